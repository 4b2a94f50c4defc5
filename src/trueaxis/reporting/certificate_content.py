"""What the document of error values says, as numbers: errors, the tool point over the volume, changes since a file."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from trueaxis.error_name import ErrorName
from trueaxis.machine.error_words import location_words
from trueaxis.model.covariance import Covariance
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import Determined, Fit
from trueaxis.model.grid import Slice
from trueaxis.model.model import MachineModel, home_of
from trueaxis.model.origin import Origin
from trueaxis.model.uncertainty import ToolUncertainty, curve_u, tool_uncertainty
from trueaxis.model.volume import corners, middle_planes, volume_points

FloatArray = NDArray[np.float64]

SAMPLES = 61  # of a curve over the travel
POINTS = 400  # in the volume, for root mean square and 95 % of its points
STEPS = 21  # along either side of a slice


@dataclass(frozen=True, slots=True, kw_only=True)
class Change:
    """Since the other file. rms: over the travel, or the value itself; in_u: the largest ratio of a change to its
    standard uncertainty, NaN where that is not known; at: where, mm or deg, None of a value without a travel.
    """

    rms: float
    in_u: float
    at: float | None


@dataclass(frozen=True, slots=True, kw_only=True)
class ErrorLine:
    """One error. value: of a curve the one that is largest over the travel, at `at`; u: there, NaN where not known;
    rms: over the travel; unit: mm or rad; determined: by what, None where the file does not say; meaning: of a
    location error in words.
    """

    name: str
    value: float
    u: float
    rms: float
    at: float | None
    unit: str
    determined: Determined | None
    change: Change | None = None
    meaning: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class OverVolume:
    """Length of the deviation of the tool point from home, mm: root mean square, 95 % of the points, the largest and
    where; u_rms: root mean square of its standard uncertainty, NaN where it is not known anywhere; u_prior_rms: of the
    part that rests on the prior, u_usual_rms: by the usual sizes of instrument unknowns; both NaN where
    there is none. u_largest: the largest u of one coordinate.
    """

    rms: float
    within: float
    largest: float
    largest_at: dict[str, float]
    u_rms: float
    u_prior_rms: float
    u_usual_rms: float
    u_largest: float


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Content:
    """title: of the machine; against: the other file as it was named, None where there is none; tool: the point in the
    tool frame, mm; changed: the tool point over the volume by one file less the other.
    """

    machine: str
    title: str
    source: str
    against: str | None
    fit: Fit | None
    origin: Origin | None
    tool: tuple[float, float, float]
    components: tuple[ErrorLine, ...]
    locations: tuple[ErrorLine, ...]
    effects: tuple[EffectValues, ...]
    volume: OverVolume
    changed: OverVolume | None
    slices: tuple[Slice, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Known:
    """A machine with error values, and their covariance; source: their file, as it was named."""

    model: MachineModel
    covariance: Covariance
    source: str


def content(now: Known, before: Known | None, tool: tuple[float, float, float]) -> Content:
    """Everything that the document says. Effects are listed, and no part of the tool point: they need a context."""
    model = now.model
    return Content(
        machine=model.name,
        title=model.machine.title,
        source=now.source,
        against=None if before is None else before.source,
        fit=model.errors.fit,
        origin=model.errors.origin,
        tool=tool,
        components=tuple(_component(name, now, before) for name in model.components if _is_there(name, now, before)),
        locations=tuple(_location(name, now, before) for name in model.location_errors),
        effects=model.errors.effects,
        volume=_over_volume(now, None, tool),
        changed=None if before is None else _over_volume(now, before, tool),
        slices=_slices(now, tool),
    )


def _is_there(name: ErrorName, *files: Known | None) -> bool:
    return any(one is not None and name in one.model.errors.motion_errors for one in files)


def _component(name: ErrorName, now: Known, before: Known | None) -> ErrorLine:
    at = np.linspace(*now.model.travel[name.axis], SAMPLES)
    values, u = _curve(name, now, at)
    place = int(np.argmax(np.abs(values)))
    change = None
    if before is not None:
        old, old_u = _curve(name, before, at)
        difference, both = values - old, np.hypot(u, old_u)
        ratios = _ratio(difference, both)
        known = np.flatnonzero(np.isfinite(ratios))
        most = int(known[np.argmax(ratios[known])]) if known.size else int(np.argmax(np.abs(difference)))
        change = Change(rms=_rms(difference), in_u=float(ratios[most]), at=float(at[most]))
    return ErrorLine(
        name=name, value=float(values[place]), u=float(u[place]), rms=_rms(values), at=float(at[place]), unit=name.unit,
        determined=now.model.errors.determined.get(name), change=change,
    )  # fmt: skip


def _curve(name: ErrorName, of: Known, at: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Values and standard uncertainties at positions, (n,); NaN where what nothing determines is part of them."""
    curve, covariance = of.model.errors.motion_errors.get(name), of.covariance
    values = np.zeros(at.size) if curve is None else np.asarray(curve(at), dtype=float)
    if curve is None:
        return values, np.zeros(at.size)
    if covariance.root is None or name not in covariance.components:
        return values, np.full(at.size, np.nan)
    rows = covariance.rows_of(name)
    basis = covariance.bases[covariance.components.index(name)](at)
    u = curve_u(covariance, name, at)
    is_open = (basis.T @ covariance.open[rows] != 0.0).any(axis=1)
    return values, np.where(is_open, np.nan, u)


