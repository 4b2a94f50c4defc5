"""Compiled kernels against the routines themselves, evaluated in 30 digits, and their calling rules."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import mpmath
import numpy as np
import numpy.typing as npt
import pytest
import sympy as sp

from tests.machines import DMU60P, FIVE_AXIS, machine_at
from trueaxis.codegen.c_source import c_header, c_source
from trueaxis.codegen.meta import ABI
from trueaxis.codegen.numpy_source import numpy_source
from trueaxis.derivation.library import derive_routines
from trueaxis.derivation.routine import Argument, Routine
from trueaxis.machine import Machine
from trueaxis.model.c_kernels import CRoutine, load_c_kernels
from trueaxis.model.compiler import find_compiler

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="there is no C compiler")

FloatArray = npt.NDArray[np.float64]
AGREEMENT = 1e-12
POSES = 7
DEVIATION = "tool_in_workpiece_deviation"


@dataclass(frozen=True)
class Compiled:
    machine: Machine
    routines: tuple[Routine, ...]
    code: dict[str, bytes]
    numpy: ModuleType
    c: dict[str, CRoutine]


@pytest.fixture(scope="module", params=[DMU60P, FIVE_AXIS], ids=["dmu60p", "five_axis"])
def compiled(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Compiled]:
    machine = machine_at(request.param)
    routines = derive_routines(machine)
    folder = tmp_path_factory.mktemp(machine.name)
    code = {
        "kernels.c": c_source(machine, routines).encode(),
        "kernels.h": c_header(machine, routines).encode(),
    }
    module = ModuleType("kernels")
    exec(numpy_source(machine, routines), module.__dict__)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("TRUEAXIS_CACHE", str(folder / "cache"))
        kernels, reason = load_c_kernels(code, machine.name, machine.digest, ABI, module.META["routines"])
        assert reason == ""
        yield Compiled(machine, routines, code, module, kernels)


def drawn(argument: Argument, machine: Machine, n: int) -> FloatArray:
    """Values of a machine's size: positions within the travel, errors of up to 0.1 mm and 100 microradians."""
    rng = np.random.default_rng(list(argument.name.encode()))
    values = rng.uniform(-1, 1, (*argument.shape, n) if argument.per_point else argument.shape)
    if argument.name == "positions":
        lowest, highest = np.array([machine.travel[axis] for axis in machine.axes]).T[..., np.newaxis]
        return np.asarray(lowest + (highest - lowest) * (values + 1) / 2)
    if argument.name == "curves":
        return np.asarray(values * 1e-2 / 500.0 ** np.arange(1, machine.curve_degree + 1))
    if argument.name == "parameters":
        return np.asarray(values * np.where(np.isin(machine.parameters, machine.location_errors), 1e-4, 300.0))
    return values * (1e-4 if argument.name == "errors" else 150.0)


def inputs(compiled: Compiled, routine: Routine, n: int) -> list[FloatArray]:
    return [drawn(argument, compiled.machine, n) for argument in routine.inputs]


def exact(routine: Routine, arrays: list[FloatArray]) -> list[list[mpmath.mpf]]:
    """Every row of the outputs at every point, by the routine's assignments in 30 digits."""
    points: list[dict[sp.Symbol, mpmath.mpf]] = [{} for _ in range(POSES)]
    for argument, array in zip(routine.inputs, arrays, strict=True):
        for point, values in enumerate(points):
            flat = array.reshape(len(argument.rows), -1)[:, point if argument.per_point else 0]
            values |= {sp.Symbol(row, real=True): mpmath.mpf(v) for row, v in zip(argument.rows, flat, strict=True)}
    for target, value in routine.batch + routine.preparation + routine.body:
        known = sorted(value.free_symbols, key=str)
        function = sp.lambdify(known, value, modules="mpmath")
        for values in points:
            values[target] = function(*(values[symbol] for symbol in known))
    rows = [sp.Symbol(row, real=True) for output in routine.outputs for row in output.rows]
    return [[mpmath.mpf(values[row]) for values in points] for row in rows]


def as_rows(result: Any, routine: Routine) -> FloatArray:
    parts = result if isinstance(result, tuple) else (result,)
    return np.concatenate([p.reshape(len(o.rows), -1) for p, o in zip(parts, routine.outputs, strict=True)])


def test_every_routine_agrees_with_its_own_assignments_in_30_digits(compiled: Compiled) -> None:
    with mpmath.workdps(30):
        for routine in compiled.routines:
            arrays = inputs(compiled, routine, POSES)
            wanted = np.array(exact(routine, arrays))
            size = np.abs(wanted).max(axis=1, keepdims=True).astype(float)
            for kernel in (compiled.c[routine.name], getattr(compiled.numpy, routine.name)):
                found = as_rows(kernel(*arrays), routine)
                assert found.shape == wanted.shape
                difference = np.abs(found - wanted).astype(float)
                assert np.all(difference <= AGREEMENT * size), routine.name


def test_c_agrees_with_numpy_across_blocks_and_odd_ends(compiled: Compiled) -> None:
    for routine in compiled.routines:
        for n in (1, 2, 511, 512, 1543, 9001):
            arrays = inputs(compiled, routine, n)
            found, wanted = compiled.c[routine.name](*arrays), getattr(compiled.numpy, routine.name)(*arrays)
            assert as_rows(found, routine).shape == (sum(len(o.rows) for o in routine.outputs), n)
            assert np.shape(found) == np.shape(wanted)
            size = np.abs(as_rows(wanted, routine)).max(axis=1, keepdims=True)
            assert np.all(np.abs(as_rows(found, routine) - as_rows(wanted, routine)) <= AGREEMENT * size), routine.name


