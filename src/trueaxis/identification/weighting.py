"""What each reading counts: the noise of its instrument or run, given or from repeats, or the same for all."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.observations import Observations, pure_error
from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.measurement.instrument_kinds import ANGLE, INSTRUMENTS
from trueaxis.measurement.machine import FloatArray

Repeats = Literal["", "instrument", "run"]
LEAST_FREEDOM = 5  # of a noise from repeats: with fewer it is uncertain by a third and more


@dataclass(frozen=True, slots=True, kw_only=True)
class NoiseModel:
    """What is known of the noise beforehand.

    um: one value for every reading of a length; by_group: instrument or run -> value, runs before instruments
    (micrometres); repeated: instruments or runs whose repeated readings tell it; urad: one value for every reading of
    an angle (microradians, which at ARM are micrometres); repeats: from repeated readings, one value for each
    instrument or each run. With none of them all readings count the same and the residuals set the level.
    """

    um: float | None = None
    by_group: Mapping[str, float] = field(default_factory=dict)
    repeats: Repeats = ""
    urad: float | None = None
    repeated: frozenset[str] = frozenset()

    @property
    def names(self) -> list[str]:
        """Instruments and runs of which something is said."""
        return [*self.by_group, *sorted(self.repeated)]


@dataclass(frozen=True, slots=True)
class GroupNoise:
    """Noise of the readings of an instrument or run, um (urad of angles); freedom: degrees of freedom it is from, None:
    given.
    """

    group: str
    um: float
    freedom: int | None


@dataclass(frozen=True, slots=True, eq=False)
class Weighting:
    """roots: (n,), by what a reading is multiplied, 1 on average of the squares; sigma: standard deviation (mm) of a
    reading of weight 1, None where the residuals set it; origin: in words; groups: the noise of each.
    """

    roots: FloatArray
    sigma: float | None
    origin: str
    groups: tuple[GroupNoise, ...] = ()


def weighting(observed: Observations, model: NoiseModel) -> Weighting:
    """The weights of the readings. Raises InputError where a group is unknown, has no noise, or too few repeats."""
    size = observed.reading.size
    _refuse_units(observed, model)
    by_group = _by_group(observed, model)
    if by_group or model.repeated:
        return _weighted(observed, _given(observed, by_group, model.repeated), "given for each instrument or run")
    if model.repeats:
        return _weighted(observed, _repeated(observed, model.repeats), f"from repeats of each {model.repeats}")
    sigma = None if model.um is None else model.um * 1e-3
    return Weighting(np.ones(size), sigma, "" if sigma is None else "given")


def _by_group(observed: Observations, model: NoiseModel) -> Mapping[str, float]:
    """Of instruments and runs, where more than one value is stated, or angles are among the readings."""
    used = {observed.runs[index].instrument for index in np.unique(observed.run)}
    if ANGLE not in used or not (model.names or model.um is not None or model.urad is not None):
        return model.by_group
    of_lengths = {} if model.um is None else dict.fromkeys(sorted(used - {ANGLE}), model.um)
    of_angles = {} if model.urad is None else {ANGLE: model.urad}
    return {**of_lengths, **model.by_group, **of_angles}


def _refuse_units(observed: Observations, model: NoiseModel) -> None:
    """Angles are in microradians, whose option is another one."""
    angles = {ANGLE, *(run.id for run in observed.runs if run.instrument == ANGLE)}
    faults = Faults("--noise-um")
    for name in sorted(angles & set(model.by_group)):
        faults.add(name, "reads an angle", "--noise-urad S")
    if model.urad is not None and not any(
        observed.runs[index].instrument == ANGLE for index in np.unique(observed.run)
    ):
        faults.found.append(Fault("--noise-urad", "", "no run is of an angle instrument", "leave it out"))
    faults.raise_if_any()


def _weighted(observed: Observations, noise: Mapping[int, GroupNoise], origin: str) -> Weighting:
    sigma = np.array([noise[index].um if index in noise else np.nan for index in range(len(observed.runs))])
    each = sigma[observed.run] * 1e-3
    level = float(np.mean(each**-2.0) ** -0.5)
    groups = {group.group: group for group in noise.values()}
    return Weighting(level / each, level, origin, tuple(groups[name] for name in sorted(groups)))


def _given(observed: Observations, by_group: Mapping[str, float], repeated: frozenset[str]) -> dict[int, GroupNoise]:
    faults = Faults("--noise-um")
    ids = [run.id for run in observed.runs]
    for name in (*by_group, *sorted(repeated)):
        if name not in ids and name not in INSTRUMENTS:
            faults.add(name, "is neither an instrument nor a run", f"{', '.join(INSTRUMENTS)}, or {', '.join(ids)}")
    found: dict[int, GroupNoise] = {}
    silent: dict[str, list[str]] = {}
    by_repeats: dict[int, str] = {}
    for index in np.unique(observed.run).tolist():
        run = observed.runs[index]
        own = next((key for key in (run.id, run.instrument) if key in by_group or key in repeated), None)
        if own is None:
            silent.setdefault(run.instrument, []).append(run.id)
        elif own in repeated:
            by_repeats[index] = own
        else:
            found[index] = GroupNoise(own, by_group[own], None)
    for instrument, ids in silent.items():
        which = f'run "{ids[0]}"' if len(ids) == 1 else f'{len(ids)} runs of the {instrument}, "{ids[0]}" first'
        remedy = "--noise-urad S" if instrument == ANGLE else f"{instrument}=S, or {ids[0]}=S"
        faults.add("", f"says nothing of {which}", remedy)
    faults.raise_if_any()
    return found | (_of_repeats(observed, by_repeats) if by_repeats else {})


def _repeated(observed: Observations, by: Repeats) -> dict[int, GroupNoise]:
    present = np.unique(observed.run).tolist()
    names = {index: observed.runs[index].id if by == "run" else observed.runs[index].instrument for index in present}
    return _of_repeats(observed, names)


def _of_repeats(observed: Observations, names: Mapping[int, str]) -> dict[int, GroupNoise]:
    """Of the runs with a name, by index: one value for all of a name."""
    order = sorted(set(names.values()))
    of_run = np.array([order.index(names[i]) if i in names else -1 for i in range(len(observed.runs))], dtype=np.int64)
    mine = observed.of(np.flatnonzero(of_run[observed.run] >= 0))
    squares, freedom = pure_error(mine, of_run[mine.run], len(order))
    _refuse_few(observed, order, freedom, squares)
    um = np.sqrt(squares / freedom) * 1e3
    return {
        index: GroupNoise(name, float(um[order.index(name)]), int(freedom[order.index(name)]))
        for index, name in names.items()
    }


def _refuse_few(observed: Observations, order: list[str], freedom: IntArray, squares: FloatArray) -> None:
    found = []
    for name, free, total in zip(order, freedom.tolist(), squares.tolist(), strict=True):
        if free < LEAST_FREEDOM:
            problem = f"{name}: repeats leave {free} degrees of freedom for the noise"
            found.append(Fault(observed.source, "", problem, f"{LEAST_FREEDOM} or more, or --noise-um {name}=S"))
        elif total == 0.0:
            problem = f"{name}: repeated readings are all equal"
            found.append(Fault(observed.source, "", problem, "readings as they were taken, or --noise-um"))
    if found:
        raise InputError(found)
