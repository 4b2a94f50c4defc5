"""What docs/errata.md states in formulas and numbers, read from its text and worked out."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
import sympy as sp

from tests.page.latex_value import value_of
from tests.page.pages import names
from tests.page.rows import rows_of
from trueaxis.identification.paper.squareness import accumulated_slope

from . import claims_systems as systems
from . import reference
from .claims_squareness import TRAVEL, cases
from .entries import largest_radius
from .errata import ERRATA
from .mending import Erratum, Kind
from .notation import EPS_XY, X_H, Formula
from .numeric import MOVED_X, machine, mended, published_pitch
from .printed import PRINTED
from .printed.compensation import LARGEST_ERROR_MEASURED, LARGEST_ERROR_SIMULATED, STROKES
from .printed.tables import POINTS_LINKAGE, POINTS_SINGLE, SQUARENESS_VALUES

RESIDUALS: dict[int, tuple[int, tuple[str, ...]]] = {
    11: (18, ("row 1", "row 3")),
    13: (21, ("x", "z")),
    14: (22, ("L_izh",)),
    15: (28, ("L_ixh", "L_iyh")),
    16: (23, ("L_izh",)),
    17: (25, ("row 1",)),
    18: (25, ("row 3",)),
    19: (26, ("delta_x(z)",)),
    20: (26, ("epsilon_x(x)",)),
    21: (27, ("x",)),
    24: (33, ("L_1yh",)),
    25: (35, ("y",)),
}
"""Entries that give left minus right side: the equation, and the parts in the order of the formulas."""
_FORMULA = re.compile(r"```math\n(.*?)\n```|\$`?(.+?)`?\$", re.DOTALL)


def sections(page: str) -> dict[int, str]:
    """Text of each entry."""
    return {int(n): text for n, text in re.findall(r"^### E(\d+)\n(.*?)(?=^##)", page, re.MULTILINE | re.DOTALL)}


def formulas_behind(text: str, words: str) -> list[str]:
    """The formulas behind these words."""
    found = re.search(words, text)
    if found is None:
        return []
    matches = (a or b for a, b in _FORMULA.findall(text[found.end() :]))
    return [part.strip(" .\n") for formula in matches for part in formula.split(r", \qquad")]


def residual_slips(page: str) -> Iterator[str]:
    """Entries whose stated left minus right side is not that of the printed formula."""
    rng = np.random.default_rng(31)
    for number, (equation, labels) in RESIDUALS.items():
        stated = formulas_behind(sections(page)[number], r"[Ll]eft minus\s+right\s+side")
        if len(stated) < len(labels):
            yield f"E{number}: no left minus right side"
            continue
        for label, text in zip(labels, stated, strict=False):
            expected = _residual(number, equation, label)
            values = {symbol: float(rng.uniform(0.3, 1.7)) for symbol in sorted(expected.free_symbols, key=str)}
            known = {_latex(str(symbol)): value for symbol, value in values.items()}
            if not np.isclose(_value(text, known), float(expected.xreplace(values))):
                yield f"E{number}: {text}"


@cache
def _residual(number: int, equation: int, label: str) -> sp.Expr:
    """Left minus right side as printed, letters and projections (E9, E10, E15) mended."""
    slips = tuple(e for e in ERRATA if e.number in {9, 10, 15} - {number})
    part = next(p for p in PRINTED[equation].parts if p.label == label)
    assert isinstance(part, Formula)
    return reference.residual(mended(equation, part, slips))


def _value(text: str, known: dict[str, Any]) -> float:
    try:
        return float(value_of(text.replace(r"\bigl", "").replace(r"\bigr", ""), lambda name, _: known.get(name)))
    except ValueError:
        return float("nan")


def _latex(symbol: str) -> str:
    """`epsilon_y(x)` as the page's reader names it."""
    name = re.sub(r"\((\w)\)", r"(\1_h)", symbol)
    name = re.sub("^(delta|epsilon|theta)", lambda m: {"epsilon": r"\varepsilon"}.get(m[0], "\\" + m[0]), name)
    return re.sub(r"L\^l_(\w+)", r"L_\1^l", name)


def other_slips(page: str) -> Iterator[str]:
    """Proofs that are no residual of one part: E8, E23, E39."""
    of = sections(page)
    known = {str(X_H): 1.3, r"\varepsilon_xy": 0.7}
    part = next(p for p in PRINTED[11].parts if p.label == "y")
    assert isinstance(part, Formula)
    others = tuple(e for e in ERRATA if e.number != 8)
    missed = _missed(part, others)
    if not np.isclose(_value(formulas_behind(of[8], "misses, in y")[0], known), abs(float(missed)) * 1.3 * 0.7):
        yield "E8"
    (row,) = (row.text for row in rows_of(of[23]) if row.text.startswith(r"\varepsilon_y(y_h) ="))
    own = {re.sub(r"\^XY", "", name): v for name, v in names("dmu60p")._run("XY", 32).items()}  # type: ignore[attr-defined]
    left, right = (_value(side.strip(" ."), own) for side in row.split("="))
    if not np.isclose(left, right):
        yield "E23"
    yield from _turned_bar(of[39])


@cache
def _missed(part: Formula, others: tuple[Erratum, ...]) -> sp.Expr:
    return sp.expand(reference.residual(mended(11, part, others))).coeff(X_H * EPS_XY)


