"""What canned cycles become, G73 G81 G82 G83 G85 G86 G89, as LinuxCNC and Fanuc make them: the motions in a hole, and
the blocks of one block.
"""

from collections.abc import Iterator

from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.moves import Item, Kind, Move
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc.lexer import Block, Meaning, due_at_end
from trueaxis.compensation.nc.state import NcState
from trueaxis.compensation.nc.straight import straight_to

MOST_PECKS = 10_000

RAPID, FEED, DWELL, SPINDLE_STOP, SPINDLE_START = range(5)
Step = tuple[int, float]  # what is done, and to which position of the axis that drills (machine, mm)
_OF_CYCLE = frozenset("XYZRQPLK")
_RETURN = frozenset({980, 990})  # codes that say where the control's own cycles end


class CycleError(Exception):
    """What is wrong with a block of a cycle, and the remedy."""


DWELLING = (820, 860, 890)  # cycles with a dwell at the bottom


def steps(
    code: int, r: float, bottom: float, clear: float, peck: tuple[float, float], dwells: bool
) -> Iterator[Step]:  # fmt: skip
    """What a cycle does in one hole, from R on; r, bottom, clear (where it ends): mm, machine coordinates; peck: how
    deep, and how far back, mm.
    """
    deep, back = peck
    if code in (730, 830):
        depth = r - deep
        while depth > bottom + 1e-9:
            yield FEED, depth
            if code == 830:
                yield RAPID, r
            yield RAPID, depth + min(back, r - depth)
            depth -= deep
    yield FEED, bottom
    if dwells and code in DWELLING:
        yield DWELL, bottom
    if code == 860:
        yield SPINDLE_STOP, bottom
    if code in (850, 890):
        yield FEED, r
    if clear != r or code not in (850, 890):
        yield RAPID, clear
    if code == 860:
        yield SPINDLE_START, clear


class CycleWriter:
    """Makes the blocks of one block of a cycle. with_return: whether G98 and G99 are written with the motions, for
    cycles that the control is left with.
    """

    def __init__(
        self,
        state: NcState,
        number: int,
        body: str,
        block: Block,
        eol: str,
        again: str,
        assumed: list[float],
        faults: FaultLog,
        *,
        with_return: bool,
    ) -> None:
        self._state, self._number, self._assumed, self._faults = state, number, assumed, faults
        self._eol, self._again = eol or "\n", again
        if " " in body or "\t" in body:
            state.gap = " "
        elif len(block.words) > 1:
            state.gap = ""
        self._lead, self._comment, self._last = _kept(body, block, state.gap, again, with_return)
        self._items: list[Item] = []
        self._wrong = False

    def fault(self, problem: str, remedy: str) -> None:
        """Note what is wrong."""
        self._wrong = True
        self._faults.add(self._number, problem, remedy)

    def finished(self) -> list[Item]:
        """The blocks."""
        if self._last and not self._wrong:
            self.say(self._last)
        return self._items

    def alone(self) -> list[Item]:
        """What stays of a block whose cycle does nothing."""
        text = (self._lead.rstrip() + self._comment + self._last).strip()
        return [f"{text}{self._eol}"] if text else []

    def say(self, text: str) -> None:
        """A block that moves nothing."""
        self._items.append(f"{self._again}{text}{self._eol}")

    def across(self, meaning: Meaning) -> bool:
        """Over the hole, by the X and Y of the block; False after a fault."""
        if not meaning.axes:
            return True
        end = self._state.after(meaning.axes)
        if None in [end[self._state.row[axis]] for axis in meaning.axes]:
            self.fault(f"the position of {' '.join(meaning.axes)} is not known here", "G90 G0 in the program first")
            return False
        return self.go(Kind.RAPID, {axis: end[self._state.row[axis]] or 0.0 for axis in meaning.axes})

    def go(self, kind: Kind, ends: dict[str, float]) -> bool:
        """A straight motion of some axes, to machine positions, mm; False after a fault."""
        state, before = self._state, self._faults.count
        made = straight_to(self._number, kind, ends, state, self._assumed, self._faults)
        if not isinstance(made, Move):
            if not self._wrong:
                self.fault(*made)
            return False
        state.in_force = int(kind)
        lead = self._lead + ("G1" if kind else "G0") + state.gap
        self._items.append(
            made._replace(
                lead=lead, tail=self._comment, gap=state.gap, eol=self._eol, again=self._again,
                feed=state.feed_in_minutes,
            )
        )  # fmt: skip
        self._lead, self._comment = self._again, ""
        return self._faults.count == before


def _kept(body: str, block: Block, gap: str, again: str, with_return: bool) -> tuple[str, str, str]:
    """What stays of a block of a cycle: text before its first motion, comments behind it, words due at the end."""
    lead: list[str] = []
    last: list[str] = []
    comment, place = "", 0
    out = codes.CYCLES if with_return else codes.CYCLES | _RETURN
    for word in block.words:
        between, place = body[place : word.start].strip(" \t").removeprefix(again), word.end
        comment += f" {between.strip()}" if between.strip() else ""
        if word.letter in _OF_CYCLE or (word.letter == "G" and round(word.value * 10) in out):
            continue
        (last if due_at_end(word) else lead).append(body[word.start : word.end])
    comment += f" {body[place:].strip()}" if body[place:].strip() else ""
    head = gap.join(lead)
    return again + head + (gap if head else ""), comment, gap.join(last)
