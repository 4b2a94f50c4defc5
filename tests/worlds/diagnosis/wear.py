"""A machine that changed after its values were identified: which component, and by how much beyond noise."""

from dataclasses import dataclass, replace

import numpy as np

from tests.worlds.diagnosis.limits import Ground
from tests.worlds.machine import LINEAR
from tests.worlds.stale import Change, growth
from tests.worlds.stale import wear as spot
from tests.worlds.truth import Truth

TRIES = 10
WEAR_SIGMA = (5.0, 8.0, 15.0, 40.0)  # by how much the sum of squares of stale values is beyond that of noise, in sigma
WEAR_LARGEST = {"um": 0.05, "urad": 2e-4}  # mm, rad


@dataclass(frozen=True)
class Wear:
    """What changed after the given values were true: form: bump or whole; size: largest change, mm or rad; sigma: by
    how much it is beyond noise; beyond: lambda of what curves of degree 12 cannot follow.
    """

    component: str
    form: str
    size: float
    sigma: float
    beyond: float


def draw_wear(source: np.random.Generator, ground: Ground, truth: Truth, seed: int) -> Wear:
    """A component that changed, by so much that readings show it."""
    design, jac = ground.design, ground.design.jacobian
    form = str(source.choice(["bump", "whole"]))
    sigma = float(source.choice(WEAR_SIGMA))
    wear = Wear("", form, 0.0, 0.0, 0.0)
    for _ in range(TRIES):
        component = str(source.choice(design.machine.components))
        most = WEAR_LARGEST["um" if component[1] in LINEAR else "urad"]
        change = change_of(truth, replace(wear, component=component, size=most), seed)
        axis = component[2]
        shown = jac.here[component] * change(jac.at[axis]) - jac.home[component] * change(jac.at_home[axis])
        white = ground.white(shown)
        seen = white - ground.instruments @ (ground.instruments.T @ white)
        rest = ground.rest(white)
        squares, freedom = float(np.sum(seen**2) - np.sum(rest**2)), ground.q.shape[1] - ground.instruments.shape[1]
        if squares <= 1e-6 * float(np.sum(white**2)):
            continue
        share = min(1.0, float(np.sqrt(sigma * np.sqrt(2.0 * freedom) / squares)))
        reached = share**2 * squares / np.sqrt(2.0 * freedom)
        wear = Wear(component, form, share * most, reached, share**2 * float(np.sum(rest**2)))
        if share < 1.0:
            break
    return wear


def change_of(truth: Truth, wear: Wear, seed: int) -> Change:
    """How the component changed: positions -> mm or rad; seed: of the case."""
    if wear.form == "whole":
        return growth(truth, wear.component, wear.size)
    return spot(truth, wear.component, wear.size, seed)
