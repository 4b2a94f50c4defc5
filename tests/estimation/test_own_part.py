"""A run's own unknowns parted off, against dense matrices."""

import numpy as np
import pytest

from tests.estimation.test_effects import KNOWN
from tests.generator.dmu60p import cubic_errors
from tests.identification.data import dmu60p_model, mixed_data
from trueaxis.estimation import jacobian
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.own_part import by_shared, own_part, own_part_of
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import started


def test_the_rest_is_the_inverse_of_the_covariance() -> None:
    draw = np.random.default_rng(3)
    own, rows = draw.normal(size=(12, 3)) * [1.0, 1e-3, 1e2], draw.normal(size=(12, 4))
    part, inverse = own_part(own), np.linalg.inv(np.eye(12) + own @ own.T)
    np.testing.assert_allclose(part.rest(rows), inverse @ rows, atol=1e-9)
    np.testing.assert_allclose(part.root(part.root(rows)), part.rest(rows), atol=1e-12)
    np.testing.assert_allclose(part.rest(rows[:, 0]), part.rest(rows)[:, 0], atol=1e-15)


def test_pieces_make_no_difference(monkeypatch: pytest.MonkeyPatch) -> None:
    data, model = mixed_data(cubic_errors(), seed=5), dmu60p_model().with_values(KNOWN)
    layout = layout_of(model, data, KNOWN)
    state = started(layout, tuple(measured_runs(data)), KNOWN, {})
    sizes, columns = Sizes(layout, state.own_kinds), np.ones((state.runs[0].reading.size, 2))
    x = np.zeros(sizes.spread.size)
    rest = own_part_of(state, sizes, x, 0).rest(columns)
    whole = by_shared(state, 0, rest)
    monkeypatch.setattr(jacobian, "PIECE", 5 * layout.count)
    np.testing.assert_allclose(by_shared(state, 0, rest), whole, rtol=1e-9, atol=1e-12 * np.abs(whole).max())
    assert np.abs(rest[:, 0]).max() < 0.1 * np.abs(state.whitening(0, state.runs[0].kept())(columns)).max()
