"""What the report is made of, gathered batch by batch."""

from collections import Counter

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import columns_of
from trueaxis.compensation.course import Placing
from trueaxis.compensation.datum import FromDatum
from trueaxis.compensation.elsewhere import Elsewhere
from trueaxis.compensation.executed import Executed
from trueaxis.compensation.logs import LineLog, Running, TravelLog
from trueaxis.compensation.machine import ErrorModel, FloatArray, PointControlled, rotary_rows
from trueaxis.compensation.moves import Notes, Setup
from trueaxis.compensation.nc.kept_holes import BOTTOM, MIDDLE, TOP, Drilled
from trueaxis.compensation.path import Path, Places
from trueaxis.compensation.report import CompensationReport, Errors, PassedCode
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.sign_check import KinematicsChecker, SignChecker, senses_of
from trueaxis.compensation.solve import Solved, ToolAxis
from trueaxis.compensation.tool_errors import NOTHING_KNOWN, CuttingPoses, Known, ToolErrors, tool_errors
from trueaxis.compensation.tracker import EffectNote
from trueaxis.compensation.used import datum_of, offsets_used, tools_used, unplaced
from trueaxis.compensation.visited import Visited
from trueaxis.compensation.word_choice import bar_error, length

STAGES = ("before", "solved", "after", "along")
UNCOMMANDED = "uncommanded"


