"""Completion of commands and options in a shell."""

import argparse
from collections.abc import Sequence
from typing import Any

SHELLS = ("bash", "zsh", "tcsh")


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
