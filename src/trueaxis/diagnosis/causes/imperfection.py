"""By how much a real effect may differ from the form of its kind, as chance beside the noise.

No play is the same all along a screw, no structure follows the thermometer at once, no periodic error is a pure
cosine. Where an effect is large, such differences are larger than the noise: taken for structure they would bring
further names, all false, or take the right one back. So each cause, once found, adds what its own form may lack to
the covariance of the readings, with the standard deviations below as shares of the effect. What of that these readings
cannot tell from the effect itself says nothing against its being there, only of how large it is.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.polynomial import legendre

from trueaxis.diagnosis.causes.search import Ground
from trueaxis.diagnosis.causes.signature import Fitted, Memory, Readings
from trueaxis.diagnosis.causes.signatures import parameter_signature
from trueaxis.diagnosis.null_model.projection import Projection, orthonormal
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.null_model.temperature import warmer
from trueaxis.diagnosis.result import BoolArray, FloatArray
from trueaxis.effects.expression import names, parse
from trueaxis.effects.placement import SINCE_REVERSAL, VARIABLES
from trueaxis.model.context import Context

MODULATED = 0.1  # along the travel, in time, with the speed, from one instrument to another
UNREAD = 1.0  # from one instrument to another, of what decays from a reversal: where a line turns is not read
FLANK = 1.0  # of what turns with the direction, right after a reversal
# over which it is taken up: ways of screw, nut and friction, mm; times of position loops of 1 and 4 m/min per mm, s
TAKEN_UP = {"d": (0.3, 1.0), "d_path": (0.3, 1.0), "d_time": (0.015, 0.06)}
LAG = 3**-0.5, (250.0, 1000.0, 4000.0)  # of what follows the temperature; by one of these time constants, s
HARMONIC = 0.2  # second harmonic of what is periodic
OPEN = 2.0  # standard uncertainties of a pitch, within which it is, in 95 % of cases
PEAK = 0.5  # periods over the range of the axis: half the width of a peak, beyond which another begins
OTHERWISE = 0.3, 1.6  # of what decays, with its constant so many times larger or smaller
SAMPLES = 500  # of the course of the temperature


@dataclass(frozen=True, slots=True, eq=False)
class Imperfection:
    """columns: (n, k), as `seen`, what the causes may do besides, each one standard deviation; beside: (n, k), of them
    what no change of the causes' sizes would do.
    """

    columns: FloatArray
    beside: FloatArray


def imperfection(
    readings: Readings, causes: Sequence[Fitted], seen: Callable[[FloatArray], FloatArray]
) -> Imperfection:
    """seen: what of columns (n, k), mm, the base leaves, whitened."""
    columns, beside = ([np.zeros((readings.rows.size, 0))] for _ in range(2))
    for one in causes:
        besides = list(imperfections(readings, one))
        if besides:
            columns.append(seen(np.stack(besides, axis=1)))
            _, derivatives = parameter_signature(readings, one.effect, one.values)
            form = orthonormal(seen(derivatives[:, [each.role != "grid" for each in one.kind.parameters]]))
            beside.append(columns[-1] - form @ (form.T @ columns[-1]))
    return Imperfection(np.hstack(columns), np.hstack(beside))


def beside_forms(ground: Ground, causes: Sequence[Fitted]) -> Ground:
    """The same search, with what the forms of these causes may lack as further chance in the readings."""
    bare = Projection(ground.plain.basis)
    chance = imperfection(ground.readings, causes, lambda columns: bare.rest(ground.whitening(columns)))
    return replace(
        ground,
        base=bare.softened(np.hstack([ground.plain.by_chance, chance.beside])),
        wide=bare.softened(np.hstack([ground.plain.by_chance, chance.columns])),
        known={},
    )


def imperfections(readings: Readings, cause: Fitted) -> Iterator[FloatArray]:
    """(n,), mm, each: what a cause may do besides, one standard deviation."""
    rows, signal = readings.rows, cause.signal
    used = {each.name for each in names(parse(cause.kind.expression))} if cause.kind.expression else set()
    scales = []
    # what time or temperature alone drive would be of another kind if it varied along the travel
    if used & VARIABLES.keys() - {"t", "T"}:
        scales += [rows.positions[rows.axes.index(axis)] for axis in _axes(cause) if axis in rows.axes]
    if rows.time is not None and np.isfinite(rows.time).all():
        scales.append(rows.time)
    if "v" in used:
        scales.append(np.linalg.norm(np.nan_to_num(readings.context.velocity), axis=0))
    for scale in scales:
        yield from (MODULATED * one for one in changing(signal, scale, scale))
    read_by = list(_read_by(rows))
    for mine in read_by:  # beside what all read together, which is the size of the cause
        share = float(signal[mine] @ signal[mine]) / (float(signal @ signal) or 1.0)
        yield (UNREAD if used & set(SINCE_REVERSAL) else MODULATED) * (mine - share) * signal
    if "direction" in used and cause.effect.component:
        counted = next((one for one in SINCE_REVERSAL if one in used), "d")
        since = readings.context.since(counted)[rows.axes.index(cause.effect.own_axis)]
        since = np.where(np.isnan(since), np.inf, since)  # of readings that the effect does not reach
        for way, mine in product(TAKEN_UP[counted], read_by):  # what circles show says nothing of where lines turn
            yield FLANK * np.where(mine, signal * np.exp(-since / way), 0.0)
    if "T" in used:
        yield from _of_temperature(readings, cause)
    if "theta" in used:
        twice = replace(readings.reading, theta=2.0 * readings.reading.theta)
        yield from _harmonic(replace(readings, reading=twice, memory=Memory()), cause, cause.values)
    elif (pitch := _pitch(cause)) is not None:
        yield from _harmonic(readings, cause, _with(cause.values, pitch, 0.5 * cause.values[pitch]))
    yield from _of_searched(readings, cause)


def changing(signal: FloatArray, scale: FloatArray, some: FloatArray) -> Iterator[FloatArray]:
    """(n,), mm, each: a signal, (n,), mm, whose size changes with a scale, (n,), by once itself over the range of some
    values of it: a slope and a bend (Legendre); nothing where these are one.
    """
    if some.size and np.ptp(some) > 0.0:
        along = 2.0 * (scale - some.min()) / np.ptp(some) - 1.0
        for degree in (1, 2):
            yield signal * legendre.legval(along, np.eye(3)[degree])


def _read_by(rows: Rows) -> Iterator[BoolArray]:
    """(n,) of each instrument: which readings are its."""
    for instrument in dict.fromkeys(run.instrument for run in rows.runs):
        mine = np.array([run.instrument == instrument for run in rows.runs])[rows.run]
        if mine.any():
            yield mine


def _of_temperature(readings: Readings, cause: Fitted) -> Iterator[FloatArray]:
    """What the machine's own temperature does, other than that which was read or, of a run that has none, assumed."""
    rows, context = readings.rows, readings.context

    def at(context: Context) -> FloatArray:
        other = replace(readings, context=context, memory=Memory())
        return parameter_signature(other, cause.effect, cause.values)[0] - cause.signal

    assumed = rows.assumed
    if rows.time is not None and np.isfinite(rows.time).all():
        share, constants = LAG
        for constant in constants:
            yield share * at(replace(context, temperature=_followed(context, ~assumed, constant)))
    if assumed.any():
        change = at(warmer(context))
        for index in np.unique(rows.run[assumed]):
            yield np.where(rows.run == index, change, 0.0)


