"""Which positions a program visits, how far it is corrected there, and how far it relies on what was measured: bounded,
however long it is.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
import numpy.typing as npt

from trueaxis.compensation.columns import columns_of
from trueaxis.compensation.machine import ROTARY, ErrorModel, FloatArray, Place, linear_rows, rotary_rows
from trueaxis.compensation.solve import SINGULAR
from trueaxis.model.covariance import Covariance
from trueaxis.model.extent import UncertaintyExtent, table_positions, uncertainty_extent
from trueaxis.model.measured_range import BeyondMeasured, beyond_measured
from trueaxis.model.model import MachineModel, home_of
from trueaxis.model.uncertainty import prior_size

MOST_CELLS = 8000  # of a program: u at so many positions takes about half a second
# Errors do not differ within a cell of these, half a millimetre of a travel of 500 mm.
FINEST = 1024  # cells along an axis; a power of two: halves are whole
MOST_SAMPLES = 500_000  # along the motions of one batch: 30 MB


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _Cells:
    """keys: (m,), which cells; position: (n_axes, m), mm or deg, where the correction (m,) is largest in each; low,
    high: (n_axes, m), what the axes pass within it.
    """

    keys: npt.NDArray[np.int64]
    position: FloatArray
    correction: FloatArray
    low: FloatArray
    high: FloatArray

    @classmethod
    def none(cls, axes: int) -> "_Cells":
        """Nothing visited."""
        empty = np.zeros((axes, 0))
        return cls(keys=np.zeros(0, np.int64), position=empty, correction=np.zeros(0), low=empty, high=empty)

    def each_once(self) -> "_Cells":
        """With what was visited of the same cell together; of equal corrections the first stays."""
        if not self.keys.size:
            return self
        stays = 2 * np.count_nonzero(np.diff(self.keys)) < self.keys.size  # a while in each cell, as most programs do
        few = self._together(slice(None)) if stays else self
        return few._together(np.argsort(few.keys, kind="stable"))

    def _together(self, order: slice | npt.NDArray[np.int64]) -> "_Cells":
        """In an order, with what stands side by side of the same cell together."""
        keys, correction = self.keys[order], self.correction[order]
        low, high = columns_of(self.low, order), columns_of(self.high, order)
        first = np.flatnonzero(np.diff(keys, prepend=keys[0] - 1))
        largest = np.maximum.reduceat(correction, first)
        there = np.flatnonzero(correction == np.repeat(largest, np.diff(first, append=keys.size)))
        chosen = there[np.searchsorted(there, first)]
        return _Cells(
            keys=keys[first], correction=largest,
            position=columns_of(self.position, chosen if isinstance(order, slice) else order[chosen]),
            low=np.minimum.reduceat(low, first, axis=1), high=np.maximum.reduceat(high, first, axis=1),
        )  # fmt: skip

    def and_later(self, later: "_Cells") -> "_Cells":
        """Together with what was visited later."""
        names = ("keys", "position", "correction", "low", "high")
        return _Cells(**{name: np.hstack([getattr(self, name), getattr(later, name)]) for name in names}).each_once()


class Visited:
    """Cells that a program comes to or passes through, each with a position of the program in it. They are as small as
    their bounded number allows: axes that stand still make no cells.

    tool_point: the one that came there, (3, 1), mm, tool frame. largest_turn: the largest correction of a rotary axis,
    deg, at the programmed position `turned_at`, (n_axes,). datum: from where corrections count; None: home.
    """

    def __init__(self, model: ErrorModel, tool_point: FloatArray, datum: Place | None = None) -> None:
        self.tool_point, self.datum = tool_point, datum
        self._linear, self._rotary = list(linear_rows(model.axes)), list(rotary_rows(model.axes))
        low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T
        self._low = low[:, np.newaxis]
        self._travel = np.maximum(high - low, 1e-9)[:, np.newaxis]
        self._each = FINEST
        count = len(model.axes)
        self._cells = _Cells.none(count)
        self._lowest, self._highest = np.full(count, np.inf), np.full(count, -np.inf)
        self._directions = np.array([*np.eye(count), *-np.eye(count), *product((-1.0, 1.0), repeat=count)])
        self._farthest = np.zeros((count, 0))
        self.largest_turn, self.turned_at = 0.0, low

    def add(self, origins: FloatArray, positions: FloatArray, moved: FloatArray) -> None:
        """Note motions from origins to positions, (n_axes, n), mm or deg, and what their ends are corrected by.

        An origin that is not known is NaN.
        """
        if positions.shape[1] == 0:
            return
        self._lowest = np.minimum(self._lowest, positions.min(axis=1))
        self._highest = np.maximum(self._highest, positions.max(axis=1))
        candidates = np.hstack([self._farthest, positions])
        self._farthest = candidates[:, np.argmax(self._directions @ (candidates / self._travel), axis=1)]
        turns = np.abs(moved[self._rotary]).max(axis=0, initial=0.0)
        if turns.max() > self.largest_turn:
            self.largest_turn, self.turned_at = float(turns.max()), positions[:, int(np.argmax(turns))]
        corrections = np.sqrt((moved[self._linear] ** 2).sum(axis=0))
        way = np.where(np.isnan(origins), 0.0, positions - origins)
        while (parts := self._parts(way)).sum() > MOST_SAMPLES and self._each > 1:
            self._halve()
        if parts.max() > 1:
            begin = np.cumsum(parts) - parts
            share = (np.arange(parts.sum()) - np.repeat(begin, parts)) / np.repeat(parts, parts)
            ends, corrections = corrections, np.zeros(share.size)
            corrections[begin] = ends
            positions = np.repeat(positions, parts, axis=1) - share * np.repeat(way, parts, axis=1)
            way = np.repeat(way / parts, parts, axis=1)
        self._note(positions, way, corrections)
        while self._cells.keys.size > MOST_CELLS:
            self._halve()

    def _parts(self, way: FloatArray) -> npt.NDArray[np.int64]:
        """(n,): into how many motions are divided: each shorter than a cell, so that none is passed over along the axis
        that passes most of them.
        """
        return np.asarray(np.abs(way / self._travel).max(axis=0) * self._each, dtype=np.int64) + 1

    def _note(self, positions: FloatArray, step: FloatArray, corrections: FloatArray) -> None:
        """Note positions (n_axes, n) that are reached by a step (n_axes, n)."""
        before = positions - step
        place = np.clip(((positions - self._low) / self._travel * self._each).astype(np.int64), 0, self._each - 1)
        found = _Cells(
            keys=self._strides @ place, position=positions, correction=corrections,
            low=np.minimum(positions, before), high=np.maximum(positions, before),
        )  # fmt: skip
        self._cells = self._cells.and_later(found.each_once())

    def _halve(self) -> None:
        """Make cells twice as long along every axis."""
        place = self._cells.keys // self._strides[:, np.newaxis] % self._each // 2
        self._each //= 2
        self._cells = replace(self._cells, keys=self._strides @ place).each_once()

    @property
    def _strides(self) -> npt.NDArray[np.int64]:
        return self._each ** np.arange(self._lowest.size, dtype=np.int64)

    @property
    def positions(self) -> FloatArray:
        """(n_axes, m): for each cell where its largest correction is, mm or deg."""
        return self._cells.position

    @property
    def corrections(self) -> FloatArray:
        """(m,): the largest correction in each cell, mm."""
        return self._cells.correction

    @property
    def ends(self) -> FloatArray:
        """(n_axes, 2): lowest and highest position of each axis, mm or deg; nothing visited: (n_axes, 0)."""
        if not self._cells.keys.size:
            return np.zeros((self._lowest.size, 0))
        return np.stack([self._lowest, self._highest], axis=1)

    def samples(self, nodes: Sequence[Sequence[float]]) -> FloatArray:
        """(n_axes, k), mm or deg: positions of the program: one of each cell, those farthest out, and where it passes
        nodes: of each axis, positions at which curves may have what they have nowhere else.
        """
        return np.hstack([self.positions, self._farthest, *self._at_nodes(nodes)])

    def _at_nodes(self, nodes: Sequence[Sequence[float]]) -> Iterator[FloatArray]:
        for row, of_axis in enumerate(nodes):
            for node in of_axis:
                at = self.positions[:, (self._cells.low[row] <= node) & (node <= self._cells.high[row])]
                at[row] = node
                yield at


# Corrections that the prior makes likely: three standard deviations. What is larger comes from a slip (um for mm, a
# sign, another machine's values) far more often than from a machine.
PRIOR_SIZES = 3.0


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
    tool point at home, mm; 0 from another datum. too_uncertain, too_large: which limit is passed; nothing is written.
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
    too_uncertain: bool
    too_large: bool

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
        return Reliance(
            uncertainty=extent,
            beyond=beyond_measured(model.errors, model.axes, np.hstack([positions, visited.ends])),
            largest_correction=0.0 if worst is None else float(corrections[worst]),
            allowed_correction=None if worst is None else float(allowed[worst]),
            correction_at={} if worst is None else dict(zip(model.axes, positions[:, worst].tolist(), strict=True)),
            largest_turn=visited.largest_turn,
            allowed_turn=allowed_turn,
            turned_at=dict(zip(model.axes, visited.turned_at.tolist(), strict=True)),
            at_home=float(np.linalg.norm(model.deviation(home_of(model), tool_point))) * (visited.datum is None),
            too_uncertain=extent.refused(limits.max_u, limits.accept_u),
            too_large=(worst is not None and bool(corrections[worst] > allowed[worst]))
            or (allowed_turn is not None and visited.largest_turn > allowed_turn),
        )

    return judge


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
