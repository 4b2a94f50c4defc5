"""Kernels as somebody uses them without the package: the header in C and C++, wrong shapes, examples, the table."""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from tests.codegen.test_numpy_source import executed, source
from tests.derivation.test_routine import models
from tests.machines import ROOT
from trueaxis.codegen.c_source import c_header, c_source, control_sources
from trueaxis.model.manifest import spec_label

STRICT = ("-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Werror")
KERNELS = ROOT / "generated" / "dmu60p"


def run(*command: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)


def compiler(name: str) -> str:
    if not shutil.which(name):
        pytest.skip(f"{name} is not installed")
    return name


@pytest.mark.parametrize("standard", ["c++17", "c++20"])
def test_the_header_is_cpp_too_and_links(standard: str, tmp_path: Path) -> None:
    """A C++ program with two machines' headers; without `extern "C"` it would not link."""
    program = tmp_path / "main.cpp"
    program.write_text(
        '#include "dmu60p/kernels.h"\n#include "dmu60p_5axis/kernels.h"\n'
        '#include "dmu60p/control.h"\n#include "dmu60p_5axis/control.h"\n'
        "int main() { return dmu60p_kernel_abi() - TRUEAXIS_KERNEL_ABI; }\n"
    )
    made = run(compiler("gcc"), "-std=c17", "-c", KERNELS / "kernels.c", "-o", tmp_path / "kernels.o")
    assert made.returncode == 0, made.stderr
    linked = run(
        *(compiler("g++"), f"-std={standard}", *STRICT, "-I", ROOT / "generated", program),
        *(tmp_path / "kernels.o", "-lm", "-o", tmp_path / "main"),
    )
    assert (linked.returncode, linked.stderr) == (0, "")
    assert run(tmp_path / "main").returncode == 0


@pytest.mark.parametrize("name", ["dmu60p", "five_axis"])
def test_the_source_compiles_as_cpp_without_a_warning(name: str, tmp_path: Path) -> None:
    """Nobody is told to, but a build may take every file as C++."""
    model = models()[name]
    (tmp_path / "kernels.c").write_text(c_source(model.machine, model.routines))
    (tmp_path / "kernels.h").write_text(c_header(model.machine, model.routines))
    flags = ("-std=c++17", "-Wall", "-Wextra", "-Werror", "-fsyntax-only")
    for file, text in control_sources(model.machine, model.routines).items():
        (tmp_path / file).write_text(text)
    made = run(compiler("g++"), *flags, "-x", "c++", tmp_path / "kernels.c", tmp_path / "control.c")
    assert (made.returncode, made.stderr) == (0, "")


def test_the_examples_say_the_same(tmp_path: Path) -> None:
    example = ROOT / "examples" / "main.c"
    made = run(
        *(compiler("gcc"), "-std=c17", *STRICT, "-I", KERNELS, example, KERNELS / "kernels.c"),
        *("-lm", "-o", tmp_path / "example"),
    )
    assert (made.returncode, made.stderr) == (0, "")
    printed = [run(tmp_path / "example").stdout, run(sys.executable, ROOT / "examples" / "point.py").stdout]
    c, numpy = ([float(word) for word in text.split()] for text in printed)
    assert len(c) == 7
    assert c == pytest.approx(numpy, rel=1e-11)
    # By hand, first order, by the x row of Eq. (4) on the page: displacements, then each lever times its angle.
    levers = {"e_y(z)": -200.0 * 5e-6, "e_xz + e_y(x) - e_y(y)": (-200.0 + 300.0) * 26e-6, "e_z(y)": -350.0 * 5e-6}
    assert c[0] == pytest.approx(2e-3 + sum(levers.values()), abs=1e-7)
    assert c[6] == 25.0


