"""Random machines: order of the axes, senses, travels, offsets, location errors."""

from dataclasses import replace

import numpy as np

from tests.worlds.machine import BED, LETTERS, Array, Body, Machine

Source = np.random.Generator

FIVE_AXES = 0.46  # share of the worlds
FEWER_ERRORS, NAMED, TRUE_ROTATIONS, FIXED_BODY = 0.42, 0.5, 0.35, 0.35
SHORTEST, LONGEST, SHORTEST_WITH_ROTARY = 100.0, 3000.0, 320.0  # mm
ROTARY_TRAVELS = ((-110.0, 30.0), (-95.0, 95.0), (-120.0, 120.0), (-30.0, 120.0))
TURNING_TRAVELS = ((-360.0, 360.0), (-180.0, 180.0), (0.0, 360.0))
ROTARY_LOCATIONS = {"A": ("EY", "EZ", "EB", "EC"), "B": ("EX", "EZ", "EA", "EC"), "C": ("EX", "EY", "EA", "EB")}


def draw_layout(source: Source, name: str, axes: int | None = None) -> Machine:
    """axes: 3, 4 or 5; None: 3 or 5, drawn."""
    count = (5 if source.random() < FIVE_AXES else 3) if axes is None else axes
    order = list(source.permutation(list("XYZ")))
    split = int(source.integers(0, 4))
    sides = {"workpiece": order[:split], "tool": order[split:]}
    kind = "three axes"
    if count == 4:
        kind = str(source.choice(["table", "head"]))
        sides["workpiece" if kind == "table" else "tool"] += [str(source.choice(["A", "B", "C"]))]
    if count == 5:
        kind = str(source.choice(["table-table", "head-table", "head-head"]))
        tilt = str(source.choice(["A", "B"]))
        sides["workpiece"] += {"table-table": [tilt, "C"], "head-table": ["C"], "head-head": []}[kind]
        sides["tool"] += {"table-table": [], "head-table": [tilt], "head-head": ["C", tilt]}[kind]
    travels = _travels(source, count > 3)
    located = _locations(source, sides)
    numbers = iter(np.cumsum(source.integers(1, 3, 12)) + BED)
    bodies: list[Body] = []
    ends = {}
    fewer = source.random() < FEWER_ERRORS
    for side in ("workpiece", "tool"):
        lower = BED
        for axis in sides[side]:
            sense = -1 if source.random() < (0.5 if side == "workpiece" else 0.15) else 1
            motion = tuple(f"E{d}{axis}" for d in LETTERS)
            if fewer and axis in "XYZ":
                kept = source.random(6) < 0.85
                motion = tuple(e for e, keep in zip(motion, kept, strict=True) if keep or e[1] == axis)
            number = int(next(numbers))
            offset, names = _offset(source, f"q_{axis}", 400.0, source.random() < 0.5)
            bodies.append(
                Body(number, lower, f"{axis} axis", axis, sense, travels[axis], offset, names, motion, located[axis])
            )
            lower = number
        if source.random() < FIXED_BODY:
            number = int(next(numbers))
            offset, names = _offset(source, f"q_{side[0]}h", 150.0, False)
            bodies.append(Body(number, lower, f"{side} holder", offset=offset, names=names))
            lower = number
        number = int(next(numbers))
        offset, names = _offset(source, f"q_{side[0]}", 400.0, False)
        bodies.append(Body(number, lower, side, offset=offset, names=names))
        ends[side] = number
    code = f"w{''.join(a + chr(39) for a in reversed(sides['workpiece']))}b{''.join(sides['tool'])}t"
    true_rotations = source.random() < TRUE_ROTATIONS
    machine = Machine(name, tuple(bodies), ends["workpiece"], ends["tool"], f"{kind} {code}", true_rotations)
    return _place_rotary_axes(source, machine)


def _offset(source: Source, stem: str, reach: float, zero: bool) -> tuple[tuple[float, float, float], tuple[str, ...]]:
    values = np.round(source.uniform(-reach, reach, 3), 2) * (0.0 if zero else 1.0)
    x, y, z = (float(value) for value in values + 0.0)
    names = tuple(f"{stem}{letter}" for letter in "xyz") if source.random() < NAMED and not zero else ()
    return (x, y, z), names


