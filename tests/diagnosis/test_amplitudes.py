"""Whether an amplitude is one: it is not where it changes along the travel or with time; noise is no change."""

import numpy as np
import numpy.typing as npt
import pytest
from scipy.stats import kstest

from tests.diagnosis.prepared import SLOW, SMALL, Field, field, noise_of
from trueaxis.diagnosis.causes.refit import refit
from trueaxis.diagnosis.causes.search import scan_all, search_of, zoomed
from trueaxis.diagnosis.causes.signatures import parameter_signature
from trueaxis.diagnosis.judging.amplitudes import Uneven, unevenness
from trueaxis.effects.kind import Effect

FloatArray = npt.NDArray[np.float64]
BACKLASH, DRIFT = Effect(kind="backlash", component="EXX"), Effect(kind="drift", component="EZZ")
SIZES = {BACKLASH: 6e-3, DRIFT: 6e-6}  # mm, mm/s: twenty times the noise


def uneven(where: Field, effect: Effect, values: FloatArray) -> Uneven:
    ground = where.ground(values)
    residual = ground.left(ground.base)
    found = [zoomed(ground, residual, scan) for scan in scan_all(ground, residual, [effect])]
    causes = refit(ground, found)
    (one,) = unevenness(ground, search_of(ground, found, ()), causes, [1.0])
    return one


def signal(where: Field, effect: Effect) -> FloatArray:
    return np.asarray(parameter_signature(where.readings, effect, np.array([SIZES[effect]]))[0])


def along(where: Field, name: str) -> FloatArray:
    """(n,): from -1 to 1 over the travel of X, or over the day."""
    scale = where.readings.rows.positions[0] if name == "place" else where.readings.rows.time
    assert scale is not None
    return np.asarray(2.0 * (scale - scale.min()) / np.ptp(scale) - 1.0)


@pytest.mark.parametrize("name", ["place", "time"])
def test_lost_motion_that_changes_is_not_one(name: str) -> None:
    where = field(SMALL, SLOW)
    changing = signal(where, BACKLASH) * (1.0 + 0.8 * along(where, name))
    one = uneven(where, BACKLASH, changing + noise_of(where, 3))
    assert one.p_value < 1e-6
    # what is left: the whitened squares of all that no curve and no one amplitude takes
    whole, change = (where.base.rest(where.whitening(it)) for it in (signal(where, BACKLASH), changing))
    change = change - whole * float(whole @ change) / float(whole @ whole)
    assert one.excess == pytest.approx(float(change @ change), rel=0.1)


@pytest.mark.parametrize("name", ["place", "time"])
def test_a_tenth_more_at_one_end_is_how_machines_are(name: str) -> None:
    where = field(SMALL, SLOW)
    changing = signal(where, BACKLASH) * (1.0 + 0.1 * along(where, name))
    assert uneven(where, BACKLASH, changing + noise_of(where, 3)).p_value > 1e-3


def test_a_drift_says_itself_how_it_changes() -> None:
    where = field(SMALL, SLOW)
    bent = signal(where, DRIFT) * (1.0 + 0.8 * along(where, "time"))
    assert uneven(where, DRIFT, bent + noise_of(where, 3)) == Uneven(1.0, 0.0)


def test_noise_is_no_change_of_an_amplitude() -> None:
    where = field(SMALL, SLOW)
    p = [uneven(where, BACKLASH, signal(where, BACKLASH) + noise_of(where, 300 + seed)).p_value for seed in range(40)]
    # times the number of tests, which are alike, and beside the tolerance: never more often small than by chance
    assert min(p) > 1e-3
    assert kstest(p, "uniform", alternative="greater").pvalue > 0.01
