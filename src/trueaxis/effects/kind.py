"""What an effect may be: a kind, its expression and its parameters."""

from dataclasses import dataclass
from typing import Literal

from trueaxis.error_name import ErrorName

Place = Literal["component", "reading", "point", "location"]
Role = Literal["linear", "phase", "root", "grid"]
Grid = Literal["pitch", "time", "reversal", "reversal_time", "reversal_path", "moment", "given"]
DIVISORS = ("pitch", "time", "reversal", "reversal_time", "reversal_path")  # grids of what terms divide by


@dataclass(frozen=True, slots=True, kw_only=True)
class Parameter:
    """A parameter of a kind.

    unit: with `u` for the unit of the component (mm or rad) and `axis` for that of its axis (mm or deg).
    role: how the search finds it. `linear`: the term is proportional to it, or to sums over such parameters. `phase`:
    of a cosine whose amplitude is the linear parameter. `root`: the term is proportional to its square. `grid`: any
    other way; searched on a grid, `grid` telling which, `values` the grid itself where it is `given`.
    """

    name: str
    unit: str
    meaning: str
    role: Role = "linear"
    grid: Grid | None = None
    values: tuple[float, ...] = ()

    @property
    def is_divisor(self) -> bool:
        """Whether terms divide by it: it is above zero, and a step changes it by a factor."""
        return self.grid in DIVISORS


@dataclass(frozen=True, slots=True, kw_only=True)
class Kind:
    """A kind of effect.

    place: what the term is added to. `component`: a component error of an axis; `reading`: the readings of an
    instrument; `point`: a point of the set-up (no expression: its three coordinates are the parameters);
    `location`: a position error that the spec leaves out (no expression either).
    expression: of context variables (see `variables`) and parameters, in the language of `expression`.
    directions: which component errors it may act on, as first letters: `along` its axis, `across`, `turn` (rotations).
    instruments: whose readings, for the places `reading` and `point`; empty: those of all. by_run: whether it is of
    some runs alone.
    nuisance: every set-up has some of it, which an estimate takes up without a name for it: no search lists it among
    the causes; a spec may name it.
    sentence: the physical cause. confused_with and broken_by: what it is mistaken for, and what tells them apart.
    """

    name: str
    place: Place
    expression: str
    parameters: tuple[Parameter, ...]
    sentence: str
    confused_with: str = ""
    broken_by: str = ""
    directions: tuple[str, ...] = ()
    components: tuple[str, ...] = ()
    other_axis: bool = False
    instruments: tuple[str, ...] = ()
    by_run: bool = False
    nuisance: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Effect:
    """A term of a machine: a kind at its place.

    component: such as EXX (`EC0X` for a squareness: ISO 230-7 style, the position error EC of X); axis: the other
    axis, where the kind has one; runs: ids of the runs whose readings it is in; end: `target` or `reference`, the
    point of the set-up that is off.
    """

    kind: str
    component: str | None = None
    axis: str | None = None
    runs: tuple[str, ...] = ()
    end: str | None = None

    @property
    def error(self) -> ErrorName:
        """The component by its name. Raises ValueError where the effect is on readings or on a point of the set-up."""
        return ErrorName(self.component or "")

    @property
    def own_axis(self) -> str:
        """The axis whose error it adds to, X .. C; empty where it is on readings or on a point of the set-up."""
        return self.error.axis if self.component else ""

    @property
    def label(self) -> str:
        """As a report names it: `backlash EXX`, `cross_axis EXX with Y`, `laser_cosine of X1, X2`."""
        text = self.kind
        if self.component:
            text += f" {self.component}"
        if self.axis:
            text += f" with {self.axis}"
        if self.end:
            text += f" of the {self.end}"
        if self.runs:
            text += f" of {', '.join(self.runs)}"
        return text
