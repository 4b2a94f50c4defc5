"""Two runs whose readings are likelier in each other's place."""

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from trueaxis.estimation.changed import changes_of_run, log_ratio
from trueaxis.estimation.fitted import Fitted
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.runs import MeasuredRun

# Runs of as many readings of an instrument that are compared, those that fit worst: time grows with their square
MOST_ALIKE = 60


@dataclass(frozen=True, slots=True)
class Swap:
    """Two runs by their places; among: the number of runs whose readings one of them could have, of which one at most
    is right.
    """

    places: tuple[int, int]
    among: int


def swap_ratios(fitted: Fitted, posterior: Posterior) -> dict[Swap, float]:
    """Of every two runs that could have each other's readings: logarithm of how much likelier they are swapped, by the
    noise and sizes of the state. posterior: of what is fitted. None without a prior: errors that are held at zero then
    make readings likelier in the wrong place.
    """
    runs = fitted.state.runs
    found: dict[Swap, float] = {}
    for members in () if fitted.sizes.flat else _alike(fitted):
        pairs = [pair for pair in combinations(members, 2) if _differ(*(runs[one] for one in pair))]
        partners = np.bincount(np.ravel(pairs), minlength=len(runs)) if pairs else np.zeros(0)
        changed = {
            one: changes_of_run(fitted, posterior, one, [runs[other].reading - runs[one].reading for other in members])
            for one in sorted({one for pair in pairs for one in pair})
        }
        for a, b in pairs:
            each = [(changed[one], members.index(other)) for one, other in ((a, b), (b, a))]
            found[Swap((a, b), int(partners[[a, b]].max()))] = log_ratio(each)
    return found


def _alike(fitted: Fitted) -> list[list[int]]:
    """Places of runs of a device with as many readings; of very many those that fit worst."""
    state = fitted.state
    members: dict[tuple[str, int], list[int]] = {}
    for place, one in enumerate(state.runs):
        members.setdefault((one.noise_group, one.reading.size), []).append(place)
    misfit = [float(np.mean(np.square(rest))) / float(scale) ** 2
              for rest, scale in zip(state.residual, state.scales, strict=True)]  # fmt: skip
    return [
        sorted(sorted(places, key=lambda place: -misfit[place])[:MOST_ALIKE])
        for places in members.values()
        if len(places) > 1
    ]


def _differ(one: MeasuredRun, other: MeasuredRun) -> bool:
    """Whether it makes a difference which readings are whose: repeats of a run may be taken for each other."""
    a, b = one.rows.run, other.rows.run
    set_ups = [(run.direction, run.target, run.reference, run.frame, dict(run.home), run.length) for run in (a, b)]
    return set_ups[0] != set_ups[1] or not np.array_equal(one.rows.positions, other.rows.positions)
