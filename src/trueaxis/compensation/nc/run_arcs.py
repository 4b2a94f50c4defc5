"""The arcs of a run of blocks, all of them at once: what `arc_of_block` makes of one."""

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.arcs import (
    Numbers,
    Point,
    WordRounding,
    allowed_about,
    allowed_beyond_radius,
    centre_of_radius,
    end_radii,
    half_chord,
    half_unit,
    radii_fit,
    radius_fits,
    rounding_of,
    sweep_between,
)
from trueaxis.compensation.columns import NO_ARCS, Arcs
from trueaxis.compensation.machine import LINEAR, FloatArray
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc.lexer import decimals_of
from trueaxis.compensation.nc.modes import undotted_decimals
from trueaxis.compensation.nc.plain_text import LETTERS, PlainText
from trueaxis.compensation.nc.state import NcState
from trueaxis.compensation.path import holds_arc
from trueaxis.compensation.settings import MM_PER_INCH, Settings

_CENTRE, _RADIUS = LETTERS.index("I"), LETTERS.index("R")
_COUNTER_CLOCKWISE = 3


class ArcReader:
    """Reads the arcs of the runs of one program."""

    def __init__(self, state: NcState, settings: Settings) -> None:
        self._state, self._settings = state, settings

    def read(
        self,
        lines: PlainText,
        index: NDArray[np.int64],
        motion: NDArray[np.int64],
        first: FloatArray,
        ends: FloatArray,
    ) -> tuple[Arcs, int]:
        """The arcs among moves, and the number of the first move that should be one and is none (of all, if all are).

        index: (n,), line of each move; motion: (n,); first: (n_axes, 1), where the first begins; ends: (n_axes, n),
        where they end, mm and deg.
        """
        number = np.flatnonzero(motion > 1)
        if not number.size:
            return NO_ARCS, index.size
        state = self._state
        across = codes.PLANES[state.plane][2]
        rows = [state.row[axis] for axis in LINEAR]
        before = np.concatenate([first, ends[:, :-1]], axis=1)
        start, end = (_point(of[rows][:, number]) for of in (before, ends))
        sense = np.where(motion[number] == _COUNTER_CLOCKWISE, 1.0, -1.0)
        normal = _point(np.array([sense * (axis == across) for axis in LINEAR]))
        words = self._words(lines, index, number)
        by_radius = words[3] != 0.0
        flat = _point(np.where(np.array([[axis == across] for axis in LINEAR]), np.array(start), np.array(end)))
        rounding = self._rounding(lines, index, number)
        about = _point(np.array(start) + words[:3])
        with np.errstate(invalid="ignore", divide="ignore"):  # what is no arc is not taken
            of_radius = np.array(centre_of_radius(start, end, words[3], normal))
            centre = _point(np.where(by_radius, of_radius, np.array(about)))
            allowed: Numbers = np.inf if self._settings.judged else allowed_about(start, flat, about, rounding)
            beyond = allowed_beyond_radius(start, flat, rounding)
            right = np.where(
                by_radius,
                (words[:3] == 0.0).all(axis=0) & radius_fits(half_chord(start, end, normal), words[3], beyond),
                (words[LINEAR.index(across)] == 0.0) & radii_fit(*end_radii(start, end, about, normal), allowed),
            )
            sweep = sweep_between(start, end, centre, normal)
        turns_about = [float(axis == across) for axis in LINEAR]
        stays = self._settings.arcs == "keep" and not holds_arc(state.commanded.held[state.absolute], turns_about)
        arcs = Arcs(
            index=number, centre=np.array(centre), normal=np.array(normal), sweep=sweep, by_radius=by_radius,
            kept=np.full(number.size, stays),
        )  # fmt: skip
        wrong = np.flatnonzero(~right)
        if not wrong.size:
            return arcs, index.size
        return arcs.some(np.arange(wrong[0])), int(number[wrong[0]])

    def _words(self, lines: PlainText, index: NDArray[np.int64], number: NDArray[np.int64]) -> FloatArray:
        """I J K R of the arcs, mm, (4, k); 0 where there is none."""
        of_text = slice(lines.first[index[0]], lines.first[index[-1] + 1])
        letter = lines.letter[of_text]
        centre = np.flatnonzero(letter >= _CENTRE)
        arc = np.searchsorted(index[number], lines.line[of_text][centre])
        words = np.zeros((4, number.size))
        words[letter[centre] - _CENTRE, arc] = lines.value[of_text][centre]
        return words * MM_PER_INCH if self._state.inch else words

    def _rounding(self, lines: PlainText, index: NDArray[np.int64], number: NDArray[np.int64]) -> WordRounding:
        """Rounding of the words of the arcs and of those that gave their starts."""
        state = self._state
        of_text = slice(lines.first[index[0]], lines.first[index[-1] + 1])
        decimals = lines.decimals[of_text]
        most = np.maximum.reduceat(np.maximum(decimals, 0), lines.first[index] - lines.first[index[0]])
        plane = codes.PLANES[state.plane]
        undotted = undotted_decimals(state.inch, self._settings.undotted)
        counts, known = np.full(number.size, -1), np.zeros(number.size)
        for axis in plane[:2]:
            before = state.numbers[state.row[axis]]
            start = -1
            if isinstance(before, str):
                found = decimals_of(before)
                start = undotted if found is None else found
            words = np.flatnonzero(lines.letter[of_text] == LETTERS.index(axis))
            given = np.append(start, np.where(decimals[words] < 0, undotted, decimals[words]))
            latest = np.searchsorted(lines.line[of_text][words], index[number])  # words of earlier lines
            counts = np.maximum(counts, given[latest])
            if isinstance(before, float):
                known = np.maximum(known, np.where(latest == 0, before, 0.0))
        unit = np.maximum(np.where(counts >= 0, half_unit(counts, state.inch), 0.0), known)
        in_plane = [axis != plane[2] for axis in LINEAR]
        return rounding_of(in_plane, most[number], unit, state.absolute, state.inch)


def _point(rows: FloatArray) -> Point:
    x, y, z = rows
    return x, y, z
