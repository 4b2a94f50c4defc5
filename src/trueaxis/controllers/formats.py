"""Every format by its name: which tables it has, how they are written, and what they leave of the model."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from trueaxis.controllers import heidenhain, linuxcnc, siemens
from trueaxis.controllers.axis_tables import AxisTable, axis_tables, nodes
from trueaxis.controllers.isg_csv import DIRECTIONS, control_model, csv_text, motion_errors, reversed_axes
from trueaxis.controllers.remaining import Remaining, TakenOff, remaining, taken_by_tables
from trueaxis.effects.placement import context_of
from trueaxis.runtime.curves import FloatArray, TableCurve
from trueaxis.runtime.model import MachineModel
from trueaxis.spec.machine import LINEAR

ISG = "isg-csv"


@dataclass(frozen=True, slots=True, kw_only=True)
class TableFormat:
    """A format of tables of single axes.

    pairs: (of, by) that it has, from the axes of a machine; write: name -> text, one name "" for a file of its own;
    most_points: of a table, None where the control is set up for as many as there are; both_directions: whether it
    tells them apart; holds, lacks: what of the model, in words; digits: of a value, mm or deg.
    """

    pairs: Callable[[Sequence[str]], Sequence[tuple[str, str]]]
    write: Callable[[Sequence[AxisTable], Sequence[str], bool], Mapping[str, str]]
    holds: str
    lacks: str
    digits: int
    most_points: int | None = None
    both_directions: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Export:
    """What is written: name -> text (the one name "" for a file), sentences on it, and what remains with it."""

    files: Mapping[str, str]
    notes: tuple[str, ...]
    remaining: Remaining


def own_pairs(axes: Sequence[str]) -> list[tuple[str, str]]:
    """Every axis by itself."""
    return [(axis, axis) for axis in axes]


def cross_pairs(axes: Sequence[str]) -> list[tuple[str, str]]:
    """Every linear axis by every other."""
    return [(of, by) for by in axes for of in axes if of != by and of in LINEAR and by in LINEAR]


def all_pairs(axes: Sequence[str]) -> list[tuple[str, str]]:
    """Every axis by itself, and every linear axis by every other."""
    return [*own_pairs(axes), *cross_pairs(axes)]


OWN = "errors of each axis along itself"
CROSS = "of each linear axis across the others (straightness, squareness)"
TABLE_FORMATS: Mapping[str, TableFormat] = {
    "siemens-enc": TableFormat(
        pairs=own_pairs, write=lambda tables, notes, _: {"": siemens.encoder_text(tables, notes)},
        digits=siemens.DIGITS, holds=OWN,
        lacks="errors across the axes (siemens-cec), and those that change with the other axes",
    ),
    "siemens-cec": TableFormat(
        pairs=cross_pairs, write=lambda tables, notes, _: {"": siemens.sag_text(tables, notes)}, digits=siemens.DIGITS,
        holds=f"errors {CROSS}", lacks="errors along the axes (siemens-enc), and those that change with two axes",
    ),
    "heidenhain-com": TableFormat(
        pairs=all_pairs, write=lambda tables, _, both: heidenhain.com_files(tables, both), digits=heidenhain.DIGITS,
        holds=f"{OWN} and {CROSS}", lacks="errors that change with two axes (rotations on a lever)",
        most_points=heidenhain.MOST_POINTS, both_directions=True,
    ),
    "linuxcnc-comp": TableFormat(
        pairs=own_pairs, write=lambda tables, _, __: linuxcnc.comp_files(tables), digits=linuxcnc.DIGITS,
        holds=OWN, lacks="errors across the axes, and those that change with the other axes",
        most_points=linuxcnc.MOST_POINTS, both_directions=True,
    ),
}  # fmt: skip
UNTABLED = {"v", "d", "t", "T"}  # what effects may depend on that a table has no room for: see effects/variables.py
FORMATS = (ISG, *TABLE_FORMATS)


def problem_of(name: str, model: MachineModel, step: float | None) -> str:
    """Why the machine cannot be exported in that format; empty where it can."""
    if any(axis not in model.axes for axis in LINEAR):
        return "has no X, Y and Z axis: tables are made for machines with all three"
    if name == ISG:
        axes = reversed_axes(model)
        return (
            f"positive commands of {' '.join(axes)} move the tool in the negative direction, seen from the workpiece, "
            "which this format cannot say (`sense` in the spec, where the control counts the other way)"
            if axes
            else ""
        )
    most = TABLE_FORMATS[name].most_points
    if most is not None and step is not None:
        longest = max(nodes(model.travel[axis], step).size for axis in model.axes)
        if longest > most:
            return f"needs {longest} positions with a step of {step:g}, and the control takes {most} in a table"
    return ""


def export_tables(
    name: str, model: MachineModel, tool: FloatArray, step: float | None, positions: FloatArray
) -> Export:
    """Make the files of a format. tool: (3, 1), mm; positions: (n_axes, n), where it is judged what remains."""
    if name == ISG:
        return _isg(model, tool, step, positions)
    chosen = TABLE_FORMATS[name]
    made = axis_tables(model, tool, chosen.pairs(model.axes), step)
    tables = tuple(table.rounded(chosen.digits) for table in made)
    left = remaining(model, tool, positions, taken_by_tables(model, tables, both_directions=chosen.both_directions))
    both = chosen.both_directions and any((table.forward != table.backward).any() for table in tables)
    notes = [f"the tables hold {chosen.holds}; they do not hold {chosen.lacks}"]
    notes += [
        f"mean reversal error of {table.of}: {table.reversal * 1e3:.3g} "
        f"{'um' if table.of in LINEAR else 'mdeg'}, which the table cannot hold"
        for table in tables
        if table.of == table.by and table.reversal and not chosen.both_directions
    ]
    heads = (f"machine {model.name}; values: actual minus commanded; zero at home", *notes)
    return Export(files=chosen.write(tables, heads, both), notes=tuple(notes), remaining=left)


def untabled_effects(model: MachineModel) -> tuple[str, ...]:
    """Labels of effects of the error values on more than positions and directions: no table holds them."""
    return tuple(
        values.effect.label
        for values in model.effect_values
        if model.kinds[values.effect.kind].place == "component"
        and UNTABLED & {name.removesuffix("_b") for name in context_of(model.kinds[values.effect.kind])}
    )


def _isg(model: MachineModel, tool: FloatArray, step: float | None, positions: FloatArray) -> Export:
    control = control_model(model, tool[:, 0], step)
    notes: tuple[str, ...] = (
        f"chain {''.join(control.chain)}, workpiece_axes 0: all axes are written as seen from the workpiece",
        "the file holds every error component and, within them, the location errors; not the difference of directions",
    )
    if any(values.effect.axis is not None for values in model.effect_values):
        notes += ("effects of a second axis are in it as they are where that axis is at home",)
    heads = (f"machine {model.name}; mm and rad by mm and deg; actual minus ideal", *notes)
    left = remaining(model, tool, positions, _taken_by_model(model, tool, step))
    return Export(files={"": csv_text(control, heads)}, notes=notes, remaining=left)


def _taken_by_model(model: MachineModel, tool: FloatArray, step: float | None) -> TakenOff:
    """What a control takes off that has the components at the nodes, interpolated on a straight line."""
    curves = {}
    for axis in model.axes:
        at = nodes(model.travel[axis], step)
        for direction, values in zip(DIRECTIONS, motion_errors(model, axis, at), strict=True):
            if (name := f"E{direction}{axis}") in model.components:
                curves[name] = TableCurve(positions=tuple(at.tolist()), values=tuple(values.tolist()))
    parameters = dict(zip(model.parameters, model.parameter_values.tolist(), strict=True))
    known = model.with_values(replace(model.errors, motion_errors=curves, parameters=parameters, effects=()))

    def taken(at: FloatArray, _: FloatArray) -> FloatArray:
        return known.correction(at, known.deviation(at, tool))

    return taken
