"""What setup.toml may have said of runs that are wrong: another's set-up, another direction, the other frame."""

from collections.abc import Collection, Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import cast

import numpy as np

from trueaxis.estimation.display import DECIMALS
from trueaxis.estimation.fitted import Fitted, Refit
from trueaxis.estimation.left_out import beside_others, widest
from trueaxis.estimation.misread import Misread
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.estimation.set_up import is_straightness, relative_motion, turned_about
from trueaxis.measurement.instrument_kinds import ANGLE
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import home_positions
from trueaxis.measurement.setup import Run, Vector
from trueaxis.model.model import MachineModel
from trueaxis.view import Frame, view_of

# Runs that are wrong, of which it is asked whose they are and along what, each at the cost of three estimates; and
# groups of runs of which it is asked in what frame they are, each at the cost of one
MOST_WRONG = 3
ABOUT = 0.5  # cosine of an angle up to which a rotation is about the sensed direction: others are across
ALONG = 1e-6  # sine of an angle up to which two directions are one
OTHER: dict[Frame, Frame] = {"bed": "workpiece", "workpiece": "bed"}


@dataclass(frozen=True, slots=True, eq=False)
class OtherSetUp:
    """observed: the readings with what setup.toml may have said; misread: the runs of which it would say it, by index,
    without odds; among: the number of such set-ups of which one at most is right.
    """

    observed: Observations
    misread: dict[int, Misread]
    among: int


def other_set_ups(
    fitted: Fitted, observed: Observations, wrong: Sequence[int], like_all: Collection[int], refit: Refit, sure: float
) -> Iterator[OtherSetUp]:
    """Of a few runs that are wrong, by index, the likely ones. None without a prior.

    Each with the run whose set-up explains its readings best, and with the direction that does, if noise allows as
    much, by an estimate without it; all runs of an instrument, or of one in a session, that are written in one frame
    with the other. What all runs of an instrument have is not the set-up of one.

    wrong: the worst first; like_all: that are wrong as all runs of their instrument are, by index; sure: minus the
    logarithm of the probability below which what is left is not noise.
    """
    if fitted.sizes.flat:
        return
    yield from _in_the_other_frame(fitted, observed, {*wrong, *like_all})
    pairs = set[tuple[int, int]]()
    for one in (run for run in fitted.state.runs if run.rows.index in wrong[:MOST_WRONG]):
        partners, directions = _partners(fitted, one), _other_directions(fitted, one)
        others = [run for run in fitted.state.runs if run is not one]
        told = one.noise_group in {run.noise_group for run in others}  # the noise of the run
        if not told or not (partners or directions):
            continue
        index = one.rows.index
        without, expected = widest(refit(others))
        scales = {run.rows.index: fitted.scales[index] for run in (one, *partners)}
        if partners:
            partner = max(partners, key=lambda run: _as_made_by(without, expected, one, run, scales))
            first, second = sorted((index, partner.rows.index))
            if (first, second) not in pairs:
                pairs.add((first, second))
                yield _exchanged(observed, first, second, len(partners))
        far = {way: beside_others(*_sensing(without, expected, one, way), scales) for way in directions}
        allowed = [way for way in directions if far[way].log_p > -sure]
        if allowed:
            best = max(allowed, key=lambda way: far[way].log_density)
            turned = Misread(how="turned", log_odds=0.0, direction=best)
            yield OtherSetUp(observed.turned(index, best), {index: turned}, len(directions))


def _exchanged(observed: Observations, first: int, second: int, among: int) -> OtherSetUp:
    """Positions go with the readings: other than where readings alone are in each other's place."""
    partner = {first: second, second: first}
    misread = {one: Misread(how="swapped", log_odds=0.0, partner=other) for one, other in partner.items()}
    return OtherSetUp(observed.exchanged(first, second), misread, among)


def _in_the_other_frame(fitted: Fitted, observed: Observations, wrong: set[int]) -> Iterator[OtherSetUp]:
    """Where that is another motion of the target: a workpiece that never moves stands in the bed's frame."""
    model = fitted.state.layout.model
    groups: dict[Hashable, list[MeasuredRun]] = {}
    for one in fitted.state.runs:
        run = one.rows.run
        if run.direction is not None:  # a distance has no frame
            for key in ((one.noise_group, run.frame), (one.noise_group, run.frame, run.session)):
                groups.setdefault(key, []).append(one)
    likely = {tuple(one.rows.index for one in group): group for group in groups.values()}
    tried = [group for indices, group in likely.items() if wrong & set(indices)]
    tried = [group for group in tried if any(_moves(model, one) for one in group)]
    for group in tried[:MOST_WRONG]:
        frame = OTHER[group[0].rows.run.frame]
        indices = tuple(one.rows.index for one in group)
        framed = Misread(how="framed", log_odds=0.0, together=indices, frame=frame)
        yield OtherSetUp(observed.framed(indices, frame), dict.fromkeys(indices, framed), len(tried))


