"""One body of a machine spec: its joint to its lower body, from a [[body]] or an [axis.X] table."""

from typing import Any

from trueaxis.error_name import DIRECTIONS, Direction, ErrorName
from trueaxis.machine.fields import Fields, shown
from trueaxis.machine.machine import AXES, LINEAR, Body

# Titles and names of bodies stand in docstrings, comments and tables of Markdown.
FARTHEST = 1e5  # mm, from the origin of the lower body's frame: the largest gantry machines travel 6e4
MOST_DEGREES = 1e6  # of a rotary axis, either way: thousands of turns
SHORTEST_TRAVEL = 1e-3  # mm or deg: shares of a travel are quotients by it

PROSE, PROSE_MEANING = r"[\w .,:;()/&'+#-]+", "letters, digits, spaces and . , : ; ( ) / & ' + # - _"


def read_body(fields: Fields) -> Body | None:
    """The body of a [[body]] table; None when its place in the machine is unknown. Complains of every fault."""
    number, lower = fields.integer("number"), fields.integer("lower")
    moves = fields.choice("moves", AXES)
    body = read_joint(fields, number or 0, lower or 0, moves, f"body {number}", ())
    if "moves" not in fields.raw and "sense" in fields.raw:
        fields.fault("sense", "a body that does not move has no sense", "leave it out, or say what moves it")
    return None if number is None or lower is None else body


def read_joint(
    fields: Fields, number: int, lower: int, moves: str | None, name: str, location: tuple[tuple[Direction, str], ...]
) -> Body:
    """The body that a table describes; `name` and `location` (position errors) hold where the table is silent."""
    said = fields.text("name", default=name, pattern=PROSE, meaning=PROSE_MEANING)
    sense = fields.integer("sense", default=1)
    travel = _travel(fields, moves)
    position = _position(fields)
    motion_errors = _motion_errors(fields, moves)
    pairs = fields.table("position_errors")
    if "position_errors" in fields.raw:
        location = tuple(
            (direction, parameter)
            for direction in DIRECTIONS
            if direction in pairs.raw and (parameter := pairs.text(direction)) is not None
        )
    pairs.refuse_others(f"the directions {' '.join(DIRECTIONS)}")
    fields.refuse_others()
    if sense not in (1, -1):
        fields.fault("sense", f"{sense} is no sense", "1, or -1 where a positive command moves the body the other way")
    return Body(
        number=number,
        name=said or name,
        lower=lower,
        moves=moves,
        sense=sense or 1,
        travel=travel,
        position=position,
        motion_errors=motion_errors,
        position_errors=location,
    )


def _travel(fields: Fields, moves: str | None) -> tuple[float, float] | None:
    if moves is None and "moves" not in fields.raw:
        if "travel" in fields.raw:
            fields.fault("travel", "a body that does not move has no travel", 'leave it out, or add moves = "X"')
        fields.known.add("travel")
        return None
    endless = "" if moves in LINEAR else "; of an axis without ends as its control has it, such as [-99999.0, 99999.0]"
    travel = fields.numbers("travel", 2, required=moves is not None, also=endless)
    if travel is None:
        return None
    runs = f"runs from {travel[0]:g} to {travel[1]:g}"
    farthest, unit = (FARTHEST, "mm") if moves in LINEAR or moves is None else (MOST_DEGREES, "deg")
    if not travel[0] < travel[1]:
        fields.fault("travel", runs, "the lower end first, the upper end after it")
    elif travel[1] - travel[0] < SHORTEST_TRAVEL:
        fields.fault("travel", runs, f"{SHORTEST_TRAVEL:g} {unit} at least")
    if max(map(abs, travel)) > farthest:
        fields.fault("travel", runs, f"ends in {unit}, at most {farthest:g} from 0")
    return travel[0], travel[1]


def _position(fields: Fields) -> tuple[float | str, float | str, float | str]:
    fields.known.add("position")
    value = fields.raw.get("position", [0.0, 0.0, 0.0])
    if not isinstance(value, list) or len(value) != 3:
        fields.fault("position", "is not a position", "three numbers (mm) or names of parameters")
        return (0.0, 0.0, 0.0)
    read: list[float | str] = []
    for index, part in enumerate(value):
        if isinstance(part, str):
            read.append(part)
        elif (number := fields.finite(part)) is not None and abs(number) <= FARTHEST:
            read.append(number)
        else:
            fields.fault(
                "position",
                f"entry {index + 1} is {shown(part)}",
                f"a finite number (mm, at most {FARTHEST:g}) or the name of a parameter",
            )
            read.append(0.0)
    return read[0], read[1], read[2]


def _motion_errors(fields: Fields, moves: str | None) -> tuple[ErrorName, ...]:
    fields.known.add("motion_errors")
    value: Any = fields.raw.get("motion_errors", "all" if moves else [])
    if moves is None and "moves" in fields.raw:
        return ()  # which errors it may have is unknown until its axis is
    allowed = tuple(direction.motion_error(moves) for direction in DIRECTIONS) if moves else ()
    if value == "all" and moves:
        return allowed
    if not isinstance(value, list):
        fields.fault("motion_errors", f"is {shown(value)}", '"all" for a moving body, or a list such as ["EXY", "ECY"]')
        return ()
    seen: list[Any] = []
    for entry in value:
        if len(seen) > len(DIRECTIONS):
            fields.fault("motion_errors", f"has {len(value)} entries", f"{len(DIRECTIONS)} at most")
            break
        if entry not in allowed:
            right = f"of {' '.join(allowed)}" if allowed else "no motion errors: the body does not move"
            fields.fault("motion_errors", f"{shown(entry)} is no motion error of this body", right)
        elif entry in seen:
            fields.fault("motion_errors", f"{entry!r} stands there already", "each name once")
        seen.append(entry)
    return tuple(name for name in allowed if name in value)
