"""A state with the sizes at which its noise and unknowns were estimated."""

from dataclasses import dataclass

from trueaxis.estimation.evidence import posterior_at
from trueaxis.estimation.posterior import Posterior
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
