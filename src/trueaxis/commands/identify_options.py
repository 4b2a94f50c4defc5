"""Options of `identify` whose values are more than one word or number."""

import argparse
from typing import Literal

from trueaxis.commands.arguments import noise, whole
from trueaxis.identify.global_fit.instruments import KINDS, Kind
from trueaxis.identify.global_fit.result import AUTO_DEGREE
from trueaxis.identify.weighting import NoiseModel, Repeats

HIGHEST_DEGREE = 30
STEPWISE = "stepwise"
FROM_ANGLES: Literal["from-angles"] = "from-angles"
_REPEATS: dict[str, Repeats] = {"repeats": "instrument", "repeats-by-run": "run"}


def method_option(text: str) -> str:
    """A method; `paper` is another name of `stepwise`."""
    if text in (STEPWISE, "paper"):
        return STEPWISE
    if text == "global":
        return text
    raise argparse.ArgumentTypeError(f"{text!r} is not stepwise (or paper) or global")


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


def squareness_option(text: str) -> str:
    """A rule for the squareness; `sect36` is the old name of `from-angles`."""
    if text in (FROM_ANGLES, "sect36"):
        return FROM_ANGLES
    if text in ("convention", "known"):
        return text
    raise argparse.ArgumentTypeError(f"{text!r} is not convention, known or {FROM_ANGLES}")


def degree_option(text: str) -> int | Literal["auto"]:
    """A power, or `auto`."""
    if text == AUTO_DEGREE:
        return AUTO_DEGREE
    return whole(1, HIGHEST_DEGREE)(text)


def instruments_option(text: str) -> tuple[Kind, ...]:
    """`real`, `ideal`, or kinds of unknowns."""
    if text == "real":
        return KINDS
    if text == "ideal":
        return ()
    asked = [part.strip() for part in text.split(",")]
    for part in asked:
        if part not in KINDS:
            raise argparse.ArgumentTypeError(
                f"{part!r} is not unknown of an instrument: real, ideal or {', '.join(KINDS)}"
            )
    return tuple(kind for kind in KINDS if kind in asked)
