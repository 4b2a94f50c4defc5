"""Draws of a machine with play: from which side an axis came, which linear propagation does not know."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import trueaxis as ta
from tests.machines import ROOT

WIDTH, U = 8e-3, 1e-3  # mm, of the play of Y
AT = np.array([[100.0, 100.0], [50.0, 200.0], [-100.0, -100.0]])


@pytest.fixture(scope="module")
def machine(tmp_path_factory: pytest.TempPathFactory) -> tuple[ta.MachineModel, ta.Errors]:
    folder = tmp_path_factory.mktemp("worn")
    spec = ROOT / "examples" / "worn_mill.toml"
    ta.derive(spec, folder)
    model = ta.load_model(spec, folder)
    play = {"kind": "backlash", "component": "EYY", "parameters": {"width": WIDTH}, "u": {"width": U}}
    path: Path = folder / "errors.json"
    path.write_text(json.dumps({"schema": 1, "machine": model.name, "effects": [play]}))
    return model, ta.load_errors(path, model)


def from_side(model: ta.MachineModel, direction: float) -> ta.Context:
    still = ta.Context.at_rest(len(model.axes), 2)
    directions = np.zeros((len(model.axes), 2))
    directions[model.axes.index("Y")] = direction
    return replace(still, directions=directions)


def test_where_the_side_is_known_the_play_is_as_uncertain_as_its_value(
    machine: tuple[ta.MachineModel, ta.Errors],
) -> None:
    model, errors = machine
    there = ta.predict(model, errors, AT, context=from_side(model, 1.0), draws=20_000)
    assert there.drawn is not None
    moved = np.abs(there.deviation[1])
    np.testing.assert_allclose(moved, moved[0])
    np.testing.assert_allclose(there.drawn.sd[1], there.u[1], rtol=0.03)
    np.testing.assert_allclose(there.drawn.sd[1] / moved, U / WIDTH, rtol=0.03)
    assert not there.drawn.differing.any()


def test_where_it_is_not_both_sides_are_drawn_and_the_difference_is_told(
    machine: tuple[ta.MachineModel, ta.Errors],
) -> None:
    model, errors = machine
    sides = [ta.predict(model, errors, AT, context=from_side(model, side)) for side in (-1.0, 1.0)]
    low, high = sorted(float(one.deviation[1, 0]) for one in sides)
    assert high - low == pytest.approx(WIDTH)
    plain = ta.predict(model, errors, AT, draws=2000).drawn
    assert plain is not None
    assert not plain.sd.any()  # an axis that has not moved yet is neither here nor there
    there = ta.predict(model, errors, AT, draws=ta.Draws(count=40_000, either_direction=True))
    drawn = there.drawn
    assert drawn is not None
    half, own_u = 0.5 * (high - low), 0.5 * U
    np.testing.assert_allclose(drawn.mean[1], 0.5 * (high + low), atol=0.02 * half)
    np.testing.assert_allclose(drawn.sd[1], np.hypot(half, own_u), rtol=0.02)
    np.testing.assert_allclose(drawn.high[1], high + 1.645 * own_u, rtol=0.02)  # 5 % of the draws from one side
    np.testing.assert_allclose(drawn.low[1], low - 1.645 * own_u, rtol=0.02)
    np.testing.assert_allclose(drawn.mean[3], half, rtol=0.02)  # a length is there whatever the side
    assert drawn.differing[1].all()
    assert not drawn.differing[[0, 2]].any()
    assert "at 2 of 2 points its 95 % interval is another than that of u, by up to" in str(there)
