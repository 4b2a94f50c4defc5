"""What the rows of a fleet come to: which machines have changed, which share a cause, which failed."""

from collections.abc import Sequence
from dataclasses import dataclass

from scipy.special import ndtri  # scipy.stats has it, too, and takes a second to import

from trueaxis.fleets.row import CauseFound, Row, ValueFound

CHANGED = 3.0  # standard uncertainties: at least, as in the document of one machine
# A curve that stays as it is passes 3 u somewhere on its travel in one case of 60, six times as often as one number
# does: it counts as so many numbers. Of a whole fleet less than one change is to be called that is none.
NUMBERS_OF_A_CURVE = 6.2


@dataclass(frozen=True, slots=True)
class Changed:
    """The newest row of a machine in which an error has changed, and the one that has by the most u."""

    row: Row
    error: ValueFound


@dataclass(frozen=True, slots=True)
class Shared:
    """A cause that the newest rows of several machines name; causes: of each of them, in their order."""

    label: str
    rows: tuple[Row, ...]
    causes: tuple[CauseFound, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Summary:
    """newest: the last row of each machine; changed: the largest change first; limit: from how many u on it is one;
    shared: the cause of the most machines first; failed: every row with a fault; misfits: newest rows whose values do
    not fit their readings.
    """

    newest: tuple[Row, ...]
    changed: tuple[Changed, ...]
    limit: float
    shared: tuple[Shared, ...]
    failed: tuple[Row, ...]
    misfits: tuple[Row, ...]


def summary_of(rows: Sequence[Row]) -> Summary:
    """rows: machine by machine, of each in the order of its dates."""
    newest = tuple({row.machine: row for row in rows}.values())
    limit = changed_from(sum(one.change_in_u is not None for row in newest for one in row.values))
    pairs = [Changed(row, row.most_changed) for row in newest if row.most_changed is not None]
    changed = [one for one in pairs if (one.error.change_in_u or 0.0) >= limit]
    return Summary(
        newest=newest,
        changed=tuple(sorted(changed, key=lambda one: -(one.error.change_in_u or 0.0))),
        limit=limit,
        shared=_shared(newest),
        failed=tuple(row for row in rows if row.faults),
        misfits=tuple(row for row in newest if row.fit == "misfit"),
    )


def changed_from(count: int) -> float:
    """From how many standard uncertainties on a change is called one, where so many errors are compared."""
    return max(CHANGED, -float(ndtri(0.5 / (NUMBERS_OF_A_CURVE * max(count, 1)))))


def _shared(newest: Sequence[Row]) -> tuple[Shared, ...]:
    by_label: dict[str, list[tuple[Row, CauseFound]]] = {}
    for row in newest:
        for cause in {_label(one): one for one in reversed(row.causes)}.values():
            by_label.setdefault(_label(cause), []).append((row, cause))
    found = [
        Shared(label, tuple(row for row, _ in pairs), tuple(cause for _, cause in pairs))
        for label, pairs in by_label.items()
        if len(pairs) > 1
    ]
    return tuple(sorted(found, key=lambda one: (-len(one.rows), one.label)))


def _label(cause: CauseFound) -> str:
    """Runs have names of their own in each set of data: an instrument's cause goes by its kind."""
    return cause.label if cause.component else cause.kind
