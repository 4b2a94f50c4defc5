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


def test_a_line_that_is_wrong_on_one_of_two_days_is_named_for_that_day() -> None:
    """60 um/m, an angle of 11 mrad: of the line on the second day alone, as a candidate of its own."""
    plan = Design(lines=2, repeats=4, targets=11, ball_bar=False)
    given = prepared(Case(4, design=plan, given="exact", noise="white"))
    said = diagnose(given.model, aligned_anew(given.data, ("X2-3", "X2-4"), 6e-5))
    assert [(one.effect.kind, one.effect.runs) for one in said.causes] == [("laser_cosine", ("X2-3", "X2-4"))]


def ball_elsewhere(data: MeasuredData, runs: tuple[str, ...], shift: float) -> MeasuredData:
    """These circles are taken a day later than all others and in a warmer shop, with the ball a little along X."""
    readings = data.readings
    assert readings.time is not None
    assert readings.temperature is not None
    there = np.isin(readings.run, [readings.run_ids.index(name) for name in runs])
    x = readings.positions[readings.axes.index("X")]
    bar = np.zeros(x.size)
    for index in np.unique(readings.run[there]).tolist():
        mine = readings.run == index
        bar[mine] = (x[mine] - 0.5 * (x[mine].max() + x[mine].min())) / (0.5 * np.ptp(x[mine]))
    return replace(
        data,
        readings=replace(
            readings,
            reading=readings.reading + shift * bar,
            time=readings.time + DAY * there,
            temperature=readings.temperature + 0.5 * there,
        ),
    )


def test_a_ball_that_was_set_up_anew_a_day_later_is_no_shift_of_the_machine() -> None:
    given = prepared(Case(4, design=Design(repeats=2, lines=1, targets=9, samples=60), given="exact", noise="white"))
    later = ("XY-F4000-ccw", "XY-F4000-cw", "ZX-F4000-ccw", "ZX-F4000-cw")
    said = diagnose(given.model, ball_elsewhere(given.data, later, 0.02))
    assert (said.verdict, said.causes, said.misfits) == ("no_discrepancy", (), ())
