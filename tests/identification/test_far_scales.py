"""Lines that no beam out of line can make so long or short are told as a scale, or as heat."""

from dataclasses import replace

import numpy as np
import pytest

from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.identification.data import dmu60p_model, joined, mixed_data
from trueaxis.estimation.estimate import estimate
from trueaxis.identification.far_scales import FarScale, as_beam, as_scale, far_scales
from trueaxis.measurement.reading_effects import along
from trueaxis.model.errors import ErrorValues

pytestmark = pytest.mark.usefixtures("values_alone")


def found(ppm: float) -> tuple[FarScale, ...]:
    """The paper's runs and two circles with noise of 0.3 um, measured twice, the lines too long the second time."""
    model = dmu60p_model()
    cold, warm = (mixed_data(cubic_errors(), 12, seed=seed) for seed in (3, 4))
    reading, runs = warm.reading.copy(), []
    for index, one in enumerate(warm.runs):
        rows = np.flatnonzero(warm.run == index)
        if one.instrument == "laser":
            reading[rows] += 1e-6 * ppm * along(model, one, warm.positions[:, rows])
        runs.append(replace(one, id=f"{one.id}-warm", session="warm"))
    observed = joined(cold, replace(warm, reading=reading, runs=tuple(runs)))
    known = {name: PARAMETERS[name] for name in model.dimensions if name in PARAMETERS}
    estimated = estimate(model, observed, ErrorValues(machine=model.name, parameters=known))
    return far_scales(observed, estimated)


def test_sound_lines_are_not() -> None:
    assert found(0.0) == ()


def test_lines_of_a_warmer_session_are_told_together() -> None:
    far = [one for one in found(40.0) if one.of_scale]
    assert {one.session for one in far} >= {"warm"}
    said = as_scale(far)
    assert "in session warm read" in said
    assert "too long" in said
    words = said.split()
    kelvin = float(words[words.index("K") - 1])
    assert kelvin == pytest.approx(40.0 / 11.5, rel=0.25)


def test_one_short_line_is_a_beam() -> None:
    one = FarScale(runs=("X1",), session="", low=-8e-6, high=-8e-6)
    assert not one.of_scale
    assert as_beam(one).startswith("the line X1 reads 8 ppm too short beside the other readings: its beam was 4 mrad")
    assert "as no beam out of line does" in as_beam(FarScale(runs=("X1",), session="", low=8e-6, high=8e-6))
