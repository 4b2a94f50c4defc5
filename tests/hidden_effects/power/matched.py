"""The size at which an effect is as plain as one of other searched parameters at so many times its limit.

An effect of the library at m times its detection limit has a signature whose norm, in standard deviations of the
noise and with everything that smooth component errors, location errors and nuisance can imitate projected out, is
m sqrt(27). Effects of other periods or constants are scaled to the same norm, by a projection of the generator's own:
Chebyshev polynomials of degree 12 for each component error, sensitivities by finite differences, an offset and a slope
per run, the place of each plane's ball.
"""

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np
from scipy.linalg import qr

from tests.hidden_effects.case import Case, clean_readings
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from tests.hidden_effects.machine import Array, Machine
from tests.hidden_effects.machines import MACHINES
from tests.hidden_effects.readings import Truth, bar_directions, sensitivity
from tests.hidden_effects.schedule import plan_runs
from tests.hidden_effects.state import Plan

DEGREE = 12
AT_LIMIT = np.sqrt(27.0)
UNIT = 1e-4  # mm or rad, of the signature


def matched_size(case: Case, effect: Hidden, times: float) -> float:
    """The positive size at which the effect's signature has the norm of `times` a limit; infinite where it has none."""
    machine = MACHINES[case.machine]
    plan, without, basis = _base(case.machine, case.design)
    with_it = clean_readings(machine, plan, Truth({}, {}, (_sized(effect, UNIT),)))
    signature = (with_it - without) / (case.sigma_um * 1e-3)
    rest = signature - basis @ (basis.T @ signature)
    norm = float(np.linalg.norm(rest))
    return times * float(AT_LIMIT) * UNIT / norm if norm > 1e-6 * np.linalg.norm(signature) else np.inf


def _sized(effect: Hidden, size: float) -> Hidden:
    return replace(effect, size=size)


@cache
def _base(machine: str, design: Design) -> tuple[Plan, Array, Array]:
    """The plan of seed 0, its readings (n,) without any effect, mm, and an orthonormal basis of the base, (n, r)."""
    made = MACHINES[machine]
    plan = plan_runs(made, design, np.random.default_rng([0, 1]))
    columns = [*_components(made, plan), *_of_runs(plan), *bar_directions(made, plan)]
    columns += [np.where(_plane(plan, name), row, 0.0) for name in ("XY", "YZ", "ZX") for row in columns[-3:]]
    matrix = np.array(columns).T
    matrix = matrix / np.maximum(np.linalg.norm(matrix, axis=0), 1e-300)
    q, r, _ = qr(matrix, mode="economic", pivoting=True)
    rank = int(np.sum(np.abs(np.diag(r)) > 1e-9 * abs(r[0, 0])))
    return plan, clean_readings(made, plan, Truth({})), np.asarray(q[:, :rank], float)


def _components(machine: Machine, plan: Plan) -> Sequence[Array]:
    found = []
    for name in machine.components:
        rate = sensitivity(machine, plan, name)
        if np.any(rate):
            s = 2.0 * machine.share(name[2], plan.state.positions[name[2]]) - 1.0
            found += [rate * np.cos(k * np.arccos(np.clip(s, -1.0, 1.0))) for k in range(DEGREE + 1)]
    return found


def _of_runs(plan: Plan) -> Sequence[Array]:
    found = []
    for index, run in enumerate(plan.runs):
        mine = plan.state.run == index
        place = np.where(mine, plan.state.seq / max(1, int(np.sum(mine)) - 1) - 0.5, 0.0)
        found += [place] if run.length is not None else [mine.astype(float), place]
    return found


def _plane(plan: Plan, plane: str) -> Array:
    return np.isin(plan.state.run, [index for index, run in enumerate(plan.runs) if run.plane == plane]).astype(float)
