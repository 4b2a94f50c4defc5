"""The report of `trueaxis fleet` on a console."""

from trueaxis.fleets.row import Row
from trueaxis.fleets.summary import Summary
from trueaxis.reporting.diagnosis.quantity import ascii_only
from trueaxis.reporting.fleet.words import cause_title, change, counts, when

MOST_FAULTS = 3  # of a machine
MOST = 20  # lines of a kind: the page and the table have all


def fleet_text(rows: tuple[Row, ...], summary: Summary, made: int) -> str:
    """What was done, what failed, what has changed, which causes are shared. ASCII, for a console of any encoding."""
    lines = [f"{counts(rows, summary)}; {made} made now, {len(rows) - made} as before"]
    lines += _some([line for row in summary.failed for line in _faults(row)])
    lines += _some(
        [f"misfit: {row.machine} {when(row)}: the values do not fit their readings" for row in summary.misfits]
    )
    lines += _some([f"changed: {one.row.machine} {when(one.row)}: {change(one)}" for one in summary.changed])
    lines += _some(
        [f"cause: {cause_title(one.label)}: {', '.join(row.machine for row in one.rows)}" for one in summary.shared]
    )
    return ascii_only("\n".join(lines)) + "\n"


def _some(lines: list[str]) -> list[str]:
    kind = lines[0].partition(":")[0] if lines else ""
    return lines if len(lines) <= MOST else [*lines[:MOST], f"{kind}: and {len(lines) - MOST} more"]


def _faults(row: Row) -> list[str]:
    """The first ones each: which of them helps most depends on the slip."""
    lines = [f"fault: {row.machine} {when(row)}: {fault}" for fault in row.faults[:MOST_FAULTS]]
    if left := len(row.faults) - MOST_FAULTS:
        lines[-1] += f" (and {left} more)" if left > 0 else ""
    return lines
