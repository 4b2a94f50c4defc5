"""What follows for printed entries that are no formulas: cells, matrices, indices, words; each worked out here."""

from __future__ import annotations

import re
from functools import cache

import numpy as np
import sympy as sp

from . import chain
from .claims_systems import single_axis_matrices
from .notation import DIRECTIONS, Formula
from .printed import EQUATIONS
from .printed.compensation import FIGURES, STROKES
from .printed.conditions import TEST_CONDITIONS
from .printed.polynomials import MODEL_NAMES
from .printed.tables import MOTIONS, TRANSFORMS

LOWER_BODY = {2: 1, 3: 2, 4: 2, 5: 1, 6: 5, 7: 6, 8: 7, 9: 6}
"""Fig. 2 and Sect. 2.1: bodies 3, 7, 8 stand on 2 and 6; workpiece and tool are taken as fixed to these."""
WORKPIECE, TOOL = 4, 9
AXIS_BODY = {"X": 5, "Y": 2, "Z": 6}


def branch(body: int) -> tuple[str, ...]:
    """Names S(lower)(body) from the bed to a body."""
    names: list[str] = []
    while body in LOWER_BODY:
        names.insert(0, f"S{LOWER_BODY[body]}{body}")
        body = LOWER_BODY[body]
    return tuple(names)


def _table_1() -> dict[str, object]:
    """Rows by what the words mean: roll about the axis itself; pitch and yaw by ISO 230-1 for a horizontal axis.

    For Z, which has no horizontal plane of its own, the paper calls the rotation about X pitch; that about Y remains.
    """
    cells = {
        "Positioning error": tuple(f"delta_{a}({a})" for a in DIRECTIONS),
        "Roll error": tuple(f"epsilon_{a}({a})" for a in DIRECTIONS),
    }
    for first, second in ("xy", "xz", "yz"):
        # One squareness has no axis of its own: the table has it once, in its first column.
        cells[f"{first.upper()}{second.upper()} axis perpendicularity error"] = (f"epsilon_{first}{second}", "", "")
    for d in DIRECTIONS:
        cells[f"{d} direction"] = tuple("" if a == d else f"delta_{d}({a})" for a in DIRECTIONS)
    pitch = {"x": "y", "y": "x", "z": "x"}
    cells["Pitch error"] = tuple(f"epsilon_{pitch[a]}({a})" for a in DIRECTIONS)
    rest = {a: next(d for d in reversed(DIRECTIONS) if d not in (a, pitch[a])) for a in DIRECTIONS}
    cells["Yaw error"] = tuple(f"epsilon_{rest[a]}({a})" for a in DIRECTIONS)
    return dict(cells)


def _table_2() -> dict[str, object]:
    """The factors of the chain composed in `chain`, with workpiece and tool offsets between parallel frames."""
    identity = sp.eye(4)
    result = {f"{joint}_{part}": identity for joint in ("S12", "S24", "S15", "S56", "S69") for part in _ORDER}
    x_error, x_motion, x_motion_error, z_error, z_motion, z_motion_error = chain.tool_branch("xz")
    y_motion, y_motion_error = chain.workpiece_branch("y")
    result |= {"S12_s": y_motion, "S12_se": y_motion_error}
    result |= {"S15_pe": x_error, "S15_s": x_motion, "S15_se": x_motion_error}
    result |= {"S56_pe": z_error, "S56_s": z_motion, "S56_se": z_motion_error}
    for joint, end in (("S24", "w"), ("S69", "T")):
        offset = sp.eye(4)
        offset[:3, 3] = sp.Matrix([sp.Symbol(f"q_{end}{d}", real=True) for d in DIRECTIONS])
        result[f"{joint}_p"] = offset
    return {name: m.subs(chain.SCALE, 1).as_immutable() for name, m in result.items()}


_ORDER = ("p", "pe", "s", "se")


