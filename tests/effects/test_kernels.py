"""The emitted terms, NumPy and C: values against other arithmetics, derivatives against differences."""

import shutil
import subprocess
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from types import ModuleType
from typing import Any

import mpmath
import numpy as np
import numpy.typing as npt
import pytest
import sympy as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.effects.expressions import NAMES, SYMBOLS, Drawn, expressions
from tests.kernels import kernels_at, model_of
from tests.machine.test_effects import effect
from tests.machines import DMU60P, machine_at
from trueaxis.codegen.c_source import c_header, c_source
from trueaxis.codegen.effect_library import FILE, library_source
from trueaxis.codegen.meta import ABI
from trueaxis.codegen.numpy_source import numpy_source
from trueaxis.derivation.effect_terms import effect_routines, library_routines
from trueaxis.derivation.routine import Routine
from trueaxis.effects.evaluate import evaluate
from trueaxis.effects.expression import LONGEST, parse
from trueaxis.effects.kind import Effect, Kind, Parameter
from trueaxis.effects.library import BY_NAME, KINDS
from trueaxis.effects.placement import FARTHEST, context_of
from trueaxis.machine import Machine
from trueaxis.model import effect_library
from trueaxis.model.c_kernels import load_c_kernels
from trueaxis.model.compiler import find_compiler

FloatArray = npt.NDArray[np.float64]
Kernel = Callable[[FloatArray, FloatArray], FloatArray]
COMPILER = pytest.mark.skipif(find_compiler() is None, reason="there is no C compiler")
BACKENDS = ["numpy", pytest.param("c", marks=COMPILER)]
LIBRARY: Any = effect_library
TERMS = [kind for kind in KINDS if kind.expression]
# Parameters named as things of Python, NumPy, C and of the loops are.
HOSTILE = (
    "n",
    "i",
    "j",
    "w",
    "e",
    "p",
    "x",
    "I",
    "N",
    "term_",
    "abs_",
    "min",
    "max",
    "sum",
    "print",
    "log",
    "y0",
    "j1",
    "time",
)


def machine_with(kinds: Sequence[Kind]) -> Machine:
    base = machine_at(DMU60P)
    return Machine(
        name=base.name,
        title=base.title,
        bodies=base.bodies,
        workpiece=base.workpiece,
        tool=base.tool,
        effect_kinds=tuple(kinds),
    )


def compiled(folder: Path, machine: Machine, routines: tuple[Routine, ...]) -> dict[str, Kernel]:
    code = {
        "kernels.c": c_source(machine, routines).encode(),
        "kernels.h": c_header(machine, routines).encode(),
    }
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("TRUEAXIS_CACHE", str(folder / "cache"))
        records = executed(machine, routines).META["routines"]
        kernels, reason = load_c_kernels(code, machine.name, machine.digest, ABI, records)
    assert reason == ""
    return kernels  # type: ignore[return-value]  # each has one output


def executed(machine: Machine, routines: tuple[Routine, ...]) -> ModuleType:
    module = ModuleType("kernels")
    exec(numpy_source(machine, routines), module.__dict__)
    return module


def kernels_of(
    backend: str, machine: Machine, folder: Path, routines: tuple[Routine, ...] = ()
) -> Callable[[str], Kernel]:
    routines = routines or effect_routines(machine)
    if backend == "c":
        return compiled(folder, machine, routines).__getitem__
    module = executed(machine, routines)
    return lambda name: getattr(module, name)


@pytest.fixture(scope="module", params=BACKENDS)
def library(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Kernel]:
    return kernels_of(request.param, machine_at(DMU60P), tmp_path_factory.mktemp(request.param), library_routines())


SIZES = {
    "u": 0.01,
    "mm": 0.01,
    "rad": 0.7,
    "axis": 7.0,
    "s": 40.0,
    "u/K": 0.003,
    "u/axis/K": 1e-5,
    "u/s": 1e-5,
    "1": 1e-6,
}


def drawn(kind: Kind, n: int) -> tuple[FloatArray, FloatArray]:
    rng = np.random.default_rng(list(kind.name.encode()))
    sizes = {"direction": 1.0, "s": 1.0, "s_b": 1.0, "T": 5.0, "theta": 3.0}
    rows = [rng.uniform(-1, 1, n) * sizes.get(name, 100.0) for name in context_of(kind)]
    context = np.array(
        [
            np.abs(row) if name in ("d", "d_time", "d_path", "s", "t") else row
            for name, row in zip(context_of(kind), rows, strict=True)
        ]
    )
    return context, np.array([SIZES[one.unit] * rng.uniform(0.5, 1.5) for one in kind.parameters])


