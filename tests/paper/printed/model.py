"""Eqs. (1)-(11): the chain, the ball bar, and the general motion equation, as printed."""

from __future__ import annotations

import sympy as sp

from ..notation import DIRECTIONS, POSITION, Definition, Entry, Formula, Printed, delta, eps, place, r

FRAMES = ("SIL", "SIJ", "SJK")


def position_symbols(name: str) -> tuple[sp.Symbol, ...]:
    """Translation in [name]_p and the three angles of [name]_pe; Table 3 gives their values."""
    return tuple(sp.Symbol(f"{name}_{part}", real=True) for part in ("px", "py", "pz", "ex", "ey", "ez"))


def _translation(x: sp.Expr, y: sp.Expr, z: sp.Expr) -> sp.Matrix:
    return sp.Matrix([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]])


def _pose(name: str) -> sp.Matrix:
    """[name]_p [name]_pe."""
    px, py, pz, ex, ey, ez = position_symbols(name)
    return _translation(px, py, pz) * sp.Matrix([[1, -ez, ey, 0], [ez, 1, -ex, 0], [-ey, ex, 1, 0], [0, 0, 0, 1]])


def _motion(*subscripts: str) -> sp.Matrix:
    """The printed ideal motion matrix with elements S^l_subscript."""
    return _translation(*(sp.Symbol(f"S_{subscript}", real=True) for subscript in subscripts))


def _motion_error(axis: str) -> sp.Matrix:
    """The printed motion error matrix with S_lh = y, S_jh = x, S_kh = z by Table 3."""
    return sp.Matrix(
        [
            [1, -eps("z", axis), eps("y", axis), delta("x", axis)],
            [eps("z", axis), 1, -eps("x", axis), delta("y", axis)],
            [-eps("y", axis), eps("x", axis), 1, delta("z", axis)],
            [0, 0, 0, 1],
        ]
    )


def _point(name: str) -> sp.Matrix:
    return sp.Matrix([*(r(name, d) for d in DIRECTIONS), 1])


_P_LH = _pose("SIL") * _motion("lhx", "lhy", "lhz") * _motion_error("y") * _point("l")
_P_L0 = _pose("SIL") * _point("l")


def tool_point(frame: str = "SIL") -> tuple[sp.Matrix, sp.Matrix]:
    """P_kh and P_k0 as printed; `frame` is the transform from the bed, printed [SIL]."""
    moved = (
        _pose(frame)
        * _motion("jhx", "jhy", "jhz")
        * _motion_error("x")
        * _pose("SJK")
        * _motion("khhx", "khhy", "khz")
        * _motion_error("z")
        * _point("k")
    )
    return moved, _pose(frame) * _pose("SJK") * _point("k")


_P_KH, _P_K0 = tool_point()


def _rows(point: str, pose: str, vector: sp.Matrix) -> tuple[Formula, ...]:
    return tuple(Formula(d, place(d, point, pose), vector[i], "chain") for i, d in enumerate(DIRECTIONS))


def _relative(direction: str) -> sp.Expr:
    lh, l0, kh, k0 = (place(direction, p, h) for p, h in (("l", "h"), ("l", "0"), ("k", "h"), ("k", "0")))
    return lh - l0 - (kh - k0)


def seen(direction: str) -> sp.Symbol:
    """Coordinate of P_T^W, the tool ball in the workpiece frame."""
    return sp.Symbol(f"{direction}_T^W", real=True)


def in_bed(direction: str) -> sp.Symbol:
    """Coordinate of [SBT] P_T."""
    return sp.Symbol(f"{direction}_T^M", real=True)


_SBW = _translation(0, POSITION["y"], 0) * _motion_error("y")
_SBW = _SBW * _translation(*(sp.Symbol(f"q_w{d}", real=True) for d in DIRECTIONS))
_SEEN = _SBW.inv(method="ADJ") * sp.Matrix([*(in_bed(d) for d in DIRECTIONS), 1])
"""Right-hand side of Eq. (4) with [SBW] by Table 2, its corner mended (E5)."""

PE = tuple(sp.Symbol(f"P_E{d}", real=True) for d in DIRECTIONS)
LENGTH, ERROR_SIZE = sp.symbols("l_1 E", real=True)
_NORM = sp.sqrt(sum(p**2 for p in PE))
_COSINES = tuple(p / _NORM for p in PE)

MODEL: tuple[Printed, ...] = (
    Printed(
        1,
        "transform between adjacent bodies",
        "2.3",
        (
            Entry("order of the factors", ("p", "pe", "s", "se")),
            Entry("wording: I and J of [SIJ]", ("I: rigid body", "J: adjacent lower body")),
        ),
    ),
    Printed(
        2,
        "bed to workpiece",
        "2.3",
        (
            Entry("body whose lower bodies run to the bed", 3),
            Entry("expanded product", ("S12", "S24")),
        ),
    ),
    Printed(
        3,
        "bed to tool",
        "2.3",
        (
            Entry("body whose lower bodies run to the bed", 4),
            Entry("expanded product", ("S15", "S56", "S69")),
        ),
    ),
    Printed(
        4,
        "tool point in the workpiece frame",
        "2.3",
        tuple(Formula(d, seen(d), _SEEN[i], "workpiece view") for i, d in enumerate(DIRECTIONS)),
    ),
    Printed(
        5,
        "vector of the ball bar",
        "2.3",
        (
            *(Definition(d, PE[i], seen(d) - sp.Symbol(f"{d}_w", real=True)) for i, d in enumerate(DIRECTIONS)),
            Formula("fourth element", sp.Symbol("P_E4", real=True), sp.Integer(0), "bar"),
        ),
    ),
    Printed(
        6,
        "positioning error",
        "2.3",
        (
            Formula("E", ERROR_SIZE, _NORM - LENGTH, "bar"),
            *(
                Formula(f"E_{d}", sp.Symbol(f"E_{d}", real=True), (_NORM - LENGTH) * _COSINES[i], "bar")
                for i, d in enumerate(DIRECTIONS)
            ),
            Formula("fourth element", sp.Symbol("E_v4", real=True), sp.Integer(1), "bar"),
        ),
    ),
    Printed(7, "point on body L, moved", "3.1", _rows("l", "h", _P_LH)),
    Printed(8, "point on body L, home", "3.1", _rows("l", "0", _P_L0)),
    Printed(9, "point on body K, moved", "3.1", _rows("k", "h", _P_KH)),
    Printed(10, "point on body K, home", "3.1", _rows("k", "0", _P_K0)),
    Printed(
        11,
        "general motion equation",
        "3.1",
        tuple(
            Formula(d, _relative(d), _P_LH[i] - _P_L0[i] - (_P_KH[i] - _P_K0[i]), "chain")
            for i, d in enumerate(DIRECTIONS)
        ),
    ),
)
