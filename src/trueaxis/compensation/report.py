"""What a compensation did; and, for who asks for it, what it changed point by point, which grows with the program."""

import json
import math
from dataclasses import asdict, dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.elsewhere import OffsetUse, UnknownPlaces, UnnamedFeeds
from trueaxis.compensation.logs import Lines, Summary
from trueaxis.compensation.machine import FloatArray
from trueaxis.compensation.reliance import Reliance
from trueaxis.compensation.settings import MM_PER_INCH, Settings
from trueaxis.compensation.sign_check import Senses, SignCheck
from trueaxis.compensation.tools import ToolUse
from trueaxis.compensation.tracker import EffectNote


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
    out_of_travel: points whose compensated position is outside the travel: their words stop at its end.
    parked_at_end: the same of rapids in machine coordinates (G53), which do no harm; they are in no other figure.
    uncommanded: points at which an axis got no word because the program has not commanded it yet; uncommanded_left: the
    error left there. Rapids to such points are not in the other figures. unknown_places: what it may cost there that
    axes may stand anywhere; None where none may. unnamed_feeds: feed motions while the program has not moved an axis so
    far; None where there are none. offsets: the work offsets, and how much the words depend on them.
    tools: those of --tools, with their points.
    senses: which way the model takes each linear axis to move the tool.
    sign_check: where a gauge shows whether the sign of the error values is right; None where nothing would be seen.
    passed: M codes that --pass-m vouches for, with their lines.
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
    passed: tuple[PassedCode, ...]
    notes: tuple[str, ...]
    reliance: Reliance | None = None

    @property
    def good(self) -> bool:
        """Whether every point converged, is within the tolerances and within the travel, and it may be relied on."""
        return not self.refused and not self.failure

    @property
    def failure(self) -> str:
        """Why what was written is not good, in a few words; empty where it is."""
        kinds = (
            ("points did not converge", self.not_converged.points),
            ("points above the tolerance", self.over_tolerance.points),
            ("points out of travel", self.out_of_travel.points),
            ("tool axis above its tolerance", self.over_orientation.points),
            ("not good for all work offsets in the ranges given", self.over_range),
            ("not good wherever axes may stand", self.over_places),
            ("nothing in the program moves an axis", not self.moves and not self.kept_motions),
        )
        return ", ".join(name for name, found in kinds if found)

    @property
    def over_range(self) -> bool:
        """Whether points may be above the tolerance at work offsets within the ranges given."""
        largest = 0.0 if self.after is None else self.after.largest
        return any(
            one.change is not None and (one.leaves_travel or largest + one.change > self.settings.tolerance)
            for one in self.offsets
        )

    @property
    def over_places(self) -> bool:
        """Whether points of feed motions may be above the tolerance, as axes may stand anywhere in their travel."""
        largest = 0.0 if self.after is None else self.after.largest
        feeds = self.unnamed_feeds
        return feeds is not None and feeds.anywhere is not None and largest + feeds.anywhere.largest > (
            self.settings.tolerance
        )  # fmt: skip

    @property
    def refused(self) -> bool:
        """Whether nothing was written, as it would rely on too little."""
        return self.reliance is not None and self.reliance.refused

    def _coarse_words(self) -> list[str]:
        """Where the rounding of words alone passes the tolerance, so that no compensation can reach it."""
        settings, found = self.settings, []
        for inch in (False, True) if self.over_tolerance.points else ():
            step, unit = (settings.inch_step, "inch") if inch else (settings.resolution, "mm")
            off = 0.5 * math.sqrt(3.0) * step * (MM_PER_INCH if inch else 1.0)
            if off > settings.tolerance and unit in self.units:
                found.append(
                    f"words of {step:g} {unit} are up to {1e3 * off:.1f} um off, more than the tolerance: it cannot be "
                    "reached everywhere with these words"
                )
        return found

    def to_json(self) -> str:
        """The report as JSON; `settings.start` as an object of axis positions."""
        tree = asdict(self)
        tree["settings"]["start"] = dict(self.settings.start)
        tree["settings"]["assumed"] = dict(self.settings.assumed)
        return json.dumps({"schema": 1, "good": self.good, **tree}, indent=1) + "\n"

    def __str__(self) -> str:
        settings = self.settings
        lines = [
            f"{self.program} ({self.language.upper()}): {self.blocks_in} blocks read, {self.blocks_out} written; "
            f"{self.moves} moves, {self.points} points"
            + (f", {self.short_blocks} passed in short blocks" if self.short_blocks else "")
            + (f", {self.take_ups} blocks that take up reversals" if self.take_ups else ""),
            *([f"not good, exit code 1: {self.failure}"] if self.failure and not self.refused else []),
            f"{'error of the tool point (um)':34s}{'mean':>10s}{'sd':>10s}{'largest':>10s}  at line",
            *_rows(self),
        ]
        if self.ball is not None:
            lines.append("|E| along the ball bar, Eq. (6) (um)")
            lines.extend(_rows(self.ball))
        if self.orientation is not None:
            corrected = "corrected" if settings.orientation == "correct" else "kept: linear axes alone are corrected"
            lines.append(f"orientation of the tool axis, {corrected} (urad)")
            lines.extend(_rows(self.orientation, 1.0))
        lines += [*self._troubles(), *self._places()]
        lines.extend(
            f"M{one.code} passed, as --pass-m says that it moves nothing and changes no mode: "
            f"{one.lines.points} times, lines {one.lines.shown}"
            for one in self.passed
        )
        if self.parked_at_end.points:
            lines.append(
                f"note: rapids in machine coordinates (G53) stop at the end of travel: {self.parked_at_end}; nothing "
                "is cut there, and they count as no fault"
            )
        lines.extend(f"note: {note}" for note in self.notes)
        lines += [str(self.senses), *([str(self.sign_check)] if self.sign_check is not None else [])]
        steps = ", ".join(f"{k}: {n} points" for k, n in enumerate(self.iterations) if n)
        lines.append(
            f"method {settings.method}, words {settings.words}, resolution {settings.resolution:g} mm, tolerance "
            f"{settings.tolerance:g} mm; corrections made: {steps}"
        )
        return "\n".join(lines)

    def _troubles(self) -> list[str]:
        """Points that are not as they are to be, and why."""
        settings, lines = self.settings, self._coarse_words()
        for name, found in (
            ("not converged", self.not_converged),
            ("above tolerance", self.over_tolerance),
            ("out of travel, words stop at its end", self.out_of_travel),
            (f"above {settings.orientation_tolerance_urad:g} urad", self.over_orientation),
            ("singular poses, one direction of the tool axis not corrected", self.singular),
        ):
            if found.points:
                lines.append(f"{name}: {found}")
        return lines

    def _places(self) -> list[str]:
        """What effects, axes without words, work offsets, tools and unknown places come to."""
        lines: list[str] = []
        lines.extend(
            f"effect {one.effect}: {'compensated' if one.compensated else 'left alone'}, {one.how}"
            for one in self.effects
        )
        if self.uncommanded_left is not None:
            left = self.uncommanded_left
            lines.append(
                f"axes not commanded yet get no words: {self.uncommanded}; "
                f"largest error left {left.largest:.4f} mm at line {left.line}"
            )
        if self.kept_holes is not None:
            of = self.kept_holes
            lines.append(
                f"{of.count} holes of cycles that are kept: X and Y are those of the middle of the hole, Z and R those "
                f"of its ends; what errors differ by along a hole is left, {of.largest:.4f} mm at most at an end (line "
                f"{of.line})"
            )
        lines.extend(map(str, (*self.offsets, *self.tools)))
        if self.over_range:
            lines.append("above tolerance, or out of travel, at work offsets within the ranges given")
        if self.unknown_places is not None:
            lines.append(str(self.unknown_places))
        if self.unnamed_feeds is not None:
            lines.append(str(self.unnamed_feeds))
        if self.over_places:
            lines.append(
                "above tolerance if these axes stand elsewhere: say by --start where they stand, or command them"
            )
        return lines


def _rows(of: CompensationReport | Errors, unit: float = 1e3) -> list[str]:
    """A line for each stage; unit: what its figures are multiplied by."""
    table = (
        ("  as programmed", of.before),
        ("  compensated, words not rounded", of.solved),
        ("  compensated, as written", of.after),
        ("  along the executed feed blocks", of.along),
    )
    return [
        f"{name:34s}{unit * part.mean:10.2f}{unit * part.sd:10.2f}{unit * part.largest:10.2f}  {part.line}"
        for name, part in table
        if part is not None
    ]
