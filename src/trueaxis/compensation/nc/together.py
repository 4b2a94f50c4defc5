"""What the words of one NC block mean beside each other: codes that the user vouches for, that cancel, or that are one
control's own.
"""

from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.nc.lexer import Meaning


def check_together(meaning: Meaning, alone: bool, dialect: str) -> None:
    """Note what is wrong; alone: whether a code that is not known has only words beside it that may be its own."""
    _passed(meaning, alone)
    _cancels(meaning)
    _look_ahead(meaning, dialect)
    _on_linuxcnc(meaning, dialect)


def _passed(meaning: Meaning, alone: bool) -> None:
    """A code that is not known and the user vouches for; alone: with words only that may belong to it."""
    if not meaning.unknown or meaning.complaints:
        return
    if alone:
        meaning.notes.append(f"{meaning.unknown} passes as --pass-g says: it moves no axis and changes no mode")
    else:
        beside = f"{meaning.unknown}, which --pass-g names, beside axis words or other codes"
        meaning.complain(beside, "a block of its own")


def _on_linuxcnc(meaning: Meaning, dialect: str) -> None:
    """M61 Q: which tool is in the spindle; whose P and Q are, of G64 or of a cycle."""
    if dialect != "linuxcnc":
        return
    if meaning.drilling and codes.CONTINUOUS in meaning.codes:
        meaning.drilling = meaning.cycle is not None or meaning.positions or bool(meaning.data)
        if meaning.drilling:
            meaning.complain("G64 in the block of a cycle: whose P and Q are is not determined", "make it two blocks")
    if m_codes.TOOL_NUMBER not in meaning.miscellaneous:
        return
    number = meaning.parameters.get("Q", -1.0)
    if number < 0.0 or number != int(number):
        meaning.complain("M61 without the number of the tool in the spindle", "M61 Q1")
    elif m_codes.TOOL_CHANGE in meaning.miscellaneous:
        meaning.complain("M6 and M61 in one block")
    else:
        meaning.in_spindle = int(number)


def _look_ahead(meaning: Meaning, dialect: str) -> None:
    """A mode of looking ahead: whether it is one that leaves positions as they are."""
    if not meaning.look_ahead:
        return
    letter, values = codes.LOOK_AHEAD_ON[dialect][meaning.look_ahead]
    name = f"G{meaning.look_ahead / 10:g}"
    value = meaning.parameters.get(letter)
    if value not in values:
        given = name if value is None else f"{name} {letter}{value:g}"
        right = " or ".join(f"{name} {letter}{one:g}" for one in sorted(values))
        meaning.complain(f"{given} is not known to leave positions as they are", right)
    elif meaning.positions or set(meaning.parameters) - {letter, "R"}:
        meaning.complain(f"other words beside {name} {letter}{value:g}", "a block of its own, without axis words")
    elif value:
        meaning.notes.append(f"{name} {letter}{value:g}: {codes.ROUNDS}")


def _cancels(meaning: Meaning) -> None:
    """Axis words beside a cancelling code: whether they are positions differs by code and control."""
    with_axes, alone = meaning.codes & codes.CANCELS_WITH_AXES, meaning.codes & codes.CANCELS_ALONE
    if not (with_axes or alone) or not meaning.positions:
        return
    name = f"G{min(with_axes | alone) / 10:g}"
    if alone or meaning.motion is not None:
        meaning.complain(f"{name} and axis words in one block: whose they are is not determined", "make it two blocks")
    elif 921 in with_axes and any((*meaning.axes.values(), *meaning.centre.values(), meaning.radius)):
        meaning.complain(f"{name} with words other than 0 may shift the frame of the positions", codes.WITHOUT_IT)
    meaning.axes, meaning.centre, meaning.radius = {}, {}, None
    meaning.undotted.clear()
