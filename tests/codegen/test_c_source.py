"""The emitted C: its text, that compilers take it without a word, and that they vectorise it."""

import re
import shutil
import subprocess
from pathlib import Path

import jinja2.meta
import pytest
import sympy as sp

from tests.machines import DMU60P, FIVE_AXIS, machine_at, machine_of, serial_text
from trueaxis.codegen.c_source import (
    c_header,
    c_source,
    control_context,
    control_header_context,
    control_sources,
    header_context,
    source_context,
)
from trueaxis.codegen.printers import CPrinter, horner_coefficients
from trueaxis.codegen.templates import environment
from trueaxis.derivation.library import derive_routines
from trueaxis.derivation.routine import Argument, Routine, build
from trueaxis.machine import Machine
from trueaxis.model.compiler import FLAGS, NATIVE

STRICT = ("-std=c17", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wmissing-prototypes", "-Werror")
x, y, z = sp.symbols("x y z", real=True)


@pytest.fixture(scope="module", params=[DMU60P, FIVE_AXIS], ids=["dmu60p", "five_axis"])
def machine(request: pytest.FixtureRequest) -> Machine:
    return machine_at(request.param)


@pytest.fixture(scope="module")
def routines(machine: Machine) -> tuple[Routine, ...]:
    return derive_routines(machine)


@pytest.fixture(scope="module")
def folder(machine: Machine, routines: tuple[Routine, ...], tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp(machine.name)
    write(made, machine, routines)
    return made


def write(folder: Path, machine: Machine, routines: tuple[Routine, ...]) -> None:
    (folder / "kernels.c").write_text(c_source(machine, routines))
    (folder / "kernels.h").write_text(c_header(machine, routines))
    for name, text in control_sources(machine, routines).items():
        (folder / name).write_text(text)


def compiler_or_skip(name: str) -> str:
    if not shutil.which(name):
        pytest.skip(f"{name} is not installed")
    return name


def run(*command: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)


@pytest.mark.parametrize("source", ["kernels.c", "control.c"])
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_compiles_without_a_warning(compiler: str, source: str, folder: Path) -> None:
    command = (compiler_or_skip(compiler), *STRICT, "-O1", "-c", folder / source, "-o", folder / "strict.o")
    assert run(*command).stderr == ""


def test_header_stands_alone(folder: Path) -> None:
    alone = folder / "alone.c"
    alone.write_text('#include "kernels.h"\n#include "kernels.h"\nint main(void) { return TRUEAXIS_KERNEL_ABI - 3; }\n')
    assert run(compiler_or_skip("gcc"), *STRICT, "-fsyntax-only", alone).stderr == ""


def test_gcc_vectorises_the_loop_over_points_of_every_routine(folder: Path, routines: tuple[Routine, ...]) -> None:
    report = run(
        # Else, of two routines with the same arithmetic one becomes the other, and a mere copy of rows a memcpy.
        *(compiler_or_skip("gcc"), *FLAGS, NATIVE, "-fno-ipa-icf", "-fno-tree-loop-distribute-patterns"),
        *("-fopt-info-vec-optimized",),
        *(folder / "kernels.c", "-o", folder / "report.so", "-lm"),
    ).stderr
    vectorised = {int(number) for number in re.findall(r"kernels\.c:(\d+):\d+: optimized: loop vectorized", report)}
    loops = loops_over_points((folder / "kernels.c").read_text())
    assert len(loops) == len(routines)
    assert {name for name, line in loops.items() if line not in vectorised} == set()


def test_rows_that_are_always_zero_are_written_one_by_one() -> None:
    """gcc takes half a minute of a loop that writes 132 rows at once; what is written is zero, and nothing else is."""
    point = Argument(name="point", rows=("rx", "ry"), shape=(2,), per_point=True, unit="mm", description="a point")
    output = Argument(name="b", rows=("b1", "b2", "b3"), shape=(3,), per_point=True, unit="mm", description="nothing")
    nothing = build("nothing", "Nothing.", "none", (point,), (output,), dict.fromkeys(output.rows, sp.Integer(0)))
    source = c_source(machine_at(DMU60P), (nothing,))
    assert re.findall(r"for \(.*\)", source) == [
        "for (size_t row = 0; row < 3; ++row)",
        "for (size_t i = 0; i < n; ++i)",
    ]
    assert source.count("b[row * stride + i] = 0.0;") == 1


def loops_over_points(source: str) -> dict[str, int]:
    """Routine -> line of its loop over points."""
    found, name = {}, ""
    lines = source.splitlines()
    for number, line in enumerate(lines, 1):
        if match := re.fullmatch(r"void (\w+)\(", line):
            name = match[1]
        elif line.strip() == "POINTS_ARE_INDEPENDENT":
            assert name not in found
            assert lines[number].strip().startswith("for (size_t")
            found[name] = number + 1
    return found


def test_loop_over_points_has_no_branch_and_no_call_but_roots(folder: Path) -> None:
    source = (folder / "kernels.c").read_text()
    lines = source.splitlines()
    for line in loops_over_points(source).values():
        indent = re.match(r" *", lines[line - 1])[0]  # type: ignore[index]  # the empty match at least
        end = lines.index(f"{indent}}}", line)
        inside = "\n".join(lines[line:end])
        assert set(re.findall(r"([A-Za-z_]\w*)\s*\(", inside)) <= {"sqrt"}
        assert not re.search(r"[?%&|!]|\b(if|for|while|switch|goto)\b", inside)


def test_powers_are_products_and_lines_are_short(folder: Path) -> None:
    for name in ("kernels.c", "control.c", "control.h"):
        source = (folder / name).read_text()
        assert "pow(" not in source
        assert max(len(line) for line in source.splitlines()) <= 120


def test_a_machine_whose_tool_cannot_be_moved_freely_has_no_kernels_for_a_control() -> None:
    machine = machine_of(serial_text("", "XY"))
    assert control_sources(machine, derive_routines(machine)) == {}


def test_head_says_where_it_comes_from(folder: Path, machine: Machine) -> None:
    for name in ("kernels.c", "kernels.h", "control.c", "control.h"):
        text = (folder / name).read_text()
        command = f"trueaxis derive machines/{machine.name}.toml"
        assert text.startswith(
            f"/* Generated from machines/{machine.name}.toml, do not edit; regenerate with: {command}"
        )
        assert machine.digest in text
    assert "#define TRUEAXIS_KERNEL_ABI 3\n" in (folder / "kernels.h").read_text()


def test_templates_use_exactly_what_they_are_given(machine: Machine, routines: tuple[Routine, ...]) -> None:
    contexts = {
        "kernels.c.j2": source_context(machine, routines),
        "kernels.h.j2": header_context(machine, routines),
        "control.c.j2": control_context(machine, routines),
        "control.h.j2": control_header_context(machine, routines),
    }
    for name, context in contexts.items():
        jinja = environment()
        assert jinja.loader is not None
        source, _, _ = jinja.loader.get_source(jinja, name)
        assert jinja2.meta.find_undeclared_variables(jinja.parse(source)) == context.keys()


@pytest.mark.parametrize(
    ("value", "code"),
    [
        (x**2, "(x*x)"),
        (x**3 * y, "(x*x*x)*y"),
        (y / x**2, "y/(x*x)"),
        (x**-1, "(1.0/x)"),
        ((x + y) ** -2, "(1.0/((x + y)*(x + y)))"),
        (sp.sqrt(x + y), "sqrt(x + y)"),
        (x / sp.sqrt(y), "x/sqrt(y)"),
        (sp.cos(sp.pi * x / 180), "cos(0.017453292519943295*x)"),
        (-x / 3, "-0.3333333333333333*x"),
        (x - sp.Rational(1, 2), "x - 0.5"),
        (-2 * x * (y - 1), "-2.0*x*(y - 1.0)"),
        (sp.Float("0.1") * x + sp.Integer(7), "0.1*x + 7.0"),
        (sp.Integer(-1), "-1.0"),
    ],
)
def test_printer(value: sp.Expr, code: str) -> None:
    assert CPrinter({}).doprint(value) == code


def test_printer_keeps_every_digit_of_a_constant() -> None:
    number = 0.1 + 0.2
    assert float(CPrinter({}).doprint(sp.Float(number))) == number


@pytest.mark.parametrize("value", [sp.log(x), x**y, x ** sp.Rational(1, 3)])
def test_printer_refuses_what_no_kernel_needs(value: sp.Expr) -> None:
    with pytest.raises(ValueError, match="no kernel needs"):
        CPrinter({}).doprint(value)


def test_names_that_mean_something_else_in_c_are_told_apart(tmp_path: Path) -> None:
    names = ["length", "result", "sqrt", "cos", "stride", "start", "count", "NAN", "INFINITY", "i", "j", "length_"]
    constants = Argument(
        name="result",
        rows=tuple(names[1:]),
        shape=(len(names) - 1,),
        per_point=False,
        unit="mm",
        description="hostile /* names */",
    )
    point = Argument(
        name="length",
        rows=("length",),
        shape=(1,),
        per_point=True,
        unit="mm",
        description="an array named as its only row",
    )
    output = Argument(name="NULL_", rows=("total",), shape=(1,), per_point=True, unit="mm", description="their sum")
    total = sp.Add(*(sp.Symbol(name, real=True) * (k + 2) for k, name in enumerate(names)))
    routine = build("names", "Sum.", "none */", (constants, point), (output,), {"total": sp.sqrt(total)})
    write(tmp_path, machine_at(DMU60P), (routine,))
    assert run(compiler_or_skip("gcc"), *STRICT, "-c", tmp_path / "kernels.c", "-o", tmp_path / "n.o").stderr == ""


def test_horner_form_is_found_again() -> None:
    a, b, c = sp.symbols("a b c", real=True)
    assert horner_coefficients(x * (a + x * (b + c * x))) == (x, (a, b, c))
    assert horner_coefficients(x * (-a + x * (-b - y * x))) == (x, (-a, -b, -y))
    assert horner_coefficients(x * (a * y - x)) == (x, (a * y, sp.S.NegativeOne))
    assert horner_coefficients(x * (a + x * (b + x * (c + x**2)))) is None
    assert horner_coefficients(x * y) is None
    assert horner_coefficients(x + y) is None
    assert horner_coefficients(x * (a + b * x + c * x**2)) is None
