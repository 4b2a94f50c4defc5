"""The positions that NC words can name."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import LINEAR, FloatArray, rotary_rows
from trueaxis.compensation.settings import MM_PER_INCH, Settings

_SAME = 1e-6  # of a step: what doubles lose in positions of the lattice


@dataclass(frozen=True, slots=True)
class Lattice:
    """Positions base + k step, k whole, of every axis; base and step are (n_axes, 1), mm or deg."""

    base: FloatArray
    step: FloatArray

    def nearest(self, positions: FloatArray, parts: int = 1) -> FloatArray:
        """Nearest position of the lattice, or of the one with steps divided by `parts`."""
        fine = self.step / parts
        return np.asarray(self.base + fine * np.rint((positions - self.base) / fine))

    def within(self, positions: FloatArray, low: FloatArray, high: FloatArray) -> FloatArray:
        """Positions of the lattice, those outside low to high (n_axes, 1) moved to the last one inside."""
        out = (positions < low - _SAME * self.step) | (positions > high + _SAME * self.step)
        if not out.any():
            return positions
        first = np.ceil((low - self.base) / self.step - _SAME)
        last = np.floor((high - self.base) / self.step + _SAME)
        return np.asarray(
            np.where(out, np.clip(positions, *(self.base + self.step * k for k in (first, last))), positions)
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Stretch:
    """Points first to last - 1, whose words are of one kind; step as in Lattice. shift: (n_axes,), position minus word
    of absolute words.
    """

    first: int
    last: int
    absolute: bool
    step: FloatArray
    shift: FloatArray

    def base(self, previous: FloatArray) -> FloatArray:
        """What words count from, (n_axes,); previous: position named by the words before."""
        return self.shift if self.absolute else previous


def word_steps(axes: tuple[str, ...], settings: Settings, inch: bool) -> FloatArray:
    """Step of each axis' words in mm or deg, (n_axes, 1)."""
    linear = settings.inch_resolution * MM_PER_INCH if inch else settings.resolution
    return np.array([[linear if axis in LINEAR else settings.rotary_resolution] for axis in axes])


def stretches(
    absolute: NDArray[np.bool_],
    inch: NDArray[np.bool_],
    shift: FloatArray,
    axes: tuple[str, ...],
    settings: Settings,
) -> Iterator[Stretch]:
    """Runs of points between switches of G90/G91, G20/G21 and offsets; shift: (n_axes, n), of absolute words."""
    kind = absolute * 2 + inch
    switched = (np.diff(kind) != 0) | (np.diff(shift, axis=1) != 0.0).any(axis=0)
    edges = [0, *(np.flatnonzero(switched) + 1).tolist(), kind.size]
    steps = {flag: word_steps(axes, settings, flag) for flag in (False, True)}
    for first, last in pairwise(edges):
        yield Stretch(
            first=first, last=last, absolute=bool(absolute[first]), step=steps[bool(inch[first])], shift=shift[:, first]
        )


def rotary_on_words(
    positions: FloatArray, kinds: Iterable[Stretch], previous: FloatArray, axes: tuple[str, ...]
) -> FloatArray:
    """The positions (n_axes, n) with those of rotary axes as their words name them.

    previous: (n_axes,), what the words before name; increments are counted from there.
    """
    rows = list(rotary_rows(axes))
    out = positions.copy()
    last = previous[rows]
    for kind in kinds:
        part = slice(kind.first, kind.last)
        base = kind.shift[rows] if kind.absolute else last
        out[rows, part] = Lattice(base[:, None], kind.step[rows]).nearest(positions[rows, part])
        last = out[rows, kind.last - 1]
    return out
