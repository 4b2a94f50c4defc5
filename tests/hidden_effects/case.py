"""One set of measured data with what is hidden in it, from a seed."""

from dataclasses import dataclass, replace

import numpy as np

from tests.hidden_effects import hidden, outside
from tests.hidden_effects.circles import PLANES
from tests.hidden_effects.curves import component_errors, location_values, total
from tests.hidden_effects.data import Data
from tests.hidden_effects.design import Design
from tests.hidden_effects.given import given_values
from tests.hidden_effects.hidden import Hidden
from tests.hidden_effects.machine import Array, Machine
from tests.hidden_effects.machines import MACHINES
from tests.hidden_effects.noise import RESOLUTION, noise
from tests.hidden_effects.readings import Truth, ideal_along, polar_angle, readings
from tests.hidden_effects.schedule import plan_runs
from tests.hidden_effects.state import Plan
from tests.hidden_effects.tamper import tampered

CENTRE_MM = 5e-3  # standard deviation of the ball's place, per plane
STANDARD = Design()
ZERO_MM = 1e-3  # and of a laser's zero, per run


@dataclass(frozen=True)
class Case:
    """noise: one of noise.KINDS, of standard deviation sigma_um; given: what errors.json says, one of `exact` (the
    truth as dense tables), `identified` (as from an identification with noise), `stale` (as it was before the machine
    changed), `zero`; tamper: `swap_directions`, `shuffle_time` or nothing; nuisance: zero offsets and ball centres.

    The plan, the machine's errors, what is given and the noise depend on the seed alone, not on the effects.
    """

    seed: int
    machine: str = "table_mill"
    design: Design = STANDARD
    effects: tuple[Hidden, ...] = ()
    noise: str = "realistic"
    sigma_um: float = 0.3
    given: str = "identified"
    tamper: str = ""
    nuisance: bool = True
    curvature: float = 1.0  # scale of the machine's own errors; 0: none


def generate(case: Case) -> Data:
    """The data of a case; the same ones each time. Raises KeyError for names of machines, kinds ... that are none."""
    machine = MACHINES[case.machine]
    plan = plan_runs(machine, case.design, _source(case, 1))
    curves = component_errors(_source(case, 2), machine, case.curvature)
    located = location_values(_source(case, 3), machine, case.curvature)
    then = given_values(case.given, _source(case, 4), machine, curves, located)
    if case.given == "stale":
        curves = total(curves, component_errors(_source(case, 5), machine, 0.4 * case.curvature))
    left_out = tuple(effect.component for effect in case.effects if effect.kind in hidden.OF_LOCATION)
    located |= dict.fromkeys(left_out, 0.0)
    balls, zeros = _nuisance(case, plan, _source(case, 6))
    reading = clean_readings(machine, plan, Truth(curves, located, case.effects, balls)) + zeros
    reading = reading + _noise(case, machine, plan, _source(case, 7))
    if case.noise in RESOLUTION:
        reading = np.round(reading / RESOLUTION[case.noise]) * RESOLUTION[case.noise]
    thermometer = _thermometer(case.design.temperature, plan, _source(case, 8))
    data = Data(machine, plan, np.round(reading, 8), thermometer, then, case.design, left_out)
    return tampered(case.tamper, data, _source(case, 9))


def clean_readings(machine: Machine, plan: Plan, truth: Truth) -> Array:
    """Readings without noise, (n,), mm."""
    located = dict(truth.located)
    for effect in truth.effects:
        if effect.kind in hidden.OF_LOCATION:
            located[effect.component] = located.get(effect.component, 0.0) + effect.size
    found = readings(machine, plan, replace(truth, located=located))
    along, theta = ideal_along(machine, plan), polar_angle(machine, plan)
    for effect in truth.effects:
        for place in (hidden, outside):
            if effect.kind in place.OF_READINGS:
                found = found + place.reading_terms(effect, plan, along, theta)
    return found


def _source(case: Case, stream: int) -> np.random.Generator:
    return np.random.default_rng([case.seed, stream])


def _thermometer(course: str, plan: Plan, source: np.random.Generator) -> Array:
    """degC; a course that is to be one with the time must not be told from it by the thermometer's noise."""
    if course == "linear":
        return plan.state.temperature
    return np.asarray(np.round(plan.state.temperature + 0.02 * source.standard_normal(len(plan.state.time)), 2), float)


def _noise(case: Case, machine: Machine, plan: Plan, source: np.random.Generator) -> Array:
    """Run by run, in the order of seq."""
    distance = np.abs(ideal_along(machine, plan))
    found = np.zeros(len(distance))
    for index in range(len(plan.runs)):
        rows = plan.state.run == index
        found[rows] = noise(case.noise, source, case.sigma_um * 1e-3, distance[rows])
    return found


def _nuisance(case: Case, plan: Plan, source: np.random.Generator) -> tuple[dict[str, Array], Array]:
    """By how much the balls are off, per plane, and the zero offset of each reading (of its run)."""
    size = 1.0 if case.nuisance else 0.0
    balls = {plane: size * CENTRE_MM * source.standard_normal(3) for plane in PLANES}
    of_runs = [size * ZERO_MM * source.normal() if run.length is None else 0.0 for run in plan.runs]
    return balls, np.array(of_runs)[plan.state.run]
