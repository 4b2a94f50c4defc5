"""The scan's statistic against explicit generalised least squares, and its evidence under noise alone."""

from dataclasses import replace
from functools import cache

import numpy as np
import numpy.typing as npt
import pytest
import statsmodels.api as sm
from scipy.linalg import block_diag
from scipy.stats import f, kstest

from tests.diagnosis.prepared import SIGMA, SLOW, SMALL, WHITE, Field, dense_covariance, field, noise_of
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.causes import prepared
from trueaxis.diagnosis.causes.prepared import Prepared, inner_of
from trueaxis.diagnosis.causes.scan import HELD, Scanned, peaks_of, residual_of, scanned
from trueaxis.diagnosis.causes.signature import Signature
from trueaxis.diagnosis.causes.signatures import signature_of
from trueaxis.effects.kind import Effect
from trueaxis.estimation.noise import Noise

FloatArray = npt.NDArray[np.float64]
FOUR_LINES = Design(lines=4, repeats=2, targets=15, samples=48)


@cache
def prepared_of(where: Field, signature: Signature) -> Prepared:
    """Once, however many values are scanned."""
    return prepared.prepared(signature, inner_of(where.whitening, where.base))


def scan_of(where: Field, effect: Effect, values: FloatArray, grid: int | None = None) -> Scanned:
    """values: (n,), mm; grid: of its points this one alone."""
    signature = signature_of(where.readings, effect)
    if grid is not None:
        signature = signature_of(where.readings, effect, (signature.points[grid],))
    return scanned_in(where, signature, where.base.rest(where.whitening(values)))


def scanned_in(where: Field, signature: Signature, white: FloatArray) -> Scanned:
    """white: (n,), whitened."""
    return scanned(
        signature, prepared_of(where, signature), residual_of(where.whitening, where.base, white, where.freedom)
    )


@pytest.mark.parametrize(
    ("effect", "grid"),
    [
        (Effect(kind="backlash", component="EXX"), None),
        (Effect(kind="drift", component="EYY"), None),
        (Effect(kind="cyclic", component="EZZ"), 40),
        (Effect(kind="servo_lag", component="EXX"), None),
        (Effect(kind="cross_axis", component="ECX", axis="Y"), None),
        (Effect(kind="laser_step", runs=("X1-1",)), 5),
    ],
    ids=lambda given: given.label if isinstance(given, Effect) else "",
)
@pytest.mark.parametrize(("of", "settles"), [(WHITE, 0.0), (SLOW, 2.0 * SIGMA)], ids=["white", "slow and settling"])
def test_statistic_is_the_difference_of_two_sums_of_squares(
    effect: Effect, grid: int | None, of: Noise, settles: float
) -> None:
    """Two fits by statsmodels, covariance and unknowns of all runs written out: with the candidate and without."""
    where = field(FOUR_LINES, of, settles=settles)
    values = noise_of(where, 1)
    found = scan_of(where, effect, values, grid)
    signature = signature_of(where.readings, effect, (found.point,))
    whole = signature.over_all()
    covariance = block_diag(*map(dense_covariance, where.whitening.runs))
    # of the base what the projection has taken for its span: the rank is tested elsewhere
    turned = np.linalg.lstsq(where.whitening(where.columns), where.base.basis.dense(), rcond=1e-12)[0]
    base = np.hstack([where.columns @ turned, where.without_own()])
    base = base[:, np.linalg.norm(base, axis=0) > 0.0]
    base = base / np.linalg.norm(base, axis=0)
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
    effect = Effect(kind="laser_cosine", runs=("X1-1", "X1-2"))
    column = signature_of(where.readings, effect).over_all()[:, 0]
    assert scan_of(where, effect, 35e-6 * column).statistic > 100.0
    assert scan_of(where, effect, -35e-6 * column).statistic == 0.0


def test_readings_say_nothing_for_what_nobody_knows_there() -> None:
    where = field()
    signature = signature_of(where.readings, Effect(kind="backlash", component="EXX"))
    white = where.base.rest(where.whitening(1e-2 * signature.over_all()[:, 0]))
    assert scanned_in(where, signature, white).evidence > 100.0
    assert scanned_in(where, replace(signature, missing="time_s"), white).evidence == 0.0


def test_what_the_base_holds_explains_nothing() -> None:
    """One line per axis: the angle of its beam is a scale of the axis."""
    where = field(replace(FOUR_LINES, lines=1, ball_bar=False))
    found = scan_of(where, Effect(kind="laser_cosine", runs=("X1-1", "X1-2")), noise_of(where, 3))
    assert found.statistic == pytest.approx(0.0, abs=1e-9)
    assert found.evidence == 0.0


