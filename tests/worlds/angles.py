"""Angle runs beside what a design measures: autocollimators, angular optics and indexers on the same machine.

They are drawn from seeds of their own, so that designs stay what they are without them, and written behind the files of
a world. Rotations are those of exact frames, as rotation vectors; nothing of the package is used.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from tests.worlds.design import Design
from tests.worlds.kinematics import Values, coordinates
from tests.worlds.machine import LETTERS, Array, Machine
from tests.worlds.truth import Truth, stacked

URAD = 1e-6
WHITE, ZERO, DRIFT = (0.1, 1.0), (0.5, 5.0), (0.2, 2.0)  # urad: out of which the shop's sizes are drawn
STEP = 0.1  # urad, of the display
TARGETS = 11
TURN = 180.0  # deg, to either side, of a rotary axis at most


@dataclass(frozen=True, eq=False)
class AngleRun:
    """A run about an axis of the bed; carrier: the end that turns against the bed; positions: axis -> (n,), mm or deg;
    reading: (n,), rad.
    """

    id: str
    carrier: str
    direction: tuple[float, float, float]
    positions: dict[str, Array]
    reading: Array


def draw_angles(design: Design, truth: Truth, seed: int) -> tuple[AngleRun, ...]:
    """Pitch and yaw of every linear axis, every rotary axis about its own axis, there and back."""
    source = np.random.default_rng([seed, 31])
    white, zero, drift = (URAD * float(source.uniform(*ends)) for ends in (WHITE, ZERO, DRIFT))
    found = []
    for name, carrier, direction, positions in _lines(design.machine):
        exact = rotation(design.machine, truth, carrier, direction, positions)
        passed = np.linspace(0.0, 1.0, exact.size)
        shown = (
            exact
            + white * source.standard_normal(exact.size)
            + zero * source.normal()
            + drift * source.normal() * passed
        )
        shown = np.round(shown / (STEP * URAD)) * STEP * URAD
        found.append(AngleRun(name, carrier, direction, positions, np.round(shown, 12)))
    return tuple(found)


def rotation(
    machine: Machine, truth: Truth, carrier: str, direction: tuple[float, float, float], positions: dict[str, Array]
) -> Array:
    """(n,), rad: rotation of an end against the bed since the first position, actual less ideal."""
    values = {name: array[0] for name, array in stacked([truth], positions).items()}
    located = {name: np.asarray(value) for name, value in truth.located.items()}
    actual = _frame(machine, carrier, positions, values, located)
    ideal = _frame(machine, carrier, positions, {}, {})
    turned = Rotation.from_matrix(actual @ np.swapaxes(ideal, 1, 2)).as_rotvec() @ np.array(direction)
    return np.asarray(turned - turned[0], float)


def _frame(machine: Machine, end: str, positions: Values, values: Values, located: Values) -> Array:
    """(n, 3, 3): axes of an end's frame seen from the bed, as columns."""
    origin = coordinates(machine, end, "bed", positions, np.zeros(3), values, located)
    tips = [coordinates(machine, end, "bed", positions, unit, values, located) for unit in np.eye(3)]
    return np.stack([tip - origin for tip in tips], axis=-1)


def _lines(machine: Machine) -> Iterator[tuple[str, str, tuple[float, float, float], dict[str, Array]]]:
    for axis in machine.axes:
        linear = axis in machine.linear
        carrier = "tool" if machine.carries("tool", axis) else "workpiece"
        low, high = machine.travel(axis)
        low, high = (low, high) if linear else (max(low, -TURN), min(high, TURN))
        way = np.round(np.linspace(low, high, TARGETS), 3)
        at = np.concatenate([way, way[-2::-1]])
        rest = {
            other: 0.5 * sum(machine.travel(other)) if other in machine.linear else machine.home(other)
            for other in machine.axes
        }
        positions = {
            other: at if other == axis else np.full(at.size, np.round(rest[other], 3)) for other in machine.axes
        }
        own = LETTERS.index(axis) % 3
        for k in range(3):
            if (k != own) == linear:
                x, y, z = (float(part) for part in np.eye(3)[k])
                yield f"{axis}{'abc'[k]}", carrier, (x, y, z), positions


def write_angles(folder: Path, design: Design, runs: tuple[AngleRun, ...]) -> None:
    """Behind data/setup.toml and data/readings.csv of a world that is written there."""
    table = (folder / "data" / "readings.csv").read_text()
    columns = table.splitlines()[0].split(",")
    tables, rows = [], []
    for run in runs:
        home = ", ".join(f"{axis} = {float(values[0])!r}" for axis, values in run.positions.items())
        tables.append(
            f'\n[[run]]\nid = "{run.id}"\ninstrument = "angle"\ndirection = {list(run.direction)}\nframe = "bed"\n'
            f'target = {{ on = "{run.carrier}" }}\nhome = {{ {home} }}\n'
        )
        for seq, reading in enumerate(run.reading.tolist()):
            cells = {"run": run.id, "seq": str(seq), "reading": repr(reading), "time_s": str(5 * seq)}
            cells |= {axis: repr(float(values[seq])) for axis, values in run.positions.items()}
            rows.append(",".join(cells.get(name, "") for name in columns) + "\n")
    setup = folder / "data" / "setup.toml"
    text = setup.read_text()
    first_device = text.find("\n[device.")
    parts = (text, "") if first_device < 0 else (text[:first_device], text[first_device:])
    setup.write_text(parts[0] + "".join(tables) + parts[1])
    (folder / "data" / "readings.csv").write_text(table + "".join(rows))
