"""What the page and the text of a fleet say alike."""

from trueaxis.fleets.row import Row
from trueaxis.fleets.summary import Changed, Summary
from trueaxis.reporting.diagnosis.quantity import quantity


def cause_title(label: str) -> str:
    """`Backlash EYY` of `backlash EYY`."""
    text = label.replace("_", " ")
    return text[:1].upper() + text[1:]


def when(row: Row) -> str:
    """The date of a row, or what stands for it."""
    return row.date or row.data or "values given"


def counts(rows: tuple[Row, ...], summary: Summary) -> str:
    """`3 machines, 7 folders of data, 2 with faults`."""
    return (
        f"{_plural(len(summary.newest), 'machine')}, {_plural(len(rows), 'row')}, "
        f"{len(summary.failed) or 'none'} with faults"
    )


def change(one: Changed) -> str:
    """`EYY by 4.1 um, 12.3 u`."""
    error = one.error
    size = "" if error.change is None else f"{quantity(abs(error.change), error.unit)}, "
    return f"{error.name} by {size}{error.change_in_u or 0.0:.1f} u"


def _plural(count: int, noun: str) -> str:
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"