@pytest.mark.parametrize("kind", TERMS, ids=lambda kind: kind.name)
class TestLibrary:
    def test_values_are_those_of_the_expression(self, kind: Kind, library: Callable[[str], Kernel]) -> None:
        context, parameters = drawn(kind, 700)
        found = library(f"effect_{kind.name}")(context, parameters)
        assert found.shape == (1 + len(parameters), 700)
        given_ = dict(zip((one.name for one in kind.parameters), parameters, strict=True))
        tree = parse(kind.expression)
        wanted = [evaluate(tree, given_ | dict(zip(context_of(kind), at, strict=True))) for at in context.T]
        np.testing.assert_allclose(found[0], wanted, rtol=1e-13, atol=1e-13 * np.abs(wanted).max())

    def test_derivatives_are_differences(self, kind: Kind, library: Callable[[str], Kernel]) -> None:
        context, parameters = drawn(kind, 50)
        kernel = library(f"effect_{kind.name}")
        found = kernel(context, parameters)
        for index, value in enumerate(parameters):
            step = np.zeros_like(parameters)
            step[index] = 1e-5 * value
            difference = kernel(context, parameters + step)[0] - kernel(context, parameters - step)[0]
            wanted = difference / (2e-5 * value)
            np.testing.assert_allclose(found[1 + index], wanted, rtol=1e-6, atol=1e-7 * np.abs(found[0] / value).max())


def test_before_the_first_reversal_nothing_is_left_of_a_spike(library: Callable[[str], Kernel]) -> None:
    context = np.array([[1.0, -1.0], [FARTHEST, FARTHEST]])
    np.testing.assert_array_equal(library("effect_reversal_spike")(context, np.array([0.01, 50.0])), np.zeros((3, 2)))


def test_what_is_unknown_stays_unknown(library: Callable[[str], Kernel]) -> None:
    unknown = np.array([[np.nan]])
    assert np.isnan(library("effect_laser_step")(unknown, np.array([0.001, 30.0]))[:2]).all()
    assert np.isnan(library("effect_backlash")(unknown, np.array([0.001]))).all()


def test_the_record_tells_context_parameters_and_place() -> None:
    record = LIBRARY.META["effects"]
    assert record["kinds"].keys() == BY_NAME.keys()
    spike = {"place": "component", "context": ["direction", "d"], "parameters": ["height", "decay"]}
    assert record["kinds"]["reversal_spike"] == spike
    assert record["kinds"]["point_offset"] == {"place": "point", "context": [], "parameters": ["x", "y", "z"]}
    assert LIBRARY.META["routines"].keys() == {f"effect_{kind.name}" for kind in TERMS}


def test_the_library_is_as_it_is_emitted() -> None:
    assert FILE.read_text(encoding="utf-8") == library_source(), "run: python -m trueaxis.codegen.effect_library"


def test_a_machine_has_the_effects_of_its_spec_alone() -> None:
    none = kernels_at(DMU60P).META
    assert (none["effects"], [n for n in none["routines"] if n.startswith("effect_")]) == (
        {"kinds": {}, "terms": []},
        [],
    )
    tables = effect(kind="backlash", component="EXX") + effect(kind="backlash", component="EYY")
    one = model_of(DMU60P.read_text() + tables + effect(kind="laser_cosine"))
    names = [routine.name for routine in one.routines if routine.name.startswith("effect_")]
    assert names == ["effect_backlash", "effect_laser_cosine"]
    own_kinds = effect_routines(machine_with([own("k*s + p")]))
    assert [routine.name for routine in own_kinds] == ["effect_own"]


def test_a_term_is_the_same_from_the_machine_s_kernels_and_from_the_library() -> None:
    machine = machine_at(DMU60P)
    with_effect = replace(machine, effects=(Effect(kind="cyclic", component="EXX"),))
    module = executed(with_effect, effect_routines(with_effect))
    context, parameters = np.array([[10.0, 20.0, 33.0]]), np.array([0.002, 0.3, 10.0])
    found, expected = (each.effect_cyclic(context, parameters) for each in (module, effect_library))
    np.testing.assert_array_equal(found, expected)
    assert np.ptp(found[0]) > 0


def own(text: str, parameters: Sequence[str] = ("k", "p")) -> Kind:
    return Kind(
        name="own",
        place="component",
        expression=text,
        parameters=tuple(Parameter(name=name, unit="u", meaning=name) for name in parameters),
        sentence="a cause",
    )


def context_for(kind: Kind, values: dict[str, float]) -> FloatArray:
    return np.array([[values.get(name, 0.0)] for name in context_of(kind)])


def exact(value: sp.Expr, values: dict[str, float]) -> float:
    with mpmath.workdps(40):
        return float(sp.N(value.subs({SYMBOLS[name]: sp.Rational(Fraction(v)) for name, v in values.items()}), 30))


POINTS = st.fixed_dictionaries({name: st.floats(-3, 3).map(lambda x: round(x, 3) + 0.0003) for name in NAMES})


