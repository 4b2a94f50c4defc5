"""What compensation is given: the emitted kernels of the chain of XyzMachine, with curves and effects."""

from collections.abc import Mapping
from dataclasses import replace

from tests.kernels import kernels_of
from tests.machines import machine_of, serial_text
from trueaxis.effects.kind import Effect
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues
from trueaxis.model.kernels import Kernels
from trueaxis.model.model import MachineModel

TEXT = serial_text(
    "Y", "XZ", X={"position_errors": {"EC": "xy"}}, Z={"position_errors": {"EA": "yz", "EB": "xz"}}
)  # fmt: skip
LOW, HIGH = -300.0, 400.0  # travel of every axis


def extended(
    coefficients: Mapping[str, tuple[float, ...]],
    squareness: tuple[float, float, float],
    effects: Mapping[Effect, Mapping[str, float]],
) -> MachineModel:
    """coefficients: component -> those of u, u^2, ... with u = position / 500, as in `polynomial` of XyzMachine."""
    module = kernels_of(TEXT)
    kernels = Kernels(
        meta=module.META,
        module=module,
        routines={name: getattr(module, name) for name in module.META["routines"]},
        backend="numpy",
        note="",
    )
    curves = {}
    for name, values in coefficients.items():
        powers = tuple(range(1, len(values) + 1))
        curves[name] = PolynomialCurve(
            powers=powers, coefficients=tuple(c / 500.0**p for p, c in zip(powers, values, strict=True))
        )
    parameters = dict(zip(("xy", "yz", "xz"), squareness, strict=True))
    found = tuple(EffectValues(effect, of_effect) for effect, of_effect in effects.items())
    machine = replace(machine_of(TEXT), effects=tuple(effects))
    return MachineModel(
        machine, kernels, ErrorValues(machine="test", parameters=parameters, motion_errors=curves, effects=found)
    )
