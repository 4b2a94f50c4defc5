"""What a call of a compiled kernel from Python costs, at few points: python -m benchmarks.calls [--rounds 1500]

Microseconds, the best of many short rounds in turns, so that what else the machine does matters little. The loops, the
rival's and ours, get addresses made ready; from Python all is paid for: checks of shapes, addresses, the result's
memory, and, where one point of the tool serves for all, its copies.
"""

import argparse
import tempfile
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.kernels import AGAINST, MODEL, ROOT, Contest, seconds, values_of
from benchmarks.rivals import Case, FloatArray, hand_written, loop
from benchmarks.wrenfold_code import cpp_of, unfolded
from trueaxis.derivation.routine import Routine
from trueaxis.machine import read_machine

POINTS = (10, 100, 1000)
CALLS = 10  # a round: the clock is fine enough, and few are interrupted


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=1500)
    rounds = parser.parse_args().rounds
    print(f"{'kernel, rival':44}{'points':>8}{'rival':>8}{'C':>8}{'Python':>8}{'one point':>11}{'rival/Python':>14}")
    with tempfile.TemporaryDirectory() as name:
        contest = Contest(read_machine(ROOT / "machines" / "dmu60p.toml"), Path(name))
        for label, routine, rival in _contests(contest):
            ours, points = contest.compiled[routine.name], [one.name for one in routine.inputs].index("point")
            for n in POINTS:
                arrays = [values_of(argument, contest.machine, n) for argument in routine.inputs]
                out = np.zeros((*routine.outputs[0].shape, n))
                single = list(arrays)
                if routine.inputs[points].per_point:
                    single[points] = arrays[points][:, :1].copy()
                calls = [
                    rival(arrays, out),
                    loop(ours.function, (*arrays, out)),
                    lambda ours=ours, arrays=arrays: ours(*arrays),
                    lambda ours=ours, single=single: ours(*single),
                ]
                took = 1e6 * best(calls, rounds)
                cells = "".join(f"{one:{width}.2f}" for one, width in zip(took, (8, 8, 8, 11), strict=True))
                print(f"{label:44}{n:8}{cells}{took[0] / took[2]:14.2f}", flush=True)


def _contests(contest: Contest) -> Iterator[tuple[str, Routine, Callable[[Sequence[FloatArray], FloatArray], Any]]]:
    """Label, routine, and what makes the rival's call from inputs and result."""
    routines = {one.name: one for one in contest.routines}
    hand = hand_written(contest.folder)
    yield "first order, polynomial curves, by hand", routines[MODEL], lambda arrays, _: hand.prepare(Case(*arrays))[0]
    for kernel in AGAINST:
        theirs = unfolded(contest.machine, routines[kernel]) if kernel == MODEL else routines[kernel]
        label = f"{kernel.removeprefix('tool_in_workpiece_')}, wrenfold"
        yield label, routines[kernel], partial(_loop, cpp_of(theirs, contest.folder))


def _loop(function: Any, arrays: Sequence[FloatArray], out: FloatArray) -> Callable[[], Any]:
    return loop(function, (*arrays, out))


def best(calls: Sequence[Callable[[], Any]], rounds: int) -> FloatArray:
    """Seconds of each call, the least of all rounds."""
    took: FloatArray = np.array([[seconds(call, CALLS) for call in calls] for _ in range(rounds)]).min(axis=0)
    return took


if __name__ == "__main__":
    main()
