"""Every format by its name: which tables it has and how they are written."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from trueaxis.controllers import heidenhain, linuxcnc, siemens
from trueaxis.controllers.axis_tables import AxisTable, axis_tables, node_count, round_step
from trueaxis.controllers.component_grids import taken_by_components
from trueaxis.controllers.isg_csv import control_model, csv_text, reversed_axes
from trueaxis.controllers.linuxcnc_kins import module_files, taken_by_module
from trueaxis.controllers.remaining import Remaining, remaining, taken_by_tables
from trueaxis.machine.machine import LINEAR
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import MachineModel

ISG = "isg-csv"
COMP = "linuxcnc-comp"
KINS = "linuxcnc-kins"  # no table: the whole model, run by the control


@dataclass(frozen=True, slots=True, kw_only=True)
class Layout:
    """How files are laid out, in the formats that leave it open.

    comments: lines for the head of a file; file_type: of linuxcnc-comp, one of FILE_TYPES.
    """

    comments: Sequence[str] = ()
    file_type: int = linuxcnc.ACTUAL


AS_USUAL = Layout()


@dataclass(frozen=True, slots=True, kw_only=True)
class TableFormat:
    """A format of tables of single axes.

    pairs: (of, by) that it has, from the axes of a machine; write: name -> text, one name "" for a single file, from
    tables, the layout and whether the directions differ; digits: of a value, mm or deg; most_points: of a table, None
    where the control is set up for as many as there are; both_directions: whether it tells them apart.
    """

    pairs: Callable[[Sequence[str]], Sequence[tuple[str, str]]]
    write: Callable[[Sequence[AxisTable], Layout, bool], Mapping[str, str]]
    digits: int
    most_points: int | None = None
    both_directions: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Export:
    """What is written: name -> text (the one name "" for a file), and what remains of the deviations with it.

    tables: those of single axes, as written; chain: axes from the workpiece to the tool where the file is a model.
    """

    files: Mapping[str, str]
    remaining: Remaining
    tables: tuple[AxisTable, ...] = ()
    chain: tuple[str, ...] = ()


def own_pairs(axes: Sequence[str]) -> list[tuple[str, str]]:
    """Every axis by itself."""
    return [(axis, axis) for axis in axes]


def cross_pairs(axes: Sequence[str]) -> list[tuple[str, str]]:
    """Every linear axis by every other."""
    return [(of, by) for by in axes for of in axes if of != by and of in LINEAR and by in LINEAR]


def all_pairs(axes: Sequence[str]) -> list[tuple[str, str]]:
    """Every axis by itself, and every linear axis by every other."""
    return [*own_pairs(axes), *cross_pairs(axes)]


TABLE_FORMATS: Mapping[str, TableFormat] = {
    "siemens-enc": TableFormat(
        pairs=own_pairs,
        write=lambda tables, layout, _: {"": siemens.encoder_text(tables, layout.comments)},
        digits=siemens.DIGITS,
    ),
    "siemens-cec": TableFormat(
        pairs=cross_pairs,
        write=lambda tables, layout, _: {"": siemens.sag_text(tables, layout.comments)},
        digits=siemens.DIGITS,
    ),
    "heidenhain-com": TableFormat(
        pairs=all_pairs,
        write=lambda tables, _, differ: heidenhain.com_files(tables, differ),
        digits=heidenhain.DIGITS,
        most_points=heidenhain.MOST_POINTS,
        both_directions=True,
    ),
    COMP: TableFormat(
        pairs=own_pairs,
        write=lambda tables, layout, _: linuxcnc.comp_files(tables, layout.file_type),
        digits=linuxcnc.DIGITS,
        most_points=linuxcnc.MOST_POINTS,
        both_directions=True,
    ),
}
# Positions of an axis in a table, where the control does not set a lower limit. No axis is measured at more; a step of
# 0.001 mm instead of 1 mm would make files of 50 MB and more.
MOST_POSITIONS = 5000
TABLED = (ISG, *TABLE_FORMATS)
FORMATS = (*TABLED, KINS)


def problem_of(name: str, model: MachineModel, step: float | None) -> str:
    """Why the machine cannot be exported in that format; empty where it can."""
    if any(axis not in model.axes for axis in LINEAR):
        return "has no X, Y and Z axis: tables are made for machines with all three"
    if step is not None and name == KINS:
        return "has no positions with a step between them: the kinematics compute the errors; leave the step out"
    if step is not None and (problem := _step_problem(name, model, step)):
        return problem
    if name == ISG:
        axes = reversed_axes(model)
        return (
            f"positive commands of {' '.join(axes)} move the tool in the negative direction, seen from the workpiece, "
            "which this format cannot say (`sense` in the spec, where the control counts the other way)"
            if axes
            else ""
        )
    return ""


def _step_problem(name: str, model: MachineModel, step: float) -> str:
    """Why tables cannot have that step; empty where they can."""
    of_control = None if name == ISG else TABLE_FORMATS[name].most_points
    most = of_control or MOST_POSITIONS
    spans = {axis: high - low for axis, (low, high) in model.travel.items()}
    longest = max(model.axes, key=lambda axis: spans[axis])
    count = node_count(model.travel[longest], step)
    if count <= most:
        return ""
    total = sum(node_count(model.travel[axis], step) for axis in model.axes)
    takes = "the control takes" if of_control else "an axis has at most"
    return (
        f"needs {count} positions of {longest} with a step of {step:g} ({total} of all axes), and {takes} {most} in a "
        f"table: --step {round_step(spans[longest] / (most - 1)):g} or more"
    )


def export_tables(
    name: str,
    model: MachineModel,
    tool: FloatArray,
    step: float | None,
    positions: FloatArray,
    layout: Layout = AS_USUAL,
) -> Export:
    """Make the files of a format of tables. tool: (3, 1), mm; positions: (n_axes, n), where it is judged what
    remains.
    """
    if name == ISG:
        control = control_model(model, tool[:, 0], step)
        left = remaining(model, tool, positions, taken_by_components(model, tool, step))
        return Export(files={"": csv_text(control, layout.comments)}, remaining=left, chain=control.chain)
    chosen = TABLE_FORMATS[name]
    made = axis_tables(model, tool, chosen.pairs(model.axes), step)
    tables = tuple(table.rounded(chosen.digits) for table in made)
    left = remaining(model, tool, positions, taken_by_tables(model, tables, both_directions=chosen.both_directions))
    differ = chosen.both_directions and any((table.forward != table.backward).any() for table in tables)
    return Export(files=chosen.write(tables, layout, differ), remaining=left, tables=tables)


def export_module(model: MachineModel, tool: FloatArray, positions: FloatArray, kernels: Mapping[str, bytes]) -> Export:
    """Make the sources of a LinuxCNC kinematics module. kernels: the content of each of CONTROL_FILES; the rest as of
    `export_tables`.
    """
    left = remaining(model, tool, positions, taken_by_module(model, tool))
    return Export(files=module_files(model, tool, kernels), remaining=left)
