"""Compensates a whole program, batch by batch, so that its length does not matter to memory."""

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.arc_chords import ArcChords
from trueaxis.compensation.columns import NO_ARCS, PlainRun, columns_of
from trueaxis.compensation.course import Everywhere, Placing
from trueaxis.compensation.datum import FromDatum, FromDatumOnCourse, datum_shift
from trueaxis.compensation.executed import Executed, execute, joined, shares_of_time
from trueaxis.compensation.kept_arcs import ArcBlocks, arc_blocks
from trueaxis.compensation.lattice import Stretch, note_outside, rotary_on_words, stretches, unplaced_tips
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import LINEAR, ErrorModel, FloatArray, PointControlled, rotary_rows
from trueaxis.compensation.move_notes import note_moves
from trueaxis.compensation.moves import Between, Item, KeptHole, Notes, Setup, Zero
from trueaxis.compensation.nc.kept_holes import BOTTOM, TOP, check_travel, drilled
from trueaxis.compensation.path import Held, MoveTable, Path, Places, follows_at_once, standing
from trueaxis.compensation.report import Changes, CompensationReport
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.solve import Solved, ToolAxis, solve, solve_pose
from trueaxis.compensation.subdivide import Along, Batch, PointAlong, PoseAlong, batches, subdivide
from trueaxis.compensation.tally import Tally
from trueaxis.compensation.tools import tool_point_of
from trueaxis.compensation.tracker import Tracker, acting
from trueaxis.compensation.visited import Visited
from trueaxis.compensation.writer import BlockWriter

FEW_ROTARY_AXES = (
    "this machine has no rotary axis: the orientation of the tool is not corrected",
    "this machine has one rotary axis: the tool axis is corrected in the direction in which it turns it, not across",
)


