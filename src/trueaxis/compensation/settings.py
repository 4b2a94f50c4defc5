"""What a compensation is asked to do."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from typing import Literal

from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.tools import ToolTable
from trueaxis.compensation.touched_off import TouchedOff

Method = Literal["iterative", "ordinary"]
WordChoice = Literal["nearest", "ends", "middles"]
Orientation = Literal["keep", "correct"]
Arcs = Literal["keep", "chords"]
BlockDelete = Literal["fault", "run", "skip"]
Dialect = Literal["fanuc", "linuxcnc", "siemens", "heidenhain"]
Integers = Literal["mm", "least-increment"]
Language = Literal["nc", "apt"]

MM_PER_INCH = 25.4
TOLERANCE = 0.001  # mm, where none is stated: one step of words in mm
_MOST = {
    "tolerance": 1.0, "resolution": 1.0, "inch_resolution": 1.0, "rotary_resolution": 1.0, "chord_tolerance": 1.0,
    "peck_return": 100.0,
}  # fmt: skip
LEAST_MM, LEAST_INCH, LEAST_DEG = 0.001, 0.0001, 0.001  # least increments, ISO 6983-1 controls of the common class IS-B
FINE_INCH = 0.00001  # five decimals
WHOLE_MILLIMETRES = frozenset({"linuxcnc", "siemens", "heidenhain"})  # controls on which X100 can only be 100 mm


@dataclass(frozen=True, slots=True, kw_only=True)
class Settings:
    """Lengths mm, angles deg.

    tolerance: Delta of Eq. (56), the largest tool point error allowed after compensation; None: one step of the words,
    see `allowed`.
    resolution, inch_resolution (inch), rotary_resolution (deg): step of the NC words that are written; inch_resolution
    None: what controls of the dialect read, see `inch_step`.
    chord_tolerance: largest distance of an arc from the chords that replace it.
    arcs: whether arcs stay arcs where they can, see kept_arcs, or all become `chords`.
    method: `iterative` repeats Eq. (55); `ordinary` applies it once.
    words: `nearest` rounds; `ends` and `middles` choose words that minimise Eq. (6), see word_choice and middles.
    ball: P_W, centre of the workpiece ball in the workpiece frame; gives E of Eq. (6) its meaning.
    tool_point: P_T in the tool frame. start: axis positions before the first block (those known).
    assumed: where axes are taken to stand, for rapids, that nothing has given a position yet; home where it is silent.
    orientation: `keep` corrects with the linear axes alone; `correct` turns rotary axes too, so that the tool axis
    points where the error-free machine's would, to orientation_tolerance_urad. tool_axis: its direction, tool frame.
    block_delete: what a motion in a `/` block is: a fault, run, or skipped.
    dialect: the control's language, None: not known. integers: what a number without a decimal point counts, None: what
    the dialect fixes. pass_m, pass_g: M and G codes that the user vouches for, see nc.m_codes, nc.g_codes.
    offsets: work offsets that are known. tools: tools that are known, None: none are. spindle_tool: the one in the
    spindle before the program, 0: none, None: not known. touched_off: work offsets that were touched off without
    compensation, see datum. keep_g53: motions in machine coordinates stay as they are. reference_points: machine
    positions to which `G28` and `G30` go.
    peck_return: the way back that breaks the chip (G73), and before the cut goes on (G83): LinuxCNC's 0.010 inch.
    judged: whether an interpreter has judged the arcs of the program: their radii may differ as they like.
    temperature (degC), time (s since the start): what effects that depend on them are compensated for; None: not known.
    batch_points: points computed at a time; bounds the memory.

    Raises ValueError when a value is out of its range.
    """

    tolerance: float | None = None
    resolution: float = 0.001
    inch_resolution: float | None = None
    rotary_resolution: float = 0.0001
    chord_tolerance: float = 0.0005
    arcs: Arcs = "keep"
    method: Method = "iterative"
    words: WordChoice = "nearest"
    ball: tuple[float, float, float] | None = None
    tool_point: tuple[float, float, float] = (0.0, 0.0, 0.0)
    start: Mapping[str, float] = field(default_factory=dict)
    assumed: Mapping[str, float] = field(default_factory=dict)
    orientation: Orientation = "keep"
    orientation_tolerance_urad: float = 2.0  # words of 0.0001 deg are up to 0.87 urad off in each of two axes
    tool_axis: tuple[float, float, float] = (0.0, 0.0, 1.0)
    block_delete: BlockDelete = "fault"
    dialect: Dialect | None = None
    integers: Integers | None = None
    pass_m: tuple[int, ...] = ()
    pass_g: tuple[float, ...] = ()
    offsets: Offsets = field(default_factory=Offsets)
    tools: ToolTable | None = None
    spindle_tool: int | None = None
    touched_off: tuple[TouchedOff, ...] = ()
    keep_g53: bool = False
    reference_points: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    peck_return: float = 0.254
    judged: bool = False
    temperature: float | None = None
    time: float | None = None
    batch_points: int = 16384

    def __post_init__(self) -> None:
        if problems := [*self._problems()]:
            raise ValueError("; ".join(problems))

    @property
    def undotted(self) -> Integers | None:
        """What a number without a decimal point counts; None: not known, a Fanuc control's parameter decides."""
        return self.integers or ("mm" if self.dialect in WHOLE_MILLIMETRES else None)

    @property
    def aim(self) -> float:
        """The tolerance by which points are solved and lines are cut, whatever words can name."""
        return TOLERANCE if self.tolerance is None else self.tolerance

    def allowed(self, inch: bool) -> float:
        """Largest tool point error of points with words in inch, or in mm. Where no tolerance is stated, words of the
        least increment of IS-B in inch are within it by rounding alone, as those of 0.001 mm are; coarser ones are not.
        """
        step = min(self.inch_step, LEAST_INCH) * MM_PER_INCH if inch and self.tolerance is None else 0.0
        return max(self.aim, step)

    @property
    def inch_step(self) -> float:
        """Step of words in inch: least increments of IS-B where the control is Fanuc's, finer elsewhere."""
        if self.inch_resolution is not None:
            return self.inch_resolution
        return LEAST_INCH if self.dialect == "fanuc" else FINE_INCH

    @property
    def unknown_tool(self) -> str:
        """What is wrong where the tool in the spindle is none of those that are given; empty where it is one."""
        if not self.spindle_tool or (self.tools is not None and self.spindle_tool in self.tools.tools):
            return ""
        problem = "not in --tools" if self.tools else "not known: say --tools FILE"
        return f"tool {self.spindle_tool} is in the spindle before the program, and is {problem}"

    def _problems(self) -> Iterator[str]:
        """Everything that is out of its range."""
        for name, most in _MOST.items():
            derived = {"inch_resolution": self.inch_step, "tolerance": self.aim}
            value = derived[name] if name in derived else getattr(self, name)
            if not (math.isfinite(value) and 0.0 < value <= most):
                yield f"{name} is {value:g}; it must be above 0 and at most {most:g}"
            elif name.endswith("resolution"):
                try:
                    decimals(value)
                except ValueError as problem:
                    yield str(problem)
        if not 0.0 < self.orientation_tolerance_urad <= 1e4:
            yield (
                f"orientation_tolerance_urad is {self.orientation_tolerance_urad:g}; "
                "it must be above 0 and at most 10000"
            )
        for name in ("ball", "tool_point", "tool_axis"):
            values = getattr(self, name)
            if values is not None and not (len(values) == 3 and all(map(math.isfinite, values))):
                yield f"{name} must be three finite coordinates"
        if math.hypot(*self.tool_axis) < 1e-6:
            yield "tool_axis must be a direction, not zero"
        if not all(map(math.isfinite, (*self.start.values(), *self.assumed.values()))):
            yield "start must hold finite positions"
        for name in ("temperature", "time"):
            value = getattr(self, name)
            if value is not None and not math.isfinite(value):
                yield f"{name} is {value:g}; it must be finite"
        if self.words != "nearest" and self.ball is None:
            yield f"words '{self.words}' minimises the error along the ball bar; give the ball too"


def decimals(resolution: float) -> int:
    """Digits after the decimal point that write every multiple of `resolution` exactly.

    Raises ValueError when more than 7 would be needed.
    """
    exponent = Decimal(repr(resolution)).normalize().as_tuple().exponent
    if not isinstance(exponent, int) or exponent < -7:
        raise ValueError(f"resolution {resolution!r} needs more than 7 decimals")
    return max(0, -exponent)