def test_threads_give_the_same_bytes(compiled: Compiled) -> None:
    n = 4 * 131072 + 77
    for name in (DEVIATION, "tool_in_workpiece_deviation_first_order_curves", "ballbar_error"):
        routine = next(r for r in compiled.routines if r.name == name)
        arrays = inputs(compiled, routine, n)
        alone = compiled.c[name](*arrays)
        assert isinstance(alone, np.ndarray)
        assert not np.isnan(alone).any()
        for threads in (2, 3, 64):
            many = compiled.c[name](*arrays, threads=threads)
            assert isinstance(many, np.ndarray)
            assert many.tobytes() == alone.tobytes()


def test_no_point_at_all(compiled: Compiled) -> None:
    for routine in compiled.routines:
        found = compiled.c[routine.name](*inputs(compiled, routine, 0), threads=4)
        assert np.shape(found) == (*routine.outputs[0].shape, 0)


def arguments(compiled: Compiled, n: int) -> list[FloatArray]:
    return inputs(compiled, next(r for r in compiled.routines if r.name == DEVIATION), n)


def test_one_point_serves_for_all(compiled: Compiled) -> None:
    positions, errors, parameters, point = arguments(compiled, 600)
    spread = np.repeat(point[:, :1], 600, axis=1)
    kernel = compiled.c[DEVIATION]
    assert np.array_equal(
        kernel(positions, errors, parameters, point[:, :1]), kernel(positions, errors, parameters, spread)
    )
    few = kernel(positions[:, :1], errors[:, :1], parameters, point)
    assert np.shape(few) == (3, 600)


def test_any_memory_layout_and_type_of_number(compiled: Compiled) -> None:
    positions, errors, parameters, point = arguments(compiled, 40)
    kernel = compiled.c[DEVIATION]
    whole = np.round(positions)
    wanted = kernel(whole, errors, parameters, point)
    turned = np.ascontiguousarray(whole.T).T
    every = np.repeat(whole, 2, axis=1)[:, ::2]
    for same in (turned, every, whole.astype(np.float32), whole.astype(int), whole.tolist()):
        assert np.array_equal(kernel(same, errors, parameters, point), wanted)


def test_read_only_and_scattered_inputs_on_threads(compiled: Compiled) -> None:
    n = 2 * 131072 + 5
    positions, errors, parameters, point = arguments(compiled, n)
    kernel = compiled.c[DEVIATION]
    wanted = kernel(positions, errors, parameters, point)
    scattered = np.repeat(positions, 2, axis=1)[:, ::2]
    for array in (errors, parameters):
        array.setflags(write=False)
    for threads in (1, 2):
        assert np.array_equal(kernel(scattered, errors, parameters, point, threads=threads), wanted)


def test_inputs_are_left_as_they_are(compiled: Compiled) -> None:
    arrays = arguments(compiled, 100)
    before = [array.copy() for array in arrays]
    compiled.c[DEVIATION](*arrays)
    assert all(np.array_equal(a, b) for a, b in zip(arrays, before, strict=True))


def test_wrong_calls_say_what_is_wrong(compiled: Compiled) -> None:
    positions, errors, parameters, point = arguments(compiled, 5)
    kernel = compiled.c[DEVIATION]
    with pytest.raises(TypeError, match="takes 4 arrays, not 3"):
        kernel(positions, errors, parameters)
    with pytest.raises(ValueError, match="positions has the shape"):
        kernel(positions[1:], errors, parameters, point)
    with pytest.raises(ValueError, match="parameters has the shape"):
        kernel(positions, errors, parameters[1:], point)
    with pytest.raises(ValueError, match="differ in their number of points: positions has 4, errors has 5"):
        kernel(positions[:, 1:], errors, parameters, point)
    with pytest.raises(ValueError, match="point has the shape"):
        kernel(positions, errors, parameters, point[:, 0])
    with pytest.raises(ValueError, match="threads is 0"):
        kernel(positions, errors, parameters, point, threads=0)


def test_kernels_of_another_spec_or_abi_are_refused(compiled: Compiled) -> None:
    records = compiled.numpy.META["routines"]
    name, digest = compiled.machine.name, compiled.machine.digest
    assert load_c_kernels(compiled.code, name, "0" * 64, ABI, records) == (
        {},
        "kernels.c was made from another spec",
    )
    found, reason = load_c_kernels(compiled.code, name, digest, ABI + 1, records)
    assert (found, reason) == ({}, f"kernels.c has the kernel ABI {ABI}, not {ABI + 1}")
    found, reason = load_c_kernels(compiled.code, name, digest, ABI, records | {"more": records[DEVIATION]})
    assert found == {}
    assert "cannot be used" in reason


def test_library_that_is_none_is_told(compiled: Compiled, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TRUEAXIS_CACHE", str(tmp_path))
    arguments_ = (compiled.code, compiled.machine.name, compiled.machine.digest, ABI)
    compiler = tmp_path / "cc"
    compiler.write_text('#!/bin/sh\nwhile [ "$1" != -o ]; do shift || exit 0; done; echo no library > "$2"\n')
    compiler.chmod(0o755)
    monkeypatch.setenv("CC", str(compiler))
    found, reason = load_c_kernels(*arguments_, compiled.numpy.META["routines"])
    assert found == {}
    assert "cannot be used" in reason
