"""The holes of drilling cycles of Heidenhain Klartext, written out as L where the cycles are called."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

from trueaxis.compensation.klartext.blocks import KlartextBlock
from trueaxis.compensation.klartext.cycles import PECKING, SAME, Call, Drilling, NotFollowed
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.moves import Item, Kind, Move, Notes, Split
from trueaxis.compensation.nc.state import Commanded, NcState
from trueaxis.compensation.nc.straight import straight_to
from trueaxis.compensation.settings import Settings

WRITTEN_OUT = (
    "CYCL DEF {0} is written out as L where it is called; between pecks it goes back to {1} above the last depth"
)
_ABOVE = {PECKING: "0.6 to 7 mm", 205: "Q258"}
_DWELLS = -1  # beside the kinds of motions
_DWELL = "{0}CYCL DEF 9.0 DWELL TIME{2}{0}CYCL DEF 9.1 DWELL {1:g}{2}"


@dataclass(slots=True)
class ModalFeed:
    """The F in force in the source; changed: whether that of a hole is in force in what is written."""

    word: str = ""
    changed: bool = False

    def restored(self, block: KlartextBlock, text: str) -> tuple[KlartextBlock, str]:
        """A block with F where it moves at one that the source does not say again; its text."""
        if block.feeds:
            self.word = next(word for word in block.others if word[0] in "Ff")
            self.changed = False
        elif self.changed and self.word and block.verb not in ("", "CC") and not block.rapid:
            self.changed = False
            code, sign, comment = text.partition(";")
            eol = "" if sign else text[len(text.rstrip("\r\n")) :]
            text = f"{code.rstrip()} {self.word}{' ' if sign else ''}{sign}{comment}{eol}"
            block = block._replace(others=(*block.others, self.word))
        return block, text


def problem_of(call: Call, cycle: Drilling | NotFollowed, due: bool, state: NcState) -> tuple[str, str] | None:
    """What is wrong with a call; due: whether its block has / or a code due at its end."""
    if isinstance(cycle, NotFollowed):
        return cycle.problem, cycle.remedy
    if due:
        return "a call of a cycle in a block with / or a code due at its end", "two blocks"
    if call.problem:
        return call.problem, "as CYCL CALL POS X+10 Y+20 Z+0 FMAX"
    row = state.row.get("Z")
    if call.goes and row is not None:
        surface = (cycle.surface + call.shift) * state.scale("Z") + (state.shift[row] if state.shift else 0.0)
        z = state.position[row]
        if z is None or state.commanded.of([row]) < Commanded.ABSOLUTE or z < surface:  # it would rise first
            return "CYCL CALL POS from where Z is not certain, or below the surface", "L Z above it before"
    return None


class HoleWriter:
    """Writes the blocks of a hole."""

    def __init__(
        self, number: int, head: str, text: str, state: NcState, settings: Settings, logs: tuple[FaultLog, Notes]
    ) -> None:
        """head: number of the block that calls; text: the whole of it."""
        self._number, self._head, self._eol = number, head, text[len(text.rstrip("\r\n")) :] or "\n"
        self._state, (self._faults, self._notes) = state, logs
        self._assumed = [settings.assumed.get(axis, 0.0) for axis in state.axes]

    def hole(self, drilling: Drilling) -> Iterator[Item]:
        """A hole where X and Y stand."""
        state = self._state
        across = [state.row[axis] for axis in "XY" if axis in state.row]
        if "Z" not in state.row or state.point_control or state.commanded.of(across) < Commanded.ABSOLUTE:
            self._faults.add(
                self._number, "a drilling cycle where X or Y is not certain, or under M128", "command them before, M129"
            )
            return
        if drilling.number == PECKING:
            row, z = state.row["Z"], state.position[state.row["Z"]]
            if z is None or state.commanded.of([row]) < Commanded.ABSOLUTE:
                self._faults.add(self._number, "CYCL DEF 1 from where Z is not certain", "L Z before the call")
                return
            drilling = drilling.raised((z - (state.shift[row] if state.shift else 0.0)) / state.scale("Z"))
        self._notes.add(self._number, WRITTEN_OUT.format(drilling.number, _ABOVE.get(drilling.number, "Q200")))
        for what, z, feed in _steps(drilling):
            if what == _DWELLS:
                yield _DWELL.format(self._head, z, self._eol)
            else:
                yield from self._go(Kind(what), z, feed)

    def _go(self, kind: Kind, z: float, feed: float) -> Iterator[Item]:
        """A straight motion to Z, as written."""
        state, shift = self._state, self._state.shift
        to = z * state.scale("Z") + (shift[state.row["Z"]] if shift else 0.0)
        made = straight_to(self._number, kind, {"Z": to}, state, self._assumed, self._faults)
        if not isinstance(made, Move):
            self._faults.add(self._number, *made)
            return
        lead, tail = f"{self._head}L ", f" F{feed:g}" if kind else " FMAX"
        yield made._replace(
            lead=lead, tail=tail, gap=" ", eol=self._eol, again=lead, split=Split(lead, tail, ""),
            feed=feed * (2.54 if state.inch else 1.0),
        )  # fmt: skip


def _steps(drilling: Drilling) -> Iterator[tuple[int, float, float]]:
    """Motions with their ends and F, and dwells with their times."""
    top, depths, broken = drilling.surface + drilling.clearance, list(drilling.depths()), 0
    yield Kind.RAPID, top, 0.0
    for number, (before, depth) in enumerate(pairwise([drilling.surface, *depths])):
        yield from _chips(drilling, before, depth)
        yield Kind.LINE, depth, drilling.feed
        if depth == depths[-1]:
            break
        if broken < drilling.breaks:
            broken += 1
            yield Kind.RAPID, min(depth + drilling.back, top), 0.0
            continue
        broken = 0
        yield (Kind.LINE if drilling.between else Kind.RAPID), top, drilling.between
        if drilling.dwell_above > 0.0:
            yield _DWELLS, drilling.dwell_above, 0.0
        first, last = drilling.above
        above = first + (last - first) * number / max(len(depths) - 2, 1)
        yield (Kind.LINE if drilling.again else Kind.RAPID), min(depth + above, top), drilling.again
    if drilling.dwell > 0.0:
        yield _DWELLS, drilling.dwell, 0.0
    if drilling.retract:
        yield Kind.LINE, top, drilling.retract
    if drilling.clear > top or not drilling.retract:
        yield Kind.RAPID, drilling.clear, 0.0


def _chips(drilling: Drilling, before: float, depth: float) -> Iterator[tuple[int, float, float]]:
    """Chips that are broken within a peck, from `before` to `depth`."""
    at = before - drilling.broken
    while drilling.broken and at > depth + SAME:
        yield Kind.LINE, at, drilling.feed
        yield Kind.RAPID, min(at + drilling.back, drilling.surface + drilling.clearance), 0.0
        at -= drilling.broken
