"""What the words of one NC block ask for."""

from dataclasses import dataclass, field

from trueaxis.compensate import m_codes
from trueaxis.compensate import nc_codes as codes
from trueaxis.compensate.machine import LINEAR, ROTARY
from trueaxis.compensate.nc_lexer import Block, Word
from trueaxis.compensate.offsets import system_name
from trueaxis.compensate.settings import LEAST_DEG, LEAST_INCH, LEAST_MM, Settings

_AXES = frozenset(LINEAR + ROTARY)
_CENTRE = frozenset("IJK")
_ONCE = frozenset("XYZABCIJKRFSTN")
_PARAMETERS = frozenset("PQLE")
_OFFSETS = frozenset("DH")
_HARMLESS = frozenset("FSNT") | _PARAMETERS | _OFFSETS
_DWELL = frozenset("XUPFS")  # words of a G4 block, of which X and U are a time
# what a code sets of a Meaning, and to what
_SETTING: dict[int, tuple[str, int | bool | str]] = {
    **{code: ("motion", code // 10) for code in codes.MOTION},
    **{code: ("plane", code) for code in codes.PLANES},
    **{code: ("system", name) for code, name in codes.SYSTEMS.items()},
    **{code: ("data_code", code) for code in codes.WITH_DATA},
    200: ("inch", True), 210: ("inch", False), 900: ("absolute", True), 910: ("absolute", False),
    codes.TAKE_LENGTH: ("length_code", codes.TAKE_LENGTH), codes.END_LENGTH: ("length_code", codes.END_LENGTH),
    940: ("per_turn", False), 950: ("per_turn", True),
}  # fmt: skip


@dataclass(slots=True)
class Meaning:
    """A block taken apart; complaints are (problem, remedy) and none may be passed over.

    motion, plane, inch, absolute, per_turn (F counts by turns), feed (as written): None where the block says nothing
    of it. axes: words that are positions. decimals: digits written after the decimal point of axis and arc words.
    undotted: letters of axis and arc words other than 0 without a decimal point. parameters: values of P Q L E. system:
    the work offset that it selects; data_code: a code (times ten) whose axis words are data: `data`, by letter, R too. length_code: G43 or G49 (times ten); length_of: the H word of G43.
    tool: the T word, as `T2`.
    changes_tool: whether the block may change the tool, see tool_changes.
    """

    motion: int | None = None
    plane: int | None = None
    inch: bool | None = None
    absolute: bool | None = None
    per_turn: bool | None = None
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
    length_of: int | None = None
    data: dict[str, float] = field(default_factory=dict)
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
        modes = (self.motion, self.plane, self.inch, self.absolute, self.data_code, self.length_code)
        shifts = self.codes & {codes.END_SHIFT, codes.SUSPEND_SHIFT, codes.RESTORE_SHIFT}
        return self.cancel_cycle or bool(self.system or shifts) or any(mode is not None for mode in modes)

    def count_in_least_increments(self, inch: bool) -> None:
        """Take numbers without a decimal point as multiples of the least increment."""
        for letter in self.undotted:
            least = LEAST_DEG if letter in ROTARY else LEAST_INCH if inch else LEAST_MM
            for values in (self.axes, self.centre, self.data):
                if letter in values:
                    values[letter] *= least
            if letter == "R" and self.radius is not None:
                self.radius *= least
            self.decimals[letter] = 4 if least == LEAST_INCH else 3

    def complain(self, problem: str, remedy: str = "") -> None:
        """Note what is wrong."""
        self.complaints.append((problem, remedy))


def interpret(block: Block, machine_axes: tuple[str, ...], settings: Settings) -> Meaning:
    """Sort the words of a block by what they do."""
    meaning = Meaning()
    if block.problem:
        meaning.complain(block.problem)
    seen: set[str] = set()
    others: list[Word] = []
    for word in block.words:
        if word.letter in _ONCE:
            if word.letter in seen:
                meaning.complain(f"{word.letter} occurs twice in the block")
            seen.add(word.letter)
        if word.letter == "G":
            _preparatory(word.value, meaning, settings)
        elif word.letter == "M":
            _miscellaneous(word.value, meaning, settings)
        else:
            others.append(word)
    for word in others:
        _other(word, meaning, machine_axes)
    if meaning.system == "G54.1":
        meaning.system = system_name(f"G54.1P{meaning.parameters.get('P', 0):g}") or ""
        if not meaning.system:
            meaning.complain("G54.1 without the number of a work offset", "G54.1 P1 to P300")
    if (
        meaning.dwell
        and any(word.letter == "X" for word in others)
        and (meaning.parameters or meaning.motion is not None)
    ):
        meaning.complain("X in a block of G4 (dwell): a time, or where to go", "give the motion a block of its own")
    _cancels(meaning)
    return meaning


def _cancels(meaning: Meaning) -> None:
    """Axis words beside a cancelling code: whether they are positions differs by code and control."""
    with_axes, alone = meaning.codes & codes.CANCELS_WITH_AXES, meaning.codes & codes.CANCELS_ALONE
    if not (with_axes or alone) or not meaning.positions:
        return
    name = f"G{min(with_axes | alone) / 10:g}"
    if alone or meaning.motion is not None:
        meaning.complain(f"{name} and axis words in one block: whose they are is not determined", "make it two blocks")
    elif 921 in with_axes and any((*meaning.axes.values(), *meaning.centre.values(), meaning.radius)):
        meaning.complain(f"{name} with words other than 0 may shift the frame of the positions", codes.MACHINE_REMEDY)
    meaning.axes, meaning.centre, meaning.radius = {}, {}, None
    meaning.undotted.clear()


def _preparatory(value: float, meaning: Meaning, settings: Settings) -> None:
    code = round(value * 10)
    name = f"G{value:g}"
    if abs(value * 10 - code) > 1e-6 or code < 0:
        meaning.complain(f"{name} is not a known code", codes.NOT_KNOWN)
    elif code in codes.FAULTY and code not in codes.HARMLESS_ON.get(settings.dialect or "", ()):
        meaning.complain(f"{name} {codes.FAULTY[code].why}", codes.FAULTY[code].remedy)
    elif harm := codes.OTHERWISE_ON.get(settings.dialect or "", {}).get(code):
        meaning.complain(f"{name} {harm}", codes.MACHINE_REMEDY)
    elif code in _SETTING:
        what, value = _SETTING[code]
        _set(meaning, what, value, name)
    elif code == codes.DWELL:
        meaning.dwell = True
    elif code == codes.CANCEL_CYCLE:
        meaning.cancel_cycle = True
    elif code == codes.EXACT_STOP:
        meaning.exact_stop = True
    elif code not in codes.HARMLESS and code not in codes.FAULTY and code != codes.RESTORE_SHIFT:
        meaning.complain(f"{name} is not a known code", codes.NOT_KNOWN)
    meaning.codes.add(code)


def _set(meaning: Meaning, what: str, value: int | bool | str, name: str) -> None:
    before = getattr(meaning, what)
    if before not in (None, "", value):
        meaning.complain(f"{name} and another code of its group in one block")
    setattr(meaning, what, value)


def _miscellaneous(value: float, meaning: Meaning, settings: Settings) -> None:
    code = int(value)
    if code != value or code < 0:
        meaning.complain(f"M{value:g} is not a code")
    elif problem := m_codes.problem_of(code, settings.pass_m, settings.dialect):
        meaning.complain(*problem)
    meaning.miscellaneous.append(code)


def _other(word: Word, meaning: Meaning, machine_axes: tuple[str, ...]) -> None:
    letter = word.letter
    if letter in _PARAMETERS:
        meaning.parameters[letter] = word.value
    if meaning.dwell and letter in _DWELL:
        return
    if letter == "F":
        meaning.feed = word.value
    if letter == "T":
        meaning.tool = f"T{word.value:g}"
    if letter in _AXES:
        _axis(word, meaning, machine_axes)
    elif letter == "R" and meaning.data_code is not None:
        meaning.data[letter] = word.value
        _number(word, meaning)
    elif letter in _CENTRE:
        meaning.centre[letter] = word.value
        _number(word, meaning)
    elif letter == "R":
        meaning.radius = word.value
        _number(word, meaning)
    elif letter == "O":
        meaning.program_number = True
    elif letter == "H" and meaning.length_code == codes.TAKE_LENGTH and word.value >= 0 and word.value % 1 == 0:
        meaning.length_of = int(word.value)
    elif letter in _OFFSETS and word.value != 0.0:
        meaning.complain(
            f"{letter}{word.value:g} calls a tool offset, a shift that is not in the program", codes.MACHINE_REMEDY
        )
    elif letter in _PARAMETERS and not (
        meaning.miscellaneous
        or meaning.dwell
        or meaning.codes & codes.WITH_PARAMETERS
        or meaning.data_code == codes.WRITE_DATA
        or (letter == "P" and meaning.system.startswith("G54.1"))
    ):
        meaning.complain(f"{letter}{word.value:g} has no code here that it could belong to")
    elif letter not in _HARMLESS:
        meaning.complain(f"address {letter} is not known", "only words whose effect on positions is known are accepted")


def _axis(word: Word, meaning: Meaning, machine_axes: tuple[str, ...]) -> None:
    letter = word.letter
    if meaning.dwell:
        meaning.complain(f"{letter} in a block of G4 (dwell)", "give the motion a block of its own")
    if letter not in machine_axes:
        meaning.complain(f"{letter}: this machine has no axis {letter}", f"its axes are {' '.join(machine_axes)}")
        return
    (meaning.axes if meaning.data_code is None else meaning.data)[letter] = word.value
    _number(word, meaning)


def _number(word: Word, meaning: Meaning) -> None:
    """Note how the number of an axis or arc word is written."""
    meaning.decimals[word.letter] = word.decimals or 0
    if not word.dot and word.value != 0.0:
        meaning.undotted.add(word.letter)
