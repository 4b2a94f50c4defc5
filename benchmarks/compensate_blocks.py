"""Blocks per second and peak memory of `compensate` at 1e4, 1e5 and 1e6 blocks, in one run.

Run from the repository: python benchmarks/compensate_blocks.py [--plain] [--words middles] [--largest 1000000]
Each program is compensated in a process of its own, so that its peak memory is its own. Seconds are those of the
processor: other work on the machine counts for less.
"""

import argparse
import json
import math
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.settings import Settings
from trueaxis.model.model import load_model

ROOT = Path(__file__).parents[1]
MACHINE = ROOT / "machines" / "dmu60p.toml"
ERRORS = ROOT / "machines" / "dmu60p_errors.json"


def write_program(path: Path, blocks: int, plain: bool = False) -> None:
    """A finishing program: rows of short chords over a wavy surface, now and then an arc or a comment unless plain."""
    with path.open("w", newline="\n") as file:
        file.write("%\nG21 G17 G90 G94\nG0 X100. Y100. Z120.\nG1 Z100. F2000.\n")
        for number in range(blocks - 5):
            row, column = divmod(number, 800)
            place = column if row % 2 == 0 else 799 - column
            x = 100.0 + 0.4 * place
            y = 100.0 + 0.2 * (row % 1500)
            z = 100.0 + 8.0 * math.sin(0.02 * x) * math.cos(0.013 * y)
            if plain:
                file.write(f"X{x:.4f} Y{y:.4f} Z{z:.4f}\n")
            elif number % 1000 == 999:
                file.write(f"(row {row})\n")
            elif number % 200 == 199:
                file.write(f"N{number} G2 X{x:.4f} Y{y:.4f} R5. F1500\nG1 F2000\n")
            else:
                file.write(f"X{x:.4f} Y{y:.4f} Z{z:.4f}\n")
        file.write("M30\n")


def one(blocks: int, words: str, plain: bool) -> None:
    """Compensate one program in this process and print what it took as JSON."""
    ball = None if words == "nearest" else (270.0, -350.0, 0.0)
    settings = Settings(words=words, ball=ball)  # type: ignore[arg-type]
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "program.nc"
        write_program(program, blocks, plain)
        model = load_model(MACHINE, ERRORS, ROOT / "generated")
        compensate_file(program, Path(folder) / "warm.nc", model, settings) if blocks <= 10_000 else None
        idle = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        begin = time.process_time()
        report = compensate_file(program, Path(folder) / "out.nc", model, settings)
        seconds = time.process_time() - begin
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    print(
        json.dumps(
            {"blocks": report.blocks_in, "written": report.blocks_out, "points": report.points,
             "seconds": seconds, "peak": peak / 1024, "idle": idle / 1024}
        )
    )  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--words", choices=("nearest", "ends", "middles"), default="nearest")
    parser.add_argument("--plain", action="store_true", help="blocks of X Y Z alone")
    parser.add_argument("--largest", type=int, default=1_000_000)
    parser.add_argument("--one", type=int, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.one:
        one(args.one, args.words, args.plain)
        return
    print(f"words {args.words}")
    print(f"{'blocks':>9s} {'written':>9s} {'points':>9s} {'seconds':>8s} {'blocks/s':>9s} {'peak MiB':>9s}")
    blocks = 10_000
    while blocks <= args.largest:
        command = [sys.executable, __file__, "--one", str(blocks), "--words", args.words, *["--plain"] * args.plain]
        got = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        print(
            f"{got['blocks']:9d} {got['written']:9d} {got['points']:9d} {got['seconds']:8.2f} "
            f"{got['blocks'] / got['seconds']:9.0f} {got['peak']:9.0f}"
        )
        blocks *= 10


if __name__ == "__main__":
    main()
