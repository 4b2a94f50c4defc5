"""What `export` says: sentences on the tables of a control, and README.md of a LinuxCNC kinematics module.

The README says what the module does, how to load it, to verify it and to take it off.
"""

from collections.abc import Sequence

import numpy as np

from trueaxis.controllers.component_grids import arguments_of
from trueaxis.controllers.formats import ISG, KINS, TABLE_FORMATS, Export
from trueaxis.controllers.remaining import Remaining, directed_effects, untabled_effects
from trueaxis.machine.machine import LINEAR, ROTARY
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import MachineModel, home_of

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
_SHARE = 0.75  # of each travel: where the worked number stands, as good a place as any but the ends


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


def module_readme(model: MachineModel, tool: FloatArray, corrections: FloatArray, notes: Sequence[str]) -> str:
    """The text; tool: (3, 1), mm; corrections: (n_axes, 1), joints less axes at `example_position`, mm."""
    at = example_position(model)
    sections = (
        _readme_head(model),
        _readme_load(model),
        _readme_use(tool),
        _readme_verify(model, at, corrections),
        _readme_limits(model, notes),
    )
    return "\n".join(sections)


def example_position(model: MachineModel) -> FloatArray:
    """(n_axes, 1), mm: where README.md has its number; rotary axes at home."""
    found = home_of(model)
    for row, axis in enumerate(model.axes):
        low, high = model.travel[axis]
        if axis in LINEAR:
            found[row] = np.round(low + _SHARE * (high - low))
    return found


def _readme_head(model: MachineModel) -> str:
    return f"""# LinuxCNC kinematics of {model.name}, with its geometric errors

World coordinates are the positions of an ideal machine, as `trivkins` has them. A joint goes where this machine has its
tool point where the ideal one would have it. All motion is compensated by it: programs, cycles, MDI and jogging, with
the work offsets and tools in force. That is why the right place of a volumetric compensation is the control.

| file | what it is |
|---|---|
| `trueaxiskins.c`, `joints.h`, `curves.h` | the module, the same for every machine |
| `control.c`, `control.h` | forward and inverse kinematics, derived from the machine spec |
| `machine.h` | the error values: new values need a new `machine.h` and nothing else |
| `trueaxiskins.hal` | the connections |
"""


def _readme_load(model: MachineModel) -> str:
    letters = "".join(model.axes)
    return f"""## Load

1. Build and install it, in this folder (needs `linuxcnc-uspace-dev` or a source tree):

   ```
   sudo halcompile --install trueaxiskins.c
   ```

2. In the INI file (machine units must be mm, `LINEAR_UNITS = mm`):

   ```
   [KINS]
   KINEMATICS = trueaxiskins coordinates={letters}
   JOINTS = {len(model.axes)}

   [HAL]
   HALFILE = trueaxiskins.hal
   ```

   Keep your other HAL files before this one. `coordinates=` gives joint 0, 1, 2 ... their letters, as with `trivkins`;
   two joints may have one letter (a gantry). Joints of other letters follow them as they are.
3. Give joints room: `MIN_LIMIT` and `MAX_LIMIT` of `[JOINT_n]` beyond those of `[AXIS_L]` by more than the largest
   correction, and `STEPGEN_MAXVEL`, `STEPGEN_MAXACCEL` a little more than the axes have.
4. Take off what corrected the same errors before: `COMP_FILE`, and programs of `trueaxis compensate`. `BACKLASH` stays.
"""


def _readme_use(tool: FloatArray) -> str:
    x, y, z = (f"{value:g}" for value in tool[:, 0])
    return f"""## Pins

| pin | | |
|---|---|---|
| `trueaxiskins.enable` | bit in | the correction comes, or goes, within `ramp-time`: axes never jump |
| `trueaxiskins.ramp-time` | float in | s, 1 by default, 0.1 at least |
| `trueaxiskins.tool-x` `-y` `-z` | float in | what `G43` adds to X, Y, Z, mm: `motion.tooloffset.x` and so on |
| `trueaxiskins.share` | float out | of the correction that acts, 0 to 1 |
| `trueaxiskins.settled` | bit out | nothing is ramping |
| `trueaxiskins.correction-x` `-y` `-z` | float out | joint minus axis, mm |
| `trueaxiskins.steps`, `.converged` | s32, bit out | of the last solution: 3 to 6 steps as a rule, 20 at most |
| `trueaxiskins.fault` | bit out | see below; stays until `reset` |
| `trueaxiskins.reset` | bit in | |

Tool lengths are measured from the point {x}, {y}, {z} of the tool frame (`--tool-point`). The tip is compensated: the
point that lies back from there by what `G43` adds. A new length ramps, too: **cut when `settled` is true again**
(`M66` on an input that is connected to it), or allow `ramp-time` after `G43`.

What is not finite never leaves. A tool offset that is NaN or beyond 2 m is not taken: the last good one stays, and
`fault` is set. For a position that is not finite, that needs more than 5 mm of correction, or for which the solution
does not converge, the last good joints or the last good correction are given, `fault` is set, and LinuxCNC stops with
`kinematicsInverse failed`.
"""


def _readme_verify(model: MachineModel, at: FloatArray, corrections: FloatArray) -> str:
    rotary = [axis for axis in model.axes if axis in ROTARY]
    go = " ".join(f"{axis}{at[row, 0]:g}" for row, axis in enumerate(model.axes))
    rows = "\n".join(
        f"| {axis} | {at[row, 0]:g} | {at[row, 0] + corrections[row, 0]:.6f} |" for row, axis in enumerate(model.axes)
    )
    turning = f" Positions of {' '.join(rotary)} stay as they are." if rotary else ""
    return f"""## Verify

`enable` on, without a tool (`G49`), when `settled` is true:

```
G53 G0 {go}
```

| | axis | joint |
|---|---|---|
{rows}

`halcmd show pin trueaxiskins.correction` shows the differences, `halcmd show pin joint` the joints
(`joint.N.motor-pos-cmd`, less the offset of homing).{turning} An error of +0.010, the tool 10 um too far, gives a
correction of -0.010. Then measure again what was measured before, with the correction on: readings must be smaller.
**Readings twice as large mean a wrong sign: set `enable` to 0.**

## Take off

`unlinkp trueaxiskins.enable`, then `setp trueaxiskins.enable 0`: the axes go back within `ramp-time`. For good:
`KINEMATICS = trivkins` in the INI file, take `trueaxiskins.hal` out, start again.
"""


def _readme_limits(model: MachineModel, notes: Sequence[str]) -> str:
    listed = "\n".join(f"- {note}" for note in notes)
    ends = ", ".join(f"{axis} {model.travel[axis][0]:g} to {model.travel[axis][1]:g}" for axis in model.axes)
    return f"""## What it holds

- Travel: {ends}. Up to 5 mm (deg) beyond, curves go on; farther out they hold
  their value. Rotary positions of more than one turn count as they are, not modulo 360.
- LinuxCNC wants all joints homed before world mode (`KINEMATICS_BOTH`), and screens show joints until then.
- Rotary axes are not turned: the tool point is put right, the direction of the tool axis stays as it is.
- With tool centre point control by another kinematics module this one cannot be loaded: LinuxCNC takes one.
- Work offsets that were touched off before it was loaded are off by the correction there: touch off again.
{listed}
"""
