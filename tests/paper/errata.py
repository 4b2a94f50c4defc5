"""The errata as data: which printed parts are wrong and the least change that makes each follow."""

from __future__ import annotations

import sympy as sp

from .errata_of_data import OF_SQUARENESS_AND_DATA
from .mending import Erratum, Kind, Mend, add, coordinates, on_left, on_right, rename, times
from .notation import DIRECTIONS, delta, eps, place, r, reading
from .printed.linkage_xz import BASE, THETA, ideal_length, straightness
from .printed.model import position_symbols, tool_point
from .printed.tables import TRANSFORMS

LETTER_L = rename(
    coordinates({"11": "l1", "12": "l2", "1l": "l1", "2l": "l2", "kl": "k1"})
    | {sp.Symbol("l_ly", real=True): r("l", "y")}
    | {place(d, "i", pose): place(d, "l", pose) for d in DIRECTIONS for pose in ("h", "0")}
)
_LETTER_PLACES: tuple[tuple[int, tuple[str, ...]], ...] = (
    (13, ("x", "z")),
    (18, ("row 1",)),
    (27, ("x", "y", "z")),
    (30, ("L_1xh", "L_2xh")),
    (31, ("row 1", "row 2")),
    (32, ("epsilon_y(y)", "delta_x(y)")),
    (33, ("L_1yh",)),
    (34, ("delta_y(x)",)),
    (37, ("L_1yh", "L_1zh")),
    (38, ("delta_z(y)", "delta_y(z)")),
)
_LINE_PLACES: tuple[tuple[int, str, tuple[str, ...]], ...] = (
    (22, "", ("L_ixh", "L_izh")),
    (24, "where ", ("L_1xh", "L_1zh", "L_2xh", "L_2zh")),
    (28, "", ("L_ixh", "L_iyh")),
    (30, "where ", ("L_1xh", "L_2xh")),
    (33, "where ", ("L_1yh",)),
    (36, "", ("L_iyh", "L_izh")),
    (37, "where ", ("L_1yh", "L_1zh")),
)
ACTUAL_LENGTH = rename({ideal_length(i): sp.Symbol(f"L_{i}h", real=True) for i in ("i", "1", "2")})
JOINT_J = rename(dict(zip(position_symbols("SIL"), position_symbols("SIJ"), strict=True)))
K_MOTION = rename({sp.Symbol(f"S_khh{d}", real=True): sp.Symbol(f"S_kh{d}", real=True) for d in "xy"})


def _cosine_sign(source: int, label: str) -> Mend:
    """- delta sin(theta) where + stands."""
    point = label.removeprefix("where L_")[0] if label.startswith("where") else "i"
    return Mend(source, label, add(-2 * straightness(point) * sp.sin(THETA)))


def _relabelled(source: int, first: int, end: str, direction: str) -> tuple[Mend, ...]:
    """Row by row, point i becomes point i + 3."""
    mends = []
    for row in (1, 2, 3):
        old, new = first + row - 1, first + row + 2
        names = coordinates({f"{end}{old}": f"{end}{new}"})
        names[reading(str(old), direction)] = reading(str(new), direction)
        mends.append(Mend(source, f"row {row}", rename(names)))
    return tuple(mends)


def _joint(source: int) -> tuple[Mend, ...]:
    """[SIL] becomes [SIJ]; a rotation about Z leaves z as it is."""
    return tuple(Mend(source, d, JOINT_J) for d in ("x", "y"))


def _tool_of_joint_j(row: int) -> sp.Expr:
    """Eq. (11): [SIJ] in the tool's part alone; the worktable's [SIL] is right."""
    (moved, home), (right_moved, right_home) = tool_point(), tool_point("SIJ")
    return (moved - home - right_moved + right_home)[row]


_ABOUT_Y = eps("y", "x") + eps("y", "z")
_YAW = (r("l1", "x") - r("l1", "z")) * eps("z", "y")


def _table_2_corner(name: str) -> Mend:
    corrected = TRANSFORMS[name].as_mutable()
    corrected[3, 3] = 1
    return Mend("Table 2", name, instead=corrected.as_immutable())


