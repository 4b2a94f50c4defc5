"""What the report is made of, gathered batch by batch."""

from collections import Counter

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import columns_of
from trueaxis.compensation.course import Placing
from trueaxis.compensation.datum import FromDatum
from trueaxis.compensation.elsewhere import Elsewhere, taken_back
from trueaxis.compensation.executed import Executed
from trueaxis.compensation.logs import LineLog, Running
from trueaxis.compensation.machine import ErrorModel, FloatArray, PointControlled, rotary_rows
from trueaxis.compensation.moves import Notes, Setup
from trueaxis.compensation.nc.kept_holes import BOTTOM, MIDDLE, TOP, Drilled
from trueaxis.compensation.path import Held, Path, Places
from trueaxis.compensation.reliance import Visited
from trueaxis.compensation.report import CompensationReport, Errors, PassedCode
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.sign_check import SignChecker, senses_of
from trueaxis.compensation.solve import Solved, ToolAxis, angle
from trueaxis.compensation.tracker import EffectNote
from trueaxis.compensation.used import datum_of, offsets_used, tools_used
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
        self._moves = self._points = self._short_blocks = self._take_ups = 0
        self._iterations: Counter[int] = Counter()
        self._vector = {stage: Running() for stage in (*STAGES, UNCOMMANDED)}
        self._bar = {stage: Running() for stage in (*STAGES, UNCOMMANDED)}
        self._orientation = {stage: Running() for stage in (*STAGES, UNCOMMANDED)}
        self._not_converged, self._over_tolerance, self._out_of_travel = LineLog(), LineLog(), LineLog()
        self._over_orientation, self._singular, self._uncommanded = LineLog(), LineLog(), LineLog()
        self._parked, self._holes = LineLog(), Running()
        self._units: set[str] = set()
        self._axes = model.axes
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
        index = np.arange(path.size)
        model = placing.at(index, np.ones(path.size))
        written = done.at_points(previous)
        target = solved.linear.target
        deviation, _ = self._stage("before", model, path.points, path.points, lines, target=target)
        moved = np.where(held, 0.0, written - path.points)
        if self._settings.orientation == "keep":  # rotary words are rounded, and not corrected
            moved[list(rotary_rows(self._axes))] = 0.0
        if self._controlled is None:
            left_out = held.any(axis=0) | stopped | places.parking
            self._sign.add(path, deviation + self._off, written, lines, left_out, self._off)
            self.visited[self._setup].add(path.origins, path.points, moved)
        else:
            origins, points = (
                self._controlled.axis_positions(p, self._tool_point) for p in (path.origins, path.points)
            )
            self.visited[self._setup].add(origins, points, moved)
        waiting = held.any(axis=0)
        self._uncommanded.add(lines[waiting])
        counted: NDArray[np.int64] | slice = slice(None)
        if waiting.any():
            rows = index[waiting]
            there = placing.at(rows, np.ones(rows.size))
            self._stage(UNCOMMANDED, there, columns_of(written, rows), columns_of(path.points, rows), lines[rows])
            if self._controlled is None:
                self._elsewhere.add(placing, path, places, lines, self._tool_point)
        if (silent := parked | (waiting & path.rapid)).any():
            counted = index = index[~silent]
            model = placing.at(index, np.ones(index.size))
        if index.size:
            self._at_points(model, counted, path, solved, written, lines, places)
        self._along(path, done, lines, previous, settled, placing, places)

    def _stopped(
        self, done: Executed, places: Places, lines: NDArray[np.int64]
    ) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Points at which a word stops at the end of travel, and those of them at which that matters to nothing, as
        axes only park there; each (n_points,).
        """
        stopped = np.zeros(lines.size, dtype=bool)
        stopped[done.point[done.stopped]] = True
        parked = stopped & places.parking
        self._out_of_travel.add(lines[done.point[done.stopped & ~parked[done.point]]])
        self._parked.add(lines[parked])
        return stopped, parked

    def hole(self, line: int, found: Drilled) -> None:
        """A hole of a cycle that stays one: what holds at its middle counts, the rest of its depth is told apart."""
        lines = np.full(3, line)
        self._moves += 1
        self._points += 1
        self._vector["before"].add(length(found.before), lines)
        after = length(found.error)
        self._vector["after"].add(after[[MIDDLE]], lines[:1])
        self._over_tolerance.add(lines[:1][~(after[[MIDDLE]] <= self._settings.tolerance)])
        self._holes.add(after[[TOP, BOTTOM]].max(keepdims=True), lines[:1])
        origins = np.full_like(found.programmed, np.nan)
        self.visited[self._setup].add(origins, found.programmed, found.words - found.programmed)

    def _at_points(
        self,
        model: ErrorModel,
        index: NDArray[np.int64] | slice,
        path: Path,
        solved: Solved,
        written: FloatArray,
        lines: NDArray[np.int64],
        places: Places,
    ) -> None:
        """Evaluate the programmed points that count."""
        points, at, free = columns_of(path.points, index), lines[index], columns_of(places.uncounted, index)
        target = columns_of(solved.linear.target, index)
        self._stage("solved", model, columns_of(solved.commands, index), points, at, free, target)
        error, turned = self._stage("after", model, columns_of(written, index), points, at, free, target)
        self._over_tolerance.add(at[~(length(error) <= self._settings.tolerance)])
        if solved.pose is not None and turned is not None:
            self._singular.add(at[solved.pose.singular[index]])
            self._over_orientation.add(at[~(1e6 * turned <= self._settings.orientation_tolerance_urad)])

    def _along(
        self,
        path: Path,
        done: Executed,
        lines: NDArray[np.int64],
        previous: FloatArray,
        settled: bool,
        placing: Placing,
        places: Places,
    ) -> None:
        """Evaluate the middles and ends of the feed blocks."""
        fed = ~path.rapid[done.point]
        fed[0] &= settled  # the way from where the machine stood at first is half uncompensated
        fed &= np.isfinite(path.origins[0])[done.point]
        fed &= ~path.halts[done.point]  # what is taken up there moves the axis, not the tool
        index = slice(None) if fed.all() else np.flatnonzero(fed)
        point = done.point[index]
        at_end, wanted_end = columns_of(done.positions, index), columns_of(done.reference, index)
        executed = columns_of(np.concatenate([previous[:, None], done.positions[:, :-1]], axis=1), index)
        reference = columns_of(np.concatenate([path.origins[:, :1], done.reference[:, :-1]], axis=1), index)
        middles = executed + 0.5 * (at_end - executed), reference + 0.5 * (wanted_end - reference)
        at, free = lines[point], columns_of(places.uncounted, point)
        for share, (there, wanted) in ((0.5, middles), (1.0, (at_end, wanted_end))):
            self._stage("along", placing.at(point, np.full(point.size, share)), there, wanted, at, free)

    def _stage(
        self,
        stage: str,
        model: ErrorModel,
        positions: FloatArray,
        wanted: FloatArray,
        lines: NDArray[np.int64],
        free: Held | None = None,
        target: FloatArray | None = None,
    ) -> tuple[FloatArray, FloatArray | None]:
        """Note where positions put the tool instead of where the error-free machine is at `wanted`.

        free: (n_axes, n), linear axes of which nothing says where they are to be: what their motion would take back of
        the error is left out. target: the tool points (3, n) of the error-free machine there, where they are known.
        Returns the error vectors (3, n), mm, and with rotary axes the orientation errors (n,), rad.
        """
        if target is None:
            target = model.ideal(wanted, self._tool_point)
        ideal = target if positions is wanted else model.ideal(positions, self._tool_point)
        error = ideal + model.deviation(positions, self._tool_point) - target
        if free is not None and free.any():
            error += taken_back(model, positions, error, free, self._tool_point)
        self._vector[stage].add(length(error), lines)
        if self._ball is not None:
            self._bar[stage].add(bar_error(target, error, self._ball), lines)
        if not self._axis.turns:
            return error, None
        turned = angle(self._axis.on(model).actual(positions), self._axis.wanted(wanted))
        self._orientation[stage].add(1e6 * turned, lines)
        return error, turned

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
            passed=tuple(PassedCode(code, log.lines()) for code, log in sorted(notes.passed.items())),
            notes=notes.texts(),
        )


def _errors(stages: dict[str, Running]) -> Errors:
    return Errors(*(stages[stage].summary() for stage in STAGES))
