"""Types of command-line arguments, with messages that say what would be right, and options that commands share."""

import argparse
import math
import os
from collections.abc import Callable
from pathlib import Path

from trueaxis.measurement.limits import NOISE_UM

# where the option is a word of Python, or says less
_OPTIONS = {"instruments": "--with", "wanted": "--for", "keys": "--map", "ideal_instruments": "--instruments"}
OPTION = "--accept-misfit"
ACCEPT_U = "--accept-u"


def file_to_write(text: str) -> Path:
    """A path of a file. Raises argparse.ArgumentTypeError where it is written as that of a folder."""
    if text.endswith(("/", os.sep)):
        raise argparse.ArgumentTypeError(f"{text!r} is the name of a folder, not of a file")
    return Path(text)


def option(argument: str) -> str:
    """The option of an argument of the Python interface."""
    return _OPTIONS.get(argument, f"--{argument.replace('_', '-')}")


def size(text: str) -> float:
    """A finite number, at least 0. Raises argparse.ArgumentTypeError otherwise."""
    return _finite(text, "a finite number, at least 0", lambda value: value >= 0.0)


def positive(text: str) -> float:
    """A finite number above 0. Raises argparse.ArgumentTypeError otherwise."""
    return _finite(text, "a finite number above 0", lambda value: value > 0.0)


def noise(text: str) -> float:
    """Standard deviation of a reading, um, of any instrument. Raises argparse.ArgumentTypeError otherwise."""
    low, high = NOISE_UM
    return _finite(text, f"a number of micrometres from {low:g} to {high:g}", lambda value: low <= value <= high)


def noise_urad(text: str) -> float:
    """The same of a reading of an angle, urad. Raises argparse.ArgumentTypeError otherwise."""
    low, high = NOISE_UM
    return _finite(text, f"a number of microradians from {low:g} to {high:g}", lambda value: low <= value <= high)


def noise_or_none(text: str) -> float:
    """Standard deviation of a reading, um or urad, or 0 for none. Raises argparse.ArgumentTypeError otherwise."""
    high = NOISE_UM[1]
    return _finite(text, f"a number from 0 to {high:g}", lambda value: 0.0 <= value <= high)


def tool_point(text: str) -> tuple[float, float, float]:
    """`X,Y,Z`, a point in the tool frame, mm. Raises argparse.ArgumentTypeError otherwise."""
    try:
        x, y, z = (float(part) for part in text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not X,Y,Z: three numbers, mm") from None
    if not all(map(math.isfinite, (x, y, z))):
        raise argparse.ArgumentTypeError(f"{text!r} is not X,Y,Z: three finite numbers, mm")
    return x, y, z


def key_value(text: str) -> tuple[str, str]:
    """`KEY=VALUE`. Raises argparse.ArgumentTypeError otherwise."""
    key, equals, value = text.partition("=")
    if not equals or not key.strip() or not value.strip():
        raise argparse.ArgumentTypeError(f"{text!r} is not KEY=VALUE")
    return key.strip(), value.strip()


def share(text: str) -> float:
    """A number above 0 and below 1. Raises argparse.ArgumentTypeError otherwise."""
    return _finite(text, "a number above 0 and below 1", lambda value: 0.0 < value < 1.0)


def whole(low: int, high: int | None = None) -> Callable[[str], int]:
    """A type: a whole number from `low` to `high` (or without an upper end)."""
    right = f"a whole number from {low} to {high}" if high is not None else f"a whole number, at least {low}"

    def read(text: str) -> int:
        try:
            value = int(text)
        except ValueError:
            raise argparse.ArgumentTypeError(f"{text!r} is not {right}") from None
        if value < low or (high is not None and value > high):
            raise argparse.ArgumentTypeError(f"{text} is not {right}")
        return value

    return read


def _finite(text: str, right: str, good: Callable[[float], bool]) -> float:
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not {right}") from None
    if not (math.isfinite(value) and good(value)):
        raise argparse.ArgumentTypeError(f"{text} is not {right}")
    return value


def misfit_option(parser: argparse.ArgumentParser) -> None:
    """Add the option to a command."""
    parser.add_argument(OPTION, action="store_true", help="accept error values that do not fit their readings")


def uncertain_option(parser: argparse.ArgumentParser, what: str) -> None:
    """Add the option to a command. what: is written."""
    parser.add_argument(
        ACCEPT_U,
        action="store_true",
        help=f"write {what} even if the noise of the readings contributes more than the correction (root mean "
        "squares), or if it rests on errors that neither readings nor a prior determine; --max-u replaces these checks "
        "by its own",
    )
