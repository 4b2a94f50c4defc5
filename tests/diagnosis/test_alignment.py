"""A line that is measured again later may have been aligned anew, whether or not setup.toml names sessions."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnosis.prepared import prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.procedure import diagnose
from trueaxis.measurement.data import MeasuredData

DAY = 86400.0


def aligned_anew(data: MeasuredData, runs: tuple[str, ...], share: float) -> MeasuredData:
    """These runs are taken a day later than all others, by a laser that reads this much of the way too little."""
    readings = data.readings
    assert readings.time is not None
    there = np.isin(readings.run, [readings.run_ids.index(name) for name in runs])
    axis = readings.axes.index(runs[0][0])
    reading = readings.reading - share * there * readings.positions[axis]
    return replace(data, readings=replace(readings, reading=reading, time=readings.time + DAY * there))


@pytest.mark.parametrize(("line", "sigma_um"), [("X2", 0.1), ("Z1", 0.05)])
def test_another_alignment_a_day_later_is_no_structure(line: str, sigma_um: float) -> None:
    """Nor a false name, nor a wrong run: 2 um/m, many times what the repeats differ by."""
    plan = Design(lines=4, repeats=4, targets=21, ball_bar=False)
    given = prepared(Case(4, design=plan, given="exact", noise="white", sigma_um=sigma_um))
    said = diagnose(given.model, aligned_anew(given.data, (f"{line}-3", f"{line}-4"), 2e-6))
    assert (said.verdict, said.causes, said.misfits) == ("no_discrepancy", (), ())
