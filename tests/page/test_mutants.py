"""Slips put into every formula, into the text of the page and into what emits it: the comparison catches all.

Nothing here looks at the checked-in page: what is caught is caught by what the formula says.
"""

import re
from collections import Counter
from collections.abc import Callable, Iterator
from typing import Any

import pytest
import sympy as sp

from tests.page.chain_names import AXES
from tests.page.checking import problem
from tests.page.mutants import mutants
from tests.page.pages import derived, names, page, rows
from tests.page.rows import cells_of, rows_of
from trueaxis.codegen import chain_section, equations, latex, paper_section
from trueaxis.codegen.chain_section import DroppedTerms
from trueaxis.derivation import first_order

KINDS = {
    "sign",
    "omission of a term",
    "omission of a factor",
    "letter",
    "index",
    "function",
    "order",
    "transposition",
    "order of rows",
    "inversion",
}
Survivor = tuple[str, str, str]


def survivors(formulas: list[tuple[str, dict[str, Any]]]) -> tuple[list[Survivor], Counter[str]]:
    """Slips that no comparison catches, and how many there were of each kind."""
    alive: list[Survivor] = []
    counts: Counter[str] = Counter()
    for text, known in formulas:
        for kind, slip in mutants(text):
            counts[kind] += 1
            if not problem(slip, known):
                alive.append((kind, text, slip))
    return alive, counts


def test_no_slip_in_the_text_of_the_paper_s_machine_survives() -> None:
    alive, counts = survivors([(row.text, names("dmu60p").of(row)) for row in rows("dmu60p")])
    assert alive == []
    assert set(counts) == KINDS
    assert counts.total() > 3000


THREE_AXES = ("bridge_cmm", "cframe_mill", "gantry_mill")
FIVE_AXES = ("dmu60p_5axis", "headhead_mill", "trunnion_mill")


def _check_page(name: str, step: int, least: int) -> None:
    own = names(name)
    alive, counts = survivors([(row.text, own.of(row)) for row in rows(name)[::step]])
    still = not any("moves" in own.chain.bodies[body] for body in own.chain.branch(own.chain.ends["workpiece"]))
    # Where the workpiece stands on the bed [SBW] is the unit matrix, Theta and D of it are 0: these slips are no slips.
    harmless = {text.split("=")[0].strip() for _, text, _ in alive}
    assert harmless <= ({"[SB2]_0", "P_T^W", "M", r"\Theta", "D"} if still else set()), alive
    assert counts.total() > least


@pytest.mark.parametrize("name", THREE_AXES)
def test_no_slip_in_a_page_of_three_axes_survives(name: str) -> None:
    _check_page(name, 1, 1800)


@pytest.mark.parametrize("name", FIVE_AXES)
def test_no_slip_in_a_sample_of_a_page_of_five_axes_survives(name: str) -> None:
    """Every eighth formula, for the time: cosines and sines, products too wide for a matrix."""
    _check_page(name, 8, 400)


@pytest.mark.slow
@pytest.mark.parametrize("name", FIVE_AXES)
def test_no_slip_in_a_page_of_five_axes_survives(name: str) -> None:
    _check_page(name, 1, 4500)


def test_no_slip_in_the_sensitivities_survives() -> None:
    own = names("dmu60p")
    formulas = []
    for link, _, *entries in cells_of(page("dmu60p"), "The sensitivity of the tool point")[1:]:
        error = link.split("`")[1]
        only = {**own.values, **dict.fromkeys(own.chain.components + own.chain.located, 0.0), error: 1.0}
        slope = own.chain.seen(only, own.point)[1]
        for k, entry in enumerate(entries):
            formulas.append((f"s_{AXES[k]} = {entry.strip('$')}", own.base | {f"s_{AXES[k]}": float(slope[k, 0])}))
    assert survivors(formulas)[0] == []


