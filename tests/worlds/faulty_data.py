"""What `identify` says of faulty data on random designs: python -m tests.worlds.faulty_data 60 9601 --faults 20

Every design is measured as it should be; the first --faults of them also with each fault: of readings, in one run of
each kind that is drawn at random, in all runs of an instrument, and in all readings; of the set-up as setup.toml has
it, in a run drawn at random. Noise is neither stated nor repeated on purpose. One line per data set, then the table.
"""

import argparse
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from pathlib import Path

import numpy as np

from tests.worlds.estimates import World, world
from tests.worlds.machine import Array
from tests.worlds.readings import measure
from tests.worlds.truth import draw_machine
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.set_up import is_straightness
from trueaxis.estimation.undone import How, undone_reading
from trueaxis.identification.believable_setup import setup_faults
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.fit_quality import NotConvergedError
from trueaxis.measurement.data import MeasuredData, read_data
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.errors import ErrorValues
from trueaxis.view import Frame

FACTORS = {"sign reversed": -1.0, "1000 times too small": 1e-3, "1000 times too large": 1e3}
MIRRORED = "targets from the other end"
ALL = "all readings"
EVERY = "all runs of"
FRAMES: dict[Frame, Frame] = {"bed": "workpiece", "workpiece": "bed"}
KINDS = ("laser", "straightness", "ballbar", "probe")
ELSEWHERE, BALL, LENGTH = 200.0, 3.0, 0.05  # mm: a home or target point, a ball, the length of a bar


@dataclass(frozen=True)
class Faulty:
    """A data set: its fault, the kind of run and the run or runs that have it, or `ALL`."""

    fault: str
    kind: str
    of: tuple[str, ...]
    plan: Observations


@dataclass(frozen=True)
class Said:
    """Of a data set: fault and runs or `ALL`, none where there is none; end: refused, misfit, note or nothing; named:
    whether a faulty run is among those that are named, or the fault is of all.
    """

    fault: str
    of: tuple[str, ...]
    end: str
    named: bool
    words: str


def faulty(one: World, reading: Array, seed: int) -> Iterator[Faulty]:
    source = np.random.default_rng([seed, 31])
    plan = replace(one.plan, reading=reading)
    yield Faulty("1000 times too small", ALL, (ALL,), replace(plan, reading=1e-3 * reading))
    runs = measured_runs(plan)
    kinds = {run.rows.index: _kind(one, run.rows.index) for run in runs}
    for kind in KINDS:
        of_kind = [run for run in runs if kinds[run.rows.index] == kind]
        for fault, factor in FACTORS.items():
            if of_kind:
                run = of_kind[int(source.integers(len(of_kind)))].rows
                changed = np.where(one.plan.run == run.index, factor, 1.0) * reading
                yield Faulty(fault, kind, (run.run.id,), replace(plan, reading=changed))
        how: How = "mirrored"
        of_kind = [run for run in of_kind if undone_reading(run, how) is not None]
        if of_kind:
            chosen = of_kind[int(source.integers(len(of_kind)))]
            turned = reading.copy()
            turned[chosen.rows.at] = undone_reading(chosen, how)
            yield Faulty(MIRRORED, kind, (chosen.rows.run.id,), replace(plan, reading=turned))
    yield from _of_instruments(plan, kinds)
    yield from _of_set_ups(plan, kinds, np.random.default_rng([seed, 37]))


def _of_instruments(plan: Observations, kinds: Mapping[int, str]) -> Iterator[Faulty]:
    """All runs of one have the wrong sign or unit, where there is another."""
    each = sorted({plan.runs[index].instrument for index in kinds})
    for instrument in each if len(each) > 1 else ():
        wrong = [index for index in kinds if plan.runs[index].instrument == instrument]
        named = tuple(plan.runs[index].id for index in wrong)
        for fault in ("sign reversed", "1000 times too small"):
            reading = np.where(np.isin(plan.run, wrong), FACTORS[fault], 1.0) * plan.reading
            yield Faulty(fault, f"{EVERY} {instrument}", named, replace(plan, reading=reading))
        if instrument != "ballbar":  # a distance has no frame
            other = [replace(run, frame=FRAMES[run.frame]) if k in wrong else run for k, run in enumerate(plan.runs)]
            yield Faulty("in the other frame", f"{EVERY} {instrument}", named, replace(plan, runs=tuple(other)))


