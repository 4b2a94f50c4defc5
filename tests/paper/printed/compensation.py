"""Eqs. (53)-(56) and Table 7: the condition of compensation, its iteration and the test, as printed."""

from __future__ import annotations

import sympy as sp

from ..notation import DIRECTIONS, Definition, Formula, Printed
from .model import ERROR_SIZE, in_bed

RESOLUTION = sp.Symbol("Delta_DBB", positive=True)


def bar_vector(direction: str) -> sp.Symbol:
    """P_D, the vector of the ball bar in the machine frame."""
    return sp.Symbol(f"P_D{direction}", real=True)


def ball_in_bed(direction: str) -> sp.Symbol:
    """P_W^M = [SBW] P_W."""
    return sp.Symbol(f"{direction}_W^M", real=True)


def ideal_ball(direction: str) -> sp.Symbol:
    """P_Ti ideal^W, the ideal position of the tool ball in the workpiece frame."""
    return sp.Symbol(f"{direction}_ideal^W", real=True)


def ball(direction: str) -> sp.Symbol:
    """P_W, the workpiece ball in the workpiece frame."""
    return sp.Symbol(f"{direction}_w", real=True)


ACCEPTED = sp.Le(ERROR_SIZE, RESOLUTION)
"""Eq. (56): the iteration ends where this holds."""

COMPENSATION: tuple[Printed, ...] = (
    Printed(
        53,
        "vector of the ball bar in the machine frame",
        "5.1",
        tuple(Definition(d, bar_vector(d), in_bed(d) - ball_in_bed(d)) for d in DIRECTIONS),
    ),
    Printed(
        54,
        "condition of compensation",
        "5.1",
        tuple(Formula(d, bar_vector(d), ideal_ball(d) - ball(d), "compensated") for d in DIRECTIONS),
    ),
    # The left-hand side of Eq. (55) is "the coordinate values of P_T", fixed in the tool frame.
    Printed(
        55,
        "position of the tool ball from the NC code",
        "5.1",
        tuple(
            Definition(d, sp.Symbol(f"{d.upper()}_T", real=True), sp.Symbol(f"Psi_{d}", real=True)) for d in DIRECTIONS
        ),
    ),
    Printed(56, "end of the iteration", "5.1", (Definition("accepted", sp.Symbol("accepted"), ACCEPTED),)),
)

FIGURES = {
    2: "The topology structure of the MAMT",
    4: "The relative motion path vector map between two ends of DBB",
    16: "The schematic diagram of the coordinate system transformation",
}
"""Captions of the figures that Sects. 2.3 and 5.1 refer to for vectors."""
STROKES = {"X": 540.0, "Y": 700.0, "Z": 600.0}
"""Sect. 4.1, mm."""
LARGEST_ERROR_SIMULATED, LARGEST_ERROR_MEASURED = 0.53, 25.1
"""Sects. 5.2 and 5.3 (Table 8), micrometres, both with the iterative method."""
RESIDUALS = {"mean": 0.244, "sd": 0.119, "max": 0.53}
"""Sect. 5.2, micrometres: positioning errors with the iterative method."""
