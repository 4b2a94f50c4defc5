"""trueaxis evaluate: a positioning test by ISO 230-2, or a circular test by ISO 230-4."""

import argparse
from dataclasses import dataclass
from itertools import permutations
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.cli.arguments import file_to_write, key_value, positive
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.evaluation.iso230_2.evaluation import evaluate
from trueaxis.evaluation.iso230_2.read import read_positioning_test
from trueaxis.evaluation.iso230_2.report import report_json, report_text
from trueaxis.evaluation.iso230_4 import report as circular_report
from trueaxis.evaluation.iso230_4.circular_test import circular_test
from trueaxis.evaluation.iso230_4.contributions import contributions
from trueaxis.evaluation.iso230_4.figures import about_centre, circular_figures
from trueaxis.instrument_files.csv_file import read_csv
from trueaxis.instrument_files.read import recognised
from trueaxis.instrument_files.user_keys import UserKeys
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering
from trueaxis.measurement.instrument_run import InstrumentRun

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Evaluate a test by what its file holds. A positioning test of a linear axis up to 2000 mm by ISO 230-2:2014 (k = 2): at
each target mean deviations, reversal value, standard uncertainty and repeatability; of the axis B, R, E, M and A, by
direction and for both. DATA is a table (.csv, .parquet) with columns target, cycle, direction (+1 or forward, -1 or
backward: how the target was approached) and measured, in mm; or a .dat file with TGT_DATA[i], REF_DATA_FWD[i,j],
REF_DATA_BWD[i,j]. A circular test by ISO 230-4: G, G(b), F, and the errors that the deviations are made of, by size:
squareness, scale mismatch, reversal error, lateral play, reversal spikes, servo mismatch, straightness, cyclic error.
DATA are tables of a ball bar (columns angle, and deviation or radius), a file or a column run for each sense."""
OF_CIRCLES = ("--plane", "--radius", "--feed", "--map")
OF_LINES = ("--repeatability", "--swap-directions")


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser(
        "evaluate", help="positioning and circular tests by ISO 230-2 and -4", description=DESCRIPTION
    )
    parser.add_argument("data", type=Path, nargs="+", metavar="DATA", help="the readings: .dat, .csv or .parquet")
    parser.add_argument("--out", type=file_to_write, metavar="REPORT.json", help="write the values as JSON")
    parser.add_argument(
        "--picture",
        type=file_to_write,
        metavar="FILE.png",
        help="draw the mean deviations with bands of 2 s, or the circle",
    )
    parser.add_argument(
        "--repeatability",
        choices=("iso", "unidirectional"),
        default="iso",
        help="the axis's bidirectional R: iso, the standard's, largest over the targets with the reversal (default); "
        "unidirectional, the larger R of the two directions, as some programs report it",
    )
    parser.add_argument(
        "--swap-directions",
        action="store_true",
        help="what DATA labels forward was approached in the negative direction",
    )
    parser.add_argument(
        "--plane", choices=tuple(map("".join, permutations("XYZ", 2))),
        help="of a circular test; angles count from the first axis to the second (XY)",
    )  # fmt: skip
    parser.add_argument("--radius", type=positive, metavar="MM", help="of a circular test: nominal length of the bar")
    parser.add_argument(
        "--feed", type=positive, metavar="MM_MIN", help="of a circular test, where DATA does not say it"
    )
    parser.add_argument(
        "--map", type=key_value, action="extend", nargs="+", default=[], metavar="KEY=VALUE",
        help="of a circular test: columns and units that the headers do not say, as import takes them",
    )  # fmt: skip
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Evaluate, write and print; raises InputError with every fault."""
    named_files = {f"DATA {k}" if len(args.data) > 1 else "DATA": path for k, path in enumerate(args.data, 1)}
    found = overwritten(named_files, {"--out": args.out, "--picture": args.picture})
    circles, faults = [], list(found)
    for path in args.data:
        with gathering(faults):
            circles.append(recognised(path) == "ballbar-csv")
    if faults:
        raise InputError(faults)
    if any(circles) != all(circles) or (len(args.data) > 1 and not circles[0]):
        problem = "positioning tests are evaluated one by one" if not any(circles) else "are tests of two kinds"
        raise InputError([Fault(" ".join(map(str, args.data)), "", problem, "one test at a time")])
    evaluated = _circular(args) if circles[0] else _positioning(args)
    write_files(evaluated.contents)
    print(evaluated.text, end="")
    if evaluated.contents:
        print(f"written: {', '.join(map(named, evaluated.contents))}")
    return 0


@dataclass(frozen=True)
class _Evaluated:
    text: str
    contents: dict[Path, bytes | str]


def _positioning(args: argparse.Namespace) -> _Evaluated:
    (path,) = args.data
    given = (args.plane, args.radius, args.feed, args.map)
    unfit = [option for option, value in zip(OF_CIRCLES, given, strict=True) if value]
    if unfit:
        problem = f"{path} is a positioning test"
        raise InputError([Fault(option, "", problem, "leave it out: it is of circular tests") for option in unfit])
    test = read_positioning_test(path)
    evaluation = evaluate(test.swapped() if args.swap_directions else test, args.repeatability)
    contents: dict[Path, bytes | str] = {}
    if args.out is not None:
        contents[args.out] = report_json(evaluation)
    if args.picture is not None:
        from trueaxis.reporting.pictures.positioning import positioning_plot  # noqa: PLC0415  matplotlib takes long to import

        contents[args.picture] = positioning_plot(evaluation, path.stem)
    return _Evaluated(report_text(str(path), evaluation), contents)


def _circular(args: argparse.Namespace) -> _Evaluated:
    source = " ".join(map(str, args.data))
    found = []
    for option, value in (("--plane", args.plane), ("--radius", args.radius)):
        if value is None:
            right = "--plane XY" if option == "--plane" else "--radius 150"
            found.append(Fault(source, "", f"does not say the {option.removeprefix('--')} of the circle", right))
    for option, value in zip(OF_LINES, (args.repeatability != "iso", args.swap_directions), strict=True):
        if value:
            found.append(Fault(option, "", f"{source} is a circular test", "leave it out: it is of positioning tests"))
    keys = UserKeys(dict(args.map))
    runs: list[InstrumentRun] = []
    for path in args.data:
        with gathering(found):
            runs += read_csv(path, keys, ballbar=True)
    found += [*keys.unknown(), *keys.faults, *(one.fault for one in keys.questions)]
    if found:
        raise InputError(found)
    test = circular_test(runs, (args.plane[0], args.plane[1]), args.radius, args.feed, source)
    figures, parts = circular_figures(test), contributions(test)
    contents: dict[Path, bytes | str] = {}
    if args.out is not None:
        contents[args.out] = circular_report.report_json(test, figures, parts)
    if args.picture is not None:
        from trueaxis.reporting.pictures.polar import Trace, polar_plot  # noqa: PLC0415

        traces = [Trace(one.id, one.angle, radial) for one, radial in zip(test.arcs, about_centre(test), strict=True)]
        contents[args.picture] = polar_plot([(f"plane {args.plane}", traces)], source)
    return _Evaluated(circular_report.report_text(source, test, figures, parts), contents)
