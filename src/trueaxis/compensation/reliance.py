"""How far a program relies on what was measured, and whether it may be written."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.compensation.machine import ROTARY
from trueaxis.compensation.solve import SINGULAR
from trueaxis.compensation.visited import Visited
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import FloatArray
from trueaxis.model.extent import UncertaintyExtent, table_positions, uncertainty_extent
from trueaxis.model.measured_range import BeyondMeasured, beyond_measured
from trueaxis.model.model import MachineModel, home_of
from trueaxis.model.uncertainty import prior_size, tool_uncertainty

# Corrections that the prior makes likely: three standard deviations. What is larger comes from a slip (um for mm, a
# sign, another machine's values) far more often than from a machine.
PRIOR_SIZES = 3.0
NOTICEABLE = 0.001  # mm: a displacement at home that a work offset shows
KNOWN = 2.0  # standard uncertainties, from which on a displacement is more than what it is uncertain by


@dataclass(frozen=True, slots=True, kw_only=True)
class Limits:
    """max_u: largest standard uncertainty of the tool point, mm, None: any. max_correction: largest correction, mm;
    None: `PRIOR_SIZES` times what errors of the prior's sizes make of the tool point there. accept_u: whether values
    are taken in which the noise of the readings is larger than the corrections.
    """

    max_u: float | None = None
    max_correction: float | None = None
    accept_u: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Reliance:
    """uncertainty: of the tool point at the places of the program, relative to home; beyond: use beyond the measured
    range (places, not blocks, are counted). largest_correction and allowed_correction (None where nothing moves), mm,
    at `correction_at` (axis positions, mm and deg), where the first is the largest share of the second. largest_turn,
    allowed_turn: of a rotary axis, deg, and where (None where none turns). at_home: by how much the errors displace the
    tool point at home, and with it every word, mm; 0 from another datum; at_home_u: the largest standard uncertainty of
    a coordinate of that, 0 where it is not known. too_uncertain, too_large: which limit is passed; nothing is written.
    """

    uncertainty: UncertaintyExtent
    beyond: tuple[BeyondMeasured, ...]
    largest_correction: float
    allowed_correction: float | None
    correction_at: dict[str, float]
    largest_turn: float
    allowed_turn: float | None
    turned_at: dict[str, float]
    at_home: float
    at_home_u: float
    too_uncertain: bool
    too_large: bool

    @property
    def shift_is_noise(self) -> bool:
        """Whether all words are displaced by what readings hardly tell."""
        return NOTICEABLE < self.at_home < KNOWN * self.at_home_u

    @property
    def refused(self) -> bool:
        """Whether the program must not be written."""
        return self.too_uncertain or self.too_large


Judge = Callable[[Sequence[Visited]], Reliance]


def judge_of(model: MachineModel, covariance: Covariance, limits: Limits) -> Judge:
    """What judges the places that a program came to."""

    def judge(visited: Sequence[Visited]) -> Reliance:
        used = [one for one in visited if one.corrections.size] or visited
        return _worst([judged(one) for one in used])

    def judged(visited: Visited) -> Reliance:
        tool_point = visited.tool_point
        positions, corrections = visited.positions, visited.corrections
        nodes = [table_positions(covariance, axis) for axis in model.axes]
        samples = visited.samples(nodes) if corrections.size else positions
        extent = uncertainty_extent(model, covariance, samples, tool_point, visited.datum)
        allowed_turn = _allowed_turn(model)
        allowed = np.full(corrections.size, limits.max_correction or np.inf)
        if limits.max_correction is None:
            allowed = PRIOR_SIZES * prior_size(model, positions, tool_point)
            if visited.datum is not None:  # a correction is a difference, at most as large as both together
                allowed += PRIOR_SIZES * prior_size(model, visited.datum[1], tool_point)
        worst = int(np.argmax(corrections / allowed)) if corrections.size else None
        at_home, at_home_u = (0.0, 0.0) if visited.datum is not None else _at_home(model, covariance, tool_point)
        shifted = limits.max_u is not None and at_home > NOTICEABLE and at_home_u > limits.max_u
        return Reliance(
            uncertainty=extent,
            beyond=beyond_measured(model.errors, model.axes, np.hstack([positions, visited.ends])),
            largest_correction=0.0 if worst is None else float(corrections[worst]),
            allowed_correction=None if worst is None else float(allowed[worst]),
            correction_at={} if worst is None else dict(zip(model.axes, positions[:, worst].tolist(), strict=True)),
            largest_turn=visited.largest_turn,
            allowed_turn=allowed_turn,
            turned_at=dict(zip(model.axes, visited.turned_at.tolist(), strict=True)),
            at_home=at_home,
            at_home_u=at_home_u,
            too_uncertain=extent.refused(limits.max_u, limits.accept_u) or shifted,
            too_large=(worst is not None and bool(corrections[worst] > allowed[worst]))
            or (allowed_turn is not None and visited.largest_turn > allowed_turn),
        )

    return judge


def _at_home(model: MachineModel, covariance: Covariance, tool_point: FloatArray) -> tuple[float, float]:
    """By how much the errors displace a tool point (3, 1) at home, and its u; mm."""
    home = home_of(model)
    u = tool_uncertainty(model, covariance, home, tool_point, datum=None).u
    return float(np.linalg.norm(model.deviation(home, tool_point))), float(np.nan_to_num(u).max())


def _worst(found: Sequence[Reliance]) -> Reliance:
    """The worst in each respect of the work offsets and tools of a program."""
    if len(found) == 1:
        return found[0]
    corrected = max(found, key=lambda one: one.largest_correction / (one.allowed_correction or np.inf))
    turned = max(found, key=lambda one: one.largest_turn)
    beyond: dict[tuple[str, tuple[str, ...]], BeyondMeasured] = {}
    for part in (part for one in found for part in one.beyond):
        key = (part.axis, part.components)
        if key not in beyond or part.count > beyond[key].count:
            beyond[key] = part
    return Reliance(
        uncertainty=max(found, key=lambda one: (one.too_uncertain, one.uncertainty.counted)).uncertainty,
        beyond=tuple(beyond.values()),
        largest_correction=corrected.largest_correction,
        allowed_correction=corrected.allowed_correction,
        correction_at=corrected.correction_at,
        largest_turn=turned.largest_turn,
        allowed_turn=turned.allowed_turn,
        turned_at=turned.turned_at,
        at_home=max(one.at_home for one in found),
        at_home_u=max(one.at_home_u for one in found),
        too_uncertain=any(one.too_uncertain for one in found),
        too_large=any(one.too_large for one in found),
    )


def _allowed_turn(model: MachineModel) -> float | None:
    """deg: the turn that errors of `PRIOR_SIZES` times the prior ask for where turns help least, see orientation."""
    if not any(axis in ROTARY for axis in model.axes):
        return None
    prior, machine = model.prior, model.machine
    sizes = [prior.of_component(name) for name in machine.components if name.is_rotation]
    units = {name: machine.parameter_unit(name) for name in machine.location_errors}
    sizes += [prior.of_location(name, unit) for name, unit in units.items() if unit == "rad"]
    return float(np.degrees(PRIOR_SIZES * np.linalg.norm(sizes) / SINGULAR))
