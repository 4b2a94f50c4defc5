"""`trueaxis compensate`: an NC program in, the same with compensated positions out."""

import argparse
from dataclasses import fields
from pathlib import Path
from typing import get_args

from trueaxis.cli.arguments import file_to_write, misfit_option, option, positive, size, uncertain_option
from trueaxis.cli.draws import add_draws, draws_of
from trueaxis.cli.program_values import codes, g_codes, offset, point, start, touched_off
from trueaxis.cli.progress import progress
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.offsets import Offsets, read_offsets, with_options
from trueaxis.compensation.reliance import Limits, judge_of
from trueaxis.compensation.settings import Arcs, Dialect, Integers, Settings
from trueaxis.compensation.tools import read_tools
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering
from trueaxis.jobs.compensate import as_faults, notes_of, notes_of_draws, of_machine
from trueaxis.jobs.drawn_program import Remembering, drawn_program
from trueaxis.jobs.draws import faults_of_draws
from trueaxis.jobs.given import check_fit
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.measurement.table import table_bytes
from trueaxis.model.model import load_model
from trueaxis.model.uncertainty import covariance_file, load_uncertainty
from trueaxis.reporting.compensation import compensation_text, failure_text
from trueaxis.reporting.reliance import refusal_sentences

_DESCRIPTION = """\
Rewrite an NC program (ISO 6983 / RS-274) or an APT cutter location file so that the machine's geometric errors no
longer move the tool: the commands are iterated until the actual tool point is where that of an error-free machine
would be (Eqs. 55, 56). With --orientation correct rotary axes turn too, until the tool axis points where it would.
Positions in the program are axis positions (machine coordinates), or those of work offsets that --offset, --offsets
or the program give; --tools gives tool lengths.

Blocks that move nothing stay as they are, byte for byte. Arcs stay arcs where possible (--arcs); lines are cut where
the errors along them bend; canned cycles are written out. Codes that move or shift axes in a way that is not followed
(macros, cutter radius compensation, mirror, scaling, rotated frames ...) are faults with their lines, and nothing is
written. So are M codes that do not mean the same on every control, unless --pass-m names them, G codes that are
not known, unless --pass-g does, and numbers without a decimal point, unless --integers gives their unit.

An axis has no known position until the program gives it one. Rapids before that are compensated as if the other axes
stood at [start] of the spec, else at home; --start states where they stand. An axis that the program has not commanded
in this frame gets no word: feed motions before that are right in the axes that are commanded, and --start must state
the position of the others if it matters. The output has a mark in a comment, and a program with the mark is refused:
compensated twice, every correction would double."""

_EPILOG = """\
Write negative coordinates with an equals sign: --ball=-10,0,5.

words: `nearest` rounds. With --ball, `ends` chooses among the words within one step of the wanted position those whose
error is perpendicular to the ball bar, and `middles` passes points in the middle of short blocks (0.04 mm), where half
steps can be reached: the smallest error, at the price of up to twice the blocks.

effects of the spec ([[effect]]) are compensated where they depend on positions, directions of approach, distances
since a reversal and velocity (F); the report names each. At a reversal a short block takes up the lost motion. Effects
of time and temperature need --time and --temperature, the same for the whole program.

orientation: words of 0.0001 deg leave up to 1.3 urad where two rotary axes turn the tool axis; --rotary-resolution
sets their step. Where the tool axis is within 0.57 deg of parallel to a rotary axis (a singular pose), it cannot be
corrected in one direction without a large turn: the rotary axis then keeps its programmed position, and the report
names the lines.

exit status: 0 done, the last line is `written: PROGRAM`; 1 done, but points did not converge, stay above a tolerance
or would leave the travel, at whose end their words stop, or the program moves nothing: the last line is
`PROGRAM: written, but not good:` and why; or nothing was written: refused for its uncertainty or by --max-u or
--max-correction: the last line begins with `PROGRAM: not written:`, and --report writes nothing; 2 the input is wrong
and nothing was written. A rapid in machine coordinates (G53 G0 Z0.) that stops at the end of travel is a note."""


