"""The rows of a fleet: what has been done of one machine and one folder of its data, its file, the table, the summary.

The summary says what they come to: which machines have changed, which share a cause, which failed.
"""

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from datetime import date
from pathlib import Path
from typing import Any

import polars as pl
from scipy.special import ndtri  # scipy.stats has it, too, and takes a second to import

ROW_FILE = "row.json"
SCHEMA = 1
NUMBER, TEXT = pl.Float64, pl.String
PARAMETER = pl.Struct({"name": TEXT, "value": NUMBER, "u": NUMBER, "unit": TEXT})
CAUSE = pl.Struct(
    {"cause": TEXT, "kind": TEXT, "component": TEXT, "certain": pl.Boolean, "rivals": pl.List(TEXT),
     "parameters": pl.List(PARAMETER)}
)  # fmt: skip
STALE = pl.Struct({"name": TEXT, "change": NUMBER, "u": NUMBER, "unit": TEXT})

ERROR = pl.Struct(
    {"name": TEXT, "value": NUMBER, "u": NUMBER, "at": NUMBER, "unit": TEXT, "determined": TEXT, "change": NUMBER,
     "change_in_u": NUMBER}
)  # fmt: skip

TABLE_SCHEMA: dict[str, pl.DataType | type[pl.DataType]] = {
    "machine": TEXT, "data": TEXT, "date": pl.Date, "tasks": pl.List(TEXT), "verdict": TEXT, "causes": pl.List(CAUSE),
    "stale": pl.List(STALE), "fit": TEXT, "chi2": NUMBER,
    "tool_rms": NUMBER, "tool_largest": NUMBER, "tool_u": NUMBER, "tool_change": NUMBER,
    "against": TEXT, "most_changed": TEXT, "most_changed_in_u": NUMBER, "errors": pl.List(ERROR),
    "faults": pl.List(TEXT), "notes": pl.List(TEXT),
}  # fmt: skip
CHANGED = 3.0  # standard uncertainties: at least, as in the document of one machine
# A curve that stays as it is passes 3 u somewhere on its travel in one case of 60, six times as often as one number
# does: it counts as so many numbers. Of a whole fleet less than one change is to be called that is none.
NUMBERS_OF_A_CURVE = 6.2


@dataclass(frozen=True, slots=True, kw_only=True)
class CauseFound:
    """A cause that a diagnosis names. kind, component: of the effect, component None of an instrument; label: as
    reports name it; certain: whether nothing else explains the readings as well; rivals: labels of other effects that
    do; parameters: name -> value, u, unit.
    """

    kind: str
    component: str | None
    label: str
    certain: bool
    parameters: Mapping[str, tuple[float, float | None, str]]
    rivals: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class StaleFound:
    """An error whose value, as the diagnosis was given it, is no longer right: its change where that is clearest, with
    its standard uncertainty, mm or rad.
    """

    name: str
    change: float
    u: float | None
    unit: str


