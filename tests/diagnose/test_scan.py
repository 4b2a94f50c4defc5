"""The scan's statistic against explicit generalised least squares, and its evidence under noise alone."""

from dataclasses import replace
from functools import cache

import numpy as np
import numpy.typing as npt
import pytest
import statsmodels.api as sm
from scipy.linalg import block_diag
from scipy.stats import f, kstest

from tests.diagnose.prepared import SIGMA, SMALL, WHITE, Field, dense_covariance, drawn_noise, field
from tests.hidden_effects.design import Design
from trueaxis.diagnose import scan
from trueaxis.diagnose.freedom import Freedom
from trueaxis.diagnose.result import NoiseOf
from trueaxis.diagnose.scan import Scanned, prepared, residual_of, scanned
from trueaxis.diagnose.signatures import Signature, signature_of
from trueaxis.effects.kind import Effect

FloatArray = npt.NDArray[np.float64]
SLOPES = NoiseOf("laser", SIGMA, SIGMA / 2, 0.8, SIGMA, 1e6, "given", slope_freedom=12.0)
FOUR_LINES = Design(lines=4, repeats=2, targets=15, samples=48)


def scan_of(where: Field, effect: Effect, values: FloatArray, grid: int | None = None) -> Scanned:
    """values: (n,), mm; grid: of its points this one alone."""
    signature = signature_of(where.readings, effect)
    if grid is not None:
        signature = signature_of(where.readings, effect, (signature.points[grid],))
    return scanned_in(where, signature, where.base.rest(where.whitening(values)))


def scanned_in(where: Field, signature: Signature, white: FloatArray) -> Scanned:
    """white: (n,), whitened."""
    known = prepared(signature, where.whitening, where.base)
    return scanned(signature, known, residual_of(where.whitening, where.base, white, where.freedom))


def noise(where: Field, of: NoiseOf, seed: int) -> FloatArray:
    """(n,), mm, run by run."""
    source = np.random.default_rng(seed)
    starts = where.whitening.starts
    return np.concatenate([drawn_noise(source, of, int(size))[:, 0] for size in np.diff(starts)])


@pytest.mark.parametrize(
    ("effect", "grid"),
    [
        (Effect("backlash", "EXX"), None),
        (Effect("drift", "EYY"), None),
        (Effect("cyclic", "EZZ"), 40),
        (Effect("laser_scale"), None),
        (Effect("cross_axis", "ECX", "Y"), None),
        (Effect("laser_step", runs=("X1-1",)), 5),
    ],
    ids=lambda given: given.label if isinstance(given, Effect) else "",
)
@pytest.mark.parametrize("of", [WHITE, SLOPES], ids=["white", "slopes"])
def test_statistic_is_the_difference_of_two_sums_of_squares(effect: Effect, grid: int | None, of: NoiseOf) -> None:
    """Two fits by statsmodels with the covariance written out: with the candidate and without."""
    where = field(FOUR_LINES, of)
    values = noise(where, of, 1)
    found = scan_of(where, effect, values, grid)
    signature = signature_of(where.readings, effect, (found.point,))
    whole = signature.over_all()
    covariance = block_diag(*(dense_covariance(of, int(size)) for size in np.diff(where.whitening.starts)))
    # of the base what the projection has taken for its span: the rank is tested elsewhere
    base = np.linalg.solve(where.whitening(np.eye(values.size)), where.base.basis)
    base /= np.linalg.norm(base, axis=0)
    without = sm.GLS(values, base, sigma=covariance).fit()
    with_it = sm.GLS(values, np.hstack([base, whole / np.linalg.norm(whole, axis=0)]), sigma=covariance).fit()
    assert found.statistic == pytest.approx(without.ssr - with_it.ssr, rel=1e-5, abs=1e-6)
    amplitudes = with_it.params[-found.freedom :] / np.linalg.norm(whole, axis=0)
    assert found.amplitudes == pytest.approx(amplitudes, rel=1e-4)
    if found.freedom == 1:
        assert found.evidence == pytest.approx(-np.log10(f.sf(found.statistic, 1, 1e6)), abs=0.5)