def _location(name: str, now: Known, before: Known | None) -> ErrorLine:
    errors = now.model.errors
    value, u = errors.parameters.get(name, 0.0), errors.u.get(name, np.nan)
    change = None
    if before is not None:
        old = before.model.errors
        difference = value - old.parameters.get(name, 0.0)
        ratio = _ratio(np.array([difference]), np.array([np.hypot(u, old.u.get(name, np.nan))]))
        change = Change(rms=difference, in_u=float(ratio[0]), at=None)
    return ErrorLine(
        name=name, value=value, u=u, rms=abs(value), at=None, unit=now.model.machine.parameter_unit(name),
        determined=errors.determined.get(name), change=change, meaning=location_words(now.model.machine, name),
    )  # fmt: skip


def _ratio(difference: FloatArray, u: FloatArray) -> FloatArray:
    """|difference| / u, 0 where nothing has changed, NaN where u is not known or 0."""
    known = np.divide(np.abs(difference), u, out=np.full(u.shape, np.nan), where=u > 0.0)
    return np.where(difference == 0.0, 0.0, known)


def _over_volume(now: Known, before: Known | None, tool: tuple[float, float, float]) -> OverVolume:
    model = now.model
    # the largest values are at the corners as a rule; root mean squares are of the points inside alone
    positions = np.hstack([volume_points(model.travel, model.axes, POINTS), corners(model.travel, model.axes)])
    moved = deviations(model, positions, tool)
    known = [_uncertainty(now, positions, tool)]
    if before is not None:
        moved = moved - deviations(before.model, positions, tool)
        known.append(_uncertainty(before, positions, tool))
    length = np.linalg.norm(moved, axis=0)
    worst = int(np.argmax(length))
    u = np.sqrt(np.sum([one.u**2 for one in known], axis=0))
    by_prior = np.sqrt(np.sum([one.u_prior**2 for one in known], axis=0))
    usual = [one.u if one.u_usual is None else one.u_usual for one in known]
    by_both = any(one.u_usual is not None for one in known)
    return OverVolume(
        rms=_rms(length[:POINTS]),
        within=float(np.quantile(length[:POINTS], 0.95)),
        largest=float(length[worst]),
        largest_at=dict(zip(model.axes, positions[:, worst].tolist(), strict=True)),
        u_rms=_length_rms(u[:, :POINTS]),
        u_prior_rms=_length_rms(by_prior[:, :POINTS]),
        u_usual_rms=_length_rms(np.sqrt(np.sum(np.square(usual), axis=0))[:, :POINTS]) if by_both else float("nan"),
        u_largest=float(np.nanmax(u)) if np.isfinite(u).any() else float("nan"),
    )


def _length_rms(vectors: FloatArray) -> float:
    """Of vectors (3, n), where they are known; NaN where none is."""
    squares = np.sum(vectors**2, axis=0)
    return float(np.sqrt(np.nanmean(squares))) if np.isfinite(squares).any() else float("nan")


def deviations(model: MachineModel, positions: FloatArray, tool: tuple[float, float, float]) -> FloatArray:
    """(3, n), mm: of the tool point in the workpiece frame, from home; effects are none of it."""
    bare = model.with_values(replace(model.errors, effects=()))
    point = np.array(tool)[:, np.newaxis]
    (there,), (home,) = (bare.view_deviations([("tool_in_workpiece", point)], at) for at in (positions, home_of(bare)))
    return np.asarray(there - home)


def _uncertainty(of: Known, positions: FloatArray, tool: tuple[float, float, float]) -> ToolUncertainty:
    """Of the tool point from home, without effects."""
    point = np.array(tool)[:, np.newaxis]
    bare = of.model.with_values(replace(of.model.errors, effects=()))
    return tool_uncertainty(bare, of.covariance, positions, point, datum=home_of(of.model))


def _slices(now: Known, tool: tuple[float, float, float]) -> tuple[Slice, ...]:
    """Length of the deviation from home, mm: one for each pair of linear axes, other linear axes in the middle, rotary
    axes at home.
    """
    return tuple(
        one.slice(np.linalg.norm(deviations(now.model, one.positions, tool), axis=0))
        for one in middle_planes(now.model, STEPS)
    )


def _rms(values: FloatArray) -> float:
    return float(np.sqrt(np.mean(values**2)))
