"""What options of programs may say: points, codes, work offsets, where axes stand.

Each raises argparse.ArgumentTypeError where the text is something else.
"""

import argparse
import re

from trueaxis.compensation.offsets import Range, offset_of_option
from trueaxis.compensation.touched_off import TouchedOff, touched_off_of_option


def point(text: str) -> tuple[float, float, float]:
    """`10,0,-5` as three lengths, mm."""
    parts = text.split(",")
    if len(parts) != 3:
        raise argparse.ArgumentTypeError(f"{text!r} is not x,y,z")
    try:
        x, y, z = map(float, parts)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not x,y,z") from None
    return x, y, z


def codes(text: str) -> tuple[int, ...]:
    """`70,110` as M codes."""
    if not re.fullmatch(r"[Mm]?\d{1,6}(,[Mm]?\d{1,6})*", text, re.ASCII):
        raise argparse.ArgumentTypeError(f"{text!r} is not a list of M codes like 70,110")
    return tuple(sorted({int(code.lstrip("Mm")) for code in text.split(",")}))


def g_codes(text: str) -> tuple[float, ...]:
    """`187,5.1` as G codes."""
    if not re.fullmatch(r"G?\d{1,3}(\.\d)?(,G?\d{1,3}(\.\d)?)*", text, re.ASCII | re.IGNORECASE):
        raise argparse.ArgumentTypeError(f"{text!r} is not a list of G codes like 187,103")
    return tuple(sorted({float(code.lstrip("Gg")) for code in text.split(",")}))


def start(text: str) -> dict[str, float]:
    """`X0Y0Z100` as positions by axis, mm and deg."""
    compact = re.sub(r"[\s,]", "", text.upper())
    if not re.fullmatch(r"([XYZABC][-+]?(\d+\.?\d*|\.\d+))+", compact):
        raise argparse.ArgumentTypeError(f"{text!r} is not like X0Y0Z100")
    found = re.findall(r"([XYZABC])([-+.\d]+)", compact)
    if len(dict(found)) != len(found):
        raise argparse.ArgumentTypeError(f"{text!r} names an axis twice")
    return {axis: float(value) for axis, value in found}


def offset(text: str) -> tuple[str, dict[str, Range]]:
    """See offset_of_option."""
    try:
        return offset_of_option(text)
    except ValueError as problem:
        raise argparse.ArgumentTypeError(str(problem)) from None


def touched_off(text: str) -> TouchedOff:
    """See touched_off_of_option."""
    try:
        return touched_off_of_option(text)
    except ValueError as problem:
        raise argparse.ArgumentTypeError(str(problem)) from None
