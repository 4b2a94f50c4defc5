"""A positioning test by ISO 230-2, a circular test by ISO 230-4 or a diagonal test, by what the files hold."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import permutations
from os import PathLike
from pathlib import Path
from typing import get_args

import numpy as np

from trueaxis.evaluation.circular_contributions import contributions
from trueaxis.evaluation.circular_test import circular_figures, circular_test
from trueaxis.evaluation.diagonal_test import DIAGONALS, diagonal_figures, diagonal_test
from trueaxis.evaluation.positioning_test import (
    FEWEST_CYCLES,
    LARGEST_DEVIATION,
    PositioningTest,
    Repeatability,
    Unit,
    too_few,
)
from trueaxis.evaluation.positioning_test import evaluate as evaluate_positioning
from trueaxis.instrument_files.csv_file import OF_BALL_BAR, read_csv
from trueaxis.instrument_files.read import mapped_tests, positioning_test, positioning_tests, recognised
from trueaxis.instrument_files.user_keys import UserKeys
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.input_files import gathering
from trueaxis.jobs.evaluated import Evaluated, EvaluatedCircle, EvaluatedDiagonals, EvaluatedPositioning
from trueaxis.jobs.given import Spelled, argument
from trueaxis.jobs.import_readings import KeyValue, key_text
from trueaxis.jobs.tables import above_zero
from trueaxis.jobs.typed import AnyPath, typed
from trueaxis.machine.machine import LINEAR
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
    diagonals: Mapping[str, float] | None = None


@typed
def evaluate(
    data: AnyPath | Sequence[AnyPath] | PositioningTest | Mapping[str, PositioningTest],
    *,
    repeatability: Repeatability = "iso",
    swap_directions: bool = False,
    rotary: bool = False,
    plane: str | None = None,
    radius: float | None = None,
    feed: float | None = None,
    keys: Mapping[str, KeyValue] | None = None,
    diagonals: Mapping[str, float] | None = None,
) -> Evaluated:
    """Evaluate a positioning test by ISO 230-2:2014 (k = 2) or a circular test by ISO 230-4; the files decide which.
    With `diagonals`, a diagonal test.

    data: the file of a positioning test, or the tables of a ball bar; or a `PositioningTest` of arrays. Of a diagonal
    test files of positioning tests, or `PositioningTest`s by name of the diagonal ("ppp"). Of a positioning test:
    repeatability "iso", the standard's R, or "unidirectional", the larger R of the two directions; swap_directions:
    readings labelled forward were approached in the negative direction; rotary: the files are of a rotary axis, in deg
    (arrays have `PositioningTest.unit`). Of a circular test: plane, such as "XY", angles count from the first axis to
    the second; radius: nominal length of the bar, mm; feed: mm/min, if no file has it. Of both: keys, columns and units
    that the headers do not give, as in `import_readings`. Of a diagonal test: diagonals, how far each axis goes along
    one of them, mm, by letter, two axes or three; keys, repeatability and swap_directions. Raises InputError with every
    fault, also for arguments of the other kind of test; ValueError for arguments of another form.
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
        rotary=rotary, diagonals=None if diagonals is None else _lengths(diagonals),
    )  # fmt: skip
    if isinstance(data, Mapping):
        if options.diagonals is None:
            raise ValueError("data: several tests are diagonals: give how far each axis goes, diagonals")
        if options.keys:
            raise ValueError("keys: they name columns of files; given tests of arrays")
        if any(one.unit != "mm" for one in data.values()):
            raise ValueError("data: expected tests in mm; diagonals are lengths")
        runs = [("data", name, _checked(one, fewest_cycles=1)) for name, one in data.items()]
        return _diagonals(runs, "the readings", options, argument)
    if isinstance(data, PositioningTest):
        if options.diagonals is not None:
            raise ValueError("data: expected files, or tests by name of the diagonal; given one without a name")
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
    if options.diagonals is not None:
        with gathering(faults):
            _check_keys(paths, " ".join(map(str, paths)), options, spelled)
        runs: list[tuple[str, str, PositioningTest]] = []
        for path in paths:
            with gathering(faults):
                runs += [(str(path), name, one) for name, one in _along_diagonals(path, options.keys).items()]
        if faults:
            raise InputError(faults)
        return _diagonals(runs, " ".join(map(str, paths)), options, spelled)
    for path in paths:
        with gathering(faults):
            circles.append(_is_circle(path, options.keys))
    if faults:
        raise InputError(faults)
    if any(circles) != all(circles) or (len(paths) > 1 and not circles[0]):
        problem = "positioning tests are evaluated one by one" if not any(circles) else "are tests of two kinds"
        remedy = (
            f"one test at a time; along diagonals: {spelled('diagonals')}" if not any(circles) else "one test at a time"
        )
        raise InputError([Fault(" ".join(map(str, paths)), "", problem, remedy)])
    return _circular(paths, options, spelled) if circles[0] else _positioning(paths[0], str(paths[0]), options, spelled)


