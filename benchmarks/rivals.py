"""Other ways to compute the first-order deviation of the dmu60p machine under polynomial curves.

Each rival is made to run as well as it comes: coefficients are plain numbers outside the loop over the points, its C is
compiled with the flags of our own kernels, and its arrays are laid out as it likes them before the clock starts.
"""

import ctypes
import subprocess
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import casadi
import numpy as np
import numpy.typing as npt
import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.curve_routines import coefficient, curve
from trueaxis.derivation.first_order import first_order
from trueaxis.derivation.views import view
from trueaxis.error_name import ErrorName
from trueaxis.machine import Machine
from trueaxis.model.compiler import FLAGS, NATIVE, find_compiler

FloatArray = npt.NDArray[np.float64]
HERE = Path(__file__).resolve().parent
MAPPED = 100  # points per call of CasADi's mapped function; more are slower, because it copies the constants per point
_WORK = ("arg", "res", "iw", "w")  # what a function of CasADi wants room for
BLOCK = 8192  # points per call of lambdify's function, where it is called by blocks


@dataclass(frozen=True)
class Case:
    """Arrays of one run: positions (3, n), curves (18, 7), parameters (9,), point (3,), all contiguous."""

    positions: FloatArray
    curves: FloatArray
    parameters: FloatArray
    point: FloatArray

    @property
    def n(self) -> int:
        return int(self.positions.shape[1])

    @property
    def arrays(self) -> tuple[FloatArray, ...]:
        return self.positions, self.curves, self.parameters, self.point


@dataclass(frozen=True)
class Contestant:
    """`prepare(case)` gives the call to be timed and the function that reads its result as (3, n)."""

    name: str
    prepare: Callable[[Case], tuple[Callable[[], Any], Callable[[], FloatArray]]]


def compiled(source: Path, folder: Path, *extra: str) -> ctypes.CDLL:
    """A library of one C file, compiled as our kernels are."""
    compiler = find_compiler()
    if compiler is None:
        raise SystemExit("the benchmark needs a C compiler")
    library = folder / f"{source.stem}.so"
    subprocess.run([*compiler, *FLAGS, NATIVE, *extra, str(source), "-o", str(library), "-lm"], check=True)
    return ctypes.CDLL(str(library))


def loop(function: Any, arrays: Sequence[FloatArray]) -> Callable[[], Any]:
    """A call of a C function of the kernels' own signature with addresses made ready."""
    signature = ctypes.CFUNCTYPE(None, *(ctypes.c_size_t,) * 2, *(ctypes.c_void_p,) * len(arrays))
    called = signature(ctypes.cast(function, ctypes.c_void_p).value or 0)
    n, addresses = arrays[-1].shape[-1], [array.ctypes.data for array in arrays]

    def call(_keep: Sequence[FloatArray] = arrays) -> None:  # the arrays live as long as the call
        called(n, n, *addresses)

    return call


def strided(name: str, function: Any) -> Contestant:
    """A C function of the kernels' own signature, called with addresses made ready."""

    def prepare(case: Case) -> tuple[Callable[[], Any], Callable[[], FloatArray]]:
        out = np.zeros((3, case.n))
        return loop(function, (*case.arrays, out)), lambda: out

    return Contestant(name, prepare)


def hand_written(folder: Path) -> Contestant:
    return strided("hand-written C loop", compiled(HERE / "hand_written.c", folder).hand_written)


