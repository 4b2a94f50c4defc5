"""Counterexamples in exact rational arithmetic: a machine with errors of some micrometres and microradians,
its readings by the untruncated chain at the published points, and how far a printed formula misses them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

import sympy as sp

from . import chain, reference
from .claims_systems import POSE, points_of
from .mending import Erratum, Mend
from .notation import DIRECTIONS, MOTION_ERRORS, POSITION, SQUARENESS, Formula, place, r, reading
from .printed import PRINTED
from .printed.compensation import ball, ideal_ball
from .printed.linkage_xz import THETA, component, ideal_length, straightness
from .printed.squareness import COUNT, P, V, angles, positions
from .printed.tables import SQUARENESS_VALUES

Values = dict[sp.Expr, sp.Expr]
_MICRO = sp.Rational(1, 1_000_000)
_SIZES = (4, -6, 3, 5, -4, 7, -3, 5, 6, -5, 3, -7, 6, 4, -5, 7, -6, 3)
"""Translational errors in micrometres and rotational ones in microradians, in the order of MOTION_ERRORS."""
MOVED_X = 50
"""mm by which r_k2x of the XZ points is moved: Table 5 has r_k1x = r_k2x, which hides Eq. (26)'s wrong sign."""
PITCH_52 = {1: 8.22104e-2, 2: -6.40509e-4, 3: 1.87087e-6, 5: -7.44546e-12, 6: 7.93764e-15}
"""Eq. (52): epsilon_y(x) in microradians, by power of x in mm."""


SYMBOLIC = "samples of Eq. (44)"
"""A setting of coefficients alone: swapped indices have no size."""


def published_pitch(x: float) -> float:
    """Eq. (52) in radians."""
    return 1e-6 * sum(c * x**power for power, c in PITCH_52.items())


@cache
def machine() -> Values:
    """Errors (mm, rad), Table 6's squareness, positions at mid-travel."""
    sizes = {
        error: size * _MICRO * (1000 if str(error).startswith("delta") else 1)
        for error, size in zip(MOTION_ERRORS, _SIZES, strict=True)
    }
    square = {e: sp.Rational(str(SQUARENESS_VALUES[str(e)])) for e in SQUARENESS}
    return sizes | square | {symbol: sp.Rational(value) for symbol, value in POSE.items()}


@cache
def coordinates(run: str) -> Values:
    """Points of a run; those without number (r_k, r_ki ...) are the first of their branch."""
    table = {str(symbol): sp.Rational(str(value)) for symbol, value in points_of(run).items()}
    if run == "XZ":
        table["r_k2x"] += MOVED_X
    result: Values = {sp.Symbol(name, real=True): value for name, value in table.items()}
    for end in "kl":
        first = next((name[2:-1] for name in sorted(table) if name[2] == end), None)
        if first is not None:
            for alias in (end, f"{end}i"):
                result |= {r(alias, d): table[f"r_{first}{d}"] for d in DIRECTIONS}
    return result


@cache
def exact_values(run: str) -> Values:
    """Everything a formula of a run may name, readings and positions by the untruncated chain."""
    base = machine() | coordinates(run) | {chain.SCALE: sp.Integer(1)}
    result = dict(base)
    for label in reference.RUN_LABELS[run]:
        moved = chain.displacement(run.lower(), *reference.point_names(run, label))
        result |= {reading(label, d): moved[n].xreplace(base) for n, d in enumerate(DIRECTIONS)}
    ends = {"k": chain.tool_branch} if "Y" not in run else {"l": chain.workpiece_branch}
    if len(run) == 2 and "Y" in run:
        ends = {"l": chain.workpiece_branch, "k": chain.tool_branch}
    for point, branch in ends.items():
        for pose, moving in (("h", run.lower()), ("0", "")):
            at = chain.carried(branch(moving), chain.at_point(point))
            result |= {place(d, point, pose): at[n].xreplace(base) for n, d in enumerate(DIRECTIONS)}
    return result


def line_values(run: str) -> Values:
    """Projections, actual and ideal length, straightness and angle of a linkage line."""
    values = exact_values(run)
    first, second = reference.PLANES[run]
    # In XY and YZ the displacement is worktable minus tool: what the tool's axis adds is negative.
    ideal = [POSITION[a].xreplace(values) * (-1 if run != "XZ" and a != "y" else 1) for a in (first, second)]
    length = sp.sqrt(ideal[0] ** 2 + ideal[1] ** 2)
    sine, cosine = ideal[0] / length, ideal[1] / length
    result: Values = {THETA: sp.atan2(ideal[0], ideal[1]), component(first): sine, component(second): cosine}
    for label in reference.RUN_LABELS[run]:
        a, b = values[reading(label, first)], values[reading(label, second)]
        result |= {reading(label, first): a, reading(label, second): b, ideal_length(label): length}
        result |= {sp.Symbol(f"L_{label}h", real=True): a * sine + b * cosine}
        result |= {straightness(label): a * cosine - b * sine}
    return result


