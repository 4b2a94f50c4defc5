"""How much is said on standard error: -v and -q, before or behind the command."""

import argparse
import logging

VERBOSITY = {"-v": logging.INFO, "--verbose": logging.INFO, "-q": logging.ERROR, "--quiet": logging.ERROR}


def add_verbosity(parser: argparse.ArgumentParser) -> None:
    """Add both options. Neither has a default: that of a command would undo what stands before it."""
    for short, long, what in (
        ("-v", "--verbose", "say what is read, done and written, on standard error"),
        ("-q", "--quiet", "no warnings and no progress on standard error; faults stay, and the report with its notes"),
    ):
        parser.add_argument(
            short, long, dest="verbosity", action="store_const", const=VERBOSITY[short], default=argparse.SUPPRESS,
            help=what,
        )  # fmt: skip


def level_of(args: argparse.Namespace) -> int:
    """The level from which messages are shown."""
    return int(getattr(args, "verbosity", logging.WARNING))