def _travels(source: Source, rotary: bool) -> dict[str, tuple[float, float]]:
    spread = source.choice([0.15, 1.0], p=[0.35, 0.65])
    middle = np.exp(source.uniform(np.log(250.0), np.log(1500.0)))
    found = {}
    for axis in "XYZ":
        shortest = SHORTEST_WITH_ROTARY if rotary else SHORTEST
        length = float(np.clip(middle * np.exp(spread * source.normal()), shortest, LONGEST))
        low = {
            "from zero": 0.0,
            "to zero": -length,
            "across zero": -length * source.uniform(0.2, 0.8),
            "beyond zero": source.uniform(10.0, 500.0),
            "below zero": -length - source.uniform(10.0, 500.0),
        }[str(source.choice(["from zero", "to zero", "across zero", "beyond zero", "below zero"]))]
        found[axis] = (round(low, 1), round(low + length, 1))
    for axis in "AB":
        found[axis] = ROTARY_TRAVELS[source.integers(len(ROTARY_TRAVELS))]
    found["C"] = TURNING_TRAVELS[source.integers(len(TURNING_TRAVELS))]
    return found


def _locations(source: Source, sides: dict[str, list[str]]) -> dict[str, tuple[tuple[str, str], ...]]:
    """The usual minimal set: no error of the linear axis next to the bed, one squareness of the second, two of the
    third; two offsets and two tilts of the line of a rotary axis.
    """
    depth = {axis: place for side in sides.values() for place, axis in enumerate(side)}
    first, second, third = sorted("XYZ", key=lambda axis: (depth[axis], axis))
    short = source.random() < 0.5
    turns = {"X": "EA", "Y": "EB", "Z": "EC"}
    directions: dict[str, tuple[str, ...]] = {
        first: (),
        second: (turns[third],),
        third: tuple(sorted({turns[first], turns[second]})),
        **ROTARY_LOCATIONS,
    }
    return {
        axis: tuple((d, f"{d}0{axis}" if short else f"loc_{d.lower()}_{axis.lower()}") for d in found)
        for axis, found in directions.items()
    }


def _place_rotary_axes(source: Source, machine: Machine) -> Machine:
    """Move tables under the tool, and tools near to the heads that swing them, so that linear axes can follow."""
    if not machine.rotary:
        return machine
    shortest = min(np.ptp(machine.travel(axis)) for axis in machine.linear)
    middle: dict[str, Array] = {axis: np.array(machine.travel(axis)).mean() for axis in machine.linear}
    bodies = {body.number: body for body in machine.bodies}

    def moved(number: int, offset: Array) -> None:
        x, y, z = (round(float(value), 2) for value in offset)
        bodies[number] = replace(bodies[number], offset=(x, y, z))

    swing = [body for body in machine.branch("tool") if body.moves in ("A", "B", "C")]
    if swing:
        after = machine.branch("tool")[machine.branch("tool").index(swing[0]) + 1 :]
        for body in after:
            moved(body.number, source.uniform(-0.08, 0.08, 3) * shortest)
    tip = np.zeros(3)
    for body in (bodies[own.number] for own in machine.branch("tool")):
        tip = tip + np.array(body.offset)
        if body.moves in machine.linear:
            tip = tip + body.sense * middle[body.moves] * np.eye(3)["XYZ".index(body.moves)]
    origin = np.zeros(3)
    for body in machine.branch("workpiece"):
        if body.moves in machine.rotary:
            moved(body.number, tip + source.uniform(-0.1, 0.1, 3) * shortest - origin)
        origin = origin + np.array(bodies[body.number].offset)
        if body.moves in machine.linear:
            origin = origin + body.sense * middle[body.moves] * np.eye(3)["XYZ".index(body.moves)]
    return replace(machine, bodies=tuple(bodies[body.number] for body in machine.bodies))
