"""The first-order design matrix of all readings, in pieces, and its triangular factor."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from trueaxis.estimation.effects.signature import RunRows
from trueaxis.estimation.first_order import sensed, sensed_at_home
from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.observations import Observations
from trueaxis.identify.global_fit.layout import Layout
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.reading_model import home_positions
from trueaxis.runtime.errors import ErrorValues

CHUNK_ENTRIES = 2**21  # of the design matrix at a time: 16 MB


@dataclass(frozen=True, slots=True, eq=False)
class Design:
    """Derivative of every reading by every scaled unknown, never held in full.

    Each row is the basis of each axis times what the instrument senses of each component, less the same at home;
    behind them effects, at the values where they are linearised, and what the instruments themselves add. roots: (n,),
    square roots of the weights of the readings, by which rows are multiplied; None: all 1.
    """

    layout: Layout
    observed: Observations
    roots: FloatArray | None = None

    def pieces(self) -> Iterator[tuple[IntArray, FloatArray]]:
        """(rows, (rows.size, n_unknowns)): pieces of bounded size, run by run."""
        longest = max(CHUNK_ENTRIES // max(self.layout.count, 1), 1)
        for index in range(len(self.observed.runs)):
            rows = np.flatnonzero(self.observed.run == index)
            for start in range(0, rows.size, longest):
                chosen = rows[start : start + longest]
                piece = self._piece(index, chosen)
                if self.roots is not None:
                    piece *= self.roots[chosen, np.newaxis]
                yield chosen, piece

    def triangle(self) -> tuple[FloatArray, npt.NDArray[np.bool_]]:
        """R of the QR factorisation (n_unknowns, n_unknowns), and (n,) which rows hold an unknown."""
        n = self.layout.count
        factor, held = np.zeros((n, n)), np.zeros(self.observed.reading.size, dtype=bool)
        waiting: list[FloatArray] = []
        for rows, piece in self.pieces():
            held[rows] = piece.any(axis=1)
            waiting.append(piece)
            if sum(part.shape[0] for part in waiting) >= 4 * n:
                factor, waiting = _folded(factor, waiting), []
        return _folded(factor, waiting), held

    def transposed(self, residual: FloatArray) -> FloatArray:
        """(n_unknowns,): transposed weighted design times residuals (n,), mm, as they are."""
        total = np.zeros(self.layout.count)
        residual = residual if self.roots is None else self.roots * residual
        for rows, piece in self.pieces():
            total += residual[rows] @ piece
        return total

    def _piece(self, index: int, rows: IntArray) -> FloatArray:
        layout = self.layout
        run, machine = self.observed.runs[index], layout.machine
        positions = self.observed.positions[:, rows]
        moved = layout.effects.set_up(run)
        here, home = sensed(machine, moved, positions), sensed_at_home(machine, moved)
        piece = self._with_bases(here, positions)
        zeroed = home_positions(run, machine.axes)
        if zeroed is not None:
            piece -= self._with_bases(home, zeroed)
        if layout.effects.count:
            piece[:, layout.of_effects] = layout.effects.columns(RunRows(index, rows, here, home))
        if layout.instruments.count:
            piece[:, layout.of_instruments] = layout.instruments.columns(machine, self.observed.runs, index, positions)
        piece[np.abs(piece) < 1e-12] = 0.0  # rounding of what cancels
        return piece

    def at(self, unknowns: FloatArray, given: ErrorValues) -> "Design":
        """Linearised at other values of the effects, whose terms need not be linear; unknowns: (n,), scaled."""
        layout = self.layout
        if not layout.effects.curved:
            return self
        values = unknowns * layout.scale
        moved = layout.effects.at(values[layout.of_effects], layout.values(values, given))
        return replace(self, layout=replace(layout, effects=moved))

    def within(self, unknowns: FloatArray) -> bool:
        """Whether a step to the unknowns (n,), scaled, leaves the effects where their terms make sense."""
        mine = self.layout.of_effects
        return self.layout.effects.within(unknowns[mine] * self.layout.scale[mine])

    def _with_bases(self, sensitivity: FloatArray, positions: FloatArray) -> FloatArray:
        """(n, n_unknowns) from sensitivities (n_components + n_location_errors, n)."""
        layout = self.layout
        piece = np.zeros((positions.shape[1], layout.count))
        values = [basis(at) if basis else None for basis, at in zip(layout.bases, positions, strict=True)]
        for place, component in enumerate(layout.components):
            of_axis = values[layout.axis[place]]
            assert of_axis is not None
            mine = layout.of_component(place)
            piece[:, mine] = (sensitivity[component] * of_axis[: mine.stop - mine.start]).T
        located = len(layout.machine.components) + layout.locations
        piece[:, layout.of_locations] = sensitivity[located].T
        return piece * layout.scale


def _folded(factor: FloatArray, pieces: list[FloatArray]) -> FloatArray:
    if not pieces:
        return factor
    n = factor.shape[0]
    stacked = np.vstack([factor, *pieces])
    return np.asarray(np.linalg.qr(stacked, mode="r"))[:n]
