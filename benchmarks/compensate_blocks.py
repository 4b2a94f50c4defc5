"""Blocks per second and peak memory of `compensate` at 1e4, 1e5 and 1e6 blocks, in one run.

Run from the repository: python benchmarks/compensate_blocks.py [--program half] [--words middles] [--largest 1000000]
[--linuxcnc /], which has LinuxCNC's own rs274 read each program beside it and print what it makes of it (FOLDER: where
its package is installed, or unpacked).
Each program is compensated in a process of its own, so that its peak memory is its own. Seconds are those of the
processor. A processor that other work shares is slower all the same: `loops` are the same seconds in units of a loop of
Python and NumPy that is timed before and after, by which runs at other times compare.
"""

import argparse
import json
import math
import random
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.settings import Settings
from trueaxis.model.model import load_model

ROOT = Path(__file__).parents[1]
MACHINE = ROOT / "machines" / "dmu60p.toml"
ERRORS = ROOT / "machines" / "dmu60p_errors.json"


PROGRAMS = {
    "plain": "blocks of X Y Z",
    "words": "N, G1, X Y Z and F in every block, a comment behind one in 50",
    "arcs": "X Y Z, an arc with its G1 behind it in 200 blocks, a comment in 1000",
    "half": "lines and arcs by turns, by I J and by R",
    "holes": "G81, said again for one of 200 holes, the others by X and Y alone",
    "pecks": "G83 of five pecks, said again for one of 20 holes, the others by X and Y alone",
    "cycles": "as pecks, but each G83 ends with G80 and a rapid",
    "laser": "blocks of X Y; Z never gets a position",
    "cam": "tool paths of 30 to 300 blocks as CAM systems write them: a head of S, M3, M8, G90 G17, G0 and the plunge, "
    "arcs in and out and at corners, three feeds, G0 up and M9",
}
PATHS = (30, 300)  # blocks of a tool path


def write_program(path: Path, blocks: int, program: str) -> None:
    """A program of `PROGRAMS` over a wavy surface, in rows of short chords."""
    with path.open("w", newline="\n") as file:
        height = ("", "") if program == "laser" else (" Z120.", " Z100.")
        file.write(f"%\nG21 G17 G90 G94\nG0 X100. Y100.{height[0]}\nG1{height[1]} F2000.\n")
        file.writelines(tool_paths(blocks - 5) if program == "cam" else surface(blocks - 5, program))
        file.write("M30\n")


def surface(blocks: int, program: str) -> Iterator[str]:
    """Blocks over a wavy surface."""
    before = (100.0, 100.0)
    for number in range(blocks):
        row, column = divmod(number, 800)
        place = column if row % 2 == 0 else 799 - column
        x = 100.0 + 0.4 * place
        y = 100.0 + 0.2 * (row % 1500)
        z = 100.0 + 8.0 * math.sin(0.02 * x) * math.cos(0.013 * y)
        yield block(program, number, (x, y, z), before)
        before = (x, y)


def tool_paths(blocks: int) -> Iterator[str]:
    """Blocks of tool paths: rows of chords in a pocket of 40 mm, each joined to the next by a half circle."""
    draw, left, number = random.Random(5), blocks, 0
    while left > 0:
        number += 1
        x, y, depth = draw.uniform(100, 300), draw.uniform(100, 300), 100 - 0.01 * (number % 500)
        path = [
            f"(PATH {number})", f"S{draw.randrange(4000, 12000, 100)} M3", "G90 G94 G17", "M8", f"G0 X{x:.3f} Y{y:.3f}",
            "Z120.", "Z105.", f"G1 Z{depth:.3f} F300.", f"G3 X{x + 1:.3f} Y{y + 1:.3f} I0. J1. F800.",
        ]  # fmt: skip
        x, y, ahead, row = x + 1, y + 1, 1, y + 1
        for place in range(draw.randrange(*PATHS) - len(path) - 3):
            if place % 25 == 24:  # a half circle to the row behind
                path += [f"G{3 if ahead > 0 else 2} X{x:.3f} Y{row + 1:.3f} I0. J0.5", "G1 F2000."]
                y += 1
                ahead = -ahead
                continue
            x += ahead * draw.uniform(0.5, 2.5)
            row = round(y + 0.05 * math.sin(x), 3)
            path.append(f"{'G1 ' * (place == 0)}X{x:.3f} Y{row:.3f}{' F2000.' * (place == 0)}")
        yield from (f"{text}\n" for text in [*path[: left - 3], "G0 Z120.", "M9", ""][:left])
        left -= len(path) + 3


