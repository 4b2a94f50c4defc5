"""The formulas and the numbers of docs/errata.md are those computed, and slips put into them are caught."""

from __future__ import annotations

from itertools import chain

import pytest
import sympy as sp

from . import reference
from .errata import ERRATA
from .notation import Formula
from .numeric import mended
from .printed import PRINTED
from .reference_compensation import SETTINGS, definitions
from .stated import number_slips, other_slips, residual_slips
from .test_page import PAGE


def slips(page: str) -> list[str]:
    return list(chain(residual_slips(page), other_slips(page), number_slips(page)))


def test_every_stated_formula_and_number_is_computed() -> None:
    assert slips(PAGE) == []


WRONG = {
    "E8": (r"x_h\,\varepsilon_{xy} .", r"2 x_h\,\varepsilon_{xy} ."),
    "E11": (r"(r_{k3y} - r_{k3z})", r"(r_{k3z} - r_{k3y})"),
    "E13": (r"2\,\varepsilon_y(z_h)\,r_{kz}", r"2\,\varepsilon_y(z_h)\,r_{ky}"),
    "E14": (r"$-2 \delta_{ih}\sin\theta$", r"$2 \delta_{ih}\sin\theta$"),
    "E15": (r"$(L_{ih}-L_{ih}^l)\cos\theta$", r"$(L_{ih}^l-L_{ih})\cos\theta$"),
    "E19": (r"\left(1 - 1/(r_{k1y}-r_{k2y})\right)", r"\left(1 + 1/(r_{k1y}-r_{k2y})\right)"),
    "E23": (r"+ (r_{k1z}-r_{k2z})\varepsilon_y(x_h)}{", r"- (r_{k1z}-r_{k2z})\varepsilon_y(x_h)}{"),
    "E24": (r"$(r_{l1x}-r_{l1z}) \varepsilon_z(y_h)$", r"$(r_{l1x}+r_{l1z}) \varepsilon_z(y_h)$"),
    "E25": (r"left minus right side is $2 z_h", r"right minus left side is $2 z_h"),
    "E33": (r"$46 \varepsilon_y - 5 \varepsilon_x$", r"$46 \varepsilon_y + 5 \varepsilon_x$"),
    "E39": ("Left minus right side of the compensated machine", "Right minus left side of the compensated machine"),
    "E42": ("at most 270 mm", "at most 207 mm"),
    "points": ("up to 287 mm away", "up to 920 mm away"),
    "from angles": ("+55.5 and", "-55.5 and"),
}


@pytest.mark.parametrize("slip", WRONG)
def test_a_slip_is_caught(slip: str) -> None:
    right, wrong = WRONG[slip]
    assert right in PAGE
    assert slips(PAGE.replace(right, wrong))


@pytest.mark.parametrize(
    ("number", "used_by", "setting"),
    [
        (40, 42, "fitted lines"),
        (44, 45, "samples of Eq. (44)"),
        (47, 48, "sums of Eq. (48)"),
        (53, 54, "compensated"),
    ],
)
def test_a_definition_with_a_slip_spoils_the_equation_that_rests_on_it(number: int, used_by: int, setting: str) -> None:
    """Each right-hand side negated in turn, and its last symbol doubled."""
    parts = [part for part in PRINTED[used_by].parts if isinstance(part, Formula)]
    right = definitions(number)
    spoil = SETTINGS[setting]
    assert all(reference.residual(mended(used_by, p, ERRATA), spoil(right)) == 0 for p in parts)
    for symbol, value in right.items():
        last = max(value.free_symbols, key=str)
        for wrong in (-value, value.xreplace({last: 2 * last})):
            values = spoil({**right, symbol: sp.expand(wrong)})
            assert any(reference.residual(mended(used_by, p, ERRATA), values) != 0 for p in parts), symbol
