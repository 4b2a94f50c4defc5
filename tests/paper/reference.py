"""What follows: for every setting that a printed part may stand in, the values its symbols must have.

`known(run)` maps readings, positions and defined quantities to what the exact chain of `chain` gives to first
order, or what elementary geometry and the normal equations give. A printed formula holds if its residual is zero.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache

import sympy as sp

from . import chain, reference_compensation
from .notation import (
    DIRECTIONS,
    EPS_XY,
    EPS_XZ,
    EPS_YZ,
    MOTION_ERRORS,
    POSITION,
    SQUARENESS,
    Formula,
    delta,
    eps,
    place,
    reading,
)
from .printed.linkage_xz import THETA, component, straightness
from .printed.model import ERROR_SIZE, FRAMES, LENGTH, PE, position_symbols, seen
from .printed.squareness import COUNT, OFFSETS, P, V, angles, intercept, offset, positions, slope, total

Known = Mapping[sp.Symbol, sp.Expr]
SAMPLES = 4
"""Number of samples for which sums are written out before they are compared."""

RUN_LABELS: dict[str, tuple[str, ...]] = {
    "X": ("1", "2", "3"),
    "Y": ("4", "5", "6"),
    "Z": ("7", "8", "9"),
    "XZ": ("i", "1", "2"),
    "XY": ("i", "1", "2"),
    "YZ": ("i", "1"),
}
"""Labels of the points measured in each pattern (Sects. 3.2-3.5, Tables 4 and 5); i is any of them."""


PLANES = {"XZ": ("x", "z"), "XY": ("x", "y"), "YZ": ("y", "z")}
"""Plane of a linkage line: the direction of the sine, then that of the cosine."""


def point_names(run: str, label: str) -> tuple[str | None, str | None]:
    """Tool point and worktable point of a label in a run."""
    return (f"k{label}" if run != "Y" else None, f"l{label}" if "Y" in run else None)


@cache
def readings(run: str) -> dict[sp.Symbol, sp.Expr]:
    """The first-order reading L_{label}{direction}h for each label and direction of a run."""
    result: dict[sp.Symbol, sp.Expr] = {}
    for label in RUN_LABELS[run]:
        moved = chain.displacement(run.lower(), *point_names(run, label))
        result |= {reading(label, d): chain.first_order(moved[n]) for n, d in enumerate(DIRECTIONS)}
    return result


@cache
def places(run: str, truncated: bool = True) -> dict[sp.Symbol, sp.Expr]:
    """Coordinates of P_l and P_k in the bed's frame, moved (h) and home (0), to first order or exact."""
    cut = chain.first_order if truncated else chain.exact
    result: dict[sp.Symbol, sp.Expr] = {}
    for point, branch in (("l", chain.workpiece_branch), ("k", chain.tool_branch)):
        for pose, moving in (("h", run.lower()), ("0", "")):
            coordinates = chain.carried(branch(moving), chain.at_point(point))
            result |= {place(d, point, pose): cut(coordinates[n]) for n, d in enumerate(DIRECTIONS)}
    return result


def general() -> dict[sp.Symbol, sp.Expr]:
    """Values of Table 3 for Eqs. (7)-(11): body L is the Y carriage, J the X carriage, K the Z carriage."""
    angle = {
        "SIL": (0, 0, 0),
        "SIJ": (0, 0, EPS_XY),
        "SJK": (EPS_YZ, EPS_XZ, 0),
    }
    values: dict[sp.Symbol, sp.Expr] = {}
    for frame in FRAMES:
        values |= dict(zip(position_symbols(frame), (0, 0, 0, *angle[frame]), strict=True))
    for body, axis in (("l", "y"), ("j", "x"), ("k", "z")):
        for d in DIRECTIONS:
            values[sp.Symbol(f"S_{body}h{d}", real=True)] = POSITION[axis] if d == axis else sp.Integer(0)
    return places("XYZ", truncated=False) | {k: sp.sympify(v) for k, v in values.items()}


def line(run: str) -> dict[sp.Symbol, sp.Expr]:
    """Projections of the displacement L along a linkage line and delta across it, theta from the second axis.

    The first direction of the plane is that with the sine; delta is counted positive towards it.
    """
    first, second = PLANES[run]
    unit = sp.Matrix([sp.sin(THETA), sp.cos(THETA)])
    across = sp.Matrix([unit[1], -unit[0]])
    result: dict[sp.Symbol, sp.Expr] = {component(first): unit[0], component(second): unit[1]}
    for label in RUN_LABELS[run]:
        length, offset_ = sp.Symbol(f"L_{label}h", real=True), straightness(label)
        vector = length * unit + offset_ * across
        result |= {reading(label, first): vector[0], reading(label, second): vector[1]}
    return result


def bar() -> dict[sp.Symbol, sp.Expr]:
    """Ball-bar vector and error; differences of points and vectors have fourth element 0."""
    vector = sp.Matrix([*PE, 1]) - sp.Matrix([0, 0, 0, 1])  # weights of points are 1
    norm = sp.sqrt(vector.dot(vector))
    error = (norm - LENGTH) * vector / norm
    symbols = [sp.Symbol(f"E_{d}", real=True) for d in DIRECTIONS]
    result = dict(zip((*symbols, sp.Symbol("E_v4", real=True)), error, strict=True))
    return result | {ERROR_SIZE: norm - LENGTH, sp.Symbol("P_E4", real=True): vector[3]}