class Tally:
    """Counts and figures of one program on one machine; visited: the places that it came to, by what was in force."""

    def __init__(self, model: ErrorModel, settings: Settings, effects: tuple[EffectNote, ...]) -> None:
        self._settings, self._effects = settings, effects
        self._tool_point = np.array(settings.tool_point, dtype=np.float64)[:, None]
        self._ball = None if settings.ball is None else np.array(settings.ball, dtype=np.float64)[:, None]
        self._axis = ToolAxis(model, settings.tool_axis)
        self._model, self._setup = model, Setup()
        self.visited = {self._setup: Visited(model, self._tool_point)}  # by what was in force
        self._off = np.zeros((3, 1))  # of the datum in force
        self._senses = senses_of(model, self._tool_point)
        self._sign = SignChecker(model, self._tool_point, settings.resolution)
        self._controlled: PointControlled | None = None
        self._kinematics, self._cutting = KinematicsChecker(model.axes), CuttingPoses()
        self._silent = False  # whether some axis may not have been at the point before
        self._moves = self._points = self._short_blocks = self._take_ups = 0
        self._iterations: Counter[int] = Counter()
        self._vector = {stage: Running() for stage in (*STAGES, UNCOMMANDED)}
        self._bar = {stage: Running() for stage in (*STAGES, UNCOMMANDED)}
        self._orientation = {stage: Running() for stage in (*STAGES, UNCOMMANDED)}
        self._not_converged, self._over_tolerance, self._out_of_travel = LineLog(), LineLog(), TravelLog(model.axes)
        self._over_orientation, self._singular, self._uncommanded = LineLog(), LineLog(), LineLog()
        self._parked, self._holes = LineLog(), Running()
        self._axes, self._units = model.axes, set[str]()
        self._elsewhere = Elsewhere(model.axes, settings)

    def setup(
        self, setup: Setup, tool_point: FloatArray, model: ErrorModel, controlled: PointControlled | None = None
    ) -> None:
        """Other work offsets or another tool, with its point (3, 1), from here on; model: the machine from their datum;
        controlled: the one where positions are those of the tip.
        """
        self._setup, self._tool_point, self._controlled = setup, tool_point, controlled
        self._off = model.off if isinstance(model, FromDatum) else np.zeros((3, 1))
        self._sign.use(tool_point)
        if setup not in self.visited:
            self.visited[setup] = Visited(self._model, tool_point, datum_of(setup, self._axes, self._settings))

    def units(self, *named: str) -> None:
        """Units of words that are written."""
        self._units.update(named)

    def add(
        self,
        moves: int,
        path: Path,
        solved: Solved,
        done: Executed,
        lines: NDArray[np.int64],
        previous: FloatArray,
        settled: bool,
        placing: Placing,
        places: Places,
    ) -> None:
        """Evaluate what was written of one batch.

        lines: (n_points,), of the path's points. previous: (n_axes,), position named by the words before; settled:
        whether it was a compensated one. placing: gives the machine along the path. Rapids to points where an axis is
        held count apart, since an axis that is not where the program wants it yet is no error of compensation there.
        Feed motions count without what axes would take back that the program has not moved so far: it does not say
        where they are to be.
        """
        held = places.held
        self._moves += moves
        self._points += path.size
        self._short_blocks += int(done.passed.sum())
        self._take_ups += int(path.halts.sum())
        self._iterations.update(dict(enumerate(np.bincount(solved.steps).tolist())))
        self._not_converged.add(lines[~solved.converged])
        stopped, parked = self._stopped(done, places, lines)
        model = placing.at(index := np.arange(path.size), np.ones(path.size))
        written = done.at_points(previous)
        known = Known(target=solved.linear.target, error=solved.linear.deviation)
        before = self._errors(model, path.points, path.points, known)
        self._note("before", before, lines)
        moved = np.where(held, 0.0, written - path.points)
        if self._settings.orientation == "keep":  # rotary words are rounded, and not corrected
            moved[list(rotary_rows(self._axes))] = 0.0
        waiting = held.any(axis=0)
        if self._controlled is None:
            left_out = waiting | stopped | places.parking
            self._sign.add(path, before.vectors + self._off, written, lines, left_out, self._off)
        self._visit(path, moved, lines, places)
        self._uncommanded.add(lines[waiting])
        counted: NDArray[np.int64] | slice = slice(None)
        if waiting.any():
            rows = index[waiting]
            there = placing.at(rows, np.ones(rows.size))
            waited = self._errors(there, columns_of(written, rows), columns_of(path.points, rows))
            self._note(UNCOMMANDED, waited, lines[rows])
            if self._controlled is None:
                self._elsewhere.add(placing, path, places, lines, self._tool_point)
        if (silent := parked | (waiting & path.rapid)).any():
            counted = index = index[~silent]
            model = placing.at(index, np.ones(index.size))
        after = self._at_points(model, counted, path, solved, written, lines, places) if index.size else None
        at_ends = after if isinstance(counted, slice) and not done.passed.any() else None
        self._along(path, done, lines, previous, settled, placing, places, at_ends)

    def _visit(self, path: Path, moved: FloatArray, lines: NDArray[np.int64], places: Places) -> None:
        """Take in where the axes come to; moved: (n_axes, n_points), by how much the words move the points. Not rapids
        to where some axis may not be, which count in no figure, nor the way of a rapid from there.
        """
        silent = places.held.any(axis=0) & path.rapid
        origins, points = path.origins, path.points
        if self._controlled is not None:
            origins, points = (self._controlled.axis_positions(at, self._tool_point) for at in (origins, points))
            ends = np.diff(path.owner, append=-1) != 0
            self._kinematics.add(path.points, points, lines, ~ends | places.elsewhere.any(axis=0))
        so_far = np.append(self._silent, silent)
        self._silent = bool(so_far[-1])
        origins, seen = np.where(path.rapid & so_far[:-1], np.nan, origins), ~(silent | places.unplaced)
        self.visited[self._setup].add(origins[:, seen], points[:, seen], moved[:, seen], ~path.rapid[seen])

    def _stopped(
        self, done: Executed, places: Places, lines: NDArray[np.int64]
    ) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """(n_points,) each: where a word stops at the end of the travel, and where axes only park there."""
        stopped = np.isin(np.arange(lines.size), done.point[done.stopped])
        parked = stopped & places.parking
        there = done.stopped & ~parked[done.point]
        self._out_of_travel.beyond(lines[done.point[there]], done.beyond[:, there])
        self._parked.add(lines[parked])
        return stopped, parked

    def hole(self, line: int, found: Drilled, inch: bool) -> None:
        """A hole of a cycle that stays one: what holds at its middle counts, the rest of its depth is told apart; inch:
        whether its words are in inch.
        """
        lines = np.full(3, line)
        self._moves += 1
        self._points += 1
        self._vector["before"].add(length(found.before), lines)
        after = length(found.error)
        self._vector["after"].add(after[[MIDDLE]], lines[:1])
        self._over_tolerance.add(lines[:1][~(after[[MIDDLE]] <= self._settings.allowed(inch))])
        self._holes.add(after[[TOP, BOTTOM]].max(keepdims=True), lines[:1])
        at = found.programmed
        self.visited[self._setup].add(np.full_like(at, np.nan), at, found.words - at)

    def _at_points(
        self,
        model: ErrorModel,
        index: NDArray[np.int64] | slice,
        path: Path,
        solved: Solved,
        written: FloatArray,
        lines: NDArray[np.int64],
        places: Places,
    ) -> ToolErrors:
        """Evaluate the programmed points that count: what is left there with the words."""
        points, at, free = columns_of(path.points, index), lines[index], columns_of(places.uncounted, index)
        target = columns_of(solved.linear.target, index)
        known = Known(free=free, target=target)
        left = solved.linear.left if solved.pose is None else None
        commands = columns_of(solved.commands, index)
        there = known if left is None else known._replace(error=columns_of(left, index))
        self._note("solved", self._errors(model, commands, points, there), at)
        after = self._errors(model, columns_of(written, index), points, known)
        self._note("after", after, at)
        self._over_tolerance.add(at[~(length(after.vectors) <= places.allowed[index])])
        if solved.pose is not None and after.turned is not None:
            singular = solved.pose.singular[index]
            self._singular.add(at[singular])
            over = ~(1e6 * after.turned <= self._settings.orientation_tolerance_urad)
            self._over_orientation.add(self._cutting.lines(at, over, singular, path.rapid[index]))
        return after

    def _along(
        self,
        path: Path,
        done: Executed,
        lines: NDArray[np.int64],
        previous: FloatArray,
        settled: bool,
        placing: Placing,
        places: Places,
        at_ends: ToolErrors | None,
    ) -> None:
        """Evaluate the middles and ends of the feed blocks; at_ends: what is left at the ends of all, where known."""
        fed = ~path.rapid[done.point]
        fed[0] &= settled  # the way from where the machine stood at first is half uncompensated
        fed &= np.isfinite(path.origins[0])[done.point]
        fed &= ~path.halts[done.point]  # what is taken up there moves the axis, not the tool
        index = slice(None) if fed.all() else np.flatnonzero(fed)
        point = done.point[index]
        executed, reference = (
            columns_of(before + 0.5 * (end - before), index)
            for before, end in (
                (np.concatenate([previous[:, None], done.positions[:, :-1]], axis=1), done.positions),
                (np.concatenate([path.origins[:, :1], done.reference[:, :-1]], axis=1), done.reference),
            )
        )
        at, known = lines[point], Known(free=columns_of(places.uncounted, point))
        halfway = placing.at(point, np.full(point.size, 0.5))
        self._note("along", self._errors(halfway, executed, reference, known), at)
        if at_ends is None:
            there = placing.at(point, np.ones(point.size))
            ends = columns_of(done.positions, index), columns_of(done.reference, index)
            at_ends = self._errors(there, *ends, known)
        else:
            at_ends = at_ends.some(index)
        self._note("along", at_ends, at)

    def _errors(
        self, model: ErrorModel, positions: FloatArray, wanted: FloatArray, known: Known = NOTHING_KNOWN
    ) -> ToolErrors:
        return tool_errors(model, self._axis, self._tool_point, positions, wanted, known)

    def _note(self, stage: str, errors: ToolErrors, lines: NDArray[np.int64]) -> None:
        self._vector[stage].add(length(errors.vectors), lines)
        if self._ball is not None:
            self._bar[stage].add(bar_error(errors.target, errors.vectors, self._ball), lines)
        if errors.turned is not None:
            self._orientation[stage].add(1e6 * errors.turned, lines)

    def report(self, program: str, language: str, blocks_in: int, blocks_out: int, notes: Notes) -> CompensationReport:
        """What has been counted so far."""
        most = max((steps for steps, count in self._iterations.items() if count), default=-1)
        vector = _errors(self._vector)
        return CompensationReport(
            program=program,
            language=language,
            settings=self._settings,
            blocks_in=blocks_in,
            blocks_out=blocks_out,
            moves=self._moves,
            units=tuple(unit for unit in ("mm", "inch") if unit in self._units),
            kept_motions=notes.kept,
            kept_holes=self._holes.summary(),
            points=self._points,
            short_blocks=self._short_blocks,
            take_ups=self._take_ups,
            iterations=tuple(self._iterations[steps] for steps in range(most + 1)),
            before=vector.before,
            solved=vector.solved,
            after=vector.after,
            along=vector.along,
            ball=None if self._ball is None else _errors(self._bar),
            orientation=_errors(self._orientation) if self._axis.turns else None,
            not_converged=self._not_converged.lines(),
            over_tolerance=self._over_tolerance.lines(),
            out_of_travel=self._out_of_travel.lines(),
            beyond_travel=self._out_of_travel.farthest(),
            parked_at_end=self._parked.lines(),
            over_orientation=self._over_orientation.lines(),
            singular=self._singular.lines(),
            uncommanded=self._uncommanded.lines(),
            uncommanded_left=self._vector[UNCOMMANDED].summary(),
            unknown_places=self._elsewhere.rapids(),
            unnamed_feeds=self._elsewhere.feeds(),
            # what an interpreter has unrolled is in machine coordinates, whatever G59.3 is called there
            offsets=() if self._settings.judged else offsets_used(self._model, self.visited, self._settings),
            tools=tools_used(self.visited),
            effects=self._effects,
            senses=self._senses,
            sign_check=self._sign.found,
            kinematics_check=self._kinematics.found,
            passed=tuple(PassedCode(code, log.lines()) for code, log in sorted(notes.passed.items())),
            unplaced=unplaced(self._model, self.visited) if notes.unplaced else None,
            warnings=notes.texts(grave=True),
            notes=notes.texts(),
        )


def _errors(stages: dict[str, Running]) -> Errors:
    return Errors(*(stages[stage].summary() for stage in STAGES))
