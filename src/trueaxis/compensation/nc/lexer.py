"""One block of an NC program as words (ISO 6983-1, RS-274), what it asks for, and its text without its axis words."""

import re
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

from trueaxis.compensation.machine import ROTARY
from trueaxis.compensation.moves import Split
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.nc.canned_cycle import DrillingCall
from trueaxis.compensation.nc.g_codes import EXACT_STOP
from trueaxis.compensation.nc.mistyped import mistyped
from trueaxis.compensation.settings import LEAST_DEG, LEAST_INCH, LEAST_MM

# possessive quantifiers: no backtracking, so a hostile block costs linear time; none of groups, which Python before
# 3.11.5 gets wrong
NUMBER = r"[-+]?+(?:\d++\.?+\d*+|\.\d++)"
_TOKEN = re.compile(rf"([ \t]++)|([A-Za-z])[ \t]*+({NUMBER})|(\([^()]*+\)|;.*+)")
_MACRO = re.compile(r"[#\[\]=<>&|]|(?i:\b(?:WHILE|END\d|GOTO\d*+|IF|CALL|SUB|ENDSUB|DEF|PROC|REPEAT|FOR|SET)\b)")
LARGEST = 1e9  # of a word's number: what is more is no machine's
# LinuxCNC runs such a comment as Python, which may do anything
_PYTHON = re.compile(r"[(;][ \t]*+py[ \t]*+,", re.IGNORECASE)
_FURTHER_BLOCK = re.compile(rf";[ \t;]*+(?:[A-Z][ \t]*+{NUMBER}[ \t;]*+)+", re.IGNORECASE)
_CORNER = re.compile(r",[ \t]*+[RC]", re.IGNORECASE)
_NAME = re.compile(r"[A-Za-z_]{2}\w*+:?")


class Word(NamedTuple):
    """An address and its value; start and end are the place in the block, decimals the digits written after the decimal
    point, None where there is none.
    """

    letter: str
    value: float
    start: int
    end: int
    decimals: int | None

    @property
    def dot(self) -> bool:
        """Whether the number has a decimal point."""
        return self.decimals is not None


class Block(NamedTuple):
    """Words of a block in order; problem is what is wrong with its text, empty if nothing is; mended: the text with the
    number put right that it says to be mistyped.
    """

    words: tuple[Word, ...]
    problem: str
    macro: bool = False  # whether that is a macro, a variable or an expression
    mended: str = ""


def lex(body: str, begin: int = 0) -> Block:
    """Words of a block, comments left out; `body` has no line end, reading begins at `begin`."""
    words: list[Word] = []
    place = begin
    while place < len(body):
        token = _TOKEN.match(body, place)
        if token is None:
            if wrong := mistyped(body, place):
                return Block(tuple(words), f"column {place + 1}: {wrong.problem}", mended=wrong.mended)
            return Block(tuple(words), f"column {place + 1}: {_wrong(body, place)}", _is_macro(body, place))
        if token[2]:
            if token[2] in "Oo" and words and words[-1].end == place and (wrong := mistyped(body, place)):
                return Block(tuple(words), f"column {place + 1}: {wrong.problem}", mended=wrong.mended)
            if abs(value := float(token[3])) > LARGEST:
                return Block(tuple(words), beyond(token[2], token[3]))
            words.append(Word(token[2].upper(), value, place, token.end(), decimals_of(token[3])))
        elif token[4] and (problem := active_comment(token[4], bool(words))):
            return Block(tuple(words), f"column {place + 1}: {problem}")
        place = token.end()
    return Block(tuple(words), "")


def beyond(letter: str, number: str) -> str:
    """What is wrong with a word above `LARGEST`."""
    return f"{letter} has the value {number[:20]}..., which is no machine's"


def decimals_of(number: str) -> int | None:
    """Digits after the decimal point of a number as written; None where there is none."""
    return len(number.partition(".")[2]) if "." in number else None


def active_comment(text: str, after_words: bool) -> str:
    """Why a comment could do more than comment; empty if it cannot."""
    if _PYTHON.match(text):
        return "LinuxCNC runs this comment as Python, which is not followed"
    if after_words and _FURTHER_BLOCK.fullmatch(text):
        return "; ends a block on some controls and begins a comment on others, and words follow it"
    return ""


