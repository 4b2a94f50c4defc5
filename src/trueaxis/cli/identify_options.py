"""Options of `identify` whose values are more than one word or number."""

import argparse
from typing import Literal

from trueaxis.cli.arguments import noise, noise_urad, whole
from trueaxis.identification.weighting import NoiseModel, Repeats
from trueaxis.jobs.identify import HIGHEST_DEGREE

STEPWISE, GLOBAL = "stepwise", "global"
FROM_ANGLES: Literal["from-angles"] = "from-angles"
_REPEATS: dict[str, Repeats] = {"repeats": "instrument", "repeats-by-run": "run"}


def method_option(text: str) -> str:
    """A method; `paper` is another name of `stepwise`."""
    if text in (STEPWISE, "paper"):
        return STEPWISE
    if text == GLOBAL:
        return text
    raise argparse.ArgumentTypeError(f"{text!r} is not global or stepwise (or paper)")


def noise_option(text: str) -> NoiseModel:
    """`0.3`, `laser=0.3,ballbar=0.5`, `repeats` or `repeats-by-run`."""
    if text in _REPEATS:
        return NoiseModel(repeats=_REPEATS[text])
    if "=" not in text:
        return NoiseModel(um=noise(text))
    found: dict[str, float] = {}
    for part in text.split(","):
        name, equals, value = part.rpartition("=")
        if not (equals and name.strip()):
            raise argparse.ArgumentTypeError(f"{part!r} is not NAME=S")
        if name.strip() in found:
            raise argparse.ArgumentTypeError(f"{name.strip()} is given more than once")
        found[name.strip()] = noise(value)
    return NoiseModel(by_group=found)


def add_noise_urad(parser: argparse.ArgumentParser) -> None:
    """The option --noise-urad."""
    parser.add_argument(
        "--noise-urad",
        type=noise_urad,
        metavar="S",
        help="standard deviation of a reading of angle instruments, urad (default: as that of lengths)",
    )


def squareness_option(text: str) -> str:
    """A rule for the squareness; `sect36` is the old name of `from-angles`."""
    if text in (FROM_ANGLES, "sect36"):
        return FROM_ANGLES
    if text in ("convention", "known"):
        return text
    raise argparse.ArgumentTypeError(f"{text!r} is not convention, known or {FROM_ANGLES}")


def degree_option(text: str) -> int:
    """An order of curves; `auto` has been replaced by what may be expected of curves."""
    if text == "auto":
        raise argparse.ArgumentTypeError("auto is replaced by --prior spec, which expects smooth curves; or a number")
    return whole(1, HIGHEST_DEGREE)(text)
