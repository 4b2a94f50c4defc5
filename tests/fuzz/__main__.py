"""`python -m tests.fuzz --minutes N [--seed S] [--only READER ...] [--save DIR]`: exit code 1 for findings."""

import argparse
import itertools
import sys
from pathlib import Path

from tests.fuzz.campaign import run
from tests.fuzz.readers import READERS


def main() -> int:
    """Run a campaign and print what came of it."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description="Hostile files for every reader.")
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--seed", type=int, default=1, help="of the first input of each reader; the next is one higher")
    parser.add_argument("--only", nargs="+", choices=[reader.name for reader in READERS], metavar="READER")
    parser.add_argument("--save", type=Path, metavar="DIR", help="folder for the inputs of what is found")
    args = parser.parse_args()
    readers = [reader for reader in READERS if not args.only or reader.name in args.only]
    tally = run(readers, itertools.count(args.seed), 60 * args.minutes, args.save)
    print("\n".join(tally.lines()))
    for (name, problem), detail in tally.details.items():
        print(f"\n{name}: {problem}\n{detail}")
    return 1 if tally.findings else 0


if __name__ == "__main__":
    sys.exit(main())
