"""Reads Heidenhain Klartext programs block by block; what is written is Klartext again, arcs as lines L.

What is not followed is a fault of its line. Frames, tools and where axes stand are as in NcReader.
"""

import math
from collections.abc import Iterable, Iterator

from trueaxis.compensation.arcs import Arc, ArcError
from trueaxis.compensation.dialects import BYTE_ORDER_MARK, COMPENSATED_ALREADY, is_marked
from trueaxis.compensation.klartext.arcs import arc_of, as_arc, pole_of
from trueaxis.compensation.klartext.blocks import (
    MACHINE_COORDINATES,
    PRESET,
    KlartextBlock,
    Other,
    codes_alone,
    head_of,
    lex_klartext,
    other_block,
    too_long,
)
from trueaxis.compensation.klartext.codes import known_codes
from trueaxis.compensation.klartext.cycles import Drilling, NotFollowed, call_of, defined
from trueaxis.compensation.klartext.drilling import HoleWriter, ModalFeed, problem_of
from trueaxis.compensation.klartext.ends import POLAR, ends_of
from trueaxis.compensation.klartext.tools import NO_DEFINITION, ToolCall, definition_differs, tool_call
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import LINEAR, ROTARY
from trueaxis.compensation.move_notes import SWITCH
from trueaxis.compensation.moves import AFTER_END, STOP, Item, Kind, Move, Notes, Split, Start
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.nc.frame_codes import FrameReader
from trueaxis.compensation.nc.mistyped import read_mended
from trueaxis.compensation.nc.modes import note_unfed, switch
from trueaxis.compensation.nc.motion import in_its_frame
from trueaxis.compensation.nc.rotary_ways import take_codes, turned_round
from trueaxis.compensation.nc.state import NcState, missing_axes, starts_elsewhere, unknown_position
from trueaxis.compensation.nc.tool_codes import ToolReader
from trueaxis.compensation.offsets import NOT_KNOWN
from trueaxis.compensation.settings import Settings

_POINT_CONTROL = m_codes.POINT_CONTROL["heidenhain"]
_ARCS = frozenset({"C", "CR", "CP"})


