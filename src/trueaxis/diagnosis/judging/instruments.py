"""Instruments that are off by more than instruments are: zeros, slopes, places of balls, lengths of bars, scales.

They are free beside the machine, and no cause in the machine can be mistaken for one of them. But one that is many
times what its device's table states, or else what its class is known to be and the others of its class are, is a cause,
of the instrument. Of one that stands alone, with nothing stated, nothing is said: its size may be any.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.special import ndtr

from trueaxis.diagnosis.judging.off import Off
from trueaxis.diagnosis.null_model.base import LARGEST, WIDE, Base
from trueaxis.diagnosis.null_model.by_run import ByRun
from trueaxis.diagnosis.null_model.noise_fit import NOISIEST
from trueaxis.diagnosis.null_model.null import Null, balls_anywhere, expected_root, factored, log_likelihood
from trueaxis.diagnosis.null_model.whiten import RANK
from trueaxis.diagnosis.result import FloatArray, IntArray
from trueaxis.effects.kind import Effect
from trueaxis.estimation.instruments import CLASSES, STATED_FACTOR
from trueaxis.measurement.setup import Run

FALSE_ALARMS = 1e-4  # share of data with instruments as usual in which one or other is taken for a cause
KINDS = {  # class of an unknown -> the kind of effect that it is when it is off
    "laser zero": "reading_zero",
    "probe zero": "reading_zero",
    "straightness zero": "reading_zero",
    "ballbar zero": "reading_zero",
    "straightness slope": "reading_slope",
    "ballbar centre of a run": "ballbar_centre",
    "ballbar length": "ballbar_length",
    "laser scale": "laser_scale",
    "stated scale": "laser_scale",
}
NOT_OF_THE_MACHINE = frozenset({"reading_zero", "reading_slope"})  # kinds that no machine is extended by
OF_ALL_RUNS = frozenset({"ballbar_length", "laser_scale"})  # kinds without runs of their own
WHOLE = {  # an unknown of a run that holds what runs share besides -> the class of that
    "ballbar centre of a run": "ballbar centre",
    "ballbar zero": "ballbar length",
    "probe zero": "probe origin",
}
WIDER = (WIDE, 16.0, 64.0, LARGEST)  # and by these where readings say so
SIZES = np.linspace(-4.0, 4.0, 161)  # of a class about its own, in logarithms of its factor
USUAL = 3.0  # median sizes of a class by which runs of one set-up may differ
MOST = 4  # instruments that are named
TOLD = 1e-3  # of what is expected of an unknown: information below it is none


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _Unknown:
    """As the readings have it. of: what it shares with the other coordinates of a point; runs: by their places in the
    base; size, factor: one standard deviation before, and by what that may be wrong; caused: by how much it may be off
    by what causes do at home, which readings do not tell; column: (n,), mm per unit; squares: what all coordinates
    explain, whitened.
    """

    kind: str
    of: object
    runs: tuple[int, ...]
    size: float
    factor: float
    value: float
    u: float
    caused: float = 0.0
    column: FloatArray
    squares: float


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _OfRun:
    """Of a run, by its place in the base: unknowns of one class; at: (k,), which of its own; value, u: (k,); squares:
    what they explain.
    """

    place: int
    at: IntArray
    value: FloatArray
    u: FloatArray
    squares: float


def instruments_off(null: Null, signal: FloatArray) -> tuple[Off, ...]:
    """Those that are, most evident first, each beside those before. signal: (n,), mm, what causes in the machine do to
    the readings: a zero may be off by as much, as a form may be wrong at home, where a run is zeroed.

    Where a machine whose errors are larger than [prior] has it is likelier than one whose instruments are off, it is
    taken for one: of instruments that what is expected of the machine alone speaks against nothing is known.
    """
    null = balls_anywhere(null)
    columns = null.base.columns.beside(null.base.by_chance)
    values = null.values - signal
    q, r, length = factored(null.whitening, columns)
    best, most = tuple[Off, ...](), -np.inf
    for wide in WIDER:
        deviation = np.concatenate([null.base.wide(wide), np.ones(null.base.by_chance.shape[1])])
        sized = r * (deviation * length)
        root = deviation[:, np.newaxis] * expected_root(sized)
        root[np.linalg.norm(r, axis=0) <= RANK] = 0.0  # what the unknowns of single runs hold
        found, left = _beside(null, columns, q, root, values, signal)
        likely = log_likelihood(q, sized, null.whitening(left)) + len(found) * np.log(FALSE_ALARMS)
        if likely > most:
            best, most = found, likely
        if not found:
            break
    return best


def _beside(
    null: Null, columns: ByRun, q: ByRun, root: FloatArray, values: FloatArray, signal: FloatArray
) -> tuple[tuple[Off, ...], FloatArray]:
    """Instruments that are off by what is expected of the machine, and (n,), mm: what they leave of the values."""
    left, found = values, dict[tuple[str, object], Off]()
    homes = [one.instrument != "ballbar" for one in null.base.runs]  # a ball bar is zeroed at its own length
    caused = [home * np.abs(signal[one.rows.at]).max() for home, one in zip(homes, null.base.runs, strict=True)]
    while len(found) < MOST:
        inside = q.transposed(null.whitening(left))
        coefficient = root[:, : inside.size] @ inside
        every = [*_shared(null.base, columns, coefficient, root), *_own(null, left, columns, coefficient, root)]
        every = [
            replace(one, caused=max(caused[place] for place in one.runs)) if CLASSES[one.kind].zero else one
            for one in every
            if (one.kind, one.of) not in found
        ]
        chances = [_chance(one, [o for o in every if o.kind == one.kind and o.of != one.of]) for one in every]
        sure = [one for one, chance in zip(every, chances, strict=True) if chance * len(every) < FALSE_ALARMS]
        if not sure:
            break
        best = max(sure, key=lambda one: one.squares)  # what one has that is off others of its run seem to have
        of_point = [one for one in every if (one.kind, one.of) == (best.kind, best.of)]
        p_value = min(chance for one, chance in zip(every, chances, strict=True) if one in of_point) * len(every)
        off = _off(null, of_point, p_value)
        found[best.kind, best.of] = off
        left = left - off.signal
    return tuple(found.values()), left


def _chance(one: _Unknown, others: Sequence[_Unknown]) -> float:
    """Probability that an unknown is so far off, the size of its class being what is stated or known, and what the
    others say of it.
    """
    size = one.size * one.factor**SIZES
    weight = -0.5 * SIZES**2
    for other in others:
        spread = np.sqrt((size * other.size / one.size) ** 2 + other.u**2 + other.caused**2)
        weight -= 0.5 * (other.value / spread) ** 2 + np.log(spread)
    weight = np.exp(weight - weight.max())
    spread = np.sqrt(size**2 + one.u**2 + one.caused**2)
    return float(2.0 * ndtr(-abs(one.value) / spread) @ weight / weight.sum())


def _shared(base: Base, columns: ByRun, coefficient: FloatArray, root: FloatArray) -> Iterator[_Unknown]:
    """Unknowns that runs share, what is expected of each itself taken off again."""
    place = {run.rows.index: number for number, run in enumerate(base.runs)}
    for k, unknown in enumerate(base.shared, start=base.of_machine):
        variance = float(root[k] @ root[k])
        information = 1.0 / variance - 1.0 if variance > 0.0 else 0.0
        size = unknown.size
        if unknown.kind not in KINDS or information < TOLD:
            continue
        value, u = float(coefficient[k]) / variance / information, information**-0.5
        runs = tuple(place[index] for index in unknown.runs if index in place)
        factor = unknown.unknown_class.factor
        yield _Unknown(
            kind=unknown.kind,
            of=k,
            runs=runs,
            size=size,
            factor=factor,
            value=value * size,
            u=u * size,
            column=columns.take(np.array([k])).dense()[:, 0] / size,
            squares=(value / u) ** 2,
        )


def _own(null: Null, left: FloatArray, columns: ByRun, coefficient: FloatArray, root: FloatArray) -> Iterator[_Unknown]:
    """Unknowns of single runs, those of one set-up together where they agree; of a ball also what its runs share.

    Not those of a run that is noisier than runs are: it disagrees with itself, and no one value says why.
    """
    rest = left - columns @ coefficient
    by_kind: dict[str, list[_OfRun]] = {}
    noisy = np.zeros(len(null.base.runs), bool) if null.found is None else np.log(null.found.scales) > NOISIEST
    inside = np.split(columns.weights @ root, columns.ends[1:-1])
    members_of = zip(null.base.runs, null.base.own, null.whitening.runs, columns.few, inside, strict=True)
    for place, (run, own, noise, few, part) in enumerate(members_of):
        if noisy[place]:
            continue
        kinds, k = np.array(null.base.own_kinds[place]), own.shape[1]
        size = np.array([_expected_of(run.rows.run, kind)[0] for kind in kinds])
        white = noise.whitened(np.column_stack([own * size, rest[run.rows.at], few]))
        information, asked = _told(white[:, :k], white[:, k], white[:, k + 1 :] @ part)
        for kind in dict.fromkeys(kinds[np.isin(kinds, list(KINDS))].tolist()):
            at = np.flatnonzero(kinds == kind)
            value, u, squares = _of_class(information, asked, at)
            by_kind.setdefault(kind, []).append(
                _OfRun(place=place, at=at, value=value * size[at], u=u * size[at], squares=squares)
            )
    for kind, members in by_kind.items():
        yield from _together(null, kind, members)


def _told(own: FloatArray, rest: FloatArray, besides: FloatArray) -> tuple[FloatArray, FloatArray]:
    """(k, k) and (k,): information of whitened readings of a run on its own unknowns, and that times their values.

    own: (n, k), per standard deviation expected; besides: (n, m), root of the covariance of all else that was fitted.
    """
    left, strength, turned = np.linalg.svd(own, full_matrices=False)
    kept = strength > TOLD
    inverse = left[:, kept].T / strength[kept, np.newaxis]
    through = inverse @ besides
    asked = turned[kept].T @ np.linalg.inv(np.diag(strength[kept] ** -2.0) + through @ through.T)
    return asked @ turned[kept], asked @ (inverse @ rest)


def _of_class(information: FloatArray, asked: FloatArray, at: IntArray) -> tuple[FloatArray, FloatArray, float]:
    """(m,) each: values of some unknowns, per standard deviation expected, and their u, the others as expected; the
    whitened squares that they explain.
    """
    others = np.setdiff1d(np.arange(asked.size), at)
    inner = information[np.ix_(others, others)] + np.eye(others.size)
    through = np.linalg.solve(inner, information[np.ix_(others, at)]).T
    own = information[np.ix_(at, at)] - through @ information[np.ix_(others, at)] + TOLD * np.eye(at.size)
    covariance = np.linalg.inv(own)
    left = asked[at] - through @ asked[others]
    value = covariance @ left
    return value, np.sqrt(np.diag(covariance)), float(value @ left)


def _together(null: Null, kind: str, members: Sequence[_OfRun]) -> Iterator[_Unknown]:
    """Runs by one bar, or else by it in a session, or of one set-up and session, that agree are one; where they do not,
    each is by itself.
    """
    differ = USUAL * float(np.median(np.abs(np.concatenate([one.value for one in members]))))
    runs = {one.place: null.base.runs[one.place].rows for one in members}
    setup = {place: int(null.rows.mounted[run.at[0]]) for place, run in runs.items()}
    of_bar = {place: (run.run.device, run.run.length) for place, run in runs.items()}
    in_session = {place: (run.run.session, *of_bar[place]) for place, run in runs.items()}
    left = list(members)
    for key in (of_bar, in_session, setup) if kind == "ballbar zero" else (setup,):
        groups: dict[object, list[_OfRun]] = {}
        for one in left:
            groups.setdefault(key[one.place], []).append(one)
        for group in groups.values():
            value, u = np.array([one.value for one in group]), np.array([one.u for one in group])
            weight = 1.0 / u**2
            mean = np.sum(value * weight, axis=0) / weight.sum(axis=0)
            expected = _expected_of(runs[group[0].place].run, kind)
            if (np.abs(value - mean) <= min(expected[0], differ) + 3.0 * u).all():
                name = "ballbar length" if len({setup[one.place] for one in group}) > 1 else kind
                expected = _expected_of(runs[group[0].place].run, kind, len(group))
                yield from _unknowns(null, name, expected, group, mean, weight.sum(axis=0) ** -0.5)
                left = [one for one in left if one not in group]
    for one in left:
        yield from _unknowns(null, kind, _expected_of(runs[one.place].run, kind), [one], one.value, one.u)


def _expected_of(run: Run, kind: str, together: int = 1) -> tuple[float, float]:
    """Of an unknown of a run, one standard deviation, and by what it may be wrong: as its device's table states, else
    as its class is. together: how many runs it is the mean of, of which each was zeroed.
    """
    known = CLASSES[WHOLE.get(kind, kind)]
    if kind == "ballbar zero" and run.device is not None and run.device.length_u is not None:
        return float(np.hypot(run.device.length_u, CLASSES[kind].size / np.sqrt(together))), STATED_FACTOR
    return known.size, known.factor


def _unknowns(
    null: Null, kind: str, expected: tuple[float, float], group: Sequence[_OfRun], value: FloatArray, u: FloatArray
) -> Iterator[_Unknown]:
    runs = tuple(one.place for one in group)
    for k in range(value.size):
        column = np.zeros(null.rows.size)
        for one in group:
            column[null.base.runs[one.place].rows.at] = null.base.own[one.place][:, one.at[k]]
        size, factor = expected
        yield _Unknown(
            kind=kind, of=runs, runs=runs, size=size, factor=factor, value=float(value[k]), u=float(u[k]),
            column=column,
            squares=sum(one.squares for one in group),
        )  # fmt: skip


def _off(null: Null, point: Sequence[_Unknown], p_value: float) -> Off:
    kind = KINDS[point[0].kind]
    runs = () if kind in OF_ALL_RUNS else tuple(null.base.runs[place].rows.run.id for place in point[0].runs)
    values, u = np.array([(one.value, one.u) for one in point]).T
    signal = np.sum([one.value * one.column for one in point], axis=0)
    return Off(effect=Effect(kind=kind, runs=runs), values=values, u=u, p_value=p_value, signal=signal)
