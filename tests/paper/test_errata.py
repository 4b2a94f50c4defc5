"""Every printed part against what follows: it agrees, or its errata and nothing less make it agree."""

from __future__ import annotations

from itertools import pairwise

import pytest

from . import reference
from .entries import follows
from .errata import ERRATA
from .mending import Erratum, Kind
from .notation import Entry, Formula
from .numeric import mended
from .printed import EQUATIONS, PRINTED

FORMULAS = [(n, part) for n, item in PRINTED.items() for part in item.parts if isinstance(part, Formula)]
ENTRIES = [(n, part) for n, item in PRINTED.items() for part in item.parts if isinstance(part, Entry)]


def named(value: object) -> str:
    return f"({value})" if isinstance(value, int) else getattr(value, "label", str(value))


def concerning(source: int | str, label: str) -> list[Erratum]:
    return [e for e in ERRATA for mend in e.mends if (mend.source, mend.label) == (source, label)]


def test_every_equation_occurs_once() -> None:
    """Eqs. (49)-(52) are a polynomial with its figures: tests/identification/polynomial/test_printed_statistics.py."""
    assert sorted(int(item.number) for item in EQUATIONS) == [*range(1, 49), *range(53, 57)]
    assert {f"Table {n}" for n in range(1, 8)} | {"Sect. 2.1", "Sect. 5.1"} == {
        n for n in PRINTED if isinstance(n, str)
    }


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


def test_numbers_run_from_one() -> None:
    assert [e.number for e in ERRATA] == list(range(1, len(ERRATA) + 1))


def test_kinds_are_those_asked_for() -> None:
    assert {e.kind for e in ERRATA} == set(Kind)
