"""The text of a moving block without its axis words."""

from typing import NamedTuple

from trueaxis.compensation import m_codes
from trueaxis.compensation.moves import Split
from trueaxis.compensation.nc_codes import EXACT_STOP
from trueaxis.compensation.nc_lexer import Word

_REPLACED = frozenset("XYZABCIJKR")


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
        if word.letter in _REPLACED or (turns and word.letter == "P"):
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
