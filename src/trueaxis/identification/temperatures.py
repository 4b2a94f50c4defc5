"""Readings taken at other temperatures, where nothing in the model depends on temperature."""

import numpy as np

from trueaxis.effects.placement import used_variables
from trueaxis.estimation.observations import Observations
from trueaxis.model.model import MachineModel

# K between the coldest and the warmest run, from where on it is said: a metre of steel grows by 11 um for each, what
# the scales of a machine err by in all
WARMER = 1.0


def temperature_notes(model: MachineModel, observed: Observations) -> tuple[str, ...]:
    """How far apart the runs are, by the mean of their readings that have a temperature."""
    uses = {name for effect in model.effects for name in used_variables(model.kinds[effect.kind])}
    if observed.context is None or "T" in uses:
        return ()
    means: dict[str, float] = {}
    for index, run in enumerate(observed.runs):
        known = observed.context.temperature[observed.run == index]
        known = known[np.isfinite(known)]
        means |= {run.id: float(known.mean())} if known.size else {}
    if not means:
        return ()
    coldest, warmest = min(means, key=lambda one: means[one]), max(means, key=lambda one: means[one])
    if means[warmest] - means[coldest] < WARMER:
        return ()
    return (
        f"the runs were taken at {means[coldest]:.1f} degC ({coldest}) to {means[warmest]:.1f} degC ({warmest}), and "
        "nothing in the model depends on temperature: what grows with it, a metre of steel by 11 um for each K, counts "
        "as error or as noise (diagnose tells more; the effect thermal_expansion in the spec takes it up)",
    )