def _of_set_ups(plan: Observations, kinds: Mapping[int, str], source: np.random.Generator) -> Iterator[Faulty]:
    """What setup.toml says of one run is wrong, or the readings of two are in each other's place."""
    bars = [index for index, kind in kinds.items() if kind == "ballbar"]
    lines = [index for index, kind in kinds.items() if kind != "ballbar"]

    def changed(fault: str, among: Sequence[int], change: Callable[[Run], Run]) -> Iterator[Faulty]:
        if among:
            index = among[int(source.integers(len(among)))]
            runs = list(plan.runs)
            runs[index] = change(runs[index])
            yield Faulty(fault, kinds[index], (runs[index].id,), replace(plan, runs=tuple(runs)))

    def moved(point: PointOn, by: Array) -> PointOn:
        return PointOn(point.on, tuple((np.array(point.point) + by).tolist()))

    def elsewhere(run: Run) -> Run:
        by = source.uniform(-ELSEWHERE, ELSEWHERE, len(run.home))
        return replace(run, home={axis: value + far for (axis, value), far in zip(run.home.items(), by, strict=True)})

    ball = BALL * np.eye(3)[source.integers(3)]
    yield from changed("home elsewhere", lines, elsewhere)
    by = source.uniform(-ELSEWHERE, ELSEWHERE, 3)
    yield from changed("target elsewhere", lines, lambda run: replace(run, target=moved(run.target, by)))
    yield from changed("ball 3 mm off", bars, lambda run: replace(run, reference=moved(run.reference, ball)))
    yield from changed("bar 0.05 mm longer", bars, lambda run: replace(run, length=(run.length or 0.0) + LENGTH))
    counts = np.bincount(plan.run, minlength=len(plan.runs))
    for kind in KINDS:
        pairs = [
            (a, b)
            for a, b in combinations([index for index in kinds if kinds[index] == kind], 2)
            if counts[a] == counts[b]
            and (plan.runs[a].direction, plan.runs[a].reference) != (plan.runs[b].direction, plan.runs[b].reference)
        ]
        if pairs:
            pair = pairs[int(source.integers(len(pairs)))]
            first, second = (np.flatnonzero(plan.run == index) for index in pair)
            reading = plan.reading.copy()
            reading[first], reading[second] = plan.reading[second], plan.reading[first]
            named = tuple(plan.runs[index].id for index in pair)
            yield Faulty("two runs swapped", kind, named, replace(plan, reading=reading))


def _kind(one: World, index: int) -> str:
    run = one.plan.runs[index]
    across = is_straightness(one.model, run, one.plan.positions[:, one.plan.run == index])
    return "straightness" if across and run.instrument == "laser" else run.instrument


def said(one: World, data: MeasuredData, plan: Observations, folder: Path) -> tuple[str, tuple[str, ...], str]:
    """End, runs that are named, words."""
    measured = MeasuredData(replace(data.setup, runs=plan.runs), replace(data.readings, reading=plan.reading))
    refused = setup_faults(one.model, measured, folder)
    if refused:
        return "refused", tuple(fault.problem.split(",")[0].removeprefix("run ") for fault in refused), "readings"
    known = ErrorValues(
        machine=one.model.name, parameters={name: one.model.errors.parameters[name] for name in one.model.dimensions}
    )
    try:
        found = identify_estimated(one.model, plan, IdentifyOptions(known=known))
    except NotConvergedError as failure:
        return "refused", tuple(run.run for run in failure.runs), "not converged"
    quality = found.report.quality
    if quality.fit.state == "misfit":
        return "misfit", quality.fit.runs, quality.reason
    notes = [note for note in found.report.notes if note.startswith(("run ", "runs "))]
    words = "; ".join(notes)
    return "note" if notes else "nothing", tuple(words.replace(",", " ").split()), words


def judged(seed: int, folder: Path, with_faults: bool, of: str = "") -> Iterator[tuple[str, Said]]:
    """Kind of run, and what came of each data set of a design; of: faults of what begins so alone."""
    one = world(seed, folder)
    data = read_data(folder / "data", one.model)
    reading = measure(one.design, draw_machine(one.design.machine, seed + 7), seed + 7).reading
    sound = Faulty("", "", (), replace(one.plan, reading=reading))
    faults = [each for each in faulty(one, reading, seed) if each.kind.startswith(of)] if with_faults else []
    for each in (sound, *faults):
        end, named, words = said(one, data, each.plan, folder)
        whole = each.of == (ALL,) and end != "nothing"
        yield each.kind, Said(each.fault, each.of, end, whole or bool(set(each.of) & set(named)), words)


def main(arguments: Sequence[str] | None = None) -> None:
    """Lines, then the table in Markdown."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("designs", type=int)
    parser.add_argument("first", type=int)
    parser.add_argument("--faults", type=int, default=0)
    parser.add_argument("--of", default="", help=f"only faults of what begins so, such as '{EVERY}'")
    args = parser.parse_args(arguments)
    rows: dict[tuple[str, str], list[Said]] = {}
    for number in range(args.designs):
        with tempfile.TemporaryDirectory() as folder:
            for kind, one in judged(args.first + number, Path(folder), number < args.faults, args.of):
                rows.setdefault((one.fault, kind), []).append(one)
                print(f"{args.first + number}: {one}", flush=True)
    print("| fault | of | data sets | refused or misfit | run named | note | exit 0, no word |\n|" + "---|" * 7)
    for (fault, kind), each in rows.items():
        ends = [one.end for one in each]
        sure = sum(end in ("refused", "misfit") for end in ends)
        named = sum(one.named for one in each)
        print(
            f"| {fault or 'none'} | {kind} | {len(each)} | {sure} | {named} | {ends.count('note')} | "
            f"{ends.count('nothing')} |"
        )


if __name__ == "__main__":
    main()