ERRATA: tuple[Erratum, ...] = (
    Erratum(
        1,
        "Table 1",
        Kind.MISPRINT,
        "yaw of Z is ε_y(z), not ε_y(y)",
        (Mend("Table 1", "Yaw error", instead=("epsilon_z(x)", "epsilon_z(y)", "epsilon_y(z)")),),
    ),
    Erratum(
        2,
        "Table 1",
        Kind.RECOGNITION,
        "straightness rows y and z have their first error under Y, row yaw all its errors a column to the left",
        (
            Mend("Table 1", "x direction", instead=("", "delta_x(y)", "delta_x(z)")),
            Mend("Table 1", "y direction", instead=("delta_y(x)", "", "delta_y(z)")),
            Mend("Table 1", "z direction", instead=("delta_z(x)", "delta_z(y)", "")),
            Mend("Table 1", "Yaw error", instead=("epsilon_z(x)", "epsilon_z(y)", "epsilon_y(y)")),
        ),
    ),
    Erratum(
        3,
        "Eq. (1)",
        Kind.CONFLICT,
        "I is the lower body and J the upper one, as in Eqs. (2), (3), (7)",
        (Mend(1, "wording: I and J of [SIJ]", instead=("I: adjacent lower body", "J: rigid body")),),
    ),
    Erratum(
        4,
        "Eqs. (2), (3)",
        Kind.MISPRINT,
        "the products start at bodies 4 and 9, not 3 and 4",
        (
            Mend(2, "body whose lower bodies run to the bed", instead=4),
            Mend(3, "body whose lower bodies run to the bed", instead=9),
        ),
    ),
    Erratum(
        5,
        "Table 2",
        Kind.MISPRINT,
        "the last element of the three motion matrices is 1, not 0",
        tuple(_table_2_corner(name) for name in ("S12_s", "S15_s", "S56_s")),
    ),
    Erratum(
        6,
        "Eq. (6)",
        Kind.CONFLICT,
        "the fourth element of the error vector is 0, as in Eq. (5), not 1",
        (Mend(6, "fourth element", on_right(lambda rhs: rhs - 1)),),
    ),
    Erratum(
        7,
        "Sect. 3.1",
        Kind.CONFLICT,
        "bodies L and J are the Y and X axes (Table 3), not X and Y",
        (Mend("Table 3", "wording: bodies X, Y, Z are called (Sect. 3.1)", instead=("J", "L", "K")),),
    ),
    Erratum(
        8,
        "Eqs. (9)-(11), Table 3",
        Kind.CONFLICT,
        "[SIL] in the tool branch and [SLJ] in Table 3 are both [SIJ]; else Eq. (12) loses x ε_xy",
        (
            *_joint(9),
            *_joint(10),
            *(Mend(11, d, add(_tool_of_joint_j(n))) for n, d in enumerate("xy")),
            Mend("Table 3", "position transforms are those of", instead=("SIL", "SIJ", "SJK")),
        ),
    ),
    Erratum(
        9,
        "Eqs. (9), (11)",
        Kind.RECOGNITION,
        "S_khhx, S_khhy are S_khx, S_khy",
        tuple(Mend(source, d, K_MOTION) for source in (9, 11) for d in DIRECTIONS),
    ),
    Erratum(
        10,
        "Eqs. (13), (18), (27), (30)-(34), (37), (38), Tables 4, 5",
        Kind.RECOGNITION,
        "digit 1 and letters l, i are confused in point names (l_ly, r_klz, x_ih, r_1ly, r_11z, P_14)",
        (
            *(Mend(source, label, LETTER_L) for source, labels in _LETTER_PLACES for label in labels),
            Mend("Table 4", "point names, Y axis", instead=("P_l4", "P_l5", "P_l6")),
        ),
    ),
    Erratum(
        11,
        "Eq. (18)",
        Kind.MISPRINT,
        "-r_k1x is -r_k1y; the last r_k3y is r_k3z, as in Eq. (15)",
        (
            Mend(18, "row 1", on_left(lambda lhs: lhs + (r("k1", "x") - r("k1", "y")) * eps("z", "x"))),
            Mend(18, "row 3", on_left(lambda lhs: lhs + (r("k3", "z") - r("k3", "y")) * eps("y", "x"))),
        ),
    ),
    Erratum(
        12,
        "Eqs. (19), (20)",
        Kind.CONFLICT,
        "points and readings 1-3 and 4-6 are 4-6 and 7-9, as in Eqs. (16), (17) and Table 4",
        (*_relabelled(19, 1, "l", "y"), *_relabelled(20, 4, "k", "z")),
    ),
    Erratum(
        13,
        "Eq. (21)",
        Kind.SIGN,
        "elements (1,3) and (3,2) are +ε_y(z) and +ε_x(z)",
        (
            Mend(21, "x", add(2 * eps("y", "z") * r("k", "z"))),
            Mend(21, "z", add(2 * eps("x", "z") * r("k", "y"))),
        ),
    ),
    Erratum(
        14,
        "Eqs. (22), (24), (36), (37)",
        Kind.SIGN,
        "the projection along cos θ has - δ sin θ, as in Eq. (28)",
        (
            _cosine_sign(22, "L_izh"),
            _cosine_sign(24, "where L_1zh"),
            _cosine_sign(24, "where L_2zh"),
            _cosine_sign(36, "L_izh"),
            _cosine_sign(37, "where L_1zh"),
        ),
    ),
    Erratum(
        15,
        "Eqs. (22), (24), (28), (30), (33), (36), (37)",
        Kind.FORMULA,
        "the projections need the actual length L, not the ideal one",
        tuple(
            Mend(source, prefix + label, ACTUAL_LENGTH) for source, prefix, labels in _LINE_PLACES for label in labels
        ),
    ),
    Erratum(
        16,
        "Eq. (23)",
        Kind.SIGN,
        "the last term of L_izh is + r_kiy (ε_x(x) + ε_x(z)), as in Eq. (24)",
        (Mend(23, "L_izh", add(2 * r("ki", "y") * (eps("x", "x") + eps("x", "z")))),),
    ),
    Erratum(
        17,
        "Eq. (25)",
        Kind.SIGN,
        "rows 1 and 2: the right-hand side has the opposite sign",
        (Mend(25, "row 1", times(-1)), Mend(25, "row 2", times(-1))),
    ),
    Erratum(
        18,
        "Eq. (25)",
        Kind.FORMULA,
        "rows 3 and 4: δ_z(x) is unknown and cannot stand on the right",
        (Mend(25, "row 3", add(delta("z", "x"))), Mend(25, "row 4", add(delta("z", "x")))),
    ),
    Erratum(
        19,
        "Eq. (26)",
        Kind.FORMULA,
        "δ_x(z) and δ_z(x) are not divided by r_k1y - r_k2y",
        (Mend(26, "delta_x(z)", times(BASE)), Mend(26, "delta_z(x)", times(BASE))),
    ),
    Erratum(
        20,
        "Eq. (26)",
        Kind.SIGN,
        "ε_x(x): + (r_k1x - r_k2x)(ε_y(x) + ε_y(z))",
        (Mend(26, "epsilon_x(x)", add(2 * (r("k1", "x") - r("k2", "x")) * _ABOUT_Y / BASE)),),
    ),
    Erratum(
        21,
        "Eq. (27)",
        Kind.MISPRINT,
        "the X bracket has δ_x(x_h) + x_h, not δ_x(y_h) + x_h",
        (Mend(27, "x", add(delta("x", "y") - delta("x", "x"))),),
    ),
    Erratum(
        22,
        "Eq. (32)",
        Kind.MISPRINT,
        "L_1xh L_2zh is L_1xh - L_2xh",
        (
            Mend(
                32,
                "epsilon_y(y)",
                on_right(
                    lambda rhs: rhs.subs(reading("1", "x") * reading("2", "z"), reading("1", "x") - reading("2", "x"))
                ),
            ),
        ),
    ),
    Erratum(
        23,
        "Eq. (32)",
        Kind.SIGN,
        "the factor of ε_y(x) is r_k1z - r_k2z",
        (
            Mend(
                32,
                "epsilon_y(y)",
                add(
                    2 * (r("k1", "z") - r("k2", "z")) * eps("y", "x") / (r("l1", "z") - r("l2", "z")),
                ),
            ),
        ),
    ),
    Erratum(
        24,
        "Eqs. (33), (34)",
        Kind.MISPRINT,
        "the factor of ε_z(y) is r_l1x, as in Eq. (29)",
        (Mend(33, "L_1yh", add(_YAW)), Mend(34, "delta_y(x)", add(_YAW))),
    ),
    *OF_SQUARENESS_AND_DATA,
)
