"""Error values that no machine has: a slip of a unit or a damaged file, never an error to be compensated."""

from collections.abc import Iterator

import numpy as np

from trueaxis.effects.kind import Effect
from trueaxis.error_name import ErrorName
from trueaxis.io.faults import Faults
from trueaxis.machine.machine import Machine
from trueaxis.model.curves import Curve, TableCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.strict_json import JsonPath, key_path

# Sizes of the prior that a value may have. A hundred of the default ones are 2 mm, 5 mrad, a squareness of 10 mrad and
# an offset of 100 mm: a belt-driven router stays below, a value in um taken for mm does not.
MOST_SIZES = 100.0
LARGEST_DIMENSION = 1e5  # mm: ten times the largest machines built
_SAMPLES = 257  # positions; a polynomial of degree 15 is followed to 1 % of its range


def check_believable(machine: Machine, errors: ErrorValues, faults: Faults) -> None:
    """Note every value that is not finite, or larger than `MOST_SIZES` times what the prior expects.

    A curve is judged where it was measured; where it does not say, over the travel.
    """
    for path, size, limit, unit in _sizes(machine, errors):
        if not size <= limit:
            scale, shown = (1e3, "um") if unit == "mm" else (1e6, "urad")
            reached = f"reaches {size * scale:.4g} {shown}" if np.isfinite(size) else "is not finite"
            problem = (
                f"{reached} within the travel, where {limit * scale:.4g} {shown} is {MOST_SIZES:g} times the prior"
            )
            faults.add(key_path(path), problem, "a value in mm or rad; or a larger size in [prior] of the spec")
    for name in machine.dimensions:
        value = errors.parameters.get(name, 0.0)
        if not abs(value) <= LARGEST_DIMENSION:
            place = key_path(("parameters", name))
            faults.add(place, f"{value:g} mm is no dimension of a machine", f"at most {LARGEST_DIMENSION:g} mm")


def _sizes(machine: Machine, errors: ErrorValues) -> Iterator[tuple[JsonPath, float, float, str]]:
    """Key, largest absolute value, limit and unit (mm or rad) of every error value that has a size to expect."""
    prior = machine.prior
    for name, curve in ((ErrorName(text), curve) for text, curve in errors.motion_errors.items()):
        limit = MOST_SIZES * prior.of_component(name)
        yield (
            ("motion_errors", name),
            _largest(curve, curve.measured or machine.travel[name.axis]),
            limit,
            name.unit,
        )
    for location in machine.location_errors:
        if location in errors.parameters:
            unit = machine.parameter_unit(location)
            size = abs(errors.parameters[location])
            yield ("parameters", location), size, MOST_SIZES * prior.of_location(location, unit), unit
    for index, values in enumerate(errors.effects):
        limit, unit = _limit_of_effect(machine, values.effect)
        for parameter in machine.kinds[values.effect.kind].parameters:
            if parameter.role != "grid" and parameter.unit in ("u", "mm") and parameter.name in values.parameters:
                path = ("effects", index, "parameters", parameter.name)
                yield path, abs(values.parameters[parameter.name]), limit, unit


def _limit_of_effect(machine: Machine, effect: Effect) -> tuple[float, str]:
    """Of a parameter that has the unit of what the effect acts on; readings and points count as translations."""
    name = effect.component or ""
    if name in machine.components:
        return MOST_SIZES * machine.prior.of_component(effect.error), effect.error.unit
    if name in machine.location_errors:
        unit = machine.parameter_unit(name)
        return MOST_SIZES * machine.prior.of_location(name, unit), unit
    return MOST_SIZES * machine.prior.location_length, "mm"


def _largest(curve: Curve, ends: tuple[float, float]) -> float:
    """Largest absolute value from one end to the other; infinite where it overflows."""
    if isinstance(curve, TableCurve):
        return float(np.max(np.abs(curve.values)))
    with np.errstate(over="ignore", invalid="ignore"):
        values = np.abs(curve(np.linspace(*ends, _SAMPLES)))
    return float(np.max(values)) if np.isfinite(values).all() else float("inf")
