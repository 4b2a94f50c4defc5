"""Greedy choice against brute force on small problems: covariances by inversion, every set tried."""

from collections.abc import Callable, Sequence
from itertools import combinations, pairwise

import numpy as np
import pytest

from trueaxis.measurement.machine import FloatArray
from trueaxis.planning.propose import Chosen, Offer, choose

N, OFFERS = 12, 9


def some(seed: int, shared: int = 3) -> tuple[FloatArray, FloatArray, list[Offer]]:
    draw = np.random.default_rng(seed)
    spread = draw.normal(size=(N, N)) / np.sqrt(N)
    target = draw.normal(size=(5, N))
    offers = [
        Offer(draw.normal(size=(int(draw.integers(1, 5)), N)), float(draw.uniform(1, 4)), ((k % shared, 10.0),))
        for k in range(OFFERS)
    ]
    return spread, target, offers


def variance(spread: FloatArray, target: FloatArray, rows: Sequence[FloatArray]) -> float:
    information = np.linalg.inv(spread @ spread.T) + sum((one.T @ one for one in rows), np.zeros((N, N)))
    return float(np.trace(target @ np.linalg.inv(information) @ target.T))


def at_most(count: int) -> Callable[[Sequence[Chosen]], float]:
    return lambda chosen: np.inf if len(chosen) < count else 0.0


def minutes(offers: Sequence[Offer], picked: Sequence[int]) -> float:
    keys = {key: taken for k in picked for key, taken in offers[k].shared}
    return sum(offers[k].minutes for k in picked) + sum(keys.values())


@pytest.mark.parametrize("seed", range(6))
def test_every_choice_falls_most_per_minute(seed: int) -> None:
    spread, target, offers = some(seed)
    chosen = choose(spread, target, offers, at_most(5))
    taken: list[int] = []
    for one in chosen:
        before = variance(spread, target, [offers[k].rows for k in taken])
        worth = {
            k: (before - variance(spread, target, [offers[j].rows for j in (*taken, k)]))
            / (minutes(offers, [*taken, k]) - minutes(offers, taken))
            for k in range(OFFERS)
            if k not in taken
        }
        assert max(worth, key=lambda k: worth[k]) == one.index
        assert one.minutes == pytest.approx(minutes(offers, [*taken, one.index]) - minutes(offers, taken))
        taken.append(one.index)
        assert one.u**2 == pytest.approx(variance(spread, target, [offers[k].rows for k in taken]), rel=1e-4)


def test_greedy_is_near_the_best_of_all_sets() -> None:
    """Of equally long runs, three of nine: the fall of the variance is at least 0.93 times the largest, 0.99 mostly."""
    shares = []
    for seed in range(20):
        spread, target, offers = some(seed)
        equal = [Offer(one.rows, 1.0, ()) for one in offers]
        before = variance(spread, target, [])
        best = min(variance(spread, target, [equal[k].rows for k in of]) for of in combinations(range(OFFERS), 3))
        shares.append((before - choose(spread, target, equal, at_most(3))[-1].u ** 2) / (before - best))
    assert max(shares) <= 1.0 + 1e-6
    assert min(shares) > 0.93
    assert np.median(shares) > 0.99


def test_the_budget_is_kept_and_used() -> None:
    spread, target, offers = some(3)

    def left(chosen: Sequence[Chosen]) -> float:
        return 30.0 - sum(one.minutes for one in chosen)

    chosen = choose(spread, target, offers, left)
    used = minutes(offers, [one.index for one in chosen])
    assert used == pytest.approx(sum(one.minutes for one in chosen))
    assert 15.0 < used <= 30.0


def test_what_is_set_up_takes_no_time_again() -> None:
    spread, target, offers = some(2)
    first = choose(spread, target, offers, at_most(1), there=[0, 1, 2])[0]
    assert first.minutes == offers[first.index].minutes


def test_it_stops_where_a_run_lowers_u_by_less_than_asked() -> None:
    spread, target, offers = some(5)
    whole = [
        float(np.sqrt(variance(spread, target, []))),
        *(one.u for one in choose(spread, target, offers, at_most(9))),
    ]
    chosen = choose(spread, target, offers, at_most(9), least_fall=0.05)
    falls = [
        1.0 - b / a for a, b in zip([whole[0], *(one.u for one in chosen)], [one.u for one in chosen], strict=False)
    ]
    assert 0 < len(chosen) < 9
    assert min(falls) >= 0.05 - 1e-6


def test_what_no_offer_tells_is_no_reason_to_stop() -> None:
    """A direction a thousand times as uncertain that no offer sees: the same choice as without it."""
    spread, target, offers = some(5)
    hidden = np.zeros((N + 1, N + 1))
    hidden[:N, :N], hidden[N, N] = spread, 1.0
    seen = [Offer(np.hstack([one.rows, np.zeros((one.rows.shape[0], 1))]), one.minutes, one.shared) for one in offers]
    wide = np.hstack([target, np.full((5, 1), 1000.0)])
    alone = choose(spread, target, offers, at_most(9), least_fall=0.05)
    beside = choose(hidden, wide, seen, at_most(9), least_fall=0.05)
    assert [one.index for one in beside] == [one.index for one in alone]
    assert beside[-1].u > 1000.0


def test_offers_that_tell_nothing_are_not_taken() -> None:
    spread, target, _ = some(1)
    assert (
        choose(spread, target, [Offer(np.zeros((0, N)), 1.0, ()), Offer(np.zeros((2, N)), 1.0, ())], at_most(2)) == []
    )
    assert choose(spread, target, [], at_most(2)) == []


def test_noise_far_below_the_prior_is_no_trouble() -> None:
    """A picometre beside a millimetre: variances of 1e-18 are not told from 0, and nothing overflows."""
    spread, target, offers = some(4)
    loud = [Offer(1e9 * one.rows, one.minutes, one.shared) for one in offers]
    chosen = choose(spread, target, loud, at_most(9))
    assert chosen[-1].u < 1e-3 * np.sqrt(variance(spread, target, []))
    assert all(b.u <= a.u * (1.0 + 1e-9) for a, b in pairwise(chosen))
