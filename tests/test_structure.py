"""What keeps the house easy to read: small files, short functions, shallow nesting, records that are built by name."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conftest import LONG
from tests.machines import ROOT
from tests.test_boundaries import modules, package_of, parsed

LONGEST_FILE, LONGEST_FUNCTION, DEEPEST = 300, 60, 4
MOST_POSITIONAL = 4  # fields that a reader of a call can tell apart by their order
EMITTED = "# Generated from "  # how a file begins that nobody writes or reads line by line
# Rooms whose records and longest files wait for other work on them.
WAITING = ()
_NESTING = (ast.If, ast.For, ast.While, ast.With, ast.Try, ast.Match)
_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)


def written() -> Iterator[tuple[str, Path, ast.Module]]:
    """The modules that people write."""
    for name, path in modules().items():
        if not path.read_text(encoding="utf-8").startswith(EMITTED):
            yield name, path, parsed(name)


def functions(tree: ast.Module) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef]:
    return (node for node in ast.walk(tree) if isinstance(node, _FUNCTIONS))


def depth(node: ast.AST) -> int:
    """How deep statements stand in one another; `elif` is no deeper than its `if`."""
    inner = (one for one in ast.iter_child_nodes(node) if not isinstance(one, (*_FUNCTIONS, ast.ClassDef)))
    return max((depth(one) + (isinstance(one, _NESTING) and not is_elif(node, one)) for one in inner), default=0)


def is_elif(outer: ast.AST, inner: ast.AST) -> bool:
    return isinstance(outer, ast.If) and isinstance(inner, ast.If) and outer.orelse == [inner]


def positional_records(tree: ast.Module) -> Iterator[str]:
    """Data classes of more fields than one may give by their order that do not ask for names."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.ClassDef):
            continue
        marks = [ast.unparse(one) for one in node.decorator_list if "dataclass" in ast.unparse(one)]
        fields = [one for one in node.body if isinstance(one, ast.AnnAssign) and "ClassVar" not in ast.unparse(one)]
        if marks and len(fields) > MOST_POSITIONAL and "kw_only=True" not in marks[0]:
            yield node.name


def test_files_are_short() -> None:
    lengths = {
        str(path): len(path.read_text(encoding="utf-8").splitlines())
        for name, path, _ in written()
        if package_of(name) not in WAITING
    }
    assert {path: length for path, length in lengths.items() if length > LONGEST_FILE} == {}


def test_functions_are_short_and_shallow() -> None:
    found = [
        f"{name}.{one.name}: {one.end_lineno - one.lineno + 1} lines, nested {depth(one)} deep"
        for name, _, tree in written()
        for one in functions(tree)
        if one.end_lineno and (one.end_lineno - one.lineno >= LONGEST_FUNCTION or depth(one) > DEEPEST)
    ]
    assert found == []


def test_long_records_are_built_by_name() -> None:
    found = [
        f"{name}.{record}"
        for name, _, tree in written()
        if package_of(name) not in WAITING
        for record in positional_records(tree)
    ]
    assert found == []


DEEP = """
def one(x):
    if x:
        pass
    elif x > 1:
        for y in x:
            with y:
                pass
"""


@pytest.mark.parametrize(
    ("text", "found"),
    [("@dataclass\nclass A:\n" + "".join(f"    {x}: int\n" for x in "abcde"), ["A"]),
     ("@dataclass(frozen=True, kw_only=True)\nclass A:\n" + "".join(f"    {x}: int\n" for x in "abcde"), []),
     ("@dataclass(frozen=True)\nclass A:\n" + "".join(f"    {x}: int\n" for x in "abcd"), [])],
)  # fmt: skip
def test_what_a_long_record_is(text: str, found: list[str]) -> None:
    assert list(positional_records(ast.parse(text))) == found


def test_how_depth_is_counted() -> None:
    (one,) = functions(ast.parse(DEEP))
    assert depth(one) == 3


def test_files_of_tests_that_begin_first_are_there() -> None:
    assert [name for name in LONG if not (ROOT / "tests" / name).is_file()] == []
