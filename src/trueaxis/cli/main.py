"""The command line: one parser, one module per command, one place where wrong input becomes exit code 2.

Options of every command: how much is said on standard error (-v, -q); of none: completion in a shell.
"""

import argparse
import difflib
import importlib
import keyword
import logging
import os
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NoReturn

from trueaxis import __version__
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.safe_text import shown
from trueaxis.io.told import NOT_DELIVERED, StandardStreams
from trueaxis.stopping import Stopped

COMMANDS = (
    "init",
    "derive",
    "predict",
    "simulate",
    "plan",
    "identify",
    "fit",
    "compensate",
    "diagnose",
    "evaluate",
    "import",
    "export",
    "report",
    "fleet",
    "demo",
)
WRONG_INPUT = 2
INTERRUPTED = 130  # as shells have it
# threads of linear algebra, unless the user says otherwise: more of them cost more than they gain on matrices of our
# size, and the last digits of a result would depend on the number of processors
ONE_THREAD = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
SHELLS = ("bash", "zsh", "tcsh")
FOLDER_OPTIONAL = "--via-linuxcnc"  # an option whose folder may be left out
VERBOSITY = {"-v": logging.INFO, "--verbose": logging.INFO, "-q": logging.ERROR, "--quiet": logging.ERROR}


def build_parser(commands: Sequence[str] = COMMANDS) -> argparse.ArgumentParser:
    """The parser of these commands; each command's module is imported for it."""
    parser = _Parser(
        prog="trueaxis",
        description="Geometric errors of machine tools: derive the model of a machine from a short spec, identify its "
        "errors from laser, ball-bar and probe data, compensate its NC programs, name what the model lacks.",
        epilog="trueaxis COMMAND --help describes each. Exit codes: 0 done; 1 done, and the answer is no, or standard "
        "output was closed or full; 2 the input is wrong, every fault is listed, no output file was touched.",
    )
    parser.add_argument("--version", action="version", version=f"trueaxis {__version__}")
    subparsers = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    parser.add_argument(
        "--print-completion", action=Completion, metavar="SHELL",
        help="print the completion script for bash, zsh or tcsh, and end; needs the package shtab",
    )  # fmt: skip
    for name in commands:
        importlib.import_module(module_of(name)).add_parser(subparsers)
    for one in (parser, *subparsers.choices.values()):
        _add_verbosity(one)
    return parser


def module_of(command: str) -> str:
    """The module of a command: `import` is a word of Python."""
    return f"trueaxis.cli.{command}_" if keyword.iskeyword(command) else f"trueaxis.cli.{command}"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command. Returns the exit code."""
    for name in ONE_THREAD:
        os.environ.setdefault(name, "1")
    with StandardStreams() as streams:
        try:
            code = _run(sys.argv[1:] if arguments is None else arguments)
        except SystemExit as stop:  # help and wrong usage
            code = _delivered(streams, int(stop.code or 0))
            raise SystemExit(code) from None
        return _delivered(streams, code)


def _run(arguments: Sequence[str]) -> int:
    try:
        words = _joined(arguments)
        # A command needs no other command's libraries; help and mistakes are told of all.
        first = next((word for word in words if word not in VERBOSITY), "")
        args = build_parser((first,) if first in COMMANDS else COMMANDS).parse_args(words)
        logging.basicConfig(handlers=[_Messages()], level=logging.WARNING)
        logging.getLogger("trueaxis").setLevel(_level_of(args))
        return int(args.run(args))
    except InputError as error:
        faults = error.faults
    except OSError as error:
        faults = (Fault(str(error.filename or "system"), "", error.strerror or str(error)),)
    except KeyboardInterrupt:
        print("trueaxis: stopped", file=sys.stderr)
        return INTERRUPTED
    except Stopped as stopped:
        print("trueaxis: stopped", file=sys.stderr)
        return stopped.code
    for fault in faults:
        print(f"trueaxis: {fault}", file=sys.stderr)
    return WRONG_INPUT


def _delivered(streams: StandardStreams, code: int) -> int:
    """The exit code, another one where standard output could not take the text of a command that was done.

    A reader that has stopped (`| head`) has what it wanted.
    """
    streams.out.flush()
    failure = streams.out.failure
    if failure is None or isinstance(failure, BrokenPipeError) or code >= WRONG_INPUT:
        return code
    print(f"trueaxis: standard output: {failure.strerror}; files were written, the text was not", file=sys.stderr)
    return NOT_DELIVERED


class _Messages(logging.Handler):
    """Shows messages on what is standard error at the time, each as one line."""

    def emit(self, record: logging.LogRecord) -> None:
        """Show one message."""
        print(f"trueaxis: {shown(record.getMessage())}", file=sys.stderr)


class _Parser(argparse.ArgumentParser):
    """A parser whose errors are one line that is safe to show, whatever was typed; options are typed in full."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **{**kwargs, "allow_abbrev": False})

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """As argparse does, after a look at every option of a command: what is not one is named with the nearest."""
        if self._subparsers is None and args is not None:
            known = [name for name in self._option_string_actions if name.startswith("--")]
            typed = [word.partition("=")[0] for word in args[: args.index("--") if "--" in args else None]]
            unknown = [word for word in typed if word.startswith("--") and word not in known]
            if unknown:
                self.error("; ".join(f"there is no option {word}{_nearest(word, known)}" for word in unknown))
        return super().parse_known_args(args, namespace)

    def error(self, message: str) -> NoReturn:
        """Say what is wrong, and where the options are listed: they would push it off the screen; exit code 2."""
        self.exit(2, f"{self.prog}: {shown(message)}\n{self.prog} --help lists what can be given\n")


