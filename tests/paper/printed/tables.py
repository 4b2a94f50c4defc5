"""Tables 1-7 as printed (4-6 are the data that Sect. 3 is judged by), and the figures of Sect. 5 that are ratios."""

from __future__ import annotations

import sympy as sp

from ..notation import DIRECTIONS, EPS_XY, EPS_XZ, EPS_YZ, X_H, Y_H, Z_H, Definition, Entry, Printed, delta, eps
from .conditions import TEST_CONDITIONS

IDENTITY = sp.ImmutableDenseMatrix.eye(4)


def _translation(x: object, y: object, z: object, corner: int = 1) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, corner]])


def _motion_error(axis: str) -> sp.ImmutableDenseMatrix:
    ex, ey, ez = (eps(d, axis) for d in DIRECTIONS)
    dx, dy, dz = (delta(d, axis) for d in DIRECTIONS)
    return sp.ImmutableDenseMatrix([[1, -ez, ey, dx], [ez, 1, -ex, dy], [-ey, ex, 1, dz], [0, 0, 0, 1]])


def _offset(end: str) -> sp.ImmutableDenseMatrix:
    return _translation(*(sp.Symbol(f"q_{end}{d}", real=True) for d in DIRECTIONS))


XY_ERROR = sp.ImmutableDenseMatrix([[1, -EPS_XY, 0, 0], [EPS_XY, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
Z_ERROR = sp.ImmutableDenseMatrix([[1, 0, EPS_XZ, 0], [0, 1, -EPS_YZ, 0], [-EPS_XZ, EPS_YZ, 1, 0], [0, 0, 0, 1]])

TRANSFORMS: dict[str, sp.ImmutableDenseMatrix] = {
    "S12_p": IDENTITY,
    "S12_s": _translation(0, Y_H, 0, corner=0),
    "S12_pe": IDENTITY,
    "S12_se": _motion_error("y"),
    "S24_p": _offset("w"),
    "S24_s": IDENTITY,
    "S24_pe": IDENTITY,
    "S24_se": IDENTITY,
    "S15_p": IDENTITY,
    "S15_s": _translation(X_H, 0, 0, corner=0),
    "S15_pe": XY_ERROR,
    "S15_se": _motion_error("x"),
    "S56_p": IDENTITY,
    "S56_s": _translation(0, 0, Z_H, corner=0),
    "S56_pe": Z_ERROR,
    "S56_se": _motion_error("z"),
    "S69_p": _offset("T"),
    "S69_s": IDENTITY,
    "S69_pe": IDENTITY,
    "S69_se": IDENTITY,
}
"""Table 2; x, y, z are written with the index h that the rest of the data uses."""

_NONE = (0, 0, 0, 1)
_IN_X, _IN_Y, _IN_Z = (X_H, 0, 0, 1), (0, Y_H, 0, 1), (0, 0, Z_H, 1)
MOTIONS = ("X", "Y", "Z", "XY", "XZ", "YZ")
IDEAL_MOTION: dict[str, tuple[tuple[object, ...], ...]] = {
    "S_lh^l": (_NONE, _IN_Y, _NONE, _IN_Y, _NONE, _IN_Y),
    "S_jh^l": (_IN_X, _NONE, _NONE, _IN_X, _IN_X, _NONE),
    "S_kh^l": (_NONE, _NONE, _IN_Z, _NONE, _IN_Z, _IN_Z),
}
"""Table 3, upper part: one column per pattern of `MOTIONS`."""

POINTS_SINGLE: dict[str, tuple[float, float, float]] = {
    "k1": (167, 30, -195),
    "k2": (185, 30, -175),
    "k3": (232, 40, -164),
    "l4": (45, -85, 64),
    "l5": (45, -85, 115),
    "l6": (150, -120, 84),
    "k7": (-100, -77, 125),
    "k8": (-54, -72, 125),
    "k9": (-54, -72, -165),
}
"""Table 4, mm, with P_14 read as P_l4 and so on."""

POINTS_LINKAGE: dict[str, dict[str, tuple[float, float, float]]] = {
    "XZ": {"k1": (-75.2, 31.8, 58.3), "k2": (-75.2, 81.7, 58.3)},
    "XY": {
        "l1": (130, 195, 75),
        "k1": (-187.8, 97, -49.127),
        "l2": (130, 195, 105),
        "k2": (-187.8, 97, -19.127),
    },
    "YZ": {"l1": (113, 20, 78), "k1": (-220, 93, -26)},
}
"""Table 5, mm, with its rows put under the linkage that Sects. 3.3-3.5 use them in."""

SQUARENESS_VALUES = {"epsilon_xy": -0.000005, "epsilon_xz": 0.000026, "epsilon_yz": 0.00001}
"""Table 6, rad."""

IMPROVEMENTS = {
    "mean positioning error": ("0.00119", "0.000244", "79.5"),
    "standard deviation": ("0.000249", "0.000119", "52.2"),
    "maximum circularity error": ("42.1", "25.1", "40.4"),
}
"""Sects. 5.2 and 5.3, Table 8: ordinary, iterative, printed reduction in per cent, digits as printed."""

TABLE_1 = """\
\t\tX axis\tY axis\tZ axis
PDGEs\tPositioning error\tdelta_x(x)\tdelta_y(y)\tdelta_z(z)
\tStraightness error\tx direction\tdelta_x(y)\tdelta_x(z)
\t\ty direction\tdelta_y(x)\tdelta_y(z)
\t\tz direction\tdelta_z(x)\tdelta_z(y)
\tRoll error\tepsilon_x(x)\tepsilon_y(y)\tepsilon_z(z)
\tPitch error\tepsilon_y(x)\tepsilon_x(y)\tepsilon_x(z)
Yaw error\tepsilon_z(x)\tepsilon_z(y)\tepsilon_y(y)\t
PIGEs\tXY axis perpendicularity error\tepsilon_xy\t\t
\tXZ axis perpendicularity error\tepsilon_xz\t\t
\tYZ axis perpendicularity error\tepsilon_yz\t\t
"""
"""Table 1 as the recognised text has it, tabs included, its maths in the names used here."""


def table_1_cells() -> dict[str, tuple[str, ...]]:
    """For each row of Table 1 the cells that stand under its headings X axis, Y axis, Z axis."""
    head, *lines = (line.split("\t") for line in TABLE_1.splitlines())
    columns = [head.index(f"{axis} axis") for axis in "XYZ"]
    rows: dict[str, tuple[str, ...]] = {}
    for line in lines:
        name = next(cell for cell in line if cell and cell not in ("PDGEs", "PIGEs", "Straightness error"))
        rows[name] = tuple(line[column] for column in columns)
    return rows


TABLES: tuple[Printed, ...] = (
    Printed(
        "Sect. 2.1",
        "what the rotary axes are fixed to",
        "2.1",
        # "by fixing C axis and B axis as one unit moving with the Z axis and Y axis, respectively"
        (Entry("axes that carry C and B", ("Z", "Y")),),
    ),
    Printed(
        "Table 1",
        "the 21 errors",
        "2.2",
        tuple(Entry(label, cells) for label, cells in table_1_cells().items()),
    ),
    Printed(
        "Table 2",
        "transforms of the adjacent bodies",
        "2.3",
        tuple(Entry(name, matrix) for name, matrix in TRANSFORMS.items()),
    ),
    Printed(
        "Table 3",
        "parameters of the motion equation",
        "3.2",
        (
            *(Entry(name, columns) for name, columns in IDEAL_MOTION.items()),
            Entry("wording: bodies X, Y, Z are called (Sect. 3.1)", ("L", "J", "K")),
            Entry("position transforms are those of", ("SIL", "SLJ", "SJK")),
            Entry("first position error", IDENTITY),
            Entry("second position error", XY_ERROR),
            Entry("third position error", Z_ERROR),
        ),
    ),
    Printed(
        "Table 4",
        "points of single-axis motion",
        "4.1",
        (
            Entry("point names, Y axis", ("P_14", "P_15", "P_16")),
            Entry("frames of X, Y, Z points", ("TCS", "WCS", "TCS")),
            Entry("rank of the systems of X, Y, Z", (3, 3, 3)),
        ),
    ),
    Printed(
        "Table 5",
        "points of two-axis motion",
        "4.1",
        (
            Entry("point names, XZ", ("P_k1 r_k1", "P_k2 r_k2")),
            Entry("point names, XY", ("P_1 r_11", "P_2 r_k1", "P_2 r_12")),
            Entry("point names, YZ", ("P_1 r_k2", "P_1 r_11", "P_1 r_k1")),
        ),
    ),
    Printed(
        "Table 6",
        "squareness values",
        "4.2",
        tuple(Definition(name, sp.Symbol(name, real=True), sp.Float(v)) for name, v in SQUARENESS_VALUES.items()),
    ),
    Printed(
        "Table 7",
        "test conditions",
        "5.3",
        (Entry("radius of a whole circle, mm", TEST_CONDITIONS.radius),),
    ),
    Printed(
        "Sect. 5.1",
        "figures of the vectors of the bar",
        "5.1",
        # "coincident with the vector difference of P_Ti ideal^W and P_W at any moment, as shown in Figs. 2 and 16"
        (Entry("figures that show the vectors", (2, 16)),),
    ),
)
