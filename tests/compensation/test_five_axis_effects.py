"""Play of a rotary axis, judged by the chain in forty digits at the side to which the axis last turned."""

from dataclasses import replace

import numpy as np
import pytest

from tests.compensation.control import Bench, execute
from tests.compensation.five_axes import TEXTS, FiveAxes
from tests.exact_chain import DIGITS
from trueaxis.effects.kind import Effect
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.model import MachineModel

WIDTH = -4e-4  # rad
PROGRAM = "G0 X10. Y20. Z30. A10. C0.\nG1 X12. Y80. C40. F500\nX15. C10.\nA20.\n"


def with_play(machine: FiveAxes) -> MachineModel:
    effect = Effect(kind="backlash", component="ECC")
    model = machine.model
    values = EffectValues(effect, {"width": WIDTH})
    return replace(
        model, machine=replace(model.machine, effects=(effect,)), errors=replace(model.errors, effects=(values,))
    )


@pytest.mark.parametrize("orientation", ["keep", "correct"])
def test_play_of_the_table_is_made_up_for(bench: Bench, orientation: str) -> None:
    machine = FiveAxes(TEXTS["table-table"], size=0.0)
    model = with_play(machine)
    axes = model.axes
    out = bench.run(PROGRAM, model, orientation=orientation, start=dict.fromkeys(axes, 0.0), chord_tolerance=0.001)
    assert bench.report.good
    assert bench.report.take_ups == 2
    at = execute(out, axes)
    wanted = execute(bench.run(PROGRAM, machine.model, start=dict.fromkeys(axes, 0.0)), axes)
    turning = np.sign(np.diff(at[axes.index("C")], prepend=0.0))
    off, ignored = [], []
    for programmed in wanted.T:
        side = np.flatnonzero(np.abs(at - programmed[:, None]).max(axis=0) < 0.1)[0]  # before what is taken up there
        last = turning[: side + 1][turning[: side + 1] != 0.0]
        values = machine.parameters | {"ECC": WIDTH / 2 * (last[-1] if last.size else 0.0)}
        pose = dict(zip(axes, map(DIGITS.mpf, at[:, side].tolist()), strict=True))
        origin = [0, 0, 0]
        actual = machine.chain.place("tool_in_workpiece", pose, values, origin)
        there = dict(zip(axes, map(DIGITS.mpf, programmed.tolist()), strict=True))
        ideal = machine.chain.place("tool_in_workpiece", there, machine.parameters, origin)
        off.append(float(DIGITS.norm(actual - ideal)))
        without = machine.chain.place("tool_in_workpiece", there, values, origin)
        ignored.append(float(DIGITS.norm(without - ideal)))
    assert max(off) < 0.001
    assert max(ignored) > 0.003
