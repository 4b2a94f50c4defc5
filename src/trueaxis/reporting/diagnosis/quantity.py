"""Numbers as people write them: units of the workshop, uncertainties of two digits."""

import math
import re

from trueaxis.estimation.tails import LEAST_P
from trueaxis.io.safe_text import plain_zero

MICRO = "\N{MICRO SIGN}"
UM = f"{MICRO}m"
URAD = f"{MICRO}rad"
NBSP = "\N{NO-BREAK SPACE}"
NO_EVIDENCE = 0.5  # p values above it differ in nothing that matters: multiplied by the tests made they often come to 1
COVERAGE_FACTOR = 2.0  # of the expanded uncertainty, as ISO 230-2 has it

# unit of the records: below this size, shown so many times larger, in this unit
_SMALL = {
    "mm": (0.1, 1e3, UM),
    "rad": (0.01, 1e6, f"{MICRO}rad"),
    "s": (0.1, 1e3, "ms"),
    "1": (0.01, 1e6, f"{UM}/m"),
    "mm/mm": (0.01, 1e6, f"{UM}/m"),
    "mm/mm/K": (0.01, 1e6, f"{UM}/m/K"),
    "mm/s": (1e-4, 3.6e6, f"{UM}/h"),
    "rad/s": (1e-4, 3.6e9, f"{MICRO}rad/h"),
}
_PREFIXED = {"mm": (1e3, UM), "rad": (1e6, f"{MICRO}rad")}

_ASCII = str.maketrans(
    {
        MICRO: "u",
        NBSP: " ",
        "\N{PLUS-MINUS SIGN}": "+/-",
        "\N{EN DASH}": "-",
        "\N{MINUS SIGN}": "-",
        "\N{SUPERSCRIPT TWO}": "2",
    }
)
_PLAIN_UNIT = re.compile(r"(?<=\d) u(m|rad)\b")
_MINUS = str.maketrans("-", "\N{MINUS SIGN}")
_RAISED = str.maketrans(
    "-0123456789",
    "\N{SUPERSCRIPT MINUS}\N{SUPERSCRIPT ZERO}\N{SUPERSCRIPT ONE}\N{SUPERSCRIPT TWO}\N{SUPERSCRIPT THREE}"
    "\N{SUPERSCRIPT FOUR}\N{SUPERSCRIPT FIVE}\N{SUPERSCRIPT SIX}\N{SUPERSCRIPT SEVEN}\N{SUPERSCRIPT EIGHT}"
    "\N{SUPERSCRIPT NINE}",
)
_LOWERED = {raised: chr(plain) for plain, raised in _RAISED.items()}
_TIMES_TEN = f"{NBSP}\N{MULTIPLICATION SIGN}{NBSP}10"


def with_own_sign(text: str) -> str:
    """A text made for a console: `0.3 um` and `2 urad` with the units' own sign."""
    return _PLAIN_UNIT.sub(rf"{NBSP}{MICRO}\1", text)


def shown_in(size: float, unit: str) -> tuple[float, str]:
    """Factor and unit in which a quantity of this size (in `unit`) is shown: 0.006 mm as 6 um."""
    if not math.isfinite(size):
        return 1.0, "" if unit == "1" else unit
    if unit in _SMALL:
        below, factor, small = _SMALL[unit]
        return (factor, small) if abs(size) < below else (1.0, "" if unit == "1" else unit)
    first, slash, rest = unit.partition("/")
    if first in _PREFIXED and slash and abs(size) < 0.01:
        factor, small = _PREFIXED[first]
        return factor, f"{small}/{rest}"
    return 1.0, unit


def quantity(value: float, unit: str, digits: int = 3) -> str:
    """`6.1 um`; `unknown` where there is no number."""
    if not math.isfinite(value):
        return "unknown"
    factor, small = shown_in(value, unit)
    length_or_angle = unit in ("mm", "rad")  # others may be small without being zero
    return _plain(plain_zero(value * factor) if length_or_angle else value * factor, digits) + (
        f"{NBSP}{small}" if small else ""
    )


def with_expanded(value: float, u: float, unit: str) -> str:
    """`6.10 um +/- 0.40 um (k = 2)`: the expanded uncertainty has two digits, the value as many decimals."""
    if not (math.isfinite(u) and u > 0.0):
        return quantity(value, unit)
    factor, small = shown_in(max(abs(value), COVERAGE_FACTOR * u), unit)
    expanded = COVERAGE_FACTOR * u * factor
    place = 1 - math.floor(math.log10(expanded))  # of the last digit; below zero left of the point: 60000 s
    rounded = (round(one, place) for one in (value * factor, expanded))
    shown = [written(one, f".{max(0, place)}f") + (f"{NBSP}{small}" if small else "") for one in rounded]
    return f"{shown[0]} \N{PLUS-MINUS SIGN}{NBSP}{shown[1]} (k{NBSP}={NBSP}{COVERAGE_FACTOR:g})"


def micrometres(value: float) -> str:
    """A length in mm as `3.21` (um); a dash where there is none."""
    return _plain(1e3 * value, 3) if math.isfinite(value) else "\N{EN DASH}"


def probability(p: float) -> str:
    """`0.03`; `2 x 10^-9` with signs of its own; `below` the least that is a figure, `above` a half: no evidence."""
    if p > NO_EVIDENCE:
        return f"above{NBSP}{written(NO_EVIDENCE, 'g')}"
    return f"below{NBSP}{written(LEAST_P, 'g')}" if p < LEAST_P else written(p, ".2g")


def equals_p(p: float) -> str:
    """`p = 0.03`, `p below ...`, `p above ...`."""
    told = probability(p)
    return f"p {told}" if told.startswith(("below", "above")) else f"p{NBSP}={NBSP}{told}"


def percent(share: float) -> str:
    """`84 %`."""
    return f"{written(100.0 * share, '.0f')}{NBSP}%" if math.isfinite(share) else "\N{EN DASH}"


def written(value: float, form: str) -> str:
    """A number as people write it: a minus sign instead of a hyphen, powers of ten raised, no negative zero; a dash
    where there is none.
    """
    if math.isnan(value):
        return "\N{EN DASH}"
    text = format(value, form)
    digits, exponential, power = text.partition("e")
    if exponential:
        return f"{digits.translate(_MINUS)}{_TIMES_TEN}{str(int(power)).translate(_RAISED)}"
    return (text.removeprefix("-") if not text.strip("-0.") else text).translate(_MINUS)


def ascii_only(text: str) -> str:
    """For a console of any encoding: um, +/-, 2e-12."""
    raised = f"{_TIMES_TEN}([{''.join(map(chr, _LOWERED))}]+)"
    text = re.sub(raised, lambda power: f"e{power.group(1).translate(_LOWERED)}", text)
    return text.translate(_ASCII).encode("ascii", "replace").decode()


def _plain(value: float, digits: int) -> str:
    """So many digits, and no exponent where a plain number does."""
    if value == 0.0 or not 1e-4 <= abs(value) < 1e7:
        return written(value, f".{digits}g")
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    return written(value, f".{decimals}f")
