"""What the tables of a control hold, in sentences."""

from collections.abc import Sequence

from trueaxis.controllers.component_grids import arguments_of
from trueaxis.controllers.formats import ISG, KINS, TABLE_FORMATS, Export
from trueaxis.controllers.remaining import Remaining, directed_effects, untabled_effects
from trueaxis.machine.machine import LINEAR
from trueaxis.model.model import MachineModel

_OWN = "errors of each axis along itself"
_CROSS = "errors of each linear axis across the others (straightness, squareness)"
_HOLDS = {
    "siemens-enc": (_OWN, "errors across the axes (siemens-cec), and those that change with the other axes"),
    "siemens-cec": (_CROSS, "errors along the axes (siemens-enc), and those that change with two axes"),
    "heidenhain-com": (f"{_OWN}, and {_CROSS}", "errors that change with two axes (rotations on a lever)"),
    "linuxcnc-comp": (_OWN, "errors across the axes, and those that change with the other axes"),
}


ACCEPT_WORSE = "--accept-worse"
_LEAST = 1e-6  # mm: a nanometre
_BESIDE = {"siemens-enc": "siemens-cec", "siemens-cec": "siemens-enc"}  # formats for one control, loaded together


def held_sentence(name: str) -> str:
    """What of the model a format holds."""
    if name == ISG:
        return (
            "the file holds every error component and, within them, the location errors; one value for both directions"
        )
    if name == KINS:
        return "the module holds every error component and location error, for any tool"
    holds, lacks = _HOLDS[name]
    return f"the tables hold {holds}; they do not hold {lacks}"


def worse_sentence(name: str, left: Remaining) -> str:
    """Why tables are not written that leave more than there is without them, and what helps."""
    helps = ["compensate, which corrects programs by the whole model"]
    if name != ISG:
        helps.insert(0, "a format that holds the whole model (isg-csv), where the control takes it")
    if name in _BESIDE:
        helps.insert(0, f"{_BESIDE[name]} loaded beside, and {ACCEPT_WORSE} for both")
    return (
        f"with these tables the error of the tool point over the travel, from home, would be {left.after * 1e3:.3g} um "
        f"RMS, without them it is {left.before * 1e3:.3g} um: errors in the tables and errors that they do not hold "
        f"partly cancel; what helps: {', or '.join(helps)}; {ACCEPT_WORSE} writes them all the same"
    )


def left_text(rms: float) -> str:
    """What remains, rms in mm: no digits that no machine has."""
    return f"{rms * 1e3:.3g} um" if rms >= _LEAST else f"less than {_LEAST * 1e3:g} um"


def module_limit_sentence(off: float, limit: float) -> str:
    """Why a module is not written that would stop the machine within its travel; mm."""
    return (
        f"the tool point is off by up to {off:.4g} mm within the travel, and the module corrects {limit:g} mm at most"
    )


def head_lines(name: str, model: MachineModel) -> list[str]:
    """Comments for the head of a file."""
    values = "values: actual minus ideal" if name == ISG else "values: actual minus commanded, zero at home"
    unit = "mm and rad by mm and deg" if name == ISG else "mm, rotary axes deg"
    lines = [f"machine {model.name}; {values}; {unit}", held_sentence(name)]
    if name == ISG:
        lines.append("workpiece_axes 0: all axes are written as seen from the workpiece")
    return lines


def export_sentences(name: str, model: MachineModel, export: Export) -> list[str]:
    """What a user must know of the files besides their values."""
    found = [held_sentence(name)]
    if export.chain:
        found.append(
            f"chain {''.join(export.chain)}, workpiece_axes 0: all axes are written as seen from the workpiece"
        )
    if name in TABLE_FORMATS and not TABLE_FORMATS[name].both_directions:
        found += [
            f"mean reversal error of {table.of}: {_amount(table.of, table.reversal)}, which the table cannot hold"
            for table in export.tables
            if table.of == table.by and table.reversal
        ]
    if name == ISG:
        for axis in model.axes:
            *others, own = arguments_of(model, axis)
            if others:
                found.append(f"errors of {own} also depend on {' and '.join(others)}, and are written as a grid")
    if name in TABLE_FORMATS and any(values.effect.axis is not None for values in model.effect_values):
        found.append("effects of a second axis are in it as they are where that axis is at home")
    if name == KINS and (labels := directed_effects(model)):
        found.append(f"in the module as the mean of both directions of approach: {_listed(labels)}")
    if labels := untabled_effects(model):
        where = "not in the module" if name == KINS else "in no table"
        found.append(f"{where}, for it depends on more than positions and directions: {_listed(labels)}")
    return found


def _amount(axis: str, value: float) -> str:
    return f"{value * 1e3:.3g} {'um' if axis in LINEAR else 'mdeg'}"


def _listed(labels: Sequence[str]) -> str:
    return ", ".join(labels)
