"""Instruments as they are: what each set-up of one does not know of itself, as columns beside those of the machine."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.machine import IdentifiedMachine, IntArray
from trueaxis.estimation.observations import Observations
from trueaxis.identify.global_fit.instruments import KINDS, Instruments, InstrumentUnknown, instruments
from trueaxis.identify.words import enumerated
from trueaxis.measure.machine import FloatArray
from trueaxis.plan.lines import line_kind, misplaced, path_line

TEXTS = {
    "laser": "laser across its motion: offset and slope of its line are unknown",
    "ballbar": "ball bar: its centre and its length are unknown",
    "probe": "probe: its zero is unknown, and the centre of a sphere that turns",
    "linkage": "laser on a line of two axes: where the line is and points to is unknown",
    "zero": "laser: its zero at home is unknown",
}
KNOWN = "laser: its zero at home and its line are taken as known"
IDEAL = "taken as ideal"


@dataclass(frozen=True, slots=True)
class Assumptions:
    """ideal: nothing is unknown of the instruments; linkage_lines: lines of laser runs neither along nor across their
    motion are unknown, too; zeros: lasers are not zeroed exactly at home.
    """

    ideal: bool = False
    linkage_lines: bool = False
    zeros: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Unknowns:
    """What runs that share unknowns of instruments do not know.

    runs: their indices; kind: in words; names, units: of each unknown (k,); rows: (m,), their readings; columns:
    (m, k), derivative of these readings by the unknowns.
    """

    runs: tuple[int, ...]
    kind: str
    names: tuple[str, ...]
    units: tuple[str, ...]
    rows: IntArray
    columns: FloatArray


def instrument_unknowns(
    machine: IdentifiedMachine, observed: Observations, assumed: Assumptions
) -> tuple[Unknowns, ...]:
    """The unknowns of all runs, those together that runs share, in the order of their first runs.

    Straightness lines, ball bars and probes as `identify --method global` has them.
    """
    if assumed.ideal:
        return ()
    found = [_shared(machine, observed, group) for group in _groups(instruments(machine, observed, KINDS).unknowns)]
    taken = {index for one in found for index in one.runs}
    lasers = [i for i, run in enumerate(observed.runs) if run.instrument == "laser" and i not in taken]
    if assumed.linkage_lines:
        found += _linkage(machine, observed, lasers)
        taken = {index for one in found for index in one.runs}
    if assumed.zeros:
        found += [_zero(observed, index) for index in lasers if index not in taken]
    return tuple(sorted(found, key=lambda one: one.runs))


def _groups(unknowns: Sequence[InstrumentUnknown]) -> list[list[InstrumentUnknown]]:
    """Unknowns whose runs hang together."""
    groups: list[tuple[set[int], list[InstrumentUnknown]]] = []
    for unknown in unknowns:
        runs, members, apart = set(unknown.runs), [unknown], []
        for theirs, others in groups:
            if theirs & runs:
                runs, members = runs | theirs, others + members
            else:
                apart.append((theirs, others))
        groups = [*apart, (runs, members)]
    return [members for _, members in groups]


def _shared(machine: IdentifiedMachine, observed: Observations, group: Sequence[InstrumentUnknown]) -> Unknowns:
    runs = tuple(sorted({index for unknown in group for index in unknown.runs}))
    own = Instruments(tuple(group))
    rows = [np.flatnonzero(observed.run == index) for index in runs]
    columns = [
        own.columns(machine, observed.runs, index, observed.positions[:, of_run])
        for index, of_run in zip(runs, rows, strict=True)
    ]
    size = np.array([unknown.size for unknown in group])
    return Unknowns(
        runs,
        TEXTS[observed.runs[runs[0]].instrument],
        tuple(unknown.name for unknown in group),
        tuple(unknown.unit for unknown in group),
        np.concatenate(rows),
        np.vstack(columns) / size,
    )


def _linkage(machine: IdentifiedMachine, observed: Observations, lasers: Sequence[int]) -> list[Unknowns]:
    """Runs that project the motion along one line (same points, same path) share that line."""
    lines = {
        index: path_line(machine, observed.runs[index], observed.positions[:, observed.run == index])
        for index in lasers
    }
    groups: dict[object, list[int]] = {}
    for index, line in lines.items():
        run = observed.runs[index]
        if line is not None and line_kind(run, line) == "linkage":
            key = (run.target, run.reference, run.frame, tuple(run.home.items()), tuple(np.round(line[0], 6) + 0.0))
            groups.setdefault(key, []).append(index)
    found = []
    for members in groups.values():
        label = f"the line of {enumerated([observed.runs[index].id for index in members])}"
        along = [line for index in members if (line := lines[index]) is not None]
        columns = misplaced([np.array(observed.runs[index].direction) for index in members], along)
        ends = ("",) if columns.shape[1] == 2 else (" (1st direction)", " (2nd direction)")
        names = tuple(f"{what} of {label}{end}" for what in ("offset", "slope") for end in ends)
        units = ("mm",) * len(ends) + ("rad",) * len(ends)
        rows = np.concatenate([np.flatnonzero(observed.run == index) for index in members])
        found.append(Unknowns(tuple(members), TEXTS["linkage"], names, units, rows, columns))
    return found


def _zero(observed: Observations, index: int) -> Unknowns:
    rows = np.flatnonzero(observed.run == index)
    name = f"zero of run {observed.runs[index].id}"
    return Unknowns((index,), TEXTS["zero"], (name,), ("mm",), rows, np.ones((rows.size, 1)))
