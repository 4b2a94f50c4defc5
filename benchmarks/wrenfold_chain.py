"""The chain of a machine in wrenfold's own expressions, without SymPy: what a start with wrenfold alone takes."""

import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from wrenfold import sym
from wrenfold.code_generation import CppGenerator, FunctionDescription, transpile
from wrenfold.type_info import NumericType, ScalarType

from trueaxis.error_name import DIRECTIONS
from trueaxis.machine import Machine, read_machine
from trueaxis.machine.machine import LINEAR, Body
from trueaxis.machine.topology import branches
from trueaxis.model.compiler import FLAGS, NATIVE

Vector = list[Any]


def compile_deviation(spec: str, folder: str) -> None:
    """The deviation of the tool to first order and its derivative by every error: C++, compiled into the folder."""
    machine, number = read_machine(Path(spec)), ScalarType(NumericType.Float)
    kernel = FunctionDescription("deviation")
    names = [*map(str.lower, machine.axes), *machine.components, *machine.parameters, "px", "py", "pz"]
    values = {str(name): kernel.add_input_argument(str(name), number) for name in names}
    columns = sensitivities(machine, values)
    for row in range(3):
        whole = sym.addition([column[row] * values[name] for name, column in columns.items()])
        kernel.add_output_argument(f"deviation_{row}", False, whole)
        for name, column in columns.items():
            kernel.add_output_argument(f"by_{name}_{row}", False, column[row])
    arguments = ["const double"] * len(names) + ["double&"] * 3 * (1 + len(columns))
    source = Path(folder) / "wrenfold.cpp"
    source.write_text(
        f"#include <cmath>\n{CppGenerator().generate(transpile(kernel))}\n"
        f"template void deviation<double>({', '.join(arguments)});\n"
    )
    flags = ["-std=c++17" if flag.startswith("-std") else flag for flag in FLAGS]
    subprocess.run(["g++", *flags, NATIVE, str(source), "-o", str(source.with_suffix(".so"))], check=True)


def sensitivities(machine: Machine, values: dict[str, Any]) -> dict[str, Vector]:
    """By error, what a unit of it does to the tool point, seen from the workpiece, mm."""
    workpiece, tool = branches(machine)
    at, columns = [values["px"], values["py"], values["pz"]], dict[str, Vector]()
    for body in reversed(tool):
        at = _through(body, 1, at, columns, values)
    for body in workpiece:
        at = _through(body, -1, at, columns, values)
    return columns


def _through(body: Body, sign: int, at: Vector, columns: dict[str, Vector], values: dict[str, Any]) -> Vector:
    """The point behind the joint of a body; sign: -1 where it is met from below, inverted."""
    place = [values[part] if isinstance(part, str) else part for part in body.position]
    location = dict(body.position_errors)
    motion = {name.direction: name for name in body.motion_errors}
    steps: list[Callable[[Vector], Vector]] = []
    steps += [lambda at: _erring(at, motion, sign, columns), lambda at: _moved(body, sign, at, columns, values)]
    steps += [lambda at: _erring(at, location, sign, columns), lambda at: _added(at, place, sign)]
    for step in steps[::sign]:
        at = step(at)
    return at


def _erring(at: Vector, names: dict[Any, Any], sign: int, columns: dict[str, Vector]) -> Vector:
    x, y, z = at
    effects = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -z, y], [z, 0, -x], [-y, x, 0]]
    for direction, effect in zip(DIRECTIONS, effects, strict=True):
        if direction in names:
            name = str(names[direction])
            columns[name] = _added(columns.get(name, [0, 0, 0]), effect, sign)
    return at


def _moved(body: Body, sign: int, at: Vector, columns: dict[str, Vector], values: dict[str, Any]) -> Vector:
    if body.moves is None:
        return at
    position = values[body.moves.lower()]
    if body.moves in LINEAR:
        return _added(at, [position if axis == body.moves else 0 for axis in LINEAR], sign * body.sense)
    angle = position * (sym.pi / 180)
    cosine, sine = sym.cos(angle), sign * body.sense * sym.sin(angle)
    for name, column in columns.items():
        columns[name] = _turned(body.moves, cosine, sine, column)
    return _turned(body.moves, cosine, sine, at)


def _turned(axis: str, cosine: Any, sine: Any, vector: Sequence[Any]) -> Vector:
    first, second = {"A": (1, 2), "B": (2, 0), "C": (0, 1)}[axis]
    turned = list(vector)
    turned[first] = cosine * vector[first] - sine * vector[second]
    turned[second] = sine * vector[first] + cosine * vector[second]
    return turned


def _added(left: Sequence[Any], right: Sequence[Any], sign: int) -> Vector:
    return [a + sign * b for a, b in zip(left, right, strict=True)]
