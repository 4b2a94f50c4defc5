"""Noise from repeats in any order, by Monte Carlo: noise of known kinds is drawn by other means and found again."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.linalg import block_diag
from statsmodels.regression.mixed_linear_model import MixedLM
from statsmodels.tsa.arima_process import arma_generate_sample

from tests.diagnosis.prepared import SIGMA, FloatArray, dense_covariance, prepared, run_noise
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.null_model.base import Base, base_of
from trueaxis.diagnosis.null_model.noise import COURSES, EXPECTED, REPEATS, STATED, UNKNOWN, noise_of_runs
from trueaxis.diagnosis.null_model.noise_blocks import _together
from trueaxis.diagnosis.null_model.noise_precision import precision_of
from trueaxis.diagnosis.null_model.rows import Rows, rows_of
from trueaxis.diagnosis.result import NoiseOf
from trueaxis.estimation.noise import Noise
from trueaxis.measurement.setup import Device

DRAWS = 6
CORRELATION = 0.8
DESIGN = Design(lines=2, repeats=3, targets=21, ball_bar=False)


@cache
def measured(design: Design = DESIGN) -> tuple[Rows, Base]:
    given_case = prepared(Case(seed=1, design=design, noise="none", given="exact"))
    return given_case.rows, base_of(given_case.model, given_case.rows)


def drawn(rows: Rows, seed: int, slow: float = 0.0) -> FloatArray:
    """(n,) mm: standard deviation SIGMA, of whose variance a share is slow; zero and creep of every run, large."""
    source = np.random.default_rng(seed)
    found = np.empty(rows.size)
    for index in rows.present:
        mine = rows.of_run(index)
        size = mine.stop - mine.start
        chain = arma_generate_sample(
            [1.0, -CORRELATION], [1.0], size, np.sqrt(1.0 - CORRELATION**2), distrvs=source.standard_normal, burnin=200
        )
        found[mine] = SIGMA * (np.sqrt(1.0 - slow) * source.standard_normal(size) + np.sqrt(slow) * chain)
        found[mine] += 10.0 * SIGMA * (source.normal() + source.normal() * np.arange(size) / size)
    return found


def noise_of(values: FloatArray, rows: Rows, base: Base, instrument: str = "laser") -> NoiseOf:
    _, noise, _ = noise_of_runs(rows, base, values, None)
    return next(one for one in noise if one.instrument == instrument)


@pytest.mark.parametrize("slow", [0.0, 0.6])
def test_noise_is_found_whatever_the_model_gets_wrong(slow: float) -> None:
    """A misfit of 100 times the noise that all repeats share; zeros and creep of 10 times."""
    rows, base = measured()
    misfit = 100.0 * SIGMA * np.random.default_rng(3).standard_normal(int(rows.target.max()) + 1)[rows.target]
    found = [noise_of(drawn(rows, seed, slow) + misfit, rows, base) for seed in range(DRAWS)]
    assert {one.origin for one in found} == {REPEATS}
    share = np.array([(one.correlated / one.sigma) ** 2 for one in found])
    assert share.mean() == pytest.approx(slow, abs=0.25)
    white = np.array([one.white for one in found])
    assert white.mean() == pytest.approx(np.sqrt(1.0 - slow) * SIGMA, rel=0.12)


def test_low_frequencies_are_as_strong_as_they_are() -> None:
    """Slow noise and a walk may stand for each other: the variance of the mean of a run's first third says both."""
    rows, base = measured()
    run = base.runs[0].rows
    first = (run.passed < 1.0 / 3.0) / np.count_nonzero(run.passed < 1.0 / 3.0)

    def strength(noise: Noise, wanders: float, settles: float) -> float:
        known = run_noise(noise, run.steps, run.passed, settles, wanders)
        own = np.stack([np.ones(run.passed.size), run.passed], axis=1)
        beside = first - own @ np.linalg.lstsq(own, first, rcond=None)[0]
        return float(beside @ dense_covariance(known) @ beside)

    truth = strength(Noise(np.sqrt(0.7) * SIGMA, np.sqrt(0.3) * SIGMA, -1.0 / np.log(CORRELATION)), 0.0, 0.0)
    found = [noise_of(drawn(rows, seed, 0.3), rows, base) for seed in range(DRAWS)]
    ratio = [
        strength(Noise(one.white, one.correlated, -1.0 / np.log(one.correlation)), one.wanders, one.settles) / truth
        for one in found
    ]
    assert np.exp(np.mean(np.log(ratio))) == pytest.approx(1.0, abs=0.3), ratio
    assert min(ratio) > 0.4, ratio


