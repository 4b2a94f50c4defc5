"""What `evaluate` returns: a positioning test, a circular test or a diagonal test with its figures."""

from dataclasses import asdict, dataclass, field
from pathlib import Path

import polars as pl

from trueaxis.evaluation import circular_report, diagonal_report, positioning_report
from trueaxis.evaluation.circular_contributions import Contributions
from trueaxis.evaluation.circular_test import CircularFigures, CircularTest, about_centre
from trueaxis.evaluation.diagonal_test import DiagonalFigures, DiagonalTest
from trueaxis.evaluation.positioning_test import Evaluation
from trueaxis.evaluation.vdi3441 import Vdi3441
from trueaxis.evaluation.vdi3441 import figures_of as vdi3441_of
from trueaxis.jobs.printed import Printed
from trueaxis.jobs.tables import Tabular


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class EvaluatedPositioning(Printed, Tabular):
    """A positioning test. source: what was evaluated; evaluation: the parameters of the standard, mm or deg. Printed,
    it is the report of `trueaxis evaluate`.
    """

    source: str
    evaluation: Evaluation

    @property
    def vdi3441(self) -> Vdi3441 | None:
        """The axis's figures by VDI/DGQ 3441; None of a test with one cycle."""
        return vdi3441_of(self.evaluation)

    def to_polars(self) -> pl.DataFrame:
        """A row for each target, mm: mean deviations, standard uncertainties, reversal value, repeatability."""
        of = self.evaluation
        sides = {"positive": of.positive, "negative": of.negative}
        columns = {f"{name}_{part}": getattr(side, part) for part in ("mean", "s", "r") for name, side in sides.items()}
        return pl.DataFrame({"target": of.targets, **columns, "mean": of.mean, "reversal": of.b, "repeatability": of.r})

    def to_json(self) -> str:
        """The values as `--out` of the command has them."""
        return positioning_report.report_json(self.evaluation)

    @property
    def has_picture(self) -> bool:
        """Whether there are bands to be drawn: of two cycles or more."""
        return self.evaluation.cycles > 1

    def picture(self) -> bytes:
        """Mean deviations with bands of 2 s, as PNG. Raises ValueError without `has_picture`."""
        if not self.has_picture:
            raise ValueError("picture: a test of one cycle gives no bands")
        from trueaxis.reporting.pictures.standard_tests import positioning_plot  # noqa: PLC0415  matplotlib takes long to import

        return positioning_plot(self.evaluation, Path(self.source).stem)

    def __str__(self) -> str:
        return positioning_report.report_text(self.source, self.evaluation)


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class EvaluatedCircle(Printed, Tabular):
    """A circular test. source: what was evaluated; test: its arcs; figures: G, G(b), F, D of the standard, mm;
    contributions: the errors that the deviations are made of, by size. Printed, it is the report of `trueaxis
    evaluate`.
    """

    source: str
    test: CircularTest = field(repr=False)
    figures: CircularFigures
    contributions: Contributions

    def to_polars(self) -> pl.DataFrame:
        """A row for each error that the deviations are made of, largest first."""
        return pl.DataFrame([asdict(one) for one in self.contributions.largest])

    def to_json(self) -> str:
        """The values as `--out` of the command has them."""
        return circular_report.report_json(self.test, self.figures, self.contributions)

    @property
    def has_picture(self) -> bool:
        """Every circle has one."""
        return True

    def picture(self) -> bytes:
        """The circle, as PNG."""
        from trueaxis.reporting.pictures.standard_tests import Trace, polar_plot  # noqa: PLC0415  matplotlib takes long to import

        circles = zip(self.test.arcs, about_centre(self.test), strict=True)
        traces = [Trace(one.id, one.angle, radial) for one, radial in circles]
        return polar_plot([(f"plane {''.join(self.test.plane)}", traces)], self.source)

    def __str__(self) -> str:
        return circular_report.report_text(self.source, self.test, self.figures, self.contributions)


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class EvaluatedDiagonals(Printed, Tabular):
    """A diagonal test. source: what was evaluated; test: its readings; figures: of each diagonal, the largest E and B,
    scales, squarenesses. Printed, it is the report of `trueaxis evaluate`.
    """

    source: str
    test: DiagonalTest = field(repr=False)
    figures: DiagonalFigures

    def to_polars(self) -> pl.DataFrame:
        """A row for each diagonal: E, B, R, A, M in mm; R and A NaN of one cycle; scale as a ratio."""
        rows = [
            {"diagonal": one.name, **{name: getattr(one.evaluation, name) for name in "EBRAM"}, "scale": one.scale}
            for one in self.figures.diagonals
        ]
        return pl.DataFrame(rows)

    def to_json(self) -> str:
        """The values as `--out` of the command has them."""
        return diagonal_report.report_json(self.test, self.figures)

    @property
    def has_picture(self) -> bool:
        """Every diagonal test has one."""
        return True

    def picture(self) -> bytes:
        """Mean deviations of all diagonals, as PNG."""
        from trueaxis.reporting.pictures.standard_tests import diagonal_plot  # noqa: PLC0415  matplotlib takes long to import

        return diagonal_plot(self.figures)

    def __str__(self) -> str:
        return diagonal_report.report_text(self.source, self.test, self.figures)


Evaluated = EvaluatedPositioning | EvaluatedCircle | EvaluatedDiagonals
