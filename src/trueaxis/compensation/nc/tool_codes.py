"""Tool changes and tool lengths of an NC program: T, M6, G43, G43.1 and G49.

SINUMERIK changes the tool at T where its machine data say so (MD22550), turrets do, and T is TOOL CALL in Heidenhain's
ISO programs. Where M6 changes the tool, T before it only selects one.
"""

from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.moves import Notes
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.nc.lexer import Meaning
from trueaxis.compensation.nc.state import NcState
from trueaxis.compensation.settings import Dialect, Settings
from trueaxis.compensation.tools import Tool, ToolTable

T_CHANGES = (
    "T alone may change the tool on this control, and so may have moved any axis: each gets words again only once the "
    "program has commanded it"
)
T_UNCERTAIN = "whether T changes the tool here is not certain, and so whose length counts"
TIP = "--tool-point is taken to hold after M6 too, whatever the tool"
M6_MOVES = "M6 may have moved any axis, so each gets words again only once the program has commanded it"
T_SELECTS = "T is taken to select a tool only: M6 changes it"
SELECTS_REMEDY = "or say --dialect fanuc or linuxcnc if M6 alone changes the tool"
SIEMENS_REMEDY = "M6 behind T, if M6 changes the tool (MD22550 = 1); a tool that T changes by itself is not followed"
_SELECTING = frozenset({"fanuc", "linuxcnc"})
_CALLING = "heidenhain"
TOOLS_REMEDY = "say --tools FILE (LinuxCNC's tool.tbl, or TOML with [tool.1] and its length)"
_LINUXCNC = "say --dialect linuxcnc if that is the control"
IN_SPINDLE = "no tool change before this G43: tool {} is taken to be in the spindle"
OLD_LENGTH = (
    "tool {} came with a tool change and no G43 since: the length of tool {} stays in force, as on LinuxCNC and Fanuc"
)
FIRST_EDGE = "no D after the tool change: D1 is taken to come into force by itself (MD20270 = 1, as delivered)"
NO_LENGTH = "G43 H0 is no length (Fanuc), or that of the tool in the spindle (LinuxCNC)"
OF_SPINDLE = "G43 without H, or with H0, takes the length of the tool in the spindle, which is not known here"
SPINDLE_REMEDY = "T and M6 before it, or --spindle-tool, which names the one in the spindle before the program"
BELOW_ZERO = (
    "a tool length below 0: the tip is taken to lie {:g} mm behind the point of --tool-point, as where lengths are "
    "differences from a master tool. A length that was touched off on the workpiece holds the work offset, too: give "
    "the tool's own length and the rest as the work offset, or the tool's point in --tools"
)
NO_SUCH_NAME = 'no tool in --tools has the name "{}"'
NAME_REMEDY = 'name = "{}" beside the length of the tool, in TOML'
UNMEASURED = (
    "tool {} is moved without its length ({:g} mm in --tools): {}, so positions count for the point of --tool-point, "
    "not for the tip"
)
NONE_SINCE = "no {} since the tool change"
ENDED = "{} has ended it"
UNKNOWN_TOOL = -1
INCREMENT = "an increment of Z beside a new tool length: whether it is added differs by control"
OF_ANOTHER = "the length of tool {} is put in force while tool {} is in the spindle"


class ToolChanges:
    """Follows the tool changes of a program, and notes what is taken for one.

    Where the control is not known, or is SINUMERIK, T counts as a change until the program changes a tool by M6.
    """

    def __init__(
        self, dialect: Dialect | None, notes: Notes, faults: FaultLog | None = None, kept: bool = False
    ) -> None:
        """faults: where tools count, so that it must be certain which is in the spindle. kept: whether M6 is known to
        move no axis.
        """
        self._dialect, self._notes, self._faults, self._kept = dialect, notes, faults, kept
        self._by_tool_word = dialect not in _SELECTING
        self._waiting: tuple[int, str] | None = None  # a note due unless M6 comes before the next motion
        self.remedy = ""  # what else would be right where the last change was one by T

    def may_change(self, number: int, meaning: Meaning) -> bool:
        """Take in a block; returns whether it may change the tool."""
        by_m6 = m_codes.TOOL_CHANGE in meaning.miscellaneous
        by_tool_word = self._by_tool_word and bool(meaning.tool) and not by_m6
        if by_m6:
            if self._faults is None:
                self._notes.add(number, TIP if self._kept else f"{TIP}; {M6_MOVES}")
            elif not self._kept:
                self._notes.add(number, M6_MOVES)
            self._by_tool_word = self._dialect == _CALLING
            self._waiting = None
        elif meaning.tool:
            self._waiting = (number, T_CHANGES if by_tool_word else T_SELECTS)
        if meaning.positions and self._waiting is not None:
            line, text = self._waiting
            self._notes.add(line, text)
            if self._faults is not None and text == T_CHANGES and self._dialect != _CALLING:
                remedy = SIEMENS_REMEDY if self._dialect == "siemens" else SELECTS_REMEDY.removeprefix("or ")
                self._faults.add(line, T_UNCERTAIN, remedy)
            self._waiting = None
        if by_m6 or by_tool_word:
            by_word = "or M6 behind T, if M6 changes the tool" if self._dialect == "siemens" else SELECTS_REMEDY
            self.remedy = by_word if by_tool_word else ""
        return by_m6 or by_tool_word

    @property
    def waiting(self) -> bool:
        """Whether a note is due unless M6 comes before the next motion."""
        return self._waiting is not None


