"""Effects along a program: which act, which can be compensated and why the others cannot; follows the axes, batch by
batch, and puts in points where a reversal is to be taken up.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.arc_chords import ArcChords
from trueaxis.compensation.columns import columns_of
from trueaxis.compensation.course import (
    ContextModel,
    Course,
    OnCourse,
    Placed,
    Standing,
    at_vertices,
    cruising,
    ramps,
    since_reversal,
    turnings,
)
from trueaxis.compensation.lattice import word_steps
from trueaxis.compensation.machine import ErrorModel, FloatArray, linear_rows
from trueaxis.compensation.moves import Kind, Notes
from trueaxis.compensation.path import Held, MoveTable, Path
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.subdivide import Along
from trueaxis.effects.kind import Effect
from trueaxis.effects.kind import Kind as EffectKind
from trueaxis.effects.placement import FARTHEST, REFERENCE_TEMPERATURE, SINCE_REVERSAL, context_of
from trueaxis.model.context import Context
from trueaxis.model.model import MachineModel

OF_INSTRUMENT = "an instrument's: no error of the machine"
NO_TIME = "depends on time: say --time"
NO_TEMPERATURE = f"temperature taken as {REFERENCE_TEMPERATURE:g} degC; another: --temperature"
_REVERSALS = ("direction", *SINCE_REVERSAL)


@dataclass(frozen=True, slots=True)
class EffectNote:
    """What is done about one effect of the machine: whether it is compensated, and how or why not."""

    effect: str
    compensated: bool
    how: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Acting:
    """A machine with those effects that are compensated.

    notes: on all of its effects. reversing: axes whose direction or distance since a reversal an effect depends on.
    moving: whether an effect depends on velocity, or on
    the time that motions take. time: s; temperature: degC.
    """

    model: ContextModel
    notes: tuple[EffectNote, ...]
    reversing: tuple[str, ...]
    moving: bool
    time: float
    temperature: float

    @property
    def at_rest(self) -> ErrorModel:
        """The machine at one position where its axes have not turned back, as where a datum is touched off."""
        still = Context.at_rest(len(self.model.axes), 1)
        return Placed.of_context(
            self.model, replace(still, time=np.array([self.time]), temperature=np.array([self.temperature]))
        )


def acting(model: ErrorModel, settings: Settings) -> Acting | None:
    """The effects of a machine along a program; None where its errors depend on positions alone."""
    if not isinstance(model, MachineModel) or not model.errors.effects:
        return None
    kinds = model.machine.kinds
    found = [(one, _note(one.effect, kinds[one.effect.kind], settings)) for one in model.errors.effects]
    kept = tuple(one for one, note in found if note.compensated)
    reversing: set[str] = set()
    moving = False
    for one in kept:
        for name in context_of(kinds[one.effect.kind]):
            own = name.removesuffix("_b")
            if own in _REVERSALS:
                axis = one.effect.axis if name.endswith("_b") else one.effect.own_axis
                reversing.add(axis or "")
            moving |= own in ("v", "d_time")
    return Acting(
        model=model.with_values(replace(model.errors, effects=kept)),
        notes=tuple(note for _, note in found),
        reversing=tuple(axis for axis in model.axes if axis in reversing),
        moving=moving,
        time=settings.time or 0.0,
        temperature=REFERENCE_TEMPERATURE if settings.temperature is None else settings.temperature,
    )


def _note(effect: Effect, kind: EffectKind, settings: Settings) -> EffectNote:
    if kind.place in ("reading", "point"):
        return EffectNote(effect.label, False, OF_INSTRUMENT)
    used = {name.removesuffix("_b") for name in context_of(kind)}
    if "t" in used and settings.time is None:
        return EffectNote(effect.label, False, NO_TIME)
    how = []
    if used.intersection(_REVERSALS):
        how.append("by blocks that take up what a reversal changes")
    if "v" in used:
        how.append("at the programmed feed, fading out towards stops and corners")
    if "d_time" in used and "v" not in used:
        how.append("at the programmed feed")
    if "t" in used:
        how.append(f"{settings.time:g} s after the start")
    if "T" in used:
        known = settings.temperature is not None
        how.append(f"at {settings.temperature:g} degC" if known else NO_TEMPERATURE)
    return EffectNote(effect.label, True, "; ".join(how) or "by position")


# In steps of words: how far an axis that moves in the program, or stands there and is moved by corrections alone, goes
# back before that is a reversal. Nothing would be gained by taking up play for less than a word.
MOVES, STANDS = 0.25, 1.0
AHEAD = (
    "a reversal throws the axis ahead (does the control compensate too much lost motion?): the block that makes up for "
    "it goes the old way, and the tool is off the path by the jump until the axis turns"
)
BACK_AND_FORTH = (
    "words chosen along the ball bar go back and forth by a step, which an axis with lost motion does not follow: "
    "--words nearest is better here"
)
NO_FEED = "a feed motion without a known F in mm/min: what depends on velocity is not compensated there"


class Tracker:
    """Knows how the axes stand after the batches so far."""

    def __init__(self, acting: Acting, along: Along, settings: Settings, notes: Notes) -> None:
        self._acting, self._along, self._settings, self._notes = acting, along, settings, notes
        self._axes = acting.model.axes
        self._steps = {inch: word_steps(self._axes, settings, inch) for inch in (False, True)}
        self._standing = Standing.at(np.full(len(self._axes), np.nan))
        if acting.reversing and settings.words != "nearest":
            notes.add(0, BACK_AND_FORTH)

    def use(self, along: Along, model: ContextModel) -> None:
        """Compare corrections otherwise from here on, on this machine: another tool, another datum."""
        self._along, self._acting = along, replace(self._acting, model=model)

    def stand(self, position: FloatArray, kept: NDArray[np.bool_]) -> None:
        """Axes stand at a position (n_axes,) and have not moved yet, but for those that are kept as they were."""
        new, old = Standing.at(position), self._standing
        self._standing = Standing(
            np.where(kept, old.extreme, new.extreme),
            np.where(kept, old.direction, new.direction),
            np.where(kept, old.since, new.since),
            new.velocity,
        )

    def place(
        self, path: Path, moves: MoveTable, follows: NDArray[np.bool_], following: MoveTable | None
    ) -> tuple[Path, OnCourse]:
        """The path of a batch, with a motion of no length wherever the commands have to jump, and its course.

        A jump is due at the start of a motion in which an axis moves the other way. follows: whether each move is run
        through; following: of one move, the one after the last.
        """
        standing = self._standing
        inch = moves.inch[path.owner]
        steps = np.where(inch, self._steps[True], self._steps[False])
        elsewhere = columns_of(moves.elsewhere, path.owner)
        direction, extreme = self._directions(path, steps, elsewhere)
        velocity, duration, at_ends = self._velocities(path, moves, follows, following)
        since, gone = since_reversal(path, direction, standing, duration, linear_rows(self._axes))
        at_starts = np.concatenate([standing.velocity[:, None], at_ends[:, :-1]], axis=1)
        course = Course(
            direction=direction, since=since, gone=gone, velocity=(at_starts, velocity, at_ends), ramp=ramps(duration)
        )
        jumps = self._jumps(path, course, steps, moves)
        self._standing = Standing(extreme, direction[:, -1], since[..., -1] + gone[..., -1], at_ends[:, -1])
        return self._with_jumps(path, course, jumps)

    def _directions(self, path: Path, steps: FloatArray, elsewhere: Held) -> tuple[FloatArray, FloatArray]:
        standing = self._standing
        if not self._acting.reversing:
            return np.zeros_like(path.points), standing.extreme
        model = self._placed(
            np.zeros_like(path.points), np.zeros_like(path.points), np.full((3, *path.points.shape), FARTHEST)
        )
        wanted = np.where(elsewhere, np.nan, path.points + self._along.correction(model, path.points))
        band = steps * np.where(path.points == path.origins, STANDS, MOVES)
        direction, extreme = turnings(wanted, standing, band)
        others = [row for row, axis in enumerate(self._axes) if axis not in self._acting.reversing]
        direction[others] = 0.0
        return direction, extreme

    def _velocities(
        self, path: Path, moves: MoveTable, follows: NDArray[np.bool_], following: MoveTable | None
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Velocity in the midst of motions, their duration, and velocity at their ends."""
        if not self._acting.moving:
            still = np.zeros_like(path.points)
            return still, np.zeros(path.size), still
        feeds = moves.feed
        for line in moves.lines[(moves.motion != Kind.RAPID) & ~(feeds > 0.0)].tolist():
            self._notes.add(line, NO_FEED)
        feed = feeds[path.owner]
        midst, duration = cruising(path, feed, self._axes)
        after, owner = np.zeros((len(self._axes), 1)), len(moves)
        if following is not None:
            end = path.points[:, -1]
            arcs = ArcChords.of(following, end, self._acting.model, self._settings.chord_tolerance, stay=False)
            ahead, _ = arcs.on(following, end, self._axes)
            after = cruising(ahead, following.feed[ahead.owner], self._axes)[0][:, :1]
        ends = at_vertices(np.concatenate([midst, after], axis=1), np.append(path.owner, owner), follows)
        return midst, duration, ends

    def _jumps(self, path: Path, course: Course, steps: FloatArray, moves: MoveTable) -> NDArray[np.int64]:
        """Motions at whose start the commands are to jump by more than rounding."""
        before = np.concatenate([self._standing.direction[:, None], course.direction[:, :-1]], axis=1)
        since = np.concatenate([self._standing.since[..., None], (course.since + course.gone)[..., :-1]], axis=2)
        turned = (course.direction != before).any(axis=0) & ~path.rapid & np.isfinite(path.origins).all(axis=0)
        index = np.flatnonzero(turned)
        if index.size == 0:
            return index
        velocity = course.velocity[0][:, index]
        at = np.ascontiguousarray(path.origins[:, index])
        new = self._placed(course.direction[:, index], velocity, course.since[..., index])
        old = self._placed(before[:, index], velocity, since[..., index])
        leap = self._along.correction(new, at) - self._along.correction(old, at)
        counts = np.abs(leap) > 0.5 * steps[:, index]
        against = counts & (leap * course.direction[:, index] < 0.0) & (course.direction * before < 0.0)[:, index]
        for line in moves.lines[path.owner[index[against.any(axis=0)]]].tolist():
            self._notes.add(line, AHEAD)
        return np.asarray(index[counts.any(axis=0)])

    def _with_jumps(self, path: Path, course: Course, jumps: NDArray[np.int64]) -> tuple[Path, OnCourse]:
        if jumps.size:
            motion = np.sort(np.concatenate([np.arange(path.size), jumps]), kind="stable")
            leaping = np.append(motion[1:] == motion[:-1], False)
            path = Path(
                points=np.where(leaping, columns_of(path.origins, motion), columns_of(path.points, motion)),
                origins=columns_of(path.origins, motion), owner=path.owner[motion], rapid=path.rapid[motion],
                halts=leaping,
            )  # fmt: skip
            course = course.with_halts(motion, leaping)
        return path, OnCourse(self._acting.model, course, self._acting.time, self._acting.temperature)

    def _placed(self, directions: FloatArray, velocity: FloatArray, since: FloatArray) -> Placed:
        acting, count = self._acting, directions.shape[1]
        times, temperatures = np.full(count, acting.time), np.full(count, acting.temperature)
        way, passed, along = since
        here = Context(
            directions=directions,
            velocity=velocity,
            since_reversal=way,
            time_since=passed,
            path_since=along,
            time=times,
            temperature=temperatures,
        )
        return Placed.of_context(acting.model, here)
