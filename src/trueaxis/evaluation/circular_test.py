"""A circular test: arcs in one plane about one set-up, in one or both senses of rotation, and its figures by ISO 230-4.

These are circular deviation G, both directions G(b), radial deviation F, mean radial deviation D. `circularity` is the
circular deviation of one arc.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.io.faults import Faults
from trueaxis.measurement.instrument_run import InstrumentRun

FloatArray = NDArray[np.float64]
FEWEST_READINGS = 12  # of an arc: fewer do not fix centre, radius and harmonics
LARGEST_DEVIATION = 10.0  # mm: beyond it radius and reading are not in one unit, or not of one circle
SAME_FEED = 0.01  # share by which feeds that are read may differ: servo mismatch is off by no more
SMALLEST_SPAN = np.pi  # rad, of the longest arc: less of a circle does not fix its centre
STANDARD = "ISO 230-4"


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Arc:
    """One run in one sense. id: its name; angle: (n,), rad, from the first axis of the plane to the second, growing
    without steps where sense is +1 (counter-clockwise), falling where it is -1; deviation: (n,), mm, of the radius.
    """

    id: str
    sense: int
    angle: FloatArray
    deviation: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class CircularTest:
    """plane: the axes, such as ("X", "Y"), in the order of the angles; radius: nominal, mm; feed: along the path,
    mm/min, None where it is not known; arcs: of one set-up.
    """

    plane: tuple[str, str]
    radius: float
    feed: float | None
    arcs: tuple[Arc, ...]

    @property
    def senses(self) -> tuple[int, ...]:
        """Which there are: (1,), (-1,) or (-1, 1)."""
        return tuple(sorted({arc.sense for arc in self.arcs}))


def circular_test(
    runs: Sequence[InstrumentRun], plane: tuple[str, str], radius: float, feed: float | None, source: str
) -> CircularTest:
    """The test that runs of a ball bar are. feed: where no run has it.

    Raises InputError with every fault: angles that do not go one way, too few readings, readings of another size,
    arcs at different feeds.
    """
    faults = Faults(source)
    arcs = [_arc(run, radius, faults) for run in runs]
    faults.raise_if_any()
    longest = max((float(np.ptp(arc.angle)) for arc in arcs), default=0.0)
    if longest < SMALLEST_SPAN:
        faults.add("", f"no arc spans more than {np.degrees(longest):.0f} degrees", "at least half a circle")
        faults.raise_if_any()
    feeds = [float(np.median(run.feed)) for run in runs if run.feed is not None]
    if feeds and max(feeds) - min(feeds) > SAME_FEED * max(feeds):
        named = ", ".join(f"{one:g}" for one in feeds)
        faults.add(
            "column feed", f"arcs at different feeds, {named} mm/min", "one feed a test: it scales servo mismatch"
        )
        faults.raise_if_any()
    return CircularTest(plane=plane, radius=radius, feed=feeds[0] if feeds else feed, arcs=tuple(arcs))


def _arc(run: InstrumentRun, radius: float, faults: Faults) -> Arc:
    place = f"run {run.id}"
    deviation = run.reading - radius if run.whole_length else run.reading
    angle = np.zeros(0) if run.angle is None else np.unwrap(run.angle)
    if run.angle is None:
        faults.add(place, "has no angles", "a column angle")
    elif angle.size < FEWEST_READINGS:
        faults.add(place, f"has {angle.size} readings", f"at least {FEWEST_READINGS}")
    elif not (np.diff(angle) > 0.0).all() and not (np.diff(angle) < 0.0).all():
        rows = np.flatnonzero(np.diff(angle) * np.sign(angle[-1] - angle[0]) <= 0.0)
        faults.add(
            place,
            f"its angles do not go one way (first at reading {rows[0] + 2})",
            "one run for each sense of rotation, rows in the order in which they were read",
        )
    if np.abs(deviation).max(initial=0.0) > LARGEST_DEVIATION:
        worst = float(deviation[np.argmax(np.abs(deviation))])
        faults.add(place, f"deviates by {worst:g} mm from a radius of {radius:g} mm", "radius and readings in one unit")
    sense = 1 if angle.size and angle[-1] > angle[0] else -1
    return Arc(id=run.id, sense=sense, angle=angle, deviation=deviation)


@dataclass(frozen=True)
class Circularity:
    """Circular deviation G (mm) about the least-squares centre, that centre (mm), and the deviations from it (n,)."""

    deviation: float
    centre: tuple[float, float]
    radial: FloatArray


def circularity(angles: FloatArray, readings: FloatArray) -> Circularity:
    """Circular deviation of one direction of run: the greatest less the smallest radial deviation.

    angles: (n,) polar angles of the bar, rad; readings: (n,) distance minus nominal length, mm. The centre of the
    circle is that of least squares, since nobody can place a ball without an offset: readings = mean + a cos + b sin.
    Raises ValueError for fewer than four readings or readings at angles that do not fix a centre.
    """
    if angles.size < 4:
        raise ValueError(f"a circle needs four readings or more, there are {angles.size}")
    design = np.column_stack([np.ones_like(angles), np.cos(angles), np.sin(angles)])
    solution, _, rank, _ = np.linalg.lstsq(design, readings, rcond=None)
    if rank < 3:
        raise ValueError("the readings lie at too few different angles to fix a centre")
    radial = readings - design[:, 1:] @ solution[1:]
    return Circularity(float(np.ptp(radial)), (float(solution[1]), float(solution[2])), radial)


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
