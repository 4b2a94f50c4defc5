"""How each command grows: python -m benchmarks.growth [--only COMMAND ...] [--decades N]

Every command is run at sizes ten times apart, each in a process of its own: seconds of the processor, of the command
and of all that it started, and the largest memory of one process, Python and libraries included. `power` is that of the
size by which seconds and memory grow between the last two sizes, what the smallest size takes being there already.
The machine is the paper's; readings are lines of a laser, simulated with 1 um of noise, errors as the demo's.
"""

import argparse
import os
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from benchmarks.compensate_blocks import write_program
from trueaxis.cli.main import ONE_THREAD

ROOT = Path(__file__).parents[1]
MACHINE, ERRORS = ROOT / "machines" / "dmu60p.toml", ROOT / "machines" / "dmu60p_errors.json"
TRAVEL = {"X": 540.0, "Y": 540.0, "Z": 530.0}
POINTS = ((0.0, 0.0, -200.0), (100.0, 0.0, -250.0), (0.0, 120.0, -170.0), (-80.0, 60.0, -300.0))
DIRECTIONS = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
LINES = len(TRAVEL) * len(POINTS) * len(DIRECTIONS)  # runs that are alike but for where the other axes stand


class Case(NamedTuple):
    """sizes: the first of which is ten times smaller than the second, and so on; words: of the command, from a size and
    a folder for what it reads and writes, made beforehand.
    """

    command: str
    of: str
    sizes: tuple[int, ...]
    words: Callable[[int, Path], list[str | Path]]


class Cost(NamedTuple):
    """seconds: of the processor; memory: MiB."""

    seconds: float
    memory: float