def test_a_root_is_found_for_one_sign_alone() -> None:
    """The square of an angle cannot make a laser read long."""
    where = field(FOUR_LINES)
    effect = Effect("laser_cosine", runs=("X1-1", "X1-2"))
    column = signature_of(where.readings, effect).over_all()[:, 0]
    assert scan_of(where, effect, 25e-6 * column).statistic > 100.0
    assert scan_of(where, effect, -25e-6 * column).statistic == 0.0


def test_what_the_base_holds_explains_nothing() -> None:
    """One line per axis: the angle of its beam is a scale of the axis."""
    where = field(replace(FOUR_LINES, lines=1, ball_bar=False))
    found = scan_of(where, Effect("laser_cosine", runs=("X1-1", "X1-2")), noise(where, WHITE, 3))
    assert found.statistic == pytest.approx(0.0, abs=1e-9)
    assert found.evidence == 0.0


@cache
def under_noise(count: int) -> dict[Effect, FloatArray]:
    """Raw statistics, p values after the effective tries, and tries of all candidates: (3, count)."""
    where = field(SMALL, WHITE)
    source = np.random.default_rng(11)
    size = where.readings.rows.size
    residuals = where.base.rest(source.standard_normal((size, count)))
    effects = where.ground(np.zeros(size)).effects
    found = {}
    for effect in effects:
        signature = signature_of(where.readings, effect)
        one = [scanned_in(where, signature, residuals[:, k]) for k in range(count)]
        found[effect] = np.array([[each.statistic, each.p_value, each.tries] for each in one]).T
    return found


CANDIDATES = [
    Effect("backlash", "EXX"),
    Effect("backlash_slope", "EYY"),
    Effect("drift", "EZZ"),
    Effect("servo_lag", "EXX"),
    Effect("backlash", "EZX"),
    Effect("thermal_offset", "EYX"),
]


@pytest.mark.parametrize("effect", CANDIDATES, ids=lambda effect: effect.label)
def test_p_values_of_linear_candidates_are_uniform_under_noise(effect: Effect) -> None:
    where = field(SMALL, WHITE)
    source = np.random.default_rng(17)
    size = where.readings.rows.size
    signature = signature_of(where.readings, effect)
    p = [scanned_in(where, signature, where.base.rest(source.standard_normal(size))).p_value for _ in range(400)]
    assert kstest(p, "uniform").pvalue > 1e-3


@pytest.mark.parametrize(
    ("effect", "least"),
    [
        (Effect("cyclic", "EXX"), 0.1),  # of a grid that is coarse beside its pitches, the angles say too much
        (Effect("cyclic", "EYZ"), 0.1),
        (Effect("warm_up", "EYY"), 0.75),
        (Effect("reversal_spike", "EXX"), 0.75),
        (Effect("laser_step", runs=("X1-1",)), 0.4),
    ],
    ids=lambda given: given.label if isinstance(given, Effect) else "",
)
def test_p_values_of_searched_candidates_are_about_what_they_should_be(effect: Effect, least: float) -> None:
    """Against simulated maxima over the grid: how often p is below a tenth, as a multiple of a tenth."""
    draws, level = 800, 0.1
    where = field(SMALL, WHITE)
    source = np.random.default_rng(23)
    size = where.readings.rows.size
    signature = signature_of(where.readings, effect)
    found = [scanned_in(where, signature, where.base.rest(source.standard_normal(size))) for _ in range(draws)]
    often = float(np.mean([one.p_value < level for one in found])) / level
    assert least < often < 1.1 + 3.0 * np.sqrt((1.0 - level) / (level * draws))


def test_in_noise_alone_the_threshold_is_hardly_ever_reached() -> None:
    """Bonferroni over candidates and tries: the least p of all candidates is uniform or larger."""
    found = under_noise(40)
    least = np.min([values[1] for values in found.values()], axis=0) * len(found)
    assert np.mean(least < 0.05) < 0.05 + 3 * np.sqrt(0.05 * 0.95 / least.size)
    assert np.mean(least < 1.0) > 0.1  # and not beyond all reach