def add_parser(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command's options."""
    parser = subparsers.add_parser(
        "compensate",
        help="rewrite an NC program so that geometric errors are compensated",
        description=_DESCRIPTION,
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    _add_files(parser)
    _add_accuracy(parser, Settings())
    _add_reading(parser, Settings())
    _add_frames(parser)
    _add_limits(parser)
    parser.set_defaults(run=run)


def _add_files(parser: argparse.ArgumentParser) -> None:
    """What is read and written."""
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine")
    parser.add_argument("--errors", type=Path, required=True, metavar="E.json", help="its error values")
    parser.add_argument("program", type=Path, metavar="PROGRAM", help="NC program or APT CL file")
    parser.add_argument("--out", type=file_to_write, required=True, metavar="PROGRAM", help="NC program to write")
    parser.add_argument(
        "--format", choices=("nc", "apt"), help="format of the program (default: by extension and content)"
    )
    parser.add_argument("--kernels", type=Path, default=Path("generated"), metavar="DIR",
                        help="folder of derived kernels (default %(default)s)")  # fmt: skip
    parser.add_argument("--report", type=file_to_write, metavar="FILE", help="write the report as JSON too")


def _add_accuracy(parser: argparse.ArgumentParser, default: Settings) -> None:
    """How well the tool is to follow, and in which words."""
    parser.add_argument("--tolerance", type=float, default=default.tolerance, metavar="MM",
                        help="largest tool point error allowed (default 0.001; 0.00254 for words of 0.0001 "
                        "inch, which are one step)")  # fmt: skip
    parser.add_argument("--resolution", type=float, default=default.resolution, metavar="MM",
                        help="step of words written in mm (default %(default)s)")  # fmt: skip
    parser.add_argument("--inch-resolution", type=float, default=default.inch_resolution, metavar="INCH",
                        help="step of words written under G20 (default 0.00001; 0.0001 with "
                        "--dialect fanuc)")  # fmt: skip
    parser.add_argument("--rotary-resolution", type=float, default=default.rotary_resolution, metavar="DEG",
                        help="step of words of rotary axes (default %(default)s)")  # fmt: skip
    parser.add_argument("--chord-tolerance", type=float, default=default.chord_tolerance, metavar="MM",
                        help="largest distance of an arc from lines that it becomes (default %(default)s)")  # fmt: skip
    parser.add_argument("--method", choices=("iterative", "ordinary"), default=default.method,
                        help="iterate, or correct once (default %(default)s)")  # fmt: skip
    parser.add_argument("--arcs", choices=get_args(Arcs), default=default.arcs,
                        help="arcs stay arcs, cut where the shifted points lie on none, or all become chords "
                        "(default %(default)s)")  # fmt: skip
    parser.add_argument("--words", choices=("nearest", "ends", "middles"), default=default.words,
                        help="choice of words, see below (default %(default)s)")  # fmt: skip
    parser.add_argument("--ball", type=point, metavar="X,Y,Z",
                        help="centre of the workpiece ball, workpiece frame, for E of Eq. (6)")  # fmt: skip
    parser.add_argument("--tool-point", type=point, default=default.tool_point, metavar="X,Y,Z",
                        help="point to be compensated, tool frame (default 0,0,0)")  # fmt: skip
    parser.add_argument("--orientation", choices=("keep", "correct"), default=default.orientation,
                        help="correct with the linear axes alone, or turn rotary axes too so that the tool axis points "
                        "as on the error-free machine (default %(default)s)")  # fmt: skip
    parser.add_argument("--orientation-tolerance-urad", type=float, default=default.orientation_tolerance_urad,
                        metavar="URAD", help="largest error of the tool axis allowed with --orientation correct "
                        "(default %(default)g)")  # fmt: skip
    parser.add_argument("--tool-axis", type=point, default=default.tool_axis, metavar="X,Y,Z",
                        help="direction of the tool axis, tool frame (default 0,0,1)")  # fmt: skip


def _add_reading(parser: argparse.ArgumentParser, default: Settings) -> None:
    """What the program does not say of itself: where and when it runs, and on which control."""
    parser.add_argument("--start", type=start, default={}, metavar="X0Y0Z0",
                        help="axis positions before the first block, in machine coordinates "
                        "(default: not known)")  # fmt: skip
    parser.add_argument("--temperature", type=float, metavar="C",
                        help="degC at which the program runs, for effects that depend on it (default 20)")  # fmt: skip
    parser.add_argument("--time", type=float, metavar="S",
                        help="time since start, for effects that depend on it (default: not compensated)")  # fmt: skip
    parser.add_argument("--block-delete", choices=("fault", "run", "skip"), default=default.block_delete,
                        help="treatment of motions in / blocks (default %(default)s)")  # fmt: skip
    parser.add_argument("--dialect", choices=get_args(Dialect),
                        help="language of the control, for the meaning of codes, T and X100 (default: siemens or "
                        "heidenhain if the program can be nothing else, otherwise unknown)")  # fmt: skip
    parser.add_argument("--via-linuxcnc", type=Path, nargs="?", const=Path("/"), metavar="DIR",
                        help="expand macros, subprograms and cutter compensation with LinuxCNC's interpreter "
                        "first; DIR: folder of the Debian package linuxcnc-uspace, if not /")  # fmt: skip
    parser.add_argument("--integers", choices=get_args(Integers),
                        help="unit of numbers without a decimal point: mm (inch, deg), or least increments of "
                        "0.001 mm (0.0001 inch, 0.001 deg); default: mm if --dialect is linuxcnc, siemens or "
                        "heidenhain, else such a number is a fault")  # fmt: skip
    parser.add_argument("--peck-return", type=float, default=default.peck_return, metavar="MM",
                        help="how far G73 and G83 go back, and before the cut goes on, where they are written out "
                        "(default %(default)s, as on LinuxCNC)")  # fmt: skip
    parser.add_argument("--pass-g", type=g_codes, default=(), metavar="187,103",
                        help="G codes that trueaxis does not know, and that move no axis and change no mode on this "
                        "control")  # fmt: skip
    parser.add_argument("--pass-m", type=codes, default=(), metavar="70,110",
                        help="M codes that move no axis and change no mode on this control; 0, 1 or 6: where axes stay "
                        "at stops or tool changes, so that they need not be commanded again")  # fmt: skip


def _add_frames(parser: argparse.ArgumentParser) -> None:
    """Work offsets and tools of the control."""
    parser.add_argument("--offset", type=offset, action="append", default=[], metavar="G54=X1.0,Y2.0,Z3.0",
                        help="machine position of the zero of a work offset, mm and deg; once for each. A few mm off "
                        "change little, and the report says how much; --touched-off says how it was set. A range like "
                        "X0:500 asks for the worst case")  # fmt: skip
    parser.add_argument("--offsets", type=Path, metavar="FILE",
                        help="work offsets: LinuxCNC's .var, or TOML with tables [offset.G54]; --via-linuxcnc reads "
                        "all parameters of the .var")  # fmt: skip
    parser.add_argument("--touched-off", type=touched_off, action="append", default=[],
                        metavar="G54[=X..,Y..,Z..,L..]",
                        help="a work offset that was touched off without compensation: the part is then right against "
                        "its datum. X.. Y.. Z..: where the axes stood, if not at its zero; L: length of the probe. "
                        "Once for each; G54:Z=.. for one direction")  # fmt: skip
    parser.add_argument("--keep-g53", action="store_true",
                        help="leave motions in machine coordinates (G53, G153, SUPA, M91) as they are: places that "
                        "were taught without compensation, such as tool racks; G28 and G30 always are")  # fmt: skip
    parser.add_argument("--tools", type=Path, metavar="FILE",
                        help="tools by number: LinuxCNC's tool.tbl, or TOML with tables [tool.1] of length, offset and "
                        "diameter; G43 then adds the length to Z, and the tip of each tool is compensated")  # fmt: skip
    parser.add_argument("--spindle-tool", type=int, metavar="N", help="tool in the spindle before the "
                        "program, one of --tools, 0: none (default: not known)")  # fmt: skip


def _add_limits(parser: argparse.ArgumentParser) -> None:
    """What is refused, and what is accepted nevertheless."""
    parser.add_argument("--max-u", type=size, metavar="MM",
                        help="write nothing, exit code 1, if a standard uncertainty of the tool point, relative to "
                        "home, is larger anywhere in the program; unknown or not determined counts as "
                        "infinite")  # fmt: skip
    parser.add_argument("--max-correction", type=positive, metavar="MM",
                        help="write nothing, exit code 1, if a correction is larger (default: three times the tool "
                        "point error that errors of the sizes in [prior] of the spec cause)")  # fmt: skip
    misfit_option(parser)
    uncertain_option(parser, "the program")
    add_draws(parser, of_program=True)


def _settings(args: argparse.Namespace) -> Settings:
    try:
        return Settings(**{field.name: getattr(args, field.name) for field in fields(Settings) if field.name in args})
    except ValueError as problem:
        raise InputError([Fault("options", "", str(problem))]) from None


def run(args: argparse.Namespace) -> int:
    """Compensate; returns the exit code.

    Raises InputError when the input is wrong.
    """
    inputs = {"MACHINE.toml": args.machine, "--errors": args.errors, "PROGRAM": args.program}
    tables = {"--offsets": args.offsets, "--tools": args.tools}
    inputs |= {option: path for option, path in tables.items() if path is not None}
    outputs = {"--out": args.out, "--report": args.report, "--draws-out": args.draws_out}
    found = overwritten(inputs, outputs, args.kernels)
    draws = draws_of(args, found)
    with gathering(found):
        args.offsets = with_options(Offsets() if args.offsets is None else read_offsets(args.offsets), args.offset)
    tools, args.tools = args.tools, None
    with gathering(found):
        args.tools = None if tools is None else read_tools(tools)
        args.touched_off = tuple(args.touched_off)
        settings = _settings(args)
    model = covariance = None
    with gathering(found):
        model = load_model(args.machine, args.errors, args.kernels)
        check_fit(model.errors, str(args.errors), args.accept_misfit, option)
        covariance = load_uncertainty(args.errors, model.errors, model.machine)
        read = {"the covariance of --errors": covariance_file(args.errors, model.errors)}
        found += overwritten(read, outputs)
        found += [] if draws is None else faults_of_draws(covariance, 1, str(args.errors), option)
    if found or model is None or covariance is None:
        raise InputError(found)
    limits = Limits(max_u=args.max_u, max_correction=args.max_correction, accept_u=args.accept_u)
    judge, chosen, left = Remembering(judge_of(model, covariance, limits)), of_machine(settings, model), None
    with as_faults(args.program), progress() as show:
        report = compensate_file(
            args.program, args.out, model, chosen, language=args.format, report_file=args.report,
            progress=lambda lines: show(f"{lines} blocks read"), judge=judge, via_linuxcnc=args.via_linuxcnc,
        )  # fmt: skip
        if draws is not None and not report.refused:
            left = drawn_program(model, covariance, judge.visited, chosen, draws, show)
            if left is not None:
                write_files({args.draws_out: table_bytes(left.to_polars(), args.draws_out.suffix)})
    print(compensation_text(report))
    for sentence in (*notes_of(report, model), *notes_of_draws(left)):
        print(f"note: {sentence}")
    for sentence in () if report.reliance is None else refusal_sentences(report.reliance, args.max_u):
        print(f"{named(args.out)}: not written: {sentence}")
    if report.failures and not report.refused:
        print(f"{named(args.out)}: written, but not good: {failure_text(report)}")
    if report.good:
        made = (args.out, args.report, None if left is None else args.draws_out)
        print(f"written: {', '.join(named(path) for path in made if path is not None)}")
    return 0 if report.good else 1
