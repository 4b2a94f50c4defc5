"""LinuxCNC's simulator loads the tables of linuxcnc-comp: its motors stand where the errors are made up for."""

import numpy as np
import pytest

from tests.controllers.linuxcnc_simulator.machine import Session, run, unavailable
from tests.controllers.machines import GANTRY, FloatArray, model_of
from tests.machines import machine_of
from trueaxis.controllers.formats import Layout, export_tables
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues

ORIGIN = np.zeros((3, 1))
STOOD = 100  # cycles of 1 ms
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(bool(unavailable()), reason=unavailable() or "it can be run"),
]


def stands(session: Session) -> FloatArray:
    """(n, 3): where the motors stood still, mm."""
    found, still = [], 0
    for before, now in zip(session.joints, session.joints[1:], strict=False):
        still = still + 1 if (before == now).all() else 0
        if still == STOOD:
            found.append(now)
    return np.array(found)


@pytest.mark.parametrize("file_type", [0, 1])
def test_the_motors_go_short_by_what_the_axis_goes_too_far(file_type: int) -> None:
    """X goes 0.1 um/mm too far and has lost motion of 20 um; Y goes too far by the square of its position."""
    text = GANTRY + '[[effect]]\nkind = "backlash"\ncomponent = "EXX"\n'
    (effect,) = machine_of(text).effects
    curves = {
        "EXX": PolynomialCurve(powers=(1,), coefficients=(1e-4,)),
        "EYY": PolynomialCurve(powers=(2,), coefficients=(1e-6,)),
    }
    lost = (EffectValues(effect, {"width": 0.02}),)
    model = model_of(text, ErrorValues(machine="gantry", motion_errors=curves, effects=lost))
    files = export_tables("linuxcnc-comp", model, ORIGIN, None, ORIGIN, Layout(file_type=file_type)).files
    moves = ["X50 Y50 Z-50", "X100 Y100 Z-100", "X500 Y200", "X100 Y100", "X600"]
    commands = ["G21 G90 G94 G64 P0.01", *(f"G53 G0 {words}" for words in moves)]
    session = run("gantry", model.travel, "", "", commands, files)
    assert session.errors == []
    right = [[0.0, 0.0, 0.0], [49.985, 49.9975, -50.0], [99.98, 99.99, -100.0], [499.94, 199.96, -100.0],
             [100.0, 99.99, -100.0], [599.93, 99.99, -100.0]]  # fmt: skip
    np.testing.assert_allclose(stands(session), right, atol=1e-6)
