"""How far a result relies on what was measured, in sentences; which curves of an estimate `fit` leaves as they are."""

from collections.abc import Collection, Mapping, Sequence
from math import isfinite

import numpy as np

from trueaxis.compensation.reliance import NOTICEABLE, Reliance
from trueaxis.io.safe_text import plain_zero
from trueaxis.machine.machine import LINEAR
from trueaxis.model.best_fit import Placement
from trueaxis.model.curves import FloatArray
from trueaxis.model.errors import ErrorValues, Fit
from trueaxis.model.extent import UncertaintyExtent
from trueaxis.model.measured_range import BeyondMeasured
from trueaxis.monte_carlo.drawn import QUANTITIES, Drawn

_CONTINUED = "no reading supports the curve there"


def range_sentences(beyond: Sequence[BeyondMeasured], total: int) -> list[str]:
    """One for each range that was left, of `total` positions; one for each axis whose curves rest on the prior."""
    found = [
        f"{one.count} of {total} positions lie beyond the measured range: {', '.join(one.components)} "
        f"from {one.axis} = {one.low:g} to {one.high:g} {_unit(one.axis)}, used at {_reached(one)}; {_CONTINUED}"
        for one in beyond
        if not one.by_prior
    ]
    for axis in dict.fromkeys(one.axis for one in beyond if one.by_prior):
        of_axis = [one for one in beyond if one.by_prior and one.axis == axis]
        found.append(
            f"{_beyond(of_axis, total)} beyond the measured range of {axis} "
            f"({_ranges(of_axis)}): the curves rest on [prior] of the spec there, and u says how far"
        )
    return found


def _beyond(of_axis: Sequence[BeyondMeasured], total: int) -> str:
    """`up to 2 of 4 positions lie`, where components have ranges of their own; else without `up to`."""
    counts = {one.count for one in of_axis}
    most = max(counts)
    return f"{'up to ' * (len(counts) > 1)}{most} of {total} positions {'lies' if most == 1 else 'lie'}"


def travel_sentences(beyond: Sequence[BeyondMeasured]) -> list[str]:
    """Of tables over the whole travel: where they go on beyond what was measured. Where curves rest on the prior the
    uncertainty over the travel says it.
    """
    return [
        f"{', '.join(one.components)}: measured from {one.axis} = {one.low:g} to {one.high:g} {_unit(one.axis)}, "
        f"written for {_reached(one)}; {_CONTINUED}"
        for one in beyond
        if not one.by_prior
    ]


def _ranges(beyond: Sequence[BeyondMeasured]) -> str:
    """`EXX, EYX 10 to 400 mm, EZX 20 to 380 mm`."""
    return ", ".join(
        f"{', '.join(one.components)} {one.low:g} to {one.high:g} {_unit(one.axis)}" for one in beyond
    )  # fmt: skip


def open_sentence(points: int, total: int, largest: float, names: Sequence[str]) -> str:
    """Where deviations rest on what nothing determines; largest: what it moves the tool by at the prior size, mm."""
    of = f" ({', '.join(names)})" if names else ""
    return (
        f"{_at_positions(points, total)} the deviation rests on values that neither readings nor a prior determine{of}"
        f": it is not known there, and has no u. One combination of them alone, of the sizes in "
        f"[prior], would move the tool by up to {_um(largest)}"
    )


def usual_sentence(u: float, usual: float) -> str:
    """Where u rests on sizes of instrument unknowns far below the usual ones; u, usual: RMS by both, mm."""
    return (
        f"u ({_um(u)} RMS in one coordinate) rests on instrument unknowns far smaller than usual; by the usual sizes "
        f"it is {_um(usual)}: see the note of identify"
    )


def placement_sentence(placement: Placement) -> str:
    """What a best fit takes off."""
    shift = ", ".join(f"{plain_zero(1e3 * part):.3g}" for part in placement.shift)
    turn = ", ".join(f"{plain_zero(1e6 * part):.3g}" for part in placement.rotation)
    at = " ".join(f"{axis}{part:.4g}" for axis, part in zip("XYZ", placement.centre, strict=True))
    return (
        f"the best fit shifts the workpiece by {shift} um (x, y, z, at {at} of the workpiece frame) and turns it by "
        f"{turn} urad (about x, y, z)"
    )


