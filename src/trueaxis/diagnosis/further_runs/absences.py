"""What the data lack: columns, instruments, directions, feeds; of repeats the origin of the noise tells."""

from collections.abc import Iterator, Sequence

import numpy as np

from trueaxis.diagnosis.causes.signature import Readings
from trueaxis.diagnosis.further_runs.at_hand import both_ways, rounds_at_hand
from trueaxis.diagnosis.further_runs.audit import Audit
from trueaxis.diagnosis.further_runs.of_plan import Absence
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.effects.expression import names, parse
from trueaxis.effects.kind import Kind

_COLUMNS = (("time_s", ("t",)), ("temperature_c", ("T",)), ("feed", ("v", "v_b")))
_TELLING = ("ballbar", "laser")


def absences(readings: Readings, audit: Audit) -> tuple[Absence, ...]:
    """Empty where nothing is lacking."""
    rows = readings.rows
    return (
        *_columns(readings, audit),
        *_assumed(rows),
        *_instruments(rows, audit),
        *_directions(readings),
        *_feeds(readings),
    )


def _columns(readings: Readings, audit: Audit) -> Iterator[Absence]:
    """Columns without which candidates have no signature."""
    lacking = {one.effect.kind for one in audit.limits if one.reason.startswith("no ")}
    context = readings.context
    values = {"time_s": context.time, "temperature_c": context.temperature, "feed": context.velocity.sum(axis=0)}
    kinds = readings.model.machine.kinds
    for column, variables in _COLUMNS:
        unknown = ~np.isfinite(values[column])
        hit = [name for name in kinds if name in lacking and _uses(kinds[name], variables)]
        if unknown.any() and hit:
            yield Absence(lack="column", place=column, kinds=tuple(hit), empty=(int(unknown.sum()), unknown.size))


def _assumed(rows: Rows) -> Iterator[Absence]:
    runs = np.unique(rows.run[rows.assumed])
    if runs.size:
        yield Absence(lack="temperature", runs=tuple(rows.runs[index].id for index in runs))


def _uses(kind: Kind, variables: Sequence[str]) -> bool:
    return bool(kind.expression) and any(one.name in variables for one in names(parse(kind.expression)))


def _instruments(rows: Rows, audit: Audit) -> Iterator[Absence]:
    """Kinds of which not one candidate leaves a trace that recalibration could not take away."""
    seen = {one.effect.kind for one in audit.limits if one.state != "unobservable"}
    lost = {one.effect.kind for one in audit.limits if not one.reason.startswith("no ")} - seen
    unseen = [name for name in dict.fromkeys(one.effect.kind for one in audit.limits) if name in lost]
    if unseen:
        used = {rows.runs[index].instrument for index in rows.present}
        lacking = tuple(instrument for instrument in _TELLING if instrument not in used)
        yield Absence(lack="instrument", kinds=tuple(unseen), lacking=lacking)


def _directions(readings: Readings) -> Iterator[Absence]:
    rows = readings.rows
    for row, axis in enumerate(rows.axes):
        ways = set()
        for index in rows.present:
            mine = rows.of_run(index)
            if rows.runs[index].instrument != "ballbar" and np.ptp(rows.positions[row, mine]) > 0.0:
                ways |= set(np.unique(rows.directions[row, mine]).tolist())
        if ways and len(ways - {0.0}) < 2:
            yield Absence(lack="one_side", place=axis)
    rounds = rounds_at_hand(readings.model, rows)
    for plane in dict.fromkeys(one.plane for one in rounds):
        if not both_ways([one for one in rounds if one.plane == plane]):
            yield Absence(lack="one_direction", place=plane)


def _feeds(readings: Readings) -> Iterator[Absence]:
    rounds = rounds_at_hand(readings.model, readings.rows)
    for plane in dict.fromkeys(one.plane for one in rounds):
        feeds = {round(one.feed) for one in rounds if one.plane == plane and np.isfinite(one.feed)}
        if len(feeds) == 1:
            yield Absence(lack="one_feed", place=plane)
