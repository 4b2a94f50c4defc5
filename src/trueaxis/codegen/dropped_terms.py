"""How large what first order drops is, for errors of the sizes that are expected before anything is measured.

The emitted kernels themselves are run: the exact deviation less the one to first order.
"""

import itertools
import random
from dataclasses import dataclass
from types import ModuleType

import numpy as np
import numpy.typing as npt

from trueaxis.codegen.numpy_source import numpy_source
from trueaxis.derivation.routine import Routine
from trueaxis.machine.machine import Machine
from trueaxis.machine.prior import Prior

FloatArray = npt.NDArray[np.float64]

DRAWS = 64  # sets of signs: every error has its expected size, its sign is drawn
DIMENSION = 100.0  # mm, of every home position: the spec names them and gives no numbers
_EXACT, _FIRST = "tool_in_workpiece_deviation", "tool_in_workpiece_deviation_first_order"


@dataclass(frozen=True)
class DroppedTerms:
    """Micrometres, over all drawn signs and the corners and the middle of the travels: rms of the deviation to first
    order, rms and largest length of what it lacks.
    """

    deviation: float
    rms: float
    largest: float


def dropped_terms(machine: Machine, routines: tuple[Routine, ...]) -> DroppedTerms:
    """The size of the dropped terms at the tool frame's origin, errors of the default sizes of [prior]."""
    module = ModuleType("kernels")
    exec(numpy_source(machine, tuple(r for r in routines if r.name in (_EXACT, _FIRST))), module.__dict__)
    positions = _positions(machine)
    drawn = random.Random(1)
    prior = Prior()  # not the spec's own: editing [prior] asks for no new files
    exact, first = [], []
    for _ in range(DRAWS):
        errors = [drawn.choice((-1, 1)) * prior.of_component(name) for name in machine.components]
        parameters = [DIMENSION] * len(machine.dimensions)
        parameters += [
            drawn.choice((-1, 1)) * prior.of_location(name, machine.parameter_unit(name))
            for name in machine.location_errors
        ]
        arguments = (positions, np.array(errors)[:, None], np.array(parameters), np.zeros((3, 1)))
        exact.append(getattr(module, _EXACT)(*arguments))
        first.append(getattr(module, _FIRST)(*arguments))
    lengths = np.linalg.norm(np.array(exact) - np.array(first), axis=1)
    deviation = np.linalg.norm(np.array(first), axis=1)
    return DroppedTerms(1e3 * _rms(deviation), 1e3 * _rms(lengths), 1e3 * float(lengths.max()))


def _positions(machine: Machine) -> FloatArray:
    corners = list(itertools.product(*(machine.travel[axis] for axis in machine.axes)))
    middle = [sum(machine.travel[axis]) / 2 for axis in machine.axes]
    return np.array([*corners, middle]).T


def _rms(lengths: FloatArray) -> float:
    return float(np.sqrt(np.mean(lengths**2)))
