"""What the control will execute: positions named by words, and the programmed positions they stand for."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import columns_of
from trueaxis.compensation.course import of_points
from trueaxis.compensation.lattice import Lattice, Stretch, inside_travel
from trueaxis.compensation.machine import ErrorModel, FloatArray, linear_jacobian, linear_rows, rotary_rows
from trueaxis.compensation.path import Held, Path, standing
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.solve import Solution
from trueaxis.compensation.word_choice import Passage, choose, passages, passages_allowed

SAME_TURN = 1e-9  # deg: less is no turn but the rounding of sums


@dataclass(frozen=True, slots=True, kw_only=True)
class Executed:
    """Ends of the blocks to be written, in order.

    positions: (n_axes, n), mm and deg, on the lattice of the words. reference: (n_axes, n), programmed positions that
    they stand for. point: (n,), index of the path's point. passed: (n,), true for the second end of a short block, in
    whose middle the path's point is passed (see middles). beyond: (n_axes, n), by how much the compensated position
    lies beyond the end of the travel, at which the word stops.
    """

    positions: FloatArray
    reference: FloatArray
    point: NDArray[np.int64]
    passed: NDArray[np.bool_]
    beyond: FloatArray

    @property
    def stopped(self) -> NDArray[np.bool_]:
        """(n,): where a word stops at the end of the travel."""
        return np.asarray(self.beyond.any(axis=0))

    def at_points(self, previous: FloatArray) -> FloatArray:
        """Positions (n_axes, n_points) where the path's points are reached or passed."""
        if not self.passed.any():
            return self.positions
        before = np.concatenate([previous[:, None], self.positions[:, :-1]], axis=1)
        there = np.where(self.passed, 0.5 * (before + self.positions), self.positions)
        last = np.append(np.diff(self.point) > 0, True)
        return columns_of(there, last)


def execute(
    stretch: Stretch,
    previous: FloatArray,
    path: Path,
    solution: Solution,
    passable: NDArray[np.bool_],
    model: ErrorModel,
    tool_point: FloatArray,
    settings: Settings,
    held: Held,
    unplaced: NDArray[np.bool_],
) -> Executed:
    """Choose the words of one stretch; `previous` (n_axes,) is the position named by the words before it.

    held: (n_axes, n_points), axes that get no word. No word names a position outside the travel; unplaced: (n_points,),
    those of which that is not known.
    """
    held = held[:, stretch.first : stretch.last]
    chosen = _chosen(stretch, previous, path, solution, passable, model, tool_point, settings, held)
    base = stretch.base(previous)
    inside = inside_travel(
        chosen.positions, Lattice(base[:, None], stretch.step), model, tool_point, unplaced[chosen.point]
    )
    held_now = columns_of(held, chosen.point - stretch.first)
    beyond = np.where(held_now, 0.0, chosen.positions - inside)
    return replace(chosen, positions=standing(inside, held_now, previous), beyond=beyond)


