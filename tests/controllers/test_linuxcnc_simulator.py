"""LinuxCNC's simulator runs the module that halcompile built: joints against matrices of the tests' own.

`python -m tests.controllers.test_linuxcnc_simulator` prints what it did.
"""

import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.controllers.kins_machines import ExactMachine, kernels_folder, length, machine_model, with_random_errors
from tests.controllers.kins_module import write_module
from tests.controllers.linuxcnc_simulator.machine import JOINT_ACCELERATION, Session, installed, run, unavailable
from trueaxis.machine.machine import LINEAR
from trueaxis.model.model import MachineModel

ALLOWED = 1e-9  # mm or deg
TOOL = (0.25, -0.5, 120.5)
TOOL_TABLE = "T1 P1 X0.25 Y-0.5 Z120.5 D10 ;end mill\n"
MOVES = 40
LETTERS = "XYZABC"
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(bool(unavailable()), reason=unavailable() or "it can be run"),
]


def commands(model: MachineModel, seed: int) -> list[str]:
    """Random moves in machine coordinates, then with G54 and a tool, arcs and G81; the correction off and on."""
    draw = np.random.default_rng(seed)

    def words(axes: Sequence[str], low: float, high: float) -> str:
        return " ".join(f"{axis}{between(model.travel[axis], draw.uniform(low, high)):.4f}" for axis in axes)

    def between(travel: tuple[float, float], share: float) -> float:
        return travel[0] + share * (travel[1] - travel[0])

    z_low, z_high = model.travel["Z"]
    start = {axis: between(model.travel[axis], 0.4) for axis in "XY"} | {"Z": between((z_low, z_high), 0.3)}
    offset = " ".join(f"{axis}{value:.3f}" for axis, value in start.items())
    turned = [f"G0 {words([axis for axis in model.axes if axis in 'ABC'], 0.1, 0.9)}"] if len(model.axes) > 3 else []
    return [
        "G21 G17 G40 G49 G90 G94 G64 P0.01",
        *(f"G53 G0 {words(model.axes, 0.0, 1.0)}" for _ in range(MOVES)),
        f"G10 L2 P1 {offset}",
        "G54",
        *turned,
        "G0 X0 Y0 Z0",
        "T1 M6",
        "G43 H1",
        *(f"G1 X{x:.3f} Y{y:.3f} Z{z:.3f} F6000" for x, y, z in draw.uniform(-20.0, 20.0, (10, 3))),
        "G2 X10 Y10 R40 F3000",
        "G81 X30 Y20 Z-15 R5 F2000",
        "G82 X25 Y15 Z-15 R5 P0.5",
        "X35 Y25",
        "G80",
        "G49",
        "unlinkp trueaxiskins.enable",
        "setp trueaxiskins.enable 0",
        "G0 X0 Y0 Z10",
        "setp trueaxiskins.enable 1",
    ]


def simulated(name: str, folder: Path) -> tuple[MachineModel, Session, str]:
    model = with_random_errors(machine_model(name), 21)
    write_module(folder / "module", model, kernels_folder(name))
    hal = (folder / "module" / "trueaxiskins.hal").read_text()
    with installed(folder / "module") as built:
        session = run(name, model.travel, hal, TOOL_TABLE, commands(model, 5))
    return model, session, built


def differences(model: MachineModel, session: Session) -> list[float]:
    """mm: after each command, how far the tool of the exact machine at the joints is from where it was wanted."""
    exact, found = ExactMachine(model), []
    for record in session.done:
        stands = [(record["position"], record["joints"]), *([record["deepest"]] if record["deepest"] else [])]
        off = [difference(exact, record, *stand) for stand in stands]
        found.append(max(off))
    return found


def difference(
    exact: ExactMachine, record: Mapping[str, Any], position: Sequence[float], joints: Sequence[float]
) -> float:
    axes = exact.machine.axes
    pose = {axis: position[LETTERS.index(axis)] for axis in axes}
    sent = dict(zip(axes, joints, strict=False))
    if record["pins"]["share"] == 0.0:
        return max(abs(sent[axis] - pose[axis]) for axis in axes)
    tip = exact.tip(record["tool"])
    turned = [abs(sent[axis] - pose[axis]) for axis in axes if axis not in LINEAR]
    return max(length(exact.actual(sent, tip) - exact.ideal(pose, tip)), *turned, 0.0)


@pytest.mark.parametrize("name", ["dmu60p", "trunnion_mill"])
def test_joints_are_those_of_the_exact_machine(tmp_path: Path, name: str) -> None:
    model, session, built = simulated(name, tmp_path)
    assert "warning" not in built.lower()
    assert session.errors == []
    assert all(record["on"] and not record["pins"]["fault"] for record in session.done)
    assert [record["command"] for record in session.done] == commands(model, 5)
    shares = [record["pins"]["share"] for record in session.done]
    assert shares.count(0.0) == 2
    assert shares.count(1.0) == len(shares) - 2
    with_tool = [record for record in session.done if any(record["tool"])]
    assert {tuple(record["tool"]) for record in with_tool} == {TOOL}
    assert len(with_tool) > 12
    (drilled,) = [record for record in session.done if record["command"].startswith("G82")]
    programmed = dict(zip(LINEAR, (25.0, 15.0, -15.0), strict=True))
    for row, axis in enumerate(LINEAR):  # the bottom of the hole, where it dwells: G54, the tool, the words
        at = session.offset[row] + TOOL[row] + programmed[axis]
        assert drilled["deepest"][0][row] == pytest.approx(at, abs=ALLOWED)
    assert max(differences(model, session)) < ALLOWED
    assert len(session.joints) > 10_000
    acceleration = np.abs(np.diff(session.joints, 2, axis=0)).max() * 1e6  # of cycles of 1 ms
    assert acceleration < 1.05 * JOINT_ACCELERATION  # nothing jumps: neither a new tool nor the correction, off and on


def main() -> None:
    for name in ("dmu60p", "trunnion_mill"):
        with tempfile.TemporaryDirectory() as folder:
            model, session, built = simulated(name, Path(folder))
        print(f"{name}\n{built}{session.log}")
        for record, off in zip(session.done, differences(model, session), strict=True):
            joints = " ".join(f"{value:.9f}" for value in record["joints"])
            print(f"{record['command']:<60} joints {joints}  steps {record['pins']['steps']}  off {off:.1e} mm")


if __name__ == "__main__":
    main()