def draw_sentences(drawn: Drawn, axes: Sequence[str], positions: FloatArray, with_noise: bool) -> list[str]:
    """What draws say beside linear propagation. positions: (n_axes, n), mm or deg; with_noise: whether they have noise,
    u has none.
    """
    points, whose = int(drawn.differing.any(axis=0).sum()), "u and the noise together" if with_noise else "u"
    if not points:
        told = f"its 95 % intervals agree with those of {whose} to the digits that u has"
    else:
        row, most = np.unravel_index(np.nanargmax(drawn.apart), drawn.apart.shape)
        at = ", ".join(f"{axis} {value:.6g}" for axis, value in zip(axes, positions[:, most], strict=True))
        told = (
            f"at {points} of {positions.shape[1]} points its 95 % interval is another than that of {whose}, by up to "
            f"{_um(drawn.apart[row, most])} ({QUANTITIES[row]} at {at}): take low and high there"
        )
    return [f"{drawn.count} draws (GUM Supplement 1): {told}"]


def extent_sentences(extent: UncertaintyExtent, where: str) -> list[str]:
    """The largest uncertainty of the tool point over positions; where: such as `over the travel`."""
    if not extent.points:
        return []
    if extent.unknown == extent.points and not extent.open:
        return [f"the uncertainty of the tool point {where} is not known: the error values have none"]
    found = []
    if extent.unknown < extent.points:
        of = " of the positions where it is known" if extent.unknown else ""
        prior = extent.largest_u_prior
        part = "" if not prior else f" (largest part from [prior] of the spec: {_um(prior)})"
        usual = ""
        if extent.largest_u_usual is not None:
            usual = (
                f"; it rests on instrument unknowns far smaller than usual, by the usual sizes it is "
                f"{_um(extent.largest_u_usual)}: see the note of identify"
            )
        found.append(
            f"largest standard uncertainty of the tool point {where}{of}, from {extent.datum}, in one coordinate: "
            f"{_um(extent.largest_u)}{part}{usual}"
        )
    if extent.open:
        found.append(f"{_at_positions(extent.open, extent.points)} {where} {_open_text(extent)}")
    return found


def prior_sentences(errors: ErrorValues, named: Collection[str]) -> list[str]:
    """Values that no reading told: they rest on the prior, or on nothing; named: told already."""
    told = {name for item in errors.undetermined for name in item.parameters} - set(named)
    if errors.covariance is None or not told:
        return []
    names = [name for name in (*errors.motion_errors, *errors.parameters) if name in told]
    if errors.origin is not None and not errors.origin.prior:
        return [f"neither readings nor a prior determine {', '.join(names)}: how far their values are off is not known"]
    return [f"the readings do not determine {', '.join(names)}: their values and u rest on [prior] of the spec"]


def program_sentences(reliance: Reliance) -> list[str]:
    """How far a compensated program relies on what was measured."""
    found = extent_sentences(reliance.uncertainty, "at the places of the program")
    if reliance.uncertainty.shift:
        found.append(
            "the squareness set by convention tilts the tool: this tool point may be off by up to "
            f"{_um(reliance.uncertainty.shift)}, the same everywhere; set the work offset with this tool and with the "
            "compensated positions, and do so again for a tool of another length"
        )
    if reliance.at_home > NOTICEABLE:
        found.append(
            f"at home the error values displace this tool point by {_um(reliance.at_home)}"
            f"{f' (u {_um(reliance.at_home_u)})' if reliance.at_home_u else ''}, which compensation "
            "corrects as well; a work offset that was touched off without compensation does not know of it: see what "
            "is said of the zero of each work offset"
        )
    if reliance.largest_turn > 0.0 and reliance.allowed_turn is not None:
        found.append(
            f"largest correction of a rotary axis: {reliance.largest_turn:.4g} deg at {_at(reliance.turned_at)}"
        )
    found += [
        f"the program leaves the measured range: {', '.join(one.components)} from {one.axis} = {one.low:g} to "
        f"{one.high:g} {_unit(one.axis)}, used at {_reached(one)}; {_CONTINUED}"
        for one in reliance.beyond
        if not one.by_prior
    ]
    for axis in dict.fromkeys(one.axis for one in reliance.beyond if one.by_prior):
        of_axis = [one for one in reliance.beyond if one.by_prior and one.axis == axis]
        found.append(
            f"the program leaves the measured range of {axis} ({_ranges(of_axis)}): the curves rest on [prior] of the "
            "spec there, and u says how far"
        )
    return found


