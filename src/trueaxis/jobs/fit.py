"""Identified curves to optimal polynomials."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import polars as pl

from trueaxis.error_name import ErrorName
from trueaxis.io.faults import Fault, InputError, RefusedError
from trueaxis.jobs.given import check_fit, name_of, with_errors
from trueaxis.jobs.load import Errors
from trueaxis.jobs.printed import Printed
from trueaxis.jobs.tables import Tabular, at_least_zero
from trueaxis.jobs.typed import typed
from trueaxis.machine import Machine
from trueaxis.model.curves import LegendreCurve, TableCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.extent import UncertaintyExtent, travel_positions, uncertainty_extent
from trueaxis.model.model import MachineModel
from trueaxis.model.uncertainty import curve_u
from trueaxis.reporting.reliance import above_sentence, curve_sentences, extent_sentences, worth_nothing_sentences

if TYPE_CHECKING:
    from trueaxis.identification.polynomial import OptimalFit

HIGHEST_ORDER = 15
DRAWN = 101  # points of a curve in the picture
NO_KERNELS = "there are no kernels of this machine (--kernels): the uncertainty of the tool point is not stated"


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Fitted(Printed, Tabular):
    """Error values whose curves are polynomials. errors: with the covariance; given: those before; fits: of tables, and
    of the curves of an estimate, by component, with all statistics; resting: components that rest on the prior and stay
    as they are; uncertainty: of the tool point over the travel, None without kernels; notes: what must be known.
    significant: whether every table has a polynomial. Printed, it is the report of `trueaxis fit`.
    """

    errors: Errors
    given: Errors
    fits: "Mapping[str, OptimalFit]"
    resting: tuple[str, ...]
    uncertainty: UncertaintyExtent | None
    notes: tuple[str, ...]
    significant: bool

    def to_polars(self) -> pl.DataFrame:
        """A row for each term of each polynomial: power, coefficient and u, mm or rad by mm or deg, t, p."""
        rows = [
            (name, power, *values)
            for name, fit in self.fits.items()
            for power, *values in zip(
                fit.after.powers, fit.after.coefficients, fit.after.u, fit.after.t_values, fit.after.p_values,
                strict=True,
            )
        ]  # fmt: skip
        numbers = dict.fromkeys(("coefficient", "u", "t_value", "p_value"), pl.Float64)
        return pl.DataFrame(rows, schema={"component": pl.String, "power": pl.Int64, **numbers}, orient="row")

    def text(self, *, statistics: bool = False) -> str:
        """The report; statistics: with those of each equation, before and after, as a table."""
        from trueaxis.identification.polynomial import statistics_table  # noqa: PLC0415  statsmodels: as in `fitted`

        lines = []
        for name, fit in self.fits.items():
            unit, factor = ("um", 1e3) if ErrorName(name).unit == "mm" else ("urad", 1e6)
            lines.append(f"{name}: {fit.verdict}")
            if statistics:
                lines.append(f"{statistics_table(fit, unit, factor)}\n")
        return "\n".join([*lines, *(f"note: {note}" for note in self.notes)]) + "\n"

    def __str__(self) -> str:
        return self.text()

    def picture(self) -> bytes:
        """Values and polynomials, before and after, as PNG."""
        from trueaxis.reporting.pictures.curves import DrawnCurve, curves_picture  # noqa: PLC0415  matplotlib takes long to import

        values, covariance = self.given.values, self.given.covariance
        bars = {}
        for name, fit in self.fits.items():
            curve = values.motion_errors[name]
            if isinstance(curve, TableCurve) and curve.u:
                bars[name] = np.array(curve.u)[np.array(curve.positions) != 0.0]
            elif isinstance(curve, LegendreCurve) and covariance.root is not None:
                bars[name] = curve_u(covariance, name, fit.samples.positions)
        kept = [name for name, fit in self.fits.items() if not fit.after.powers]
        drawn = {}
        for name in (*self.resting, *kept):
            curve = values.motion_errors[name]
            if isinstance(curve, LegendreCurve):
                at = np.linspace(curve.basis.low, curve.basis.high, DRAWN)
                u = np.zeros(at.size) if covariance.root is None else curve_u(covariance, name, at)
                drawn[name] = DrawnCurve(at, curve(at), u)
        by_prior = {name: one for name, one in drawn.items() if name in self.resting}
        machine = self.errors.machine
        travel = {} if machine is None else {name: machine.travel[ErrorName(name).axis] for name in self.fits}
        doubtful = () if self.uncertainty is None else self.uncertainty.components
        grey = [name for name in doubtful if name not in by_prior]
        return curves_picture(self.fits, u=bars, undetermined=grey, by_prior=by_prior, travel=travel,
                              kept={name: one for name, one in drawn.items() if name in kept})  # fmt: skip


@typed
def fit(
    model: MachineModel,
    errors: Errors,
    *,
    max_order: int = 7,
    alpha: float = 0.05,
    max_u: float | None = None,
    accept_misfit: bool = False,
) -> Fitted:
    """Replace the curves of error values by optimal polynomials that are zero at home, as in Sect. 4 of the paper.

    Orders by the mean square error, an F test of the equation, t tests of its terms, terms by AIC. max_order: highest
    power tried, 1 to 15; alpha: significance level of the tests; max_u: largest standard uncertainty of the tool point
    over the travel, from home, mm; accept_misfit: accept values that do not fit their readings. Curves that rest on
    the prior stay as they are. Write the result with `save_errors`. Raises InputError if there is nothing to fit, or
    the values are a misfit or edited; RefusedError if max_u is exceeded; ValueError for arguments of another form.
    """
    if not (isinstance(max_order, int) and 1 <= max_order <= HIGHEST_ORDER):
        raise ValueError(f"max_order: expected a whole number from 1 to {HIGHEST_ORDER}; given {max_order}")
    if not 0.0 < alpha < 1.0:
        raise ValueError(f"alpha: expected a number above 0 and below 1; given {alpha}")
    at_least_zero(max_u=max_u)
    with_errors(model, errors)
    check_fit(errors.values, name_of(errors), accept_misfit)
    done = fitted(model.machine, errors, model, max_order=max_order, alpha=alpha)
    if refused := refusal(done, max_u):
        raise RefusedError((refused,), done)
    return done


def fitted(machine: Machine, errors: Errors, model: MachineModel | None, *, max_order: int, alpha: float) -> Fitted:
    """As `fit`, without limits; model: None where there are no kernels."""
    # statsmodels takes a second to import; only this job needs it
    from trueaxis.identification.curve_fit import fit_tables, in_polynomials, polynomial_curves  # noqa: PLC0415
    from trueaxis.identification.legendre_fit import fit_legendre, with_polynomials  # noqa: PLC0415

    given, covariance = errors.values, errors.covariance
    fits = fit_tables(given.motion_errors, max_order=max_order, alpha=alpha)
    of_estimate, resting = fit_legendre(given, covariance, machine, max_order=max_order, alpha=alpha)
    if not fits and not of_estimate:
        raise InputError([_nothing_to_fit(given, name_of(errors))])
    values, of_values = with_polynomials(given, covariance, machine, of_estimate)
    curves, notes = polynomial_curves(values.motion_errors, fits)
    values = replace(values, motion_errors=curves, covariance=None)
    of_values = in_polynomials(of_values, given.motion_errors, curves)
    notes += curve_sentences([name for name, one in of_estimate.items() if not one.after.powers], resting)
    extent, stated = None, [NO_KERNELS]
    if model is not None:
        model = model.with_values(values)
        extent = uncertainty_extent(model, of_values, travel_positions(model, of_values), np.zeros((3, 1)))
        stated = extent_sentences(extent, "over the travel") + worth_nothing_sentences(extent)
    return Fitted(
        errors=Errors(values, replace(of_values, sha256_of_values=""), machine=machine),
        given=errors,
        fits={**fits, **of_estimate},
        resting=tuple(resting),
        uncertainty=extent,
        notes=(*notes, *stated),
        significant=all(one.after.powers for one in fits.values()),
    )


def refusal(done: Fitted, max_u: float | None) -> str:
    """Why the values may not be written; empty where they may."""
    extent = done.uncertainty
    if extent is None or max_u is None or not extent.refused(max_u, accepted=True):
        return ""
    return above_sentence(extent.counted, max_u)


def _nothing_to_fit(errors: ErrorValues, file: str) -> Fault:
    curves = errors.motion_errors.values()
    if any(isinstance(curve, LegendreCurve) for curve in curves):
        problem = "rest on the prior: no reading tells of them, so that there is nothing to fit"
        return Fault(file, "motion_errors", problem, "use these error values as they are, or measure more")
    if curves and not any(isinstance(curve, TableCurve) for curve in curves):
        problem = "are polynomials already, without a table: there is nothing to fit"
        return Fault(file, "motion_errors", problem, "use these error values as they are")
    return Fault(file, "motion_errors", "has no table of three positions or more")
