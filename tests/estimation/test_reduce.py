"""What readings say does not depend on the way it is written down: by places, by pieces, kept or computed anew."""

from dataclasses import replace

import numpy as np
import pytest

from tests.estimation.test_steps import GIVEN, begun
from tests.generator.dmu60p import cubic_errors
from tests.identification.data import mixed_data
from trueaxis.estimation import jacobian
from trueaxis.estimation import state as estimation_state
from trueaxis.estimation.evidence import posterior_at
from trueaxis.estimation.noise import Noise
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import State, linearised, started, with_noise
from trueaxis.measurement.machine import FloatArray


def repeated(data: Observations, times: int) -> Observations:
    """Every row as often, one cycle after another."""
    draw = np.random.default_rng(7)
    reading = np.tile(data.reading, times)
    return replace(
        data,
        run=np.tile(data.run, times),
        positions=np.tile(data.positions, times),
        reading=reading + 1e-4 * draw.standard_normal(reading.size),
    )


@pytest.fixture(scope="module")
def state() -> State:
    """Slow noise, outliers left out, every place read three times."""
    found, _, _ = begun(repeated(mixed_data(cubic_errors(), 3, seed=2), 3), GIVEN)
    good = [np.arange(one.reading.size) % 17 != 5 for one in found.runs]
    return replace(
        found,
        noise={name: Noise(0.8, 0.6, 5.0) for name in found.noise},
        runs=tuple(replace(one, good=of) for one, of in zip(found.runs, good, strict=True)),
    )


def said(state: State) -> Posterior:
    sizes = Sizes(state.layout, state.own_kinds)
    return posterior_at(sizes, linearised(state), np.zeros(sizes.spread.size))


def whitened(state: State) -> tuple[list[FloatArray], list[FloatArray]]:
    """Columns and readings of every run, written down reading by reading."""
    columns, readings = [], []
    for place, one in enumerate(state.runs):
        parts = [(own, others) for _, own, others in jacobian.pieces(state.layout, one.rows)]
        own, others = (np.vstack(part) for part in zip(*parts, strict=True))
        white = state.whitening(place, one.kept())(np.column_stack([own, others, state.residual[place]])[one.good])
        columns.append(white[:, :-1])
        readings.append(white[:, -1])
    return columns, readings


def test_places_say_what_readings_say(state: State) -> None:
    """Against one least-squares problem of all readings and all unknowns, those of single runs in columns of theirs."""
    assert all(part.others.shape[0] < part.place.size for one in state.kept for part in one)
    columns, readings = whitened(state)
    n, kinds = state.layout.count, state.own_kinds
    sizes = Sizes(state.layout, kinds)
    x = np.zeros(sizes.spread.size)
    first = n + np.cumsum([0, *map(len, kinds)])
    whole = np.zeros((sum(map(len, readings)) + first[-1], first[-1]))
    start = 0
    for white, of_run, at in zip(columns, kinds, first, strict=False):
        rows = slice(start, start + white.shape[0])
        whole[rows, :n], whole[rows, at : at + len(of_run)] = white[:, len(of_run) :], white[:, : len(of_run)]
        start = rows.stop
    scale = np.concatenate([np.exp(sizes.scale(x)[0]), *sizes.own_scales(x)])
    whole[:start] *= scale
    whole[start:] = np.eye(first[-1])
    expected = np.linalg.lstsq(whole, np.concatenate([*readings, np.zeros(first[-1])]), rcond=None)[0] * scale
    found = said(state)
    u = np.linalg.norm(found.spread, axis=1)
    np.testing.assert_allclose(found.mean / u, expected[:n] / u, atol=1e-8)
    covariance = np.linalg.inv(np.linalg.qr(whole, mode="r")) * scale[:, np.newaxis]
    np.testing.assert_allclose(u, np.linalg.norm(covariance, axis=1)[:n], rtol=1e-8)
    for one, at in zip(found.own, first, strict=False):
        np.testing.assert_allclose(one.mean / scale[at], expected[at : at + one.mean.size] / scale[at], atol=1e-7)


def test_pieces_of_a_run_share_what_is_few(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where all derivatives are kept, runs in pieces are folded by as few columns as a run in one."""
    before = said(state)
    monkeypatch.setattr(jacobian, "PIECE", 2000)
    parts = [tuple(jacobian.derivatives(state.layout, one.rows)) for one in state.runs]
    assert max(map(len, parts)) > 2
    again = replace(state, kept=tuple(map(jacobian.with_common_few, parts)))
    for one, whole in zip(again.kept, state.kept, strict=True):
        assert all(part.others is one[0].others for part in one)
        assert one[0].others.shape[0] <= whole[0].others.shape[0] + 1  # but for rounding
    after = said(again)
    u = np.linalg.norm(before.spread, axis=1)
    np.testing.assert_allclose(after.mean / u, before.mean / u, atol=1e-8)
    np.testing.assert_allclose(np.linalg.norm(after.spread, axis=1), u, rtol=1e-8)


def test_what_takes_too_much_memory_is_not_kept(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    entries = sum(part.own.size + part.few.size + part.others.size for one in state.kept for part in one)
    again = [replace(one, good=np.ones(one.reading.size, dtype=bool)) for one in state.runs]
    for most, kept in ((entries, True), (entries - 1, False)):
        monkeypatch.setattr(estimation_state, "KEPT", most)
        assert bool(started(state.layout, tuple(again), state.given, {}).kept) is kept


@pytest.mark.parametrize("piece", [2000, jacobian.PIECE])
def test_nothing_is_lost_where_derivatives_are_not_kept(
    state: State, piece: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = said(state)
    monkeypatch.setattr(jacobian, "PIECE", piece)  # one: as kept; the other: runs in pieces, row by row
    again = replace(state, kept=())
    assert max(sum(1 for _ in again.derivatives(place)) for place in range(len(state.runs))) > (piece == 2000)
    after = said(again)
    u = np.linalg.norm(before.spread, axis=1)
    np.testing.assert_allclose(after.mean / u, before.mean / u, atol=1e-8)
    np.testing.assert_allclose(np.linalg.norm(after.spread, axis=1), u, rtol=1e-8)
    unstated = [replace(one, stated=frozenset()) for one in (state, again)]
    found = [with_noise(one, before, np.random.default_rng(1)) for one in unstated]
    for name, noise in found[0].noise.items():
        assert found[1].noise[name].sigma == pytest.approx(noise.sigma, rel=1e-9)