def block(program: str, number: int, place: tuple[float, float, float], before: tuple[float, float]) -> str:
    """One block of a program; before: where the block before ends."""
    x, y, z = place
    line = f"X{x:.4f} Y{y:.4f}"
    text = f"{line} Z{z:.4f}\n"
    if program == "words":
        text = f"N{number + 1} G1 {line} Z{z:.4f} F{1500 + number % 7 * 50}.{' (pass)' * (number % 50 == 49)}\n"
    elif program == "arcs" and number % 1000 == 999:
        text = f"(block {number})\n"
    elif program == "arcs" and number % 200 == 199:
        text = f"N{number} G2 {line} R5. F1500\nG1 F2000\n"
    elif program == "half" and number % 4 == 1:
        text = f"G2 {line} R5.\n"
    elif program == "half" and number % 4 == 3:  # about a point that lies as far from both ends
        i, j = 0.5 * (x - before[0]) - (y - before[1]), 0.5 * (y - before[1]) + (x - before[0])
        text = f"G3 {line} I{i:.4f} J{j:.4f}\n"
    elif program == "half":
        text = f"G1 {text}"
    elif program == "laser":
        text = f"{line}\n"
    elif program == "holes":
        text = f"G81 {line} Z100. R120. F500.\n" if number % 200 == 0 else f"{line}\n"
    elif program in {"pecks", "cycles"}:
        ended = "G80\nG0 Z120.\n" if program == "cycles" else ""
        text = f"{ended}G83 {line} Z100. R120. Q4. F500.\n" if number % 20 == 0 else f"{line}\n"
    return text


def reference() -> float:
    """Seconds of a loop of Python and NumPy that has nothing to do with compensation."""
    begin = time.process_time()
    values, total = np.arange(30_000.0), 0
    for _ in range(20):
        total += int((np.sin(values) * values).sum()) + len("".join(map(str, range(15_000))))
        total += sum(number * number % 7 for number in range(30_000))
    return time.process_time() - begin


def read_by_linuxcnc(program: Path, package: Path) -> float:
    """Seconds of the processor that LinuxCNC's rs274 takes for a program, starting and printing its calls included."""
    folder = program.parent
    (folder / "tool.tbl").write_text("")
    (folder / "rs274.var").write_text("5220\t1.0\n")
    libraries = f"{package}/usr/lib:{package}/usr/lib/x86_64-linux-gnu"
    command = [f"{package}/usr/bin/rs274", "-g", "-t", "tool.tbl", "-v", "rs274.var", str(program)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(
        command, cwd=folder, env={"HOME": str(folder), "LD_LIBRARY_PATH": libraries}, check=True,
        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def one(blocks: int, words: str, name: str, package: Path | None) -> None:
    """Compensate one program in this process and print what it took as JSON."""
    ball = None if words == "nearest" else (270.0, -350.0, 0.0)
    settings = Settings(words=words, ball=ball)  # type: ignore[arg-type]
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "program.nc"
        write_program(program, blocks, name)
        model = load_model(MACHINE, ERRORS, ROOT / "generated")
        compensate_file(program, Path(folder) / "warm.nc", model, settings) if blocks <= 10_000 else None
        idle = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        before = reference()
        begin = time.process_time()
        report = compensate_file(program, Path(folder) / "out.nc", model, settings)
        seconds = time.process_time() - begin
        loops = seconds / (0.5 * (before + reference()))
        beside = 0.0 if package is None else read_by_linuxcnc(program, package)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    print(
        json.dumps(
            {"blocks": report.blocks_in, "written": report.blocks_out, "moves": report.moves,
             "points": report.points, "seconds": seconds, "loops": loops, "peak": peak / 1024, "idle": idle / 1024,
             "linuxcnc": beside}
        )
    )  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--words", choices=("nearest", "ends", "middles"), default="nearest")
    parser.add_argument("--program", choices=PROGRAMS, default="plain", help=str(PROGRAMS))
    parser.add_argument("--largest", type=int, default=1_000_000)
    parser.add_argument("--linuxcnc", type=Path, metavar="FOLDER", help="where LinuxCNC is: / or where it was unpacked")
    parser.add_argument("--one", type=int, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.one:
        one(args.one, args.words, args.program, args.linuxcnc)
        return
    print(f"{PROGRAMS[args.program]}; words {args.words}")
    names = ["blocks", "written", "moves", "points", "seconds", "loops", "blocks/s", "moves/s", "points/s", "peak MiB"]
    names += ["LinuxCNC"] * bool(args.linuxcnc)
    print(" ".join(f"{name:>9s}" for name in names))
    blocks = 10_000
    while blocks <= args.largest:
        command = [sys.executable, __file__, "--one", str(blocks), "--words", args.words, "--program", args.program]
        command += ["--linuxcnc", str(args.linuxcnc)] * bool(args.linuxcnc)
        got = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        rates = (got[name] / got["seconds"] for name in ("blocks", "moves", "points"))
        print(
            *(f"{got[name]:9d}" for name in ("blocks", "written", "moves", "points")),
            f"{got['seconds']:9.2f} {got['loops']:9.1f}",
            *(f"{rate:9.0f}" for rate in rates),
            f"{got['peak']:9.0f}",
            *([f"{got['blocks'] / got['linuxcnc']:9.0f}"] * bool(args.linuxcnc)),
        )
        blocks *= 10


if __name__ == "__main__":
    main()