def _nearest(word: str, known: Sequence[str]) -> str:
    """`, did you mean --out?`; empty where none is near."""
    near = [name for name in known if name.startswith(word)]
    if not near:  # without the dashes, which make all options alike
        near = [
            f"--{name}"
            for name in difflib.get_close_matches(word.removeprefix("--"), [one.removeprefix("--") for one in known])
        ]
    return f", did you mean {' or '.join(near)}?" if near else ""


def _joined(words: Sequence[str]) -> list[str]:
    """The words with values such as -10,0,5 joined to their option: argparse takes them for options of their own. A
    file behind an option whose folder may be left out is no folder: it is the program.
    """
    joined: list[str] = []
    for word in words:
        if joined and joined[-1] == FOLDER_OPTIONAL and Path(word).is_file():
            joined[-1:] = [f"{FOLDER_OPTIONAL}=/", word]
        elif joined and joined[-1].startswith("--") and "=" not in joined[-1] and re.match(r"-[\d.]", word):
            joined[-1] += f"={word}"
        else:
            joined.append(word)
    return joined


class Completion(argparse.Action):
    """Prints the script that a shell reads, and ends."""

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: str | Sequence[Any] | None,
        option_string: str | None = None,
    ) -> None:
        """Ends with exit code 2 for another shell, or where shtab is not installed."""
        del namespace
        if values not in SHELLS:
            parser.error(f"{option_string}: {values} is no shell that is known; one of {', '.join(SHELLS)}")
        try:
            import shtab  # noqa: PLC0415  only who asks for it needs it
        except ModuleNotFoundError:
            parser.error(f"{option_string} needs the package shtab: pip install 'trueaxis[completion]'")
        print(shtab.complete(parser, shell=values))
        parser.exit()


def _add_verbosity(parser: argparse.ArgumentParser) -> None:
    """Add both options. Neither has a default: that of a command would undo what stands before it."""
    for short, long, what in (
        ("-v", "--verbose", "list what is read, done and written, on standard error"),
        ("-q", "--quiet",
         "no warnings and no progress on standard error; faults stay, and the report with its WARNING lines and notes"),
    ):  # fmt: skip
        parser.add_argument(
            short, long, dest="verbosity", action="store_const", const=VERBOSITY[short], default=argparse.SUPPRESS,
            help=what,
        )  # fmt: skip


def _level_of(args: argparse.Namespace) -> int:
    """The level from which messages are shown."""
    return int(getattr(args, "verbosity", logging.WARNING))
