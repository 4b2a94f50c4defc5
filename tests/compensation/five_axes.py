"""Five-axis machines with errors: derived kernels for compensation, and the same chain in forty digits to judge it."""

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from tests.compensation.analytic_machine import FloatArray
from tests.exact_chain import DIGITS, ExactChain, placed
from tests.kernels import kernels_of
from tests.machines import machine_of, serial_text
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.kernels import Kernels
from trueaxis.model.model import MachineModel

TEXTS = {
    "head-head": serial_text(
        "", "XYZCB", C={"position_errors": {"EA": "cA", "EX": "cX"}}, B={"position": [0, 0, -9.0]}
    ),
    "table-table": serial_text(
        "YAC", "XZ", A={"position_errors": {"EB": "aB", "EC": "aC"}}, C={"position": [0, 3, 50]}
    ),
    "head and table": serial_text("YC", "XZB", B={"position": [1.5, 0, 80.0]}, C={"position_errors": {"EA": "cA"}}),
    "all reversed": serial_text("YAC", "XZ", **{axis: {"sense": -1} for axis in "XYZAC"}),
    "slanted order": serial_text("XA", "YZB", A={"sense": -1}, B={"position_errors": {"EA": "bA"}}),
}


class FiveAxes:
    """One machine: `model` is what compensation gets, `pose_of` what its chain says in forty digits."""

    def __init__(self, text: str, size: float = 1.0, seed: int = 5) -> None:
        self.chain = ExactChain(text)
        random = np.random.default_rng(seed)
        self.curves: dict[str, PolynomialCurve] = {}
        for name in self.chain.components:
            scale = size * (0.02 if name[1] in "XYZ" else 5e-5)
            a, b, c = scale * random.uniform(-1.0, 1.0, 3)
            self.curves[name] = PolynomialCurve(powers=(0, 1, 2), coefficients=(a, b / 300.0, c / 300.0**2))
        self.parameters = {name: random.uniform(-100.0, 100.0) for name in self.chain.dimensions}
        self.parameters |= {name: size * random.uniform(-1e-4, 1e-4) for name in self.chain.location_errors}
        self.model = _empty(text).with_values(
            ErrorValues(machine="test", parameters=self.parameters, motion_errors=self.curves)
        )

    def programmed(self, count: int, seed: int = 1) -> FloatArray:
        random = np.random.default_rng(seed)
        linear = random.uniform(-250.0, 350.0, (3, count))
        return np.concatenate([linear, random.uniform(-80.0, 80.0, (2, count))])

    def pose_of(self, column: FloatArray, tool_point: FloatArray, ideal: bool = False) -> tuple[Any, Any]:
        """Tool point (mm) and unit tool axis in the workpiece frame, as the chain of matrices has them."""
        pose = {axis: DIGITS.mpf(float(value)) for axis, value in zip(self.chain.axes, column, strict=True)}
        values: dict[str, Any] = {
            name: value for name, value in self.parameters.items() if not ideal or name in self.chain.dimensions
        }
        if not ideal:
            for name, curve in self.curves.items():
                at = pose[name[2]]
                values[name] = sum(
                    (DIGITS.mpf(c) * at**p for p, c in zip(curve.powers, curve.coefficients, strict=True)),
                    DIGITS.mpf(0),
                )
        view = "tool_in_workpiece"
        at = self.chain.matrix(view, pose, values)
        origin = placed(at, [0, 0, 0])
        axis = placed(at, [0, 0, 1]) - origin
        return placed(at, [float(v) for v in tool_point[:, 0]]), axis / DIGITS.norm(axis)

    def off(
        self, commands: FloatArray, programmed: FloatArray, tool_point: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Distance (mm) and angle (rad) of the actual tool from the error-free one, for every pose."""
        found = []
        for command, wanted in zip(commands.T, programmed.T, strict=True):
            (p, n), (p0, n0) = self.pose_of(command, tool_point), self.pose_of(wanted, tool_point, ideal=True)
            found.append([float(DIGITS.norm(p - p0)), float(DIGITS.norm(n - n0))])
        point, axis = np.array(found).T
        return point, axis


@cache
def _empty(text: str) -> MachineModel:
    machine, module = machine_of(text), kernels_of(text)  # the NumPy kernels alone: C and equations take longer
    routines = {name: getattr(module, name) for name in module.META["routines"]}
    kernels = Kernels(meta=module.META, module=module, routines=routines, backend="numpy", note="")
    return MachineModel(machine, kernels, ErrorValues(machine=machine.name))


def constant(text: str, errors: Mapping[str, float]) -> MachineModel:
    """A machine whose motion errors are the same everywhere."""
    curves = {name: PolynomialCurve(powers=(0,), coefficients=(value,)) for name, value in errors.items()}
    return _empty(text).with_values(ErrorValues(machine="test", parameters={}, motion_errors=curves))
