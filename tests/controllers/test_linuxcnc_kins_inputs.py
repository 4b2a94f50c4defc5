"""The kinematics module, compiled with a stub of LinuxCNC: inputs that step, are not finite or make no sense."""

import itertools
import math
from pathlib import Path

import pytest

from tests.controllers.kins_machines import (
    EXACT,
    OFFSET,
    ExactMachine,
    built,
    joints_of,
    length,
    machine_model,
    poses,
    with_random_errors,
)
from tests.controllers.kins_module import IN, KinsModule, compiler
from trueaxis.controllers.linuxcnc_kins import BEYOND
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel

pytestmark = pytest.mark.skipif(compiler() is None, reason="there is no C compiler")

NAN, INFINITE = math.nan, math.inf


@pytest.fixture(scope="module")
def mill(tmp_path_factory: pytest.TempPathFactory) -> tuple[MachineModel, Path]:
    model = with_random_errors(machine_model("dmu60p"), 3)
    return model, built(tmp_path_factory.mktemp("mill"), model)


def test_off_it_is_the_ideal_machine(mill: tuple[MachineModel, Path]) -> None:
    model, library = mill
    module = KinsModule(library)
    module.update(10)
    for pose in poses(model, 5, 1):
        assert joints_of(module, pose, model.axes) == pose
        code, back = module.forward(list(pose.values()))
        assert code == 0
        assert {axis: back[axis] for axis in model.axes} == pose
    assert module["share"] == 0.0
    assert module["settled"]
    assert module.type() == 4  # KINEMATICS_BOTH: joints are no axes


def test_pins_are_inputs_and_outputs(mill: tuple[MachineModel, Path]) -> None:
    module = KinsModule(mill[1])
    inputs = {"enable", "reset", "ramp-time", "tool-x", "tool-y", "tool-z"}
    outputs = {"share", "settled", "fault", "converged", "steps", "correction-x", "correction-y", "correction-z"}
    assert {pin for pin in inputs | outputs if module.direction(pin) == IN} == inputs


def test_switching_on_and_off_never_jumps(tmp_path: Path) -> None:
    """Nowhere more than the steepest part of the ramp, and forward undoes inverse at every share."""
    model = with_random_errors(machine_model("dmu60p"), 4)
    module = KinsModule(built(tmp_path, model))
    pose = {"X": 400.0, "Y": 600.0, "Z": 500.0}
    module["ramp-time"] = 0.25
    module.update()
    cycles = itertools.chain([True] * 100, [False] * 30, [True] * 400, [False] * 400)
    before = joints_of(module, pose, model.axes)
    largest, steps = 0.0, []
    for on in cycles:
        module["enable"] = on
        module.update()
        joints = joints_of(module, pose, model.axes)
        steps.append(max(abs(joints[axis] - before[axis]) for axis in model.axes))
        largest = max(largest, *(abs(joints[axis] - pose[axis]) for axis in model.axes))
        before = joints
        _, back = module.forward(list(joints.values()))
        assert max(abs(back[axis] - pose[axis]) for axis in model.axes) < EXACT
    assert largest > 5e-3
    assert max(steps) <= 1.51 * largest * 1e-3 / 0.25
    assert max(abs(one - other) for one, other in itertools.pairwise(steps)) < 0.1 * max(steps)  # nor a step of speed
    assert before == pose
    assert module["settled"]


def test_a_new_tool_ramps(mill: tuple[MachineModel, Path]) -> None:
    model, library = mill
    module = KinsModule(library)
    module.switch_on()
    pose = {"X": 400.0, "Y": 600.0, "Z": 500.0}
    exact = ExactMachine(model)
    before = joints_of(module, pose, model.axes)
    without = before
    module["tool-z"], module["ramp-time"] = 200.0, 0.2
    largest = 0.0
    for cycle in range(200):
        module.update()
        assert bool(module["settled"]) == (cycle == 199)
        joints = joints_of(module, pose, model.axes)
        largest = max(largest, *(abs(joints[axis] - before[axis]) for axis in model.axes))
        before = joints
    change = max(abs(before[axis] - without[axis]) for axis in model.axes)
    assert change > 1e-3
    assert largest <= 1.51 * change / 200
    tip = exact.tip((0.0, 0.0, 200.0))
    assert length(exact.actual(before, tip) - exact.ideal(pose, tip)) < EXACT