@pytest.mark.parametrize("order", ["cycles", "passes", "poses"])
def test_repeats_are_known_in_any_order(order: str) -> None:
    """The same readings of 12 targets, five times each, in one run."""
    rows, base = measured()
    run = base.runs[0]
    size, targets = run.rows.at.size, 12
    number = np.arange(size)
    target = {
        "cycles": number % targets,
        "passes": np.abs((number % (2 * targets)) - targets + 0.5).astype(int),
        "poses": np.repeat(np.arange(targets), -(-size // targets))[:size],
    }[order]
    numbers = rows.target.copy()
    numbers[run.rows.at] = numbers.max() + 1 + target
    values = drawn(rows, 5) + 50.0 * SIGMA * np.random.default_rng(1).standard_normal(numbers.max() + 1)[numbers]
    changed = Rows(**{name: getattr(rows, name) for name in rows.__slots__} | {"target": numbers})
    found = noise_of(values, changed, base)
    assert found.origin == REPEATS
    assert found.sigma == pytest.approx(SIGMA, rel=0.25)


def test_white_noise_is_that_of_a_mixed_model() -> None:
    """By statsmodels' REML, the targets as fixed effects, zeros of runs taken for random ones far apart."""
    rows, base = measured(Design(lines=1, repeats=3, targets=11, ball_bar=False))
    source = np.random.default_rng(4)
    values = SIGMA * source.standard_normal(rows.size)
    number = np.unique(rows.target, return_inverse=True)[1]
    fixed = np.eye(number.max() + 1)[number]
    passed = np.concatenate([run.rows.passed - 0.5 for run in base.runs])
    random = np.stack([np.ones(rows.size), passed], axis=1)
    apart = values + (100.0 * SIGMA * source.standard_normal((len(rows.runs), 2))[rows.run] * random).sum(axis=1)
    expected = MixedLM(1e3 * apart, fixed, rows.run, exog_re=random).fit(reml=True, method=["powell"])
    found = noise_of(apart, rows, base)
    assert found.sigma == pytest.approx(1e-3 * np.sqrt(expected.scale), rel=0.1)


@pytest.mark.parametrize("moved", [0.0, 3e-3])
def test_runs_tell_how_far_their_balls_stand_apart(moved: float) -> None:
    """Two circles a plane, the ball of each drawn anew, beside one place that is far off for all: it is not theirs."""
    rows, base = measured(Design(lines=1, repeats=1, targets=11, samples=60))
    of_all, found = np.array([0.04, -0.03, 0.02]), []
    for seed in range(DRAWS):
        source = np.random.default_rng(seed)
        values = SIGMA * source.standard_normal(rows.size)
        for run, ball in zip(base.runs, base.balls, strict=True):
            if ball.size:
                values[run.rows.at] += ball @ (of_all + moved * source.standard_normal(3))
        found.append(noise_of(values, rows, base, "ballbar"))
    assert [one.white for one in found] == pytest.approx(DRAWS * [SIGMA], rel=0.25)
    places = np.array([one.places for one in found])
    assert np.sqrt(np.mean(places**2)) == pytest.approx(moved, rel=0.4, abs=0.5 * SIGMA)
    assert places.min() >= 0.4 * moved


def test_outliers_do_not_move_it() -> None:
    rows, base = measured()
    values = drawn(rows, 7)
    clean = noise_of(values, rows, base)
    values[np.random.default_rng(2).choice(rows.size, 12, replace=False)] += 40.0 * SIGMA
    assert noise_of(values, rows, base).sigma == pytest.approx(clean.sigma, rel=0.15)


def test_a_run_with_more_noise_is_told_from_the_others() -> None:
    rows, base = measured()
    values = drawn(rows, 8)
    noisy = base.runs[3].rows.at
    values[noisy] += 3.0 * SIGMA * np.random.default_rng(9).standard_normal(noisy.size)
    runs, _, _ = noise_of_runs(rows, base, values, None)
    of_lasers = [one.noise.white for one, run in zip(runs, base.runs, strict=True) if run.instrument == "laser"]
    scales = np.array(of_lasers) / np.median(of_lasers)
    assert scales.argmax() == 3
    assert scales[3] > 1.6  # of sqrt(10), as far as its readings tell
    assert np.delete(scales, 3) == pytest.approx(1.0, abs=0.35)


def test_each_device_has_its_own_noise_where_several_are_named() -> None:
    """Optics for straightness are noisier than those for distances: with one noise for both, sound readings were
    "unexplained". Runs that name no device are of one.
    """
    case = prepared(Case(seed=1, design=DESIGN, noise="none", given="exact"))
    optics = Device(id="optics")
    runs = tuple(replace(one, device=optics if k % 2 else None) for k, one in enumerate(case.data.setup.runs))
    rows = rows_of(replace(case.data, setup=replace(case.data.setup, runs=runs)))
    noise = np.array([20.0 if run.device == optics else 1.0 for run in rows.runs])[rows.run]
    _, found, _ = noise_of_runs(rows, base_of(case.model, rows), noise * drawn(rows, 8), None)
    sigma = {one.group: one.sigma for one in found}
    assert sigma == pytest.approx({"laser optics": 20.0 * SIGMA, "laser without a device": SIGMA}, rel=0.15)
    assert {one.instrument for one in found} == {"laser"}


def test_without_repeats_the_course_of_each_run_tells() -> None:
    rows, base = measured(Design(lines=2, repeats=1, targets=41, samples=180, feeds=(1000.0,)))
    smooth = 30.0 * SIGMA * np.sin(rows.positions.sum(axis=0) / 300.0)
    found = noise_of(smooth + drawn(rows, 1), rows, base)
    assert found.origin == COURSES
    assert found.white == pytest.approx(SIGMA, rel=0.35)  # slow noise the course has taken away, any is allowed


@pytest.mark.parametrize("times", [0.02, 0.25, 1.0])
def test_lines_of_few_targets_tell_it_beside_errors_as_large_as_expected(times: float) -> None:
    """Eight targets from one side, which a curve of degree 12 follows whatever it reads: their noise was taken for as
    large as the values themselves. Values given that are nearly right leave smaller errors than expected.
    """
    every, _ = measured(Design(lines=4, repeats=1, targets=8, ball_bar=False))
    rows = every.only(np.asarray((every.directions >= 0).all(axis=0)))
    base = base_of(prepared(Case(seed=1, design=DESIGN, noise="none", given="exact")).model, rows)
    ratio = []
    for seed in range(DRAWS):
        size = times * base.expected[: base.of_machine]
        errors = base.machine @ (size * np.random.default_rng([seed, 5]).standard_normal(size.size))
        found = noise_of(errors + drawn(rows, seed), rows, base)
        assert found.origin == EXPECTED
        ratio.append(found.sigma / SIGMA)
    assert 0.5 < float(np.exp(np.mean(np.log(ratio)))) < 2.0
    assert 0.3 < min(ratio) < max(ratio) < 3.0


def test_noise_that_is_given_is_taken() -> None:
    rows, base = measured()
    runs, noise, _ = noise_of_runs(rows, base, drawn(rows, 0), 0.7)
    assert {(one.white, one.correlated, one.origin) for one in noise} == {(0.7e-3, 0.0, STATED)}
    assert {one.sigma for one in runs} == {0.7e-3}


def test_too_few_readings_tell_none() -> None:
    rows, _ = measured()
    first = np.isin(np.arange(rows.size), np.arange(3))
    few = rows.only(first)
    case = prepared(Case(seed=1, design=DESIGN, noise="none", given="exact"))
    (found,) = noise_of_runs(few, base_of(case.model, few), np.array([1e-3, -1e-3, 1e-3]), None)[1]
    assert (found.origin, found.freedom) == (UNKNOWN, 1.0)
    assert found.sigma == pytest.approx(1e-3)


@pytest.mark.parametrize("repeats", [1, 4])
def test_repeats_of_a_coarse_display_are_no_proof(repeats: int) -> None:
    """Repeats equal to the last digit: the mean of a target is off by the rounding of one reading, however many."""
    rows, base = measured(Design(lines=2, repeats=repeats, targets=21, ball_bar=False))
    smooth = np.sin(rows.positions.sum(axis=0) / 37.0) * 5e-3
    step = 1e-3
    rounded = step * np.round((smooth + 1e-5 * np.random.default_rng(1).standard_normal(rows.size)) / step)
    shown = Rows(**{name: getattr(rows, name) for name in rows.__slots__} | {"reading": rounded})
    found = noise_of(rounded, shown, base)
    assert found.sigma >= 0.99 * step / np.sqrt(12.0)


def test_a_misfit_of_a_billion_times_the_noise_is_positive_definite() -> None:
    """As of a run in another unit: rounding of the misfit alone is more than the noise."""
    repeated = np.repeat(np.eye(6), 4, axis=0)
    within = np.eye(24) - 0.25 * repeated @ repeated.T  # what repeats differ by alone is known
    for column in (np.tile(np.eye(4), 6).T[:, :1], repeated[:, :1], np.ones((24, 1))):
        own = column / np.linalg.norm(column)
        precision, logarithm = precision_of([np.eye(12), np.eye(12)], repeated, 1e9, own)
        assert np.isfinite(logarithm)
        contrast = within @ own
        size = float(np.linalg.norm(contrast))
        held = contrast / size if size > 1e-9 else np.zeros_like(own)
        assert precision.dense() == pytest.approx(within - held @ held.T, abs=1e-3)


@pytest.mark.parametrize("seed", range(4))
def test_the_precision_is_that_of_the_whole_covariance(seed: int) -> None:
    """Inverse less what free columns take, its slopes, and the determinants."""
    source = np.random.default_rng(seed)
    sizes, targets = source.integers(3, 9, size=3), int(source.integers(2, 7))
    noise = [(half := source.standard_normal((m, m))) @ half.T + np.eye(m) for m in sizes]
    repeated = np.eye(targets)[source.integers(0, targets, size=sizes.sum())]
    own = np.linalg.qr(source.standard_normal((sizes.sum(), 2)))[0]
    misfit = float(source.uniform(0.0, 5.0))
    found, root = precision_of(noise, repeated, misfit, own)
    inverse = np.linalg.inv(block_diag(*noise) + misfit**2 * repeated @ repeated.T)
    held = own.T @ inverse @ own
    dense = inverse - inverse @ own @ np.linalg.solve(held, own.T @ inverse)
    assert found.dense() == pytest.approx(dense, abs=1e-10)
    assert found @ repeated == pytest.approx(dense @ repeated, abs=1e-10)
    assert found.diagonal() == pytest.approx(np.diag(dense), abs=1e-10)
    assert block_diag(*found.blocks()) == pytest.approx(dense * block_diag(*map(np.ones_like, noise)), abs=1e-10)
    assert found.within(repeated) == pytest.approx(np.trace(repeated.T @ dense @ repeated), abs=1e-9)
    assert root == pytest.approx(0.5 * (np.linalg.slogdet(held)[1] - np.linalg.slogdet(inverse)[1]), abs=1e-9)


def test_only_what_repeats_tell_counts_as_degrees_of_freedom_of_the_noise() -> None:
    """Readings of targets that are read once differ from the base by what it gets wrong as much as by noise: counted
    as degrees of freedom they made the tests that divide by the noise far too sure.
    """
    rows, base = measured()
    run = np.array([base.runs[k].rows.run.id for k in np.searchsorted([r.rows.index for r in base.runs], rows.run)])
    keep = np.char.endswith(run, "-1") | np.char.startswith(run, "X1")
    rows, base = rows.only(keep), base.only(keep)
    misfit = 100.0 * SIGMA * np.random.default_rng(3).standard_normal(int(rows.target.max()) + 1)[rows.target]
    found = np.mean([noise_of(drawn(rows, seed) + misfit, rows, base).freedom for seed in range(DRAWS)])
    own = block_diag(*(base.own[k][np.argsort(one.rows.at)] for k, one in enumerate(base.runs)))
    targets = np.equal.outer(rows.target, np.unique(rows.target)).astype(float)
    contrasts = rows.size - np.linalg.matrix_rank(np.hstack([own, targets]))
    assert found == pytest.approx(contrasts, rel=0.1)
    assert contrasts < 0.5 * rows.size


def test_every_instrument_tells_its_noise_in_the_first_block() -> None:
    """An angle instrument measured three times was too few to know its noise: the first block was full without it."""
    groups = [np.arange(10 * k, 10 * k + 10) for k in range(9)]
    owner = ("laser", "laser", "bar", "laser", "angle", "bar", "angle", "probe", "laser")
    found = _together(groups, 35, lambda at: owner[int(at[0]) // 10])
    numbers = [[int(at[0]) // 10 for at in members] for members in found]
    assert numbers == [[0, 1, 2, 4, 7], [3, 5], [6, 8]]
    assert _together([], 35, lambda _: "") == []
