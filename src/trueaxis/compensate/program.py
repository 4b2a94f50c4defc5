"""Compensates a whole program, batch by batch, so that its length does not matter to memory."""

import math
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensate.arcs import MOST_CHORDS, Arc, chord_counts
from trueaxis.compensate.executed import Executed, execute, joined
from trueaxis.compensate.fault_log import FaultLog
from trueaxis.compensate.lattice import stretches
from trueaxis.compensate.machine import LINEAR, ErrorModel, FloatArray
from trueaxis.compensate.moves import Item, Kind, Move, Notes, Start
from trueaxis.compensate.path import Path, path_of
from trueaxis.compensate.report import BallBar, CompensationReport
from trueaxis.compensate.settings import Settings
from trueaxis.compensate.solve import Solution, solve
from trueaxis.compensate.statistics import LineLog, Running
from trueaxis.compensate.subdivide import PROBE_SPACING, subdivide
from trueaxis.compensate.word_choice import bar_error
from trueaxis.compensate.writer import BlockWriter


@dataclass(slots=True)
class _Tally:
    """What the report is made of."""

    moves: int = 0
    points: int = 0
    short_blocks: int = 0
    iterations: Counter[int] = field(default_factory=Counter)
    vector: dict[str, Running] = field(default_factory=dict)
    bar: dict[str, Running] = field(default_factory=dict)
    not_converged: LineLog = field(default_factory=LineLog)
    over_tolerance: LineLog = field(default_factory=LineLog)
    out_of_travel: LineLog = field(default_factory=LineLog)


