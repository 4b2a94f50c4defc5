"""Every printed part against what follows: it agrees, or its errata and nothing less make it agree."""

from __future__ import annotations

from itertools import pairwise

import pytest
import sympy as sp

from . import reference
from .entries import follows
from .errata import ERRATA
from .mending import Erratum, Kind
from .notation import EPS_XZ, EPS_YZ, Z_H, Entry, Formula, delta, eps, r
from .numeric import mended
from .printed import EQUATIONS, PRINTED
from .printed.compensation import ball, ideal_ball
from .printed.linkage_xz import THETA, straightness

FORMULAS = [(n, part) for n, item in PRINTED.items() for part in item.parts if isinstance(part, Formula)]
ENTRIES = [(n, part) for n, item in PRINTED.items() for part in item.parts if isinstance(part, Entry)]


def named(value: object) -> str:
    return f"({value})" if isinstance(value, int) else getattr(value, "label", str(value))


def concerning(source: int | str, label: str) -> list[Erratum]:
    return [e for e in ERRATA for mend in e.mends if (mend.source, mend.label) == (source, label)]


def test_every_equation_occurs_once() -> None:
    """Eqs. (49)-(52) are one polynomial with its figures: tests/identify/polynomial/test_printed_statistics.py."""
    assert sorted(int(item.number) for item in EQUATIONS) == [*range(1, 49), *range(53, 57)]
    assert {f"Table {n}" for n in range(1, 8)} | {"Sect. 2.1"} == {n for n in PRINTED if isinstance(n, str)}


def test_every_mend_changes_something_printed() -> None:
    printed = {(n, part.label) for n, item in PRINTED.items() for part in item.parts}
    assert {(mend.source, mend.label) for e in ERRATA for mend in e.mends} <= printed


@pytest.mark.parametrize(("source", "part"), FORMULAS, ids=named)
def test_formula_follows_once_mended(source: int | str, part: Formula) -> None:
    right = mended(source, part, ERRATA)
    assert reference.residual(right) == 0
    errata = concerning(source, part.label)
    assert (reference.residual(part) == 0) == (not errata)
    for erratum in errata:
        assert reference.residual(mended(source, part, ERRATA, without=erratum)) != 0, f"E{erratum.number} is idle"


@pytest.mark.parametrize(("source", "part"), ENTRIES, ids=named)
def test_entry_follows_once_mended(source: int | str, part: Entry) -> None:
    right = follows()[source, part.label]
    errata = concerning(source, part.label)
    if not errata:
        assert part.printed == right
        return
    assert part.printed != right
    # A slip of the recognition comes last to the text and is undone first.
    errata.sort(key=lambda e: e.kind is not Kind.RECOGNITION)
    stated = [mend.instead for e in errata for mend in e.mends if (mend.source, mend.label) == (source, part.label)]
    steps = [part.printed, *stated]
    assert all(before != after for before, after in pairwise(steps))
    assert stated[-1] == right


def test_residuals_stated_on_the_page() -> None:
    """The symbolic proofs that docs/errata.md quotes: left minus right side once the readings are put in."""
    about_x, about_y = (eps(d, "x") + eps(d, "z") for d in "xy")
    base = r("k1", "y") - r("k2", "y")
    stated = {
        (21, "x"): 2 * eps("y", "z") * r("k", "z"),
        (21, "z"): 2 * eps("x", "z") * r("k", "y"),
        (22, "L_izh"): -2 * straightness("i") * sp.sin(THETA),
        (23, "L_izh"): 2 * r("ki", "y") * about_x,
        (25, "row 1"): 2 * (delta("x", "z") - r("k1", "y") * eps("z", "z")),
        (25, "row 3"): delta("z", "x"),
        (26, "delta_x(z)"): delta("x", "z") * (1 - 1 / base),
        (26, "epsilon_x(x)"): 2 * (r("k1", "x") - r("k2", "x")) * about_y / base,
        (27, "x"): delta("x", "y") - delta("x", "x"),
        (33, "L_1yh"): (r("l1", "x") - r("l1", "z")) * eps("z", "y"),
        (35, "y"): 2 * Z_H * EPS_YZ,
        (43, "epsilon_xz"): 2 * EPS_XZ,
        (54, "x"): eps("y", "y") * (ideal_ball("z") - ball("z")) - eps("z", "y") * (ideal_ball("y") - ball("y")),
    }
    slips = tuple(e for e in ERRATA if e.number in (9, 10, 15))
    for (source, label), right in stated.items():
        part = next(p for n, p in FORMULAS if (n, p.label) == (source, label))
        left = reference.residual(mended(source, part, slips))
        assert sp.expand(sp.cancel(left - right)) == 0, (source, label)


def test_numbers_run_from_one() -> None:
    assert [e.number for e in ERRATA] == list(range(1, len(ERRATA) + 1))


def test_kinds_are_those_asked_for() -> None:
    assert {e.kind for e in ERRATA} == set(Kind)