def _is_macro(body: str, place: int) -> bool:
    return body[place] != "(" and bool(_MACRO.search(body, place))


def _wrong(body: str, place: int) -> str:
    sign = body[place]
    if sign == "(":
        return "a comment that is not closed, or holds another"
    if _is_macro(body, place):
        return f"{body[place : place + 20]!r} is a macro, variable or expression; its value is not followed"
    if word := _NAME.match(body, place):
        return f"{word[0]!r} is no address with its number"
    if sign.isascii() and sign.isalpha():
        return f"address {sign} without a number"
    if _CORNER.match(body, place):
        return f"{body[place : place + 10]!r} rounds or chamfers a corner: write it as an arc or a line"
    return f"{sign!r} does not belong in a block"


# F counts mm/min (deg/min), by turns of the spindle, or 1/min of the block
FeedMode = Literal["minute", "turn", "time"]


@dataclass(slots=True, kw_only=True)
class Meaning:
    """A block taken apart; complaints are (problem, remedy) and none may be passed over.

    motion, plane, inch, absolute, feed (as written): None where the block says nothing of it. feed_mode: how F counts,
    empty: not said. axes: words that are positions. decimals: digits written after the decimal point of axis and arc
    words. undotted: letters of axis and arc words other than 0 without a decimal point. parameters: values of P Q L E.
    system: the work offset that it selects; data_code: a code (times ten) whose axis words are data: `data`, by letter,
    R too. length_code: G43 or G49 (times ten); length_of: the H word of G43. cycle: a canned cycle that it begins (code
    times ten); drilling: whether its axis words are those of a cycle, with R in `data`; at_initial_level: G98, or G99.
    look_ahead: a code (times ten) of looking ahead, 0: none. turns: whether P counts turns of an arc (LinuxCNC).
    point_control: whether it switches tool centre point control on or off.
    ways: for letters with `AC` or `IC` (SINUMERIK) whether they are absolute; turning: `DC`, `ACP` or `ACN`. frame:
    why axis words beside a data_code would be no shift; call: a cycle that is called; notes: remarks on the block.
    unknown: a G code that is none of those known. tool: the T word, as `T2`; tool_name: of a tool that is called by its
    name. changes_tool: whether the block may change the tool, see tool_changes. in_spindle: the tool that it says to be
    in the spindle (M61 of LinuxCNC).
    """

    motion: int | None = None
    plane: int | None = None
    inch: bool | None = None
    absolute: bool | None = None
    feed_mode: FeedMode | Literal[""] = ""
    feed: float | None = None
    cancel_cycle: bool = False
    exact_stop: bool = False
    dwell: bool = False
    codes: set[int] = field(default_factory=set)
    miscellaneous: list[int] = field(default_factory=list)
    axes: dict[str, float] = field(default_factory=dict)
    centre: dict[str, float] = field(default_factory=dict)
    radius: float | None = None
    program_number: bool = False
    tool: str = ""
    tool_name: str = ""
    changes_tool: bool = False
    in_spindle: int | None = None
    undotted: set[str] = field(default_factory=set)
    decimals: dict[str, int] = field(default_factory=dict)
    parameters: dict[str, float] = field(default_factory=dict)
    system: str = ""
    data_code: int | None = None
    length_code: int | None = None
    cycle: int | None = None
    drilling: bool = False
    look_ahead: int = 0
    at_initial_level: bool | None = None
    length_of: int | None = None
    data: dict[str, float] = field(default_factory=dict)
    point_control: bool | None = None
    turns: bool = False
    ways: dict[str, bool] = field(default_factory=dict)
    turning: dict[str, str] = field(default_factory=dict)
    frame: str = ""
    call: DrillingCall | None = None
    unknown: str = ""
    notes: list[str] = field(default_factory=list)
    complaints: list[tuple[str, str]] = field(default_factory=list)

    @property
    def positions(self) -> bool:
        """Whether the block gives positions: axis words or an arc's centre or radius."""
        return bool(self.axes or self.centre or self.radius is not None)

    @property
    def in_machine_coordinates(self) -> bool:
        """Whether the block has G53."""
        return codes.MACHINE_COORDINATES in self.codes

    @property
    def uncertain_codes(self) -> str:
        """Codes of which it is not known whether they act before or after a motion, as `M70 M71`."""
        uncertain = [f"M{code}" for code in self.miscellaneous if code not in m_codes.OF_CERTAIN_TIMING]
        by_tool_word = self.changes_tool and m_codes.TOOL_CHANGE not in self.miscellaneous
        return " ".join([*uncertain, *([self.tool] if by_tool_word else [])])

    @property
    def changes_modes(self) -> bool:
        """Whether later blocks read differently after this one."""
        modes = (self.motion, self.plane, self.inch, self.absolute, self.data_code, self.length_code, self.cycle)
        shifts = self.codes & {codes.END_SHIFT, codes.SUSPEND_SHIFT, codes.RESTORE_SHIFT}
        ends = not m_codes.END.isdisjoint(self.miscellaneous)
        said = self.system or shifts or self.feed_mode or ends or self.at_initial_level is not None
        return self.cancel_cycle or bool(said or self.call) or any(mode is not None for mode in modes)

    def count_in_least_increments(self, inch: bool) -> None:
        """Take numbers without a decimal point as multiples of the least increment."""
        for letter in self.undotted:
            least = LEAST_DEG if letter in ROTARY else LEAST_INCH if inch else LEAST_MM
            for values in (self.axes, self.centre, self.data, self.parameters if letter == "Q" else {}):
                if letter in values:
                    values[letter] *= least
            if letter == "R" and self.radius is not None:
                self.radius *= least
            self.decimals[letter] = 4 if least == LEAST_INCH else 3

    def complain(self, problem: str, remedy: str = "") -> None:
        """Note what is wrong."""
        self.complaints.append((problem, remedy))