@settings(deadline=None, max_examples=60, suppress_health_check=[HealthCheck.too_slow])
@given(expressions().filter(lambda one: len(one.text) <= LONGEST), POINTS)
def test_any_expression_in_numpy(one: Drawn, values: dict[str, float]) -> None:
    kind = own(one.text)
    module = executed(machine_with([kind]), effect_routines(machine_with([kind]))[-1:])
    parameters = np.array([values["k"], values["p"]])
    with np.errstate(all="ignore"):
        found = module.effect_own(context_for(kind, values), parameters)[:, 0]
    assert not np.isnan(found).any(), "an expression with a value has derivatives"
    wanted = exact(one.value, values)
    if abs(wanted) < 1e9 and not one.value.has(sp.sign, sp.Heaviside):
        assert found[0] == pytest.approx(wanted, rel=1e-6, abs=1e-6)
        for index, name in enumerate(("k", "p")):
            slope = exact_slope(one.value, values, name)
            if slope is not None:
                assert found[1 + index] == pytest.approx(slope, rel=1e-4, abs=1e-4), (one.text, name)


def exact_slope(value: sp.Expr, values: dict[str, float], name: str) -> float | None:
    """The central difference in 30 digits; None where it depends on the step: at a corner, or too steep."""
    slopes = []
    for step in (1e-7, 5e-8):
        low, high = (exact_fraction(value, values | {name: values[name] + sign * step}) for sign in (-1, 1))
        slopes.append(float((high - low) / (2 * mpmath.mpf(step))))
    steady = abs(slopes[0] - slopes[1]) <= 1e-6 * (1 + abs(slopes[0])) and abs(slopes[0]) < 1e9
    return slopes[1] if steady else None


def exact_fraction(value: sp.Expr, values: dict[str, float]) -> mpmath.mpf:
    with mpmath.workdps(40):
        found = sp.N(value.subs({SYMBOLS[name]: sp.Rational(Fraction(v)) for name, v in values.items()}), 30)
        return mpmath.mpf(str(found))


@COMPILER
def test_many_expressions_in_c_are_as_in_numpy(tmp_path: Path) -> None:
    texts = [
        "k*sqrt(abs(s - 1/3))*step(sin(q/p))*exp(-abs(q)/7)*sign(T)^2",
        "k*tanh(s*p)^3/(1 + s^2)^2 + p",
        "k*(2*pi)^2*cos(pi/5 + p)*q^9 - -p",
        "k*2^3*exp(1)*sqrt(2)/(0.1 + abs(direction))",
        "p*k",
        "k + p",
        "-k*(s - (q - (T - p)))^5",
    ]
    kinds = [
        Kind(name=f"own{index}", place="component", expression=text, parameters=own("k").parameters, sentence="a cause")
        for index, text in enumerate(texts)
    ]
    machine = machine_with(kinds)
    routines = effect_routines(machine)
    numpy, c = executed(machine, routines), compiled(tmp_path, machine, routines)
    rng = np.random.default_rng(5)
    for kind in kinds:
        context, parameters = rng.uniform(-2, 2, (len(context_of(kind)), 999)), rng.uniform(0.5, 2, 2)
        wanted = getattr(numpy, f"effect_{kind.name}")(context, parameters)
        found = c[f"effect_{kind.name}"](context, parameters)
        assert np.all(np.abs(found - wanted) <= 1e-12 * np.abs(wanted).max(axis=1, keepdims=True)), kind.expression
        values = dict(zip(context_of(kind), context[:, 0], strict=True)) | {"k": parameters[0], "p": parameters[1]}
        assert found[0, 0] == pytest.approx(evaluate(parse(kind.expression), values), rel=1e-11)


@pytest.mark.parametrize("backend", BACKENDS)
def test_parameters_may_have_the_names_of_other_things(backend: str, tmp_path: Path) -> None:
    kinds = [own(" + ".join(f"{k + 2}*{name}*s" for k, name in enumerate(HOSTILE)), HOSTILE)]
    kernel = kernels_of(backend, machine_with(kinds), tmp_path)("effect_own")
    found = kernel(np.array([[0.5]]), np.arange(1.0, len(HOSTILE) + 1))
    assert found[0, 0] == sum((k + 2) * (k + 1) for k in range(len(HOSTILE))) / 2
    np.testing.assert_array_equal(found[1:, 0], [(k + 2) / 2 for k in range(len(HOSTILE))])


@pytest.mark.skipif(not shutil.which("gcc"), reason="gcc is not installed")
@pytest.mark.parametrize("text", ["k*s", "k*step(s)", "k*sign(s)*abs(q)", "k"])
def test_c_of_effects_compiles_without_a_warning(text: str, tmp_path: Path) -> None:
    # Own kinds beside the library's, and alone: helpers that nothing calls would be a warning.
    machine = machine_with([own(text, ("k",))])
    for routines in (library_routines() + effect_routines(machine), effect_routines(machine)):
        (tmp_path / "kernels.c").write_text(c_source(machine, routines))
        (tmp_path / "kernels.h").write_text(c_header(machine, routines))
        strict = ("-std=c17", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wmissing-prototypes", "-Wunused-function")
        done = subprocess.run(
            ["gcc", *strict, "-Werror", "-O1", "-c", "kernels.c", "-o", "kernels.o"],
            cwd=tmp_path, capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert done.stderr == ""
