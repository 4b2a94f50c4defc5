"""Sorts the words of one NC block by what they do."""

from trueaxis.compensation.machine import LINEAR, ROTARY
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.nc.lexer import Block, Meaning, Word
from trueaxis.compensation.nc.together import check_together
from trueaxis.compensation.offsets import system_name
from trueaxis.compensation.settings import Settings

_AXES = frozenset(LINEAR + ROTARY)
_CENTRE = frozenset("IJK")
_ONCE = frozenset("XYZABCIJKRFSTN")
_PARAMETERS = frozenset("PQLE")
_MACRO_CALLS = frozenset({650, 660, 661})  # G65 G66 G66.1: the other words are arguments
_OFFSETS = frozenset("DH")
_HARMLESS = frozenset("FSNT") | _PARAMETERS | _OFFSETS
TO_PLC = "goes to the machine's own control (PLC), and is taken to move no axis"
_OF_UNKNOWN = frozenset("NDEHLPQR")  # letters that may be words of a code that is not known
_DWELL = frozenset("XUPFS")  # words of a G4 block, of which X and U are a time
# what a code sets of a Meaning, and to what
_SETTING: dict[int, tuple[str, int | bool | str]] = {
    **{code: ("motion", code // 10) for code in codes.MOTION},
    **{code: ("plane", code) for code in codes.PLANES},
    **{code: ("system", name) for code, name in codes.SYSTEMS.items()},
    **{code: ("data_code", code) for code in codes.WITH_DATA},
    200: ("inch", True), 210: ("inch", False), 900: ("absolute", True), 910: ("absolute", False),
    codes.TAKE_LENGTH: ("length_code", codes.TAKE_LENGTH), codes.END_LENGTH: ("length_code", codes.END_LENGTH),
    930: ("feed_mode", "time"), 940: ("feed_mode", "minute"), 950: ("feed_mode", "turn"),
    980: ("at_initial_level", True), 990: ("at_initial_level", False),
    **{code: ("cycle", code) for code in codes.CYCLES},
}  # fmt: skip


def interpret(
    block: Block,
    machine_axes: tuple[str, ...],
    settings: Settings,
    in_cycle: bool = False,
    meaning: Meaning | None = None,
) -> Meaning:
    """Sort the words of a block by what they do; in_cycle: whether a canned cycle is in force; meaning: of its keywords
    so far.
    """
    meaning = Meaning() if meaning is None else meaning
    if block.problem:
        meaning.complain(block.problem, codes.numbers_for(settings.dialect) if block.macro else "")
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
    goes_on = in_cycle and meaning.motion is None and not meaning.cancel_cycle and not meaning.in_machine_coordinates
    meaning.drilling = meaning.data_code is None and not meaning.dwell and (meaning.cycle is not None or goes_on)
    centre = any(word.letter in _CENTRE for word in others)
    meaning.turns = settings.dialect == "linuxcnc" and centre and meaning.motion in (None, 2, 3)
    alone = bool(meaning.unknown) and {word.letter for word in others} <= _OF_UNKNOWN
    for word in () if alone else others:
        _other(word, meaning, machine_axes, settings.dialect == "siemens")
    if meaning.frame and meaning.data:
        meaning.complain(meaning.frame, codes.WITHOUT_IT)
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
    check_together(meaning, alone and len(block.words) == len(others) + 1, settings.dialect or "")
    return meaning


def _preparatory(value: float, meaning: Meaning, settings: Settings) -> None:
    code, name, dialect = round(value * 10), f"G{value:g}", settings.dialect or ""
    if abs(value * 10 - code) > 1e-6 or code < 0:
        meaning.complain(f"{name} is not a known code", codes.NOT_KNOWN)
    elif _only_on(dialect, code, name, meaning):
        pass
    elif code in codes.FAULTY and code not in codes.HARMLESS_ON.get(dialect, ()):
        why, remedy = codes.refused(code, dialect)
        meaning.complain(f"{name} {why}", remedy)
    elif code in _SETTING:
        what, setting = _SETTING[code]
        if what == "length_code" and dialect in codes.POINT_CONTROL_ON:
            meaning.point_control = False  # G43 and G49 take the place of G43.4
        _set(meaning, what, setting, name)
    elif code == codes.DWELL:
        meaning.dwell = True
    elif code == codes.CANCEL_CYCLE:
        meaning.cancel_cycle = True
    elif code == codes.EXACT_STOP:
        meaning.exact_stop = True
    elif code not in codes.HARMLESS | codes.HARMLESS_ON.get(dialect, frozenset()) and code != codes.RESTORE_SHIFT:
        meaning.unknown = name
        if value not in settings.pass_g:
            meaning.complain(f"{name} is not a known code", codes.PASS_G.format(f"{value:g}"))
    meaning.codes.add(codes.SAME_ON.get(dialect, {}).get(code, code))


def _only_on(dialect: str, code: int, name: str, meaning: Meaning) -> bool:
    """Take in a code that means something else on this control than on the others; False if it is none."""
    if code in codes.INCH_ON.get(dialect, {}):
        _set(meaning, "inch", codes.INCH_ON[dialect][code], name)
    elif code in codes.POINT_CONTROL_ON.get(dialect, ()):
        meaning.length_code, meaning.point_control = codes.TAKE_LENGTH, True
    elif dialect == "siemens" and (name == codes.MACHINE_FRAME or (code > codes.FURTHER_SYSTEMS and system_name(name))):
        _set(meaning, "system", name, name)
    elif harm := codes.OTHERWISE_ON.get(dialect, {}).get(code):
        meaning.complain(f"{name} {harm}", codes.WITHOUT_IT)
    elif code in codes.KEPT_CYCLES_ON.get(dialect, ()):
        _set(meaning, "cycle", code, name)
    elif code in codes.LOOK_AHEAD_ON.get(dialect, {}):
        meaning.look_ahead = code
    else:
        return False
    return True


def _set(meaning: Meaning, what: str, value: int | bool | str, name: str) -> None:
    before = getattr(meaning, what)
    if before not in (None, "", value):
        meaning.complain(f"{name} and another code of its group in one block")
    setattr(meaning, what, value)


def _miscellaneous(value: float, meaning: Meaning, settings: Settings) -> None:
    code = int(value)
    if code != value or code < 0:
        meaning.complain(f"M{value:g} is not a code")
    elif code in m_codes.POINT_CONTROL.get(settings.dialect or "", {}):
        meaning.point_control = m_codes.POINT_CONTROL[settings.dialect or ""][code]
    elif problem := m_codes.problem_of(code, settings.pass_m, settings.dialect):
        meaning.complain(*problem)
    meaning.miscellaneous.append(code)


def _other(word: Word, meaning: Meaning, machine_axes: tuple[str, ...], edges: bool) -> None:
    """A word that is no code; edges: whether D selects an edge of the tool."""
    letter = word.letter
    if letter in _PARAMETERS or (letter == "K" and meaning.drilling) or (letter == "R" and meaning.look_ahead):
        meaning.parameters[letter] = word.value
    if meaning.dwell and letter in _DWELL:
        return
    if letter == "F":
        meaning.feed = word.value
    if letter == "T":
        meaning.tool = f"T{word.value:g}"
    if letter in _AXES:
        _axis(word, meaning, machine_axes)
    elif letter == "R" and (meaning.data_code is not None or meaning.drilling):
        meaning.data[letter] = word.value
        _number(word, meaning)
    elif letter == "R" and not meaning.look_ahead:
        meaning.radius = word.value
        _number(word, meaning)
    elif letter in _CENTRE and not (letter == "K" and meaning.drilling):
        meaning.centre[letter] = word.value
        _number(word, meaning)
    elif letter == "O":
        meaning.program_number = True
    elif letter == "D" and edges:
        _edge(word, meaning)
    elif letter == "H" and edges:
        meaning.notes.append(f"H{word.value:g} {TO_PLC}")
    else:
        _number_of_code(word, meaning)


def _number_of_code(word: Word, meaning: Meaning) -> None:
    """A word that is no position: whether it belongs to a code of the block."""
    letter = word.letter
    if letter == "H" and meaning.length_code == codes.TAKE_LENGTH and word.value >= 0 and word.value % 1 == 0:
        meaning.length_of = int(word.value)
    elif letter == "D" and not codes.WITH_D.isdisjoint(meaning.codes):
        return
    elif letter in _OFFSETS and word.value != 0.0 and not _explained(meaning):
        meaning.complain(
            f"{letter}{word.value:g} calls a tool offset, a shift that is not in the program", codes.WITHOUT_IT
        )
    elif letter in _PARAMETERS and not _takes(letter, meaning):
        further = f"G54.1 P{word.value:g} for a further work offset" if letter + meaning.system == "PG54" else ""
        meaning.complain(f"{letter}{word.value:g} has no code here that it could belong to", further)
    elif letter not in _HARMLESS and letter not in "KR":
        meaning.complain(f"address {letter} is not known", "only words whose effect on positions is known are accepted")
    if letter == "Q" and meaning.drilling:
        _number(word, meaning)


def _edge(word: Word, meaning: Meaning) -> None:
    """D of SINUMERIK: the length of the tool in the spindle."""
    if word.value in (0.0, 1.0):
        meaning.length_code = codes.TAKE_LENGTH if word.value else codes.END_LENGTH
    else:
        meaning.complain(f"D{word.value:g} selects another edge of the tool", "D1, and the tool's length in --tools")


def _takes(letter: str, meaning: Meaning) -> bool:
    """Whether a code of the block takes a word with this address."""
    return bool(
        _explained(meaning)
        or meaning.miscellaneous
        or meaning.dwell
        or not meaning.codes.isdisjoint(codes.PATH_MODES)
        or meaning.look_ahead
        or meaning.data_code in (codes.WRITE_DATA, codes.TO_SECOND_REFERENCE)
        or (letter == "P" and meaning.system.startswith("G54.1"))
        or (meaning.drilling and letter != "E")
        or (letter == "P" and meaning.turns)
    )


def _explained(meaning: Meaning) -> bool:
    """Whether a code of the block is refused, which says enough of its words."""
    return bool(meaning.complaints) and not meaning.codes.isdisjoint(codes.FAULTY)


def _axis(word: Word, meaning: Meaning, machine_axes: tuple[str, ...]) -> None:
    letter = word.letter
    if meaning.dwell:
        meaning.complain(f"{letter} in a block of G4 (dwell)", "give the motion a block of its own")
    if letter not in machine_axes:
        if _MACRO_CALLS.isdisjoint(meaning.codes):
            meaning.complain(f"{letter}: this machine has no axis {letter}", f"its axes are {' '.join(machine_axes)}")
        return
    (meaning.axes if meaning.data_code is None else meaning.data)[letter] = word.value
    _number(word, meaning)


def _number(word: Word, meaning: Meaning) -> None:
    """Note how the number of an axis or arc word is written."""
    meaning.decimals[word.letter] = word.decimals or 0
    if not word.dot and word.value != 0.0:
        meaning.undotted.add(word.letter)