class ToolReader:
    """Follows the tool of one program and its length in its state; remedy: as of ToolChanges."""

    def __init__(self, state: NcState, settings: Settings, faults: FaultLog, notes: Notes) -> None:
        self._state, self._faults, self._notes = state, faults, notes
        state.tool = settings.spindle_tool
        self._table: ToolTable | None = settings.tools
        self._dialect = settings.dialect
        self._on_linuxcnc = settings.dialect == "linuxcnc"
        self._on_siemens = settings.dialect == "siemens"
        self._length_word = {"siemens": "D1", "heidenhain": "TOOL CALL"}.get(settings.dialect or "", "G43")
        self._in_words = settings.judged  # lengths are part of the words that an interpreter has made
        self._why_none = ""  # why no length is in force, where that is to be noted at the next motion
        self._not_yet_gone = False  # Z goes by a new length only with its next word (SINUMERIK)
        self._kept = m_codes.TOOL_CHANGE in settings.pass_m
        self._changes = ToolChanges(settings.dialect, notes, None if settings.tools is None else faults, self._kept)
        self._selected: int | None = None
        self._told = set[int | str]()  # tools that are not in the table
        self._changed = False  # a tool has come since the last length was put in force
        self._taken = False  # the tool in the spindle is that of the first G43 H: good enough for the tip, not for H0

    @property
    def remedy(self) -> str:
        """What else would be right where the last change was one by T."""
        return self._changes.remedy

    @property
    def due(self) -> bool:
        """Whether something may be to be noted at the next motion."""
        return self._changed or bool(self._why_none) or self._not_yet_gone or self._changes.waiting

    def moves(self, meaning: Meaning) -> bool:
        """Whether the tool change of a block may move axes."""
        return not self._kept or m_codes.TOOL_CHANGE not in meaning.miscellaneous

    def change(self, number: int, meaning: Meaning) -> None:
        """Take in what a block does to the tool."""
        state = self._state
        if meaning.tool_name:
            meaning.tool = f"T{self.number_of(number, meaning.tool_name)}"
        meaning.changes_tool = self._changes.may_change(number, meaning)
        if meaning.tool:
            self._selected = int(float(meaning.tool[1:]))
        if meaning.in_spindle is not None and self._table is not None:
            self._tool(number, meaning.in_spindle)
            state.tool, self._changed, self._taken = meaning.in_spindle, True, False
        if not meaning.changes_tool:
            return
        if self.moves(meaning):
            state.commanded.displace()
        if self._table is None:
            return
        if meaning.positions:
            self._faults.add(
                number, "a tool change and a motion in one block: with which tool it is made differs by control",
                "give the tool change a block of its own",
            )  # fmt: skip
        if self._selected is None:
            self._faults.add(number, "M6 without a T before it: which tool comes is not known", "T in the program")
        else:
            self._tool(number, self._selected)
            state.tool, self._changed, self._taken = self._selected, True, False
            if self._on_siemens and meaning.length_code is None:
                lengths = self._lengths(number, self._tool(number, self._selected))
                self._set(number, meaning, lengths, self._selected)

    def call(self, number: int, tool: int) -> None:
        """TOOL CALL of Klartext: the tool comes with its length. A call of the one in the spindle changes its speed or
        feed alone.
        """
        if tool != self._state.tool:
            self.change(number, Meaning(tool=f"T{tool}"))
        code = codes.TAKE_LENGTH if tool else codes.END_LENGTH
        self.length(number, Meaning(length_code=code, length_of=tool))

    def length(self, number: int, meaning: Meaning) -> None:
        """Take in G43 and G49; note a motion with the length of the tool before the one in the spindle.

        A rapid beside Z is none: programs go there first, and then to Z with the new length.
        """
        frames = self._state.frames
        if meaning.length_code is None:
            rapid = meaning.motion == 0 or (meaning.motion is None and self._state.motion == 0)
            if meaning.drilling or (meaning.positions and ("Z" in meaning.axes or not rapid)):
                self._note_length(number, meaning)
            return
        self._changed, self._why_none = False, ""
        if meaning.length_code == codes.END_LENGTH:
            self._why_none = ENDED.format("D0" if self._on_siemens else "G49")
            self._set(number, meaning, [0.0] * len(frames.axes), 0)
            return
        of_tool = self._whose_length(number, meaning)
        if of_tool is None:
            return
        if self._state.tool and of_tool and of_tool != self._state.tool:
            self._notes.warn(number, OF_ANOTHER.format(of_tool, self._state.tool))
        if self._state.tool is None and of_tool:
            self._notes.add(number, IN_SPINDLE.format(of_tool))
            self._state.tool, self._taken = of_tool, True
        self._set(number, meaning, self._lengths(number, self._tool(number, of_tool)), of_tool)

    def _note_length(self, number: int, meaning: Meaning) -> None:
        """Note, at a motion, what is to be said of the length in force."""
        if self._not_yet_gone and "Z" in meaning.axes:
            self._not_yet_gone = False
            if not meaning.ways.get("Z", self._state.absolute):
                self._faults.add(number, INCREMENT, "G90 in the block")
        if meaning.in_machine_coordinates and not self._on_siemens:
            return
        if self._changed and self._on_siemens:
            self._notes.add(number, FIRST_EDGE)
        if meaning.in_machine_coordinates and not self._changed:
            return
        tool, old = self._state.tool, self._state.frames.tool_of_length
        if self._changed and old and old != tool:
            self._notes.warn(number, OLD_LENGTH.format(tool, old))
        known = self._table.tools.get(tool) if self._table is not None and tool else None
        bare = not old and not self._in_words and (self._changed or bool(self._why_none))
        if bare and known is not None and known.shift[2]:
            why = self._why_none or NONE_SINCE.format(self._length_word)
            self._notes.warn(number, UNMEASURED.format(tool, known.shift[2], why))
        self._changed, self._why_none = False, ""

    def _whose_length(self, number: int, meaning: Meaning) -> int | None:
        """The tool whose length is put in force, 0: none; None: a fault, which is added."""
        of_tool = meaning.length_of
        if of_tool == 0 and self._dialect is None:
            self._faults.add(number, NO_LENGTH, "say --dialect")
        elif self._on_linuxcnc and not of_tool:  # H0 is the tool in the spindle, too
            of_tool = None if self._taken else self._state.tool
        elif of_tool is None and self._on_siemens:
            of_tool = self._state.tool or None
        if self._table is None and (of_tool is not None or self._on_siemens or self._on_linuxcnc):
            problem = f"{self._length_word} shifts positions by a tool value that is not in the program"
            self._faults.add(number, problem, TOOLS_REMEDY)
            return None
        if of_tool is None and self._on_siemens:
            self._faults.add(number, "D1 before a tool change: whose length it is is not known", "T1 M6 before it")
        elif of_tool is None and self._on_linuxcnc:
            self._faults.add(number, OF_SPINDLE, SPINDLE_REMEDY)
        elif of_tool is None:
            self._faults.add(number, "G43 without H: whose length it is is not known", "G43 H1")
        return of_tool

    def data(self, number: int, meaning: Meaning) -> None:
        """G43.1: lengths in the program."""
        state = self._state
        if not self._on_linuxcnc:
            self._faults.add(number, "G43.1 gives tool lengths (LinuxCNC) or follows the tool axis (Fanuc)", _LINUXCNC)
            return
        lengths = state.frames.length.copy()
        for axis, value in meaning.data.items():
            if axis in state.row:
                lengths[state.row[axis]] = value * state.scale(axis)
        state.frames.take_length(lengths, -number)

    def number_of(self, number: int, name: str) -> int:
        """Of a tool that is called by its name; UNKNOWN_TOOL after a fault, and where tools do not count."""
        found = None if self._table is None else self._table.number_of(name)
        if found is None and self._table is not None and name.upper() not in self._told:
            self._told.add(name.upper())
            self._faults.add(number, NO_SUCH_NAME.format(name), NAME_REMEDY.format(name))
        return UNKNOWN_TOOL if found is None else found

    def _tool(self, number: int, tool: int) -> Tool:
        if tool in (0, UNKNOWN_TOOL):
            return Tool()
        if self._table is not None and tool not in self._table.tools and tool not in self._told:
            self._told.add(tool)
            self._faults.add(number, f"tool {tool} is not in --tools", f"add tool {tool} with its length")
        return Tool() if self._table is None else self._table.tools.get(tool, Tool())

    def _lengths(self, number: int, tool: Tool) -> list[float]:
        """What G43 adds to each axis, mm: Z everywhere, X and Y on LinuxCNC."""
        if any(tool.shift[:2]) and not self._on_linuxcnc:
            self._faults.add(number, "G43 of a tool with X or Y: LinuxCNC adds them, others do not", _LINUXCNC)
        if tool.shift[2] < 0.0 and tool.point is None:
            self._notes.add(number, BELOW_ZERO.format(-tool.shift[2]))
        given = dict(zip(LINEAR, tool.shift, strict=True))
        return [given.get(axis, 0.0) for axis in self._state.axes]

    def _set(self, number: int, meaning: Meaning, lengths: list[float], tool: int) -> None:
        state = self._state
        if not state.frames.has_length_of(tool) and not self._on_linuxcnc:
            if "Z" in meaning.axes:
                if not meaning.ways.get("Z", state.absolute) and not meaning.in_machine_coordinates:
                    self._faults.add(number, INCREMENT, "G90 in the block")
            elif self._on_siemens:
                self._not_yet_gone = True
            else:  # some controls move by the difference at once, others with the next word
                state.commanded.displace([state.row["Z"]] if "Z" in state.row else [])
        state.frames.take_length(lengths, tool)
