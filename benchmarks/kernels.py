"""Points per second of every emitted kernel, and of other ways to compute the same, in one run.

Run from the repository: python -m benchmarks.kernels [--points 1000 100000 1000000] [--json FILE]
Then the kernels of AGAINST beside what wrenfold emits for them, on machines of three and five axes.
"""

import argparse
import json
import os
import platform
import subprocess
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from benchmarks.rivals import Case, Contestant, FloatArray, casadi_functions, hand_written, lambdify, loop, strided
from benchmarks.wrenfold_code import cpp_of, numpy_of, unfolded
from trueaxis.codegen.c_source import c_header, c_source
from trueaxis.codegen.meta import ABI
from trueaxis.codegen.numpy_source import numpy_source
from trueaxis.derivation.library import derive_routines
from trueaxis.derivation.routine import Argument, Routine
from trueaxis.machine import Machine, read_machine
from trueaxis.model.c_kernels import CRoutine, load_c_kernels
from trueaxis.model.compiler import find_compiler

ROOT = Path(__file__).resolve().parent.parent
MODEL = "tool_in_workpiece_deviation_first_order_curves"
AGAINST = (
    "tool_in_workpiece_deviation",
    "tool_in_workpiece_deviation_first_order",
    "tool_in_workpiece_deviation_curves",
    MODEL,
    "tool_in_workpiece_sensitivity",
)
AGREEMENT = 1e-12  # relative to the largest value of a row
SECONDS = 0.03  # that one measurement takes at least, so that the clock is fine enough
CORES = os.cpu_count() or 1


@dataclass(frozen=True)
class Timed:
    """One row: points per second, and the median over the rounds of its speed relative to the first row's."""

    kernel: str
    points: int
    per_second: float
    ratio: float


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, nargs="+", default=[1_000, 100_000, 1_000_000])
    parser.add_argument("--rounds", type=int, default=9, help="interleaved measurements of every row (default 9)")
    parser.add_argument("--json", type=Path, help="write the figures to this file")
    options = parser.parse_args()
    machines = [read_machine(ROOT / "machines" / f"{name}.toml") for name in ("dmu60p", "dmu60p_5axis")]
    with tempfile.TemporaryDirectory() as name:
        contests = [Contest(machine, Path(name)) for machine in machines]
        timed = [row for n in options.points for row in contests[0].run(n, options.rounds)]
        beside = [
            row
            for contest in contests
            for kernel in AGAINST
            for n in options.points
            for row in contest.against(kernel, n, options.rounds)
        ]
    about = {"processor": _processor(), "compiler": _compiler(), "numpy": np.__version__}
    print("\n".join(f"{key}: {value}" for key, value in about.items()))
    print_table(timed, options.points)
    print("\nratio: to wrenfold's C++")
    print_table(beside, options.points)
    if options.json:
        options.json.write_text(json.dumps(about | {"rows": [asdict(row) for row in timed + beside]}, indent=1) + "\n")


