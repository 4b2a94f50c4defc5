"""NC blocks with compensated axis words."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import PlainRun
from trueaxis.compensation.kept_arcs import NO_PIECES, Pieces
from trueaxis.compensation.machine import LINEAR, FloatArray
from trueaxis.compensation.moves import KeptHole, Move, Zero
from trueaxis.compensation.path import MoveTable
from trueaxis.compensation.run_text import RunBlocks
from trueaxis.compensation.settings import MM_PER_INCH, Settings, decimals

_LEAST_SHARE = 1e-6  # of the time of a block: a piece of no length has an F all the same
_F_DIGITS = 7  # of F under G93: times are then right to a part in a million
_HOLDS = 1e-9  # mm, deg: positions closer than this are the same


class BlockWriter:
    """Writes moves; holds the number formats of a machine's words."""

    def __init__(self, axes: tuple[str, ...], settings: Settings) -> None:
        self._axes, self._formats, self._digits, self._units, self._steps = axes, {}, {}, {}, {}
        for inch in (False, True):
            linear = settings.inch_step if inch else settings.resolution
            steps = [linear if axis in LINEAR else settings.rotary_resolution for axis in axes]
            # always with a decimal point: some controls read X100 as 0.1 mm
            digits = [max(decimals(step), 1) for step in steps]
            self._formats[inch] = [
                (step, f"{axis}%.{of_axis}f") for axis, step, of_axis in zip(axes, steps, digits, strict=True)
            ]
            self._digits[inch] = digits
            self._steps[inch] = linear
            self._units[inch] = np.array([[round(step * 10**n)] for step, n in zip(steps, digits, strict=True)])

    def texts(
        self,
        moves: MoveTable,
        owner: NDArray[np.int64],
        positions: FloatArray,
        previous: FloatArray,
        lattices: tuple[FloatArray, FloatArray],
        programmed: tuple[FloatArray, FloatArray],
        shares: FloatArray,
        arcs: Pieces = NO_PIECES,
    ) -> list[str]:
        """One text for each item of the table: its blocks, or the blocks they have become.

        owner: (n,), move of each executed position; positions, previous: (n_axes, n), named by the words and by those
        before them (NaN: not known); lattices: mm or deg per step of a word, and position minus word in G90,
        (n_axes, n); programmed: end and start of the move that each belongs to, (n_axes, n); shares: (n,), of the time
        of that move; arcs: of the positions that end one, ascending.
        Raises ValueError rather than write a position that is not finite.
        """
        if not np.isfinite(positions).all():
            raise ValueError("a position to be written is not finite")
        absolute = moves.absolute[owner]
        with np.errstate(invalid="ignore"):
            stays = np.abs(positions - previous) < _HOLDS
        steps, shift = lattices
        origin = np.where(absolute, shift, previous)
        all_counts = np.rint((positions - origin) / steps).astype(np.int64)
        # a word may stay as it is where it names the position to be reached, and an increment where it starts as it did
        ends, starts = programmed
        with np.errstate(invalid="ignore"):
            held_end = (np.abs(positions - ends) < _HOLDS).all(axis=0)
            held_start = (np.abs(previous - starts) < _HOLDS).all(axis=0)
        all_unchanged = held_end & (absolute | held_start)
        pieces = np.bincount(owner, minlength=len(moves))
        edges = [0, *np.cumsum(pieces).tolist()]
        out = []
        move_number = 0
        for item in moves.items:
            count = item.count if isinstance(item, PlainRun) else 1
            of_item = pieces[move_number : move_number + count]
            whole = slice(edges[move_number], edges[move_number + count])
            counts, stay, unchanged = all_counts[:, whole], stays[:, whole], all_unchanged[whole]
            of_arcs = arcs
            if arcs.at.size:
                of_arcs = arcs.some(np.arange(*np.searchsorted(arcs.at, [whole.start, whole.stop])))
            if isinstance(item, PlainRun):
                of_arcs = of_arcs._replace(at=of_arcs.at - whole.start)
                blocks = RunBlocks(
                    run=item, pieces=of_item, counts=counts * self._units[item.inch], stay=stay, unchanged=unchanged,
                    cut=of_item > 1, arcs=of_arcs,
                )  # fmt: skip
                out.append(blocks.text(self._axes, self._digits[item.inch], self._steps[item.inch]))
            elif count == of_item[0] and not of_arcs.at.size:
                out.append(self._single(item, counts[:, 0].tolist(), stay[:, 0].tolist(), bool(unchanged[0])))
            else:
                centres = [self._centre(item, of_arcs, block) for block in range(whole.start, whole.stop)]
                out.append(self._several(item, counts.T.tolist(), stay.T.tolist(), shares[whole], centres))
            move_number += count
        return out

    def zero(self, block: Zero, written: FloatArray, programmed: FloatArray) -> str:
        """A block that gives axes new values where they stand: where the words, not the program, have put them.

        written, programmed: (n_axes,), mm and deg. A word has the decimals that it needs, up to 7.
        """
        if all(abs(written[row] - programmed[row]) < _HOLDS for row in block.rows):
            return block.source
        words = []
        for row in block.rows:
            axis = self._axes[row]
            scale = MM_PER_INCH if block.inch and axis in LINEAR else 1.0
            step, form = self._formats[block.inch][row]
            value = (written[row] - block.shift[row]) / scale
            on_step = abs(value - round(value / step) * step) < _HOLDS
            words.append(f"{axis}{value:.7f}" if not on_step else form % value)
        return f"{block.lead}{block.gap.join(words)}{block.tail}"

    def hole(self, hole: KeptHole, bottom: FloatArray, top: float) -> str:
        """A hole of a cycle that stays one; bottom: (n_axes,), top: position of Z at R, mm, as words name them."""
        shift = hole.shift or (0.0,) * len(self._axes)
        words = []
        for letter, axis in (("X", "X"), ("Y", "Y"), ("Z", "Z"), ("R", "Z")):
            row = self._axes.index(axis)
            step, form = self._formats[hole.inch][row]
            value = (top if letter == "R" else float(bottom[row])) - shift[row]
            words.append(letter + form[1:] % (round(value / (MM_PER_INCH if hole.inch else 1.0) / step) * step))
        return f"{hole.lead}{hole.gap.join(words)}{hole.tail}{hole.eol}"

    def _single(self, move: Move, counts: list[int], stay: list[bool], unchanged: bool) -> str:
        if unchanged and move.source and all(held or written for held, written in zip(stay, move.written, strict=True)):
            return move.source
        words = self._words(move, counts, stay, move.written)
        return f"{move.lead}{words}{move.tail}{move.eol}"

    def _several(
        self,
        move: Move,
        counts: list[list[int]],
        stay: list[list[bool]],
        shares: FloatArray,
        centres: Sequence[str],
    ) -> str:
        """The blocks that a block becomes; centres: the words of those that are arcs, with the gap before them."""
        lead, tail, last = move.split or (move.lead, move.tail, "")
        if len(counts) == 1:
            tail, last = move.tail, ""
        none = (False,) * len(move.written)
        eol = move.eol or "\n"
        feeds = [_feed(move, share) for share in shares.tolist()] if len(counts) > 1 else [""]
        if move.round is not None and centres[0]:
            lead = move.round.lead if len(counts) == 1 else move.round.split_lead
        first = self._words(move, counts[0], stay[0], move.written)
        parts = [f"{lead}{first}{centres[0]}{feeds[0]}{tail}"]
        before = centres[0]
        for count, held, feed, centre in zip(counts[1:], stay[1:], feeds[1:], centres[1:], strict=True):
            words = self._words(move, count, held, none)
            if not words:
                continue
            code = ""
            if move.round is not None and (centre or before or move.round.last):
                code = move.round.code if centre else move.round.line
            parts.append(f"{move.again}{code}{words}{centre}{feed}")
            before = centre
        if last:
            parts[-1 if len(parts) > 1 else 0] += last
        return eol.join(parts) + move.eol

    def _centre(self, move: Move, arcs: Pieces, block: int) -> str:
        """The words of the centre or radius of a block that is an arc, with the gap before them; empty: it is none."""
        number = int(np.searchsorted(arcs.at, block))
        if number == arcs.at.size or arcs.at[number] != block or move.round is None:
            return ""
        scale = MM_PER_INCH if move.inch else 1.0
        step, form = self._formats[move.inch][self._axes.index("X")]
        digits = form[1:]

        def word(letter: str, value: float) -> str:
            return f"{move.gap}{letter}{digits % (round(value / scale / step) * step)}"

        if move.round.centre == "radius":
            return word(move.round.radius, float(arcs.radius[number])) + move.round.last
        centre = zip(arcs.rows[:, number].tolist(), arcs.centre[:, number].tolist(), strict=True)
        return "".join(word("IJK"[row], value) for row, value in sorted(centre))

    def _words(self, move: Move, counts: list[int], stay: list[bool], written: tuple[bool, ...]) -> str:
        formats = self._formats[move.inch]
        if move.ways:
            formats = [
                (step, f"{form[0]}={way}({form[1:]})" if way else form)
                for (step, form), way in zip(formats, move.ways, strict=True)
            ]
        return move.gap.join(
            form % (count * step)
            for (step, form), count, held, named in zip(formats, counts, stay, written, strict=True)
            if named or not held
        )


def _feed(move: Move, share: float) -> str:
    """The F word of a piece that takes a share of the time of its block, under G93; nothing otherwise."""
    if not move.inverse_time:
        return ""
    value = move.inverse_time / max(share, _LEAST_SHARE)
    return f"{move.gap}F{np.format_float_positional(value, precision=_F_DIGITS, fractional=False, trim='0')}"
