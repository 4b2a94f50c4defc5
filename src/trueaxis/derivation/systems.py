"""Identification systems: from a set of runs to linear systems, in the order in which they can be solved.

Every run gives one equation per position: its reading as a linear form of the component errors of the axes that
move (first order). Which unknown each equation holds decides the blocks and their order (`trueaxis.blocks`).
Location errors are taken as known here, as in Sects. 3.3-3.5 of the paper; `undetermined` says what that hides.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from trueaxis.blocks import solution_order
from trueaxis.derivation import symbols
from trueaxis.derivation.chain import Vector
from trueaxis.derivation.motion import MotionEquation, motion_equation
from trueaxis.derivation.products import multiplied_out
from trueaxis.error_name import DIRECTIONS, ErrorName
from trueaxis.machine.machine import ROTARY, Machine
from trueaxis.view import Carrier, Frame

Point = tuple[float, float, float]

_LARGEST_CLOSED_FORM = 4  # unknowns; the entries of an inverse grow beyond reading, and beyond minutes at six
# Poses of rotary axes in rational numbers: t = tan(angle / 2).
_HALF_TANGENTS = (sp.Rational(1, 2), sp.Rational(1, 3), sp.Rational(3, 4))


@dataclass(frozen=True, kw_only=True)
class RunPattern:
    """What a laser or probe run senses: the axes that move, and the two points, each (body, coordinates in mm)."""

    name: str
    moves: tuple[str, ...]
    direction: tuple[float, float, float]
    frame: Frame
    target: tuple[Carrier, Point]
    reference: tuple[Carrier, Point]


@dataclass(frozen=True, kw_only=True)
class IdentificationSystem:
    """matrix * unknowns = reading - known, solved: unknowns = adjugate * (reading - known) / determinant.

    adjugate, determinant: None if the matrix is not square or has more than four rows; numbers are no harder to solve
    then, formulas are. points: for each point symbol triple the body and the coordinates that the runs give it. rank:
    of the matrix at those points, exact; less than the number of unknowns where the points leave the system singular.
    """

    runs: tuple[str, ...]
    moves: tuple[tuple[str, ...], ...]
    unknowns: tuple[str, ...]
    matrix: sp.Matrix
    known: tuple[sp.Expr, ...]
    adjugate: sp.Matrix | None
    determinant: sp.Expr | None
    points: tuple[tuple[Vector, Carrier, Point], ...]
    rank: int

    @cached_property
    def inverse(self) -> sp.Matrix | None:
        """Adjugate / determinant."""
        return (
            None if self.adjugate is None else self.adjugate.applyfunc(lambda entry: entry and entry / self.determinant)
        )


@dataclass(frozen=True)
class Identification:
    """Systems in the order of solution; `unreached`: components that the runs hold but cannot give."""

    systems: tuple[IdentificationSystem, ...]
    unreached: tuple[str, ...]
    unseen: tuple[str, ...]
    combinations: tuple[dict[str, sp.Rational], ...]


def identification(machine: Machine, runs: Sequence[RunPattern]) -> Identification:
    """The systems of a set of runs. Deterministic: ties are broken by the order of the runs."""
    unknowns = [name for name in machine.components if any(name.axis in run.moves for run in runs)]
    readings = [_reading(machine, run, _labels([run])[0]) for run in runs]
    row_of: dict[str, int] = {name: row for row, name in enumerate(unknowns)}
    held = [[row_of[name] for name in reading if name in row_of] for reading in readings]
    order = solution_order(held, len(unknowns))
    labels, _ = _labels(runs)  # of all runs together: a point has one name in all systems
    systems = tuple(
        _system(machine, [runs[e] for e in block.equations], in_order(unknowns[u] for u in block.unknowns), labels)
        for block in order.blocks
    )
    seen = {name for reading in readings for name in reading}
    unreached = tuple(unknowns[u] for u in order.undetermined if unknowns[u] in seen)
    unseen = tuple(name for name in machine.components if name not in seen)
    return Identification(systems, unreached, unseen, undetermined(machine, runs))


def in_order(unknowns: Iterable[ErrorName]) -> list[ErrorName]:
    """Unknowns in the paper's order, Eqs. (15)-(34): displacements along X, Y, Z, then rotations about Z, Y, X."""
    return sorted(unknowns, key=lambda name: (name.is_rotation, _rank(name)))


def _rank(name: ErrorName) -> int:
    rank = DIRECTIONS.index(name.direction)
    return -rank if name.is_rotation else rank