def open_harmonics(readings: Readings, cause: Fitted) -> Iterator[FloatArray]:
    """(n,), mm, each, one standard deviation: second harmonics with any pitch that the readings leave open, so near one
    another that they differ by a quarter of a turn at most at the end of the axis. At few even targets each of these
    may be another smooth curve.
    """
    pitch = _pitch(cause)
    if pitch is None:
        return
    axis, rows = cause.effect.own_axis, readings.rows
    at = rows.positions[rows.axes.index(axis)] if axis else readings.reading.along
    value, a_period = cause.values[pitch], cause.values[pitch] ** 2 / max(float(np.nanmax(at) - np.nanmin(at)), 1e-300)
    away = min(OPEN * float(np.nan_to_num(cause.u[pitch])), PEAK * a_period)
    steps = math.ceil(2 * 4 * away / a_period)  # quarters of a turn of the harmonic, to each side
    pitches = value + away * np.linspace(-1.0, 1.0, 1 + 2 * steps)
    for other in pitches:
        for column in _harmonic(readings, cause, _with(cause.values, pitch, 0.5 * other)):
            yield column / np.sqrt(pitches.size)


def _pitch(cause: Fitted) -> int | None:
    """Place of the pitch among the parameters, if there is one."""
    return next((place for place, one in enumerate(cause.kind.parameters) if one.grid == "pitch"), None)


def _harmonic(readings: Readings, cause: Fitted, values: FloatArray) -> Iterator[FloatArray]:
    """Second harmonic of what is periodic, at two phases a quarter apart; values: (m,), of twice the frequency."""
    phase = next((place for place, one in enumerate(cause.kind.parameters) if one.role == "phase"), None)
    for quarter in (0.0, 0.5 * np.pi) if phase is not None else ():
        yield HARMONIC * parameter_signature(readings, cause.effect, _with(values, phase or 0, quarter))[0]


def _with(values: FloatArray, place: int, value: float) -> FloatArray:
    """Parameters (m,), one of them changed."""
    return np.where(np.arange(values.size) == place, value, values)


def _of_searched(readings: Readings, cause: Fitted) -> Iterator[FloatArray]:
    """Of parameters that the term is not linear in."""
    share, factor = OTHERWISE
    for place, parameter in enumerate(cause.kind.parameters):
        if parameter.role != "grid" or not parameter.is_divisor or parameter.grid == "pitch":
            continue
        for scale in (factor, 1.0 / factor):
            values = _with(cause.values, place, scale * cause.values[place])
            yield share * (parameter_signature(readings, cause.effect, values)[0] - cause.signal)


def _axes(cause: Fitted) -> tuple[str, ...]:
    return tuple(axis for axis in (cause.effect.own_axis, cause.effect.axis) if axis)


def _followed(context: Context, read: BoolArray, constant: float) -> FloatArray:
    """(n,), degC: a temperature that follows that of the readings with a time constant, s; others keep theirs."""
    time, temperature = context.time[read], context.temperature[read]
    order = np.argsort(time, kind="stable")
    grid = np.linspace(float(time.min()), float(time.max()), SAMPLES)
    air = np.interp(grid, time[order], temperature[order])
    share = 1.0 - np.exp(-(grid[1] - grid[0]) / constant)
    followed = np.empty_like(air)
    followed[0] = air[0]
    for k in range(1, SAMPLES):
        followed[k] = followed[k - 1] + share * (air[k] - followed[k - 1])
    found = context.temperature.copy()
    found[read] = np.interp(time, grid, followed)
    return found
