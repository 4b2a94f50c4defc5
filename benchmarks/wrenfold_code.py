"""What wrenfold (https://wrenfold.org) emits for our routines: C++ in a loop over the points, and NumPy.

It is given what our emitters are given, the assignments of a routine, and shares and factorises as it likes; the first
order under polynomial curves is given unfolded, as the machine's equations have it. Arguments are scalars, so that its
C++ needs no library, and the compiler may take whatever is the same for all points out of the loop.
"""

import ctypes
import subprocess
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import sympy as sp
from wrenfold import sym
from wrenfold.code_generation import CppGenerator, FunctionDescription, PythonGenerator, transpile
from wrenfold.type_info import NumericType, ScalarType

from trueaxis.derivation import symbols
from trueaxis.derivation.curve_routines import curve
from trueaxis.derivation.first_order import first_order
from trueaxis.derivation.routine import Argument, Routine
from trueaxis.derivation.sharing import Assignment
from trueaxis.derivation.views import view
from trueaxis.machine import Machine
from trueaxis.model.compiler import FLAGS, NATIVE

FUNCTIONS: Mapping[type, Callable[..., Any]] = {
    sp.Add: sym.addition, sp.Mul: sym.multiplication, sp.Pow: sym.pow, sp.cos: sym.cos, sp.sin: sym.sin
}  # fmt: skip


def unfolded(machine: Machine, routine: Routine) -> Routine:
    """The deviation of first order under polynomial curves, as it is written down: columns times curves."""
    columns = first_order(view(machine, "tool_in_workpiece"), symbols.point()).columns
    errors = {str(name): curve(name, machine.curve_degree) for name in machine.components}
    (output,) = routine.outputs
    body: list[Assignment] = [
        (
            sp.Symbol(row, real=True),
            sp.Add(*(column[k] * errors.get(str(name), symbols.named(name)) for name, column in columns.items())),
        )
        for k, row in enumerate(output.rows)
    ]
    return replace(routine, batch=(), body=tuple(body))


def described(routine: Routine) -> FunctionDescription:
    """The routine for one point: a scalar for every row of every argument."""
    found = FunctionDescription(routine.name)
    number = ScalarType(NumericType.Float)
    values = {row: found.add_input_argument(row, number) for one in routine.inputs for row in one.rows}
    for target, value in (*routine.batch, *routine.preparation, *routine.body):
        values[target.name] = _converted(value, values)
    for one in routine.outputs:
        for row in one.rows:
            found.add_output_argument(f"out_{row}", False, values[row])
    return found


def _converted(value: sp.Expr, values: Mapping[str, Any]) -> Any:
    match value:
        case sp.Symbol():
            return values[value.name]
        case sp.Rational():
            return sym.rational(int(value.p), int(value.q))
        case sp.Float():
            return float(value)
    parts = [_converted(part, values) for part in value.args]
    function = FUNCTIONS[type(value)]
    return function(parts) if type(value) in (sp.Add, sp.Mul) else function(*parts)


def cpp_of(routine: Routine, folder: Path) -> Any:
    """A C function of the kernels' own signature: n, stride, the inputs' and the outputs' addresses."""
    arguments, passed = [], []
    for place, one in enumerate((*routine.inputs, *routine.outputs)):
        kind = "const double" if place < len(routine.inputs) else "double"
        arguments.append(f"{kind} *__restrict a{place}")
        each = "[{row} * stride + i]" if one.per_point else "[{row}]"
        passed += [f"a{place}{each.format(row=row)}" for row in range(len(one.rows))]
    source = folder / f"wrenfold_{routine.name}.cpp"
    source.write_text(
        "#include <cmath>\n#include <cstddef>\n"
        + CppGenerator().generate(transpile(described(routine)))
        + f'\nextern "C" void loop(std::size_t n, std::size_t stride, {", ".join(arguments)})\n{{\n'
        + f"  for (std::size_t i = 0; i < n; ++i)\n    {routine.name}<double>({', '.join(passed)});\n}}\n"
    )
    library = source.with_suffix(".so")
    flags = ["-std=c++17" if flag.startswith("-std") else flag for flag in FLAGS]
    subprocess.run(["g++", *flags, NATIVE, str(source), "-o", str(library)], check=True)
    return ctypes.CDLL(str(library)).loop


def numpy_of(routine: Routine) -> Callable[..., npt.NDArray[np.float64]]:
    """A function of the routine's input arrays: (*shape, n) of its output, with a value for every point."""
    space: dict[str, Any] = {"np": np}
    exec(PythonGenerator().generate(transpile(described(routine))), space)
    function: Callable[..., Any] = space[routine.name]
    (output,) = routine.outputs

    def call(*arrays: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        given = [row for array, one in zip(arrays, routine.inputs, strict=True) for row in _rows(array, one)]
        found = np.empty((len(output.rows), max(np.size(row) for row in given)))
        for place, value in enumerate(function(*given)):
            found[place] = value
        return found.reshape(*output.shape, -1)

    return call


def _rows(array: npt.NDArray[np.float64], argument: Argument) -> Iterable[Any]:
    return array.reshape(len(argument.rows), -1) if argument.per_point else array.ravel()
