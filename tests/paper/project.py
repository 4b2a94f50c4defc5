"""What trueaxis derives from machines/dmu60p.toml, in the paper's symbols.

The one place where names are mapped: EXX is delta_x(x), EAX epsilon_x(x), ECY epsilon_z(y); x, y, z are x_h, y_h, z_h;
a tool or workpiece point is the paper's r_k or r_l less the offset q of its frame on its carriage.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.chain import chains, product
from trueaxis.derivation.first_order import FirstOrder, squarenesses
from trueaxis.derivation.motion import motion_equation
from trueaxis.machine import Machine, read_machine
from trueaxis.view import Carrier

from . import reference
from .notation import DIRECTIONS, POSITION, SQUARENESS, delta, eps, place, r, reading

MACHINE_FILE = Path(__file__).parents[2] / "machines" / "dmu60p.toml"
SENSES = {"EX": ("x", delta), "EY": ("y", delta), "EZ": ("z", delta)} | {
    "EA": ("x", eps),
    "EB": ("y", eps),
    "EC": ("z", eps),
}
Known = dict[sp.Symbol, sp.Expr]


@cache
def machine() -> Machine:
    """The paper's machine as the project reads it."""
    return read_machine(MACHINE_FILE)


@cache
def names() -> dict[sp.Symbol, sp.Symbol]:
    """The project's symbols -> the paper's."""
    result = {symbols.position(axis.upper()): POSITION[axis] for axis in DIRECTIONS}
    for component in machine().components:
        direction, make = SENSES[component[:2]]
        result[symbols.named(component)] = make(direction, component[2].lower())
    for name, symbol in zip(("eps_xy", "eps_xz", "eps_yz"), SQUARENESS, strict=True):
        result[symbols.named(name)] = symbol
    return result


def _on(end: str, point: str) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """A carriage point in the frame of tool or workpiece."""
    offset = "q_T" if end == "tool" else "q_w"
    x, y, z = (r(point, d) - sp.Symbol(offset + d, real=True) for d in DIRECTIONS)
    return x, y, z


def _total(motion: FirstOrder) -> list[sp.Expr]:
    sums = zip(motion.ideal, motion.deviation(), strict=True)
    return [sp.expand((ideal + deviation).xreplace(names())) for ideal, deviation in sums]


def displacement(run: str, tool_point: str | None, work_point: str | None) -> list[sp.Expr]:
    """The derived motion equation (bed frame) of a run."""
    both: tuple[tuple[Carrier, str | None], ...] = (("workpiece", work_point), ("tool", tool_point))
    ends = [(end, p) for end, p in both if p is not None]
    signs = (1, -1)
    terms = tuple((sign, end, _on(end, p)) for sign, (end, p) in zip(signs, ends, strict=False))
    return _total(motion_equation(machine(), tuple(run), terms).motion)


@cache
def readings(run: str) -> Known:
    """Every reading of a run, and the printed positions of r_l and r_k less their home."""
    result: Known = {}
    for label in reference.RUN_LABELS[run]:
        moved = displacement(run, *reference.point_names(run, label))
        result |= {reading(label, d): moved[n] for n, d in enumerate(DIRECTIONS)}
    for point, tool_point, work_point in (("k", "k", None), ("l", None, "l")):
        moved = displacement(run, tool_point, work_point)
        result |= {place(d, point, "h"): moved[n] for n, d in enumerate(DIRECTIONS)}
        result |= {place(d, point, "0"): sp.Integer(0) for d in DIRECTIONS}
    return result


@cache
def chain_places() -> Known:
    """P_lh, P_l0, P_kh, P_k0 from the project's factored chain, multiplied out; home has no motion errors."""
    workpiece, tool = (product(joints) for joints in chains(machine()))
    home = {symbols.position(axis): 0 for axis in machine().axes}
    home |= {symbols.named(component): 0 for component in machine().components}
    result: Known = {}
    for point, end, matrix in (("l", "workpiece", workpiece), ("k", "tool", tool)):
        moved = matrix * sp.Matrix([*_on(end, point), 1])
        for pose, vector in (("h", moved), ("0", moved.xreplace(home))):
            result |= {place(d, point, pose): sp.expand(vector[n].xreplace(names())) for n, d in enumerate(DIRECTIONS)}
    return result


def right_angles() -> dict[sp.Symbol, sp.Expr]:
    """pi/2 minus the angle between two axes, first order, by the squareness symbol that Eq. (43) gives for them."""
    pairs = {("X", "Y"): SQUARENESS[0], ("X", "Z"): SQUARENESS[1], ("Y", "Z"): SQUARENESS[2]}
    return {pairs[s.axes]: s.product.xreplace(names()) for s in squarenesses(machine())}


def known(run: str) -> Known | None:
    """What the project derives for a run; None where it derives nothing of the kind (Figs. 6-8, line fits)."""
    if run in reference.RUN_LABELS:
        return readings(run)
    if run == "chain":
        return dict(reference.known("chain")) | chain_places()
    return None
