"""A probe whose stylus is longer than its target says, on a world of five axes with exact rotations."""

from dataclasses import replace

import numpy as np
import pytest

from tests.worlds.effects import Effect
from tests.worlds.estimates import TOOL, World, deviations, rms_um, world
from tests.worlds.readings import measure
from tests.worlds.truth import Truth, draw_machine
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.instruments import STYLUSES
from trueaxis.estimation.misread import SURE
from trueaxis.estimation.result import Estimate
from trueaxis.measurement.setup import Device
from trueaxis.model.errors import ErrorValues

pytestmark = pytest.mark.usefixtures("values_alone")
SEED, MACHINE = 11, 11000  # X, Y, Z, B, C; a probe with two styluses on two spheres, 6 runs of 18
LONGER, FAR, EXACT = 0.05, 0.3, 1e-4  # mm


@pytest.fixture(scope="module")
def five_axes(tmp_path_factory: pytest.TempPathFactory) -> World:
    return world(SEED, tmp_path_factory.mktemp("world"))


@pytest.fixture(scope="module")
def truth(five_axes: World) -> Truth:
    return draw_machine(five_axes.design.machine, MACHINE)


def estimated(one: World, truth: Truth, length_u: float | None, longer: float = LONGER) -> Estimate:
    """From readings of a probe that is too long. length_u: as the table of the probe states it."""
    probes = tuple(run.id for run in one.design.plan.runs if run.instrument == "probe")
    hidden = truth.hiding(Effect("point_offset", "Z", -longer, runs=probes))  # Z leads from the workpiece to the holder
    reading = measure(one.design, hidden, MACHINE).reading
    device = Device(id="P", length_u=length_u)
    runs = tuple(replace(run, device=device) if run.instrument == "probe" else run for run in one.plan.runs)
    known = {name: one.model.errors.parameters[name] for name in one.model.dimensions}
    return estimate(
        one.model,
        replace(one.plan, reading=reading.copy(), runs=runs),
        ErrorValues(machine=one.model.name, parameters=known),
    )


def off(one: World, truth: Truth, found: Estimate) -> float:
    """Of the predicted tool point over the volume, um."""
    positions = np.array([one.points[axis] for axis in one.model.axes])
    return rms_um(
        deviations(one.model.with_values(found.values), positions) - truth.deviation(one.points, TOOL[:, 0], "home")
    )


@pytest.mark.parametrize("length_u", [LONGER, None])
def test_a_stylus_of_uncertain_length_is_none_of_the_machine(
    five_axes: World, truth: Truth, length_u: float | None
) -> None:
    """Stated, or as usual: nobody knows a length exactly; with a length that is taken as known it is the machine's."""
    found, exact = estimated(five_axes, truth, length_u), estimated(five_axes, truth, EXACT)
    rows = [place for place, one in enumerate(found.layout.shared) if one.kind in STYLUSES]
    assert len(rows) == 2  # of two tips
    length = found.unknowns[found.layout.of_shared][rows]
    u = np.linalg.norm(found.spread[found.layout.of_shared][rows], axis=1)
    assert u.max() < 0.2 * LONGER
    assert (np.abs(length - LONGER) < 2.0 * u).all()
    assert off(five_axes, truth, found) < 0.6 * off(five_axes, truth, exact)


@pytest.mark.parametrize(("length_u", "doubted"), [(0.01, True), (FAR, False)])
def test_a_length_that_is_a_wrong_number_is_named(
    five_axes: World, truth: Truth, length_u: float, doubted: bool
) -> None:
    """1 mm more than stated to 10 um became 1 mm of errors of a swivelling head, and nothing was said."""
    found = estimated(five_axes, truth, length_u, FAR).readings.doubted
    assert [len(one.runs) for one in found] == ([3, 3] if doubted else [])  # two tips
    for one in found:
        assert abs(one.longer - FAR) < 3.0 * one.u < 0.2 * FAR
        assert one.log_odds > SURE
