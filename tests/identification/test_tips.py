"""A sphere cycle whose rotary axis is counted from elsewhere than the spec has it."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.planning.data import model
from trueaxis.estimation.observations import Observations
from trueaxis.identification.tips import tip_notes, wrong_tip
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import Run
from trueaxis.model.model import MachineModel
from trueaxis.planning.candidates import candidates
from trueaxis.planning.kit import Kit

FOLDER = Path("data")


def sphere(machine: MachineModel) -> tuple[Run, FloatArray]:
    """A cycle while C turns."""
    every = candidates(machine, Kit(instruments=("probe",), everywhere=False))
    return next((one.run, one.positions) for one in every if "C turning at B0 about" in one.what)


@pytest.mark.parametrize("angle", [90.0, -90.0, 37.25])
def test_a_rotary_axis_counted_from_elsewhere_is_refused_with_the_angle(angle: float) -> None:
    """90 degrees off, the values followed a tip that was not there: predictions were worse than none."""
    machine = model("dmu60p_5axis")
    run, right = sphere(machine)
    assert wrong_tip(machine, run, right, FOLDER) is None
    off = right.copy()
    off[machine.axes.index("C")] += angle
    elsewhere = replace(run, home={**run.home, "C": run.home["C"] + angle})
    found = wrong_tip(machine, elsewhere, off, FOLDER)
    assert found is not None
    assert f"if C were {abs(angle):g} deg {'less' if angle > 0.0 else 'more'} than written" in found.fault.problem
    (slip,) = found.slips
    assert "C" in slip.remedy


@pytest.mark.parametrize("seed", range(8))
def test_an_axis_that_stands_elsewhere_is_no_other_angle(seed: int) -> None:
    """A dimension that is 6 to 60 mm off, along no circle about the axis, is not explained away by an angle."""
    machine = model("dmu60p_5axis")
    run, positions = sphere(machine)
    draw = np.random.default_rng(seed)
    far, way = draw.uniform(6.0, 60.0), draw.uniform(0.0, 2.0 * np.pi)
    values = {"q_wx": far * float(np.cos(way)), "q_wy": far * float(np.sin(way))}
    off = machine.with_values(replace(machine.errors, parameters={**machine.errors.parameters, **values}))
    observed = Observations(
        source="plan",
        runs=(run,),
        run=np.zeros(positions.shape[1], dtype=np.int64),
        positions=positions,
        reading=np.zeros(positions.shape[1]),
    )
    assert tip_notes(off, observed)
    assert wrong_tip(off, run, positions, FOLDER) is None
