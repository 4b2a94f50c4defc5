"""Runs that contradict the others: by the estimate from all of them, by one without them, and in data with a fault."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.worlds.estimates import World, world
from tests.worlds.machine import Array
from tests.worlds.readings import measure
from tests.worlds.truth import draw_machine
from trueaxis.estimation import estimate as room
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.fitted import Fitted
from trueaxis.estimation.left_out import _far, _Rows, beside_all, beside_others
from trueaxis.estimation.misread import SURE
from trueaxis.estimation.other_set_ups import _other_directions
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.steps import moved as moved_state
from trueaxis.estimation.wrong_runs import WrongRuns
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.measurement.setup import Device
from trueaxis.model.errors import ErrorValues

SEED, MACHINE = 9714, 9721  # 14 runs of few targets: half a second an estimate


@pytest.fixture(scope="module")
def bench(tmp_path_factory: pytest.TempPathFactory) -> tuple[World, Array]:
    one = world(SEED, tmp_path_factory.mktemp("left_out"))
    return one, measure(one.design, draw_machine(one.design.machine, MACHINE), MACHINE).reading


def _known(one: World) -> ErrorValues:
    return ErrorValues(
        machine=one.model.name, parameters={name: one.model.errors.parameters[name] for name in one.model.dimensions}
    )


def _estimated(one: World, reading: Array) -> Estimate:
    return estimate(one.model, replace(one.plan, reading=reading.copy()), _known(one))


def _swapped(one: World, reading: Array, pair: tuple[int, int]) -> Array:
    first, second = (np.flatnonzero(one.plan.run == run) for run in pair)
    found = reading.copy()
    found[first], found[second] = reading[second], reading[first]
    return found


def _kept(monkeypatch: pytest.MonkeyPatch) -> list[Fitted]:
    """What is fitted from now on, of which no run is judged."""
    kept: list[Fitted] = []

    def keep(_: object, fitted: Fitted, *__: object) -> WrongRuns:
        kept.append(fitted)
        return WrongRuns()

    monkeypatch.setattr(room, "wrong_runs", keep)
    return kept


def _pairs(one: World) -> list[tuple[int, int]]:
    """Lines of as many readings that sense different directions."""
    runs, counts = one.plan.runs, np.bincount(one.plan.run, minlength=len(one.plan.runs))
    lines = [k for k, run in enumerate(runs) if run.instrument == "laser" and counts[k]]
    return [
        (a, b)
        for a in lines
        for b in lines
        if a < b and counts[a] == counts[b] and runs[a].direction != runs[b].direction
    ]


def test_all_readings_say_of_a_run_what_the_others_say(
    bench: tuple[World, Array], monkeypatch: pytest.MonkeyPatch
) -> None:
    """P^-1 e is what the run differs by from an estimate without it, at the same sizes and noise."""
    one, reading = bench
    kept = _kept(monkeypatch)
    _estimated(one, reading)
    (fitted,) = kept
    state = fitted.state
    groups = [(run.rows.index,) for run in state.runs]
    together = beside_all(fitted, fitted.posterior(), groups)
    for place, run in enumerate(state.runs):
        chosen = [k for k in range(len(state.runs)) if k != place]
        rest = replace(
            state,
            runs=tuple(state.runs[k] for k in chosen),
            scales=state.scales[chosen],
            own=tuple(state.own[k] for k in chosen),
            residual=tuple(state.residual[k] for k in chosen),
            kept=tuple(state.kept[k] for k in chosen),
        )
        sizes = Sizes(state.layout, rest.own_kinds)
        values = dict(zip(fitted.sizes.names, fitted.x.tolist(), strict=True))
        others = Fitted(state=rest, sizes=sizes, x=np.array([values[name] for name in sizes.names]))
        expected = others.posterior()
        moved = replace(others, state=moved_state(rest, expected, sizes.own_scales(others.x)))
        alone = beside_others(moved, expected, [run], fitted.scales)
        assert together[run.rows.index,].times == pytest.approx(alone.times, rel=0.02)


@pytest.mark.parametrize(("times", "sure"), [(2.4, False), (5.0, True)])
def test_however_many_readings_the_form_of_noise_is_no_better_known(times: float, sure: bool) -> None:
    """Noise of a run is seen where no error could be; in 25 directions of errors it follows from its form. With a
    degree of freedom for each of 2000 readings, circles with play that is not quite of its form contradicted all.
    """
    none = np.zeros((25, 0))
    run = _Rows(own=none, others=none, sizes=np.zeros((0, 1)), left=np.full(25, times), noise=1.0, beside=0.0)
    far = _far([run], np.eye(25))
    assert far.times == pytest.approx(times)
    assert (far.log_p < -SURE) is sure


def test_readings_as_they_should_be_contradict_nothing(bench: tuple[World, Array]) -> None:
    one, reading = bench
    assert _estimated(one, reading).readings.contradicting == ()


@pytest.mark.slow
def test_a_run_that_alone_sees_curves_less_smooth_than_others_is_no_misfit(tmp_path: Path) -> None:
    """A probe along Z that alone tells EZB and EZC; data as they should be."""
    one = world(9009, tmp_path)
    reading = measure(one.design, draw_machine(one.design.machine, 9009), 9009).reading
    found = identify_estimated(one.model, replace(one.plan, reading=reading), IdentifyOptions(known=_known(one)))
    assert found.report.quality.fit.state == "converged"


def test_swapped_runs_are_named_and_decide(bench: tuple[World, Array]) -> None:
    one, reading = bench
    pairs = _pairs(one)
    for number in np.random.default_rng(3).choice(len(pairs), 3, replace=False).tolist():
        pair = pairs[number]
        swapped = replace(one.plan, reading=_swapped(one, reading, pair))
        found = identify_estimated(one.model, swapped, IdentifyOptions(known=_known(one)))
        quality = found.report.quality
        assert quality.fit.state == "misfit"
        assert set(quality.fit.runs) == {one.plan.runs[run].id for run in pair}
        assert "read as if each had the other's readings" in quality.reason


@pytest.mark.parametrize("line", ["X1", "YXs1", "DXY1"])
def test_a_run_along_another_direction_is_named_with_it(bench: tuple[World, Array], line: str) -> None:
    """A line, a straightness and a diagonal; they were called reversed, or swapped with runs of other targets."""
    one, reading = bench
    index = [run.id for run in one.plan.runs].index(line)
    right = one.plan.runs[index].direction
    assert right is not None
    x, y, z = right
    wrong = replace(one.plan.turned(index, (z, x, y)), reading=reading)
    quality = identify_estimated(one.model, wrong, IdentifyOptions(known=_known(one))).report.quality
    assert (quality.fit.state, quality.fit.runs) == ("misfit", (line,))
    along = ", ".join(f"{part:g}" for part in right)
    assert f"run {line} reads as if its direction were [{along}] (direction in setup.toml)" in quality.reason


@pytest.mark.parametrize("by_itself", [False, True])
def test_a_line_may_be_a_straightness_only_where_its_instrument_has_read_one(
    bench: tuple[World, Array], monkeypatch: pytest.MonkeyPatch, by_itself: bool
) -> None:
    """A line taken under compensation reads as little as a straightness, and was said to have sensed across."""
    one, reading = bench
    kept = _kept(monkeypatch)
    runs = one.plan.runs
    if by_itself:
        optics = Device(id="straightness")
        runs = tuple(replace(run, device=optics) if "s" in run.id else run for run in runs)
    estimate(one.model, replace(one.plan, runs=runs, reading=reading.copy()), _known(one))
    state = kept[0].state
    straight = [run.rows.run.id for run in state.runs if state.layout.straightness[run.rows.index]]
    assert straight
    assert all("s" in name for name in straight)
    line = next(run for run in state.runs if run.rows.run.id == "X1")
    directions = _other_directions(kept[0], line)
    across = [way for way in directions if abs(way[0]) < 1e-6]
    assert bool(across) is not by_itself


def test_a_zero_of_a_run_that_is_far_off_decides_nothing(bench: tuple[World, Array]) -> None:
    """It is an unknown of the instrument: the values hardly depend on it."""
    one, reading = bench
    line = next(k for k, run in enumerate(one.plan.runs) if run.instrument == "laser" and run.id.startswith("X"))
    shifted = reading + np.where(one.plan.run == line, 0.05, 0.0)
    found = identify_estimated(one.model, replace(one.plan, reading=shifted), IdentifyOptions(known=_known(one)))
    assert found.report.quality.fit.state == "converged"
