"""trueaxis evaluate: a positioning test by ISO 230-2, a circular test by ISO 230-4 or a diagonal test."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.cli.arguments import file_to_write, key_value, option, positive
from trueaxis.evaluation.diagonal_test import DIAGONALS
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.jobs.evaluate import PLANES, EvaluateOptions, evaluated
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.machine.machine import LINEAR

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Evaluate a standard test; the file decides which. A positioning test of a linear axis or, with --rotary, of a rotary one
by ISO 230-2:2014 (k = 2): for each target mean deviations, reversal value, standard uncertainty and repeatability; for
the axis B, R, E, M and A, by direction and for both, and the figures of VDI/DGQ 3441. Beyond 2000 mm or 360 deg one
approach of each target may do, which gives no R and A. DATA is a table (.csv, .parquet) with columns target, cycle,
direction (of the approach: +1 or forward, -1 or backward) and measured, in mm; a .rtl file; or a .dat file with
TGT_DATA[i], REF_DATA_FWD[i,j], REF_DATA_BWD[i,j]. A circular test by ISO 230-4: G, G(b), F, and the errors that cause
the deviations, by size: squareness, scale mismatch, reversal error, lateral play, reversal spikes, servo mismatch,
straightness, cyclic error. DATA are tables of a ball bar (columns angle, and deviation or radius), a file or a column
run for each sense of rotation. A diagonal test (ISO 230-6), with --diagonals: figures of ISO 230-2 along each diagonal,
the largest, scales and squareness. DATA are files of positioning tests, targets along the diagonal, whose names end in
ppp, npp, pnp or ppn (of a face pp or np): p where an axis goes in its positive direction; or have a column run."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser(
        "evaluate", help="positioning, circular and diagonal tests by ISO 230-2, -4 and -6", description=DESCRIPTION
    )
    parser.add_argument("data", type=Path, nargs="+", metavar="DATA", help="the readings: .rtl, .dat, .csv or .parquet")
    parser.add_argument("--out", type=file_to_write, metavar="REPORT.json", help="write the values as JSON")
    parser.add_argument(
        "--picture",
        type=file_to_write,
        metavar="FILE.png",
        help="draw the mean deviations, of a positioning test with bands of 2 s, or the circle",
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
        help="readings that DATA labels forward were approached in the negative direction",
    )
    parser.add_argument(
        "--rotary",
        action="store_true",
        help="DATA is of a rotary axis, targets and readings in deg; figures are in arc seconds and microradians",
    )
    parser.add_argument(
        "--plane", choices=PLANES,
        help="plane of a circular test; angles count from the first axis to the second (XY)",
    )  # fmt: skip
    parser.add_argument("--radius", type=positive, metavar="MM", help="of a circular test: nominal length of the bar")
    parser.add_argument("--feed", type=positive, metavar="MM_MIN", help="of a circular test, if DATA does not give it")
    parser.add_argument(
        "--map", type=key_value, action="extend", nargs="+", default=[], metavar="KEY=VALUE",
        help="columns and units that the headers of a table do not say, as import takes them: column.target=Soll",
    )  # fmt: skip
    parser.add_argument(
        "--diagonals", type=_length, nargs="+", default=[], metavar="AXIS=MM",
        help="DATA are diagonals; how far each axis goes along one of them: X=500 Y=400 Z=300, of a face two axes",
    )  # fmt: skip
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Evaluate, write and print; raises InputError with every fault."""
    named_files = {f"DATA {k}" if len(args.data) > 1 else "DATA": path for k, path in enumerate(args.data, 1)}
    found = overwritten(named_files, {"--out": args.out, "--picture": args.picture})
    options = EvaluateOptions(
        repeatability=args.repeatability, swap_directions=args.swap_directions, plane=args.plane, radius=args.radius,
        feed=args.feed, keys=dict(args.map), rotary=args.rotary, diagonals=dict(args.diagonals) or None,
    )  # fmt: skip
    if args.diagonals and (len(args.diagonals) not in DIAGONALS or len(dict(args.diagonals)) < len(args.diagonals)):
        problem = f"{' '.join(axis for axis, _ in args.diagonals)} are no axes of a face or volume"
        found.append(Fault("--diagonals", "", problem, "two axes or three, each once, such as X=500 Y=400 Z=300"))
        raise InputError(found)
    done = evaluated(args.data, options, option, found)
    if args.picture is not None and not done.has_picture:
        problem = f"{done.source} has one cycle, which gives no bands"
        raise InputError([Fault("--picture", "", problem, "leave it out: a picture needs two cycles or more")])
    contents: dict[Path, bytes | str] = {}
    if args.out is not None:
        contents[args.out] = done.to_json()
    if args.picture is not None:
        contents[args.picture] = done.picture()
    write_files(contents)
    print(done, end="")
    if contents:
        print(f"written: {', '.join(map(named, contents))}")
    return 0


def _length(text: str) -> tuple[str, float]:
    axis, _, length = text.partition("=")
    if axis not in LINEAR:
        raise argparse.ArgumentTypeError(f"{text!r} is not AXIS=MM, such as X=500")
    return axis, positive(length)