def workpiece_view() -> dict[sp.Symbol, sp.Expr]:
    """P_T^W by vectors: shift and small rotation of the Y carriage undone, by Cramer's rule; then q_w taken off.

    s + epsilon x s solved for s: (b - epsilon x b + epsilon (epsilon . b)) / (1 + |epsilon|^2).
    """
    bed, offset = (sp.Matrix([sp.Symbol(n.format(d), real=True) for d in DIRECTIONS]) for n in ("{}_T^M", "q_w{}"))
    shift = sp.Matrix([delta(d, "y") for d in DIRECTIONS]) + sp.Matrix([0, POSITION["y"], 0])
    about = sp.Matrix([eps(d, "y") for d in DIRECTIONS])
    b = bed - shift
    found = (b - about.cross(b) + about * about.dot(b)) / (1 + about.dot(about)) - offset
    return {seen(d): found[n] for n, d in enumerate(DIRECTIONS)}


def tangent_offsets() -> dict[sp.Symbol, sp.Expr]:
    """Offsets of a carriage that runs where its own small rotation points: sum of (epsilon x axis) times step.

    The rotation matrix of Table 2 turns the unit vector of the axis by epsilon x unit; over a step v_i - v_(i-1)
    that moves the line sideways by so much (v_0 = 0, home).
    """
    index = sp.Symbol("i", integer=True)
    result: dict[sp.Symbol, sp.Expr] = {}
    for pair in OFFSETS:
        direction, axis = pair[0], pair[1]
        about = sp.Matrix([angles(d, axis)[index] for d in DIRECTIONS])
        unit = sp.Matrix([int(d == axis) for d in DIRECTIONS])
        turn = about.cross(unit)[DIRECTIONS.index(direction)]
        step = positions(axis)[index] - positions(axis)[index - 1]
        result[offset(pair)] = total(turn * step)
    return result


def least_squares() -> dict[sp.Symbol, sp.Expr]:
    """Intercept and slope from the normal equations written as matrices."""
    design = sp.Matrix([[1, V[i]] for i in range(1, SAMPLES + 1)])
    data = sp.Matrix([P[i] for i in range(1, SAMPLES + 1)])
    solution = (design.T * design).LUsolve(design.T * data)
    return {intercept("uv"): solution[0], slope("uv"): solution[1]}


def directions() -> dict[sp.Symbol, sp.Expr]:
    """Slopes of the three axis lines of a machine with no errors but Table 2's squareness.

    The line of an axis is where its error-free motion takes a point: the direction of P_kh - P_k0, P_lh - P_l0.
    """
    result: dict[sp.Symbol, sp.Expr] = {}
    for axis in DIRECTIONS:
        branch = chain.workpiece_branch if axis == "y" else chain.tool_branch
        moved, home = (carried_without_motion_errors(branch, moving) for moving in (axis, ""))
        step = [chain.first_order(a - b) for a, b in zip(moved, home, strict=True)]
        for n, d in enumerate(DIRECTIONS):
            if d != axis:
                result[slope(d + axis)] = sp.cancel(step[n] / POSITION[axis])
    return result


def carried_without_motion_errors(branch: Callable[[str], list[sp.Matrix]], moving: str) -> list[sp.Expr]:
    """A point carried along a branch whose 18 motion errors are zero."""
    none = dict.fromkeys(MOTION_ERRORS, sp.Integer(0))
    return [c.xreplace(none) for c in chain.carried(branch(moving), chain.at_point("p"))]


@cache
def known(run: str) -> Known:
    """What the symbols of a part printed for this run stand for."""
    if run in RUN_LABELS:
        return readings(run) | places(run)
    if run.startswith("line "):
        return line(run.removeprefix("line "))
    settings = {
        "chain": general,
        "bar": bar,
        "offset curve": tangent_offsets,
        "workpiece view": workpiece_view,
        "least squares": least_squares,
        "directions": directions,
        **reference_compensation.SETTINGS,
    }
    return settings[run]()


def residual(formula: Formula, values: Known | None = None) -> sp.Expr:
    """lhs - rhs of a printed formula with what follows put in; zero if and only if the formula holds."""
    result = formula.residual(known(formula.run) if values is None else values)
    if formula.run == "directions":
        # The angles between the lines are the angles of Table 2 to first order; beyond that both are conventions.
        return chain.first_order(result.xreplace({e: chain.SCALE * e for e in SQUARENESS}))
    if result.has(sp.Sum):
        result = result.subs(COUNT, SAMPLES).doit().subs({positions(axis)[0]: 0 for axis in DIRECTIONS})
    return sp.expand(sp.cancel(sp.together(result)) if _rational(result) else sp.simplify(result))


def _rational(expression: sp.Expr) -> bool:
    powers = expression.atoms(sp.Pow)
    return not expression.has(sp.sin, sp.cos) and all(power.exp.is_Integer for power in powers)
