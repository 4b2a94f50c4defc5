"""Structure of the residuals that needs no cause to be seen."""

from dataclasses import dataclass
from enum import Enum


class StructureClass(Enum):
    """Classes of structure that need no cause; the value is the id in diagnosis.json."""

    LINE_DIRECTION = "line_direction"
    LINE_DIRECTION_BY_LINE = "line_direction_by_line"
    LINE_BY_LINE = "line_by_line"
    LINE_COURSE = "line_course"
    LINE_TEMPERATURE = "line_temperature"
    LINE_RIPPLE = "line_ripple"
    LINE_LOCAL = "line_local"
    CIRCLE_LOBES = "circle_lobes"
    CIRCLE_RIPPLE = "circle_ripple"
    CIRCLE_COURSE = "circle_course"
    CIRCLE_DIRECTION = "circle_direction"
    CIRCLE_RIPPLE_DIRECTION = "circle_ripple_direction"
    CIRCLE_FEED = "circle_feed"
    CIRCLE_DIRECTION_FEED = "circle_direction_feed"
    CIRCLE_REVERSALS = "circle_reversals"
    CIRCLE_AFTER_REVERSALS = "circle_after_reversals"
    ERROR_DIRECTION = "error_direction"
    ERROR_AFTER_REVERSALS = "error_after_reversals"
    ERROR_COURSE = "error_course"
    ONE_PERIOD = "one_period"
    LACK_OF_FIT = "lack_of_fit"  # sees any structure, and says nothing of its kind


@dataclass(frozen=True, slots=True, kw_only=True)
class Check:
    """A test for structure of a class that needs no cause; p_value already multiplied by the number of checks.

    place: axis of lines, plane of circles, component error, run or instrument; rms: of the structure over the readings,
    mm; excess: its whitened squares beyond those of noise.
    """

    structure: StructureClass
    place: str
    p_value: float
    fired: bool
    rms: float
    excess: float = 0.0
