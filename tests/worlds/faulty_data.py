"""What `identify` says of faulty data on random designs: python -m tests.worlds.faulty_data 60 9601 --faults 20

Every design is measured as it should be; the first --faults of them also with each fault, in one run of each kind that
is drawn at random, and in all readings. Noise is neither stated nor repeated on purpose. One line per data set, then
the table.
"""

import argparse
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tests.worlds.estimates import World, world
from tests.worlds.machine import Array
from tests.worlds.readings import measure
from tests.worlds.truth import draw_machine
from trueaxis.estimation.misread import How, undone_reading
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.set_up import is_straightness
from trueaxis.identification.believable_setup import setup_faults
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.fit_quality import NotConvergedError
from trueaxis.measurement.data import MeasuredData, read_data
from trueaxis.model.errors import ErrorValues

FACTORS = {"sign reversed": -1.0, "1000 times too small": 1e-3, "1000 times too large": 1e3}
MIRRORED = "targets from the other end"
ALL = "all readings"
KINDS = ("laser", "straightness", "ballbar", "probe")


@dataclass(frozen=True)
class Said:
    """Of a data set: fault and run or `ALL`, "" where there is none; end: refused, misfit, note or nothing; named:
    whether the faulty run is among those that are named, or the fault is of all.
    """

    fault: str
    of: str
    end: str
    named: bool
    words: str


def faulty(one: World, reading: Array, seed: int) -> Iterator[tuple[str, str, str, Array]]:
    """Fault, kind of run, run or `ALL`, readings."""
    source = np.random.default_rng([seed, 31])
    yield "1000 times too small", ALL, ALL, 1e-3 * reading
    runs = measured_runs(replace(one.plan, reading=reading))
    kinds = {run.rows.index: _kind(one, run.rows.index) for run in runs}
    for kind in KINDS:
        of_kind = [run for run in runs if kinds[run.rows.index] == kind]
        for fault, factor in FACTORS.items():
            if of_kind:
                run = of_kind[int(source.integers(len(of_kind)))].rows
                yield fault, kind, run.run.id, np.where(one.plan.run == run.index, factor, 1.0) * reading
        how: How = "mirrored"
        of_kind = [run for run in of_kind if undone_reading(run, how) is not None]
        if of_kind:
            chosen = of_kind[int(source.integers(len(of_kind)))]
            turned = reading.copy()
            turned[chosen.rows.at] = undone_reading(chosen, how)
            yield MIRRORED, kind, chosen.rows.run.id, turned


def _kind(one: World, index: int) -> str:
    run = one.plan.runs[index]
    across = is_straightness(one.model, run, one.plan.positions[:, one.plan.run == index])
    return "straightness" if across and run.instrument == "laser" else run.instrument


def said(one: World, data: MeasuredData, reading: Array, folder: Path) -> tuple[str, tuple[str, ...], str]:
    """End, runs that are named, words."""
    refused = setup_faults(one.model, replace(data, readings=replace(data.readings, reading=reading)), folder)
    if refused:
        return "refused", tuple(fault.problem.split(",")[0].removeprefix("run ") for fault in refused), "readings"
    known = ErrorValues(one.model.name, {name: one.model.errors.parameters[name] for name in one.model.dimensions})
    try:
        found = identify_estimated(one.model, replace(one.plan, reading=reading), IdentifyOptions(known=known))
    except NotConvergedError as failure:
        return "refused", tuple(run.run for run in failure.runs), "not converged"
    quality = found.report.quality
    if quality.fit.state == "misfit":
        return "misfit", quality.fit.runs, quality.reason
    notes = [note for note in found.report.notes if note.startswith("run ")]
    return "note" if notes else "nothing", tuple(note.split()[1] for note in notes), "; ".join(notes)


def judged(seed: int, folder: Path, with_faults: bool) -> Iterator[tuple[str, Said]]:
    """Kind of run, and what came of each data set of a design."""
    one = world(seed, folder)
    data = read_data(folder / "data", one.model)
    reading = measure(one.design, draw_machine(one.design.machine, seed + 7), seed + 7).reading
    sets = [("", "", "", reading), *(faulty(one, reading, seed) if with_faults else ())]
    for fault, kind, run, values in sets:
        end, named, words = said(one, data, values, folder)
        yield kind, Said(fault, run, end, run in named or (run == ALL and end != "nothing"), words)


def main(arguments: Sequence[str] | None = None) -> None:
    """Lines, then the table in Markdown."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("designs", type=int)
    parser.add_argument("first", type=int)
    parser.add_argument("--faults", type=int, default=0)
    args = parser.parse_args(arguments)
    rows: dict[tuple[str, str], list[Said]] = {}
    for number in range(args.designs):
        with tempfile.TemporaryDirectory() as folder:
            for kind, one in judged(args.first + number, Path(folder), number < args.faults):
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
