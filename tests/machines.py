"""Machines to test with: the paper's, a five-axis one, and texts of any topology."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import permutations
from pathlib import Path
from typing import Any

from trueaxis.io.faults import Faults
from trueaxis.machine import Machine
from trueaxis.machine.read import parse_machine

ROOT = Path(__file__).resolve().parent.parent
DMU60P = ROOT / "machines" / "dmu60p.toml"
FIVE_AXIS = ROOT / "tests" / "data" / "machines" / "five_axis.toml"

HEAD = 'schema = 1\nname = "test"\ntitle = "Test machine"\n'


def machine_of(text: str) -> Machine:
    return parse_machine(text, Faults("test.toml"))


def machine_at(path: Path) -> Machine:
    return machine_of(path.read_text())


def spec_text(bodies: Sequence[Mapping[str, Any]], workpiece: int, tool: int) -> str:
    parts = [HEAD]
    for body in bodies:
        parts.append("\n[[body]]\n" + "".join(f"{key} = {toml(value)}\n" for key, value in body.items()))
    return "".join(parts) + f"\n[ends]\nworkpiece = {workpiece}\ntool = {tool}\n"


def toml(value: Any) -> str:
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key} = {toml(part)}" for key, part in value.items()) + " }"
    if isinstance(value, list | tuple):
        return f"[{', '.join(toml(part) for part in value)}]"
    return f'"{value}"' if isinstance(value, str) else repr(value)


def serial_text(workpiece_side: str, tool_side: str, **extra: Mapping[str, Any]) -> str:
    """A machine whose axes stand on one another from the bed outwards; `extra`: keys of an axis's body, by letter."""
    bodies: list[dict[str, Any]] = []

    def stand(axes: str, end: str) -> int:
        lower = 1
        for axis in axes:
            number = len(bodies) + 2
            travel = [-300.0, 400.0] if axis in "XYZ" else [-170.0, 180.0]
            body = {"number": number, "name": axis, "lower": lower, "moves": axis, "travel": travel}
            bodies.append(body | dict(extra.get(axis, {})))
            lower = number
        number = len(bodies) + 2
        position = [f"q_{end}{letter}" for letter in "xyz"]
        bodies.append({"number": number, "name": end, "lower": lower, "position": position})
        return number

    return spec_text(bodies, stand(workpiece_side, "W"), stand(tool_side, "T"))


def three_axis_texts() -> Iterator[tuple[str, str]]:
    """Every order of three linear axes with every place of the bed, each with location errors: (label, text)."""
    errors = {axis: {"position_errors": {d: f"s_{axis}{d}" for d in ("EA", "EB", "EC")}} for axis in "XYZ"}
    for order in permutations("XYZ"):
        for bed in range(4):
            workpiece, tool = "".join(order[:bed]), "".join(order[bed:])
            yield f"w{workpiece[::-1]}b{tool}t", serial_text(workpiece, tool, **errors)
