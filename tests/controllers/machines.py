"""Machines with random errors, derived here, and what `predict` says of them."""

from functools import cache

import numpy as np
import numpy.typing as npt

from tests.kernels import kernels_of
from tests.machines import machine_of
from trueaxis.model.curves import Curve, PolynomialCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.kernels import Kernels
from trueaxis.model.model import MachineModel

FloatArray = npt.NDArray[np.float64]
GANTRY = """schema = 1
name = "gantry"
structure = "[w b X Y Z t]"
[axis.X]
travel = [0.0, 1000.0]
[axis.Y]
travel = [-200.0, 400.0]
[axis.Z]
travel = [-350.0, 0.0]
"""
TABLE = """schema = 1
name = "moving_table"
structure = "[w Y' X' b Z t]"
[axis.X]
travel = [0.0, 500.0]
[axis.Y]
travel = [0.0, 300.0]
sense = -1
position = [10.0, 20.0, -5.0]
[axis.Z]
travel = [0.0, 250.0]
[tool]
position = [0.0, 0.0, -100.0]
"""
FIVE = """schema = 1
name = "five"
structure = "[w C' Y' b X Z B t]"
[axis.X]
travel = [0.0, 500.0]
[axis.Y]
travel = [-100.0, 300.0]
sense = -1
[axis.Z]
travel = [-250.0, 0.0]
[axis.C]
travel = [-180.0, 180.0]
sense = -1
position = [120.0, 80.0, -30.0]
[axis.B]
travel = [-90.0, 90.0]
position = [5.0, 0.0, 260.0]
[tool]
position = [0.5, -1.0, -140.0]
"""
FIXED_TABLE = """[[body]]
number = 2
name = "fixture"
lower = 1
position = [5.0, 6.0, 7.0]
position_errors = { EX = "f_x", EC = "f_c" }
"""
# bodies that no axis moves, with location errors: a fixture on the bed, a head on the ram
FIXED = f"""schema = 1
name = "fixed"
{FIXED_TABLE}
[[body]]
number = 3
name = "gantry"
lower = 1
moves = "X"
travel = [0.0, 600.0]
[[body]]
number = 4
name = "saddle"
lower = 3
moves = "Y"
travel = [0.0, 400.0]
position = [0.0, 30.0, 0.0]
position_errors = {{ EC = "s_xy" }}
[[body]]
number = 5
name = "ram"
lower = 4
moves = "Z"
travel = [-200.0, 0.0]
position_errors = {{ EA = "s_yz" }}
[[body]]
number = 6
name = "head"
lower = 5
position = [0.0, -40.0, -90.0]
position_errors = {{ EY = "h_y", EB = "h_b" }}
[ends]
workpiece = 2
tool = 6
"""
# the same with the fixture on a table that Y moves
FIXED_ON_TABLE = (
    FIXED.replace('name = "fixed"', 'name = "fixed_on_table"')
    .replace(FIXED_TABLE, FIXED_TABLE.replace("lower = 1", "lower = 4"))
    .replace('name = "saddle"\nlower = 3\n', 'name = "saddle"\nlower = 1\nsense = -1\n')
    .replace('name = "ram"\nlower = 4', 'name = "ram"\nlower = 3')
)


@cache
def _kernels(text: str) -> Kernels:
    module = kernels_of(text)
    routines = {name: getattr(module, name) for name in module.META["routines"]}
    return Kernels(meta=module.META, module=module, routines=routines, backend="numpy", note="")


def model_of(text: str, errors: ErrorValues) -> MachineModel:
    return MachineModel(machine_of(text), _kernels(text), errors)


def random_model(
    text: str, seed: int, *, scale: float = 1.0, rotations: float = 1.0, locations: float = 1.0
) -> MachineModel:
    """Errors of about 20 um and, times `rotations`, 20 urad over the travel; location errors times `locations`.

    scale: of all errors; small ones leave nothing of the products of errors.
    """
    machine, draw = machine_of(text), np.random.default_rng(seed)
    curves: dict[str, Curve] = {}
    for name in machine.components:
        low, high = machine.travel[name[2]]
        size = scale * (0.02 if name[1] in "XYZ" else 2e-5 * rotations)
        longest = max(abs(low), abs(high))
        coefficients = tuple(float(size * draw.normal() / longest**power) for power in (1, 2, 3))
        curves[name] = PolynomialCurve(powers=(1, 2, 3), coefficients=coefficients)
    parameters = {
        name: float(scale * locations * draw.normal() * (5e-5 if machine.parameter_unit(name) == "rad" else 0.02))
        for name in machine.location_errors
    }
    return model_of(text, ErrorValues(machine=machine.name, parameters=parameters, motion_errors=curves))
