"""The sections of equations.md on the chain: factors, products body by body, the tool point, what first order drops.

How large that is, for errors of the sizes that are expected before anything is measured, the emitted kernels
themselves say: the exact deviation less the one to first order.
"""

import itertools
import random
from collections.abc import Iterator
from dataclasses import dataclass
from types import ModuleType

import numpy as np
import numpy.typing as npt
import sympy as sp

from trueaxis.codegen.latex import WIDEST, Latex, block_width, broken
from trueaxis.codegen.numpy_source import module_source
from trueaxis.derivation import symbols
from trueaxis.derivation.chain import Joint, Vector, chains, matrix, times
from trueaxis.derivation.first_order import BranchStep, Columns, FirstOrder, branch_steps, first_order
from trueaxis.derivation.products import multiplied_out
from trueaxis.derivation.routine import Routine
from trueaxis.derivation.views import view
from trueaxis.machine.machine import ROTARY, Machine
from trueaxis.machine.prior import Prior

AXES = ("x", "y", "z")
_PARTS = ("p", "pe", "s", "se")
Row = str  # of an `aligned` block
FloatArray = npt.NDArray[np.float64]
DRAWS = 64  # sets of signs: every error has its expected size, its sign is drawn
DIMENSION = 100.0  # mm, of every home position: the spec names them and gives no numbers
_EXACT, _FIRST = "tool_in_workpiece_deviation", "tool_in_workpiece_deviation_first_order"


@dataclass(frozen=True)
class JointText:
    """One joint: its factors that are no unit matrix, and their product."""

    title: str
    factors: tuple[tuple[str, str], ...]
    product: tuple[Row, ...]


@dataclass(frozen=True)
class StepText:
    """One step of a branch: the error-free product, and what the joint adds to rotation and displacement."""

    title: str
    ideal: tuple[Row, ...]
    added: tuple[Row, ...]
    same_as: str


@dataclass(frozen=True, kw_only=True)
class BranchText:
    """One branch: its name in the paper, the product of its factors, its steps."""

    name: str
    number: str
    end: int
    product: tuple[Row, ...]
    steps: tuple[StepText, ...]


@dataclass(frozen=True, kw_only=True)
class ChainTexts:
    """Everything that the template prints of the chain."""

    joints: tuple[JointText, ...]
    branches: tuple[BranchText, ...]
    relative: tuple[Row, ...]
    in_bed: tuple[Row, ...]
    turned: tuple[Row, ...]
    workpiece_turns: bool
    position: tuple[Row, ...]


def chain_texts(machine: Machine, latex: Latex) -> ChainTexts:
    """The sections on the chain of a machine."""
    workpiece, tool = chains(machine)
    sides = branch_steps(workpiece), branch_steps(tool)
    joints = {part.body.number: part for part in workpiece + tool}
    main = first_order(view(machine, "tool_in_workpiece"), symbols.point())
    ends = [side[-1].ideal if side else sp.eye(4) for side in sides]
    point = ends[1] * sp.Matrix([*symbols.point(), 1])
    return ChainTexts(
        joints=tuple(_joint(part, latex) for part in joints.values()),
        branches=tuple(
            _branch(name, number, side, latex)
            for name, number, side in (("[SBW]", "(2)", sides[0]), ("[SBT]", "(3)", sides[1]))
        ),
        relative=tuple(matrix_rows("M", _pose(main.ideal), latex, "M_{{{}}}")),
        in_bed=tuple(broken(f"P_{row}", latex.terms(point[i])) for i, row in enumerate(AXES)),
        turned=tuple(_turned(ends[0][:3, :3].T, latex)),
        workpiece_turns=ends[0][:3, :3] != sp.eye(3),
        position=tuple(_position(machine, main, latex)),
    )


def _position(machine: Machine, main: FirstOrder, latex: Latex) -> Iterator[Row]:
    """The tool point with its deviation; by M and d where an axis turns: written out it would fill two pages."""
    turning = any(axis in ROTARY for axis in machine.axes)
    ideal = _pose(main.ideal)
    for i, row in enumerate(AXES):
        if turning:
            held = [k for k in range(4) if ideal[i, k] != 0]
            terms = [f"M_{{{i + 1}{k + 1}}} r_{{{AXES[k]}}}" if k < 3 else f"M_{{{i + 1}4}}" for k in held]
            terms.append(f"d_{{{row}}}")
            yield f"P^W_{{T{row}}} &= " + " + ".join(terms)
        else:
            deviation = latex.linear({name: column[i] for name, column in main.columns.items()})
            yield broken(f"P^W_{{T{row}}}", latex.terms(main.ideal[i]) + deviation)


def _pose(ideal: Vector) -> sp.Matrix:
    """The matrix that takes the point to its ideal place."""
    result = sp.eye(4)
    result[:3, :3] = sp.Matrix(ideal).jacobian(symbols.point())
    result[:3, 3] = sp.Matrix(ideal).xreplace(dict.fromkeys(symbols.point(), sp.S.Zero))
    return result.applyfunc(multiplied_out)


def matrix_rows(name: str, value: sp.Matrix, latex: Latex, element: str) -> Iterator[Row]:
    """A 4x4 matrix as one row `name &= matrix`; where it is too wide, its three upper rows element by element.

    element: the name of an element, with {} for its row and column.
    """
    text = latex(value)
    if block_width(f"{name} = {text}") <= WIDEST:
        yield f"{name} &= {text}"
        return
    for row in range(3):
        for column in range(4):
            yield broken(element.format(f"{row + 1}{column + 1}"), latex.terms(value[row, column]))