def lambdify(machine: Machine) -> list[Contestant]:
    """sympy.lambdify(cse=True) of the deviation with 18 polynomials, as sums of powers and in Horner's form."""
    columns = first_order(view(machine, "tool_in_workpiece"), symbols.point()).columns
    powers = range(1, machine.curve_degree + 1)
    coefficients = [coefficient(name, power) for name in machine.components for power in powers]
    constants = [*coefficients, *map(symbols.named, machine.parameters), *symbols.point()]

    def sum_of_powers(name: ErrorName) -> sp.Expr:
        return sp.Add(*(coefficient(name, power) * symbols.position(name.axis) ** power for power in powers))

    def function(component: Callable[[ErrorName], sp.Expr]) -> Callable[..., Any]:
        errors: dict[str, sp.Expr] = {name: component(name) for name in machine.components}
        rows = [
            sp.Add(*(column[row] * errors.get(name, symbols.named(name)) for name, column in columns.items()))
            for row in range(3)
        ]
        arguments = [*map(symbols.position, machine.axes), *constants]
        made: Callable[..., Any] = sp.lambdify(arguments, rows, modules="numpy", cse=True)
        return made

    def contestant(name: str, made: Callable[..., Any], block: int | None = None) -> Contestant:
        def prepare(case: Case) -> tuple[Callable[[], Any], Callable[[], FloatArray]]:
            values = [float(v) for array in case.arrays[1:] for v in array.ravel()]
            if block is None:
                return lambda: made(*case.positions, *values), lambda: np.array(made(*case.positions, *values))
            out = np.empty((3, case.n))

            def run() -> None:
                for start in range(0, case.n, block):
                    at = slice(start, start + block)
                    out[0, at], out[1, at], out[2, at] = made(*case.positions[:, at], *values)

            return run, lambda: out

        return Contestant(name, prepare)

    horner = function(lambda name: curve(name, machine.curve_degree))
    return [
        contestant("sympy.lambdify, powers", function(sum_of_powers)),
        contestant("sympy.lambdify, Horner", horner),
        contestant(f"sympy.lambdify, Horner, blocks of {BLOCK}", horner, BLOCK),
    ]


def casadi_functions(folder: Path) -> list[Contestant]:
    """CasADi's generated C: called once per point, and its own map over many points."""
    single = casadi.Function("single", *_casadi_model())
    mapped = single.map("mapped", "serial", MAPPED, [1, 2, 3], [])
    generator = casadi.CodeGenerator("casadi_generated.c")
    generator.add(single)
    generator.add(mapped)
    generator.generate(f"{folder}/")
    driver = HERE / "casadi_loop.c"
    room = {f"ROOM_{part.upper()}": max(getattr(f, f"sz_{part}")() for f in (single, mapped)) + 1 for part in _WORK}
    library = compiled(
        driver, folder, f"-I{folder}", f"-DMAPPED={MAPPED}", *(f"-D{name}={size}" for name, size in room.items())
    )
    return [
        _interleaved("CasADi C, point by point", library.loop_single),
        _interleaved(f"CasADi C, map of {MAPPED}", library.loop_mapped),
    ]


def _casadi_model() -> tuple[Sequence[Any], Sequence[Any]]:
    position, curves = casadi.SX.sym("position", 3), casadi.SX.sym("curves", 7, 18)
    parameters, point = casadi.SX.sym("parameters", 9), casadi.SX.sym("point", 3)
    x, y, z = position[0], position[1], position[2]
    eps_xy, eps_yz, eps_xz = parameters[6], parameters[7], parameters[8]
    error = []
    for component in range(18):
        at, value = position[component // 6], casadi.SX(0)
        for power in reversed(range(7)):
            value = at * (curves[power, component] + value)
        error.append(value)
    exx, eyx, ezx, eax, ebx, ecx, exy, eyy, ezy, eay, eby, ecy, exz, eyz, ezz, eaz, ebz, ecz = error
    tx, ty, tz = (parameters[3 + k] + point[k] for k in range(3))
    up = tz + z
    dx = exx + exz - exy + (ebx + eps_xz - eby) * up - (ecx + eps_xy + ecz) * ty + ecy * (ty - y) + ebz * tz
    dy = eyx + eyz - eyy - (eax + eps_yz - eay) * up + (ecx + ecz) * tx + (eps_xy - ecy) * (tx + x) - eaz * tz
    dz = ezx + ezz - ezy + (eax + eps_yz + eaz) * ty - (ebx + eps_xz + ebz) * tx - eay * (ty - y) + eby * (tx + x)
    return [position, curves, parameters, point], [casadi.vertcat(dx, dy, dz)]


def _interleaved(name: str, function: Any) -> Contestant:
    """CasADi takes the coordinates of a point side by side."""
    function.argtypes, function.restype = (ctypes.c_size_t,) + (ctypes.c_void_p,) * 5, None

    def prepare(case: Case) -> tuple[Callable[[], Any], Callable[[], FloatArray]]:
        positions, out = np.ascontiguousarray(case.positions.T), np.zeros((case.n, 3))
        arrays = (positions, *case.arrays[1:], out)

        def run() -> None:  # holds `arrays`, so that they live as long as the call
            function(case.n, *(array.ctypes.data for array in arrays))

        return run, lambda: np.ascontiguousarray(out.T)

    return Contestant(name, prepare)
