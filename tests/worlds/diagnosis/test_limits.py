"""Limits by brute force, by the shop's own noise and by what sizes come to."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from numpy.polynomial import legendre
from scipy.linalg import cholesky, solve_triangular

from tests.hidden_effects.power.grade import Name
from tests.worlds.design import Design
from tests.worlds.diagnosis.cases import Bench, Case, bench_of, draw_case
from tests.worlds.diagnosis.library import SEARCHED, Candidate, candidates, fine
from tests.worlds.diagnosis.limits import CONFOUNDED, DEGREE, DETECTION, ISOLATION, RANK, _lasting, limit_of
from tests.worlds.diagnosis.signatures import is_curve, largest, pitch_of, signature
from tests.worlds.effects import Effect
from tests.worlds.machine import Array, Indices
from tests.worlds.readings import exact_readings, measure_all
from tests.worlds.shop import every_unknown
from tests.worlds.truth import draw_machine, span_of

SMALL = 5006  # 456 readings of lines and circles
SEEDS = (5006, 5008)


@cache
def bench(seed: int = SMALL) -> Bench:
    return bench_of(seed)


def flat_columns(design: Design) -> Array:
    """Everything flat, dense and unwhitened, (n, p)."""
    jac, blocks = design.jacobian, []
    for name in design.machine.components:
        scaled = span_of(design.machine, name[2]).scaled
        values = legendre.legvander(scaled(jac.at[name[2]]), DEGREE)[:, 1:]
        at_home = legendre.legvander(scaled(jac.at_home[name[2]]), DEGREE)[:, 1:]
        blocks.append(jac.here[name][:, None] * values - jac.home[name][:, None] * at_home)
    blocks += [jac.located[name][:, None] for name in design.machine.locations]
    warm = tuple(unknown for unknown in design.shop.unknowns if unknown.kind == "warm_bar")
    for index, run in enumerate(design.plan.runs):
        if run.instrument == "ballbar":
            blocks.append((design.plan.run == index)[:, None].astype(float))
    for unknown in (*every_unknown(design.machine, design.plan), *warm):
        column = np.zeros((design.plan.count, 1))
        column[unknown.rows, 0] = unknown.column
        blocks.append(column)
    return np.hstack(blocks)


def whitened(design: Design, values: Array) -> Array:
    """(n,) or (n, k), by one dense covariance matrix; outliers left out."""
    low, good = factor(design.seed)
    return np.asarray(solve_triangular(low, values[good], lower=True), float)


@cache
def factor(seed: int) -> tuple[Array, Indices]:
    design = bench(seed).design
    plan, shop = design.plan, design.shop
    covariance = np.zeros((plan.count, plan.count))
    for index in range(len(plan.runs)):
        rows = plan.rows(index)
        covariance[np.ix_(rows, rows)] = shop.covariance(plan, index)
    for unknown in shop.unknowns:
        if unknown.kind == "creep":
            part = np.ix_(unknown.rows, unknown.rows)
            covariance[part] += unknown.spread**2 * np.outer(unknown.column, unknown.column)
    good = np.setdiff1d(np.arange(plan.count), shop.outliers)
    return cholesky(covariance[np.ix_(good, good)], lower=True), good


@cache
def flat_by_hand(seed: int) -> Array:
    """Orthonormal basis of what is flat."""
    columns = whitened(bench(seed).design, flat_columns(bench(seed).design))
    size = np.linalg.norm(columns, axis=0)
    u, s, _ = np.linalg.svd(columns[:, size > 0] / size[size > 0], full_matrices=False)
    return np.asarray(u[:, s > RANK * s[0]], float)


def left_by_hand(design: Design, values: Array) -> Array:
    white, basis = whitened(design, values), flat_by_hand(design.seed)
    return white - basis @ (basis.T @ white)


@pytest.mark.parametrize(
    "effect",
    [
        Effect("backlash", "EXY", 1e-3, shape=1),
        Effect("servo_lag", "EXX", 1e-4),
        Effect("reversal_spike", "EYY", 1e-2, shape=4),
    ],
    ids=lambda effect: effect.kind,
)
def test_strength_and_nearest_rival_are_those_of_a_dense_fit(effect: Effect) -> None:
    design = bench().design
    shown = signature(design, draw_machine(design.machine, 1), effect)
    name = Name(effect.kind, effect.component, effect.axis)
    found = limit_of(bench().flat, shown, name)
    left = left_by_hand(design, shown)
    assert found.strength == pytest.approx(float(left @ left), rel=0.02)
    own, _ = best_by_hand(left, [one for one in candidates(design, fine(name, 0.0)) if one.name == name])
    assert found.own == pytest.approx(own, abs=0.02)
    others = {one.name for one in candidates(design) if one.name.kind in SEARCHED} - {name}
    finely = [
        each for other in others if other.component == name.component for each in candidates(design, fine(other, 0.0))
    ]
    every = [*(one for one in candidates(design) if one.name != name), *finely]
    r2, _ = best_by_hand(left, every)
    assert found.r2 == pytest.approx(r2 / own, abs=0.02)
    # figures: to where the two decompositions draw the line at directions that hardly show
    assert best_by_hand(left, [one for one in every if one.name == found.rival])[0] == pytest.approx(r2, abs=0.02)
    assert found.detection == pytest.approx(np.sqrt(DETECTION / (found.strength * own)), rel=0.02)
    assert found.isolation == pytest.approx(np.sqrt(ISOLATION / (found.strength * (own - r2))), rel=0.05)


def best_by_hand(left: Array, some: list[Candidate]) -> tuple[float, Name]:
    """Share of a signature that the best of some candidates explains, and that one."""
    design, found = bench().design, []
    for one in some:
        rest = left_by_hand(design, one.columns)
        if np.sum(rest**2) > 1e-5 * np.sum(whitened(design, one.columns) ** 2):
            fitted = rest @ np.linalg.lstsq(rest, left, rcond=1e-9)[0]
            found.append((float(fitted @ fitted) / float(left @ left), one.name))
    return max(found)


@pytest.mark.parametrize("seed", SEEDS)
def test_nothing_but_noise_is_left_of_clean_readings(seed: int) -> None:
    """Curves that are polynomials of DEGREE, unknowns of instruments and displays are all taken away; what is left is
    white, and of unit size.
    """
    design, ground = bench(seed).design, bench(seed).flat
    truths = [draw_machine(design.machine, number, curves="prior") for number in range(6)]
    sets = measure_all(design, truths, range(100, 106))
    left = [ground.rest(ground.white(data.reading - design.jacobian.ideal)) for data in sets]
    freedom = len(left[0]) - ground.q.shape[1] - sum(one.own.shape[1] for one in ground.runs)
    squares = np.array([float(np.sum(one**2)) for one in left])
    assert np.mean(squares) == pytest.approx(freedom, rel=0.03 + 4 * np.sqrt(2 / freedom / len(sets)))


def test_what_two_neighbours_of_a_run_alone_show_does_not_last() -> None:
    ground = bench().flat
    spike, step = np.zeros((2, len(ground.q)))
    spike[3:5], step[: len(ground.runs[0].rows)] = (1.0, -2.0), 1.0
    assert _lasting(ground, spike) == 0.0
    assert _lasting(ground, step) == pytest.approx(1.0 - 2.0 / len(ground.runs[0].rows))


def test_an_effect_that_curves_imitate_is_absorbed() -> None:
    design = bench().design
    jac, span = design.jacobian, span_of(design.machine, "X")
    bow = jac.here["EYX"] * span.scaled(jac.at["X"]) ** 2 - jac.home["EYX"] * span.scaled(jac.at_home["X"]) ** 2
    assert limit_of(bench().flat, bow, Name("")).strength == 0.0
    assert limit_of(bench().flat, bow, Name("")).detection == np.inf


def cases(count: int, only: tuple[str, ...] = ()) -> list[Case]:
    return [draw_case(bench(seed), number, only) for seed in SEEDS for number in range(count)]


def test_sizes_are_multiples_of_limits_and_none_is_unheard_of() -> None:
    for case in cases(4, ("effect", "two", "outside")):
        for one in case.hidden:
            assert abs(one.effect.size) <= largest(one.effect) * (1 + 1e-9)
            if one.state not in ("isolable", "confounded"):
                continue
            ground = bench(case.world).flat if not case.left_out else bench(case.world).without(case.left_out[0])
            shown = signature(bench(case.world).design, case.truth, one.effect)
            left = ground.left_of(shown)
            over = (abs(one.effect.size) / one.detection) ** (4 if one.effect.kind == "laser_cosine" else 2)
            assert one.own * float(left @ left) == pytest.approx(DETECTION * over, rel=0.05)
            assert (one.r2 > CONFOUNDED) == (one.state == "confounded")
            assert pitch_of(one.effect) >= 0.0


def test_a_case_is_the_same_each_time() -> None:
    one, other = draw_case(bench(), 3), draw_case(bench_of(SMALL), 3)
    assert (one.kind, one.hidden, one.wear, one.given) == (other.kind, other.hidden, other.wear, other.given)
    first, second = (exact_readings(bench().design, [case.truth]) for case in (one, other))
    assert np.array_equal(first, second)


def test_given_values_are_stale_by_as_much_as_is_said() -> None:
    for case in cases(4, ("stale",)):
        assert case.wear is not None
        assert case.wear.sigma > 0.0
        assert case.wear.component in bench(case.world).design.machine.components


def test_one_way_a_worn_spot_is_a_curve_and_both_ways_it_is_none() -> None:
    design = bench().design
    component = next(name for name in design.machine.components if name[2] == "X" and name[1] == "X")
    seen = design.jacobian.here[component] != 0.0
    assert np.unique(design.plan.directions["X"][seen]).size > 1
    one_way = {axis: np.abs(ways) for axis, ways in design.plan.directions.items()}
    other = replace(design, plan=replace(design.plan, directions=one_way))
    bump, warm = Effect("local_bump", component, shape=3), Effect("warm_lost_motion", component, shape=3)
    assert [is_curve(one, bump) for one in (design, other)] == [False, True]
    assert not is_curve(other, warm)  # it changes with the temperature