class Compensator:
    """Turns the items of one program into its compensated text."""

    def __init__(self, model: ErrorModel, settings: Settings, faults: FaultLog, notes: Notes) -> None:
        self._model = model
        self._settings = settings
        self._faults = faults
        self._notes = notes
        self._tool_point = np.array(settings.tool_point, dtype=np.float64)[:, None]
        self._ball = None if settings.ball is None else np.array(settings.ball, dtype=np.float64)[:, None]
        self._writer = BlockWriter(model.axes, settings)
        nowhere = np.full(len(model.axes), np.nan)
        self._programmed = nowhere  # position programmed last
        self._written = nowhere  # position named by the words written last
        self._settled = False  # whether the machine stands at a compensated position
        self._tally = _Tally()
        low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T
        self._low, self._high = low[:, None] - 1e-9, high[:, None] + 1e-9

    def texts(self, items: Iterable[Item]) -> Iterator[str]:
        """The compensated program in pieces; none once a fault has been found, but all faults are."""
        batch: list[str | Move] = []
        load = 0
        last: tuple[float, ...] | None = None
        for item in items:
            if isinstance(item, Start):
                yield self._batch(batch)
                batch, load = [], 0
                self._programmed = self._written = np.array(item.position)
                self._settled = False
                continue
            if not isinstance(item, str) and item.arc is not None:
                chords = self._chords(item, item.arc)
                if chords > MOST_CHORDS:
                    self._faults.add(item.line, f"the arc takes {chords} chords", "say a larger --chord-tolerance")
                    item = item._replace(arc=None, kind=Kind.LINE)  # noqa: PLW2901  # only to read on
                load += chords
            batch.append(item)
            load += 1
            if not isinstance(item, str):
                if item.kind and last is not None:
                    load += int(math.dist(last, item.end) / PROBE_SPACING)  # it may be cut as finely as it is probed
                last = item.end
            if load >= self._settings.batch_points:
                yield self._batch(batch)
                batch, load = [], 0
        yield self._batch(batch)

    def _chords(self, move: Move, arc: Arc) -> int:
        at = dict(zip(self._model.axes, move.end, strict=True))
        radius = math.dist([at.get(axis, 0.0) for axis in LINEAR], arc.centre)  # with its rise; a bound
        count = chord_counts(np.array(radius), np.array(arc.sweep), self._settings.chord_tolerance)
        return int(count)

    def _batch(self, batch: list[str | Move]) -> str:
        moves = [item for item in batch if not isinstance(item, str)]
        if not moves:
            return "".join(item for item in batch if isinstance(item, str))
        start, self._programmed = self._programmed, np.array(moves[-1].end)
        if self._faults.count:  # moves may be missing: where arcs would start is not known
            moves = [move._replace(arc=None) for move in moves]
        path = path_of(moves, start, self._model.axes, self._settings.chord_tolerance)
        self._inside(moves, path)
        if self._faults.count:
            return ""
        texts = self._compensated(moves, start, path, _follows(batch))
        if len(texts) == len(batch):
            return "".join(texts)
        of_moves = iter(texts)
        return "".join(item if isinstance(item, str) else next(of_moves) for item in batch)

    def _inside(self, moves: list[Move], path: Path) -> None:
        """Note programmed positions, those along arcs too, that are outside the travel; once a block."""
        outside = (path.points < self._low) | (path.points > self._high)
        points = np.flatnonzero(outside.any(axis=0))
        for point in points[np.unique(path.owner[points], return_index=True)[1]]:
            row = int(np.argmax(outside[:, point]))
            axis = self._model.axes[row]
            low, high = self._model.travel[axis]
            self._faults.add(
                moves[path.owner[point]].line,
                f"{axis} = {path.points[row, point]:g} is outside its travel",
                f"from {low:g} to {high:g}",
            )

    def _compensated(self, moves: list[Move], start: FloatArray, path: Path, follows: NDArray[np.bool_]) -> list[str]:
        settings, model, tool_point = self._settings, self._model, self._tool_point
        axes = model.axes
        if np.isnan(start).any() and moves[0].kind != Kind.RAPID:
            self._notes.add(moves[0].line, "a feed motion from an unknown position: only its end is compensated")
        path = subdivide(path, model, tool_point, settings.tolerance)
        absolute = np.array([move.absolute for move in moves])[path.owner]
        inch = np.array([move.inch for move in moves])[path.owner]
        lines = np.array([move.line for move in moves])[path.owner]
        kinds = list(stretches(absolute, inch, axes, settings))
        steps = np.concatenate([np.repeat(kind.step, kind.last - kind.first, axis=1) for kind in kinds], axis=1)
        solution = self._solved(path, steps)
        last_of_move = np.append(np.diff(path.owner) > 0, True)
        passable = ~last_of_move | follows[path.owner]

        parts: list[Executed] = []
        previous = self._written
        for stretch in kinds:
            part = execute(stretch, previous, path, solution, passable, model, tool_point, settings)
            parts.append(part)
            previous = part.positions[:, -1]
        done = joined(parts)
        self._count(moves, path, solution, done, lines)
        owner = path.owner[done.point]
        before = np.concatenate([self._written[:, None], done.positions[:, :-1]], axis=1)
        self._written, self._settled = previous, True
        ends = np.array([move.end for move in moves]).T
        starts = np.concatenate([start[:, None], ends[:, :-1]], axis=1)
        programmed = (ends[:, owner], starts[:, owner])
        return self._writer.texts(moves, owner, done.positions, before, steps[:, done.point], programmed)

    def _solved(self, path: Path, steps: FloatArray) -> Solution:
        """Solve with the rotary positions that their words can name."""
        begin = path.points.copy()
        for row, axis in enumerate(self._model.axes):
            if axis in "ABC":
                begin[row] = np.rint(begin[row] / steps[row]) * steps[row]
        settings = self._settings
        return solve(path.points, begin, self._model, self._tool_point, settings.tolerance, settings.method)

    def _count(
        self, moves: list[Move], path: Path, solution: Solution, done: Executed, lines: NDArray[np.int64]
    ) -> None:
        """Evaluate what was written and add it to the report's figures."""
        tally, tolerance = self._tally, self._settings.tolerance
        tally.moves += len(moves)
        tally.points += path.size
        tally.short_blocks += int(done.passed.sum())
        tally.iterations.update(dict(enumerate(np.bincount(solution.steps).tolist())))
        tally.not_converged.add(lines[~solution.converged])
        commanded = done.positions
        outside = ((commanded < self._low) | (commanded > self._high)).any(axis=0)
        tally.out_of_travel.add(lines[done.point[outside]])

        uncompensated = self._model.deviation(path.points, self._tool_point)
        solved = self._error(solution.commands, solution.target)
        after = self._error(done.at_points(self._written), solution.target)
        for name, error in (("before", uncompensated), ("solved", solved), ("after", after)):
            self._add(name, solution.target, error, lines)
        length = np.sqrt((after**2).sum(axis=0))
        tally.over_tolerance.add(lines[~(length <= tolerance)])

        fed = ~path.rapid[done.point]
        fed[0] &= self._settled  # the way from where the machine stood at first is half uncompensated
        index = np.flatnonzero(fed)
        reference = np.concatenate([path.origins[:, :1], done.reference], axis=1)
        executed = np.concatenate([self._written[:, None], commanded], axis=1)
        for share in (0.5, 1.0):
            at = executed[:, index] + share * (executed[:, index + 1] - executed[:, index])
            wanted = reference[:, index] + share * (reference[:, index + 1] - reference[:, index])
            target = self._model.ideal(wanted, self._tool_point)
            self._add("along", target, self._error(at, target), lines[done.point[index]])

    def _error(self, positions: FloatArray, target: FloatArray) -> FloatArray:
        actual = self._model.ideal(positions, self._tool_point) + self._model.deviation(positions, self._tool_point)
        return np.asarray(actual - target)

    def _add(self, name: str, target: FloatArray, error: FloatArray, lines: NDArray[np.int64]) -> None:
        self._tally.vector.setdefault(name, Running()).add(np.sqrt((error**2).sum(axis=0)), lines)
        if self._ball is not None:
            self._tally.bar.setdefault(name, Running()).add(bar_error(target, error, self._ball), lines)

    def report(self, program: str, language: str, blocks_in: int, blocks_out: int) -> CompensationReport:
        """What has been done so far."""
        tally = self._tally
        vector = {name: running.summary() for name, running in tally.vector.items()}
        bar = {name: running.summary() for name, running in tally.bar.items()}
        most = max((steps for steps, count in tally.iterations.items() if count), default=-1)
        return CompensationReport(
            program,
            language,
            self._settings,
            blocks_in,
            blocks_out,
            tally.moves,
            tally.points,
            tally.short_blocks,
            tuple(tally.iterations[steps] for steps in range(most + 1)),
            vector.get("before"),
            vector.get("solved"),
            vector.get("after"),
            vector.get("along"),
            None
            if self._ball is None
            else BallBar(bar.get("before"), bar.get("solved"), bar.get("after"), bar.get("along")),
            tally.not_converged.lines(),
            tally.over_tolerance.lines(),
            tally.out_of_travel.lines(),
            self._notes.texts(),
        )


def _follows(batch: list[str | Move]) -> NDArray[np.bool_]:
    """For each move of a batch whether another follows at once and the tool may run through the end between them."""
    return np.array(
        [
            not isinstance(after, str) and after is not None and item.passable and after.passable
            for item, after in zip(batch, [*batch[1:], None], strict=True)
            if not isinstance(item, str)
        ]
    )