def _turned_bar(text: str) -> Iterator[str]:
    """E39: the vector that Eq. (54) misses, left minus right, at drawn values."""
    rng = np.random.default_rng(32)
    stated = formulas_behind(text, r"[Ll]eft minus\s+right\s+side")
    about, ideal, ball = rng.uniform(0.3, 1.7, (3, 3))
    known = {"e": about, "a": ideal, "b": ball}
    read = (
        stated[0].replace(r"\varepsilon(y)", "e").replace(r"P^W_{Ti\,ideal}", "a").replace("P_W", "b") if stated else ""
    )
    try:
        found = value_of(read, lambda name, _: known.get(name))
    except ValueError:
        found = np.full(3, np.nan)
    values = {f"epsilon_{d}(y)": about[n] for n, d in enumerate("xyz")}
    values |= {f"{d}_ideal^W": ideal[n] for n, d in enumerate("xyz")} | {f"{d}_w": ball[n] for n, d in enumerate("xyz")}
    for n, d in enumerate("xyz"):
        part = next(p for p in PRINTED[54].parts if p.label == d)
        assert isinstance(part, Formula)
        residual = reference.residual(part)
        expected = float(residual.xreplace({s: values[str(s)] for s in residual.free_symbols}))
        if not np.isclose(found[n], expected):
            yield f"E39 {d}"


def numbers() -> Iterator[tuple[int | None, str]]:
    """Statements with numbers, their numbers computed: the entry (None: anywhere) and the words."""
    micro, at = 1e6, machine()
    xy, way = float(SQUARENESS_VALUES["epsilon_xy"]), float(at[X_H])
    yield 8, rf"{abs(xy * way) * 1e3:.2f} µm in y, just ${way:g} \cdot {abs(xy) * micro:g} \cdot 10^{{-6}}$ mm"
    yield 20, f"(with $r_{{k2x}}$ moved by {MOVED_X} mm)"
    yield 30, f"square machines give up to {max(abs(c.found) for c in cases() if c.truth == 0):.0f} µrad"
    yield 32, f"{2 * SQUARENESS_VALUES['epsilon_xz'] * micro:.0f} µrad, twice Table 6's value"
    x, y, _ = POINTS_SINGLE["k8"]
    yield 33, rf"$\delta_z + {-x:g} \varepsilon_y - {-y:g} \varepsilon_x$"
    step = np.subtract(POINTS_SINGLE["k8"], POINTS_SINGLE["k7"])
    yield 33, rf"${step[0]:g} \varepsilon_y - {step[1]:g} \varepsilon_x$"
    free = systems.null_space(systems.single_axis_matrices()["Z"])[:, 0]
    free *= step[1] / free[1]
    yield 33, rf"\bigl({free[0]:.0f}\ \mathrm{{mm}},\ {free[1]:.0f},\ {free[2]:.0f}\bigr)"
    table = POINTS_LINKAGE
    pairs = {run: np.subtract(table[run]["l1"], table[run]["k1"]) for run in ("XY", "YZ")}
    xy_pair, yz_pair = (f"({', '.join(f'{c:g}' for c in np.round(pair, 3))})" for pair in pairs.values())
    yield 35, f"= {xy_pair}$"
    yield None, f"is ${xy_pair}$ for both XY pairs and ${yz_pair}$ for YZ"
    yield 42, f"at most {largest_radius():.0f} mm, or an arc"
    strokes = f"{STROKES['X']:g} and {STROKES['Y']:g} mm"
    yield 42, f"a whole circle of 300 mm radius takes {2 * 300} mm in X and in Y; the strokes are {strokes}"
    yield 43, f"it is {LARGEST_ERROR_MEASURED / LARGEST_ERROR_SIMULATED:.0f} times as large"
    points = [point for group in (POINTS_SINGLE, *table.values()) for point in group.values()]
    yield None, f"lie up to {max(float(np.linalg.norm(p)) for p in points):.0f} mm away from the measuring points"
    spread = np.ptp([POINTS_SINGLE[k][1] for k in ("k1", "k2", "k3")])
    noise = {a.name: a.standard for a in systems.amplification(systems.with_mended_z_point())}
    yield (
        None,
        f"span {spread:g} mm in y, and 1 µm of noise in a reading becomes {noise['epsilon_z(x)']:.0f} µrad of yaw",
    )
    yield None, f"(0.01 mm across 300 mm: {0.01**2 / 600 * 1e3:.2g} µm)"
    kinds = [e.kind for e in ERRATA if e.number <= 35]
    signs, wrong = kinds.count(Kind.SIGN), kinds.count(Kind.FORMULA)
    yield None, f"{signs} are wrong signs and {wrong} are wrong formulas"
    coarse, fine = (from_angles(samples) * micro for samples in (18, 36))
    yield None, f"its $\\varepsilon_{{xz}}$ has the other sign, {coarse:+.1f} and {fine:+.1f} µrad"


@cache
def _numbers() -> tuple[tuple[int | None, str], ...]:
    return tuple(numbers())


def from_angles(samples: int) -> float:
    """eps_xz of `--squareness from-angles` for the pitch of Eq. (52), rad: the slope of X's line in z."""
    at = np.linspace(0.0, TRAVEL["x"], samples + 1)
    return float(np.arcsin(accumulated_slope(at, 0) @ [published_pitch(float(x)) for x in at]))


def number_slips(page: str) -> Iterator[str]:
    """Statements of `numbers` that the page does not make."""
    of = sections(page)
    for entry, words in _numbers():
        text = page if entry is None else of[entry]
        if " ".join(words.split()) not in " ".join(text.split()):
            yield f"{entry}: {words}"