def _drop_last(function: Callable[..., list[str]]) -> Callable[..., list[str]]:
    def short(*args: Any) -> list[str]:
        terms = function(*args)
        return terms[:-1] if len(terms) > 2 else terms

    return short


def _transpose(function: Callable[..., sp.Matrix]) -> Callable[..., sp.Matrix]:
    return lambda *args: function(*args).T


def _negated(function: Callable[..., sp.Expr]) -> Callable[..., sp.Expr]:
    return lambda *args: tuple(-part for part in function(*args))


def _swapped(function: Callable[..., Any]) -> Callable[..., Any]:
    return lambda first, second, *rest: function(second, first, *rest)


def _sign_lost(text: str) -> str:
    return text.replace("- ", "+ ", 1)


def _negative(row: str) -> str:
    return row.replace("&= ", "&= -")


def _points_exchanged(row: str) -> str:
    """Coordinates of the points 1 and 2 exchanged, readings left."""
    return re.sub(r"(_\{[kl])([12])", lambda found: found[1] + {"1": "2", "2": "1"}[found[2]], row)


EMITTER_SLIPS: dict[str, tuple[Any, str, Callable[[Any], Any]]] = {
    "sign of a coefficient": (latex, "is_negative", lambda f: lambda value: not f(value)),
    "last error of a linear form left out": (latex.Latex, "linear", _drop_last),
    "last term of a sum left out": (latex.Latex, "terms", _drop_last),
    "first sign of a row": (latex, "joined", lambda f: lambda terms: _sign_lost(f(terms))),
    "factors transposed": (chain_section, "matrix", _transpose),
    "factors in the opposite order": (chain_section, "_PARTS", lambda parts: parts[::-1]),
    "place of the point negated": (chain_section, "_pose", lambda f: lambda ideal: f(tuple(-part for part in ideal))),
    "inverse not turned": (chain_section, "_turned", lambda f: lambda back, *rest: f(back.T + sp.eye(3), *rest)),
    "lever of a rotation negated": (first_order, "cross", _negated),
    "lever of a rotation exchanged": (first_order, "cross", _swapped),
    "generators transposed": (first_order, "_generators", lambda f: lambda at: f(tuple(-part for part in at))),
    "coordinates of readings negated": (
        paper_section,
        "monomial_terms",
        lambda f: lambda columns, own: f({name: -value for name, value in columns.items()}, own),
    ),
    "difference of points turned": (paper_section, "_difference", lambda f: lambda *a, **k: _sign_lost(f(*a, **k))),
    "reading less its ideal part": (paper_section, "reduced", lambda f: lambda *a: f(*a).replace("-", "+")),
    "closed form with points exchanged": (
        paper_section,
        "_rotation_row",
        lambda f: lambda *a: _points_exchanged(f(*a)),
    ),
    "moves of the compensation": (equations, "_correction", lambda f: lambda *a: [_negative(row) for row in f(*a)]),
}


@pytest.fixture
def walked_anew() -> Iterator[None]:
    """What was walked through before knows nothing of a slip, and what is walked through with one goes afterwards."""
    first_order.first_order.cache_clear()
    yield
    first_order.first_order.cache_clear()


@pytest.mark.usefixtures("walked_anew")
@pytest.mark.parametrize("slip", EMITTER_SLIPS)
def test_a_slip_of_the_emitter_is_caught(slip: str, monkeypatch: pytest.MonkeyPatch) -> None:
    where, name, change = EMITTER_SLIPS[slip]
    monkeypatch.setattr(equations, "dropped_terms", lambda *_: DroppedTerms(1.0, 1.0, 1.0))
    monkeypatch.setattr(where, name, change(getattr(where, name)))
    slipped = rows_of(equations.equations_page(derived("dmu60p")))
    changed = [row for row, before in zip(slipped, rows("dmu60p"), strict=False) if row != before]
    assert changed, "the slip changes nothing on the page"
    assert any(problem(row.text, names("dmu60p").of(row)) for row in changed)