def _table_3() -> dict[str, object]:
    letter = {"Y": "L", "X": "J", "Z": "K"}
    columns: dict[str, object] = {}
    for axis, body in letter.items():
        motion = sp.Matrix(chain.motion(axis.lower(), axis.lower())[0][:3, 3])
        columns[f"S_{body.lower()}h^l"] = tuple(
            (*(motion if axis in moving else sp.zeros(3, 1)), 1) for moving in MOTIONS
        )
    letters = {AXIS_BODY[axis]: body for axis, body in letter.items()} | {1: "I"}
    lower = [f"S{letters[LOWER_BODY[body]]}{letters[body]}" for body in (2, 5, 6)]
    x_error, z_error = (m.subs(chain.SCALE, 1).as_immutable() for m in chain.tool_branch(""))
    return columns | {
        "wording: bodies X, Y, Z are called (Sect. 3.1)": tuple(letter[a] for a in "XYZ"),
        "position transforms are those of": tuple(lower),
        "first position error": sp.eye(4).as_immutable(),
        "second position error": x_error,
        "third position error": z_error,
    }


def _point_tables() -> dict[tuple[int | str, str], object]:
    ranks = tuple(int(np.linalg.matrix_rank(matrix)) for matrix in single_axis_matrices().values())
    return {
        ("Table 4", "point names, Y axis"): tuple(f"P_l{i}" for i in (4, 5, 6)),
        # Sect. 3.1: "in the reference coordinate system of body" K and L.
        ("Table 4", "frames of X, Y, Z points"): tuple(f"body {AXIS_BODY[a]}" for a in "ZYZ"),
        ("Table 4", "rank of the systems of X, Y, Z"): ranks,
        ("Table 5", "point names, XZ"): tuple(f"P_k{i} r_k{i}" for i in (1, 2)),
        ("Table 5", "point names, XY"): tuple(f"P_{i} r_{end}{i}" for i in (1, 2) for end in "lk"),
        ("Table 5", "point names, YZ"): tuple(f"P_1 r_{end}1" for end in "lk"),
    }


@cache
def follows() -> dict[tuple[int | str, str], object]:
    """What must stand in each printed entry, by (equation or table, label)."""
    result: dict[tuple[int | str, str], object] = {
        (1, "order of the factors"): _ORDER,
        (1, "wording: I and J of [SIJ]"): _roles(),
        (2, "body whose lower bodies run to the bed"): WORKPIECE,
        (2, "expanded product"): branch(WORKPIECE),
        (3, "body whose lower bodies run to the bed"): TOOL,
        (3, "expanded product"): branch(TOOL),
        ("Sect. 2.1", "axes that carry C and B"): _carriers(),
        (47, "matrix that it defines"): MODEL_NAMES[1],
        ("Table 7", "radius of a whole circle, mm"): largest_radius(),
        ("Sect. 5.1", "figures that show the vectors"): _figures_of_vectors(),
        (36, "projections named in the text"): _left_sides(36, "L_"),
    }
    for table, cells in (("Table 1", _table_1()), ("Table 2", _table_2()), ("Table 3", _table_3())):
        result |= {(table, label): cell for label, cell in cells.items()}
    return result | _point_tables()


def _carriers() -> tuple[str, ...]:
    """By Table 2 the workpiece, which stands on C, goes with one axis, the tool, which hangs on B, with another."""
    axis = {body: name for name, body in AXIS_BODY.items()}
    lower = {int(name[2]): int(name[1]) for name in TRANSFORMS}
    return tuple(axis[lower[end]] for end in (WORKPIECE, TOOL))


def largest_radius() -> float:
    """Radius of the largest whole circle: its diameter is the shorter stroke in its plane."""
    return min(STROKES[axis] for axis in TEST_CONDITIONS.plane) / 2


def _figures_of_vectors() -> tuple[int, ...]:
    """Figures whose captions speak of the vector between the balls and of the frames that it is taken to."""
    return tuple(number for number, caption in FIGURES.items() if re.search("vector|coordinate system", caption))


def _left_sides(equation: int, head: str) -> tuple[str, ...]:
    """The names that a printed equation itself gives to its left-hand sides."""
    parts = next(item.parts for item in EQUATIONS if item.number == equation)
    return tuple(str(p.lhs) for p in parts if isinstance(p, Formula) and str(p.lhs).startswith(head))


def _roles() -> tuple[str, str]:
    """In [S12] of Eq. (2), which of 1 and 2 is the lower body of the other?"""
    first, second = (int(c) for c in branch(WORKPIECE)[0][1:])
    lower, upper = "adjacent lower body", "rigid body"
    return (f"I: {lower}", f"J: {upper}") if LOWER_BODY[second] == first else (f"I: {upper}", f"J: {lower}")
