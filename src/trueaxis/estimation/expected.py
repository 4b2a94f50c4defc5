"""What readings will say before any is taken: the posterior covariance of a plan, and the rows of single runs.

The covariance of a linear mixed model holds no reading, only the derivative, the noise and the sizes of the prior; so
readings of a machine without errors have it, too.
"""

from collections.abc import Mapping

import numpy as np

from trueaxis.estimation.effects.unknowns import EffectUnknowns
from trueaxis.estimation.evidence import posterior_at
from trueaxis.estimation.giving_way import giving_way
from trueaxis.estimation.instruments import CLASSES, own_kinds
from trueaxis.estimation.jacobian import RunRows, pieces
from trueaxis.estimation.layout import Layout, layout_of
from trueaxis.estimation.noise import Noise, Whitening
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.own_part import own_part
from trueaxis.estimation.posterior import Posterior, parted_root
from trueaxis.estimation.reduce import reduced
from trueaxis.estimation.result import Estimate, InstrumentNoise, Iteration, ReadingsLeft
from trueaxis.estimation.runs import measured_runs, noise_groups
from trueaxis.estimation.sizes import Sizes
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel

UNIT = Noise(1.0)  # white; the standard deviation of each run, mm, is its scale
NEGLIGIBLE = 1e-3  # variance of a combination of readings over that of its noise: it lowers no variance by more


def expected_posterior(
    layout: Layout, observed: Observations, noise: Mapping[int, float]
) -> tuple[Posterior, Mapping[str, float]]:
    """The posterior before any reading, at the sizes of [prior] and of the instruments, and these by their class.

    observed: what they read is not looked at; noise: standard deviation of the readings of every run, by index, mm.
    """
    rows = [one.rows for one in measured_runs(observed)]
    whitenings = [Whitening(UNIT, one.steps, noise[one.index]) for one in rows]
    found = reduced(layout, rows, whitenings, [np.zeros(one.at.size) for one in rows])
    sizes = Sizes(layout, [own_kinds(one.run, layout.straightness[one.index]) for one in rows])
    start = np.zeros(sizes.spread.size)
    return posterior_at(sizes, found, start), sizes.factors(start)


def expected(
    model: MachineModel,
    observed: Observations,
    given: ErrorValues,
    noise: Mapping[int, float],
    effects: EffectUnknowns | None = None,
) -> Estimate:
    """The estimate from readings of a machine without errors: its spread is what a plan lets expect.

    observed, noise: see `expected_posterior`; given: errors that are no unknowns; effects: those that are unknowns, at
    the values at which they are linearised; None: none.
    """
    layout = layout_of(model.with_values(given), observed, given, effects)
    layout = giving_way(layout, measured_runs(observed))
    layout = layout.at(layout.start(), given)
    posterior, factors = expected_posterior(layout, observed, noise)
    spread, of_prior = parted_root([posterior], posterior.mean, layout.of_machine)
    unknowns, readings = layout.start(), observed.reading.size
    groups = noise_groups(observed.runs)
    stated = frozenset(groups[index] for index in noise)
    return Estimate(
        layout=layout,
        values=layout.values(unknowns, given),
        unknowns=unknowns,
        spread=spread * layout.sizes[:, np.newaxis],
        of_prior=of_prior,
        open=np.zeros((layout.count, 0)),
        scale=posterior.scale * layout.sizes,
        factors=factors,
        noise=InstrumentNoise(of_group=dict.fromkeys(sorted(stated), UNIT), scale_of_run=dict(noise), stated=stated),
        readings=ReadingsLeft(
            residual=np.zeros(readings),
            outliers=np.zeros(readings, dtype=bool),
            misread={},
            contradicting=(),
            freedom=readings - posterior.told,
        ),
        iteration=Iteration(rounds=0, steps=0, last_step=0.0, last_change=0.0, converged=True),
    )


def informing_rows(layout: Layout, rows: RunRows, noise: float, scale: FloatArray) -> FloatArray:
    """(m, n): what one run adds to the information, noise of 1, by unknowns in units of their prior sizes, scale (n,).

    The unknowns of the run alone are integrated out; combinations of readings that tell nothing are left out. noise:
    standard deviation of its readings, mm.
    """
    parts = [(own, others) for _, own, others in pieces(layout, rows)]
    own, others = (np.vstack(columns) / noise for columns in zip(*parts, strict=True))
    sizes = np.array([CLASSES[kind].size for kind in own_kinds(rows.run, layout.straightness[rows.index])])
    found = own_part(own * sizes).root(others * (scale / layout.sizes))
    variance, vectors = np.linalg.eigh(found @ found.T)
    return np.asarray(vectors[:, variance > NEGLIGIBLE].T @ found)
