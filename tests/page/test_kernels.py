"""What the page says of the kernels, carried out: readings and points by its sentences, unknowns in its order."""

import re
from functools import cache
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from tests.machines import ROOT
from tests.page.chain_names import AXES, Names
from tests.page.latex_value import names_in, value_of
from tests.page.pages import derived, names, page
from tests.page.paper_names import RUNS
from trueaxis.codegen.c_source import c_header
from trueaxis.codegen.numpy_source import numpy_source

LINE = re.compile(
    r"- `(system_\d)` takes the displacements less those of the error-free machine, (.*), and the points in TCS and "
    r"WCS, (.*); it returns (.*?)( in this order)?\."
)
ERRORS = {
    f"\\{kind}_{d}({axis.lower()}_h)": f"E{'XYZABC'[n + turn]}{axis}"
    for axis in "XYZ"
    for kind, turn in (("delta", 0), ("varepsilon", 3))
    for n, d in enumerate(AXES)
}


@cache
def module() -> ModuleType:
    kernels = ModuleType("kernels")
    exec(numpy_source(derived("dmu60p").machine, derived("dmu60p").routines), kernels.__dict__)
    return kernels


def sentences(text: str) -> list[tuple[int, str, list[str], list[str], list[str]]]:
    """Equation, kernel, readings, points with their names in the kernel, unknowns."""
    found = []
    number = 0
    for line in text.splitlines():
        if heading := re.match(r"### Eq. \((\d+)\)", line):
            number = int(heading[1])
        if taken := LINE.fullmatch(line):
            readings, points, unknowns = (taken[k].split(", ") for k in (2, 3, 4))
            found.append((number, taken[1], readings, points, unknowns))
    return found


def carried_out(kernels: ModuleType, text: str) -> dict[str, float]:
    """For each kernel the largest difference between what it returns and the errors that the readings were made of."""
    off: dict[str, float] = {}
    own = names("dmu60p")
    meta = kernels.META
    errors = np.array([[own.values[name]] for name in meta["components"]])
    parameters = np.array([own.values[name] for name in meta["parameters"]])
    positions = np.array([[own.values[axis.lower()]] for axis in meta["axes"]])
    for number, kernel, readings, points, unknowns in sentences(text):
        known = own._run(RUNS[number], number)  # type: ignore[attr-defined]
        expected = [known[re.sub(r"[{}$]", "", name)] for name in unknowns]
        rows = meta["routines"][kernel]
        # The unknowns of the call are none of what it is told: their rows of `errors` are spoiled.
        told = errors.copy()
        for name in unknowns:
            told[meta["components"].index(ERRORS[re.sub(r"[{}$]", "", name)])] = np.nan
        given = np.array([[value_of(text.strip("$"), names_in(known))] for text in readings])
        at = np.array([_point(text, known) for text in points])
        assert list(at.shape) == next(a["shape"] for a in rows["inputs"] if a["name"] == "points")
        solved = getattr(kernels, kernel)(given, positions, told, parameters, at)
        off[f"({number}) {kernel}"] = float(np.nan_to_num(np.abs(solved[:, 0] - expected), nan=np.inf).max())
    return off


def _point(text: str, known: Names) -> list[float]:
    """`r_{k1} - q_T` (`rT1`), by coordinates."""
    found = re.fullmatch(r"\$`(r\S*)_\{(\w+)\} - (q_[Tw])`\$ \(`(r[TW]\d+)`\)", text)
    assert found, text
    above, label, home, _ = found.groups()
    above = re.sub(r"[{}]", "", above)
    return [known[f"{above}_{label}{a}"] - known[f"{home}{a}"] for a in AXES]


def test_the_page_s_rules_give_the_errors() -> None:
    off = carried_out(module(), page("dmu60p"))
    assert [name.split("_")[1] for name in off] == list("123456798")
    assert {kernel: size for kernel, size in off.items() if not size < 1e-9} == {}


SLIPS: dict[str, tuple[str, str]] = {
    "number of a kernel": ("`system_1` takes", "`system_2` takes"),
    "the whole displacement": ("$L_{1xh} - x_h$, $L_{2xh} - x_h$, $L_{3xh} - x_h$", "$L_{1xh}$, $L_{2xh}$, $L_{3xh}$"),
    "sign of the error-free part": ("$L_{1xh} + x_h$", "$L_{1xh} - x_h$"),
    "order of the unknowns": (
        r"$\varepsilon_{y}(z_h)$, $\varepsilon_{x}(z_h)$ in",
        r"$\varepsilon_{x}(z_h)$, $\varepsilon_{y}(z_h)$ in",
    ),
    "points exchanged": (
        "$`r^{XZ}_{k1} - q_T`$ (`rT7`), $`r^{XZ}_{k2}",
        "$`r^{XZ}_{k2} - q_T`$ (`rT7`), $`r^{XZ}_{k1}",
    ),
    "points in a carriage's frame": ("$`r^{YZ}_{l1} - q_w`$", "$`r^{YZ}_{l1} - q_T`$"),
    "kernels exchanged": ("it returns $\\delta_{y}(z_h)$", "it returns $\\delta_{z}(y_h)$"),
}


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_in_these_sentences_is_caught(slip: str) -> None:
    right, wrong = SLIPS[slip]
    assert right in page("dmu60p")
    assert max(carried_out(module(), page("dmu60p").replace(right, wrong)).values()) > 1e-3


def test_names_of_points_are_those_of_the_kernels() -> None:
    kernels = module()
    for _, kernel, _, points, unknowns in sentences(page("dmu60p")):
        doc = " ".join(getattr(kernels, kernel).__doc__.split())
        named = [re.findall(r"`(r[TW]\d+)`", point)[0] for point in points]
        assert f"rows: {' '.join(f'{name}{a}' for name in named for a in AXES)} Returns" in doc
        errors = [ERRORS[re.sub(r"[{}$]", "", name)] for name in unknowns]
        assert f"rows: {' '.join(f'identified_{name}' for name in errors)}" in doc


def test_header_docstring_and_document_state_the_convention() -> None:
    model = derived("dmu60p")
    header = " ".join(c_header(model.machine, model.routines).replace("\n * ", " ").split())
    documents = [header, " ".join(module().system_1.__doc__.split())]
    documents.append(" ".join((ROOT / "docs" / "kernels.md").read_text(encoding="utf-8").split()))
    assert all(re.search("displacements? .{0,60}less (those|that) of the error-free machine", t) for t in documents)


def test_the_paper_s_points_of_z_divide_by_zero() -> None:
    """E33: Python raises, C has no finite number (the document says so); the docstring gives the rank."""
    kernels = module()
    at = [[-100.0, -77.0, 125.0], [-54.0, -72.0, 125.0], [-54.0, -72.0, -165.0]]
    arguments: list[Any] = [np.zeros((rows, 1)) for rows in (3, 3, 18)]
    with pytest.raises(ZeroDivisionError):
        kernels.system_3(*arguments, np.zeros(9), at)
    assert "the rank is 2: division by zero" in kernels.system_3.__doc__
    assert "rank" not in kernels.system_1.__doc__
