"""Circles by ball bar, and the turns of a table with the bar standing on it."""

from collections.abc import Iterator

import numpy as np

from tests.hidden_effects.design import Design
from tests.hidden_effects.machine import Array, Machine
from tests.hidden_effects.rows import Rows, unit
from tests.hidden_effects.state import RunPlan

PLANES = ("XY", "YZ", "ZX")
BALL_RADIUS, BALL_HEIGHT = 100.0, 100.0  # mm, of the ball on a turning table
BARS = {"radial": (1.0, 0.0, 0.0), "tangential": (0.0, 1.0, 0.0), "axial": (0.0, 0.0, 1.0)}


def circle_runs(machine: Machine, design: Design) -> Iterator[tuple[RunPlan, Rows]]:
    """Per plane: both directions at every feed. On a machine with a C table also its turns."""
    for plane in PLANES:
        for feed in design.feeds:
            for way in (1, -1):
                yield _circle(machine, design, plane, feed, way)
    if "C" in machine.axes:
        for bar in BARS:
            for feed in design.feeds:
                for way in (1, -1):
                    yield _turn(machine, design, bar, feed, way)


def _circle(machine: Machine, design: Design, plane: str, feed: float, way: int) -> tuple[RunPlan, Rows]:
    """A circle seen from the workpiece, counter-clockwise for way = 1, about the middle of the travels.

    A bar longer than the radius stands on a cone: the ball on the workpiece lies below the plane of the circle.
    """
    step = 2 * np.pi / design.samples
    angle = np.asarray(np.pi / 4 + way * step * (np.arange(design.samples) + 0.5), float)
    if design.leave_out:
        angle = angle[np.abs(np.mod(angle + np.pi / 4, np.pi / 2) - np.pi / 4) > step]
    middle = {axis: 0.5 * sum(machine.travel[axis]) if axis in "XYZ" else 0.0 for axis in machine.axes}
    count, speed = len(angle), feed / 60.0
    still, never = np.zeros(count), np.full(count, np.inf)
    positions = {axis: np.full(count, middle[axis]) for axis in machine.axes}
    directions, since = dict.fromkeys(machine.axes, still), dict.fromkeys(machine.axes, never)
    velocity = dict.fromkeys(machine.axes, still)
    for axis, turned in zip(plane, (angle, angle - np.pi / 2), strict=True):
        side = -1.0 if machine.carries_workpiece(axis) else 1.0
        positions[axis] = np.round(middle[axis] + side * design.radius * np.cos(turned), 6)
        velocity[axis] = -way * side * speed * np.sin(turned)
        directions[axis] = np.sign(velocity[axis])
        since[axis] = since_extreme(way * turned, design.radius)
    centre = {axis: np.array([value]) for axis, value in middle.items()}
    seen = machine.coordinates(("tool", "workpiece"), centre, np.zeros(3))[:, 0]
    normal = next(letter for letter in "XYZ" if letter not in plane)
    seen = seen - unit(normal) * np.sqrt(design.bar**2 - design.radius**2)
    run = RunPlan(
        id=f"{plane}-F{feed:.0f}-{'ccw' if way > 0 else 'cw'}",
        instrument="ballbar",
        target=("tool", np.zeros(3)),
        reference=("workpiece", np.round(seen, 6)),
        line=plane,
        length=design.bar,
        plane=plane,
    )
    time = way * (angle - np.pi / 4) * design.radius / speed
    lasts = float(time[-1])
    return run, Rows(positions, directions, velocity, since, time, np.full(count, feed), lasts)


def since_extreme(phase: Array, radius: float) -> Array:
    """Way along the axis since its last reversal, where it stands at radius cos(phase) and phase grows."""
    within = np.mod(phase, np.pi)
    return np.asarray(radius * (1.0 - np.cos(within)), float)


def _turn(machine: Machine, design: Design, bar: str, feed: float, way: int) -> tuple[RunPlan, Rows]:
    """C turns once, X and Y follow so that the bar stands still on the table: radial, tangential or axial.

    feed: mm/min of the ball on the table.
    """
    ball = np.array([BALL_RADIUS, 0.0, BALL_HEIGHT])
    place = machine.dimensions
    on_table = np.array([place[f"q_w{c}"] for c in "xyz"])
    tip = ball + on_table + design.bar * np.array(BARS[bar])
    radius, ahead = np.hypot(tip[0], tip[1]), np.arctan2(tip[1], tip[0])
    step = 2 * np.pi / design.samples
    turned = np.asarray(step * (np.arange(design.samples) + 0.5), float)
    angle = turned if way > 0 else 2 * np.pi - turned
    x, y = (radius * wave(angle + ahead) + place[f"q_C{c}"] for wave, c in ((np.cos, "x"), (np.sin, "y")))
    count, speed = len(angle), feed / 60.0 / BALL_RADIUS  # rad/s
    still, tip_radius = np.zeros(count), float(radius)
    height = tip[2] + place["q_Cz"] - place["q_Tz"]
    positions = {
        "X": np.round(x - place["q_Tx"], 6),
        "Y": np.round(place["q_Ty"] - y, 6),
        "Z": np.full(count, height),
        "C": np.round(np.degrees(angle), 6),
    }
    velocity = {
        "X": -way * speed * radius * np.sin(angle + ahead),
        "Y": -way * speed * radius * np.cos(angle + ahead),
        "Z": still,
        "C": np.full(count, way * np.degrees(speed)),
    }
    since = {
        "X": since_extreme(way * (angle + ahead), tip_radius),
        "Y": since_extreme(way * (angle + ahead - np.pi / 2), tip_radius),
        "Z": np.full(count, np.inf),
        "C": np.degrees(turned),
    }
    directions = {axis: np.sign(values) for axis, values in velocity.items()}
    run = RunPlan(
        id=f"C-{bar}-F{feed:.0f}-{'ccw' if way > 0 else 'cw'}",
        instrument="ballbar",
        target=("tool", np.zeros(3)),
        reference=("workpiece", ball),
        line="C",
        length=design.bar,
    )
    time = turned / speed
    return run, Rows(positions, directions, velocity, since, time, np.full(count, feed), float(time[-1]))
