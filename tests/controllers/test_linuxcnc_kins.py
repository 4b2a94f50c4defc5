"""The kinematics module, compiled with a stub of LinuxCNC: joints against matrices of the tests' own."""

import math
import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.controllers.kins_machines import (
    EXACT,
    OFFSET,
    ExactMachine,
    built,
    joints_of,
    kernels_folder,
    length,
    machine_model,
    poses,
    with_random_errors,
)
from tests.controllers.kins_module import KinsModule, compiled, compiler
from tests.controllers.machines import FIVE, random_model
from tests.controllers.machines import model_of as kernels_model
from tests.kernels import emitted
from tests.machines import ROOT, serial_text
from trueaxis.compensation.solve import solve
from trueaxis.compensation.tools import Tool, tool_point_of
from trueaxis.controllers.formats import KINS, export_module
from trueaxis.controllers.linuxcnc_kins import BEYOND
from trueaxis.effects.kind import Effect
from trueaxis.jobs.export import ExportOptions, exported
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues
from trueaxis.model.manifest import CONTROL_FILES
from trueaxis.model.own_uncertainty import own_uncertainty
from trueaxis.reporting.export import export_sentences

pytestmark = pytest.mark.skipif(compiler() is None, reason="there is no C compiler")

MACHINES = ("dmu60p", "gantry_mill", "cframe_mill", "dmu60p_5axis", "trunnion_mill", "headhead_mill")


@pytest.mark.parametrize("name", MACHINES)
def test_the_tool_of_the_real_machine_is_where_that_of_the_ideal_one_would_be(tmp_path: Path, name: str) -> None:
    model = with_random_errors(machine_model(name), 11)
    exact, module = ExactMachine(model), KinsModule(built(tmp_path, model))
    module.switch_on(OFFSET)
    tip = exact.tip(OFFSET)
    moved = 0.0
    for pose in poses(model, 8, 5):
        joints = joints_of(module, pose, model.axes)
        wanted = exact.ideal(pose, tip)
        assert length(exact.actual(joints, tip) - wanted) < EXACT
        moved = max(moved, length(exact.actual(pose, tip) - wanted))
        code, back = module.forward(list(joints.values()))
        assert code == 0
        assert length(exact.ideal(back, tip) - exact.actual(joints, tip)) < EXACT
        assert all(joints[axis] == pose[axis] for axis in model.axes if axis in "ABC")
        assert module["converged"]
        assert 1 <= module["steps"] <= 6
    assert moved > 5e-3
    assert not module["fault"]


def test_joints_are_the_words_that_compensate_writes(tmp_path: Path) -> None:
    model = random_model(FIVE, 2)
    module = KinsModule(built(tmp_path, model, kernels=emitted(FIVE) / "five"))
    module.switch_on(OFFSET)
    point = tool_point_of(model, Tool(length=OFFSET[2], offset=(*OFFSET[:2], 0.0)), np.zeros((3, 1)))
    wanted = poses(model, 20, 8)
    programmed = np.array([[pose[axis] for pose in wanted] for axis in model.axes])
    solved = solve(programmed, programmed, model, point, 1e-9)
    assert solved.converged.all()
    for column, pose in enumerate(wanted):
        joints = joints_of(module, pose, model.axes)
        np.testing.assert_allclose(list(joints.values()), solved.commands[:, column], rtol=0, atol=1e-10)


def test_a_call_takes_little_stack(tmp_path: Path) -> None:
    """All functions of the module together, as if each called the next: below 8 kB."""
    for name in ("dmu60p", "trunnion_mill", "headhead_mill"):
        folder = tmp_path / name
        folder.mkdir()
        library = built(folder, with_random_errors(machine_model(name), 1), "-fstack-usage")
        sizes = [
            line.split("\t")
            for file in library.parent.glob("*trueaxiskins.su")
            for line in file.read_text().splitlines()
        ]
        assert len(sizes) > 10
        assert {kind for _, _, kind in sizes} == {"static"}
        assert sum(int(size) for _, size, _ in sizes) < 8192


def test_the_control_kernels_of_a_machine_have_no_state() -> None:

    for name in MACHINES:
        source = (kernels_folder(name) / "control.c").read_text()
        assert not re.search(r"\b(malloc|static double \w+;|printf)\b", source)
        assert max(map(len, source.splitlines())) <= 120


PAGE = ROOT / "docs" / "controllers" / "linuxcnc-kins.md"