def plan_of(folder: Path, runs: int, readings: int) -> Path:
    """A plan of so many lines, and so many readings on each, there and back."""
    folder.mkdir()
    draw = np.random.default_rng(1)
    setup, rows = ['schema = 1\nmachine = "dmu60p"'], ["run,seq,X,Y,Z,reading"]
    for run in range(runs):
        axis, rest = list(TRAVEL)[run % 3], run // 3
        point, direction = POINTS[rest % len(POINTS)], DIRECTIONS[rest // len(POINTS) % 3]
        still = {name: round(float(draw.uniform(0.0, travel)), 1) for name, travel in TRAVEL.items()}
        home = ", ".join(f"{name} = {0.0 if name == axis else value}" for name, value in still.items())
        setup.append(
            f'[[run]]\nid = "{run}"\ninstrument = "laser"\ndirection = {list(direction)}\nframe = "bed"\n'
            f'target = {{ on = "tool", point = {list(point)} }}\nreference = {{ on = "bed" }}\nhome = {{ {home} }}'
        )
        there = np.linspace(0.0, TRAVEL[axis], -(-readings // 2))
        for seq, at in enumerate([*there, *there[::-1]][:readings]):
            values = [f"{at:.4f}" if name == axis else str(value) for name, value in still.items()]
            rows.append(f"{run},{seq},{','.join(values)},")
    (folder / "setup.toml").write_text("\n\n".join(setup) + "\n")
    (folder / "readings.csv").write_text("\n".join(rows) + "\n")
    return folder


def read_of(folder: Path, runs: int, readings: int) -> Path:
    """The same, read."""
    plan = plan_of(folder / "plan", runs, readings)
    words: list[str | Path] = [
        "simulate",
        MACHINE,
        "--errors",
        ERRORS,
        "--data",
        plan,
        "--out",
        folder / "data",
        "--noise-um",
        "1",
    ]
    assert run(words)[1] == 0, words
    return folder / "data"


def cases() -> Iterator[Case]:
    """Every command whose input may be long."""

    def predict(size: int, folder: Path) -> list[str | Path]:
        points = np.random.default_rng(1).uniform(0.0, list(TRAVEL.values()), (size, 3))
        np.savetxt(folder / "points.csv", points, "%.4f", ",", header="X,Y,Z", comments="")
        return ["predict", MACHINE, "--errors", ERRORS, "--at", folder / "points.csv", "--out", folder / "out.csv"]

    def compensate(size: int, folder: Path) -> list[str | Path]:
        write_program(folder / "in.nc", size, "arcs")
        return ["compensate", MACHINE, "--errors", ERRORS, folder / "in.nc", "--out", folder / "out.nc"]

    def simulate(size: int, folder: Path) -> list[str | Path]:
        plan = plan_of(folder / "plan", LINES, size // LINES)
        return ["simulate", MACHINE, "--errors", ERRORS, "--data", plan, "--out", folder / "data"]

    def identify(size: int, folder: Path) -> list[str | Path]:
        return identified(read_of(folder, LINES, size // LINES))

    def identify_runs(size: int, folder: Path) -> list[str | Path]:
        return identified(read_of(folder, size, 20))

    def identified(data: Path) -> list[str | Path]:
        return ["identify", MACHINE, "--data", data, "--out", data.parent / "errors.json"]

    def diagnose(size: int, folder: Path) -> list[str | Path]:
        return diagnosed(read_of(folder, LINES, size // LINES))

    def diagnose_runs(size: int, folder: Path) -> list[str | Path]:
        return diagnosed(read_of(folder, size, 20))

    def diagnosed(data: Path) -> list[str | Path]:
        return ["diagnose", MACHINE, "--errors", ERRORS, "--data", data, "--out", data.parent / "found"]

    def plan_runs(size: int, folder: Path) -> list[str | Path]:
        return ["plan", MACHINE, "--data", plan_of(folder / "plan", size, 20), "--noise-um", "1"]

    yield Case("predict", "points", (1_000, 10_000, 100_000, 1_000_000), predict)
    yield Case("compensate", "blocks", (1_000, 10_000, 100_000, 1_000_000), compensate)
    yield Case("simulate", "readings", (1_000, 10_000, 100_000, 1_000_000), simulate)
    yield Case("identify", "readings", (360, 3_600, 36_000, 360_000), identify)
    yield Case("identify", "runs", (3, 30, 300), identify_runs)
    yield Case("diagnose", "readings", (360, 3_600, 36_000), diagnose)
    yield Case("diagnose", "runs", (3, 30, 300), diagnose_runs)
    yield Case("plan", "runs", (3, 30, 300), plan_runs)


def run(words: list[str | Path]) -> tuple[Cost, int]:
    """What a command takes, and its exit code."""
    environment = {**os.environ, **dict.fromkeys(ONE_THREAD, "1")}
    command = [sys.executable, "-m", "trueaxis", *(str(word) for word in words)]
    silent = [(os.POSIX_SPAWN_OPEN, stream, os.devnull, os.O_WRONLY, 0) for stream in (1,)]
    child = os.posix_spawn(sys.executable, command, environment, file_actions=silent)
    _, status, used = os.wait4(child, 0)
    return Cost(used.ru_utime + used.ru_stime, used.ru_maxrss / 1024), os.waitstatus_to_exitcode(status)


def measured(case: Case, size: int) -> Cost:
    """Of one size, in a folder of its own."""
    with tempfile.TemporaryDirectory() as name:
        words = case.words(size, Path(name))
        cost, code = run(words)
    if code not in (0, 1):  # 1: done, and the answer is no
        raise SystemExit(f"trueaxis {' '.join(map(str, words))} ended with {code}")
    return cost


def power(costs: list[float], sizes: tuple[int, ...]) -> str:
    """Between the last two sizes, of what is more than at the first."""
    last, before = (cost - costs[0] for cost in (costs[-1], costs[-2]))
    return f"{np.log(last / before) / np.log(sizes[-1] / sizes[-2]):5.2f}" if min(last, before) > 0.0 else "    -"


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--only", nargs="+", metavar="COMMAND", help="default: all")
    parser.add_argument("--decades", type=int, default=3, help="above the first size, at most (%(default)s)")
    options = parser.parse_args()
    print("command     of         size  seconds  power      MiB  power")
    for case in cases():
        if options.only and case.command not in options.only:
            continue
        sizes, costs = case.sizes[: options.decades + 1], list[Cost]()
        for size in sizes:
            costs.append(measured(case, size))
            seconds, memory = [cost.seconds for cost in costs], [cost.memory for cost in costs]
            powers = [power(column, sizes[: len(costs)]) if len(costs) > 2 else "    -" for column in (seconds, memory)]
            told = f"{seconds[-1]:8.2f}  {powers[0]} {memory[-1]:8.0f}  {powers[1]}"
            print(f"{case.command:11s} {case.of:8s} {size:7d} {told}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