@pytest.mark.parametrize("share", [0.0, 0.3, 1.0])
def test_freedom_is_that_of_the_ratio(share: float) -> None:
    """Noise of white part and slope, both estimated: the variance of the estimate along a column, by simulation."""
    of_readings, of_slopes, draws = 200.0, 10.0, 40_000
    source = np.random.default_rng(5)
    ramp = np.array([np.sqrt(share), 0.0])  # whitened: along the column the slope has this share of the variance
    column = np.array([[1.0], [0.0]])
    freedom = Freedom(of_readings, np.array([of_slopes]), ramp, np.array([0]))
    found = freedom.of(freedom.slopes.T @ column, np.eye(1))
    white = source.chisquare(of_readings, draws) / of_readings
    slope = source.chisquare(of_slopes, draws) / of_slopes
    variance = (1.0 - share) * white + share * slope
    assert found == pytest.approx(2.0 / np.var(variance), rel=0.05)
    assert kstest(source.standard_normal(draws) ** 2 / variance, f(1, found).cdf).statistic < 0.02


def test_freedom_of_several_runs_that_share_one_slope() -> None:
    """Three runs of one instrument and one of another: shares of those that share an estimate add up first."""
    ramps = np.sqrt(np.array([0.2, 0.1, 0.3, 0.1]))
    columns = np.full((4, 1), 1.0)  # not of length 1: shares are as given
    freedom = Freedom(1e9, np.array([8.0, 8.0, 8.0, 5.0]), ramps, np.arange(4))
    found = freedom.of(freedom.slopes.T @ columns, np.eye(1))
    draws = 200_000
    source = np.random.default_rng(6)
    variance = 0.6 * source.chisquare(8.0, draws) / 8.0 + 0.1 * source.chisquare(5.0, draws) / 5.0 + 0.3
    assert found == pytest.approx(2.0 / np.var(variance), rel=0.05)


@pytest.mark.parametrize(
    "effect", [Effect("cyclic", "ECX"), Effect("reversal_spike", "EXX")], ids=lambda one: one.label
)
@pytest.mark.parametrize("entries", [1, 2000])
def test_a_grid_in_pieces_is_the_grid(effect: Effect, entries: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Memory is bounded, point by point if need be; nothing else changes."""
    where = field(FOUR_LINES, SLOPES)
    signature = signature_of(where.readings, effect)
    whole = prepared(signature, where.whitening, where.base)
    monkeypatch.setattr(scan, "ENTRIES", entries)
    pieces = prepared(signature, where.whitening, where.base)
    assert pieces.total == pytest.approx(whole.total, rel=1e-12)
    assert pieces.gram == pytest.approx(whole.gram, rel=1e-9, abs=1e-12 * whole.total.max())
    assert pieces.length == pytest.approx(whole.length, rel=1e-6)


def test_freedom_is_that_of_what_the_base_and_causes_leave() -> None:
    """From products alone as from an orthonormal basis of the column, projected in full."""
    where = field(FOUR_LINES, SLOPES)
    cause = where.whitening(signature_of(where.readings, Effect("drift", "EXX")).over_all())
    base = where.base.softened(np.random.default_rng(1).normal(size=(where.base.basis.shape[0], 2))).extended(cause)
    residual = residual_of(where.whitening, base, np.zeros(base.basis.shape[0]), where.freedom)
    for effect in (Effect("backlash", "EYY"), Effect("laser_scale"), Effect("laser_cosine", runs=("X1-1", "X1-2"))):
        signature = signature_of(where.readings, effect)
        left = base.rest(where.whitening(signature.over_all()))
        unit = left / np.linalg.norm(left)
        expected = where.freedom.of(where.freedom.slopes.T @ unit, np.eye(1))
        assert residual.freedom_of(signature, 0, left.T @ left) == pytest.approx(expected, rel=1e-9)
        assert expected < where.freedom.of_readings
