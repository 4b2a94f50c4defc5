"""What readings tell of causes once a set-up is left out, beside a fit of the others by themselves."""

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.judging.carried import told_without
from trueaxis.diagnosis.judging.misfit import groups_of
from trueaxis.diagnosis.null_model.null import Null
from trueaxis.diagnosis.null_model.outliers import null_of
from trueaxis.diagnosis.result import BoolArray, FloatArray


def test_it_is_what_a_fit_of_the_others_leaves() -> None:
    case = prepared(
        Case(seed=1, design=Design(lines=2, repeats=2, targets=11, samples=24), noise="none", given="exact")
    )
    source = np.random.default_rng(5)
    null = null_of(case.model, case.rows, SIGMA * source.standard_normal(case.rows.size), None)
    signals, groups = 1e-3 * source.standard_normal((null.rows.size, 3)), groups_of(null)
    first = np.isin(null.rows.run, [null.base.runs[place].rows.index for place in groups[0]])
    signals[~first, 0] = 0.0  # told by one set-up alone
    whole, each = told_without(null, signals, groups)
    assert whole == pytest.approx(_fitted(np.ones(null.rows.size, dtype=bool), null, signals), rel=1e-6)
    for group, told in zip(groups, each, strict=True):
        mine = np.isin(null.rows.run, [null.base.runs[place].rows.index for place in group])
        assert told == pytest.approx(_fitted(~mine, null, signals), rel=1e-6, abs=1e-6 * whole.max())
    assert each[0][0] < 1e-6 * whole[0]


def _fitted(kept: BoolArray, null: Null, signals: FloatArray) -> FloatArray:
    """(k,): least squares of some readings, base, other signals and what varies by chance as columns."""
    some = null.only(kept)
    white = some.whitening
    columns = white(np.hstack([some.base.columns.dense(), some.base.by_chance]))
    chance = some.base.by_chance.shape[1]
    expected = np.zeros((chance, columns.shape[1]))
    expected[:, columns.shape[1] - chance :] = np.eye(chance)
    found = []
    for k in range(signals.shape[1]):
        others = np.vstack([white(np.delete(signals[kept], k, axis=1)), np.zeros((chance, signals.shape[1] - 1))])
        design = np.hstack([np.vstack([columns, expected]), others])
        values = np.concatenate([white(signals[kept][:, k]), np.zeros(chance)])
        design = design / np.maximum(np.linalg.norm(design, axis=0), 1e-300)
        rest = values - design @ np.linalg.lstsq(design, values, rcond=1e-9)[0]
        found.append(float(rest @ rest))
    return np.array(found)