class KlartextReader:
    """Turns the lines of one program into items; faults and notes are gathered in the logs given."""

    def __init__(self, axes: tuple[str, ...], settings: Settings, faults: FaultLog, notes: Notes) -> None:
        self._axes, self._settings, self._faults, self._notes = axes, settings, faults, notes
        self._state = NcState(axes=axes, position=[settings.start.get(axis) for axis in axes], offsets=settings.offsets)
        self._tools = ToolReader(self._state, settings, faults, notes)
        self._frames = FrameReader(self._state, settings, faults, notes)
        self._assumed = [settings.assumed.get(axis, 0.0) for axis in axes]
        self._pole: dict[str, float] = {}  # of X and Y, in the frame in force, mm
        self._cycle: Drilling | NotFollowed | None = None  # that is called
        self._preset, self._feed = "", ModalFeed()

    def items(self, lines: Iterable[str]) -> Iterator[Item]:
        """Items of a program, in order; lines carry their ends, bytes as latin-1 characters."""
        if self._settings.start:
            yield Start(tuple(math.nan if value is None else value for value in self._state.position))
        yield from self._frames.changed()
        first, held = 0, ""
        for number, line in enumerate(lines, 1):
            first, held = first or number, held + line
            if line.rstrip().endswith("~"):
                continue  # the block goes on in the next line
            yield from self._block(first, held)
            first, held = 0, ""
        self._frames.note_end("END PGM, M2 or M30")
        if held:
            self._faults.add(first, "the block goes on after ~, and the program ends")

    def _block(self, number: int, text: str) -> list[Item]:
        """A block, and the hole where it calls the cycle that is defined before."""
        cycle, call = None if self._state.ended else self._cycle, call_of(text)
        if cycle is None or call is None:
            return self._read(number, text)
        head, optional, _ = head_of(text)
        due = bool(optional) or not m_codes.AFTER.isdisjoint(lex_klartext(call.rest).codes)
        if problem := problem_of(call, cycle, due, self._state):
            self._faults.add(number, *problem)
        items = self._read(number, call.rest) if call.rest else []
        if isinstance(cycle, NotFollowed):
            return items
        self._feed.changed = True
        writer = HoleWriter(number, head, text, self._state, self._settings, (self._faults, self._notes))
        return [*items, *writer.hole(cycle.raised(call.shift))]

    def _read(self, number: int, text: str) -> list[Item]:
        state = self._state
        if is_marked(text):
            self._faults.add(number, *COMPENSATED_ALREADY)
        text = text.removeprefix(BYTE_ORDER_MARK) if number == 1 else text
        body = text.rstrip("\r\n")
        if problem := too_long(body):
            self._faults.add(number, problem)
        if state.ended or problem:
            if not problem and lex_klartext(body).coordinates:
                self._notes.warn(number, AFTER_END)
            return [text]
        _, optional, rest = head_of(body)
        block, wrong = read_mended(body, lex_klartext)
        self._faults.add_mistyped(number, wrong)
        if optional and (delete := self._settings.block_delete) == "fault":
            problem = "whether this block with / is run depends on a switch"
            self._faults.add(number, problem, "say --block-delete run or --block-delete skip")
        elif optional:
            self._notes.add(number, SWITCH[delete])
            if delete == "skip":
                return [text]
        content = rest.partition(";")[0].replace("~", " ")
        self._cycle = defined(text, self._cycle)
        if block.verb and block.verb not in ("CT", "CTP", "LN", "LT"):
            return self._path(number, text, block)
        if call := tool_call(content):
            return self._tool(number, text, call)
        if only_codes := codes_alone(content):
            return self._path(number, text, only_codes)
        return self._other(number, text, content)

    def _other(self, number: int, text: str, content: str) -> list[Item]:
        state, frames = self._state, self._state.frames
        if content.strip().upper().startswith("BEGIN PGM"):
            state.inch = content.upper().split()[-1] == "INCH"
        differs = definition_differs(content, self._settings.tools, state.inch)
        found = other_block(content) if differs is NO_DEFINITION else Other(problem=differs[0], remedy=differs[1])
        if found.problem:
            self._faults.add(number, found.problem, found.remedy)
        if found.preset:
            self._take_preset(number, found.preset)
        if found.reset:
            frames.shift_program({}, adding=False)
        rows = {}
        for axis, value in found.shift.items():
            if axis not in state.row:
                self._faults.add(number, f"{axis}: this machine has no axis {axis}")
                continue
            row = state.row[axis]
            rows[row] = value * state.scale(axis) + (frames.local[row] if axis in found.added else 0.0)
        if rows:
            frames.shift_locally(rows, shared=False)
        if found.note:
            self._notes.add(number, found.note)
        if found.stops:
            self._stop(number)
        if found.ends:
            state.ended = number
        changed = self._switch(number, found.point_control)
        if rows or found.reset or found.preset:
            self._pole = {}
        return [text, *changed]

    def _take_preset(self, number: int, preset: str) -> None:
        if self._preset and preset != self._preset:
            self._faults.add_unplaced(
                number, f"preset {preset} after preset {self._preset}: {NOT_KNOWN}",
                "a program for each preset",
            )  # fmt: skip
        self._preset = preset
        if self._state.frames.system:
            self._notes.add(number, PRESET)

    def _switch(self, number: int, control: bool | None) -> list[Item]:
        if lost := switch(number, control, self._state, self._settings, self._faults, self._notes):
            self._pole = {}
        return [*lost, *self._frames.changed()]

    def _stop(self, number: int) -> None:
        self._state.commanded.stop()
        self._notes.add(number, STOP)

    def _tool(self, number: int, text: str, call: ToolCall) -> list[Item]:
        for problem, remedy in call.problems:
            self._faults.add(number, problem, remedy)
        tool = self._tools.number_of(number, call.name) if call.name else call.tool
        if tool is not None:
            self._tools.call(number, tool)
        return [text, *self._frames.changed()]

    def _path(self, number: int, text: str, block: KlartextBlock) -> list[Item]:
        """A path function, or M codes alone."""
        if block.problem:
            self._faults.add(number, block.problem, "the number itself in place of it")
        if block.side in ("RL", "RR"):
            self._faults.add(
                number, f"{block.side} compensates the cutter's radius", "have the path of its centre written"
            )
        known_codes(number, block, self._settings, self._faults, self._notes)
        state = self._state
        block, text = self._feed.restored(block, text)
        item: Item = text
        before = state.position
        take_codes(number, block.codes, bool(block.coordinates), state, self._faults)
        control = next((_POINT_CONTROL[code] for code in block.codes if code in _POINT_CONTROL), None)
        items = self._switch(number, control)
        if block.feed is not None:
            state.feed = block.feed * (2.54 if state.inch else 1.0)
        state.fed = state.fed or block.feeds
        if not block.problem and block.verb == "CC":
            try:
                self._pole = pole_of(block, state)
            except ArcError as problem:
                self._faults.add(number, str(problem))
        elif not block.problem and block.verb:
            item = self._moved(number, text, block) or text
        if isinstance(item, Move):
            items += turned_round(number, before, state, {}, self._faults)
        items += self._framed(item, text)
        if block.retracts:
            moved = LINEAR if set(ROTARY) & state.row.keys() else ("Z",)
            items.append(state.lose([row for axis, row in state.row.items() if axis in moved]))
        if any(m_codes.may_move(code, self._settings.pass_m) for code in block.codes):
            self._stop(number)
        if m_codes.END.intersection(block.codes):
            state.ended = number
        return items

    def _framed(self, item: Item, text: str) -> list[Item]:
        if not isinstance(item, Move):
            return [item]
        if item.in_machine and self._settings.keep_g53 and not item.source:
            self._faults.add(item.line, "increments under M91 with --keep-g53", "the position itself")
        return in_its_frame(item, text, self._settings, self._frames, self._notes)

    def _moved(self, number: int, text: str, block: KlartextBlock) -> Move | None:
        if not block.coordinates and block.verb not in _ARCS:
            return None
        machine = MACHINE_COORDINATES in block.codes
        if machine and self._state.point_control:
            self._faults.add(number, "machine coordinates under tool centre point control", "end it before")
        state = self._state
        if machine:
            state.enter_frame(machine=True)
        try:
            return self._move(number, text, block, machine)
        except ArcError as problem:
            self._faults.add(number, str(problem))
            return None
        finally:
            if machine:
                state.enter_frame()

    def _move(self, number: int, text: str, block: KlartextBlock, machine: bool) -> Move | None:
        state = self._state
        circular = block.verb in _ARCS
        start = state.position
        end, named = ends_of(number, block, self._pole, state, self._faults)
        if circular:
            named |= {"X", "Y"}
        motion = 0 if block.rapid and not circular else 1
        state.motion = 2 if circular else motion
        if missing := missing_axes(state, start, end, named):
            self._faults.add(number, *unknown_position(state, missing))
            state.position = [0.0 if value is None else value for value in end]
            return None
        if not machine:
            self._frames.note_first(number)
        if motion:
            note_unfed(number, state, self._notes)
        commands = tuple(axis in named for axis in self._axes)
        elsewhere = starts_elsewhere(number, state, commands, "", self._faults)
        known_end = tuple(self._assumed[row] if value is None else value for row, value in enumerate(end))
        arc: Arc | None = None
        if circular:
            known_start = tuple(self._assumed[row] if value is None else value for row, value in enumerate(start))
            arc = arc_of(block, self._pole, state, known_start, known_end)
        state.position, state.moved = end, True
        for axis in named & set(block.coordinates):
            state.numbers[state.row[axis]] = f"0.{'0' * block.coordinates[axis].decimals}"
        whole = "M91" if machine else ""
        straight = block.verb == "L" and not any(word.incremental for word in block.coordinates.values())
        return self._written(number, text, block, known_end, commands, motion, arc, elsewhere, whole, straight)

    def _written(
        self, number: int, text: str, block: KlartextBlock, end: tuple[float, ...], commands: tuple[bool, ...],
        motion: int, arc: Arc | None, elsewhere: bool, whole: str, straight: bool,
    ) -> Move:  # fmt: skip
        state = self._state
        written = tuple(axis in block.coordinates or (block.verb in POLAR and axis in "XY") for axis in self._axes)
        eol = text[len(text.rstrip("\r\n")) :]
        again = f"{block.head}{block.optional}"
        lead = f"{again}L "
        codes_of = {word: int(word[1:]) for word in block.others if word[0] in "Mm" and word[1:].strip().isdigit()}
        last = [word for word in block.others if codes_of.get(word) in m_codes.AFTER]
        tail = "".join(f" {word}" for word in block.others)
        kept = "".join(f" {word}" for word in block.others if word not in last)
        comment = f" {block.comment}" if block.comment else ""
        split = Split(lead, kept, "".join(f" {word}" for word in last) + comment)
        rounded = None if arc is None or self._settings.arcs != "keep" else as_arc(block)
        return Move(
            number, Kind.ARC if arc else Kind(motion), end, written, True, state.inch, lead, tail + comment, " ", eol,
            text if straight else "", again if rounded else lead, split, arc, m_codes.AFTER.isdisjoint(block.codes),
            state.feed, state.commanded.command(commands, True), state.commanded.elsewhere, state.commanded.unnamed,
            state.shift, elsewhere, whole, 0.0, rounded, bool(whole),
        )  # fmt: skip
