"""Probes whose length is far from what setup.toml states, in the eyes of all readings.

While rotary axes carry a probe, its length looks like errors of these axes: of a head that swivels, a stylus that is
1 mm longer is a circle of 1 mm. By a length that is stated to 10 um the errors take it up, however large they have to
be.
"""

from dataclasses import dataclass, replace

import numpy as np

from trueaxis.estimation.fitted import Fitted, evidence_ratio
from trueaxis.estimation.instruments import PROBE_LENGTH, STATED_STYLUS
from trueaxis.estimation.misread import SUSPICIOUS
from trueaxis.estimation.rounds import CONTINUED_ROUNDS, MOST_ROUNDS, settled
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.setting import Setting

FARTHER = 2.0  # times its stated standard uncertainty, as 95 % ask, is what is no longer the length that is stated


@dataclass(frozen=True, slots=True, kw_only=True)
class DoubtedLength:
    """runs: of the probe, by index; longer, u: by how much it is longer than setup.toml has it, and its standard
    uncertainty, mm, where nothing states how well it is known; stated: its stated standard uncertainty, mm; log_odds:
    logarithm of how much likelier the readings are then.
    """

    runs: tuple[int, ...]
    longer: float
    u: float
    stated: float
    log_odds: float


def doubted_lengths(setting: Setting, fitted: Fitted) -> tuple[DoubtedLength, ...]:
    """Of an estimate with a prior; without one the readings alone tell the errors. Costs an estimate."""
    stated = [one for one in fitted.state.layout.shared if one.kind == STATED_STYLUS]
    if not stated or fitted.sizes.flat:
        return ()
    observed = setting.observed.unstated({index for one in stated for index in one.runs})
    there = replace(setting, observed=observed, runs=tuple(measured_runs(observed)))
    begun, sizes = there.started(fitted.state.layout.effects)
    near = sizes.taken(fitted.sizes, fitted.x)
    x, state, _ = settled(begun, sizes, MOST_ROUNDS, near, CONTINUED_ROUNDS)
    so = Fitted(state=state, sizes=sizes, x=x)
    odds = evidence_ratio(fitted, so)
    if odds <= SUSPICIOUS:
        return ()
    layout, posterior = state.layout, so.posterior()
    u = np.linalg.norm(posterior.spread, axis=1) * layout.sizes
    known = {one.runs: one.size for one in stated}
    found = [
        DoubtedLength(
            runs=one.runs,
            longer=float(state.unknowns[layout.of_shared][place]),
            u=float(u[layout.of_shared][place]),
            stated=known[one.runs],
            log_odds=odds,
        )
        for place, one in enumerate(layout.shared)
        if one.kind == PROBE_LENGTH and one.runs in known
    ]
    return tuple(one for one in found if abs(one.longer) > FARTHER * one.stated)