def refusal_sentences(reliance: Reliance, max_u: float | None) -> list[str]:
    """Why a program was not written; max_u: the limit that was asked for, mm."""
    found = []
    if reliance.too_uncertain and (max_u is None or reliance.uncertainty.counted > max_u):
        found.append(uncertain_sentence(reliance.uncertainty, max_u))
    elif reliance.too_uncertain and max_u is not None:
        found.append(
            f"every word holds the displacement at home, {_um(reliance.at_home)}, and its standard uncertainty is "
            f"{_um(reliance.at_home_u)}, where --max-u allows {_um(max_u)}: say --touched-off of each work offset that "
            "was touched off, and it is left out"
        )
    turned = reliance.allowed_turn is not None and reliance.largest_turn > reliance.allowed_turn
    if turned and reliance.allowed_turn is not None:
        found.append(
            f"a rotary axis would be corrected by {reliance.largest_turn:.4g} deg at {_at(reliance.turned_at)}, more "
            f"than {reliance.allowed_turn:.4g} deg; larger sizes in [prior] of the spec allow more"
        )
    if reliance.too_large and not turned and reliance.allowed_correction is not None:
        found.append(
            f"the correction at {_at(reliance.correction_at)} is {reliance.largest_correction:.4g} mm, more than "
            f"{reliance.allowed_correction:.4g} mm; --max-correction allows more, or larger sizes in [prior] of the "
            "spec, if the machine is that far off"
        )
    return found


def _open_text(extent: UncertaintyExtent) -> str:
    return (
        "the tool point rests on errors that neither readings nor a prior determine "
        f"({', '.join(extent.components) or 'location errors'}): it is not known there. One combination of them alone, "
        f"of the sizes in [prior], would move it by up to {_um(extent.largest_open)}"
    )


def _at_positions(count: int, total: int) -> str:
    return f"at all {total} positions" if count == total else f"at {count} of {total} positions"


def uncertain_sentence(extent: UncertaintyExtent, max_u: float | None) -> str:
    """Why a result is refused for its uncertainty; max_u: the limit that was asked for, mm, None: none was."""
    if max_u is not None:
        return above_sentence(extent.counted, max_u)
    reasons = [*worth_nothing_sentences(extent), *([_open_text(extent)] if extent.undetermined else [])]
    return f"{'; '.join(reasons)}. Measure more, identify with a prior, or take --accept-u, or a limit with --max-u"


def worth_nothing_sentences(extent: UncertaintyExtent) -> list[str]:
    """Where the noise in values is larger than what they correct."""
    if not extent.worth_nothing:
        return []
    return [
        f"the corrections are {_um(extent.correction_rms)}, and their uncertainty from the noise of the readings is "
        f"{_um(extent.u_readings_rms)} (root mean squares where it is known, from {extent.datum}): no better than "
        "doing nothing"
    ]


def above_sentence(u: float, limit: float) -> str:
    """Why a result is refused by --max-u; u: the largest standard uncertainty, infinite where none is known, mm."""
    known = f"the largest standard uncertainty is {_um(u)}" if isfinite(u) else "an uncertainty is not known"
    return f"{known}, and --max-u allows {_um(limit)}"


def error_free_sentences(error_free: bool) -> list[str]:
    """error_free: whether every error value is zero, or none is there."""
    if not error_free:
        return []
    return ["every error value is zero or missing: the machine is without errors, and nothing is corrected"]


def misfit_sentence(fit: Fit) -> str:
    """What a misfit means for whoever uses the values."""
    size = "" if fit.chi2 is None else f" (chi2 per degree of freedom {fit.chi2:.3g})"
    runs = f", worst in {', '.join(fit.runs[:5])}" if fit.runs else ""
    return f"these error values do not fit their readings{size}{runs}"


def _reached(one: BeyondMeasured) -> str:
    if one.lowest == one.highest:
        return f"{one.axis} = {one.lowest:g}"
    return f"{one.axis} = {one.lowest:g} to {one.highest:g}"


def _at(position: Mapping[str, float]) -> str:
    return " ".join(f"{axis}{value:g}" for axis, value in position.items())


def _um(length: float) -> str:
    return f"{plain_zero(length * 1e3):.3g} um"


def _unit(axis: str) -> str:
    return "mm" if axis in LINEAR else "deg"


def curve_sentences(without_polynomial: Sequence[str], by_prior: Sequence[str]) -> tuple[str, ...]:
    """without_polynomial: curves of which no polynomial is significant and near; by_prior: those that no reading
    determines.
    """
    found = []
    if without_polynomial:
        found.append(
            f"{', '.join(without_polynomial)}: no polynomial is both significant and near to the curve, by its u; "
            "the Legendre curve is kept"
        )
    if by_prior:
        found.append(
            f"{', '.join(by_prior)}: the readings do not determine these errors; their Legendre curves are kept, "
            "and the picture shows them dashed, with a band of 2 u"
        )
    return tuple(found)
