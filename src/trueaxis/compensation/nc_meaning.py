"""What one NC block asks for."""

from dataclasses import dataclass, field
from typing import Literal

from trueaxis.compensation import m_codes
from trueaxis.compensation import nc_codes as codes
from trueaxis.compensation.machine import ROTARY
from trueaxis.compensation.settings import LEAST_DEG, LEAST_INCH, LEAST_MM

FeedMode = Literal[
    "minute", "turn", "time"
]  # F counts mm/min (deg/min), by turns of the spindle, or 1/min of the block


@dataclass(slots=True, kw_only=True)
class Meaning:
    """A block taken apart; complaints are (problem, remedy) and none may be passed over.

    motion, plane, inch, absolute, feed (as written): None where the block says nothing of it. feed_mode: how F counts,
    empty: not said. axes: words that are positions. decimals: digits written after the decimal point of axis and arc
    words. undotted: letters of axis and arc words other than 0 without a decimal point. parameters: values of P Q L E.
    system: the work offset that it selects; data_code: a code (times ten) whose axis words are data: `data`, by letter,
    R too. length_code: G43 or G49 (times ten); length_of: the H word of G43. cycle: a canned cycle that it begins (code
    times ten); drilling: whether its axis words are those of a cycle, with R in `data`; at_initial_level: G98, or G99.
    turns: whether P counts turns of an arc (LinuxCNC).
    point_control: whether it switches tool centre point control on or off.
    ways: for letters with `AC` or `IC` (SINUMERIK) whether they are absolute. frame: why axis words beside a data_code
    would be no shift; notes: remarks on the block.
    tool: the T word, as `T2`. changes_tool: whether the block may change the tool, see tool_changes.
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
    changes_tool: bool = False
    undotted: set[str] = field(default_factory=set)
    decimals: dict[str, int] = field(default_factory=dict)
    parameters: dict[str, float] = field(default_factory=dict)
    system: str = ""
    data_code: int | None = None
    length_code: int | None = None
    cycle: int | None = None
    drilling: bool = False
    at_initial_level: bool | None = None
    length_of: int | None = None
    data: dict[str, float] = field(default_factory=dict)
    point_control: bool | None = None
    turns: bool = False
    ways: dict[str, bool] = field(default_factory=dict)
    frame: str = ""
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
        return self.cancel_cycle or bool(said) or any(mode is not None for mode in modes)

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