def _chosen(
    stretch: Stretch,
    previous: FloatArray,
    path: Path,
    solution: Solution,
    passable: NDArray[np.bool_],
    model: ErrorModel,
    tool_point: FloatArray,
    settings: Settings,
    held: Held,
) -> Executed:
    part = slice(stretch.first, stretch.last)
    model = of_points(model, part)
    base = stretch.base(previous)
    lattice = Lattice(base[:, None], stretch.step)
    commands, target = solution.commands[:, part], solution.target[:, part]
    near = lattice.nearest(commands)
    point = np.arange(stretch.first, stretch.last)
    programmed = path.points[:, part]
    none = np.zeros(point.size, dtype=bool)
    plain = Executed(positions=near, reference=programmed, point=point, passed=none, beyond=np.zeros_like(near))
    free = ~held.any(axis=0)
    if settings.words == "nearest" or settings.ball is None:
        return plain
    rows = list(linear_rows(model.axes))
    ball = np.array(settings.ball)[:, None]
    limit = float(stretch.step[rows].max())
    jacobian = linear_jacobian(model, commands, tool_point)

    def error(positions: FloatArray, index: NDArray[np.int64]) -> FloatArray:
        actual = model.ideal(positions, tool_point) + of_points(model, index).deviation(positions, tool_point)
        return np.asarray(actual - target[:, index])

    moves = jacobian * stretch.step[rows][None, :, :]
    chosen, _ = choose(error(near, point - stretch.first), target, ball, moves, 1, limit)
    near[rows] += stretch.step[rows] * chosen[:, 0] * free
    if settings.words == "ends":
        return plain

    rotary = list(rotary_rows(model.axes))
    still = _still(near[rotary])
    fed = ~path.rapid[part]
    fed[:-1] &= fed[1:]
    allowed, direction, half = passages_allowed(
        commands[rows], passable[part] & fed & free, still, float(stretch.step[rows].max())
    )
    index = np.flatnonzero(allowed)
    if index.size == 0:
        return plain
    on_half = commands[:, index].copy()
    on_half[rotary] = near[rotary][:, index]
    on_half[rows] = Lattice(lattice.base[rows], lattice.step[rows]).nearest(commands[rows][:, index], 2)
    passage = passages(
        commands[rows][:, index], error(on_half, index), target[:, index], ball, jacobian[:, :, index],
        direction[:, index], half[index], Lattice(lattice.base[rows], lattice.step[rows]), limit,
    )  # fmt: skip
    return _passing(plain, passage, index, rows, direction)


def _still(rotary: FloatArray) -> NDArray[np.bool_]:
    """Where no rotary axis, (n_rotary, n), turns before or behind a point."""
    still = np.ones(rotary.shape[1], dtype=bool)
    if rotary.size:
        stands = np.abs(np.diff(rotary, axis=1)).max(axis=0) < SAME_TURN
        still[1:] &= stands
        still[:-1] &= stands
    return still


def _passing(
    plain: Executed, passage: Passage, index: NDArray[np.int64], rows: list[int], direction: FloatArray
) -> Executed:
    """Short blocks in place of the points, with these indices, that can be passed in their middle.

    rows: of the linear axes; direction: (3, n), of the feed at every point.
    """
    kept = passage.possible
    index = index[kept]
    twice = np.ones(plain.point.size, dtype=np.int64)
    twice[index] = 2
    source = np.repeat(np.arange(plain.point.size), twice)
    second = np.cumsum(twice) - 1
    positions, reference = plain.positions[:, source], plain.reference[:, source]
    passed = np.zeros(source.size, dtype=bool)
    passed[second[index]] = True
    for column, ends, way in (
        (second[index] - 1, passage.before, passage.way_before),
        (second[index], passage.after, passage.way_after),
    ):
        for row, linear in enumerate(rows):
            positions[linear, column] = ends[row, kept]
            reference[linear, column] += way[kept] * direction[row, index]
    return Executed(
        positions=positions,
        reference=reference,
        point=plain.point[source],
        passed=passed,
        beyond=np.zeros_like(positions),
    )


def joined(parts: list[Executed]) -> Executed:
    """Several stretches as one."""
    return Executed(
        positions=np.concatenate([part.positions for part in parts], axis=1),
        reference=np.concatenate([part.reference for part in parts], axis=1),
        point=np.concatenate([part.point for part in parts]),
        passed=np.concatenate([part.passed for part in parts]),
        beyond=np.concatenate([part.beyond for part in parts], axis=1),
    )


def shares_of_time(done: Executed, owner: NDArray[np.int64], path: Path, count: int) -> FloatArray:
    """Share of each executed motion, (n,), in the way of its move: of the time too, as F is the same all along.

    owner: (n,), move of each; count: of moves. A motion that takes up a reversal has no way of its own.
    """
    before = np.concatenate([path.origins[:, :1], done.reference[:, :-1]], axis=1)
    way = np.nan_to_num(np.sqrt(((done.reference - before) ** 2).sum(axis=0)))
    whole = np.bincount(owner, weights=way, minlength=count)[owner]
    return np.asarray(np.where(whole > 0.0, way / np.where(whole > 0.0, whole, 1.0), 1.0))