@dataclass(frozen=True, slots=True, kw_only=True)
class ValueFound:
    """An error: of a component its largest value over the travel, at the position `at` (mm, deg; None of a location
    error); u: there; unit: mm or rad; determined: by what; change: since the values before, root mean square over the
    travel; change_in_u: the largest, in standard uncertainties of the difference. None: not known, or nothing before.
    """

    name: str
    value: float
    u: float | None
    at: float | None
    unit: str
    determined: str | None
    change: float | None = None
    change_in_u: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class ToolFound:
    """Length of the deviation of the tool point over the volume, from home, mm: root mean square, largest, its u, and
    the root mean square of its change since the values before. None: not known, or nothing before.
    """

    rms: float
    largest: float
    u: float | None
    change: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Row:
    """machine: id; data: the folder, as paths in the fleet file are written, empty where there is none; date: ISO,
    None: its name holds none; inputs: digest of all that the row comes from, empty where the work was lost and is to be
    done again; tasks: that were asked for; verdict, causes, stale: of the diagnosis; fit, chi2: of the identification;
    values: of the errors; tool: point over the volume; against: what the changes are since; faults, notes: a sentence
    each; files: that were written, in the folder of the row; newest: the file of the newest values of the machine, this
    row's or those before it, relative to the folder of the row, None: there are none.
    """

    machine: str
    data: str
    date: str | None
    inputs: str
    tasks: tuple[str, ...]
    verdict: str | None = None
    causes: tuple[CauseFound, ...] = ()
    stale: tuple[StaleFound, ...] = ()
    fit: str | None = None
    chi2: float | None = None
    values: tuple[ValueFound, ...] = ()
    tool: ToolFound | None = None
    against: str | None = None
    faults: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    files: tuple[str, ...] = ()
    newest: str | None = None

    @property
    def most_changed(self) -> ValueFound | None:
        """The error that has changed by the most standard uncertainties; None where nothing is known of changes."""
        known = [one for one in self.values if one.change_in_u is not None]
        return max(known, key=lambda one: one.change_in_u or 0.0, default=None)


def row_text(row: Row) -> str:
    """The content of its file."""
    return json.dumps({"schema": SCHEMA, **asdict(row)}, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def read_row(folder: Path) -> Row | None:
    """The row of a folder of results; None where there is none, or another version or a damaged disk wrote it."""
    try:
        tree = json.loads((folder / ROW_FILE).read_text(encoding="utf-8"))
        row = _row(tree) if tree.pop("schema") == SCHEMA else None
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None
    # files that a row names are removed when it is made anew: none beyond its folder
    own = row is not None and all(not Path(name).is_absolute() and ".." not in Path(name).parts for name in row.files)
    return row if own else None


def _row(tree: dict[str, Any]) -> Row:
    texts: dict[str, Any] = {key: tuple(map(str, tree.pop(key))) for key in ("tasks", "faults", "notes", "files")}
    causes = tuple(
        CauseFound(
            **{
                **one,
                "parameters": {name: tuple(of) for name, of in one["parameters"].items()},
                "rivals": tuple(one["rivals"]),
            }
        )
        for one in tree.pop("causes")
    )
    stale = tuple(StaleFound(**one) for one in tree.pop("stale"))
    values = tuple(ValueFound(**one) for one in tree.pop("values"))
    tool = tree.pop("tool")
    return Row(
        **tree, **texts, causes=causes, stale=stale, values=values, tool=None if tool is None else ToolFound(**tool)
    )


def rows_frame(rows: Sequence[Row]) -> pl.DataFrame:
    """A row for each; lengths mm, angles rad."""
    return pl.DataFrame([_cells(row) for row in rows], schema=TABLE_SCHEMA)


def _cells(row: Row) -> dict[str, object]:
    tool, most = row.tool, row.most_changed
    causes = [
        {
            "cause": one.label, "kind": one.kind, "component": one.component, "certain": one.certain,
            "rivals": list(one.rivals),
            "parameters": [
                {"name": name, "value": value, "u": u, "unit": unit}
                for name, (value, u, unit) in one.parameters.items()
            ],
        }
        for one in row.causes
    ]  # fmt: skip
    return {
        "machine": row.machine, "data": row.data or None,
        "date": None if row.date is None else date.fromisoformat(row.date), "tasks": list(row.tasks),
        "verdict": row.verdict, "causes": causes, "stale": [asdict(one) for one in row.stale],
        "fit": row.fit, "chi2": row.chi2,
        "tool_rms": None if tool is None else tool.rms, "tool_largest": None if tool is None else tool.largest,
        "tool_u": None if tool is None else tool.u, "tool_change": None if tool is None else tool.change,
        "against": row.against, "most_changed": None if most is None else most.name,
        "most_changed_in_u": None if most is None else most.change_in_u,
        "errors": [asdict(one) for one in row.values], "faults": list(row.faults), "notes": list(row.notes),
    }  # fmt: skip


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
