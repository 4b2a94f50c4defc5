"""The rows of a fleet as a table: results.parquet."""

from collections.abc import Sequence
from dataclasses import asdict
from datetime import date

import polars as pl

from trueaxis.fleets.row import Row

NUMBER, TEXT = pl.Float64, pl.String
PARAMETER = pl.Struct({"name": TEXT, "value": NUMBER, "u": NUMBER, "unit": TEXT})
CAUSE = pl.Struct(
    {"cause": TEXT, "kind": TEXT, "component": TEXT, "certain": pl.Boolean, "parameters": pl.List(PARAMETER)}
)
ERROR = pl.Struct(
    {"name": TEXT, "value": NUMBER, "u": NUMBER, "at": NUMBER, "unit": TEXT, "determined": TEXT, "change": NUMBER,
     "change_in_u": NUMBER}
)  # fmt: skip
SCHEMA: dict[str, pl.DataType | type[pl.DataType]] = {
    "machine": TEXT, "data": TEXT, "date": pl.Date, "tasks": pl.List(TEXT), "verdict": TEXT, "causes": pl.List(CAUSE),
    "fit": TEXT, "chi2": NUMBER, "tool_rms": NUMBER, "tool_largest": NUMBER, "tool_u": NUMBER, "tool_change": NUMBER,
    "against": TEXT, "most_changed": TEXT, "most_changed_in_u": NUMBER, "errors": pl.List(ERROR),
    "faults": pl.List(TEXT), "notes": pl.List(TEXT),
}  # fmt: skip


def rows_frame(rows: Sequence[Row]) -> pl.DataFrame:
    """A row for each; lengths mm, angles rad."""
    return pl.DataFrame([_cells(row) for row in rows], schema=SCHEMA)


def _cells(row: Row) -> dict[str, object]:
    tool, most = row.tool, row.most_changed
    causes = [
        {
            "cause": one.label, "kind": one.kind, "component": one.component, "certain": one.certain,
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
        "verdict": row.verdict, "causes": causes, "fit": row.fit, "chi2": row.chi2,
        "tool_rms": None if tool is None else tool.rms, "tool_largest": None if tool is None else tool.largest,
        "tool_u": None if tool is None else tool.u, "tool_change": None if tool is None else tool.change,
        "against": row.against, "most_changed": None if most is None else most.name,
        "most_changed_in_u": None if most is None else most.change_in_u,
        "errors": [asdict(one) for one in row.values], "faults": list(row.faults), "notes": list(row.notes),
    }  # fmt: skip
