"""What a compensation did."""

import json
from dataclasses import asdict, dataclass

from trueaxis.compensate.settings import Settings
from trueaxis.compensate.statistics import Lines, Summary


@dataclass(frozen=True, slots=True)
class BallBar:
    """|E| of Eq. (6), mm: uncompensated; after the solver, before words are rounded; with the words, at the programmed
    points; and at the middles and ends of all executed feed blocks.
    """

    before: Summary | None
    solved: Summary | None
    after: Summary | None
    along: Summary | None


@dataclass(frozen=True, slots=True)
class CompensationReport:
    """Counts, and lengths of error vectors (actual minus wanted tool point, workpiece frame) in mm.

    blocks_in, blocks_out: lines read and written. moves: blocks that move; points: their ends with those of chords and
    cuts; short_blocks: points passed within a block of their own. iterations[k]: points that took k corrections.
    before: as programmed, uncompensated. solved: after the solver, before words are rounded. after: with the words, at
    the points. along: at the ends and middles of all executed feed blocks, whose ends are not all programmed points.
    not_converged: points the solver gave up. over_tolerance: points with `after` above the tolerance.
    out_of_travel: points whose command leaves the travel of an axis.
    """

    program: str
    language: str
    settings: Settings
    blocks_in: int
    blocks_out: int
    moves: int
    points: int
    short_blocks: int
    iterations: tuple[int, ...]
    before: Summary | None
    solved: Summary | None
    after: Summary | None
    along: Summary | None
    ball: BallBar | None
    not_converged: Lines
    over_tolerance: Lines
    out_of_travel: Lines
    notes: tuple[str, ...]

    @property
    def good(self) -> bool:
        """Whether every point converged, is within the tolerance and within the travel."""
        return not (self.not_converged.points or self.over_tolerance.points or self.out_of_travel.points)

    def to_json(self) -> str:
        """The report as JSON; `settings.start` as an object of axis positions."""
        tree = asdict(self)
        tree["settings"]["start"] = dict(self.settings.start)
        return json.dumps({"schema": 1, "good": self.good, **tree}, indent=1) + "\n"

    def __str__(self) -> str:
        settings = self.settings
        lines = [
            f"{self.program} ({self.language.upper()}): {self.blocks_in} blocks read, {self.blocks_out} written; "
            f"{self.moves} moves, {self.points} points"
            + (f", {self.short_blocks} passed in short blocks" if self.short_blocks else ""),
            f"method {settings.method}, words {settings.words}, resolution {settings.resolution:g} mm, "
            f"tolerance {settings.tolerance:g} mm",
            "corrections made: " + ", ".join(f"{k}: {n} points" for k, n in enumerate(self.iterations) if n),
            f"{'error vector (mm)':34s}{'mean':>12s}{'sd':>12s}{'largest':>12s}  at line",
            *_rows(self),
        ]
        if self.ball is not None:
            lines.append("|E| along the ball bar, Eq. (6) (mm)")
            lines.extend(_rows(self.ball))
        for name, found in (
            ("not converged", self.not_converged),
            ("above tolerance", self.over_tolerance),
            ("out of travel", self.out_of_travel),
        ):
            if found.points:
                lines.append(f"{name}: {found}")
        lines.extend(f"note: {note}" for note in self.notes)
        return "\n".join(lines)


def _rows(of: CompensationReport | BallBar) -> list[str]:
    table = (
        ("  as programmed", of.before),
        ("  compensated, words not rounded", of.solved),
        ("  compensated, as written", of.after),
        ("  along the executed feed blocks", of.along),
    )
    return [
        f"{name:34s}{part.mean:12.7f}{part.sd:12.7f}{part.largest:12.7f}  {part.line}"
        for name, part in table
        if part is not None
    ]
