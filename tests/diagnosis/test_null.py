"""Outliers that are put in are left out, and nothing else; how runs settle is found."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, FloatArray, Prepared, dense_covariance, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.causes.signature import readings_of
from trueaxis.diagnosis.causes.signatures import parameter_signature
from trueaxis.diagnosis.null_model.null import Null, expected_root, fitted, less_own
from trueaxis.diagnosis.null_model.outliers import explained, null_of, spoilt_beside, undecided
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.null_model.whiten import SETTLED
from trueaxis.diagnosis.result import IntArray
from trueaxis.effects.kind import Effect


@cache
def given() -> tuple[Prepared, Rows]:
    found = prepared(
        Case(seed=1, design=Design(lines=2, repeats=3, targets=15, samples=36), noise="none", given="exact")
    )
    return found, found.rows


def noise(seed: int) -> FloatArray:
    return SIGMA * np.random.default_rng(seed).standard_normal(given()[1].size)


def null(values: FloatArray) -> Null:
    case, rows = given()
    return null_of(case.model, rows, values, None)


def places() -> list[int]:
    rows = given()[1]
    return [rows.of_run(0).start + 3, rows.of_run(4).start + 12, rows.of_run(11).stop - 2]


@pytest.mark.parametrize("size", [12.0, -12.0, 1000.0])
def test_a_reading_far_from_its_repeats_is_found_and_left_out(size: float) -> None:
    rows, values = given()[1], noise(1)
    values[places()] += size * SIGMA
    found = null(values)
    assert {(one.run, one.seq) for one in found.outliers} == {
        (rows.runs[rows.run[place]].id, int(rows.seq[place])) for place in places()
    }
    assert found.rows.size == found.values.size == rows.size - 3
    for one in found.outliers:
        assert one.deviation == pytest.approx(size * SIGMA, rel=0.5)
        assert np.sign(one.z) == np.sign(size)


def test_two_neighbours_are_found_in_short_runs_too() -> None:
    rows, values = given()[1], noise(4)
    start = rows.of_run(2).start + 7
    values[[start, start + 1]] += 15.0 * SIGMA
    found = null(values)
    assert {(one.run, one.seq) for one in found.outliers} == {
        (rows.runs[rows.run[place]].id, int(rows.seq[place])) for place in (start, start + 1)
    }


def test_in_clean_data_hardly_anything_is_left_out() -> None:
    """A data set in twenty loses one reading by the limit alone."""
    assert sum(len(null(noise(seed)).outliers) for seed in range(3)) <= 1


def test_what_the_final_noise_explains_is_no_outlier() -> None:
    """A reading left out while the noise was taken for smaller comes back; what is told of others is by that noise."""
    rows, values = given()[1], noise(8)
    spoilt, sound = places()[0], places()[1]
    values[spoilt] += 20.0 * SIGMA
    whole = null(values)
    full = null_of(given()[0].model, rows, values, 1e3 * SIGMA)
    assert [one.seq for one in whole.outliers] == [one.seq for one in full.outliers] == [int(rows.seq[spoilt])]
    good = np.ones(rows.size, dtype=bool)
    good[[spoilt, sound]] = False
    everything = null_of(given()[0].model, rows, noise(8), 1e3 * SIGMA)
    back, told = explained(replace(everything, values=values), everything.only(good), good)
    assert np.flatnonzero(back).tolist() == [sound]
    assert told[spoilt].z == pytest.approx(20.0, abs=4.0)
    assert abs(told[sound].z) < 4.0


def test_what_is_told_of_readings_beyond_all_others_is_no_extrapolation() -> None:
    """A curve of order 12 goes anywhere beyond the targets that are left; what is expected of a machine does not."""
    rows, values = given()[1], noise(9)
    everything = null_of(given()[0].model, rows, values, 1e3 * SIGMA)
    at = rows.positions[0]
    good = at < np.sort(np.unique(at))[-4]
    _, told = explained(everything, everything.only(good), good)
    assert (~good).sum() == 30
    assert max(abs(one.deviation) for one in told.values()) < 0.02


def test_where_it_is_open_which_of_a_target_s_readings_are_spoilt_all_are_left_out() -> None:
    """Two of three in a row were spoilt, or the third: it is never left out alone. Another pass would tell."""
    rows = given()[1].only(np.arange(given()[1].size) < 9)
    good = np.ones(9, dtype=bool)
    good[4] = good[5] = False
    poses = at_targets(rows, np.repeat([0, 1, 2], 3))
    assert np.flatnonzero(undecided(poses, good)).tolist() == [3, 4, 5]
    passes = at_targets(rows, np.tile([0, 1, 2], 3))
    assert not undecided(passes, good).any()
    again = at_targets(rows, np.array([0, 0, 0, 1, 1, 1, 0, 1, 2]))
    assert not undecided(again, good).any()
    middle = np.arange(9) != 4
    assert not undecided(poses, middle).any()


def test_of_two_readings_of_a_place_none_is_left_out_alone() -> None:
    """The end of a line, read once on each way: nothing tells which of the two was spoilt, whatever the directions."""
    rows = given()[1].only(np.arange(given()[1].size) < 9)
    there = np.array([0, 1, 2, 3, 4, 3, 2, 1, 0])
    both = replace(at_targets(rows, there), target=np.arange(9))
    assert np.flatnonzero(undecided(both, np.arange(9) != 0)).tolist() == [0, 8]
    assert np.flatnonzero(undecided(both, np.arange(9) != 4)).tolist() == []


def at_targets(rows: Rows, target: IntArray) -> Rows:
    """Readings of targets 10 mm apart, of one set-up."""
    positions = np.zeros_like(rows.positions)
    positions[0] = 10.0 * target
    return replace(rows, target=target, positions=positions, setup=np.zeros_like(rows.setup))


@pytest.mark.parametrize("kind", ["jump", "drift", "misfit", "offset"])
def test_what_is_no_outlier_stays(kind: str) -> None:
    rows, values = given()[1], noise(2)
    run = rows.of_run(7)
    size = run.stop - run.start
    if kind == "jump":
        values[run.start + size // 2 : run.stop] += 30 * SIGMA
    elif kind == "drift":
        values[run] += np.linspace(0.0, 60 * SIGMA, size)
    elif kind == "misfit":
        values += 20 * SIGMA * np.sin(rows.positions.sum(axis=0) / 40.0)
    else:
        values[run] += 1000 * SIGMA
    assert len(null(values).outliers) <= 1


def test_readings_that_repeat_to_the_last_digit() -> None:
    assert not null(np.zeros(given()[1].size)).outliers


def test_how_runs_settle_is_found() -> None:
    """Beside zeros and creep of their own; of the ball bar nothing settles here, but its few short runs hardly tell."""
    rows, values = given()[1], noise(3)
    found = null(values)
    clean = {one.instrument: one.settles for one in found.noise}
    assert clean["laser"] < SIGMA
    assert clean["ballbar"] < 3.0 * SIGMA
    source = np.random.default_rng(5)
    for run in found.base.runs:
        if run.instrument == "laser":
            mine = rows.of_run(run.rows.index)
            values[mine] += (
                20.0 * SIGMA * source.normal() * np.exp(-np.linspace(0.0, 1.0, mine.stop - mine.start) / SETTLED)
            )
    settles = {one.instrument: one.settles for one in null(values).noise}
    assert settles["laser"] == pytest.approx(20.0 * SIGMA, rel=0.6)
    assert settles["ballbar"] < 3.0 * SIGMA


def test_what_runs_have_of_their_own_is_fitted_and_no_more() -> None:
    """By generalised least squares and the best prediction of what varies by chance, with dense covariances."""
    found = null(noise(6))
    own = np.concatenate([columns @ np.ones(columns.shape[1]) for columns in found.base.free])
    assert less_own(found.whitening, own) == pytest.approx(np.zeros(own.size), abs=1e-12 * np.abs(own).max())
    left = less_own(found.whitening, found.values)
    for run, free, each in zip(found.base.runs, found.base.free, found.whitening.runs, strict=True):
        at, alone = run.rows.at, replace(each, settles=0.0, wanders=0.0)
        chance = dense_covariance(alone) - dense_covariance(replace(alone, drifts=0.0, places=0.0))
        inverse = np.linalg.inv(dense_covariance(alone))
        held = free @ np.linalg.solve(free.T @ inverse @ free, free.T @ inverse)
        without = found.values[at] - held @ found.values[at]
        assert left[at] == pytest.approx(without - chance @ inverse @ without, abs=1e-4 * SIGMA)


def test_an_unknown_that_hardly_any_reading_feels_takes_nothing_from_the_others() -> None:
    """The posterior by the normal equations, without it: its column is 1e-15 of the others."""
    columns = 1e4 * np.random.default_rng(3).normal(size=(40, 6))
    columns[:, 2] = 1e-11
    r = np.asarray(np.linalg.qr(columns, mode="r"))
    others = np.arange(6) != 2
    root = expected_root(r)
    expected = np.linalg.inv(columns[:, others].T @ columns[:, others] + np.eye(5))
    assert (root @ root.T)[np.ix_(others, others)] == pytest.approx(expected, rel=1e-6, abs=1e-16)
    assert (root @ root.T)[2, 2] == pytest.approx(1.0)


def test_the_base_is_fitted_by_generalised_least_squares() -> None:
    """The whitened residual is orthogonal to every whitened column."""
    found = null(noise(7))
    coefficient = fitted(found.whitening, found.base.columns, found.values)
    white = found.whitening(found.base.columns.dense())
    left = found.whitening(found.values) - white @ coefficient
    size = np.linalg.norm(white, axis=0)
    assert np.abs(white.T @ left)[size > 0.0] / size[size > 0.0] == pytest.approx(
        0.0, abs=1e-6 * float(np.linalg.norm(left))
    )


def test_an_outlier_that_a_cause_hides_is_found_beside_it() -> None:
    """One of two readings of a target, 12 standard deviations off, where play in yaw shifts all by many more."""
    design = Design(lines=2, repeats=2, targets=15, samples=48)
    case = prepared(Case(2, design=design, noise="none", given="exact", nuisance=False))
    rows, effect = case.rows, Effect(kind="backlash", component="ECX")
    signal = parameter_signature(readings_of(case.model, rows), effect, np.array([1e-4]))[0]
    values = signal + SIGMA * np.random.default_rng(2).standard_normal(rows.size)
    spoilt = rows.of_run([run.id for run in rows.runs].index("X1-1")).start + 6
    values[spoilt] += 12.0 * SIGMA
    found = null_of(case.model, rows, values, None)
    assert found.outliers == ()
    assert np.flatnonzero(spoilt_beside(found, [signal])).tolist() == [spoilt]
