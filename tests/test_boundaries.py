"""Who may import whom: SymPy stays left of the generated files, and imports go one way."""

import ast
import importlib
import pkgutil
import re
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

import trueaxis

SOURCE = Path(trueaxis.__file__).parent
LEFT = {"derivation", "codegen"}
SYMBOLIC = {"sympy", "jinja2"}
# The HTML report is a template too. It loads Jinja2 when a report is written, never when it is imported
# (test_a_fresh_interpreter_runs_without_symbolic_libraries holds it to that); SymPy stays forbidden to it.
REPORT = "trueaxis.reporting.diagnosis."


@cache
def modules() -> dict[str, Path]:
    found = {"trueaxis": SOURCE / "__init__.py"}
    for info in pkgutil.walk_packages([str(SOURCE)], "trueaxis."):
        path = SOURCE.parent / Path(*info.name.split("."))
        found[info.name] = path / "__init__.py" if info.ispkg else path.with_suffix(".py")
    return found


@cache
def parsed(module: str) -> ast.Module:
    return ast.parse(modules()[module].read_text())


def package_of(module: str) -> str:
    """`derivation` of trueaxis.derivation.chain, `view` of trueaxis.view."""
    return [*module.split("."), ""][1]


@cache
def imported(module: str, *, lazily: bool) -> tuple[str, ...]:
    return tuple(_imported(module, lazily=lazily))


def _imported(module: str, *, lazily: bool) -> Iterator[str]:
    """Modules that a module's text imports, as full names; `lazily`: also inside functions. Type checking is no use."""

    def statements(node: ast.AST) -> Iterator[ast.AST]:
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.expr):  # no import is in one
                continue
            if isinstance(child, ast.If) and ast.unparse(child.test) == "TYPE_CHECKING":
                continue
            if isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef) and not lazily:
                continue
            yield child
            yield from statements(child)

    for node in statements(parsed(module)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{module} imports relatively"
            for alias in node.names:
                whole = f"{node.module}.{alias.name}"
                yield whole if whole in modules() else str(node.module)


def test_every_module_is_found_and_parsed() -> None:
    assert {"trueaxis.derivation.chain", "trueaxis.model.model", "trueaxis.cli.derive"} <= modules().keys()
    assert len(modules()) == sum(1 for path in SOURCE.rglob("*.py"))


def test_the_imports_of_modules_run_in_no_circle() -> None:
    graph = {module: {name for name in imported(module, lazily=True) if name in modules()} for module in modules()}
    try:
        tuple(TopologicalSorter(graph).static_order())
    except CycleError as error:
        pytest.fail(f"imports run in a circle: {' -> '.join(error.args[1])}")


def test_the_imports_of_packages_run_in_no_circle() -> None:
    graph: dict[str, set[str]] = {}
    for module in modules():
        names = {package_of(name) for name in imported(module, lazily=True) if name in modules()}
        graph.setdefault(package_of(module), set()).update(names - {package_of(module), ""})
    try:
        tuple(TopologicalSorter(graph).static_order())
    except CycleError as error:
        pytest.fail(f"packages import one another: {' -> '.join(error.args[1])}")


def test_what_lies_right_of_the_generated_files_does_not_import_what_lies_left() -> None:
    for module in modules():
        if package_of(module) in LEFT:
            continue
        for name in imported(module, lazily=package_of(module) not in ("cli", "demo", "jobs")):
            assert package_of(name) not in LEFT or not name.startswith("trueaxis."), f"{module} imports {name}"
            allowed = {"jinja2"} if module.startswith(REPORT) else set()
            assert name.split(".")[0] not in SYMBOLIC - allowed, f"{module} imports {name}"


def test_what_lies_left_imports_nothing_that_only_runs() -> None:
    for module in modules():
        if package_of(module) in LEFT:
            found = {package_of(name) for name in imported(module, lazily=True) if name in modules()}
            allowed = {
                "machine",
                "effects",
                "error_name",
                "view",
                "blocks",
                "io",
                "c_prefix",
                "template_folders",
            }
            assert found <= LEFT | allowed, module


def test_effects_import_nothing_of_the_project_but_faults_and_names() -> None:
    for module in modules():
        if package_of(module) == "effects":
            found = {package_of(name) for name in imported(module, lazily=True) if name in modules()}
            assert found <= {"effects", "io", "error_name"}, module


def test_what_computes_writes_no_sentences() -> None:
    showing = {"reporting", "jobs", "cli", "demo", ""}
    found = [
        f"{module} imports {name}"
        for module in modules()
        if package_of(module) not in showing
        for name in imported(module, lazily=True)
        if name.startswith((REPORT, "trueaxis.reporting."))
    ]
    assert found == []


def test_a_fresh_interpreter_runs_without_symbolic_libraries() -> None:
    right = [module for module in modules() if package_of(module) not in LEFT and not module.endswith("__main__")]
    assert any(module.startswith("trueaxis.compensation.") for module in right)
    code = f"""
import importlib, sys
for name in {right!r}:
    importlib.import_module(name)
import trueaxis.cli.main
trueaxis.cli.main.build_parser()
print(sorted({{name.split(".")[0] for name in sys.modules}} & {SYMBOLIC!r}))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stderr == ""
    assert done.stdout.strip() == "[]"


def test_every_package_and_module_says_what_it_is() -> None:
    for folder in {path.parent for path in SOURCE.rglob("*.py")}:
        assert (folder / "__init__.py").is_file(), f"{folder} is no package"
    for module in modules():
        assert ast.get_docstring(parsed(module)), f"{module} has no docstring"


def test_public_functions_and_classes_have_docstrings() -> None:
    for module in modules():
        for node in parsed(module).body:
            if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_"):
                assert ast.get_docstring(node), f"{module}.{node.name} has no docstring"


def test_every_module_can_be_imported_first() -> None:
    # An import circle hides until its modules are imported in another order.
    for module in (
        "trueaxis.machine.machine",
        "trueaxis.model.model",
        "trueaxis.measurement.data",
        "trueaxis.derivation.chain",
    ):
        done = subprocess.run([sys.executable, "-c", f"import {module}"], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
    assert importlib.import_module("trueaxis").__version__


def test_no_group_is_repeated_possessively() -> None:
    """Python before 3.11.5 takes such groups for matched where they are not: a word without its number would pass."""
    found = [path.name for path in SOURCE.rglob("*.py") if re.search(r"(?<!\\)\)[?*+]\+", path.read_text())]
    assert found == []
