"""What is lacking is said, with its cost; nothing is said of data that lack nothing."""

from dataclasses import replace

import numpy as np

from tests.diagnosis.prepared import SMALL, field_of, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.further_runs.absences import absences
from trueaxis.diagnosis.further_runs.at_hand import both_ways, rounds_at_hand
from trueaxis.diagnosis.further_runs.audit import audit
from trueaxis.reporting.diagnosis.further import absence_sentence


def said(design: Design, *, one_way: bool = False) -> tuple[str, ...]:
    case = prepared(Case(seed=1, design=design, noise="none", given="exact"))
    rows = case.rows
    if one_way:
        rows = rows.only((rows.directions >= 0.0).all(axis=0) & np.isnan(rows.feed if rows.feed is not None else 0.0))
    one = field_of(case.model, rows)
    ground = one.ground(np.zeros(rows.size))
    return tuple(map(absence_sentence, absences(one.readings, audit(ground))))


def test_nothing_of_columns_directions_or_feeds_lacks_in_a_whole_campaign() -> None:
    for text in said(SMALL):
        assert text.startswith("in these runs: "), text


def test_columns() -> None:
    found = said(replace(SMALL, temperature=""))
    assert "without temperature_c: thermal_expansion and thermal_offset cannot be seen" in found
    without_time = next(text for text in said(replace(SMALL, times=False)) if text.startswith("without time_s"))
    assert "warm_up, drift and laser_step" in without_time
    assert "thermal" not in without_time


def test_instruments() -> None:
    lasers = next(text for text in said(replace(SMALL, ball_bar=False)) if text.startswith("without a ball bar"))
    assert "servo_lag" in lasers
    assert "backlash" not in lasers
    bars = next(text for text in said(replace(SMALL, laser=False)) if text.startswith("without a laser"))
    assert "ballbar_length" in bars
    assert "servo_lag" not in bars


def test_one_direction_and_one_feed() -> None:
    assert sum("from one side only" in text for text in said(SMALL, one_way=True)) == 3
    assert sum("at one feed only" in text for text in said(replace(SMALL, feeds=(1000.0,)))) == 3


def test_a_bar_that_goes_there_and_back_shows_both_directions() -> None:
    case = prepared(Case(seed=1, design=SMALL, noise="none", given="exact"))
    every = rounds_at_hand(case.model, case.rows)
    rows = case.rows.only(np.isin(case.rows.run, [index for index, run in enumerate(case.rows.runs) if run.length]))
    clockwise = [one.run.id for one in every if one.sense < 0]
    alone = rows.only(np.array([rows.runs[index].id in clockwise for index in rows.run.tolist()]))
    assert not both_ways(rounds_at_hand(case.model, alone))
    (first, *_) = alone.present
    forth = alone.only(alone.run == first)
    back = np.arange(forth.size)[::-1]
    there_and_back = replace(
        forth,
        run=np.concatenate([forth.run, forth.run]),
        positions=np.concatenate([forth.positions, forth.positions[:, back]], axis=1),
        directions=np.concatenate([forth.directions, forth.directions[:, back]], axis=1),
        passing=np.concatenate([forth.passing, forth.passing]),
        feed=None,
    )
    (one,) = rounds_at_hand(case.model, there_and_back)
    assert one.returns