def _is_circle(path: Path, keys: Mapping[str, str]) -> bool:
    """Whether a file is of a ball bar: by its heads, or because the user says which column has angles or radii.

    Raises InputError where it is of no known kind.
    """
    found = recognised(path)
    named = {key.rpartition(":")[2] for key in keys}
    return found == "ballbar-csv" or (found == "csv" and any(f"column.{name}" in named for name in OF_BALL_BAR))


def _positioning(
    data: Path | PositioningTest, source: str, options: EvaluateOptions, spelled: Spelled
) -> EvaluatedPositioning:
    unfit = [name for name in ("plane", "radius", "feed") if getattr(options, name)]
    if unfit:
        problem = f"{source} is a positioning test"
        raise InputError([Fault(spelled(name), "", problem, "leave it out: it is of circular tests") for name in unfit])
    _check_keys([data] if isinstance(data, Path) else [], source, options, spelled)
    unit: Unit = "deg" if options.rotary else "mm"
    if isinstance(data, Path):
        test = _the_only_one(data, options.keys, unit) if options.keys else positioning_test(data, unit)
    else:
        test = data
    test = test.swapped() if options.swap_directions else test
    return EvaluatedPositioning(source=source, evaluation=evaluate_positioning(test, options.repeatability))


def _check_keys(paths: Sequence[Path], source: str, options: EvaluateOptions, spelled: Spelled) -> None:
    """Raises InputError where keys are given and no file needs them."""
    if options.keys and not any(recognised(path) == "csv" for path in paths):
        problem = f"{source} names its columns and units itself"
        raise InputError([Fault(spelled("keys"), "", problem, "leave it out: it is of tables with other names")])


def _the_only_one(path: Path, keys: Mapping[str, str], unit: Unit) -> PositioningTest:
    tests = mapped_tests(path, keys, unit)
    if len(tests) > 1:
        raise InputError([Fault(str(path), "", f"has {len(tests)} runs", "a file of one test")])
    (test,) = tests.values()
    return test


def _along_diagonals(path: Path, keys: Mapping[str, str]) -> dict[str, PositioningTest]:
    """The tests of a file; keys name the columns and units of tables."""
    if keys and recognised(path) == "csv":
        return mapped_tests(path, keys, fewest_cycles=1)
    return positioning_tests(path, fewest_cycles=1)


def _diagonals(
    runs: Sequence[tuple[str, str, PositioningTest]], source: str, options: EvaluateOptions, spelled: Spelled
) -> EvaluatedDiagonals:
    unfit = [name for name in ("plane", "radius", "feed", "rotary") if getattr(options, name)]
    if unfit:
        problem = f"{source} is a diagonal test"
        raise InputError([Fault(spelled(name), "", problem, "leave it out: it is of other tests") for name in unfit])
    if options.swap_directions:
        runs = [(file, name, one.swapped()) for file, name, one in runs]
    test = diagonal_test(runs, options.diagonals or {}, source)
    return EvaluatedDiagonals(source=source, test=test, figures=diagonal_figures(test, options.repeatability))


def _lengths(diagonals: Mapping[str, float]) -> dict[str, float]:
    """Raises ValueError where these are not two or three linear axes with their lengths."""
    if len(diagonals) not in DIAGONALS or not set(diagonals) <= set(LINEAR):
        raise ValueError(f"diagonals: expected lengths of two axes or three of X, Y, Z; given {dict(diagonals)!r}")
    above_zero(**{f"diagonals[{axis!r}]": value for axis, value in diagonals.items()})
    return {axis: float(value) for axis, value in diagonals.items()}


def _checked(test: PositioningTest, fewest_cycles: int = FEWEST_CYCLES) -> PositioningTest:
    """The arrays of a test, by ascending targets. Raises ValueError where a shape or a size is not right."""
    given_arrays = (test.targets, test.positive, test.negative)
    targets, positive, negative = (np.asarray(one, dtype=np.float64) for one in given_arrays)
    if targets.ndim != 1 or positive.ndim != 2 or positive.shape != negative.shape or len(positive) != targets.size:
        given = f"{targets.shape}, {positive.shape}, {negative.shape}"
        raise ValueError(f"data: expected targets (m,), positive and negative (m, n), {test.unit}; given {given}")
    span = float(np.ptp(targets)) if targets.size else 0.0
    if problem := too_few("target", targets.size) or too_few(
        "cycle", positive.shape[1], span, test.unit, fewest_cycles
    ):
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
    keys = UserKeys(given=options.keys)
    runs: list[InstrumentRun] = []
    for path in paths:
        with gathering(found):
            runs += read_csv(path, keys, ballbar=True)
    found += [*keys.unknown(), *keys.faults, *(one.fault for one in keys.questions)]
    if found or plane is None or radius is None:
        raise InputError(found)
    test = circular_test(runs, (plane[0], plane[1]), radius, options.feed, source)
    return EvaluatedCircle(source=source, test=test, figures=circular_figures(test), contributions=contributions(test))
