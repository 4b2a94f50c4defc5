"""Error values that do not fit the readings they come from, or say nothing, are taken on request alone."""

import argparse

OPTION = "--accept-misfit"
ACCEPT_U = "--accept-u"


def misfit_option(parser: argparse.ArgumentParser) -> None:
    """Add the option to a command."""
    parser.add_argument(
        OPTION, action="store_true", help="take error values that do not fit the readings they come from"
    )


def uncertain_option(parser: argparse.ArgumentParser, what: str) -> None:
    """Add the option to a command. what: is written."""
    parser.add_argument(
        ACCEPT_U,
        action="store_true",
        help=f"write {what} also where the noise of the readings is larger than the correction (root mean squares); so "
        "does --max-u, which then decides alone",
    )
