"""What a plan determines of each error, and with what standard uncertainty."""

import numpy as np
import numpy.typing as npt

from trueaxis.estimation.machine import units
from trueaxis.identify.global_fit.layout import Layout
from trueaxis.identify.words import unit_of
from trueaxis.measure.machine import FloatArray
from trueaxis.plan.convention import Settled
from trueaxis.plan.report import CurveReport, LocationReport, State
from trueaxis.plan.system import System

OPEN = 1e-4  # share of an unknown in an open combination, scaled, below which that does not matter to it
TRAVEL_POINTS = 101


def covariance(whole: System, settled: Settled, noise: float) -> FloatArray:
    """(n, n) in mm and rad, for readings of standard deviation `noise` (mm); of what is open it says nothing."""
    size = whole.layout.scale[:, np.newaxis] * settled.projector
    return noise**2 * (size @ whole.factors.covariance() @ size.T)


def curves(whole: System, settled: Settled, spread: FloatArray) -> tuple[CurveReport, ...]:
    """Every component of the machine, in its order."""
    layout = whole.layout
    place_of = {int(component): place for place, component in enumerate(layout.components)}
    found = []
    for index, name in enumerate(layout.machine.components):
        place = place_of.get(index)
        if place is None:
            state: State = "given" if name in whole.given else "not seen"
            found.append(CurveReport(name, state, 0, 0, None, None, unit_of(name)))
            continue
        mine = np.arange(layout.count)[layout.of_component(place)]
        state, determined = _state(whole, settled, mine)
        measured = travelled = None
        if determined == mine.size:
            basis, of_axis = layout.basis_of(place), spread[np.ix_(mine, mine)]
            knots = layout.knots[layout.axis[place]]
            travel = np.linspace(*layout.machine.travel[name[2]], TRAVEL_POINTS)
            measured, travelled = (_largest(of_axis, basis(at)) for at in (knots, travel))
        found.append(CurveReport(name, state, mine.size, determined, measured, travelled, unit_of(name)))
    return tuple(found)


def locations(
    whole: System, settled: Settled, spread: FloatArray, by_end_points: FloatArray
) -> tuple[LocationReport, ...]:
    """Every location error of the machine, in its order; by_end_points: the covariance with the other convention."""
    layout, machine = whole.layout, whole.layout.machine
    unit = units(machine)[len(machine.components) :]
    found = []
    for index, name in enumerate(machine.location_errors):
        if index not in layout.locations:
            found.append(LocationReport(name, "given", None, None, unit[index]))
            continue
        at = int(layout.offset[-1]) + int(np.flatnonzero(layout.locations == index)[0])
        state, determined = _state(whole, settled, np.array([at]))
        u = float(np.sqrt(spread[at, at])) if determined else None
        other = float(np.sqrt(by_end_points[at, at])) if state == "by convention" else None
        found.append(LocationReport(name, state, u, other, unit[index]))
    return tuple(found)


def opened(settled: Settled) -> npt.NDArray[np.bool_]:
    """(n,): unknowns that take part in an open combination."""
    return np.asarray(np.abs(settled.open).max(axis=1, initial=0.0) > OPEN)


def _state(whole: System, settled: Settled, mine: npt.NDArray[np.int64]) -> tuple[State, int]:
    """What is known of unknowns, and how many combinations of them alone are."""
    if not whole.seen[mine].any():
        return "not seen", 0
    size = np.linalg.svd(settled.open[mine], compute_uv=False)
    determined = mine.size - int(np.count_nonzero(size > OPEN))
    if determined == 0:
        return "undetermined", 0
    if determined < mine.size:
        return "partly", determined
    by_rule = bool(np.abs(settled.settled[mine]).max(initial=0.0) > OPEN)
    return ("by convention" if by_rule else "determined"), determined


def _largest(spread: FloatArray, basis: FloatArray) -> float:
    variance = np.einsum("kn,kl,ln->n", basis, spread, basis)
    return float(np.sqrt(np.max(variance, initial=0.0)))


def worst(layout: Layout, spread: FloatArray) -> float:
    """Largest standard deviation of a scaled unknown, mm."""
    return float(np.max(np.sqrt(np.maximum(np.diag(spread), 0.0)) / layout.scale, initial=0.0))
