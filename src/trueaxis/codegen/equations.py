"""equations.md: the derivation of one machine as a person reads it, on a page that GitHub renders.

Its table Notation has the signs that are neither errors nor dimensions of the machine.
"""

from collections.abc import Iterator, Mapping
from functools import partial
from typing import Any

import sympy as sp

from trueaxis.codegen.chain_section import DRAWS, Row, chain_texts, dropped_terms
from trueaxis.codegen.effect_section import effect_symbols, effect_texts
from trueaxis.codegen.latex import WIDEST, Latex, broken, joined, width
from trueaxis.codegen.meta import ABI, spec_name
from trueaxis.codegen.paper_layout import TITLE, beside
from trueaxis.codegen.paper_notation import kinds_of_table_1
from trueaxis.codegen.paper_section import is_the_papers, paper_part
from trueaxis.codegen.system_section import combination_text, motion_text, system_text
from trueaxis.codegen.templates import environment
from trueaxis.derivation import symbols
from trueaxis.derivation.first_order import first_order
from trueaxis.derivation.model import DerivedModel
from trueaxis.derivation.views import view
from trueaxis.machine.machine import ROTARY, Body, Machine
from trueaxis.machine.topology import lower_body_array, tool_senses

_NAMES = 9.0  # em, of the first two columns of the table of sensitivities
Entry = tuple[str, str]  # sign, meaning

_PAPER: tuple[Entry, ...] = (
    ("$h$", "number of a given position; $h = 0$ at home"),
    ("$x_h$, $y_h$, $z_h$", "positions of X, Y, Z there, mm"),
    (
        "$P_{lh}$, $P_{kh}$",
        "points of worktable and tool in the bed frame, $(x_{lh}, y_{lh}, z_{lh}, 1)^T$ and $k$ alike",
    ),
    (
        "$r_l$, $r_k$",
        "the same points in the frames of the Y and the Z carriage, mm; coordinates $r_{lx}$, $r_{ky}$, ...",
    ),
    ("$r_W$, $r_T$", "the same points in the workpiece frame (WCS) and the tool frame (TCS), mm; $r_T$ is $P_T$"),
    ("$r_{k1}$, $r_{l4}$, ...", "points of the runs, with their numbers; point $i$ is any of them"),
    (
        "$S^l_{lh}$, $S^l_{jh}$, $S^l_{kh}$",
        "ideal motion of the Y, X and Z carriage: the translation in their $[SIJ]_s$",
    ),
    ("$L_{1xh}$", "displacement read at point 1 along x, from home to position $h$, mm"),
    ("$\\delta_{ih}$, $\\theta$", "straightness of a linkage line, mm, and its angle in its plane, rad"),
    ("$b_k$", "right-hand side of row $k$ of a system"),
    ("$u$, $v$", "two of the directions x, y, z: $v$ along an axis, $u$ across it"),
    ("$v_i$, $n$", "the $i$-th of the $n$ given positions of axis $v$, mm; $v_0 = 0$ is home"),
    ("$P_{uv}$, $P_{uvi}$", "offset in direction $u$ of the line of axis $v$, at position $h$ and at $v_i$, mm"),
    ("$`P'_{uv}`$, $c_{uv0}$, $c_{uv1}$", "straight line fitted to $P_{uv}$, its offset (mm) and slope"),
)

_SYSTEMS: tuple[Entry, ...] = (
    ("$L_k$, $b_k$", "reading $k$ of a system, less that of the error-free machine, and its right-hand side, mm"),
    ("$r_{T1}$, $r_{W1}$, ...", "points of the runs on the tool and on the workpiece, in their frames, mm"),
)

_MOTIONS: tuple[Entry, ...] = (
    ("$r_W$, $r_T$", "points in the workpiece frame and in the tool frame, mm"),
    (r"$\Delta x$, $\Delta y$, $\Delta z$", "displacement since home; under Compensation moves of the linear axes, mm"),
)


def equations_page(model: DerivedModel, spec: str = "") -> str:
    """The text of equations.md; spec: how it is named there."""
    return environment().get_template("equations.md.j2").render(page_context(model, spec))


def page_context(model: DerivedModel, spec: str = "") -> dict[str, Any]:
    """The variables of equations.md.j2."""
    machine = model.machine
    latex = Latex(machine)
    paper = is_the_papers(model)
    return {
        "spec": spec or spec_name(machine),
        "digest": machine.digest,
        "abi": ABI,
        "title": machine.title,
        "paper_title": TITLE,
        "paper": paper_part(model) if paper else None,
        "beside": partial(beside, linked=paper),
        "turning": any(axis in ROTARY for axis in machine.axes),
        "bodies": list(lower_body_array(machine)),
        "body_rows": [_body_row(body) for body in machine.bodies],
        "symbols": _symbols(machine, paper=paper),
        "not_in_files": [
            s(axis).name for axis in machine.axes if axis in ROTARY for s in (symbols.cosine, symbols.sine)
        ],
        "notation": list(_notation(model, paper=paper)),
        "true_rotation": machine.true_rotation,
        "chain": chain_texts(machine, latex),
        "dropped": _dropped(model),
        "sensitivities": _sensitivities(machine, latex),
        "squareness": [("".join(s.axes), latex(s.product)) for s in model.squareness],
        "opposite": ["".join(s.axes) for s in model.squareness if _opposite(machine, s.axes)],
        "correction": _correction(model, latex),
        "effects": effect_texts(machine),
        "effect_symbols": effect_symbols(machine),
        "kernels": [(f"`{r.name}`", _operations(r.operations, r.batch_operations), r.summary) for r in model.routines],
        **_systems(model, latex),
    }


