"""trueaxis evaluate: a positioning test by ISO 230-2."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.commands.arguments import file_to_write
from trueaxis.commands.paths import named, overwritten
from trueaxis.faults import InputError
from trueaxis.files import write_files
from trueaxis.input_files import gathering
from trueaxis.iso230_2.evaluation import evaluate
from trueaxis.iso230_2.read import read_positioning_test
from trueaxis.iso230_2.report import report_json, report_text

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Evaluate a bidirectional positioning test of a linear axis up to 2000 mm by ISO 230-2:2014 (k = 2): at each target mean
deviations, reversal value, standard uncertainty and repeatability; of the axis B, R, E, M and A, by direction and for
both. DATA is a table (.csv, .parquet) with columns target, cycle, direction (+1 or forward, -1 or backward: how the
target was approached) and measured, in mm; or a .dat file with TGT_DATA[i], REF_DATA_FWD[i,j], REF_DATA_BWD[i,j]."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser("evaluate", help="a positioning test by ISO 230-2", description=DESCRIPTION)
    parser.add_argument("data", type=Path, metavar="DATA", help="the readings: .dat, .csv or .parquet")
    parser.add_argument("--out", type=file_to_write, metavar="REPORT.json", help="write the values as JSON")
    parser.add_argument(
        "--picture", type=file_to_write, metavar="FILE.png", help="draw the mean deviations with bands of 2 s"
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
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Evaluate, write and print; raises InputError with every fault."""
    found = overwritten({"DATA": args.data}, {"--out": args.out, "--picture": args.picture})
    with gathering(found):
        test = read_positioning_test(args.data)
    if found:
        raise InputError(found)
    evaluation = evaluate(test.swapped() if args.swap_directions else test, args.repeatability)
    contents: dict[Path, bytes | str] = {}
    if args.out is not None:
        contents[args.out] = report_json(evaluation)
    if args.picture is not None:
        from trueaxis.pictures.positioning import positioning_plot  # noqa: PLC0415  matplotlib takes long to import

        contents[args.picture] = positioning_plot(evaluation, args.data.stem)
    write_files(contents)
    print(report_text(str(args.data), evaluation), end="")
    if contents:
        print(f"written: {', '.join(map(named, contents))}")
    return 0
