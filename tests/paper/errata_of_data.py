"""Errata of Sects. 3.5 and 3.6, of the data (Tables 4 to 7), and of Sects. 2.1, 4 and 5."""

from __future__ import annotations

import sympy as sp

from .mending import Erratum, Kind, Mend, add, on_right, rename, times
from .notation import DIRECTIONS, EPS_YZ, Z_H, eps
from .printed.compensation import ball, ideal_ball
from .printed.linkage_xz import component
from .printed.polynomials import coefficient
from .printed.squareness import DENOMINATOR, INDEX, OFFSETS, P, V, positions, total


def _step(expression: sp.Expr) -> sp.Expr:
    steps = {positions(a)[INDEX]: positions(a)[INDEX] - positions(a)[INDEX - 1] for a in DIRECTIONS}
    return expression.xreplace(steps)


_LAST_SUM = total(V[INDEX]) * (total(V[INDEX] * P[INDEX]) - total(P[INDEX])) / DENOMINATOR


SWAPPED = rename({coefficient(j, i): coefficient(i, j) for i in range(1, 7) for j in range(1, 7)})


def _turned_bar(row: int) -> sp.Expr:
    """What the small rotation of the Y carriage makes of the bar's vector: epsilon(y) x (P_Ti ideal^W - P_W)."""
    bar = sp.Matrix([ideal_ball(d) - ball(d) for d in DIRECTIONS])
    return sp.Matrix([eps(d, "y") for d in DIRECTIONS]).cross(bar)[row]


OF_SQUARENESS_AND_DATA: tuple[Erratum, ...] = (
    Erratum(
        25,
        "Eq. (35)",
        Kind.SIGN,
        "the Z bracket has δ_y(z) - z ε_yz, as in Eqs. (14) and (37)",
        (Mend(35, "y", add(2 * Z_H * EPS_YZ)),),
    ),
    Erratum(
        26,
        "Eq. (36)",
        Kind.CONFLICT,
        "θ is measured from Z in Eqs. (36), (37), not from Y; the projections are L_iyh and L_izh",
        (
            Mend(36, "cosine of theta", rename({component("y"): component("z")})),
            Mend(36, "projections named in the text", instead=("L_iyh", "L_izh")),
        ),
    ),
    Erratum(
        27,
        "Eq. (39)",
        Kind.RECOGNITION,
        "P_uv is the offset curve of the v axis in u direction",
        shown_by="test_letters_of_an_offset_are_its_direction_and_its_axis",
    ),
    Erratum(
        28,
        "Eq. (39)",
        Kind.FORMULA,
        "angles are summed with the step, not with the position",
        tuple(Mend(39, f"P_{pair}", on_right(_step)) for pair in OFFSETS),
    ),
    Erratum(
        29,
        "Eq. (39)",
        Kind.SIGN,
        "P_zx, P_xy and P_yz are negative",
        tuple(Mend(39, f"P_{pair}", times(-1)) for pair in ("zx", "xy", "yz")),
    ),
    Erratum(
        30,
        "Eqs. (39)-(43)",
        Kind.FORMULA,
        "squareness does not follow from pitch and yaw",
        shown_by="test_squareness_is_blind_to_squareness",
    ),
    Erratum(
        31,
        "Eq. (41)",
        Kind.FORMULA,
        "c_uv1: the last sum is of P, not of v P",
        (Mend(41, "c_uv1", add(_LAST_SUM)),),
    ),
    Erratum(
        32,
        "Eq. (43)",
        Kind.SIGN,
        "ε_xz is π/2 - arccos, by Table 2",
        (Mend(43, "epsilon_xz", times(-1)),),
    ),
    Erratum(
        33,
        "Table 4",
        Kind.CONFLICT,
        "P_k8 and P_k9 share x and y: Eqs. (17), (20) are singular",
        (Mend("Table 4", "rank of the systems of X, Y, Z", instead=(3, 3, 2)),),
        shown_by="test_z_system_is_singular",
    ),
    Erratum(
        34,
        "Tables 4, 5",
        Kind.CONFLICT,
        "TCS and WCS coordinates stand for coordinates in the carriages' frames",
        (Mend("Table 4", "frames of X, Y, Z points", instead=("body 6", "body 2", "body 6")),),
        shown_by="test_tool_frame_coordinates_shift_the_errors",
    ),
    Erratum(
        35,
        "Table 5",
        Kind.RECOGNITION,
        "rows and point names have moved: P_1 has r_l1, r_k1, P_2 has r_l2, r_k2",
        (
            Mend(
                "Table 5",
                "point names, XY",
                instead=("P_1 r_l1", "P_1 r_k1", "P_2 r_l2", "P_2 r_k2"),
            ),
            Mend("Table 5", "point names, YZ", instead=("P_1 r_l1", "P_1 r_k1")),
        ),
    ),
    Erratum(
        36,
        "Sect. 2.1",
        Kind.CONFLICT,
        "C is fixed to the Y axis and B to the Z axis, as Sect. 2.3 and Table 2 have it",
        (Mend("Sect. 2.1", "axes that carry C and B", instead=("Y", "Z")),),
    ),
    Erratum(
        37,
        "Eqs. (44), (45)",
        Kind.CONFLICT,
        "the indices of the elements of A are those of Eq. (44) swapped",
        tuple(Mend(45, f"row {j}", SWAPPED) for j in range(1, 7)),
    ),
    Erratum(
        38,
        "Eq. (47)",
        Kind.MISPRINT,
        "it defines X, not x",
        (Mend(47, "matrix that it defines", instead="X"),),
    ),
    Erratum(
        39,
        "Eqs. (53), (54)",
        Kind.FORMULA,
        "both sides must be vectors of one frame: P_D = [SBW] (P_Ti ideal^W - P_W)",
        tuple(Mend(54, d, add(_turned_bar(n))) for n, d in enumerate(DIRECTIONS)),
    ),
    Erratum(
        40,
        "Eq. (55)",
        Kind.CONFLICT,
        "the left-hand side is P_T^W; P_T is constant",
        shown_by="test_tool_ball_in_the_tool_frame_is_constant",
    ),
    Erratum(
        41,
        "Eq. (56)",
        Kind.FORMULA,
        "|E| must be tested, not E",
        shown_by="test_signed_error_passes_however_large",
    ),
    Erratum(
        42,
        "Table 7",
        Kind.CONFLICT,
        "a whole circle of 300 mm radius needs 600 mm, X has 540 mm",
        (Mend("Table 7", "radius of a whole circle, mm", instead=270.0),),
    ),
    Erratum(
        43,
        "Sect. 5.3",
        Kind.CONFLICT,
        '25.1 µm is not "little worse" than 0.53 µm',
        shown_by="test_measured_circle_is_far_from_the_simulation",
    ),
    Erratum(
        44,
        "Sect. 5.1",
        Kind.MISPRINT,
        "the vectors of the bar are in Figs. 4 and 16, not 2 and 16",
        (Mend("Sect. 5.1", "figures that show the vectors", instead=(4, 16)),),
    ),
)