def _systems(model: DerivedModel, latex: Latex) -> dict[str, Any]:
    machine, found = model.machine, model.identification
    references = dict(machine.references)
    runs = {run.name: run for run in model.runs}
    return {
        "motions": [motion_text(equation, latex, references) for equation in model.motions],
        "systems": [system_text(machine, k, s, runs, latex) for k, s in enumerate(found.systems)] if found else [],
        "undetermined": [combination_text(machine, c) for c in found.combinations] if found else [],
        "unseen": ", ".join((*found.unseen, *found.unreached)) if found else "",
    }


def _symbols(machine: Machine, *, paper: bool) -> list[tuple[str, str, str, str]]:
    """Rows of LaTeX, name, unit and meaning; pitch and yaw of the paper's machine are told apart by its Table 1."""
    kinds = kinds_of_table_1() if paper else {}
    return [
        (text.latex, name, text.unit, kinds.get(name, text.description))
        for name, text in symbols.describe(machine).items()
    ]


def _body_row(body: Body) -> tuple[object, ...]:
    located = ", ".join(f"{direction} = {linked(parameter)}" for direction, parameter in body.position_errors)
    moved = " ".join(linked(name) for name in body.motion_errors)
    return body.number, body.name, body.lower, body.moves or "-", moved or "-", located or "-"


def _opposite(machine: Machine, axes: tuple[str, str]) -> bool:
    """Whether one of two linear axes moves the workpiece and the other the tool."""
    senses = tool_senses(machine)
    return sum(senses[axis] == -machine.mover(axis).sense for axis in axes) == 1


def linked(name: str) -> str:
    """A symbol by its name in files, with a link to its row in the table of symbols."""
    return f"[`{name}`](#{name})"


def _sensitivities(machine: Machine, latex: Latex) -> list[tuple[str, ...]]:
    columns = first_order(view(machine, "tool_in_workpiece"), symbols.point()).columns
    rows = [(n, latex.symbol(n), *(joined(latex.terms(entry)) for entry in column)) for n, column in columns.items()]
    if max(sum(width(cell) for cell in row[2:]) for row in rows) > WIDEST - _NAMES:
        return []  # the coefficients stand in the equation above
    return [(name, *(f"${cell}$" for cell in cells)) for name, *cells in rows]


def _correction(model: DerivedModel, latex: Latex) -> list[Row]:
    body = next((routine.body for routine in model.routines if routine.name == "correction"), ())
    moves = {f"move_{axis.lower()}": rf"\Delta {axis.lower()}" for axis in model.machine.axes}
    own = latex.with_names(moves | {f"d{axis}": f"d_{axis}" for axis in "xyz"})
    values: dict[sp.Symbol, sp.Expr] = {}
    for target, value in body:
        values[target] = value.xreplace(values)  # the kernel's shared subexpressions written out
    return [broken(moves[t.name], own.terms(value)) for t, value in values.items() if t.name in moves]


def _dropped(model: DerivedModel) -> Mapping[str, str]:
    found = dropped_terms(model.machine, model.routines)
    sizes = {"deviation": found.deviation, "rms": found.rms, "largest": found.largest}
    return {name: f"{float(f'{size:.2g}'):g}" for name, size in sizes.items()} | {"draws": str(DRAWS)}


def _operations(per_point: int, per_call: int) -> str:
    return f"{per_point} ({per_call})" if per_call else f"{per_point}"


def _notation(model: DerivedModel, *, paper: bool) -> Iterator[Entry]:
    """The entries of a page."""
    machine = model.machine
    yield "$I$, $J$", "a body and the body that stands on it: $[SIJ]$ takes coordinates in $J$ to coordinates in $I$"
    yield "$[SBW]$, $[SBT]$, $[SBk]$", _ends(machine)
    yield "$M$", "error-free transform from the tool frame to the workpiece frame"
    yield (
        r"$\Theta_k$, $D_k$",
        "small rotation (rad) and displacement (mm) of body $k$ in the bed frame, by all errors below it",
    )
    yield (
        "motion errors, location errors",
        "the error motions of an axis and the constant errors of its place (ISO 230-1)",
    )
    yield "view", "a point of one body in the frame of another: `tool_in_bed` is a point of the tool in the bed frame"
    yield "$P_T$, $P_T^W$", _tool_point(paper)
    yield "$P$", "error-free tool point in the bed frame"
    yield (
        "$d$",
        "deviation of the tool point in the workpiece frame, mm; under Compensation the displacement that is wanted",
    )
    yield (
        "$P_W$, $P_E$, $l_1$",
        "workpiece ball of a ball bar, vector from it to the tool ball, ideal length of the bar, mm",
    )
    yield "$E$, $E_v$", "positioning error along the bar and its vector, mm"
    if paper:
        yield from _PAPER
        yield r"$\Delta P$", "displacement since home (11)"
        yield r"$\Delta x$, $\Delta y$, $\Delta z$", "moves of the linear axes, mm"
        return
    yield from _MOTIONS
    if model.identification and model.identification.systems:
        yield from _SYSTEMS


def _ends(machine: Machine) -> str:
    return (
        f"$B$ is the bed (body 1), $W$ the workpiece (body {machine.workpiece}), $T$ the tool (body {machine.tool}), "
        "$k$ any body"
    )


def _tool_point(paper: bool) -> str:
    own = ", in the paper $(X_T, Y_T, Z_T, 1)^T$" if paper else ""
    return f"a point in the tool frame, $(r_x, r_y, r_z, 1)^T${own}, and the same point in the workpiece frame"
