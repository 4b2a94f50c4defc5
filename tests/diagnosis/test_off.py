"""What an instrument that is off may be besides: what makes the same of the readings is not told from it."""

import numpy as np
import pytest

from tests.diagnosis.prepared import prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.judging.off import Instead, Off, with_instead
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.effects.kind import Effect


@pytest.fixture(scope="module")
def rows() -> Rows:
    return prepared(Case(seed=1, design=Design(lines=2, repeats=1), noise="none", given="exact")).rows


def instead(rows: Rows, kind: str, runs: tuple[str, ...], value: float) -> tuple[Instead, ...]:
    (found,) = with_instead(
        rows,
        [
            Off(
                effect=Effect(kind=kind, runs=runs),
                values=np.array([value]),
                u=np.array([1e-6]),
                p_value=1e-9,
                signal=np.zeros(rows.size),
            )
        ],
    )
    return found.instead


def ids(rows: Rows, instrument: str) -> tuple[str, ...]:
    return tuple(rows.runs[index].id for index in rows.present if rows.runs[index].instrument == instrument)


def test_one_line_that_reads_short_may_have_a_beam_askew(rows: Rows) -> None:
    """It was named as the scale of the laser alone; its beam was 5 mrad out of line."""
    line = ids(rows, "laser")[:1]
    (found,) = instead(rows, "laser_scale", line, -12.5e-6)
    assert found.effect == Effect(kind="laser_cosine", runs=line)
    assert found.values == pytest.approx([5e-3])
    assert found.u == pytest.approx([1e-6 / 5e-3])  # of angle^2/2
    assert instead(rows, "laser_scale", line, 12.5e-6) == ()  # a beam askew never reads long


def test_lines_of_several_set_ups_that_read_short_have_no_beam_askew(rows: Rows) -> None:
    assert instead(rows, "laser_scale", ids(rows, "laser"), -12.5e-6) == ()
    assert instead(rows, "laser_scale", (), -12.5e-6) == ()


def test_a_zero_of_all_runs_by_the_bar_may_be_its_length(rows: Rows) -> None:
    bars = ids(rows, "ballbar")
    (found,) = instead(rows, "reading_zero", bars, 0.01)
    assert (found.effect, found.values.tolist()) == (Effect(kind="ballbar_length"), [0.01])
    assert instead(rows, "reading_zero", bars[:-1], 0.01) == ()
