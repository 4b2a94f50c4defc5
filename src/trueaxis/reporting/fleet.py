"""A fleet for people: one HTML page that needs nothing else, whose links lead to the files beside it; the console."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath
from urllib.parse import quote

from trueaxis.fleets.rows import CauseFound, Changed, Row, StaleFound, Summary
from trueaxis.fleets.unit import GIVEN, MACHINES
from trueaxis.reporting.diagnosis.html import rendered
from trueaxis.reporting.diagnosis.quantity import ascii_only, quantity
from trueaxis.reporting.diagnosis.words import TITLES

TEMPLATE = "fleet.html.j2"
TEXT_OF: dict[str, str] = dict(TITLES.items())
DASH = "\N{EN DASH}"
MOST_ROWS = 2000  # of a table: more make a page that browsers are slow with, and nobody reads; results.parquet has all
MOST_NAMED = 30  # machines in one cell
MOST_RIVALS = 2  # of a cause: the page of the diagnosis has all
MOST_FAULTS = 5  # of one row: what comes behind is seldom another mistake
DOCUMENTS = (("document", "report.html"), ("diagnosis", "diagnosis/report.html"))
MOST_TOLD = 3  # of a machine
MOST = 20  # lines of a kind: the page and the table have all


@dataclass(frozen=True, slots=True)
class Cell:
    """Text, or lines of it; links: text and address of each."""

    lines: tuple[str, ...]
    links: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class FleetTable:
    """A part of the page: its title, an introduction, the table; numbers: columns set to the right; empty: what is said
    where it has no row; left: how many rows are not shown.
    """

    title: str
    intro: str
    head: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    numbers: frozenset[int] = frozenset()
    empty: str
    left: int = 0


def fleet_page(name: str, rows: tuple[Row, ...], summary: Summary) -> str:
    """The page, the same for the same rows to the byte. name: of the fleet file."""
    parts = [_failed(summary), _changed(summary), _shared(summary), _machines(summary)]
    return rendered(TEMPLATE, name=name, headline=_counts(rows, summary), facts=_facts(rows, summary), parts=parts)


def _facts(rows: Sequence[Row], summary: Summary) -> list[tuple[str, str]]:
    dates = sorted(row.date for row in rows if row.date is not None)
    verdicts = [row.verdict for row in summary.newest if row.verdict is not None]
    found = [
        ("machines", str(len(summary.newest))),
        ("folders of data", str(sum(bool(row.data) for row in rows))),
        ("with faults", str(len(summary.failed))),
        ("changed", str(len(summary.changed))),
    ]
    if dates:
        found.append(("dates", f"{dates[0]} to {dates[-1]}"))
    found += [(title, str(verdicts.count(verdict))) for verdict, title in TITLES.items() if verdict in verdicts]
    if summary.misfits:
        found.append(("do not fit their readings", str(len(summary.misfits))))
    return found


def _failed(summary: Summary) -> FleetTable:
    rows = [
        (_of(row.machine), _of(_when(row)), Cell(_faults(row))) for row in summary.failed
    ]  # fmt: skip
    return _table("Failed, and why", "", ("machine", "data", "faults"), rows, frozenset(), "No machine failed.")


def _faults(row: Row) -> tuple[str, ...]:
    left = len(row.faults) - MOST_FAULTS
    return (*row.faults[:MOST_FAULTS], f"and {left} more") if left > 0 else row.faults


def _changed(summary: Summary) -> FleetTable:
    intro = (
        f"An error counts as changed from {summary.limit:.1f} standard uncertainties of the difference on: of as many "
        "unchanged errors as were compared here, fewer than one goes so far by chance. Change: root mean square over "
        "the travel. Tool point: root mean square of its change over the volume, from home."
    )
    rows = []
    for one in summary.changed:
        tool = one.row.tool
        moved = DASH if tool is None or tool.change is None else quantity(tool.change, "mm")
        size = DASH if one.error.change is None else quantity(abs(one.error.change), one.error.unit)
        texts = (_when(one.row), _since(one.row), one.error.name, size, f"{one.error.change_in_u or 0.0:.1f}", moved)
        rows.append((_machine(one.row), *map(_of, texts)))
    head = ("machine", "data", "since", "error", "change", "change / u", "tool point")
    compared = any(row.against is not None for row in summary.newest)
    empty = "No error of any machine has changed." if compared else "There is nothing to compare with yet."
    return _table("What has changed", intro if rows else "", head, rows, frozenset({4, 5, 6}), empty)


def _shared(summary: Summary) -> FleetTable:
    rows = []
    for one in summary.shared:
        names = [row.machine for row in one.rows]
        more = [f"and {len(names) - MOST_NAMED} more"] if len(names) > MOST_NAMED else []
        told = ", ".join([*names[:MOST_NAMED], *more])
        rows.append((_of(_cause_title(one.label)), _of(str(len(names))), Cell(_sizes(one.causes)), _of(told)))
    asked = any(row.verdict is not None for row in summary.newest)
    empty = "No cause is named for more than one machine." if asked else "No diagnosis was asked for."
    return _table(
        "Causes that machines share", "", ("cause", "machines", "size, from to", "which"), rows, frozenset({1}), empty
    )


def _sizes(causes: Sequence[CauseFound]) -> tuple[str, ...]:
    """`width: 3.1 um to 4.0 um`, a line for each parameter."""
    found = []
    for name, (_, _, unit) in causes[0].parameters.items():
        values = sorted(one.parameters[name][0] for one in causes if name in one.parameters)
        found.append(f"{name}: {quantity(values[0], unit)} to {quantity(values[-1], unit)}")
    return tuple(found)


def _machines(summary: Summary) -> FleetTable:
    rows = []
    for row in summary.newest:
        tool, most = row.tool, row.most_changed
        sizes = [DASH if one is None else quantity(one, "mm") for one in
                 ((tool.rms, tool.largest, tool.u) if tool is not None else (None, None, None))]  # fmt: skip
        verdict = DASH if row.verdict is None else TEXT_OF.get(row.verdict, row.verdict)
        causes = Cell((verdict, *map(_named, row.causes), *map(_stale, row.stale)))
        moved = DASH if tool is None or tool.change is None else quantity(tool.change, "mm")
        changed = DASH if most is None else f"{most.name} {most.change_in_u or 0.0:.1f} u"
        fit = "failed" if row.faults else row.fit or DASH
        rows.append((_machine(row), _of(_when(row)), _of(fit), *map(_of, sizes), _of(moved), _of(changed), causes))
    head = (
        "machine",
        "newest data",
        "fit",
        "tool point, RMS",
        "largest",
        "u, RMS",
        "change, RMS",
        "most changed",
        "verdict and causes",
    )
    intro = "Tool point: length of the deviation over the volume, from home, for a tool at the origin of its frame."
    return _table("All machines", intro, head, rows, frozenset({3, 4, 5, 6}), "There is no machine.")


def _table(
    title: str,
    intro: str,
    head: tuple[str, ...],
    rows: Sequence[tuple[Cell, ...]],
    numbers: frozenset[int],
    empty: str,
) -> FleetTable:
    left = max(len(rows) - MOST_ROWS, 0)
    return FleetTable(
        title=title, intro=intro, head=head, rows=tuple(rows[:MOST_ROWS]), numbers=numbers, empty=empty, left=left
    )


def _of(text: str) -> Cell:
    return Cell((text,))


def _machine(row: Row) -> Cell:
    """The machine with links to its documents."""
    folder = PurePosixPath(MACHINES, row.machine, PurePosixPath(row.data).name or GIVEN)
    links = [(text, quote(str(folder / file))) for text, file in DOCUMENTS if file in row.files]
    return Cell((row.machine,), tuple(links))


def _since(row: Row) -> str:
    """The folder of the values before, or the file that was given."""
    if row.against is None:
        return DASH
    path = PurePosixPath(row.against)
    return path.parent.name if row.against.startswith("../") and path.name == "errors.json" else path.name


def fleet_text(rows: tuple[Row, ...], summary: Summary, made: int, kept: int) -> str:
    """What was done, what failed, what has changed, which causes are shared. ASCII, for a console of any encoding."""
    lines = [f"{_counts(rows, summary)}; {made} made now, {kept} as before"]
    lines += _some([line for row in summary.failed for line in _fault_lines(row)])
    lines += _some(
        [f"misfit: {row.machine} {_when(row)}: the values do not fit their readings" for row in summary.misfits]
    )
    lines += _some([f"changed: {one.row.machine} {_when(one.row)}: {_change(one)}" for one in summary.changed])
    lines += _some(
        [f"cause: {_cause_title(one.label)}: {', '.join(row.machine for row in one.rows)}" for one in summary.shared]
    )
    lines += _some(
        [f"named: {row.machine} {_when(row)}: {_named(one)}" for row in summary.newest for one in row.causes]
    )
    lines += _some([f"stale: {row.machine} {_when(row)}: {_stale(one)}" for row in summary.newest for one in row.stale])
    return ascii_only("\n".join(lines)) + "\n"


def _some(lines: list[str]) -> list[str]:
    kind = lines[0].partition(":")[0] if lines else ""
    return lines if len(lines) <= MOST else [*lines[:MOST], f"{kind}: and {len(lines) - MOST} more"]


def _fault_lines(row: Row) -> list[str]:
    """The first ones each: which of them helps most depends on the slip."""
    lines = [f"fault: {row.machine} {_when(row)}: {fault}" for fault in row.faults[:MOST_TOLD]]
    if left := len(row.faults) - MOST_TOLD:
        lines[-1] += f" (and {left} more)" if left > 0 else ""
    return lines


def _cause_title(label: str) -> str:
    """`Backlash EYY` of `backlash EYY`."""
    text = label.replace("_", " ")
    return text[:1].upper() + text[1:]


def _named(cause: CauseFound) -> str:
    """`Backlash EYY, width 5.95 um`, `Backlash EAY, width 9 urad; or Backlash EYY`."""
    sizes = [f"{name} {quantity(value, unit)}" for name, (value, _, unit) in cause.parameters.items()]
    left = len(cause.rivals) - MOST_RIVALS
    others = [*map(_cause_title, cause.rivals[:MOST_RIVALS]), *([f"{left} more"] if left > 0 else [])]
    either = f"; or {', '.join(others)}" if others else "" if cause.certain else " (not certain)"
    return ", ".join([_cause_title(cause.label), *sizes[:1]]) + either


def _stale(one: StaleFound) -> str:
    """`EC0Y changed by 40 urad, u 0.43 urad`."""
    u = "" if one.u is None else f", u {quantity(one.u, one.unit, 2)}"
    return f"{one.name} changed by {quantity(one.change, one.unit)}{u}"


def _when(row: Row) -> str:
    """The date of a row, or what stands for it."""
    return row.date or row.data or "values given"


def _counts(rows: tuple[Row, ...], summary: Summary) -> str:
    """`3 machines, 7 folders of data, 2 with faults`."""
    return (
        f"{_plural(len(summary.newest), 'machine')}, {_plural(len(rows), 'row')}, "
        f"{len(summary.failed) or 'none'} with faults"
    )


def _change(one: Changed) -> str:
    """`EYY by 4.1 um, 12.3 u`."""
    error = one.error
    size = "" if error.change is None else f"{quantity(abs(error.change), error.unit)}, "
    return f"{error.name} by {size}{error.change_in_u or 0.0:.1f} u"


def _plural(count: int, noun: str) -> str:
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"
