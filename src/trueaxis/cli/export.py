"""trueaxis export: error values as compensation tables of a control."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from trueaxis.cli.arguments import positive, size, tool_point
from trueaxis.cli.misfit import check_fit, misfit_option, uncertain_option
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.compensation.reliance import PRIOR_SIZES
from trueaxis.controllers.formats import FORMATS, Export, export_tables, problem_of
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering
from trueaxis.machine import read_machine
from trueaxis.model.curves import FloatArray
from trueaxis.model.extent import UncertaintyExtent, travel_positions, uncertainty_extent
from trueaxis.model.measured_range import beyond_measured
from trueaxis.model.model import MachineModel, load_model
from trueaxis.model.uncertainty import covariance_file, load_uncertainty, prior_size
from trueaxis.reporting.control_tables import export_sentences, head_lines
from trueaxis.reporting.reliance import (
    error_free_sentences,
    extent_sentences,
    prior_sentences,
    travel_sentences,
    uncertain_sentence,
)

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Write error values as compensation tables that a control reads. Every table says what of the model it holds; the command
says how large the deviations of the tool point are over the travel, and what is left of them with the tables, as the
control would interpolate them. docs/controllers has a page for each format: its source, the sign with a number, limits,
how to load it, how to verify it by measuring again, how to take it off."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser(
        "export", help="error values as compensation tables of a control", description=DESCRIPTION,
        epilog="exit code: 0 done; 1 refused for its uncertainty or by --max-correction, nothing is written; "
        "2 the input is wrong",
    )  # fmt: skip
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument("--errors", type=Path, required=True, metavar="E.json", help="its error values")
    parser.add_argument("--format", choices=FORMATS, required=True, help="of the control")
    parser.add_argument(
        "--out", type=Path, required=True, metavar="PATH",
        help="file to write; a folder for heidenhain-com and linuxcnc-comp",
    )  # fmt: skip
    parser.add_argument(
        "--step", type=positive, metavar="MM",
        help="largest distance of the positions of a table, mm or deg (default: the finest round one with up to 200)",
    )  # fmt: skip
    parser.add_argument(
        "--tool-point", type=tool_point, default=(0.0, 0.0, 0.0), metavar="X,Y,Z",
        help="the point in the tool frame that tables of single axes are made for, mm (0,0,0)",
    )  # fmt: skip
    misfit_option(parser)
    uncertain_option(parser, "the tables")
    parser.add_argument(
        "--max-u", type=size, metavar="MM",
        help="write nothing, exit code 1, where a standard uncertainty of the tool point within the travel, relative "
        "to home, is larger; what is not known or not determined counts as infinite",
    )  # fmt: skip
    parser.add_argument(
        "--max-correction", type=positive, metavar="MM",
        help="write nothing, exit code 1, where the tool point is off by more than this from home (default: three "
        "times what [prior] of the spec lets expect there)",
    )  # fmt: skip
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR", help="folder of derived kernels (%(default)s)"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Judge, write, say what remains; raises InputError with the faults of every file."""
    found: list[Fault] = []
    machine = read_machine(args.machine)
    with gathering(found):
        model = load_model(args.machine, args.errors, args.kernels)
        check_fit(model.errors, args.errors, args.accept_misfit)
        covariance = load_uncertainty(args.errors, model.errors, machine)
    if found:
        raise InputError(found)
    if problem := problem_of(args.format, model, args.step):
        raise InputError([Fault(str(args.machine), f"--format {args.format}", problem)])
    tool = np.array(args.tool_point)[:, np.newaxis]
    positions = travel_positions(model, covariance)
    comments = head_lines(args.format, model)
    export = export_tables(args.format, model, tool, args.step, positions, comments)
    contents = _contents(args.out, export)
    inputs = {"MACHINE.toml": args.machine, "--errors": args.errors}
    inputs["the covariance of --errors"] = covariance_file(args.errors, model.errors)
    outputs: dict[str, Path | None] = {f"{path.name} of --out": path for path in contents}
    if found := overwritten(inputs, outputs, args.kernels):
        raise InputError(found)
    extent = uncertainty_extent(model, covariance, positions, tool)
    beyond = travel_sentences(beyond_measured(model.errors, model.axes, positions))
    refusals = _refusals(args, model, tool, positions, extent)
    if not refusals:
        write_files(contents)
    notes = export_sentences(args.format, model, export)
    for sentence in (
        *error_free_sentences(model.error_free),
        *notes,
        *extent_sentences(extent, "over the travel"),
        *prior_sentences(model.errors, extent.components),
        *beyond,
    ):
        print(f"note: {sentence}")
    for sentence in refusals:
        print(f"{named(args.out)}: not written: {sentence}")
    if refusals:
        return 1
    left = export.remaining
    print(
        f"RMS of the tool point over the travel, from home: {left.before * 1e3:.3g} um, {left.after * 1e3:.3g} um left"
    )
    print(f"written: {', '.join(map(named, contents))}")
    return 0


def _contents(out: Path, export: Export) -> dict[Path, bytes | str]:
    return {out / name if name else out: text for name, text in export.files.items()}


def _refusals(
    args: argparse.Namespace, model: MachineModel, tool: FloatArray, positions: FloatArray, extent: UncertaintyExtent
) -> list[str]:
    """Why nothing may be written."""
    sentences = []
    if extent.refused(args.max_u, args.accept_u):
        sentences.append(uncertain_sentence(extent, args.max_u))
    off = np.linalg.norm(model.deviation(positions, tool), axis=0)
    allowed = PRIOR_SIZES * prior_size(model, positions, tool)
    if args.max_correction is not None:
        allowed = np.full(off.size, args.max_correction)
    worst = int(np.argmax(off - allowed))
    if off[worst] > allowed[worst]:
        at = " ".join(f"{axis}{value:g}" for axis, value in zip(model.axes, positions[:, worst], strict=True))
        sentences.append(
            f"the tool point is off by {off[worst]:.4g} mm at {at}, more than {allowed[worst]:.4g} mm; "
            "--max-correction allows more, or larger sizes in [prior] of the spec, if the machine is that far off"
        )
    return sentences