class Compensator:
    """Turns the items of one program into its compensated text."""

    def __init__(
        self,
        model: ErrorModel,
        settings: Settings,
        faults: FaultLog,
        notes: Notes,
        changes: Changes | None = None,
    ) -> None:
        self._model, self._changes = model, changes
        self._settings = settings
        self._faults = faults
        self._notes = notes
        self._tool_point = self._given_point = np.array(settings.tool_point, dtype=np.float64)[:, None]
        self._writer = BlockWriter(model.axes, settings)
        self._turned = self._axis_to_turn()
        rotary = np.array([axis not in LINEAR for axis in model.axes])
        self._corrected = (~rotary | (self._turned is not None))[:, None]  # axes that compensation moves, (n_axes, 1)
        self._along = self._comparison()
        self._acting = acting(model, settings)
        self._model = model if self._acting is None else self._acting.model
        self._axes_model = self._model
        self._tracker = None if self._acting is None else Tracker(self._acting, self._along, settings, notes)
        self._assumed = np.array([settings.assumed.get(axis, 0.0) for axis in model.axes])
        self._programmed = np.full(len(model.axes), np.nan)  # position programmed last
        self._written = self._assumed  # position named by the words written last, or where axes are taken to stand
        self._settled = False  # whether the machine stands at a compensated position
        self._level = 0.0  # to which a kept cycle goes back, as written
        # a reversal in the midst of an arc, or words chosen along a ball bar, ask for chords
        self._arcs_stay = settings.arcs == "keep" and self._tracker is None and settings.words == "nearest"
        self._arcs_stay &= self._turned is None
        self._tally = Tally(self._model, settings, () if self._acting is None else self._acting.notes)

    def _axis_to_turn(self) -> ToolAxis | None:
        """The tool axis where it is to be corrected and there are rotary axes for it."""
        if self._settings.orientation == "keep":
            return None
        rotary = rotary_rows(self._model.axes)
        if len(rotary) < 2:
            self._notes.add(0, FEW_ROTARY_AXES[len(rotary)])
        return ToolAxis(self._model, self._settings.tool_axis) if rotary else None

    def _comparison(self) -> Along:
        settings = self._settings
        if self._turned is None:
            return PointAlong(self._model.axes, self._tool_point, settings.aim)
        return PoseAlong(
            model=self._model,
            tool_point=self._tool_point,
            tool_axis=self._turned,
            tolerance=settings.aim,
            orientation_tolerance=1e-6 * settings.orientation_tolerance_urad,
        )

    def texts(self, items: Iterable[Item | PlainRun]) -> Iterator[str]:
        """The compensated program in pieces; none once a fault has been found, but all faults are."""
        for batch in batches(items, self._model.axes, self._settings, self._faults, self._arcs_stay):
            yield self._batch(batch)
            if batch.between is not None:
                yield self._between(batch.between)

    def _between(self, item: Between) -> str:
        """Take in what is said between moves; returns its text."""
        if isinstance(item, Zero):
            return "" if self._faults.count else self._writer.zero(item, self._written, self._programmed)
        if isinstance(item, Setup):
            self._faults.placed |= bool(item.system)
            tools = self._settings.tools
            tool = None if tools is None or item.tool is None else tools.tools.get(item.tool)
            self._tool_point = tool_point_of(self._axes_model, tool, self._given_point)
            on_datum = self._on_datum(item)
            controlled = PointControlled(on_datum) if item.point_control else None
            self._model = controlled or on_datum
            if controlled is not None and self._tracker is not None:
                self._faults.add(0, "effects under tool centre point control are not followed", "leave them out")
            self._along = self._comparison()
            if self._tracker is not None and self._acting is not None:
                datum = FromDatumOnCourse(self._acting.model, on_datum.off) if isinstance(on_datum, FromDatum) else None
                self._tracker.use(self._along, datum or self._acting.model)
            self._tally.setup(item, self._tool_point, on_datum, controlled)
            return ""
        if isinstance(item, KeptHole):
            return "" if self._faults.count else self._hole(item)
        stands = np.array([math.nan if value is None else value for value in item.position])
        kept = np.array([value is None for value in item.position])
        self._programmed = np.where(kept, self._programmed, stands)
        self._written = np.where(kept, self._written, np.where(np.isnan(stands), self._assumed, stands))
        self._settled = False
        if self._tracker is not None:
            self._tracker.stand(self._programmed, kept)
        return ""

    def _hole(self, hole: KeptHole) -> str:
        """A hole of a cycle that stays one; where the axes stand behind it."""
        found = drilled(hole, self._model, self._tool_point, self._settings)
        check_travel(hole, found, self._model, self._faults)
        row = self._model.axes.index("Z")
        if hole.begins:
            self._level = float(self._written[row])
        self._tally.hole(hole.line, found, hole.inch)
        self._tally.units("inch" if hole.inch else "mm")
        if self._changes is not None:
            self._changes.add(np.full(3, hole.line), found.programmed, found.words)
        self._programmed, self._written = found.programmed[:, BOTTOM].copy(), found.words[:, BOTTOM].copy()
        self._programmed[row] = hole.clear
        self._written[row] = self._level if hole.to_level else found.words[row, TOP]
        self._settled = True
        if self._tracker is not None:
            self._tracker.stand(self._programmed, np.zeros(self._programmed.size, dtype=bool))
        return self._writer.hole(hole, found.words[:, BOTTOM], float(found.words[row, TOP]))

    def _on_datum(self, setup: Setup) -> ErrorModel:
        """The machine from the datum of the work offset in force, where that was touched off without compensation."""
        touched = [one for one in self._settings.touched_off if one.system == setup.system]
        if not touched:
            return self._axes_model
        zero = dict(zip(self._model.axes, setup.values, strict=True))
        still = self._axes_model if self._acting is None else self._acting.at_rest
        return FromDatum(self._axes_model, datum_shift(still, touched, zero, self._given_point))

    def _batch(self, batch: Batch) -> str:
        moves = MoveTable([item for item in batch.items if not isinstance(item, str)], len(self._model.axes))
        if not len(moves):
            return "".join(item for item in batch.items if isinstance(item, str))
        start, self._programmed = self._programmed, moves.ends[:, -1]
        if self._faults.broken:  # moves may be missing: where arcs would start is not known
            moves = moves.without_arcs()
        chords = ArcChords.of(moves, start, self._model, self._settings.chord_tolerance, self._arcs_stay)
        path, _ = chords.on(moves, start, self._model.axes)
        note_outside(moves, path, self._model, self._tool_point, self._faults, self._notes)
        if self._faults.count:
            return ""
        ahead = batch.following
        first = ahead.part(0, 1) if isinstance(ahead, PlainRun) else ahead
        after = None if first is None else MoveTable([first], len(self._model.axes))
        follows = follows_at_once(batch.items, moves, after is not None and bool(after.passable[0]))
        note_moves(moves, start, moves.held & self._corrected, self._model.axes, self._notes)
        of_moves = iter(self._compensated(moves, start, (path, chords), follows, after))
        return "".join(item if isinstance(item, str) else next(of_moves) for item in batch.items)

    def _compensated(
        self,
        moves: MoveTable,
        start: FloatArray,
        points: tuple[Path, ArcChords],
        follows: NDArray[np.bool_],
        following: MoveTable | None,
    ) -> list[str]:
        """The text of each item; points: their path, and how many of it are of arcs."""
        settings, tool_point, axes, (path, chords) = self._settings, self._tool_point, self._model.axes, points
        placing: Placing = Everywhere(self._model)
        if self._tracker is not None:
            path, placing = self._tracker.place(path, moves, follows, following)
        path, placing, bent = subdivide(path, self._along, placing, chords.few(path.owner))
        if bent.size:
            return self._compensated(moves, start, chords.finer(bent).on(moves, start, axes), follows, following)
        model = placing.at(np.arange(path.size), np.ones(path.size))
        of = path.owner if path.size > len(moves) else slice(None)  # each move has a point at least
        absolute, inch, lines, held = moves.absolute[of], moves.inch[of], moves.lines[of], columns_of(moves.held, of)
        waiting = held & self._corrected
        parking = moves.in_machine[of] & path.rapid
        allowed = np.where(inch, settings.allowed(True), settings.allowed(False))
        elsewhere, controlled = columns_of(moves.elsewhere, of), isinstance(self._model, PointControlled)
        places = Places(
            held=waiting, elsewhere=elsewhere, unnamed=columns_of(moves.unnamed, of), parking=parking, allowed=allowed,
            unplaced=unplaced_tips(path, elsewhere, axes) if controlled else np.zeros_like(parking),
        )  # fmt: skip
        shift = columns_of(moves.shift, of)
        kinds = list(stretches(absolute, inch, shift, axes, settings))
        self._tally.units(*(unit for unit, some in (("inch", inch.any()), ("mm", not inch.all())) if some))
        steps = np.concatenate([np.repeat(kind.step, kind.last - kind.first, axis=1) for kind in kinds], axis=1)
        solved = self._solved(path, kinds, model, held)
        last_of_move = np.append(np.diff(path.owner) > 0, True)
        passable = ~last_of_move | follows[path.owner]

        parts: list[Executed] = []
        previous = self._written
        for stretch in kinds:
            part = execute(
                stretch, previous, path, solved.linear, passable, model, tool_point, settings, held, places.unplaced
            )
            parts.append(part)
            previous = part.positions[:, -1]
        done = joined(parts)
        before = self._written if self._settled and np.isfinite(start).all() else None
        blocks = arc_blocks(
            chords.arcs if self._arcs_stay else NO_ARCS, chords.count < chords.most, path.owner[done.point],
            done.positions, solved.linear.commands, before, columns_of(steps, done.point), axes, allowed[done.point],
        )  # fmt: skip
        if blocks.apart.size:
            again = chords.finer(blocks.apart, at_once=True).on(moves, start, axes)
            return self._compensated(moves, start, again, follows, following)
        done = replace(done, positions=blocks.positions)
        if self._changes is not None:
            self._changes.add(lines, path.points, done.at_points(self._written))
        self._tally.add(len(moves), path, solved, done, lines, self._written, self._settled, placing, places)
        shares = shares_of_time(done, path.owner[done.point], path, len(moves))
        return self._texts(moves, start, path, done, blocks, shares, (steps, shift))

    def _texts(
        self,
        moves: MoveTable,
        start: FloatArray,
        path: Path,
        done: Executed,
        blocks: ArcBlocks,
        shares: FloatArray,
        lattices: tuple[FloatArray, FloatArray],
    ) -> list[str]:
        """The text of each item; lattices: steps of words, and position minus word, (n_axes, n_points)."""
        at, shares, arcs = blocks.blocks(shares)
        owner, positions = path.owner[done.point[at]], columns_of(done.positions, at)
        self._refuse_cuts(moves, owner)
        before = np.concatenate([self._written[:, None], positions[:, :-1]], axis=1)
        self._written, self._settled = positions[:, -1], True
        ends = moves.ends
        starts = np.concatenate([start[:, None], ends[:, :-1]], axis=1)
        programmed = (columns_of(ends, owner), columns_of(starts, owner))
        steps, shift = (columns_of(of_points, done.point[at]) for of_points in lattices)
        return self._writer.texts(moves, owner, positions, before, (steps, shift), programmed, shares, arcs)

    def _refuse_cuts(self, moves: MoveTable, owner: NDArray[np.int64]) -> None:
        """Faults of blocks that become several and may not; owner: (n,), move of each block to be written."""
        pieces = np.bincount(owner, minlength=len(moves))
        for index, move in moves.singles():
            if move.whole and pieces[index] > 1:
                self._faults.add(
                    move.line,
                    f"the block becomes {pieces[index]} blocks, and whether {move.whole} acts before or after its "
                    "motion is not known",
                    f"give {move.whole} a block of its own",
                )

    def _solved(self, path: Path, kinds: list[Stretch], model: ErrorModel, held: Held) -> Solved:
        """Solve with the rotary positions that their words can name; held axes stay."""
        settings, points = self._settings, path.points
        pose = None
        if self._turned is not None:
            pose = solve_pose(
                points, model, self._tool_point, self._turned,
                settings.aim, 1e-6 * settings.orientation_tolerance_urad, settings.method,
            )  # fmt: skip
        begin = rotary_on_words(points if pose is None else pose.commands, kinds, self._written, model.axes)
        rotary = list(rotary_rows(model.axes))
        begin[rotary] = standing(begin[rotary], held[rotary], self._written[rotary])
        linear = solve(points, begin, model, self._tool_point, settings.aim, settings.method)
        if held.any():
            linear = replace(linear, commands=standing(linear.commands, held, self._written), left=None)
        if pose is not None:
            pose = replace(pose, commands=standing(pose.commands, held, self._written))
        return Solved(linear, pose)

    @property
    def visited(self) -> tuple[Visited, ...]:
        """The places that the program came to so far, for each work offset and tool."""
        return tuple(self._tally.visited.values())

    def report(self, program: str, language: str, blocks_in: int, blocks_out: int) -> CompensationReport:
        """What has been done so far."""
        return self._tally.report(program, language, blocks_in, blocks_out, self._notes)