def test_the_header_names_rows_and_units() -> None:
    header = (KERNELS / "kernels.h").read_text(encoding="utf-8")
    for text in ("SPDX-License-Identifier: MIT", "EXX mm,", "EAX rad,", "q_wx mm,", "eps_xy rad,", 'extern "C"'):
        assert text in header
    assert "Rows and units: kernels.c" not in header
    declared = re.findall(r"/\*\n((?: \* .*\n)+) \*/\nvoid (\w+)\(", header)
    manifest = json.loads((KERNELS / "manifest.json").read_text(encoding="utf-8"))
    assert [name for _, name in declared] == [f"dmu60p_{routine}" for routine in manifest["operations"]]
    assert all("Operations: " in comment and " * in " in comment for comment, _ in declared)


@pytest.mark.parametrize("file", ["kernels.py", "kernels.c", "kernels.h", "control.c", "control.h"])
def test_nothing_turns_on_a_machine_of_linear_axes(file: str) -> None:
    text = (KERNELS / file).read_text(encoding="utf-8")
    assert not re.search(r"rotary axes|cosines", text)
    turning = (ROOT / "generated" / "dmu60p_5axis" / file).read_text(encoding="utf-8")
    assert "rotary axes deg" in " ".join(turning.split())


@pytest.fixture(scope="module")
def module() -> ModuleType:
    return executed(source("dmu60p"))


WRONG = {
    "positions has the shape (2, 4), not (3, n)": ((2, 4), (18, 4), (9,), (3, 4)),
    "errors has the shape (18,), not (18, n)": ((3, 4), (18,), (9,), (3, 4)),
    "parameters has the shape (8,), not (9,)": ((3, 4), (18, 4), (8,), (3, 4)),
    "errors has 5 points, not 4 or 1": ((3, 4), (18, 5), (9,), (3, 1)),
}


@pytest.mark.parametrize("message", WRONG)
def test_a_wrong_shape_names_the_argument(message: str, module: ModuleType) -> None:
    arrays = [np.zeros(shape) for shape in WRONG[message]]
    with pytest.raises(ValueError, match=re.escape(message)):
        module.tool_in_workpiece_deviation(*arrays)


def test_docstrings_have_the_rows_in_order(module: ModuleType) -> None:
    doc = " ".join(module.tool_in_workpiece_deviation.__doc__.split())
    assert "rows: EXX EYX EZX EAX EBX ECX EXY" in doc
    assert "rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz" in doc


def test_every_routine_is_in_the_table_of_the_documentation() -> None:
    table = re.findall(r"^\| `(\w+)` \|", (ROOT / "docs" / "kernels.md").read_text(encoding="utf-8"), re.MULTILINE)
    views = "(tool_in_workpiece|tool_in_bed|workpiece_in_bed|bed_in_workpiece)"
    words = {"VIEW": views, "AXES": "[XYZABC]+", "NUMBER": r"\d+", "KIND": r"\w+"}
    patterns = [re.sub("VIEW|AXES|NUMBER|KIND", lambda found: words[found[0]], row) for row in table]
    names = {routine.name for model in models().values() for routine in model.routines}
    elsewhere = {"system_1", "effect_cyclic"}  # of specs with runs, with effects
    assert {name for name in names if not any(re.fullmatch(p, name) for p in patterns)} == set()
    assert [p for p in patterns if not any(re.fullmatch(p, name) for name in names | elsewhere)] == []


@pytest.mark.parametrize(
    ("spec", "out", "label"),
    [
        ("shop/machines/mill.toml", "shop/generated", "machines/mill.toml"),
        ("shop/mill.toml", "shop/generated", "mill.toml"),
        ("elsewhere/mill.toml", "shop/generated", "mill.toml"),
        ("shop/a--b */mill.toml", "shop/generated", "the machine's spec"),
    ],
)
def test_the_banner_names_the_spec_as_it_was_given(spec: str, out: str, label: str, tmp_path: Path) -> None:
    assert spec_label(tmp_path / spec, tmp_path / out) == label
