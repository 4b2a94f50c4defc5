"""Words for the checks: where structure was looked for, what it is, and what to measure where it was found."""

from collections.abc import Mapping

from trueaxis.diagnosis.judging.structure import Check, StructureClass

LINES, CIRCLES, ERRORS = "lines of", "circles of", "readings that show"

# class -> where, what, meaning, what to measure; {}: the axis of lines, the plane of circles, the run, the instrument
_WORDS: Mapping[StructureClass, tuple[str, str, str, str]] = {
    StructureClass.LINE_DIRECTION: (
        LINES,
        "between directions",
        "differs by the direction of approach",
        "the lines of {} again, each target from both sides",
    ),
    StructureClass.LINE_DIRECTION_BY_LINE: (
        LINES,
        "between directions, by line",
        "differs by the direction of approach, otherwise on each line",
        "the lines of {} again, each target from both sides",
    ),
    StructureClass.LINE_BY_LINE: (
        LINES,
        "by line",
        "depends on the position, otherwise on each line",
        "a further line of {} at another offset of the other axes",
    ),
    StructureClass.LINE_COURSE: (
        LINES,
        "in the course of a run",
        "changes while a run is taken, alike in all",
        "the lines of {} again, each over a longer time, with the temperature beside it",
    ),
    StructureClass.LINE_TEMPERATURE: (
        LINES,
        "with temperature",
        "follows the temperature",
        "a line of {} again over a change of the temperature, measured at the scale or screw",
    ),
    StructureClass.LINE_RIPPLE: (
        LINES,
        "ripple between directions",
        "ripple that changes sign with the direction",
        "the lines of {} again, each target from both sides",
    ),
    StructureClass.LINE_LOCAL: (
        LINES,
        "locally",
        "a place where the readings deviate, by direction",
        "the line of {} again with targets at a fifth of the distance where the readings deviate",
    ),
    StructureClass.CIRCLE_LOBES: (
        CIRCLES,
        "lobes",
        "lobes common to both directions",
        "the circle in {} with another bar, and with the bar turned in its sockets",
    ),
    StructureClass.CIRCLE_RIPPLE: (CIRCLES, "ripple", "ripple common to both directions", ""),
    StructureClass.CIRCLE_COURSE: (
        CIRCLES,
        "in the course of a run",
        "changes while a run is taken, alike in all",
        "the circle in {} again, two turns in a row, of a machine that has moved before",
    ),
    StructureClass.CIRCLE_DIRECTION: (
        CIRCLES,
        "lobes by direction",
        "lobes that change sign with the direction",
        "the circle in {} again, both directions in turn",
    ),
    StructureClass.CIRCLE_RIPPLE_DIRECTION: (
        CIRCLES,
        "ripple by direction",
        "ripple that changes sign with the direction",
        "the circle in {} again, both directions in turn",
    ),
    StructureClass.CIRCLE_FEED: (
        CIRCLES,
        "lobes by feed",
        "lobes that change with the feed",
        "the circle in {} at two further feeds",
    ),
    StructureClass.CIRCLE_DIRECTION_FEED: (
        CIRCLES,
        "lobes by direction and feed",
        "lobes that change with direction and feed",
        "the circle in {} at two further feeds, in both directions",
    ),
    StructureClass.CIRCLE_REVERSALS: (
        CIRCLES,
        "at reversals",
        "steps where an axis reverses",
        "the circle in {} at a quarter of the feed, with samples close to the reversals",
    ),
    StructureClass.CIRCLE_AFTER_REVERSALS: (
        CIRCLES,
        "after reversals",
        "a course after each reversal",
        "the circle in {} at a quarter of the feed, with samples close to the reversals",
    ),
    StructureClass.ERROR_DIRECTION: (
        ERRORS,
        "between directions",
        "differs by the direction of motion, in a way that depends on the position",
        "lines and circles that show {} again, each target from both sides",
    ),
    StructureClass.ERROR_AFTER_REVERSALS: (
        ERRORS,
        "after reversals",
        "changes with the distance since the axis turned back",
        "a line that shows {}, with targets at small distances after each reversal",
    ),
    StructureClass.ERROR_COURSE: (
        ERRORS,
        "with time",
        "changes while the machine is measured",
        "a line that shows {} again after some hours, with time and temperature beside it",
    ),
    StructureClass.ONE_PERIOD: ("run", "one period", "the readings of run {} vary with one period", ""),
    StructureClass.LACK_OF_FIT: (
        "readings of the",
        "lack of fit",
        "readings of the {} deviate more than repeats differ",
        "",
    ),
}


def check_name(check: Check) -> str:
    """Where and what: lines of X, between directions."""
    where, what, _, _ = _WORDS[check.structure]
    return f"{where} {check.place}, {what}"


def check_meaning(check: Check) -> str:
    """What it is, as a part of a sentence."""
    return _WORDS[check.structure][2].format(check.place)


def closer_look(check: Check) -> str:
    """What to measure to see more of it; empty where there is nothing in particular."""
    return _WORDS[check.structure][3].format(check.place)
