"""A state with the sizes at which its noise and unknowns were estimated."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.estimation.evidence import evidence_at, posterior_at
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import State, linearised
from trueaxis.measurement.machine import FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Fitted:
    """x: (n_sizes,), the sizes, as the standard normal numbers that `sizes` takes."""

    state: State
    sizes: Sizes
    x: FloatArray

    def posterior(self) -> Posterior:
        """At these sizes."""
        return posterior_at(self.sizes, linearised(self.state), self.x)

    @property
    def scales(self) -> dict[int, float]:
        """Of the noise of each run, by its index; as in the state."""
        return {one.rows.index: scale for one, scale in zip(self.state.runs, self.state.scales.tolist(), strict=True)}


Refit = Callable[[Sequence[MeasuredRun]], Fitted]  # the estimate of runs, from the beginning
Continued = Callable[[Fitted, Sequence[MeasuredRun]], Fitted]  # the estimate of runs that goes on from another


def evidence_ratio(one: Fitted, other: Fitted) -> float:
    """Logarithm of how much likelier readings are by the other estimate: those that count in both."""
    before, after = counting_in_both(one.state, other.state)
    return evidence_at(other.sizes, linearised(after), other.x) - evidence_at(one.sizes, linearised(before), one.x)


def counting_in_both(one: State, other: State) -> tuple[State, State]:
    """The states of the same readings, of which those count that count in both."""
    count = 1 + max(int(run.rows.at.max()) for run in one.runs)
    good = np.zeros((2, count), dtype=bool)
    for row, state in enumerate((one, other)):
        for run in state.runs:
            good[row, run.rows.at] = run.good
    both = good[0] & good[1]
    of_one, of_other = (
        replace(state, runs=tuple(replace(run, good=both[run.rows.at]) for run in state.runs)) for state in (one, other)
    )
    return of_one, of_other
