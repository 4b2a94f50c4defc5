"""Which blocks may change the tool: those with M6, and on some controls those with T alone.

SINUMERIK changes at T where its machine data say so (MD22550), turrets do, and T is TOOL CALL in Heidenhain's ISO
programs. Where M6 changes the tool, T before it only selects one.
"""

from trueaxis.compensation.fault_log import FaultLog
from trueaxis.compensation.m_codes import TOOL_CHANGE
from trueaxis.compensation.moves import Notes
from trueaxis.compensation.nc_meaning import Meaning
from trueaxis.compensation.settings import Dialect

T_CHANGES = (
    "T alone may change the tool on this control, and so may have moved any axis: each gets words again only once the "
    "program has commanded it"
)
T_UNCERTAIN = "whether T changes the tool here is not certain, and so whose length counts"
TIP = "--tool-point is taken to hold after M6 too, whatever the tool"
M6_MOVES = "M6 may have moved any axis, so each gets words again only once the program has commanded it"
T_SELECTS = "T is taken to select a tool only: M6 changes it"
SELECTS_REMEDY = "or say --dialect fanuc or linuxcnc if M6 alone changes the tool"
_SELECTING = frozenset({"fanuc", "linuxcnc"})
_CALLING = "heidenhain"


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
        by_m6 = TOOL_CHANGE in meaning.miscellaneous
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
                self._faults.add(line, T_UNCERTAIN, SELECTS_REMEDY.removeprefix("or "))
            self._waiting = None
        if by_m6 or by_tool_word:
            self.remedy = SELECTS_REMEDY if by_tool_word else ""
        return by_m6 or by_tool_word
