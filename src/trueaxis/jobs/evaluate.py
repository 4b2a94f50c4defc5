"""A positioning test by ISO 230-2, or a circular test by ISO 230-4, by what the files hold."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from itertools import permutations
from os import PathLike
from pathlib import Path
from typing import get_args

import numpy as np
import polars as pl

from trueaxis.evaluation.iso230_2 import report as positioning_report
from trueaxis.evaluation.iso230_2.evaluation import Evaluation, Repeatability
from trueaxis.evaluation.iso230_2.evaluation import evaluate as evaluate_positioning
from trueaxis.evaluation.iso230_2.positioning_test import LARGEST_DEVIATION, PositioningTest, too_few
from trueaxis.evaluation.iso230_2.table_file import read_positioning_test
from trueaxis.evaluation.iso230_4 import report as circular_report
from trueaxis.evaluation.iso230_4.circular_test import CircularTest, circular_test
from trueaxis.evaluation.iso230_4.contributions import Contributions, contributions
from trueaxis.evaluation.iso230_4.figures import CircularFigures, about_centre, circular_figures
from trueaxis.evaluation.vdi3441 import Vdi3441
from trueaxis.evaluation.vdi3441 import figures_of as vdi3441_of
from trueaxis.instrument_files.csv_file import read_csv
from trueaxis.instrument_files.read import recognised
from trueaxis.instrument_files.user_keys import UserKeys
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.input_files import gathering
from trueaxis.jobs.given import Spelled, argument
from trueaxis.jobs.import_readings import KeyValue, key_text
from trueaxis.jobs.load import AnyPath
from trueaxis.jobs.tables import Printed, Tabular, above_zero
from trueaxis.measurement.instrument_run import InstrumentRun

PLANES = tuple(map("".join, permutations("XYZ", 2)))


@dataclass(frozen=True, slots=True, kw_only=True)
class EvaluateOptions:
    """As the arguments of `evaluate`."""

    repeatability: Repeatability = "iso"
    swap_directions: bool = False
    plane: str | None = None
    radius: float | None = None
    feed: float | None = None
    keys: Mapping[str, str]
    rotary: bool = False


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


Evaluated = EvaluatedPositioning | EvaluatedCircle


def evaluate(
    data: AnyPath | Sequence[AnyPath] | PositioningTest,
    *,
    repeatability: Repeatability = "iso",
    swap_directions: bool = False,
    rotary: bool = False,
    plane: str | None = None,
    radius: float | None = None,
    feed: float | None = None,
    keys: Mapping[str, KeyValue] | None = None,
) -> Evaluated:
    """Evaluate a positioning test by ISO 230-2:2014 (k = 2) or a circular test by ISO 230-4; the files decide which.

    data: the file of a positioning test, or the tables of a ball bar; or a `PositioningTest` of arrays. Of a
    positioning test: repeatability "iso", the standard's R, or "unidirectional", the larger R of the two directions;
    swap_directions: readings labelled forward were approached in the negative direction; rotary: the files are of a
    rotary axis, in deg (arrays have `PositioningTest.unit`). Of a circular test: plane, such as "XY", angles count from
    the first axis to the second; radius: nominal length of the bar, mm; feed: mm/min, if no file has it; keys: columns
    and units that the headers do not give, as in `import_readings`. Raises InputError with every fault, also for
    arguments of the other kind of test; ValueError for arguments of another form.
    """
    if repeatability not in get_args(Repeatability):
        raise ValueError(
            f"repeatability: expected one of {', '.join(get_args(Repeatability))}; given {repeatability!r}"
        )
    if plane is not None and plane not in PLANES:
        raise ValueError(f"plane: expected one of {', '.join(PLANES)}; given {plane!r}")
    above_zero(radius=radius, feed=feed)
    texts = {key: key_text(key, value) for key, value in (keys or {}).items()}
    options = EvaluateOptions(
        repeatability=repeatability, swap_directions=swap_directions, plane=plane, radius=radius, feed=feed, keys=texts,
        rotary=rotary,
    )  # fmt: skip
    if isinstance(data, PositioningTest):
        return _positioning(_checked(data), "the readings", options, argument)
    paths = [Path(one) for one in ([data] if isinstance(data, str | PathLike) else data)]
    if not paths:
        raise ValueError("data: expected a file or several; given none")
    return evaluated(paths, options)


def evaluated(
    paths: Sequence[Path], options: EvaluateOptions, spelled: Spelled = argument, found: Sequence[Fault] = ()
) -> Evaluated:
    """As `evaluate`. found: faults so far, told with those of what the files are."""
    circles, faults = [], list(found)
    for path in paths:
        with gathering(faults):
            circles.append(recognised(path) == "ballbar-csv")
    if faults:
        raise InputError(faults)
    if any(circles) != all(circles) or (len(paths) > 1 and not circles[0]):
        problem = "positioning tests are evaluated one by one" if not any(circles) else "are tests of two kinds"
        raise InputError([Fault(" ".join(map(str, paths)), "", problem, "one test at a time")])
    return _circular(paths, options, spelled) if circles[0] else _positioning(paths[0], str(paths[0]), options, spelled)


def _positioning(
    data: Path | PositioningTest, source: str, options: EvaluateOptions, spelled: Spelled
) -> EvaluatedPositioning:
    unfit = [name for name in ("plane", "radius", "feed", "keys") if getattr(options, name)]
    if unfit:
        problem = f"{source} is a positioning test"
        raise InputError([Fault(spelled(name), "", problem, "leave it out: it is of circular tests") for name in unfit])
    test = read_positioning_test(data, "deg" if options.rotary else "mm") if isinstance(data, Path) else data
    test = test.swapped() if options.swap_directions else test
    return EvaluatedPositioning(source=source, evaluation=evaluate_positioning(test, options.repeatability))


def _checked(test: PositioningTest) -> PositioningTest:
    """The arrays of a test, by ascending targets. Raises ValueError where a shape or a size is not right."""
    given_arrays = (test.targets, test.positive, test.negative)
    targets, positive, negative = (np.asarray(one, dtype=np.float64) for one in given_arrays)
    if targets.ndim != 1 or positive.ndim != 2 or positive.shape != negative.shape or len(positive) != targets.size:
        given = f"{targets.shape}, {positive.shape}, {negative.shape}"
        raise ValueError(f"data: expected targets (m,), positive and negative (m, n), {test.unit}; given {given}")
    span = float(np.ptp(targets)) if targets.size else 0.0
    if problem := too_few("target", targets.size) or too_few("cycle", positive.shape[1], span, test.unit):
        raise ValueError(f"data: {problem}")
    off = np.hstack([positive, negative]) - targets[:, np.newaxis]
    if not (np.abs(off) <= LARGEST_DEVIATION).all():  # NaN is not
        raise ValueError(
            f"data: expected positions within {LARGEST_DEVIATION:g} {test.unit} of their targets, all finite"
        )
    order = np.argsort(targets)
    return PositioningTest(targets[order], positive[order], negative[order], test.unit)


def _circular(paths: Sequence[Path], options: EvaluateOptions, spelled: Spelled) -> EvaluatedCircle:
    source = " ".join(map(str, paths))
    plane, radius = options.plane, options.radius
    found = []
    for name, value, right in (("plane", plane, "XY"), ("radius", radius, "150")):
        if value is None:
            found.append(Fault(source, "", f"does not say the {name} of the circle", f"{spelled(name)} {right}"))
    for name, used in (
        ("repeatability", options.repeatability != "iso"),
        ("swap_directions", options.swap_directions),
        ("rotary", options.rotary),
    ):
        if used:
            problem = f"{source} is a circular test"
            found.append(Fault(spelled(name), "", problem, "leave it out: it is of positioning tests"))
    keys = UserKeys(options.keys)
    runs: list[InstrumentRun] = []
    for path in paths:
        with gathering(found):
            runs += read_csv(path, keys, ballbar=True)
    found += [*keys.unknown(), *keys.faults, *(one.fault for one in keys.questions)]
    if found or plane is None or radius is None:
        raise InputError(found)
    test = circular_test(runs, (plane[0], plane[1]), radius, options.feed, source)
    return EvaluatedCircle(source=source, test=test, figures=circular_figures(test), contributions=contributions(test))
