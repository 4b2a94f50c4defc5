"""Plain least squares of the poses of the head-head mill with some errors unknown, by the exact model of the package.

No part of the estimate has a hand in it: it is what its predictions are held against, and what the account of an
independent fit of the same poses is compared with.
"""

from dataclasses import dataclass

import numpy as np

from tests.real_data.headhead_data import DIMENSIONS
from trueaxis.estimation.observations import Observations
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel

OFFSETS = ("EX0C", "EY0C", "EX0B", "EZ0B", "EX0T", "EY0T", "EZ0T")
TILTS = ("EA0C", "EB0C", "EA0B", "EC0B")
SQUARENESS = ("EC0Y", "EA0Z", "EB0Z")
SCALES = ("EXX", "EYY", "EZZ")
OF_C, OF_B = (tuple(f"E{direction}{axis}" for direction in "XYZABC") for axis in "CB")
STEPS = 4  # of Gauss and Newton: errors of a millimetre in 500 mm leave 1e-3 of a step to the next
OPEN = 1e-8  # of the largest singular value: combinations that no pose tells are left at zero


@dataclass(frozen=True)
class Form:
    """What is unknown besides the centre of the sphere: location errors, and motion errors of the given degree (those
    of SCALES in proportion to the position).
    """

    title: str
    locations: tuple[str, ...] = ()
    components: tuple[str, ...] = ()
    degree: int = 1

    @property
    def terms(self) -> tuple[tuple[str, int], ...]:
        """Component and power of every coefficient."""
        return tuple(
            (name, power) for name in self.components for power in range(1, (1 if name in SCALES else self.degree) + 1)
        )


CENTRE = Form("sphere centre only")
AXES_ONLY = Form("and the rotary axes by ISO 230-7, no tool", (*OFFSETS[:4], *TILTS))
SMALL = Form("centre, offsets of rotary axes and tool", OFFSETS)
TILTED = Form("and tilts of the rotary axes", (*OFFSETS, *TILTS))
BIG = Form("and linear scale and squareness", (*OFFSETS, *TILTS, *SQUARENESS), SCALES)
CURVED_B = Form("these and motion errors of B, degree 2", BIG.locations, (*SCALES, *OF_B), 2)
CURVED_C = Form("these and motion errors of C, degree 2", BIG.locations, (*SCALES, *OF_C), 2)
FORMS = (CENTRE, AXES_ONLY, SMALL, TILTED, BIG, CURVED_B, CURVED_C)


@dataclass(frozen=True, eq=False)
class Fit:
    """unknowns: (n,), centre of the sphere (mm), location errors, coefficients; u: by what is left as if it were noise;
    residual: (n_readings,), mm; rank: how many combinations the poses tell.
    """

    unknowns: FloatArray
    u: FloatArray
    residual: FloatArray
    rank: int


class Poses:
    """All poses, and how their readings change with the unknowns of a form at the nominal machine."""

    def __init__(self, machine: MachineModel, observed: Observations, form: Form) -> None:
        self.machine, self.observed, self.form = machine, observed, form
        self.units = np.array([1.0] * 3 + [self._unit(name) for name in form.locations] + self._units_of_terms())
        zero = np.zeros(self.units.size)
        changes = [(self.readings(unit) - self.readings(-unit)) / 2.0 for unit in 1e-2 * np.diag(self.units)]
        self.columns = np.stack(changes, axis=1) / (1e-2 * self.units)
        assert np.abs(self.readings(zero)).max() < 1e-9

    def _unit(self, name: str) -> float:
        return 1.0 if self.machine.machine.parameter_unit(name) == "mm" else 1e-3

    def _units_of_terms(self) -> list[float]:
        each = []
        for name, power in self.form.terms:
            farthest = max(map(abs, self.machine.travel[name[2]]))
            each.append((1.0 if name[1] in "XYZ" else 1e-3) / farthest**power)
        return each

    def values(self, unknowns: FloatArray) -> ErrorValues:
        """Of the machine."""
        named = dict(zip(self.form.locations, unknowns[3 : 3 + len(self.form.locations)].tolist(), strict=True))
        found: dict[str, dict[int, float]] = {}
        for (name, power), value in zip(self.form.terms, unknowns[3 + len(named) :].tolist(), strict=True):
            found.setdefault(name, {})[power] = value
        curves = {
            name: PolynomialCurve(powers=tuple(of), coefficients=tuple(of.values())) for name, of in found.items()
        }
        return ErrorValues(machine=self.machine.name, parameters={**DIMENSIONS, **named}, motion_errors=curves)

    def readings(self, unknowns: FloatArray) -> FloatArray:
        """(n_readings,), mm, by the exact model; the sphere stands off by the first three."""
        observed = self.observed
        model = self.machine.with_values(self.values(unknowns))
        return expected_readings(model, observed.runs, observed.run, observed.positions) - unknowns[observed.run]

    def fitted(self, rows: np.ndarray) -> Fit:
        """By the readings of these rows; residuals of all."""
        unknowns = np.zeros(self.units.size)
        left, singular, right = np.linalg.svd(self.columns[rows] * self.units, full_matrices=False)
        told = singular > OPEN * singular[0]
        inverse = self.units[:, np.newaxis] * (right[told].T / singular[told])
        for _ in range(STEPS):
            off = self.observed.reading - self.readings(unknowns)
            unknowns = unknowns + inverse @ (left[:, told].T @ off[rows])
        residual = self.observed.reading - self.readings(unknowns)
        sigma = np.linalg.norm(residual[rows]) / np.sqrt(max(rows.size - told.sum(), 1))
        return Fit(unknowns, sigma * np.linalg.norm(inverse, axis=1), residual, int(told.sum()))


def rms_3d(residual: FloatArray) -> float:
    """Root mean square of the lengths of the residual vectors, mm; residual: (3 n,), pose by pose."""
    return float(np.sqrt((residual.reshape(-1, 3) ** 2).sum(axis=1).mean()))


def fitted(machine: MachineModel, observed: Observations, form: Form) -> Fit:
    """All readings, every one counting the same."""
    return Poses(machine, observed, form).fitted(np.arange(observed.reading.size))


def left_out(machine: MachineModel, observed: Observations, form: Form) -> float:
    """3-D rms of poses predicted from the 31 others, mm."""
    poses = Poses(machine, observed, form)
    every = np.arange(observed.reading.size)
    found = [poses.fitted(np.setdiff1d(every, mine)).residual[mine] for mine in every.reshape(-1, 3)]
    return rms_3d(np.concatenate(found))
