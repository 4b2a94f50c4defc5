"""Probes whose length is far from what setup.toml states, in the eyes of all readings.

While rotary axes carry a probe, its length looks like errors of these axes: of a head that swivels, a stylus that is
1 mm longer is a circle of 1 mm. By a length that is stated to 10 um the errors take it up, however large they have to
be.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.fitted import Fitted, evidence_ratio
from trueaxis.estimation.instruments import STYLUSES
from trueaxis.estimation.misread import SUSPICIOUS
from trueaxis.estimation.rounds import CONTINUED_ROUNDS, MOST_ROUNDS, settled
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.estimation.setting import Setting
from trueaxis.machine.machine import ROTARY

TYPED = 10.0  # mm, one standard deviation of a length that is a wrong number: of another stylus, or mistyped
FARTHER = 2.0  # standard uncertainties, as 95 % ask, by which another length is not the one that is known


@dataclass(frozen=True, slots=True, kw_only=True)
class DoubtedLength:
    """runs: of the probe, by index; longer, u: by how much it is longer than setup.toml has it, and its standard
    uncertainty, mm, where it may be a wrong number; known: to what it was taken as known, mm, as its device's table
    states it or as usual; log_odds: logarithm of how much likelier the readings are by a wrong number.
    """

    runs: tuple[int, ...]
    longer: float
    u: float
    known: float
    log_odds: float


def doubted_lengths(setting: Setting, fitted: Fitted) -> tuple[DoubtedLength, ...]:
    """Of an estimate with a prior; without one the readings alone tell the errors. Costs an estimate."""
    layout = fitted.state.layout
    turned = {one.rows.index for one in fitted.state.runs if _turns(layout.model.axes, one)}
    lengths = [k for k, one in enumerate(layout.shared) if one.kind in STYLUSES and not turned.isdisjoint(one.runs)]
    if not lengths or fitted.sizes.flat:
        return ()
    runs = {index for place in lengths for index in layout.shared[place].runs}
    begun, sizes = setting.of(setting.observed.of_unknown_length(runs, TYPED)).started(layout.effects)
    x, state, _ = settled(begun, sizes, MOST_ROUNDS, sizes.taken(fitted.sizes, fitted.x), CONTINUED_ROUNDS)
    so = Fitted(state=state, sizes=sizes, x=x)
    odds = evidence_ratio(fitted, so)
    if odds <= SUSPICIOUS:
        return ()
    before, after = fitted.state.unknowns[layout.of_shared], state.unknowns[state.layout.of_shared]
    u = (np.linalg.norm(so.posterior().spread, axis=1) * state.layout.sizes)[state.layout.of_shared]
    places = {one.runs: place for place, one in enumerate(state.layout.shared) if one.kind in STYLUSES}
    found = []
    for place in lengths:
        one, other = layout.shared[place], places[layout.shared[place].runs]
        if abs(after[other] - before[place]) > FARTHER * one.size:
            longer, its_u = float(after[other]), float(u[other])
            found.append(DoubtedLength(runs=one.runs, longer=longer, u=its_u, known=one.size, log_odds=odds))
    return tuple(found)


def _turns(axes: Sequence[str], run: MeasuredRun) -> bool:
    """Whether a rotary axis does; else a length is a part of the zero."""
    rotary = [axis in ROTARY for axis in axes]
    return bool(np.ptp(run.rows.positions[rotary], axis=1).any())
