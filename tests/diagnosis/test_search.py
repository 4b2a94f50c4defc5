"""The search: what a further cause needs, what is left without one, by what candidates are compared."""

from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pytest
from scipy.stats import chi2

from tests.diagnosis.prepared import SIGMA, field, prepared
from tests.hidden_effects.case import Case
from trueaxis.diagnosis.causes import scan
from trueaxis.diagnosis.causes.prepared import inner_of
from trueaxis.diagnosis.causes.prepared import prepared as prepare
from trueaxis.diagnosis.causes.search import Ground, search, without
from trueaxis.diagnosis.causes.signatures import parameter_signature, signature_of
from trueaxis.diagnosis.null_model.rows import rows_of
from trueaxis.effects.kind import Effect

FloatArray = npt.NDArray[np.float64]
X, Y, Z = (Effect(kind="backlash", component=name) for name in ("EXX", "EYY", "EZZ"))


def signal(effect: Effect, evidence: float) -> FloatArray:
    """(n,), mm: so large that it has about this evidence where the noise is SIGMA."""
    where = field()
    column = parameter_signature(where.readings, effect, np.ones(1))[0]
    size = np.linalg.norm(where.base.rest(where.whitening(column)))
    return np.asarray(column * np.sqrt(chi2.isf(10.0**-evidence, 1)) / size)


def ground(*parts: FloatArray) -> Ground:
    """Without noise: what is found is what was put in."""
    return field().ground(np.sum(parts, axis=0))


@pytest.mark.parametrize(("beyond", "alone", "further"), [(-0.5, False, False), (1.0, True, False), (3.0, True, True)])
def test_a_further_cause_needs_two_decades_more(beyond: float, alone: bool, further: bool) -> None:
    threshold = ground(signal(X, 1.0)).threshold
    weak = signal(Y, threshold + beyond)
    assert (Y in [one.scan.effect for one in search(ground(weak)).causes]) is alone
    strong = signal(X, threshold + 60.0)
    assert [one.scan.effect for one in search(ground(strong, weak)).causes] == ([X, Y] if further else [X])


def test_threshold_is_that_of_all_candidates() -> None:
    found = ground(signal(X, 1.0))
    assert found.threshold == pytest.approx(np.log10(len(found.effects) / 1e-4))


def test_without_one_cause_the_others_stay_and_its_part_is_left() -> None:
    parts = [signal(effect, evidence) for effect, evidence in ((X, 160.0), (Y, 100.0), (Z, 90.0))]
    found = search(ground(*parts))
    assert [one.scan.effect for one in found.causes] == [X, Y, Z]
    assert np.linalg.norm(found.residual) < 1e-6
    left = without(ground(*parts), found, 1)
    assert [one.scan.effect for one in left.causes] == [X, Z]
    assert left.first is found.first
    expected = search(ground(parts[0], parts[2])).projection.rest(field().whitening(parts[1]))
    assert left.residual == pytest.approx(expected, abs=1e-6)
    assert float(left.residual @ left.residual) > 100.0


def test_candidates_are_compared_as_if_the_noise_were_known() -> None:
    """Evidence falls where few runs tell the noise; preference, by which two candidates are weighed, does not."""
    where = field()
    values = where.whitening(signal(X, 30.0))
    signature = signature_of(where.readings, X)
    known = prepare(signature, inner_of(where.whitening, where.base))
    found = {}
    for freedom in (1e6, 12.0):
        vague = replace(where.freedom, of_rows=np.full(values.size, freedom))
        found[freedom] = scan.scanned(signature, known, scan.residual_of(where.whitening, where.base, values, vague))
    assert found[12.0].preference == found[1e6].preference == pytest.approx(30.0, abs=1e-3)
    assert found[12.0].evidence < 0.5 * found[1e6].evidence


class TestUnknownDirections:
    def test_a_run_whose_directions_nobody_knows_is_kept(self) -> None:
        data = prepared(Case(seed=1, noise="none", given="exact")).data
        run = next(k for k, one in enumerate(data.setup.runs) if one.instrument == "laser")
        directions = data.readings.directions.copy()
        directions[:, data.readings.run == run] = 0
        found = rows_of(replace(data, readings=replace(data.readings, directions=directions)))
        assert (found.run == run).sum() == (data.readings.run == run).sum()
        assert not found.directions[:, found.run == run].any()

    def test_single_readings_that_come_from_nowhere_are_left_out(self) -> None:
        data = prepared(Case(seed=1, noise="none", given="exact")).data
        run = next(k for k, one in enumerate(data.setup.runs) if one.instrument == "laser")
        mine = np.flatnonzero(data.readings.run == run)
        known = rows_of(data)
        directions = data.readings.directions.copy()
        directions[:, mine[5]] = 0
        found = rows_of(replace(data, readings=replace(data.readings, directions=directions)))
        assert mine[5] in known.row
        assert set(known.row) - set(found.row) == {mine[5]}


def test_noise_alone_names_nothing() -> None:
    noise = SIGMA * np.random.default_rng(3).standard_normal(field().readings.rows.size)
    assert search(ground(noise)).causes == ()
