"""The figures of ISO 230-4: circular deviation G, both directions G(b), radial deviation F, mean radial deviation D."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.evaluation.iso230_4.circular_test import Arc, CircularTest, FloatArray, circularity

STANDARD = "ISO 230-4"


@dataclass(frozen=True, slots=True, kw_only=True)
class OfArc:
    """One arc, mm. G: circular deviation, range of the radial deviations about the least-squares centre; zone: the same
    about the centre that makes it least (minimum zone circles); F_max, F_min: radial deviation from the nominal radius,
    about the least-squares centre; centre: in the plane.
    """

    id: str
    sense: int
    G: float
    zone: float
    F_max: float
    F_min: float
    centre: tuple[float, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class CircularFigures:
    """mm. G_b: bidirectional circular deviation, of all arcs about one centre, None with one sense of rotation; D: mean
    radial deviation of all arcs.
    """

    arcs: tuple[OfArc, ...]
    G_b: float | None
    D: float


def circular_figures(test: CircularTest) -> CircularFigures:
    """Evaluate the test. Source: ISO 230-4:2022, clause 3; the centre is that of least squares, as it may be there."""
    every = _about_centre(test.arcs)[0]
    return CircularFigures(
        arcs=tuple(_of_arc(arc) for arc in test.arcs),
        G_b=float(np.ptp(every)) if len(test.senses) > 1 else None,
        D=float(np.mean(every)),
    )


def about_centre(test: CircularTest) -> list[FloatArray]:
    """Radial deviations of every arc, (n,) mm, about the least-squares centre of all."""
    radial, _ = _about_centre(test.arcs)
    return np.split(radial, np.cumsum([arc.angle.size for arc in test.arcs])[:-1])


def _of_arc(arc: Arc) -> OfArc:
    radial, centre = _about_centre([arc])
    return OfArc(
        id=arc.id,
        sense=arc.sense,
        G=float(np.ptp(radial)),
        zone=_zone(arc),
        F_max=float(radial.max()),
        F_min=float(radial.min()),
        centre=centre,
    )


def _about_centre(arcs: Sequence[Arc]) -> tuple[FloatArray, tuple[float, float]]:
    """Radial deviations, (n,) mm, about the least-squares centre of all arcs, and that centre."""
    circle = circularity(np.concatenate([arc.angle for arc in arcs]), np.concatenate([arc.deviation for arc in arcs]))
    return circle.radial, circle.centre


def _zone(arc: Arc) -> float:
    """The least distance of two circles about one centre that hold all readings: a linear programme to first order.

    Unknowns: centre x, y and the deviations of the outer and the inner circle.
    """
    from scipy.optimize import linprog  # noqa: PLC0415  half a second; only who evaluates a circle needs it

    wave = np.column_stack([np.cos(arc.angle), np.sin(arc.angle)])
    one, none = np.ones((arc.angle.size, 1)), np.zeros((arc.angle.size, 1))
    above, below = np.hstack([-wave, -one, none]), np.hstack([wave, none, one])
    scale = float(np.abs(arc.deviation).max()) or 1.0
    limits = np.concatenate([-arc.deviation, arc.deviation]) / scale
    found = linprog([0.0, 0.0, 1.0, -1.0], A_ub=np.vstack([above, below]), b_ub=limits, bounds=(None, None))
    _, _, outer, inner = np.asarray(found.x, dtype=float)
    return float(outer - inner) * scale
