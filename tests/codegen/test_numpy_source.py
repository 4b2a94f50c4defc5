"""kernels.py: constants to the last digit, self-sufficient code, and texts that tell a reader what he calls."""

import ast
import re
from functools import cache
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import sympy as sp

from tests.derivation.test_routine import models
from tests.machines import DMU60P, HEAD, machine_at, machine_of, serial_text
from trueaxis.codegen.meta import ABI
from trueaxis.codegen.numpy_source import numpy_source
from trueaxis.derivation.model import derive_model
from trueaxis.derivation.routine import Argument, build
from trueaxis.io.faults import InputError

X, Y = sp.Symbol("rx", real=True), sp.Symbol("ry", real=True)
POINT = Argument(name="point", rows=("rx", "ry"), shape=(2,), per_point=True, unit="mm", description="a point")
FACTOR = Argument(name="factor", rows=("k",), shape=(1,), per_point=False, unit="1", description="a factor")


def executed(text: str) -> ModuleType:
    module = ModuleType("kernels")
    exec(text, module.__dict__)
    return module


@cache
def source(name: str) -> str:
    model = models()[name]
    return numpy_source(model.machine, model.routines)


def emitted(value: sp.Expr) -> tuple[str, Any]:
    """The text and the function of one expression of rx and ry."""
    out = Argument(name="out", rows=("dx",), shape=(1,), per_point=True, unit="mm", description="a result")
    routine = build("f", "F.", "by hand", (POINT, FACTOR), (out,), {"dx": value})
    text = numpy_source(machine_at(DMU60P), (routine,))
    return text, executed(text).f


CONSTANTS = [0.1 + 0.2, 1 / 3, np.pi / 180, 5e-324, 1.7976931348623157e308, 1e-5, 123456789.12345679, -2 / 3]


@pytest.mark.parametrize("constant", CONSTANTS)
def test_constants_keep_every_digit(constant: float) -> None:
    _, function = emitted(sp.Float(constant, 17) + X)
    assert function(np.array([[0.0], [0.0]]), np.zeros(1))[0, 0] == constant
    _, function = emitted(sp.Float(constant, 17) * X)
    assert function(np.array([[1.0], [0.0]]), np.zeros(1))[0, 0] == constant


@pytest.mark.parametrize(("p", "q"), [(1, 3), (-2, 7), (10**20 + 1, 3), (1, 10)])
def test_fractions_are_the_nearest_doubles(p: int, q: int) -> None:
    _, function = emitted(sp.Rational(p, q) + X)
    assert function(np.array([[0.0], [0.0]]), np.zeros(1))[0, 0] == p / q


def test_powers_and_roots_are_products_and_roots() -> None:
    text, function = emitted((X + Y) ** 2 + X**3 / Y + sp.sqrt(X * Y) - 1 / (X - Y))
    body = text[text.index("def f(") :]
    assert "**" not in body
    assert "pow" not in body
    x, y = 2.5, 0.75
    wanted = (x + y) ** 2 + x**3 / y + np.sqrt(x * y) - 1 / (x - y)
    assert function(np.array([[x], [y]]), np.zeros(1))[0, 0] == pytest.approx(wanted, rel=1e-15)


def test_what_no_kernel_needs_is_refused_rather_than_printed_wrongly() -> None:
    with pytest.raises(ValueError, match="no kernel needs"):
        emitted(X ** sp.Rational(1, 3))


