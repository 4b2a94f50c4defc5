"""Lines: one axis, or several along a diagonal, from target to target; sensed along the motion or across it."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from tests.worlds.kinematics import coordinates
from tests.worlds.machine import Array, Machine
from tests.worlds.plan import End, Habits, Measurement, Run, Track

Source = np.random.Generator

RAPID = 100.0  # mm/s between targets
TOOL_TO_OPTICS = 100.0  # mm from the target back to the reference


def draw_line(source: Source, machine: Machine, habits: Habits, name: str, axis: str, across: str = "") -> Measurement:
    """A line of one axis, the others at random offsets; across: the axis letter along which a straightness senses."""
    still = _offsets(source, machine)
    used = ["straightness" if across else "positioning"]
    return _measure(source, machine, habits, name, {axis: _targets(source, machine, habits, axis)}, still, across, used)


def draw_diagonal(source: Source, machine: Machine, habits: Habits, name: str, axes: Sequence[str]) -> Measurement:
    """Two or three linear axes together, each up or down its travel."""
    shares = np.linspace(0.02, 0.98, habits.targets)
    moved = {}
    for axis in axes:
        low, high = machine.travel(axis)
        reach = source.uniform(0.6, 1.0)
        start = low + (1 - reach) * source.random() * (high - low)
        way = shares if axis == axes[0] or source.random() < 0.5 else 1 - shares
        moved[axis] = np.round(start + way * reach * (high - low), 3)
    used = [f"diagonal_{len(axes)}"]
    return _measure(source, machine, habits, name, moved, _offsets(source, machine), "", used)


def _offsets(source: Source, machine: Machine) -> dict[str, float]:
    """Where axes stand that do not move; rotary ones mostly at home."""
    found = {}
    for axis in machine.axes:
        low, high = machine.travel(axis)
        anywhere = axis in machine.linear or source.random() < 0.25
        found[axis] = float(np.round(low + source.uniform(0.05, 0.95) * (high - low), 1))
        found[axis] = found[axis] if anywhere else machine.home(axis)
    return found


def _targets(source: Source, machine: Machine, habits: Habits, axis: str) -> Array:
    low, high = machine.travel(axis)
    reach = float(source.choice([1.0, source.uniform(0.6, 1.0)]))
    low, high = low + 0.01 * (high - low), high - 0.01 * (high - low)
    start = low + (1 - reach) * source.random() * (high - low)
    targets: Array = np.linspace(start, start + reach * (high - low), habits.targets)
    if habits.spacing == "jittered" and habits.targets > 2:
        targets[1:-1] += source.uniform(-0.4, 0.4, habits.targets - 2) * (targets[1] - targets[0])
    return np.asarray(np.round(targets, 3), float)


def _measure(
    source: Source,
    machine: Machine,
    habits: Habits,
    name: str,
    moved: Mapping[str, Array],
    still: Mapping[str, float],
    across: str,
    used: list[str],
) -> Measurement:
    order = str(source.choice(habits.orders))
    as_runs = habits.as_runs and order == "passes" and habits.repeats > 1
    numbers, ways = visits(habits.targets, order, 1 if as_runs else habits.repeats, habits.both, source)
    home, where = _home(source, machine, habits, moved, still)
    run = _run(source, machine, habits, name, moved, home, across)
    count = habits.repeats if as_runs else 1
    pairs = []
    for repeat in range(count):
        track = _track(source, machine, habits, moved, still, numbers, ways, home)
        pairs.append((replace(run, id=f"{name}-{repeat + 1}" if as_runs else name), track))
    used += [f"order_{order}", f"home_{where}"] if habits.repeats > 1 else [f"home_{where}"]
    return Measurement(tuple(pairs), (*used, *(["repeats_as_runs"] if as_runs else [])))


def visits(count: int, order: str, repeats: int, both: bool, source: Source) -> tuple[Array, Array]:
    """Which targets are visited in which order, and from which direction (+1: from lower numbers), (n,) each.

    passes: whole passes; cycles: of a few neighbouring targets; poses: every target as often as is wanted.
    """
    size = {"passes": count, "cycles": int(source.integers(2, 6)), "poses": 1}[order]
    numbers: list[int] = []
    ways: list[int] = []
    for first in range(0, count, size):
        group = list(range(first, min(first + size, count)))
        for _ in range(repeats):
            numbers += group
            ways += [1] * len(group)
            if both:
                numbers += group[::-1]
                ways += [-1] * len(group)
    return np.array(numbers), np.array(ways, float)


def _track(
    source: Source,
    machine: Machine,
    habits: Habits,
    moved: Mapping[str, Array],
    still: Mapping[str, float],
    numbers: Array,
    ways: Array,
    home: Mapping[str, float],
) -> Track:
    count = len(numbers)
    never, zero = np.full(count, np.inf), np.zeros(count)
    positions = {axis: np.full(count, still[axis]) for axis in machine.axes}
    directions, since = dict.fromkeys(machine.axes, zero), dict.fromkeys(machine.axes, never)
    longest = np.zeros(count)
    for axis, targets in moved.items():
        positions[axis] = there = targets[numbers.astype(int)]
        longest = np.maximum(longest, np.abs(np.diff(there, prepend=there[0])))
        if habits.overtravel:
            directions[axis] = ways * np.sign(targets[-1] - targets[0])
        else:
            directions[axis] = steps_taken(there, home[axis])
        since[axis] = way_since_turn(there, directions[axis], habits.overtravel)
    dwell = source.uniform(2.0, 6.0)
    time = np.cumsum(dwell + longest / RAPID)
    velocity = dict.fromkeys(machine.axes, zero)
    extent = {axis: float(np.ptp(targets)) for axis, targets in moved.items()}
    whole = float(np.linalg.norm(list(extent.values())))
    path = since | {axis: since[axis] * whole / max(own, 1e-9) for axis, own in extent.items()}
    turned = dict.fromkeys(machine.axes, never)
    return Track(positions, directions, since, path, turned, velocity, time, np.full(count, np.nan))


def steps_taken(path: Array, start: float) -> Array:
    """Sign of the last step that was one, (n,); 0 before the first."""
    found, last, before = np.zeros(len(path)), 0.0, start
    for k, here in enumerate(path):
        last = np.sign(here - before) if here != before else last
        found[k], before = last, here
    return found


def way_since_turn(path: Array, directions: Array, overtravel: float) -> Array:
    """Way since the axis turned back last, (n,); it turns an overtravel beyond where it last stood, and comes to its
    first target from such a turn.
    """
    found = np.full(len(path), np.inf)
    turn = path[0] - directions[0] * overtravel
    for k, here in enumerate(path):
        if k and directions[k] != directions[k - 1]:
            ends = (path[k - 1], here)
            turn = min(ends) - overtravel if directions[k] > 0 else max(ends) + overtravel
        elif k and (here - path[k - 1]) * directions[k] < 0:  # it went back in between, to come from the same side
            turn = here - directions[k] * overtravel
        found[k] = abs(here - turn) if directions[k] else np.inf
    return found


def path_since_turn(since: Array, positions: Mapping[str, Array], own: Array) -> Array:
    """Way of the linear axes together since one of them turned, (n,), mm, by the way of its own since then."""
    linear = [np.diff(values, prepend=values[0]) for axis, values in positions.items() if axis in "XYZ"]
    steps, mine = np.linalg.norm(linear, axis=0), np.abs(np.diff(own, prepend=own[0]))
    found = since.copy()
    for k in range(1, len(since)):
        if np.isclose(since[k], since[k - 1] + mine[k]):
            found[k] = found[k - 1] + steps[k]
        elif since[k] >= mine[k]:  # it turned where it stood before, or an overtravel beyond
            found[k] += steps[k] - mine[k]
    return found


def _home(
    source: Source, machine: Machine, habits: Habits, moved: Mapping[str, Array], still: Mapping[str, float]
) -> tuple[dict[str, float], str]:
    where = str(source.choice(habits.homes))
    home = dict(still)
    for axis, targets in moved.items():
        low, high = machine.travel(axis)
        anywhere = float(np.round(low + source.random() * (high - low), 2))
        anywhere = min(max(anywhere, low), high)
        home[axis] = {"first": float(targets[0]), "zero": machine.home(axis), "anywhere": anywhere}[where]
    return home, where


def _run(
    source: Source,
    machine: Machine,
    habits: Habits,
    name: str,
    moved: Mapping[str, Array],
    home: Mapping[str, float],
    across: str,
) -> Run:
    """Which points are watched from where: what moves must be sensed."""
    choices = [("tool", "workpiece", "bed"), ("workpiece", "tool", "bed"), ("tool", "workpiece", "workpiece")]
    if all(machine.carries("tool", axis) for axis in moved):
        choices += [("tool", "bed", "bed"), ("tool", "bed", "workpiece")]
    if all(machine.carries("workpiece", axis) for axis in moved):
        choices += [("workpiece", "bed", "bed")] * 2
    on, seen_from, frame = choices[source.integers(len(choices))]
    start = {axis: np.array([value]) for axis, value in home.items()}
    bracket = np.round(source.uniform(-1, 1, 3) * habits.bracket, 1)
    tool: End = ("tool", three(bracket))
    met = coordinates(machine, "tool", "workpiece", start, bracket, {}, {})[0]
    back = np.round(met + source.uniform(-0.5, 0.5, 3) * TOOL_TO_OPTICS, 2)
    fixed = np.round(coordinates(machine, "tool", "bed", start, bracket, {}, {})[0], 1)
    ends: dict[str, End] = {"tool": tool, "workpiece": ("workpiece", three(back)), "bed": ("bed", three(fixed))}
    run = Run(name, "laser", ends[on], ends[seen_from], frame, name, dict(home), None, None, bool(across))
    ahead = {axis: np.array([values[-1] - values[0]]) + start[axis] for axis, values in moved.items()}
    way = ideal_displacement(machine, run, start | ahead)[0]
    along = way / np.linalg.norm(way)
    if across:
        along = np.eye(3)["XYZ".index(across)] - along["XYZ".index(across)] * along
        along = along / np.linalg.norm(along)
    return replace(run, direction=three(np.round(along, 12) + 0.0))


def ideal_displacement(machine: Machine, run: Run, positions: Mapping[str, Array]) -> Array:
    """Of the target less the reference, since home, on the ideal machine, (n, 3), mm, in the frame of the run."""
    home = {axis: np.array([value]) for axis, value in (run.home or {}).items()}
    found = np.zeros((1, 3))
    for (on, point), sign in ((run.target, 1.0), (run.reference, -1.0)):
        for at, side in ((positions, 1.0), (home, -1.0)):
            found = found + sign * side * coordinates(machine, on, run.frame, at, np.array(point), {}, {})
    return found


def three(values: Array) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return (x, y, z)
