"""Tables 1, 3, 4 and 5 of the paper, for the page of its machine."""

from collections.abc import Iterator
from dataclasses import dataclass

from trueaxis.codegen.latex import Latex
from trueaxis.derivation import symbols
from trueaxis.derivation.chain import chains, matrix
from trueaxis.derivation.model import DerivedModel
from trueaxis.machine.machine import Machine

_TABLE_1 = (
    ("positioning error", ("EXX", "EYY", "EZZ")),
    ("straightness error, x direction", ("", "EXY", "EXZ")),
    ("straightness error, y direction", ("EYX", "", "EYZ")),
    ("straightness error, z direction", ("EZX", "EZY", "")),
    ("roll error", ("EAX", "EBY", "ECZ")),
    ("pitch error", ("EBX", "EAY", "EAZ")),
    ("yaw error", ("ECX", "ECY", "EBZ")),
    ("XY perpendicularity error", ("eps_xy", "", "")),
    ("XZ perpendicularity error", ("eps_xz", "", "")),
    ("YZ perpendicularity error", ("eps_yz", "", "")),
)


@dataclass(frozen=True)
class Table1:
    """Axes, and rows of a name and three cells."""

    axes: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def kinds_of_table_1() -> dict[str, str]:
    """`yaw error of X` for each rotation of an axis."""
    turns = [(kind, errors) for kind, errors in _TABLE_1 if kind in ("roll error", "pitch error", "yaw error")]
    return {name: f"{kind} of {axis}" for kind, errors in turns for axis, name in zip("XYZ", errors, strict=True)}


def table_1(machine: Machine) -> Iterator[tuple[str, ...]]:
    """Rows of Table 1: a name, then the errors of the axes X, Y, Z, linked to the table of symbols."""
    texts = symbols.describe(machine)
    for title, errors in _TABLE_1:
        yield title, *(f"${texts[name].latex}$ [`{name}`](#{name})" if name else "" for name in errors)


def table_3(patterns: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Rows of Table 3: the ideal motion of bodies L, J and K in each pattern, without the fourth element, 1."""
    for letter, axis in (("l", "Y"), ("j", "X"), ("k", "Z")):
        cells = [[f"{a.lower()}_h" if a == axis and axis in moving else "0" for a in "XYZ"] for moving in patterns]
        yield f"$S^l_{{{letter}h}}$", *(f"$({', '.join(cell)})$" for cell in cells)


def position_errors(machine: Machine, latex: Latex) -> Iterator[str]:
    """[SIJ]_pe and [SJK]_pe of Table 3, the position errors of the X and the Z carriage."""
    for axis in "XZ":
        (error,) = (step for joint in chains(machine)[1] if joint.body.moves == axis for step in joint.steps[1:2])
        yield latex(matrix(error))


def points(model: DerivedModel) -> Iterator[tuple[str, str, str, str]]:
    """Points of Tables 4 and 5: name, coordinates, frame, runs."""
    found: dict[tuple[str, str, str], list[str]] = {}
    for run in model.runs:
        pattern, _, label = run.name.partition("-")
        above = f"^{{{pattern}}}" if len(pattern) > 1 else ""
        for body, at in (run.target, run.reference):
            if body != "bed":
                letter, frame = ("k", "TCS") if body == "tool" else ("l", "WCS")
                key = (f"$P{above}_{{{letter}{label[0]}}}$", f"({', '.join(f'{c:g}' for c in at)})", frame)
                found.setdefault(key, []).append(run.name)
    for key, runs in found.items():
        yield *key, ", ".join(runs)