def undetermined(machine: Machine, runs: Sequence[RunPattern]) -> tuple[dict[str, sp.Rational], ...]:
    """Combinations that leave every reading as it is: a basis of the null space, exact, at the runs' points.

    The axes of a run move together, so that each position gives one equation per run. Per unit of a location error,
    a component of a linear axis is given as the slope (per mm) by which its curve would change, one of a rotary axis
    as its change at one pose; combinations without a location error hold at every position by themselves.
    """
    moved = [name for name in machine.components if any(name.axis in run.moves for run in runs)]
    location = list(machine.location_errors)
    rotary = any(axis in ROTARY for run in runs for axis in run.moves)
    # The effect of a location error is linear in positions, so that one tells of all, but not in angles: there it must
    # be taken up at several poses, the components free at each.
    poses = [_pose(machine, k) for k in range(len(_HALF_TANGENTS) if rotary else 1)]
    rows: list[list[sp.Expr]] = []
    for index, pose in enumerate(poses):
        scale: dict[str, sp.Expr] = {name: pose.get(symbols.position(name.axis), sp.S.One) for name in moved}
        for run in runs:
            labels, points = _labels([run])
            reading = _reading(machine, run, labels)
            values = point_values(points) | pose
            entries = {name: value.xreplace(values) * scale.get(name, 1) for name, value in reading.items()}
            row = [sp.S.Zero] * (len(moved) * len(poses))
            row[index * len(moved) : (index + 1) * len(moved)] = [entries.get(name, sp.S.Zero) for name in moved]
            rows.append(row + [entries.get(name, sp.S.Zero) for name in location])
    if not rows:
        return ()
    found: list[dict[str, sp.Rational]] = []
    for vector in sp.Matrix(rows).nullspace():
        first = [*vector[: len(moved)], *vector[len(moved) * len(poses) :]]
        if any(first):  # else it says of another pose what was said of the first
            found.append({name: v for name, v in zip(moved + location, first, strict=True) if v != 0})
    return tuple(found)


def _pose(machine: Machine, index: int) -> dict[sp.Symbol, sp.Rational]:
    """Exact values of positions, cosines and sines, all dimensions zero: linear axes far out, rotary axes anywhere."""
    values = {symbols.named(name): sp.S.Zero for name in machine.dimensions}
    t = _HALF_TANGENTS[index]
    for axis in machine.axes:
        if axis in ROTARY:
            values |= {symbols.cosine(axis): (1 - t**2) / (1 + t**2), symbols.sine(axis): 2 * t / (1 + t**2)}
        else:
            values[symbols.position(axis)] = sp.Rational(repr(max(machine.travel[axis], key=abs))) / (index + 1)
    return values


def point_values(points: Sequence[tuple[Vector, Carrier, Point]]) -> dict[sp.Symbol, sp.Rational]:
    """Exact coordinates by point symbol: the decimal numbers as the files have them."""
    return {s: sp.Rational(repr(c)) for triple, _, at in points for s, c in zip(triple, at, strict=True)}


def _labels(
    runs: Sequence[RunPattern],
) -> tuple[dict[tuple[Carrier, Point], Vector], tuple[tuple[Vector, Carrier, Point], ...]]:
    """A symbol triple for each different point: rT1x .. on the tool, rW1x .. on the workpiece, rB1x .. on the bed."""
    labels: dict[tuple[Carrier, Point], Vector] = {}
    counts: dict[str, int] = {}
    for run in runs:
        for on, at in (run.target, run.reference):
            if on != run.frame and (on, at) not in labels:
                counts[on] = counts.get(on, 0) + 1
                labels[on, at] = symbols.point(f"r{on[0].upper()}{counts[on]}")
    return labels, tuple((triple, on, at) for (on, at), triple in labels.items())


def run_motion(machine: Machine, run: RunPattern, labels: dict[tuple[Carrier, Point], Vector]) -> MotionEquation:
    """The motion equation that a run senses a direction of."""
    terms = tuple(
        (sign, end[0], labels[end]) for sign, end in ((1, run.target), (-1, run.reference)) if end[0] != run.frame
    )
    return motion_equation(machine, run.moves, terms, run.frame)


def _reading(machine: Machine, run: RunPattern, labels: dict[tuple[Carrier, Point], Vector]) -> dict[str, sp.Expr]:
    direction = [sp.Rational(repr(part)) for part in run.direction]
    columns = run_motion(machine, run, labels).motion.columns
    reading = {
        name: multiplied_out(sp.Add(*(d * c for d, c in zip(direction, column, strict=True) if d and c)))
        for name, column in columns.items()
    }
    return {name: value for name, value in reading.items() if value != 0}


def _system(
    machine: Machine, runs: Sequence[RunPattern], unknowns: Sequence[str], labels: dict[tuple[Carrier, Point], Vector]
) -> IdentificationSystem:
    points = tuple((labels[end], *end) for end in _labels(runs)[0])
    readings = [_reading(machine, run, labels) for run in runs]
    matrix = sp.Matrix([[reading.get(name, sp.S.Zero) for name in unknowns] for reading in readings])
    known = tuple(
        sp.Add(*(value * symbols.named(name) for name, value in reading.items() if name not in unknowns))
        for reading in readings
    )
    adjugate = determinant = None
    if matrix.rows == matrix.cols <= _LARGEST_CLOSED_FORM:
        determinant = sp.factor(matrix.det(method="berkowitz"))
        if determinant != 0:
            adjugate = matrix.adjugate()
    moves = tuple(dict.fromkeys(run.moves for run in runs))
    at_points = matrix.xreplace(point_values(points) | {symbols.named(name): sp.S.Zero for name in machine.dimensions})
    return IdentificationSystem(
        runs=tuple(run.name for run in runs),
        moves=moves,
        unknowns=tuple(unknowns),
        matrix=matrix,
        known=known,
        adjugate=adjugate,
        determinant=determinant,
        points=points,
        rank=int(at_points.rank()),
    )
