"""The options of points: those of a table, or a grid over the volume."""

import argparse
from pathlib import Path

from trueaxis.cli.arguments import file_to_write, option, tool_point
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.input_files import gathering
from trueaxis.jobs.tables import ORIGIN, faults_of_grid, tool_points
from trueaxis.machine.machine import Machine
from trueaxis.measurement.points import Points, points_at, read_points
from trueaxis.model.grid import Grid

OPTION = "--grid"


def add_points(parser: argparse.ArgumentParser) -> None:
    """Declare --at, --grid and what goes with it."""
    where = parser.add_mutually_exclusive_group(required=True)
    where.add_argument("--at", type=Path, metavar="POINTS", help="axis positions, .csv or .parquet")
    where.add_argument(
        OPTION, type=_nodes, action="extend", nargs="+", metavar="AXIS=N",
        help="a map of the volume: so many positions of each axis, evenly spread over its travel; axes that are left "
        "out stand at home: X=11 Y=9 Z=7",
    )  # fmt: skip
    parser.add_argument(
        "--tool-point", type=tool_point, metavar="X,Y,Z", help="with --grid: the point in the tool frame, mm (0,0,0)"
    )
    parser.add_argument(
        "--picture", type=file_to_write, metavar="FILE.png",
        help="with --grid: draw slices through the middle: the error, its uncertainty, where draws and u differ",
    )  # fmt: skip


def points_of(args: argparse.Namespace, machine: Machine) -> tuple[Points, Grid | None]:
    """The points; None: they are those of a table. Raises InputError with every fault of the table or the options."""
    if args.grid is None:
        given = [name for name in ("tool_point", "picture") if getattr(args, name) is not None]
        found = [
            Fault(option(name), "", f"goes with {OPTION}", f"leave it out, or {OPTION} for --at") for name in given
        ]
        with gathering(found):
            points = read_points(args.at, machine)
        if found:
            raise InputError(found)
        return points, None
    axes, grid = [axis for axis, _ in args.grid], Grid(dict(args.grid))
    found = [Fault(OPTION, axis, "is given more than once", "once") for axis in grid.counts if axes.count(axis) > 1]
    found += faults_of_grid(grid, machine, OPTION)
    if args.picture is not None and not grid.has_slices:
        found.append(Fault("--picture", "", "is of a grid of one axis", "a grid of two axes or more"))
    if found:
        raise InputError(found)
    positions = grid.positions(machine)
    return points_at(positions, tool_points(args.tool_point or ORIGIN, positions.shape[1]), machine), grid


def _nodes(text: str) -> tuple[str, int]:
    axis, _, count = text.partition("=")
    if not axis or not count.isdecimal():
        raise argparse.ArgumentTypeError(f"{text!r} is not AXIS=N, such as X=11")
    return axis, int(count)
