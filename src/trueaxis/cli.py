"""The command line: one parser, one module per command, one place where wrong input becomes exit code 2."""

import argparse
import importlib
import logging
import os
import re
import sys
from collections.abc import Sequence

from trueaxis import __version__
from trueaxis.faults import InputError

COMMANDS = ("derive", "predict", "simulate", "plan", "identify", "fit", "compensate", "diagnose", "evaluate", "demo")
INTERRUPTED = 130  # as shells have it
# threads of linear algebra, unless the user says otherwise: more of them cost more than they gain on matrices of our
# size, and the last digits of a result would depend on the number of processors
ONE_THREAD = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")


def build_parser(commands: Sequence[str] = COMMANDS) -> argparse.ArgumentParser:
    """The parser of these commands; each command's module is imported for it."""
    parser = argparse.ArgumentParser(
        prog="trueaxis",
        description="Geometric errors of machine tools: derive the model of a machine from a short spec, identify its "
        "errors from laser, ball-bar and probe data, compensate its NC programs, name what the model lacks.",
        epilog="trueaxis COMMAND --help tells more of each. Exit codes: 0 done; 1 done, and the answer is no; "
        "2 the input is wrong, every fault is listed and no output file was touched.",
    )
    parser.add_argument("--version", action="version", version=f"trueaxis {__version__}")
    subparsers = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    for name in commands:
        importlib.import_module(f"trueaxis.commands.{name}").add_parser(subparsers)
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command. Returns the exit code."""
    for name in ONE_THREAD:
        os.environ.setdefault(name, "1")
    try:
        words = _joined(sys.argv[1:] if arguments is None else arguments)
        # A command needs no other command's libraries; help and mistakes are told of all.
        args = build_parser(words[:1] if words and words[0] in COMMANDS else COMMANDS).parse_args(words)
        logging.basicConfig(format="trueaxis: %(message)s", level=logging.WARNING)
        return int(args.run(args))
    except InputError as error:
        for fault in error.faults:
            print(f"trueaxis: {fault}", file=sys.stderr)
    except BrokenPipeError:
        # Whoever read our output has stopped; what was to be written to files has been.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except OSError as error:
        print(f"trueaxis: {error.filename or ''}: {error.strerror or error}", file=sys.stderr)
    except KeyboardInterrupt:
        print("trueaxis: stopped", file=sys.stderr)
        return INTERRUPTED
    return 2


def _joined(words: Sequence[str]) -> list[str]:
    """The words with values such as -10,0,5 joined to their option: argparse takes them for options of their own."""
    joined: list[str] = []
    for word in words:
        if joined and joined[-1].startswith("--") and "=" not in joined[-1] and re.match(r"-[\d.]", word):
            joined[-1] += f"={word}"
        else:
            joined.append(word)
    return joined
