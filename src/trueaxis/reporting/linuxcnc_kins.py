"""README.md of a LinuxCNC kinematics module: what it does, how to load it, to verify it and to take it off."""

from collections.abc import Sequence

import numpy as np

from trueaxis.machine.machine import LINEAR, ROTARY
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import MachineModel
from trueaxis.model.uncertainty import home_of

_SHARE = 0.75  # of each travel: where the worked number stands, as good a place as any but the ends


def readme(model: MachineModel, tool: FloatArray, corrections: FloatArray, notes: Sequence[str]) -> str:
    """The text; tool: (3, 1), mm; corrections: (n_axes, 1), joints less axes at `example_position`, mm."""
    at = example_position(model)
    sections = (
        _head(model),
        _load(model),
        _use(tool),
        _verify(model, at, corrections),
        _limits(model, notes),
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


def _head(model: MachineModel) -> str:
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


def _load(model: MachineModel) -> str:
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


def _use(tool: FloatArray) -> str:
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


def _verify(model: MachineModel, at: FloatArray, corrections: FloatArray) -> str:
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


def _limits(model: MachineModel, notes: Sequence[str]) -> str:
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