@cache
def under_noise(count: int) -> dict[Effect, FloatArray]:
    """Raw statistics, p values after the effective tries, and tries of all candidates: (3, count)."""
    where = field(SMALL, WHITE)
    source = np.random.default_rng(11)
    size = where.readings.rows.size
    draws = where.base.rest(source.standard_normal((size, count))).T
    residuals = [residual_of(where.whitening, where.base, one, where.freedom) for one in draws]
    effects = where.ground(np.zeros(size)).effects
    found = {}
    for effect in effects:
        signature = signature_of(where.readings, effect)
        one = [scanned(signature, prepared_of(where, signature), residual) for residual in residuals]
        found[effect] = np.array([[each.statistic, each.p_value, each.tries] for each in one]).T
    return found


CANDIDATES = [
    Effect(kind="backlash", component="EXX"),
    Effect(kind="backlash_slope", component="EYY"),
    Effect(kind="drift", component="EZZ"),
    Effect(kind="servo_lag", component="EXX"),
    Effect(kind="backlash", component="EZX"),
    Effect(kind="thermal_offset", component="EYX"),
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
        (
            Effect(kind="cyclic", component="EXX"),
            0.1,
        ),  # of a grid that is coarse beside its pitches, the angles say too much
        (Effect(kind="cyclic", component="EYZ"), 0.1),
        (Effect(kind="warm_up", component="EYY"), 0.75),
        (Effect(kind="reversal_spike", component="EXX"), 0.75),
        (Effect(kind="laser_step", runs=("X1-1",)), 0.4),
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


@pytest.mark.parametrize(
    "effect",
    [Effect(kind="cyclic", component="ECX"), Effect(kind="reversal_spike", component="EXX")],
    ids=lambda one: one.label,
)
@pytest.mark.parametrize("entries", [1, 2000])
def test_a_grid_in_pieces_is_the_grid(effect: Effect, entries: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Memory is bounded, point by point if need be; nothing else changes."""
    where = field(FOUR_LINES, SLOW, settles=2.0 * SIGMA)
    signature = signature_of(where.readings, effect)
    whole = prepared.prepared(signature, inner_of(where.whitening, where.base))
    monkeypatch.setattr(prepared, "ENTRIES", entries)
    pieces = prepared.prepared(signature, inner_of(where.whitening, where.base))
    assert pieces.whole == pytest.approx(whole.whole, rel=1e-12)
    assert pieces.gram == pytest.approx(whole.gram, rel=1e-9, abs=1e-12 * whole.whole.max())
    assert pieces.length == pytest.approx(whole.length, rel=1e-6)


def test_every_peak_that_may_be_the_highest_between_the_points_of_the_grid_is_known() -> None:
    """A pitch was named that was an alias of the true one: it was nearer to a point of the grid."""
    frequency = np.arange(41) * 0.5  # two steps a period, as the grid of pitches
    for offset in (0.0, 0.1, 0.25):
        true, alias = np.sinc(frequency - 9.0 - offset) ** 2, 0.97 * np.sinc(frequency - 15.5) ** 2
        places = peaks_of(true + alias, HELD * float((true + alias).max()))
        assert {18, 31} <= set(places)
        assert len(places) == 2


def test_more_than_a_machine_has_explains_no_more_than_what_it_has() -> None:
    """Beside the sum of squares that the most of it leaves, one for what is expected of it."""
    where = field(FOUR_LINES, WHITE)
    signature = signature_of(where.readings, Effect(kind="thermal_offset", component="EXX"))
    signal = signature.over_all()[:, 0]
    values = noise_of(where, 1) + 50.0 * signal
    left, column = (where.base.rest(where.whitening(one)) for one in (values, signal))
    found = scanned_in(where, replace(signature, most=2.0), left)
    assert found.amplitudes == pytest.approx([2.0])
    with_it = left - 2.0 * column
    assert found.statistic == pytest.approx(left @ left - with_it @ with_it - 1.0, rel=1e-6)


@pytest.mark.parametrize(
    ("kind", "component", "unit"),
    [("thermal_expansion", "EXX", 1.0), ("thermal_offset", "EAX", 1.0), ("thermal_offset", "EXX", 600.0)],
)
def test_what_a_machine_has_per_kelvin(kind: str, component: str, unit: float) -> None:
    """Times 1e-4: of a length or in rad; of its travels, here between 0.6 and 1.2 m together."""
    readings = field(FOUR_LINES, WHITE).readings
    most = signature_of(readings, Effect(kind=kind, component=component)).most
    assert 1e-4 * unit <= most <= 2e-4 * unit
