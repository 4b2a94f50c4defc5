"""CYCL DEF 200 (drilling) of Heidenhain Klartext, called by CYCL CALL or M99: its holes, written out as L."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from trueaxis.compensation.klartext.blocks import KlartextBlock, head_of
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.moves import Item, Kind, Move, Notes, Split
from trueaxis.compensation.nc.cycle_blocks import MOST_PECKS
from trueaxis.compensation.nc.lexer import LARGEST, NUMBER
from trueaxis.compensation.nc.state import Commanded, NcState, missing_axes, unknown_position
from trueaxis.compensation.settings import Settings

_DEFINITION = re.compile(r"CYCLE?[ \t]+DEF[ \t]+(\d+)(?:\.\d+)?", re.IGNORECASE)
_VALUE = re.compile(rf"Q(\d+)[ \t]*=[ \t]*({NUMBER}|\S+)", re.IGNORECASE)
_CALL = re.compile(r"[ \t]*(?:CYCLE?[ \t]+CALL(?=[ \t]*(?:$|;|~|M))|(?<![\w.])M[ \t]*99(?![\w.]))", re.IGNORECASE)
_BARE = re.compile(r"(?:L[ \t]*)?(?:R0[ \t]*)?(?:FMAX[ \t]*)?", re.IGNORECASE)
_DRILLING = 200
# what acts where it is defined leaves the cycle that is called as it was: datum, mirror, dwell, rotation, scaling,
# spindle, contours, tilt, tolerance, preset
_AT_ONCE = frozenset({7, 8, 9, 10, 11, 13, 14, 19, 20, 26, 32, 247})
_NEEDED = frozenset({200, 201, 202, 203, 206})
_OPTIONAL = frozenset({204, 210, 211, 395})
WRITTEN_OUT = (
    "CYCL DEF 200 is written out as L where it is called; between pecks it goes back to Q200 above the last depth"
)
_DWELLS = -1  # beside the kinds of motions
_SAME = 1e-9
_DWELL = "{0}CYCL DEF 9.0 DWELL TIME{2}{0}CYCL DEF 9.1 DWELL {1:g}{2}"


class Drilling(NamedTuple):
    """Lengths as written, in the frame in force. surface: of the part; clearance: how far above it, and above the depth
    of the peck before, the feed begins; clear: where the hole ends; peck: 0 for the whole depth; feed: mm/min or 0.1
    inch/min; dwells (s) at the clearance between pecks, and at the bottom.
    """

    surface: float
    clearance: float
    bottom: float
    clear: float
    peck: float
    feed: float
    dwell_above: float
    dwell: float


def defined(text: str, before: Drilling | None) -> Drilling | None:
    """The cycle that a call means after this block; None: one that is not followed. text: with its comments."""
    plain = re.sub(r";[^\n]*", "", text)
    definition = _DEFINITION.search(plain)
    if definition is None or int(definition[1]) in _AT_ONCE:
        return before
    if int(definition[1]) != _DRILLING:
        return None
    values = {int(name): value for name, value in _VALUE.findall(plain)}
    if not values.keys() >= _NEEDED or not values.keys() <= _NEEDED | _OPTIONAL:
        return None
    if not all(re.fullmatch(NUMBER, value) and abs(float(value)) < LARGEST for value in values.values()):
        return None
    q = {name: float(value) for name, value in values.items()}
    peck, feed, clearance, surface = q[202], q[206], q[200], q[203]
    bottom = surface + q[201]
    right = q[201] < 0.0 < feed and clearance >= 0.0 <= peck and not q.get(395)
    if not right or (peck and -q[201] / peck > MOST_PECKS):
        return None
    clear = surface + max(clearance, q.get(204, 0.0))
    return Drilling(
        surface=surface, clearance=clearance, bottom=bottom, clear=clear, peck=peck, feed=feed,
        dwell_above=q.get(210, 0.0), dwell=q.get(211, 0.0),
    )  # fmt: skip


def without_call(text: str) -> str | None:
    """A block without its call of a cycle, empty if nothing remains; None if it has none."""
    code, sign, comment = text.partition(";")
    if not _CALL.search(code):
        return None
    rest = _CALL.sub("", code.rstrip("\r\n"))
    eol = text[len(text.rstrip("\r\n")) :]
    if _BARE.fullmatch(head_of(f"{rest} ")[2].strip()):
        return ""
    return f"{rest.rstrip()} {sign}{comment}" if sign else rest + eol


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
        self._notes.add(self._number, WRITTEN_OUT)
        for what, z in _steps(drilling):
            if what == _DWELLS:
                yield _DWELL.format(self._head, z, self._eol)
            else:
                yield from self._go(Kind(what), z, drilling.feed)

    def _go(self, kind: Kind, z: float, feed: float) -> Iterator[Item]:
        """A straight motion to Z, as written."""
        state, row = self._state, self._state.row["Z"]
        end = list(state.position)
        end[row] = z * state.scale("Z") + (state.shift[row] if state.shift else 0.0)
        state.motion = int(kind)
        if kind and (missing := missing_axes(state, state.position, end, {"Z"})):
            self._faults.add(self._number, *unknown_position(state, missing))
            return
        state.position, state.moved = end, True
        written = tuple(axis == "Z" for axis in state.axes)
        lead, tail = f"{self._head}L ", f" F{feed:g}" if kind else " FMAX"
        known = tuple(self._assumed[n] if value is None else value for n, value in enumerate(end))
        yield Move(
            self._number, kind, known, written, True, state.inch, lead, tail, " ", self._eol, "", lead,
            Split(lead, tail, ""), passable=False, feed=feed * (2.54 if state.inch else 1.0),
            held=state.commanded.command(written, True), elsewhere=state.commanded.elsewhere,
            unnamed=state.commanded.unnamed, shift=state.shift,
        )  # fmt: skip


def _steps(drilling: Drilling) -> Iterator[tuple[int, float]]:
    """Motions with their ends, and dwells with their times."""
    top = drilling.surface + drilling.clearance
    yield Kind.RAPID, top
    depth = drilling.surface - drilling.peck
    while drilling.peck and depth > drilling.bottom + _SAME:
        yield Kind.LINE, depth
        yield Kind.RAPID, top
        if drilling.dwell_above > 0.0:
            yield _DWELLS, drilling.dwell_above
        yield Kind.RAPID, depth + drilling.clearance
        depth -= drilling.peck
    yield Kind.LINE, drilling.bottom
    if drilling.dwell > 0.0:
        yield _DWELLS, drilling.dwell
    yield Kind.RAPID, drilling.clear
