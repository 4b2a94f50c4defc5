"""Error values as a table, one row for each."""

import numpy as np
import polars as pl

from trueaxis.error_name import ErrorName
from trueaxis.io.safe_text import html_table
from trueaxis.machine.machine import Machine
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import Curve, LegendreCurve, TableCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.uncertainty import curve_u

SAMPLES = 65  # positions at which the largest value of a curve is sought, at least
_SCHEMA = {
    "error": pl.String, "unit": pl.String, "value": pl.Float64, "u": pl.Float64, "at": pl.Float64, "basis": pl.String,
    "determined": pl.String,
}  # fmt: skip
Row = tuple[str, str | None, float | None, float | None, float | None, str, str | None]


def errors_frame(values: ErrorValues, covariance: Covariance, machine: Machine | None = None) -> pl.DataFrame:
    """A row for each component, parameter and effect's parameter.

    value: of a component its largest over the range of its table or estimate, else over the travel, at the position
    `at`, mm or deg; null where no range is known. unit: mm or rad, null where it is not known without the machine, and
    of parameters of effects, which have those of their kinds. u: standard uncertainty, null where it is not known.
    """
    rows: list[Row] = [
        (name, ErrorName(name).unit, *_largest(name, curve, covariance, machine), values.determined.get(name))
        for name, curve in values.motion_errors.items()
    ]
    for name, value in values.parameters.items():
        unit = None if machine is None else machine.parameter_unit(name)
        rows.append((name, unit, value, values.u.get(name), None, "number", values.determined.get(name)))
    for one in values.effects:
        label = one.effect.label
        rows += [(f"{label} {name}", None, value, None, None, "effect", None) for name, value in one.parameters.items()]
    return pl.DataFrame(rows, schema=_SCHEMA, orient="row").with_columns(pl.col("value", "u").fill_nan(None))


def _largest(
    name: str, curve: Curve, covariance: Covariance, machine: Machine | None
) -> tuple[float | None, float | None, float | None, str]:
    """The value that is farthest from zero, its u, its position, and what kind of curve it is of."""
    if isinstance(curve, TableCurve):
        basis, positions = "table", np.array(curve.positions)
    elif isinstance(curve, LegendreCurve):
        basis, positions = curve.basis.form, curve.basis.evenly(SAMPLES)
    else:
        basis, at = "polynomial", curve.measured if machine is None else machine.travel[ErrorName(name).axis]
        if at is None:
            return None, None, None, basis
        positions = np.linspace(*at, SAMPLES)
    found = curve(positions)
    worst = int(np.argmax(np.abs(found)))
    u = None
    if covariance.root is not None and name in covariance.components:
        u = float(curve_u(covariance, name, positions[worst : worst + 1])[0])
    return float(found[worst]), u, float(positions[worst]), basis


def errors_text(values: ErrorValues, covariance: Covariance, machine: Machine | None = None) -> str:
    """The same as text."""
    fit = "" if values.fit is None else f", fit {values.fit.state}"
    with pl.Config(tbl_rows=-1, tbl_cols=-1, tbl_width_chars=-1, fmt_str_lengths=80, tbl_hide_dataframe_shape=True,
                   tbl_hide_column_data_types=True, tbl_formatting="ASCII_MARKDOWN"):  # fmt: skip
        return f"{values.machine}: error values{fit}\n{errors_frame(values, covariance, machine)}"


def errors_html(values: ErrorValues, covariance: Covariance, machine: Machine | None = None) -> str:
    """The same for a notebook, with how the fit ended."""
    frame = errors_frame(values, covariance, machine)
    fit = "" if values.fit is None else f", fit {values.fit.state}"
    return html_table(f"{values.machine}: error values{fit}", frame.columns, frame.rows())