def _moves(model: MachineModel, one: MeasuredRun) -> bool:
    """Whether the workpiece moves in a run or has since its home."""
    run, origin = one.rows.run, np.zeros((3, 1))
    positions = np.hstack([cast(FloatArray, home_positions(run, model.axes)), one.rows.positions])
    return bool(np.ptp(model.view_ideal(view_of("workpiece", "bed"), positions, origin), axis=1).any())


def _partners(fitted: Fitted, one: MeasuredRun) -> list[MeasuredRun]:
    """Runs of its device by whose set-up a run may have been made."""
    read = _kinds_read(fitted, one.noise_group)
    return [
        run
        for run in fitted.state.runs
        if run is not one
        and run.noise_group == one.noise_group
        and run.rows.run != one.rows.run
        and _kind(fitted.state.layout.model, run.rows.run, one.rows.positions) in read
    ]


def _as_made_by(
    without: Fitted, expected: Posterior, one: MeasuredRun, other: MeasuredRun, scales: Mapping[int, float]
) -> float:
    """Logarithm of the probability that the readings of a run are as far by the set-up of another."""
    there = replace(one, rows=replace(one.rows, run=other.rows.run, index=other.rows.index))
    return beside_others(without, expected, [there], scales).log_p


def _other_directions(fitted: Fitted, one: MeasuredRun) -> list[Vector]:
    """Along the axes of the measuring frame and along the motion, both ways; not its own, nor the opposite of that,
    which is its sign. None of a display that never moved, which says nothing of a direction.
    """
    own = one.rows.run.direction
    if own is None or np.ptp(one.reading) <= 10.0**-DECIMALS:
        return []
    moved = relative_motion(fitted.state.layout.model, one.rows.run, one.rows.positions)
    along = np.linalg.svd(moved, full_matrices=False)[0][:, 0]
    axes = [*np.eye(3), *([along] if moved.any() and np.abs(along).max() < 1.0 - ALONG else [])]
    others = [axis for axis in axes if np.linalg.norm(np.cross(axis, own)) > ALONG]
    both_ways = (one for axis in others for one in (axis + 0.0, 0.0 - axis))  # no zero with a sign
    found: list[Vector] = [(float(x), float(y), float(z)) for x, y, z in both_ways]
    model, run, read = fitted.state.layout.model, one.rows.run, _kinds_read(fitted, one.noise_group)
    return [way for way in found if _kind(model, replace(run, direction=way), one.rows.positions) in read]


def _kinds_read(fitted: Fitted, noise_group: str) -> set[tuple[bool, bool]]:
    """See `_kind`: what an instrument has read, in the runs as they are written. A run may have been made by another
    set-up of such a kind alone: a curve of straightness that no other run tells would take up whatever is wrong.
    """
    mine = [run.rows for run in fitted.state.runs if run.noise_group == noise_group]
    return {_kind(fitted.state.layout.model, rows.run, rows.positions) for rows in mine}


def _kind(model: MachineModel, run: Run, positions: FloatArray) -> tuple[bool, bool]:
    """Whether it reads a straightness, and whether the angle that a rotary axis is turned by."""
    angle = False
    if run.instrument == ANGLE and run.direction is not None:
        angle = abs(float(np.array(run.direction) @ turned_about(model, run, positions))) > ABOUT
    return is_straightness(model, run, positions), angle


def _sensing(
    without: Fitted, expected: Posterior, one: MeasuredRun, direction: Vector
) -> tuple[Fitted, Posterior, list[MeasuredRun]]:
    """A run as if it had sensed in another direction, and the estimate by whose layout it is then of straightness or
    not.
    """
    layout, rows = without.state.layout, one.rows
    run = replace(rows.run, direction=direction)
    straight = list(layout.straightness)
    straight[rows.index] = is_straightness(layout.model, run, rows.positions)
    state = replace(without.state, layout=replace(layout, straightness=tuple(straight)))
    return replace(without, state=state), expected, [replace(one, rows=replace(rows, run=run))]
