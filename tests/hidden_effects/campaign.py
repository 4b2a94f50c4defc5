"""Measure how often the diagnosis is right.

    python -m tests.hidden_effects.campaign [--cases N] [--clean N] [--workers W] [--only SCENARIO ...]
                                            [--write docs/diagnosis-power.md] [--log FILE.jsonl]

--cases: trials per line of the tables (20); --clean: data sets without any effect (920). Scenarios and what is hidden
in them: `power.trials`; grades: `power.grade`; how effects outside the library are sized: `power.outside_limit`.
"""

import argparse
import json
import multiprocessing
import os
import sys
import traceback
from collections.abc import Sequence
from dataclasses import asdict
from functools import cache
from pathlib import Path

THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
os.environ.update(dict.fromkeys(THREADS, "1"))  # before NumPy is imported, here and in the workers that are spawned

from tests.hidden_effects.case import Case  # noqa: E402
from tests.hidden_effects.power.bench import Bound, bounds_of, diagnosed, said_of  # noqa: E402
from tests.hidden_effects.power.grade import FAILED, Said  # noqa: E402
from tests.hidden_effects.power.tally import Result, page  # noqa: E402
from tests.hidden_effects.power.trials import SCENARIOS, Trial  # noqa: E402


@cache
def bounds(case: Case) -> tuple[Bound, ...]:
    """The audit of data of this design and noise, without effects."""
    return bounds_of(case)


def tried(trial: Trial) -> Result | None:
    """None where nobody has an effect of that size."""
    try:
        sized = trial.sized()
        return None if sized is None else Result(sized, said_of(diagnosed(sized.case)))
    except Exception as error:  # a diagnosis that breaks down is a result, and no reason to lose the others
        traceback.print_exc()
        return Result(trial, Said(f"{FAILED}: {error!r}"))


def run(trials: Sequence[Trial], workers: int, log: Path | None = None) -> list[Result]:
    """In the order of the trials, whatever the number of workers; log: gets a line of JSON per trial as it is done."""
    results = []
    with multiprocessing.get_context("spawn").Pool(workers) as pool:
        for number, result in enumerate(pool.imap(tried, trials, chunksize=1), start=1):
            if result is not None:
                results.append(result)
            if log is not None and result is not None:
                with log.open("a") as file:
                    file.write(json.dumps(asdict(result) | {"grade": result.grade}, default=str) + "\n")
            if sys.stderr.isatty() or number % 50 == 0:
                print(f"{number} of {len(trials)}", file=sys.stderr, flush=True)
    return results


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", type=int, default=20)
    parser.add_argument("--clean", type=int, default=920)
    parser.add_argument("--workers", type=int, default=max(1, (os.cpu_count() or 2) - 1))
    parser.add_argument("--only", nargs="+", choices=sorted(SCENARIOS), default=list(SCENARIOS))
    parser.add_argument("--write", type=Path)
    parser.add_argument("--log", type=Path)
    args = parser.parse_args(arguments)
    trials = [
        trial for name in args.only for trial in SCENARIOS[name](args.clean if name == "clean" else args.cases, bounds)
    ]
    if args.log is not None:
        args.log.unlink(missing_ok=True)
    results = run(trials, args.workers, args.log)
    words = [f"--cases {args.cases}", f"--clean {args.clean}"]
    words += [f"--only {' '.join(args.only)}"] if args.only != list(SCENARIOS) else []
    text = page(results, f"python -m tests.hidden_effects.campaign {' '.join(words)}")
    print(text)
    if args.write is not None:
        args.write.write_text(text)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