def test_the_number_beside_the_sign_of_its_page(tmp_path: Path) -> None:
    (word, joint) = re.search(r"\n```\nX([\d.]+) ([\d.]+)\n```", PAGE.read_text()).groups()  # type: ignore[union-attr]
    curves = {"EXX": PolynomialCurve(powers=(1,), coefficients=(1e-4,))}
    model = machine_model("gantry_mill").with_values(ErrorValues(machine="gantry_mill", motion_errors=curves))
    module = KinsModule(built(tmp_path, model))
    module.switch_on()
    joints = joints_of(module, {"X": float(word)}, model.axes)
    assert f"{joints['X']:.6f}" == joint
    assert module["correction-x"] == joints["X"] - float(word)


def test_the_number_of_the_readme_is_what_the_module_does(tmp_path: Path) -> None:
    model = with_random_errors(machine_model("trunnion_mill"), 6)
    point = np.array([[1.0], [2.0], [-30.0]])
    options = ExportOptions(accept_u=True, max_correction=BEYOND)
    covariance = own_uncertainty(model.machine, model.errors)
    export = exported(model, covariance, KINS, tmp_path / "kins", point, options, {})
    module = KinsModule(compiled(tmp_path / "kins"))
    module.switch_on()
    rows = re.findall(r"^\| ([XYZAC]) \| (\S+) \| (\S+) \|$", export.texts["README.md"], re.MULTILINE)
    assert [axis for axis, _, _ in rows] == list(model.axes)
    joints = joints_of(module, {axis: float(at) for axis, at, _ in rows}, model.axes)
    assert [f"{joints[axis]:.6f}" for axis in model.axes] == [joint for _, _, joint in rows]
    assert "from the point 1, 2, -30 of the tool frame" in export.texts["README.md"]
    assert export.remaining.after < EXACT
    assert export.remaining.before > 1e-3


SAG = """
[[effect_kind]]
name = "one_sided"
expression = "width*step(direction)"
components = ["EZZ"]
sentence = "it hangs in one direction"
parameters.width = { unit = "u", meaning = "by how much" }
"""
EFFECTS = {  # kind, component, other axis -> values, and what is in the module at X Y Z: travel -300 to 400
    ("cyclic", "EXX", None): {"amplitude": 3e-3, "phase": 0.7, "pitch": 10.0},
    ("backlash", "EYY", None): {"width": 6e-3},
    ("cross_axis", "EXY", "Z"): {"k": 8e-3},
    ("one_sided", "EZZ", None): {"width": 5e-3},
    ("warm_up", "EYY", None): {"amplitude": 9e-3, "tau": 600.0},
}


def known_of_effects(pose: Mapping[str, float]) -> dict[str, float]:
    """What positions tell of them: by hand, from docs/effects.md; the mean of both directions of approach."""
    share = {axis: (pose[axis] + 300.0) / 700.0 for axis in "YZ"}
    return {
        "EXX": 3e-3 * math.cos(2.0 * math.pi * pose["X"] / 10.0 + 0.7),
        "EXY": 8e-3 * share["Y"] * share["Z"] ** 2,
        "EZZ": 0.5 * 5e-3,
    }


def test_effects_of_positions_are_in_it_and_of_directions_their_mean(tmp_path: Path) -> None:
    named = [{"kind": kind, "component": component, "axis": axis} for kind, component, axis in EFFECTS]
    tables = ["".join(f'{key} = "{value}"\n' for key, value in one.items() if value) for one in named]
    text = serial_text("Y", "XZ") + SAG + "".join(f"\n[[effect]]\n{table}" for table in tables)
    folder = emitted(text) / "test"
    values = tuple(
        EffectValues(Effect(kind=kind, component=component, axis=axis), numbers)
        for (kind, component, axis), numbers in EFFECTS.items()
    )
    model = with_random_errors(kernels_model(text, ErrorValues(machine="test")), 9)
    model = model.with_values(replace(model.errors, effects=values))
    module = KinsModule(built(tmp_path, model, kernels=folder))
    module.switch_on(OFFSET)
    exact = ExactMachine(model)
    tip = exact.tip(OFFSET)
    for pose in poses(model, 6, 2):
        joints = joints_of(module, pose, model.axes)
        off = exact.actual(joints, tip, known_of_effects(joints)) - exact.ideal(pose, tip)
        assert length(off) < EXACT
    positions = np.array([[pose[axis] for pose in poses(model, 6, 2)] for axis in model.axes])
    made = export_module(model, np.zeros((3, 1)), positions, dict.fromkeys(CONTROL_FILES, b""))
    assert 1e-3 < made.remaining.after < made.remaining.before  # lost motion, warm-up
    said = export_sentences(KINS, model, made)
    assert "in the module as the mean of both directions of approach: backlash EYY, one_sided EZZ" in said
    assert any(one.startswith("not in the module, for") and one.endswith(": warm_up EYY") for one in said)
