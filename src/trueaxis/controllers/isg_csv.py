"""Error components in the ISG CSV format (ISG kernel, Beckhoff TF5280): the whole model but effects of direction.

The control's chain begins at the workpiece and carries every axis towards the tool. The components that are written
are those of this chain, so that workpiece_axes stays 0, and no location errors are needed:

- A location error L acts before the motion T(q). Expressed behind it, it is a motion error T(q)^-1 L T(q). That of a
  body that no axis moves is a constant error of the axis before it in the chain.
- An axis on the workpiece side moves the tool, seen from the workpiece, by the inverse of its joint: with E behind the
  motion T the inverse is T^-1 (1 - T E T^-1).
- Errors act on points in coordinates whose origin is that of the machine with every axis at 0; a body's frame stands
  at O there: rotation e, translation d - e x O.

All of it to first order in the errors, as the control's model is.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from trueaxis.controllers.axis_tables import plain
from trueaxis.controllers.component_grids import grid_of, motion_errors
from trueaxis.error_name import DIRECTIONS
from trueaxis.machine.machine import AXES, BED, LINEAR, Body
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import MachineModel

MM_DIGITS, RAD_DIGITS, POSITION_DIGITS = 7, 12, 6


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class ComponentTable:
    """The six errors of an axis, rows EX EY EZ (mm) EA EB EC (rad) by (6, n), at its positions (n,), mm or deg.

    beside: positions (n,) of other axes on which they depend too, by letter; then these and its own are a grid.
    """

    axis: str
    positions: FloatArray
    errors: FloatArray
    beside: Mapping[str, FloatArray] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class ControlModel:
    """What the control needs: axes from the workpiece to the tool, their errors, points of rotary axes and the tool.

    centres: axis -> point on its line, mm; tool: mm; both with every axis at 0.
    """

    chain: tuple[str, ...]
    tables: tuple[ComponentTable, ...]
    centres: dict[str, FloatArray]
    tool: FloatArray


def control_model(model: MachineModel, tool: FloatArray, step: float | None) -> ControlModel:
    """The model as the control has it; tool: (3,), point in the tool frame, mm. Check `reversed_axes` before."""
    workpiece, tooled = _branch(model, model.machine.workpiece), _branch(model, model.machine.tool)
    tables: list[ComponentTable] = []
    before = np.zeros(6)  # errors of fixed bodies before the first axis of the chain
    for body, at, inverse in [(*one, True) for one in reversed(workpiece)] + [(*one, False) for one in tooled]:
        located = _location_errors(model, body, at)
        if body.moves:
            tables.append(_table(model, body, at, step, inverse, before))
            before = np.zeros(6)
        elif tables:
            last = tables[-1]
            fixed = (-located if inverse else located)[:, np.newaxis]
            tables[-1] = replace(last, errors=last.errors + fixed)
        else:
            before += -located if inverse else located
    rotary = [(str(body.moves), at) for body, at in (*workpiece, *tooled) if body.moves and body.moves not in LINEAR]
    end = tooled[-1][1] if tooled else np.zeros(3)
    return ControlModel(
        chain=tuple(table.axis for table in tables), tables=tuple(tables), centres=dict(rotary), tool=end + tool
    )


def reversed_axes(model: MachineModel) -> tuple[str, ...]:
    """Axes whose positive commands move the tool in the negative direction, seen from the workpiece."""
    on_tool = {body.number for body, _ in _branch(model, model.machine.tool)}
    return tuple(
        axis
        for axis in model.axes
        for body in [model.machine.mover(axis)]
        if (body.sense > 0) != (body.number in on_tool)
    )


def csv_text(control: ControlModel, notes: Sequence[str] = ()) -> str:
    """The text of the file: a block for points, then one for each axis, with `#` between them."""
    blocks = ["".join(f"// {note}\n" for note in notes) + _points(control)]
    for table in control.tables:
        arguments = {**table.beside, table.axis: table.positions}
        head = " ".join([*arguments, *(direction.motion_error(table.axis) for direction in DIRECTIONS)])
        rows = [
            " ".join([*(plain(one, POSITION_DIGITS) for one in at), *(_cell(*cell) for cell in enumerate(errors))])
            for *at, errors in zip(*arguments.values(), table.errors.T, strict=True)
        ]
        blocks.append("\n".join([head, *rows]) + "\n")
    return "#\n".join(blocks)


def _cell(row: int, value: float) -> str:
    return plain(value, MM_DIGITS if row < 3 else RAD_DIGITS)


def _points(control: ControlModel) -> str:
    names = ["P0X", "P0Y", "P0Z"]
    values = [*control.tool]
    for axis in AXES:
        if axis in control.centres:
            names += [f"P{letter}{axis}" for letter in LINEAR]
            values += [*control.centres[axis]]
    return " ".join(names) + "\n" + " ".join(plain(value, POSITION_DIGITS) for value in values) + "\n"


def _branch(model: MachineModel, number: int) -> list[tuple[Body, FloatArray]]:
    """Bodies from the bed to an end, each with the origin of its frame with every axis at 0, mm."""
    bodies = []
    while number != BED:
        body = model.machine.body(number)
        bodies.append(body)
        number = body.lower
    at, found = np.zeros(3), []
    values = dict(zip(model.parameters, model.parameter_values, strict=True))
    for body in reversed(bodies):
        at = at + np.array([values[part] if isinstance(part, str) else part for part in body.position])
        found.append((body, at))
    return found


def _table(
    model: MachineModel, body: Body, at: FloatArray, step: float | None, inverse: bool, before: FloatArray
) -> ComponentTable:
    """The errors behind the motion of an axis in the chain. before: (6,), errors that act before its motion as well."""
    grid = grid_of(model, str(body.moves), step)
    *beside, positions = grid.positions
    own = motion_errors(model, grid.arguments, grid.positions)
    own[:3] -= np.cross(own[3:].T, at).T  # about the common origin
    joint = _motions(body, positions, at)
    own += _expressed(_location_errors(model, body, at)[:, np.newaxis], joint, behind=True)
    if inverse:
        own = -_expressed(own, joint, behind=False)
    # behind the motion of the chain, which on the workpiece side is the inverse of the joint
    own += _expressed(before[:, np.newaxis], joint, behind=not inverse)
    others = dict(zip(grid.arguments[:-1], beside, strict=True))
    return ComponentTable(axis=grid.arguments[-1], positions=positions, errors=own, beside=others)


def _location_errors(model: MachineModel, body: Body, at: FloatArray) -> FloatArray:
    """(6,): the location errors of a body about the common origin."""
    values = dict(zip(model.parameters, model.parameter_values, strict=True))
    found = np.zeros(6)
    for direction, name in body.position_errors:
        found[DIRECTIONS.index(direction)] = values[name]
    found[:3] -= np.cross(found[3:], at)
    return found


def _motions(body: Body, positions: FloatArray, at: FloatArray) -> FloatArray:
    """(n, 4, 4): the ideal motion of a body in common coordinates."""
    axis, found = str(body.moves), np.repeat(np.eye(4)[np.newaxis], positions.size, axis=0)
    if axis in LINEAR:
        found[:, LINEAR.index(axis), 3] = body.sense * positions
        return found
    along = "ABC".index(axis)
    one, two = (along + 1) % 3, (along + 2) % 3
    angle = np.radians(body.sense * positions)
    found[:, one, one] = found[:, two, two] = np.cos(angle)
    found[:, one, two], found[:, two, one] = -np.sin(angle), np.sin(angle)
    found[:, :3, 3] = at - found[:, :3, :3] @ at
    return found


def _expressed(errors: FloatArray, motion: FloatArray, *, behind: bool) -> FloatArray:
    """(6, n): errors (6, n) or (6, 1) before the motion (n, 4, 4), expressed behind it, or the other way round."""
    turn, shift = motion[:, :3, :3], motion[:, :3, 3]
    if behind:
        turn = turn.transpose(0, 2, 1)
        shift = -np.einsum("nij,nj->ni", turn, shift)
    small, moved = np.broadcast_to(errors[3:].T, shift.shape), np.broadcast_to(errors[:3].T, shift.shape)
    turned = np.einsum("nij,nj->ni", turn, small)
    carried = np.einsum("nij,nj->ni", turn, moved) - np.cross(turned, shift)
    return np.vstack([carried.T, turned.T])