def _samples() -> Values:
    """The published pitch for every angle, at quarters of the X travel, and its offset for the fit."""
    at = [sp.Integer(540 * i // reference.SAMPLES) for i in range(reference.SAMPLES + 1)]
    result: Values = {COUNT: sp.Integer(reference.SAMPLES)}
    for i, x in enumerate(at):
        value = sp.Float(published_pitch(float(x)))
        result |= {positions(a)[i]: x for a in DIRECTIONS}
        result |= {angles(d, a)[i]: value for a in DIRECTIONS for d in DIRECTIONS}
        result |= {V[i]: x, P[i]: value * x}
    return result


def bar_values() -> Values:
    """A ball bar of 300 mm in the XY plane, 300 = |(180, 240)|, from a workpiece ball at the frame's origin."""
    ends = (*(ideal_ball(d) for d in DIRECTIONS), *(ball(d) for d in DIRECTIONS))
    return dict(zip(ends, map(sp.Integer, (180, 240, 0, 0, 0, 0)), strict=True))


def miss(formula: Formula) -> float | None:
    """|lhs - rhs| in numbers; None if a printed symbol stands for nothing."""
    run = formula.run
    if run in reference.RUN_LABELS:
        difference = (formula.lhs - formula.rhs).xreplace(exact_values(run))
    elif run.startswith("line "):
        difference = (formula.lhs - formula.rhs).xreplace(line_values(run.removeprefix("line ")))
    elif run == "directions":
        difference = formula.residual(reference.known(run)).xreplace(machine())
    elif run == "compensated":
        difference = reference.residual(formula).xreplace(machine() | bar_values())
    elif run == "chain":
        difference = reference.residual(formula).xreplace(machine() | coordinates("XY"))
    else:
        difference = reference.residual(formula).xreplace(_samples())
    if difference.free_symbols:
        return None
    size = abs(float(difference.evalf(30)))
    return size if size > 1e-20 else 0.0  # what 30 digits leave of an exact zero


def mended(source: int | str, part: Formula, errata: tuple[Erratum, ...], without: Erratum | None = None) -> Formula:
    """A part with the mends of all errata in their order, or of all but one."""
    result = part
    for erratum in errata:
        for mend in erratum.mends:
            if (mend.source, mend.label) == (source, part.label) and erratum is not without:
                assert mend.change is not None
                result = mend.change(result)
    return result


def formula(mend: Mend) -> Formula | None:
    """The printed formula that a mend changes; None if it is an entry."""
    part = next(part for part in PRINTED[mend.source].parts if part.label == mend.label)
    return part if isinstance(part, Formula) else None


@dataclass(frozen=True, slots=True)
class Counterexample:
    """The worst part of an erratum: what is missed with all other errata mended, and with all."""

    erratum: int
    place: str
    unit: str
    printed: float | None
    mended: float


@cache
def counterexample(erratum: Erratum, errata: tuple[Erratum, ...]) -> Counterexample | None:
    """The formula that this erratum spoils most; None if it concerns no formula."""
    worst: Counterexample | None = None
    for mend, part in _with_numbers(erratum):
        printed = miss(mended(mend.source, part, errata, without=erratum))
        right = miss(mended(mend.source, part, errata))
        assert right is not None, f"({mend.source}) {part.label} names something undefined after mending"
        found = Counterexample(
            erratum.number, f"({mend.source}) {part.label}", _unit(mend.source, part), printed, right
        )
        if worst is None or (worst.printed or 0.0) < (printed or 0.0):
            worst = found
    return worst


def has_counterexample(erratum: Erratum) -> bool:
    """Whether it concerns a formula, without a value of it."""
    return any(True for _ in _with_numbers(erratum))


def _with_numbers(erratum: Erratum) -> Iterator[tuple[Mend, Formula]]:
    """The mends of formulas that take numbers, and these formulas as printed."""
    for mend in erratum.mends:
        part = formula(mend)
        if part is not None and part.run != SYMBOLIC:
            yield mend, part


def _unit(source: int | str, part: Formula) -> str:
    if source == 6 or part.label in ("c_uv1", "cosine of theta"):
        return "1"
    return "rad" if str(part.lhs).startswith("epsilon") and part.lhs.is_Symbol else "mm"
