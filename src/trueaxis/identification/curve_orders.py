"""Identified tables as polynomials: by the paper's procedure or by held-out positions, each beside the other."""

from collections.abc import Mapping
from typing import Literal

from trueaxis.error_name import ErrorName
from trueaxis.identification.curve_fit import fit_tables, polynomial_curves
from trueaxis.identification.held_out import held_out
from trueaxis.identification.report import CurveOrderReport
from trueaxis.model.curves import Curve, PolynomialCurve


def ordered_curves(
    curves: Mapping[str, Curve], choice: Literal["polynomial", "held-out"]
) -> tuple[dict[str, Curve], tuple[str, ...], tuple[CurveOrderReport, ...]]:
    """The curves, notes on those that stay as they are, and both choices of powers with their held-out errors."""
    fits = fit_tables(curves)
    checked = held_out(fits)
    found, notes = polynomial_curves(curves, fits)
    if choice == "held-out":
        notes = tuple(note for note in notes if "stays a table" in note)
        for name, one in checked.items():
            coefficients, u = tuple(one.fit.coefficients.tolist()), tuple(one.fit.u.tolist())
            found[name] = PolynomialCurve(
                powers=one.fit.powers, coefficients=coefficients, u=u, measured=curves[name].measured
            )
    orders = tuple(
        CurveOrderReport(
            name=name,
            by_paper=fits[name].after.powers,
            by_held_out=one.fit.powers,
            held_out_by_paper=one.rms_optimal,
            held_out=one.rms,
            unit=ErrorName(name).unit,
        )
        for name, one in checked.items()
    )
    return found, notes, orders
