"""What every estimation of one data set shares, and what it is asked to do."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from trueaxis.error_name import ErrorName
from trueaxis.estimation.curve_prior import DEGREE
from trueaxis.estimation.effects.unknowns import EffectUnknowns
from trueaxis.estimation.giving_way import giving_way
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.runs import MeasuredRun, measured_runs
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import State, started
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class EstimationOptions:
    """noise: standard deviation of the readings of runs, by index, mm; that of an instrument is estimated unless all of
    its runs are there; start: values of effects, which spare the search of those that the readings do not depend on
    linearly; prior: whether anything is expected of the machine's errors: if not, what the readings do not determine is
    zero, and `open`; ideal: whether nothing is unknown of the instruments; degree: of the curves; None:
    with a prior as high as readings tell, else DEGREE; changes: whether readings are changes against values given: one
    run may then hold all that has changed, and contradicts nothing.
    """

    noise: Mapping[int, float] = field(default_factory=dict)
    start: Sequence[EffectValues] = ()
    prior: bool = True
    ideal: bool = False
    degree: int | None = None
    changes: bool = False


USUAL = EstimationOptions()


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Setting:
    """What every estimation of one data set shares."""

    model: MachineModel
    observed: Observations
    given: ErrorValues
    runs: tuple[MeasuredRun, ...]
    options: EstimationOptions
    degrees: Mapping[ErrorName, int] = field(default_factory=dict)  # of curves of higher orders than others

    def started(self, effects: EffectUnknowns) -> tuple[State, Sizes]:
        """Nothing estimated yet."""
        degree = self.options.degree or DEGREE
        layout = layout_of(
            self.model, self.observed, self.given, effects, degree, self.degrees, turns=self.options.prior
        )
        layout = giving_way(layout, self.runs)
        state = started(layout, self.runs, self.given, self.options.noise)
        return state, self.sizes(state)

    def of(self, observed: Observations) -> "Setting":
        """The same of readings whose set-ups are said otherwise."""
        return replace(self, observed=observed, runs=tuple(measured_runs(observed)))

    def sizes(self, state: State) -> Sizes:
        """Of the unknowns of a state."""
        return Sizes(state.layout, state.own_kinds, flat=not self.options.prior, ideal=self.options.ideal)
