"""Notes on moves whose words are not what one might expect."""

from collections.abc import Iterator

import numpy as np

from trueaxis.compensation.machine import FloatArray, linear_rows, rotary_rows
from trueaxis.compensation.moves import Kind, Notes
from trueaxis.compensation.nc.canned_cycle import Cycle, whole_peck_in_mm
from trueaxis.compensation.path import Held, MoveTable, alike
from trueaxis.compensation.settings import Settings

HELD = (
    "gets no word here, and its error is left: the program has not commanded it to a position in this frame "
    "since its start, or since the last tool change or stop"
)
_SWITCH = "a block with / is taken to be {}: what follows is right only with the switch of the control so"
SWITCH = {"run": _SWITCH.format("run"), "skip": _SWITCH.format("skipped")}  # by what --block-delete says
TURNS_ALONE = (
    "a feed block of rotary axes alone gets words of linear axes too: some controls then read its F as a feed in mm/min"
)
WRITTEN_OUT = "a canned cycle is written out as G0 and G1"
DEEP_WRITTEN_OUT = (
    "CYCLE83 is written out in the pecks of the cycle as delivered; chips are broken by 1 mm (_VRT), and pecks begin "
    "0.6 mm above the last depth, 1/50 of depths above 30 mm (_DIS1), where the call does not say otherwise"
)
KEPT = "{} stays a cycle, with corrected X, Y, Z and R: how Z goes and the spindle turns in the hole is for the control"
STORED = "K0 or L0: the words of the cycle are stored, and nothing is drilled"
ONE_PECK = "Q is no less than the way from R to Z: each hole is drilled in one peck"
WHOLE_PECK = (
    "Q without a decimal point is read as mm, as --integers says: some controls count it in steps of 0.001 mm all the "
    "same"
)
PECKS = "pecks go back by {:g} mm; on LinuxCNC it is 0.254 mm, elsewhere a parameter, which --peck-return takes"

OF_PECKS = frozenset({ONE_PECK, WHOLE_PECK})  # a drill may break

UNKNOWN_START = "a feed motion from an unknown position: only its end is compensated"


def note_moves(moves: MoveTable, start: FloatArray, held: Held, axes: tuple[str, ...], notes: Notes) -> None:
    """Note what the moves of a batch are to be known for; start: (n_axes,), before them; held: as in `note_held`."""
    if np.isnan(start).any() and moves.motion[0] != Kind.RAPID:
        notes.add(int(moves.lines[0]), UNKNOWN_START)
    note_turns(moves, start, axes, notes)
    note_held(moves, held, axes, notes)


def note_held(moves: MoveTable, held: Held, axes: tuple[str, ...], notes: Notes) -> None:
    """Note axes that get no word; held: (n_axes, n_moves)."""
    for some in alike(held):
        names = " ".join(axis for axis, stays in zip(axes, held[:, some[0]], strict=True) if stays)
        notes.add(int(moves.lines[some[0]]), f"{names} {HELD}", some.size)


def note_turns(moves: MoveTable, start: FloatArray, axes: tuple[str, ...], notes: Notes) -> None:
    """Note feed blocks whose F may be read differently once they have words of linear axes."""
    linear, rotary = list(linear_rows(axes)), list(rotary_rows(axes))
    if not rotary:
        return
    ends = moves.ends
    way = np.abs(np.diff(np.concatenate([start[:, None], ends], axis=1), axis=1))
    alone = (way[linear] == 0.0).all(axis=0) & (way[rotary] > 0.0).any(axis=0)
    for line in moves.lines[alone & (moves.motion == Kind.LINE)].tolist():
        notes.warn(line, TURNS_ALONE)


def notes_of_cycle(cycle: Cycle, settings: Settings) -> Iterator[str]:
    """What is to be said of a cycle that is written out."""
    yield WRITTEN_OUT
    if cycle.pecks:
        yield PECKS.format(settings.peck_return)
        if cycle.in_one_peck:
            yield ONE_PECK
        if whole_peck_in_mm(cycle, settings):
            yield WHOLE_PECK
