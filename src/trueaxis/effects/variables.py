"""The context variables that the expression of an effect may use."""

from dataclasses import dataclass

REFERENCE_TEMPERATURE = 20.0  # degC, ISO 1
# What d, d_time, d_path are before the first reversal: exp(-d/w) and its derivatives are then 0, an infinite d would
# make them NaN.
FARTHEST = 1e9


@dataclass(frozen=True, slots=True)
class Variable:
    """A context variable; unit: `axis` stands for mm or deg, as the axis has it."""

    name: str
    unit: str
    latex: str
    meaning: str


OF_AXIS = (
    Variable("q", "axis", "q", "commanded position of the axis"),
    Variable("s", "1", "s", "share of its travel, 0 at the lower end and 1 at the upper"),
    Variable("direction", "1", r"\sigma", "direction by which the axis came: +1, -1, 0 before it has moved"),
    Variable("v", "axis/s", "v", "its velocity while the reading is taken, 0 where it stands"),
    Variable("d", "axis", "d", "distance since its last reversal, 1e9 before the first"),
    Variable("d_time", "s", r"\Delta t", "time since its last reversal, 1e9 before the first"),
    Variable(
        "d_path", "mm", "p", "way along the path of all linear axes since its last reversal, 1e9 before the first"
    ),
)
OF_OTHER_AXIS = tuple(
    Variable(f"{one.name}_b", one.unit, f"{one.latex}_b", f"{one.meaning} (the other axis)") for one in OF_AXIS
)
OF_TIME = (
    Variable("t", "s", "t", "time of the reading"),
    Variable("T", "K", "T", "temperature less 20 degC"),
)
OF_READING = (
    Variable("along", "mm", r"\ell", "ideal displacement that the instrument senses, since home"),
    Variable("theta", "rad", r"\theta", "polar angle of a ball bar in the plane of its circle"),
    Variable("along_line", "mm", "w", "ideal way of laser or probe along the line of the motion, since home"),
)
SINCE_REVERSAL = ("d", "d_time", "d_path")

OF_COMPONENT_TERMS = (*OF_AXIS, *OF_OTHER_AXIS, *OF_TIME)
OF_READING_TERMS = (*OF_READING, *OF_TIME)
VARIABLES = {one.name: one for one in (*OF_AXIS, *OF_OTHER_AXIS, *OF_TIME, *OF_READING)}