class Contest:
    """The contestants of one machine: `run` measures all of them, by turns."""

    def __init__(self, machine: Machine, folder: Path) -> None:
        self.machine, self.routines, self.folder = machine, derive_routines(machine), folder / machine.name
        self.folder.mkdir()
        self.module = ModuleType("kernels")
        exec(numpy_source(machine, self.routines), self.module.__dict__)
        code = {
            "kernels.c": c_source(machine, self.routines).encode(),
            "kernels.h": c_header(machine, self.routines).encode(),
        }
        records = self.module.META["routines"]
        self.compiled, reason = load_c_kernels(code, machine.name, machine.digest, ABI, records)
        if reason:
            raise SystemExit(reason)

    def rivals(self) -> list[Contestant]:
        """Of the model that all compute: the machine of three axes that is written by hand."""
        return [
            hand_written(self.folder),
            strided("emitted C", self.compiled[MODEL].function),
            _called("emitted C, called from Python", self.compiled[MODEL]),
            _called(f"emitted C, called from Python, {CORES} threads", self.compiled[MODEL], threads=CORES),
            _called("emitted NumPy", getattr(self.module, MODEL)),
            *lambdify(self.machine),
            *casadi_functions(self.folder),
        ]

    def run(self, n: int, rounds: int) -> list[Timed]:
        """All rows at `n` points. The rivals take turns, round by round: noise of the machine meets all alike."""
        case = model_case(self.machine, n)
        ready = [(contestant.name, *contestant.prepare(case)) for contestant in self.rivals()]
        for _, call, _ in ready:
            call()
        expected = ready[0][2]()
        for name, _, result in ready[1:]:
            check_agreement(name, result(), expected)
        rows = measure([(name, call) for name, call, _ in ready], n, rounds)
        yardstick = rows[0].per_second
        for routine in self.routines:
            rows += self._routine(routine, n, rounds, yardstick)
        return rows

    def against(self, kernel: str, n: int, rounds: int) -> list[Timed]:
        """What is emitted for a kernel, and what wrenfold emits: loops called with addresses made ready, from Python,
        and NumPy.
        """
        routine = next(one for one in self.routines if one.name == kernel)
        arrays = [values_of(argument, self.machine, n) for argument in routine.inputs]
        theirs = unfolded(self.machine, routine) if kernel == MODEL else routine
        ours, plain, numpy_call = self.compiled[kernel], getattr(self.module, kernel), numpy_of(theirs)
        expected = np.asarray(ours(*arrays))
        outs = [np.zeros_like(expected), np.zeros_like(expected)]
        loops = []
        for out, function in zip(outs, (cpp_of(theirs, self.folder), ours.function), strict=True):
            loops.append(loop(function, (*arrays, out)))
            loops[-1]()
            check_agreement(kernel, out, expected)
        check_agreement(kernel, numpy_call(*arrays), expected)
        name = f"{self.machine.name} {kernel.removeprefix('tool_in_workpiece_')}"
        calls: list[tuple[str, Callable[[], Any]]] = [
            (f"{name}: wrenfold C++", loops[0]),
            (f"{name}: C", loops[1]),
            (f"{name}: C, called from Python", lambda: ours(*arrays)),
            (f"{name}: wrenfold NumPy", lambda: numpy_call(*arrays)),
            (f"{name}: NumPy", lambda: plain(*arrays)),
        ]
        return measure(calls, n, rounds)

    def _routine(self, routine: Routine, n: int, rounds: int, yardstick: float) -> list[Timed]:
        arrays = [values_of(argument, self.machine, n) for argument in routine.inputs]
        fast, plain = self.compiled[routine.name], getattr(self.module, routine.name)
        check_agreement(routine.name, np.asarray(fast(*arrays)), plain(*arrays))
        calls: list[tuple[str, Callable[[], Any]]] = [
            (f"C      {routine.name}", lambda: fast(*arrays)),
            (f"NumPy  {routine.name}", lambda: plain(*arrays)),
        ]
        rows = measure(calls, n, max(3, rounds // 3))
        return [Timed(row.kernel, n, row.per_second, row.per_second / yardstick) for row in rows]


def model_case(machine: Machine, n: int) -> Case:
    """Seeded inputs of the model that all rivals compute."""
    routine = next(r for r in derive_routines(machine) if r.name == MODEL)
    return Case(*(values_of(argument, machine, n) for argument in routine.inputs))


def values_of(argument: Argument, machine: Machine, n: int) -> FloatArray:
    """Seeded values of a machine's size: positions within the travel, errors of micrometres and microradians."""
    rng = np.random.default_rng(list(argument.name.encode()))
    shape = (*argument.shape, n) if argument.per_point else argument.shape
    values: FloatArray = rng.uniform(-1, 1, shape)
    match argument.name:
        case "positions":
            lowest, highest = np.array([machine.travel[axis] for axis in machine.axes]).T[..., np.newaxis]
            values = lowest + (highest - lowest) * (values + 1) / 2
        case "errors":
            values *= 1e-4
        case "curves":
            values *= 1e-2 / 700.0 ** np.arange(1, machine.curve_degree + 1)
        case "parameters":
            small = np.isin(machine.parameters, machine.location_errors)
            values *= np.where(small, 1e-4, 300.0)
        case _:
            values *= 100.0
    return values


def _called(name: str, kernel: Callable[..., Any] | CRoutine, **options: int) -> Contestant:
    def prepare(case: Case) -> tuple[Callable[[], Any], Callable[[], FloatArray]]:
        return lambda: kernel(*case.arrays, **options), lambda: np.asarray(kernel(*case.arrays, **options))

    return Contestant(name, prepare)


def check_agreement(name: str, found: FloatArray, expected: FloatArray) -> None:
    """Every row agrees to 1e-12 of its largest value, or there is nothing to be timed."""
    size = np.abs(expected).max(axis=-1, keepdims=True)
    if not np.all(np.abs(found - expected) <= AGREEMENT * size):
        raise SystemExit(f"{name} does not agree with the others: nothing is timed")


def measure(calls: Sequence[tuple[str, Callable[[], Any]]], n: int, rounds: int) -> list[Timed]:
    """Median seconds per call of each; ratios are medians of the rounds' own ratios."""
    repeats = [max(1, round(SECONDS / max(seconds(call, 1), 1e-7))) for _, call in calls]
    took = np.array([[seconds(call, k) for (_, call), k in zip(calls, repeats, strict=True)] for _ in range(rounds)])
    ratios = np.median(took[:, :1] / took, axis=0)
    typical = np.median(took, axis=0)
    return [Timed(name, n, n / typical[k], float(ratios[k])) for k, (name, _) in enumerate(calls)]


def seconds(call: Callable[[], Any], repeats: int) -> float:
    start = time.perf_counter()
    for _ in range(repeats):
        call()
    return (time.perf_counter() - start) / repeats


def print_table(rows: Sequence[Timed], sizes: Sequence[int]) -> None:
    """Millions of points per second and the ratio to the first row, a pair of columns for each number of points."""
    names = list(dict.fromkeys(row.kernel for row in rows))
    found = {(row.kernel, row.points): row for row in rows}
    width = max(map(len, names))
    print(f"\n{'Mpoints/s, ratio':{width}}" + "".join(f"{size:>12,} points " for size in sizes))
    for name in names:
        cells = "".join(f"{found[name, size].per_second / 1e6:12.2f} {found[name, size].ratio:6.3f} " for size in sizes)
        print(f"{name:{width}}{cells}")


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:  # not Linux
        return platform.processor()
    return next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), platform.machine())


def _compiler() -> str:
    words = find_compiler() or ()
    return subprocess.run([*words, "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]


if __name__ == "__main__":
    main()