def factor_name(joint: Joint) -> str:
    """`[S12]`."""
    return f"[S{joint.body.lower}{joint.body.number}]"


def _joint(part: Joint, latex: Latex) -> JointText:
    name = factor_name(part)
    values = [(f"{name}_{{{n}}}", matrix(step)) for n, step in zip(_PARTS, part.steps, strict=True)]
    kept = [(each, value) for each, value in values if value != sp.eye(4)]
    product = sp.eye(4)
    for _, value in kept:
        product = times(product, value)
    rows = tuple(matrix_rows(name, product, latex, name + "_{{{}}}")) if len(kept) > 1 else ()
    title = f"Body {part.body.number}, {part.body.name}, on body {part.body.lower}"
    return JointText(title, tuple((each, latex(value)) for each, value in kept), rows)


def _branch(name: str, number: str, steps: tuple[BranchStep, ...], latex: Latex) -> BranchText:
    factors = [f"{factor_name(step.joint)}_{{{index}}}" for step in steps for index in _PARTS]
    texts: list[StepText] = []
    before = 1
    for step in steps:
        texts.append(_step(step, before, latex))
        before = step.joint.body.number
    product = broken(name, [f"\\,{factor}" for factor in factors] or ["1"]).replace("&= \\,", "&= ")
    return BranchText(name=name, number=number, end=before, product=(product,), steps=tuple(texts))


def _step(step: BranchStep, before: int, latex: Latex) -> StepText:
    number = step.joint.body.number
    added: list[Row] = []
    for letter, columns in ((r"\Theta", step.rotation), ("D", step.displacement)):
        for i, row in enumerate(AXES):
            start = [f"+ {letter}_{{{before},{row}}}"] if before != 1 else []
            if change := latex.linear(_entry(columns, i)):
                added.append(broken(f"{letter}_{{{number},{row}}}", start + change))
            elif step.rotation or step.displacement:
                added.append(broken(f"{letter}_{{{number},{row}}}", start))
    same = "" if added else f"$\\Theta_{{{number}}} = \\Theta_{{{before}}}$, $D_{{{number}}} = D_{{{before}}}$"
    if not added and before == 1:
        same = f"$\\Theta_{{{number}}} = 0$, $D_{{{number}}} = 0$"
    ideal = tuple(matrix_rows(f"[SB{number}]_0", step.ideal, latex, f"[SB{number}]_" + "{{0,{}}}"))
    return StepText(f"Body {number}, {step.joint.body.name}", ideal, tuple(added), same)


def _entry(columns: Columns, row: int) -> dict[str, sp.Expr]:
    return {name: multiplied_out(column[row]) for name, column in columns.items()}


def _turned(back: sp.Matrix, latex: Latex) -> Iterator[Row]:
    """The deviation of the tool point by Theta, D and P, turned into the workpiece frame."""
    theta = sp.symbols("_Theta_x _Theta_y _Theta_z", real=True)
    moved = sp.symbols("_D_x _D_y _D_z", real=True)
    at = sp.symbols("_P_x _P_y _P_z", real=True)
    vector = sp.Matrix(moved) + sp.Matrix(theta).cross(sp.Matrix(at))
    names = {
        f"_{letter}_{a}": f"{text}_{a}" for letter, text in (("Theta", r"\Theta"), ("D", "D"), ("P", "P")) for a in AXES
    }
    own = latex.with_names(names)
    for i, row in enumerate(AXES):
        yield broken(f"d_{row}", own.terms((back * vector)[i]))


@dataclass(frozen=True)
class DroppedTerms:
    """Micrometres, over all drawn signs and the corners and the middle of the travels: rms of the deviation to first
    order, rms and largest length of what it lacks.
    """

    deviation: float
    rms: float
    largest: float


def dropped_terms(machine: Machine, routines: tuple[Routine, ...]) -> DroppedTerms:
    """The size of the dropped terms at the tool frame's origin, errors of the default sizes of [prior]."""
    module = ModuleType("kernels")
    used = tuple(routine for routine in routines if routine.name in (_EXACT, _FIRST))
    exec(module_source(used, {}, digest="", spec="", command="", title="", turning=False), module.__dict__)
    positions = _positions(machine)
    drawn = random.Random(1)
    prior = Prior()  # not the spec's own: editing [prior] asks for no new files
    exact, first = [], []
    for _ in range(DRAWS):
        errors = [drawn.choice((-1, 1)) * prior.of_component(name) for name in machine.components]
        parameters = [DIMENSION] * len(machine.dimensions)
        parameters += [
            drawn.choice((-1, 1)) * prior.of_location(name, machine.parameter_unit(name))
            for name in machine.location_errors
        ]
        arguments = (positions, np.array(errors)[:, None], np.array(parameters), np.zeros((3, 1)))
        exact.append(getattr(module, _EXACT)(*arguments))
        first.append(getattr(module, _FIRST)(*arguments))
    lengths = np.linalg.norm(np.array(exact) - np.array(first), axis=1)
    deviation = np.linalg.norm(np.array(first), axis=1)
    return DroppedTerms(1e3 * _rms(deviation), 1e3 * _rms(lengths), 1e3 * float(lengths.max()))


def _positions(machine: Machine) -> FloatArray:
    corners = list(itertools.product(*(machine.travel[axis] for axis in machine.axes)))
    middle = [sum(machine.travel[axis]) / 2 for axis in machine.axes]
    return np.array([*corners, middle]).T


def _rms(lengths: FloatArray) -> float:
    return float(np.sqrt(np.mean(lengths**2)))