REPLACED = frozenset("XYZABCIJKR")  # letters of the words that are written anew


class BlockText(NamedTuple):
    """lead and tail stand before and after the axis words; split as in Move."""

    lead: str
    tail: str
    split: Split | None


def block_text(
    body: str,
    words: tuple[Word, ...],
    gap: str,
    motion_word: bool,
    as_line: bool,
    timed: bool = False,
    arc: str = "",
    turns: bool = False,
) -> BlockText:
    """Take the axis and arc words out of a block; gap separates words that are put in.

    motion_word: put a G1 or G0 before the axis words, since the block's own text has none and the motion in force
    differs; `as_line` says which, and turns G2 and G3 into G1. timed: F is the inverse of the block's time: when split,
    each piece has its own, and this one is left out. arc: the code of an arc that stays one. turns:
    whether P, the turns of an arc, is left out, because its pieces have one each.
    """
    lead: list[str] = []
    tail: list[str] = []
    kept_lead: list[str] = []
    kept_tail: list[str] = []
    last: list[str] = []
    place = 0
    out, kept = lead, kept_lead
    for word in words:
        between = body[place : word.start]
        place = word.end
        if word.letter in REPLACED or (turns and word.letter == "P"):
            if out is lead:
                out, kept = tail, kept_tail
                lead.append(between)
                kept_lead.append(between)
            else:
                out.append(between.rstrip(" \t"))
                kept.append(between.rstrip(" \t"))
            continue
        text = between + body[word.start : word.end]
        if as_line and not arc and word.letter == "G" and word.value in (2.0, 3.0):
            text = between + "G1"
        out.append(text)
        if due_at_end(word):
            last.append(text.strip())
        elif not (timed and word.letter == "F"):
            kept.append(text)
    out.append(body[place:])
    kept.append(body[place:])
    first = "".join(lead)
    if motion_word:
        insert = (arc or ("G1" if as_line else "G0")) + gap
        first = _joined(first, insert, gap)
        kept_lead = [_joined("".join(kept_lead), insert, gap)]
    at_end = gap + gap.join(last) if last else ""
    split = Split("".join(kept_lead), "".join(kept_tail), at_end) if last or timed else None
    return BlockText(first, "".join(tail), split)


def _joined(lead: str, insert: str, gap: str) -> str:
    return lead + (gap if lead.strip() and not lead.endswith((" ", "\t")) else "") + insert


def due_at_end(word: Word) -> bool:
    """Whether a word belongs to the end of the motion of its block."""
    return (word.letter == "M" and word.value in m_codes.AFTER) or (
        word.letter == "G" and round(word.value * 10) == EXACT_STOP
    )