def test_a_ramp_of_no_time_still_is_one(mill: tuple[MachineModel, Path]) -> None:
    for asked in (0.0, -1.0, NAN, INFINITE):
        module = KinsModule(mill[1])
        module["enable"], module["ramp-time"] = True, asked
        module.update()
        assert 0.0 < module["share"] < 1e-3
        module["enable"] = False
        module.update(101)
        assert module["share"] == 0.0


@pytest.mark.parametrize("bad", [NAN, INFINITE, -INFINITE])
def test_what_is_not_finite_never_leaves(mill: tuple[MachineModel, Path], bad: float) -> None:
    model, library = mill
    module = KinsModule(library)
    module.switch_on(OFFSET)
    pose = {"X": 100.0, "Y": 200.0, "Z": 300.0}
    good = joints_of(module, pose, model.axes)
    assert module.inverse(pose | {"Y": bad}, 3) == (-1, list(good.values()))
    assert module["fault"]
    module["reset"] = True
    module.update()
    module["reset"] = False
    assert not module["fault"]
    code, back = module.forward(list(good.values()))
    assert code == 0
    code, held = module.forward([good["X"], bad, good["Z"]])
    assert code == -1
    assert [held[axis] for axis in "XYZ"] == [back[axis] for axis in "XYZ"]
    assert module["fault"]
    module["reset"] = True
    module.update()
    assert not module["fault"]
    module["tool-y"] = bad
    module.update(300)
    assert module["fault"]
    assert joints_of(module, pose, model.axes) == good


def test_a_tool_of_ten_metres_is_none(mill: tuple[MachineModel, Path]) -> None:
    model, library = mill
    module = KinsModule(library)
    module.switch_on(OFFSET)
    pose = {"X": 100.0, "Y": 200.0, "Z": 300.0}
    good = joints_of(module, pose, model.axes)
    module["tool-z"] = 1e4
    module.update(300)
    assert module["fault"]
    assert joints_of(module, pose, model.axes) == good


def test_corrections_beyond_all_reason_are_not_made(tmp_path: Path) -> None:
    """EXX of 10 um at X100 and of more than the module allows at X500."""
    curves = {"EXX": PolynomialCurve(powers=(1, 9), coefficients=(1e-4, 6.0 / 500.0**9))}
    model = machine_model("dmu60p").with_values(ErrorValues(machine="dmu60p", motion_errors=curves))
    module = KinsModule(built(tmp_path, model))
    module.switch_on()
    near = joints_of(module, {"X": 100.0}, model.axes)["X"] - 100.0
    assert near == pytest.approx(-0.01, rel=1e-3)
    code, joints = module.inverse({"X": 500.0}, 3)
    assert code == -1
    assert joints[0] == pytest.approx(500.0 + near, abs=1e-12)  # the last good correction
    assert module["fault"]


def test_beyond_the_travel_curves_hold_their_value(tmp_path: Path) -> None:
    curves = {"EXX": PolynomialCurve(powers=(1,), coefficients=(1e-4,))}
    model = machine_model("dmu60p").with_values(ErrorValues(machine="dmu60p", motion_errors=curves))
    module = KinsModule(built(tmp_path, model))
    module.switch_on()
    end = model.travel["X"][1] + BEYOND
    for x in (end + 1.0, end + 1000.0):
        assert joints_of(module, {"X": x}, model.axes)["X"] == pytest.approx(x - 1e-4 * end, abs=1e-9)


def test_joints_have_the_letters_that_they_are_given(mill: tuple[MachineModel, Path]) -> None:
    model, library = mill
    plain, gantry = KinsModule(library), KinsModule(library, "zyu xy")
    for module in (plain, gantry):
        module.switch_on()
    pose = {"X": 100.0, "Y": 200.0, "Z": 300.0, "U": 7.5}
    joints = joints_of(plain, pose, model.axes)
    code, found = gantry.inverse(pose, 5)
    assert code == 0
    assert found == [joints["Z"], joints["Y"], 7.5, joints["X"], joints["Y"]]
    found[4] += 0.5  # of two joints with one letter the first counts
    _, back = gantry.forward(found)
    assert back == pytest.approx(pose | {"A": 0.0, "B": 0.0, "C": 0.0, "V": 0.0, "W": 0.0}, abs=EXACT)


@pytest.mark.parametrize(("letters", "told"), [("XY", "axis Z of the machine is missing"), ("XYZQ", "letters of XYZA")])
def test_coordinates_that_cannot_be_are_refused(mill: tuple[MachineModel, Path], letters: str, told: str) -> None:
    module = KinsModule(mill[1], letters, loads=False)
    assert f"coordinates={letters}: " in module.message
    assert told in module.message