@pytest.mark.parametrize("name", ["dmu60p", "five_axis"])
class TestEveryModule:
    def test_it_needs_numpy_alone(self, name: str) -> None:
        tree = ast.parse(source(name))
        imports = [node for node in ast.walk(tree) if isinstance(node, ast.Import | ast.ImportFrom)]
        assert [ast.unparse(node) for node in imports] == ["import numpy as np"]
        # And calls nothing but NumPy, its own functions and what Python has built in.
        own = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
        called = {
            node.func.id for node in ast.walk(tree) if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
        }
        assert called <= own | {"range", "slice", "float", "min", "len", "next", "ValueError"}

    def test_the_header_says_what_it_is_and_how_to_make_it(self, name: str) -> None:
        first, spdx, second, *_ = source(name).splitlines()
        spec = f"machines/{name}.toml"
        assert first == f"# Generated from {spec}, do not edit; regenerate with: trueaxis derive {spec}"
        assert spdx == "# SPDX-License-Identifier: MIT"
        assert second.startswith(f'"""Kernels of {models()[name].machine.title}')

    def test_it_carries_abi_hash_and_a_full_record(self, name: str) -> None:
        machine, module = models()[name].machine, executed(source(name))
        assert (ABI, machine.digest) == (module.ABI, module.SPEC_HASH)
        meta = module.META
        assert tuple(meta["axes"]) == machine.axes
        assert tuple(meta["components"]) == machine.components
        assert tuple(meta["parameters"]) == machine.parameters
        for kind in ("component", "parameter"):
            names, units, texts = (meta[k] for k in (f"{kind}s", f"{kind}_units", f"{kind}_descriptions"))
            assert len(names) == len(units) == len(texts)
            assert set(units) <= {"mm", "rad"}
            assert all(texts)
            assert len(set(texts)) == len(texts), "two of one description cannot be told apart"
        assert meta["position_units"] == ["mm" if axis in "XYZ" else "deg" for axis in machine.axes]
        functions = {n for n, f in vars(module).items() if callable(f) and not n.startswith("_")}
        assert functions == set(meta["routines"])

    def test_every_docstring_tells_shapes_units_and_operations(self, name: str) -> None:
        module = executed(source(name))
        for routine in models()[name].routines:
            doc = getattr(module, routine.name).__doc__
            assert routine.summary in doc
            assert f"Operations: {routine.operations} per point" in doc
            for argument in routine.inputs + routine.outputs:
                sizes = [*map(str, argument.shape), *(["n"] if argument.per_point else [])]
                shape = f"({', '.join(sizes)}{',' if len(sizes) == 1 else ''})"
                assert f"{argument.name} {shape}: {argument.description} [{argument.unit}]" in doc, routine.name

    def test_shapes_are_those_that_the_record_tells(self, name: str) -> None:
        module = executed(source(name))
        rng = np.random.default_rng(0)
        for routine, record in module.META["routines"].items():
            given = [rng.normal(size=(*a["shape"], *([5] if a["per_point"] else []))) for a in record["inputs"]]
            found = getattr(module, routine)(*given)
            (out,) = record["outputs"]
            assert found.shape == (*out["shape"], 5), routine
            assert found.dtype == np.float64

    def test_a_quantity_that_is_the_same_at_all_points_may_be_given_once(self, name: str) -> None:
        module = executed(source(name))
        rng = np.random.default_rng(1)
        meta = module.META
        positions, errors = rng.normal(size=(len(meta["axes"]), 7)), rng.normal(size=(len(meta["components"]), 1))
        parameters, point = rng.normal(size=len(meta["parameters"])), rng.normal(size=(3, 1))
        once = module.tool_in_workpiece_deviation(positions, errors, parameters, point)
        each = module.tool_in_workpiece_deviation(
            positions, np.repeat(errors, 7, axis=1), parameters, np.repeat(point, 7, axis=1)
        )
        np.testing.assert_array_equal(once, each)

    def test_blocks_leave_no_seam(self, name: str) -> None:
        module = executed(source(name))
        rng = np.random.default_rng(2)
        meta, n = module.META, 2 * module.BLOCK + 3
        positions, errors = rng.normal(size=(len(meta["axes"]), n)), rng.normal(size=(len(meta["components"]), n))
        parameters, point = rng.normal(size=len(meta["parameters"])), rng.normal(size=(3, 1))
        whole = module.tool_in_workpiece_deviation(positions, errors, parameters, point)
        for at in (0, module.BLOCK - 1, module.BLOCK, 2 * module.BLOCK, n - 1):
            one = module.tool_in_workpiece_deviation(
                positions[:, at : at + 1], errors[:, at : at + 1], parameters, point
            )
            np.testing.assert_allclose(whole[:, at : at + 1], one, rtol=1e-13)
        nothing = module.tool_in_workpiece_deviation(positions[:, :0], errors[:, :0], parameters, point[:, [0] * 0])
        assert nothing.shape == (3, 0)

    def test_no_argument_is_written_to(self, name: str) -> None:
        module = executed(source(name))
        rng = np.random.default_rng(0)
        for routine, record in module.META["routines"].items():
            given = [rng.normal(size=(*a["shape"], *([5] if a["per_point"] else []))) for a in record["inputs"]]
            before = [array.copy() for array in given]
            getattr(module, routine)(*given)
            for old, new in zip(before, given, strict=True):
                np.testing.assert_array_equal(old, new, err_msg=routine)

    def test_names_that_the_code_uses_are_refused_as_names_of_parameters(self, name: str) -> None:
        model = models()[name]
        # The terms of effects take no parameters of the machine.
        routines = [r for r in model.routines if not r.name.startswith("effect_")]
        used = {row for r in routines for a in r.inputs + r.outputs for row in a.rows}
        used |= {target.name for r in routines for stage in (r.batch, r.preparation, r.body) for target, _ in stage}
        for taken in sorted(used - set(model.machine.parameters)):
            text = serial_text("Y", "X", X={"position": [taken, 0.0, 0.0]})
            with pytest.raises(InputError, match="clashes"):
                machine_of(text)


def test_parameters_may_have_the_names_of_python_s_and_c_s_own_functions() -> None:
    # What is not refused must work: names that generated code might use for something else.
    names = ["min", "max", "exp", "abs", "print", "size_t"]
    positions = {"X": {"position": names[:3]}, "Y": {"position": names[3:]}}
    machine = machine_of(serial_text("Y", "X", **positions))
    module = executed(numpy_source(machine, derive_model(machine).routines))
    parameters = np.array([float(names.index(n) + 1) if n in names else 0.0 for n in machine.parameters])
    found = module.tool_in_workpiece_ideal(np.array([[10.0], [20.0]]), parameters, np.zeros((3, 1)))
    np.testing.assert_array_equal(found[:, 0], [10 + 1 - 4, -20 + 2 - 5, 3 - 6])


@pytest.mark.parametrize("title", ["A mill, 5 axes (B/C)", "Fräse & Söhne's #1", "x + y - z: _test_"])
def test_titles_that_the_spec_takes_break_no_file(title: str) -> None:
    machine = machine_of(serial_text("Y", "X").replace(HEAD.splitlines()[2], f'title = "{title}"'))
    module = executed(numpy_source(machine, derive_model(machine).routines))
    assert module.META["title"] == title


def test_no_date_user_or_path_is_in_it() -> None:
    text = source("dmu60p")
    assert not re.search(r"\b20\d\d-\d\d|/(home|tmp|root|usr)/", text)
