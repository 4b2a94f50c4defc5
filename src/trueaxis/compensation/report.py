"""What a compensation did; and, for who asks for it, what it changed point by point, which grows with the program."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.elsewhere import OffsetUse, UnknownPlaces, UnnamedFeeds
from trueaxis.compensation.logs import Lines, Summary
from trueaxis.compensation.machine import FloatArray
from trueaxis.compensation.reliance import Reliance
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.sign_check import KinematicsCheck, Senses, SignCheck
from trueaxis.compensation.tools import ToolUse
from trueaxis.compensation.tracker import EffectNote

Failure = Literal[
    "not converged", "above tolerance", "out of travel", "tool axis above tolerance", "above within ranges of offsets",
    "above at other places of axes", "nothing moves",
]  # fmt: skip


class Changes:
    """Gathers programmed and compensated positions, batch by batch."""

    def __init__(self, n_axes: int) -> None:
        self._lines: list[NDArray[np.int64]] = [np.zeros(0, dtype=np.int64)]
        self._programmed, self._compensated = [np.zeros((n_axes, 0))], [np.zeros((n_axes, 0))]

    def add(self, lines: NDArray[np.int64], programmed: FloatArray, compensated: FloatArray) -> None:
        """Note points (n,) with their lines; programmed, compensated: (n_axes, n), mm and deg."""
        self._lines.append(np.array(lines, dtype=np.int64))
        self._programmed.append(np.array(programmed))
        self._compensated.append(np.array(compensated))

    @property
    def lines(self) -> NDArray[np.int64]:
        """(n,): the line of the program that each point belongs to."""
        return np.concatenate(self._lines)

    @property
    def programmed(self) -> FloatArray:
        """(n_axes, n): ends of motions with those of chords and cuts, mm and deg."""
        return np.hstack(self._programmed)

    @property
    def compensated(self) -> FloatArray:
        """(n_axes, n): where the words that were written name them."""
        return np.hstack(self._compensated)


@dataclass(frozen=True, slots=True)
class Errors:
    """Magnitudes of one kind of error: uncompensated; after the solver, before words are rounded; with the words, at
    the programmed points; and at the middles and ends of all executed feed blocks.
    """

    before: Summary | None
    solved: Summary | None
    after: Summary | None
    along: Summary | None


@dataclass(frozen=True, slots=True)
class PassedCode:
    """An M code that --pass-m vouches for, and where it occurs."""

    code: int
    lines: Lines


@dataclass(frozen=True, slots=True, kw_only=True)
class CompensationReport:
    """Counts, and lengths of error vectors (actual minus wanted tool point, workpiece frame) in mm.

    blocks_in, blocks_out: lines read and written. units: of the words, mm and inch. moves: blocks that move;
    kept_motions: those that --keep-g53 left as they are, and G28 and G30; kept_holes: holes of cycles that stay
    cycles, and the error at the worse end of each, mm, which no word can take back; points: their ends with those
    of chords and cuts; short_blocks: points passed within a block of their own. take_ups: blocks that take up what
    a reversal changes; they are no part of `along`, the tool stands in them. iterations[k]: points that took k
    corrections.
    before: as programmed, uncompensated. solved: after the solver, before words are rounded. after: with the words, at
    the points. along: at the ends and middles of all executed feed blocks, whose ends are not all programmed points.
    not_converged: points the solver gave up. over_tolerance: points with `after` above the tolerance.
    out_of_travel: points whose compensated position is outside the travel: their words stop at its end; beyond_travel:
    by how much at most, mm or deg, of the axes that would leave it.
    parked_at_end: the same of rapids in machine coordinates (G53), which do no harm; they are in no other figure.
    uncommanded: points at which an axis got no word because the program has not commanded it yet; uncommanded_left: the
    error left there. Rapids to such points are not in the other figures. unknown_places: what it may cost there that
    axes may stand anywhere; None where none may. unnamed_feeds: feed motions while the program has not moved an axis so
    far; None where there are none. offsets: the work offsets, and how much the words depend on them.
    tools: those of --tools, with their points.
    senses: which way the model takes each linear axis to move the tool.
    sign_check: where a gauge shows whether the sign of the error values is right; None where nothing would be seen.
    kinematics_check: where the axes stand under tool centre point control; None without it, or where nothing turns.
    passed: M codes that --pass-m vouches for, with their lines.
    unplaced: where no work offset is known, by how much words may change with its zero anywhere in the travel, mm.
    warnings: what may cost a crash or a wrong part; notes: all else that is to be known.
    reliance: how far the program relies on what was measured; None where nobody asked.
    ball: |E| of Eq. (6), mm. orientation: angle between actual and wanted tool axis, urad, on machines with rotary
    axes. over_orientation: points with orientation.after above its tolerance, where orientation is corrected.
    effects: what was done about each effect of the machine.
    singular: points at which one direction of the tool axis cannot be corrected, see orientation.SINGULAR.
    """

    program: str
    language: str
    settings: Settings
    blocks_in: int
    blocks_out: int
    units: tuple[str, ...]
    moves: int
    kept_motions: int
    kept_holes: Summary | None
    points: int
    short_blocks: int
    take_ups: int
    iterations: tuple[int, ...]
    before: Summary | None
    solved: Summary | None
    after: Summary | None
    along: Summary | None
    ball: Errors | None
    orientation: Errors | None
    not_converged: Lines
    over_tolerance: Lines
    out_of_travel: Lines
    beyond_travel: Mapping[str, float]
    parked_at_end: Lines
    over_orientation: Lines
    singular: Lines
    uncommanded: Lines
    uncommanded_left: Summary | None
    unknown_places: UnknownPlaces | None
    unnamed_feeds: UnnamedFeeds | None
    offsets: tuple[OffsetUse, ...]
    tools: tuple[ToolUse, ...]
    effects: tuple[EffectNote, ...]
    senses: Senses
    sign_check: SignCheck | None
    kinematics_check: KinematicsCheck | None
    passed: tuple[PassedCode, ...]
    unplaced: float | None
    warnings: tuple[str, ...]
    notes: tuple[str, ...]
    reliance: Reliance | None = None

    @property
    def good(self) -> bool:
        """Whether every point converged, is within the tolerances and within the travel, and it may be relied on."""
        return not self.refused and not self.failures

    @property
    def failures(self) -> tuple[Failure, ...]:
        """What of what was written is not good."""
        kinds: tuple[tuple[Failure, bool], ...] = (
            ("not converged", self.not_converged.points > 0),
            ("above tolerance", self.over_tolerance.points > 0),
            ("out of travel", self.out_of_travel.points > 0),
            ("tool axis above tolerance", self.over_orientation.points > 0),
            ("above within ranges of offsets", self.over_range),
            ("above at other places of axes", self.over_places),
            ("nothing moves", not self.moves and not self.kept_motions),
        )
        return tuple(name for name, found in kinds if found)

    @property
    def tolerance(self) -> float:
        """The largest tool point error allowed, mm: the smallest where words are in mm and in inch."""
        return min((self.settings.allowed(unit == "inch") for unit in self.units), default=self.settings.aim)

    @property
    def over_range(self) -> bool:
        """Whether points may be above the tolerance at work offsets within the ranges given."""
        largest = 0.0 if self.after is None else self.after.largest
        return any(
            one.change is not None and (one.leaves_travel or largest + one.change > self.tolerance)
            for one in self.offsets
        )

    @property
    def over_places(self) -> bool:
        """Whether points of feed motions may be above the tolerance, as axes may stand anywhere in their travel."""
        largest = 0.0 if self.after is None else self.after.largest
        feeds = self.unnamed_feeds
        return feeds is not None and feeds.anywhere is not None and largest + feeds.anywhere.largest > self.tolerance

    @property
    def refused(self) -> bool:
        """Whether nothing was written, as it would rely on too little."""
        return self.reliance is not None and self.reliance.refused

    def to_json(self) -> str:
        """The report as JSON; `settings.start` as an object of axis positions, `settings.tolerance` as it was taken."""
        tree = asdict(self)
        tree["settings"]["tolerance"] = self.tolerance
        tree["settings"]["start"] = dict(self.settings.start)
        tree["settings"]["assumed"] = dict(self.settings.assumed)
        return json.dumps({"schema": 1, "good": self.good, **tree}, indent=1) + "\n"
