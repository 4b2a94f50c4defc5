"""A location error that a probe of unknown length tells is as uncertain as the length, and is said to be."""

from dataclasses import replace

import numpy as np
import pytest

from tests.planning.data import model
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.identification.tip_lengths import resting_on_length
from trueaxis.measurement.reading_geometry import home_positions
from trueaxis.measurement.reading_model import sensed_directions
from trueaxis.measurement.setup import Device
from trueaxis.model.errors import ErrorValues
from trueaxis.planning.candidates import candidates
from trueaxis.planning.kit import Kit
from trueaxis.view import view_of

pytestmark = pytest.mark.usefixtures("values_alone")
NOISE = 1e-3  # mm


def found(longer: float, length_u: float | None = None) -> tuple[Observations, Estimate]:
    """Spheres while tables turn, by a probe whose tip is lower than its set-up says, mm; a machine without errors."""
    machine = model("trunnion_mill")
    chosen = [
        one for one in candidates(machine, Kit(instruments=("probe",), everywhere=False)) if "turning" in one.what
    ]
    device, draw, readings = Device(id="P", length_u=length_u), np.random.default_rng(4), []
    for one in chosen:
        home = home_positions(one.run, machine.axes)
        assert home is not None
        view, tip = view_of("tool", one.run.frame), np.array([[0.0], [0.0], [-longer]])
        lower = [
            machine.view_ideal(view, at, tip) - machine.view_ideal(view, at, np.zeros((3, 1)))
            for at in (one.positions, home)
        ]
        sensed = np.einsum("in,in->n", sensed_directions(machine, one.run, one.positions), lower[0] - lower[1])
        readings.append(sensed + draw.normal(0.0, NOISE, sensed.size))
    observed = Observations(
        source="plan",
        runs=tuple(replace(one.run, device=device) for one in chosen),
        run=np.repeat(np.arange(len(chosen)), [one.positions.shape[1] for one in chosen]),
        positions=np.hstack([one.positions for one in chosen]),
        reading=np.concatenate(readings),
    )
    known = {name: machine.errors.parameters.get(name, 0.0) for name in machine.dimensions}
    return observed, estimate(machine, observed, ErrorValues(machine=machine.name, parameters=known))


def test_a_probe_of_unknown_length_leaves_the_height_of_an_axis_open() -> None:
    observed, estimated = found(0.02)
    (said,) = resting_on_length(observed, estimated)
    assert said.location == "EZ0A"
    assert not said.far
    row = estimated.layout.locations.index("EZ0A") + int(estimated.layout.offsets[-1])
    u = float(np.linalg.norm(estimated.spread[row]))
    assert abs(said.value) < 2.0 * u
    assert 0.01 < u < 0.02
    assert resting_on_length(*found(0.02, length_u=0.02)) == ()  # who states it has thought of it


def test_a_length_that_is_a_millimetre_wrong_is_told_as_such() -> None:
    """It became an offset of the axis by 1 mm, `determined by readings`, and spoilt parts tenfold."""
    (said,) = resting_on_length(*found(1.0))
    assert said.far
    assert said.longer == pytest.approx(1.0, abs=0.01)
    assert len(said.runs) == 21
