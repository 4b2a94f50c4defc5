"""What errors of the two axes the radial deviations of a circle are made of, each with its uncertainty.

A radial deviation is the deviation (du, dv) of the tool along the radius, du cos + dv sin, at u = r cos, v = r sin.
Each error of an axis gives a column; all are estimated at once by least squares, with standard uncertainties that hold
where neighbouring readings are correlated (Newey and West 1987). What these arcs cannot tell from the others is left
out and named: squareness and servo mismatch, for one, look the same with one sense of rotation.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.evaluation.circular_test import CircularTest, FloatArray

# Share of a column that the others leave of it, below which it is left out: its uncertainty would be more than five
# times that without them.
LEAST_SHARE = 0.2
LENGTHS = np.geomspace(0.002, 0.2, 15)  # of the radius: over which a reversal spike decays along the path
PITCHES = (0.01, 0.5)  # of the radius: shortest and longest period of a cyclic error
ROUNDS = 2  # spikes and cyclic errors are sought beside each other
READINGS_A_PERIOD = 6.0  # at least, of a cyclic error, else it cannot be told from one of another period
CHANCE = 1e-3  # that the strongest period of noise alone is taken for a cyclic error


@dataclass(frozen=True, slots=True, kw_only=True)
class Contribution:
    """error: identifier, a key of `NAMES` in the report; of: axis or plane, with the end of the axis where it has one;
    value, u: with standard uncertainty, in unit; range: of the radial deviations that it causes, mm; share: of the sum
    of the ranges; pitch: of a cyclic error, mm.
    """

    error: str
    of: str
    value: float
    u: float
    unit: str
    range: float
    share: float
    pitch: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Contributions:
    """largest: in the order of their ranges; left_out: what these arcs cannot tell from the others, (error, of);
    radius: mean deviation of the radius, mm, with u; residual: root mean square of what is left, mm; explained: share
    of the mean square of the deviations about the centre.
    """

    largest: tuple[Contribution, ...]
    left_out: tuple[tuple[str, str], ...]
    radius: tuple[float, float]
    residual: float
    explained: float


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _Term:
    """columns: (n, k), radial deviation in mm by the value over `scale`; k is 2 for a cyclic error, else 1; bent: (n,),
    derivative of the column by what was sought of its form.
    """

    error: str
    of: str
    unit: str
    scale: float
    columns: FloatArray
    pitch: float | None = None
    bent: FloatArray | None = None


def contributions(test: CircularTest) -> Contributions:
    """The errors of the two axes, largest range first."""
    angle = np.concatenate([arc.angle for arc in test.arcs])
    sense = np.concatenate([np.full(arc.angle.size, float(arc.sense)) for arc in test.arcs])
    deviation = np.concatenate([arc.deviation for arc in test.arcs])
    set_up = np.column_stack([np.ones_like(angle), np.cos(angle), np.sin(angle)])
    steady = [*_geometry(test, angle), *_drives(test, angle, sense)]
    kept, left_out = _separable(set_up, steady)
    cyclic: list[_Term] = []
    for _ in range(ROUNDS):
        others = [set_up, *(one.columns for one in (*kept, *cyclic))]
        spikes = _best_spikes(test, angle, sense, deviation, others)
        steady, more = _separable(set_up, [*kept, *spikes])
        cyclic = _cyclic(test, angle, deviation, [set_up, *(one.columns for one in steady)])
    return _estimated(set_up, [*steady, *cyclic], deviation, left_out + more)


def _geometry(test: CircularTest, angle: FloatArray) -> Iterator[_Term]:
    """Squareness, scale and straightness: what the sense of rotation does not change."""
    u, v = test.plane
    r, cos, sin = test.radius, np.cos(angle), np.sin(angle)
    yield _Term(error="squareness", of=u + v, unit="urad", scale=1e6, columns=-r * (sin * cos)[:, np.newaxis])
    yield _Term(
        error="scale_mismatch",
        of=f"{u}-{v}",
        unit="um/m",
        scale=1e6,
        columns=0.5 * r * np.cos(2 * angle)[:, np.newaxis],
    )
    yield _Term(error="straightness", of=f"{u} in {v}", unit="um", scale=1e3, columns=(cos**2 * sin)[:, np.newaxis])
    yield _Term(error="straightness", of=f"{v} in {u}", unit="um", scale=1e3, columns=(sin**2 * cos)[:, np.newaxis])


def _drives(test: CircularTest, angle: FloatArray, sense: FloatArray) -> Iterator[_Term]:
    """Reversal error at each end of each axis, lateral play, servo mismatch: what goes with the motion."""
    feed = test.feed
    unit, scale = ("ms", 6e4 / feed) if feed else ("um", 1e3)  # mm of following error at the feed, or time
    column = 0.5 * sense * np.sin(2 * angle)
    yield _Term(error="servo_mismatch", of="-".join(test.plane), unit=unit, scale=scale, columns=column[:, np.newaxis])
    for axis, along, across, way in _axes(test, angle, sense):
        half = 0.5 * way * along
        for end, at in (("+", along > 0.0), ("-", along < 0.0)):
            yield _Term(
                error="reversal_error",
                of=f"{axis}, {end} end",
                unit="um",
                scale=1e3,
                columns=(half * at)[:, np.newaxis],
            )
        yield _Term(error="lateral_play", of=axis, unit="um", scale=1e3, columns=(0.5 * way * across)[:, np.newaxis])


def _axes(
    test: CircularTest, angle: FloatArray, sense: FloatArray
) -> Iterator[tuple[str, FloatArray, FloatArray, FloatArray]]:
    """Each axis of the plane: cosine of the radius to it, sine, and the direction in which it moves."""
    cos, sin = np.cos(angle), np.sin(angle)
    yield test.plane[0], cos, sin, -sense * np.sign(sin)
    yield test.plane[1], sin, cos, sense * np.sign(cos)


def _best_spikes(
    test: CircularTest, angle: FloatArray, sense: FloatArray, deviation: FloatArray, others: Sequence[FloatArray]
) -> list[_Term]:
    """Reversal spikes of both axes, decaying over the length of path that leaves least."""
    from scipy.optimize import minimize_scalar  # noqa: PLC0415  half a second; only who evaluates a circle needs it

    space = _orthonormal(np.hstack(others))
    rest = deviation - space @ (space.T @ deviation)

    def left(log_length: float) -> float:
        columns = np.hstack([one.columns for one in _spikes(test, angle, sense, float(np.exp(log_length)))])
        columns = columns - space @ (space.T @ columns)
        return float(np.sum((rest - columns @ np.linalg.lstsq(columns, rest, rcond=None)[0]) ** 2))

    grid = np.log(LENGTHS)
    best = int(np.argmin([left(one) for one in grid]))
    between = grid[max(best - 1, 0)], grid[min(best + 1, grid.size - 1)]
    length = float(np.exp(minimize_scalar(left, bounds=between, method="bounded").x))
    return list(_spikes(test, angle, sense, length))


def _spikes(test: CircularTest, angle: FloatArray, sense: FloatArray, length: float) -> Iterator[_Term]:
    """The axis stays behind where it turns round and catches up: outwards at both of its ends."""
    for number, axis in enumerate(test.plane):
        since = np.mod(sense * (angle - 0.5 * np.pi * number), np.pi)  # angle since the axis turned round
        column = np.exp(-since / length)
        yield _Term(
            error="reversal_spike",
            of=axis,
            unit="um",
            scale=1e3,
            columns=column[:, np.newaxis],
            bent=column * since / length,
        )


def _cyclic(test: CircularTest, angle: FloatArray, deviation: FloatArray, others: Sequence[FloatArray]) -> list[_Term]:
    """A cyclic error of each axis where one period stands out of what is left; see CHANCE."""
    from scipy.optimize import minimize_scalar  # noqa: PLC0415  as above

    found: list[_Term] = []
    step = test.radius * float(np.median(np.abs(np.concatenate([np.diff(arc.angle) for arc in test.arcs]))))
    shortest = max(PITCHES[0] * test.radius, READINGS_A_PERIOD * step)
    longest = PITCHES[1] * test.radius
    if shortest >= longest:
        return found
    # a circle holds 2 r of each axis: periods that differ by less than a quarter of one over it look the same
    rates = np.arange(1.0 / longest, 1.0 / shortest, 0.125 / test.radius)
    space = _orthonormal(np.hstack(others))
    for number, axis in enumerate(test.plane):
        along = np.cos(angle - 0.5 * np.pi * number)
        rest = deviation - space @ (space.T @ deviation)
        known = (test.radius * along, along, space, rest)
        losses = [_loss(float(rate), *known) for rate in rates]
        best = int(np.argmin(losses))
        between = rates[max(best - 1, 0)], rates[min(best + 1, rates.size - 1)]
        finer = minimize_scalar(_loss, bounds=between, args=known, method="bounded")
        rate, gain = float(finer.x), -float(finer.fun)
        if rates.size * _chance(gain / float(rest @ rest), _independent(rest)) < CHANCE:
            columns = _waves(rate, *known[:2])
            found.append(_Term(error="cyclic_error", of=axis, unit="um", scale=2e3, columns=columns, pitch=1.0 / rate))
            space = _orthonormal(np.hstack([space, columns]))
    return found


def _waves(rate: float, position: FloatArray, along: FloatArray) -> FloatArray:
    """(n, 2): radial deviation by a periodic error of an axis. rate: periods a mm; position: of the axis, mm; along:
    its share in the radius.
    """
    phase = 2 * np.pi * rate * position
    return np.column_stack([np.cos(phase) * along, np.sin(phase) * along])


def _loss(rate: float, position: FloatArray, along: FloatArray, space: FloatArray, rest: FloatArray) -> float:
    """Minus the sum of squares that a periodic error explains of what a space leaves, mm^2."""
    columns = _waves(rate, position, along)
    own = _orthonormal(columns - space @ (space.T @ columns))
    return -float(np.sum((own.T @ rest) ** 2))


def _chance(share: float, readings: float) -> float:
    """That a wave of a given period explains this share of the squares of noise: Fisher's g of one period."""
    return float((1.0 - min(share, 1.0)) ** (0.5 * max(readings - 2.0, 1.0)))


def _independent(rest: FloatArray) -> float:
    """How many independent readings the residuals are worth, by the correlation of neighbours."""
    kept = float(rest[1:] @ rest[:-1]) / max(float(rest @ rest), 1e-300)
    kept = min(max(kept, 0.0), 0.999)
    return rest.size * (1.0 - kept) / (1.0 + kept)


def _separable(set_up: FloatArray, terms: Sequence[_Term]) -> tuple[list[_Term], list[tuple[str, str]]]:
    """Those that the set-up and the terms before leave enough of; and the others."""
    kept, left_out, space = list[_Term](), list[tuple[str, str]](), _orthonormal(set_up)
    for term in terms:
        column = term.columns[:, 0]
        rest = column - space @ (space.T @ column)
        if float(np.linalg.norm(rest)) < LEAST_SHARE * float(np.linalg.norm(column)):
            left_out.append((term.error, term.of))
            continue
        kept.append(term)
        space = _orthonormal(np.hstack([space, rest[:, np.newaxis]]))
    return kept, left_out


def _orthonormal(columns: FloatArray) -> FloatArray:
    q, r = np.linalg.qr(columns)
    size = np.abs(np.diag(r))
    return np.asarray(q[:, size > 1e-12 * size.max(initial=1e-300)])


def _estimated(
    set_up: FloatArray,
    terms: Sequence[_Term],
    deviation: FloatArray,
    left_out: Sequence[tuple[str, str]],
) -> Contributions:
    import statsmodels.api as sm  # noqa: PLC0415  takes long to import

    design = np.hstack([set_up, *(one.columns for one in terms)])
    starts = np.cumsum([set_up.shape[1], *(one.columns.shape[1] for one in terms)])[:-1]
    sizes = np.linalg.lstsq(design, deviation, rcond=None)[0][starts]
    bent = [size * one.bent for size, one in zip(sizes, terms, strict=True) if one.bent is not None]
    if bent:  # how far spikes last is not known either: their u holds it
        design = np.column_stack([design, np.sum(bent, axis=0)])
    lags = int(4.0 * (deviation.size / 100.0) ** (2.0 / 9.0))  # Newey and West 1994
    fit = sm.OLS(deviation, design).fit(cov_type="HAC", cov_kwds={"maxlags": lags, "use_correction": True})
    values, covariance = np.asarray(fit.params), np.asarray(fit.cov_params())
    found = []
    for start, term in zip(starts, terms, strict=True):
        part = slice(start, start + term.columns.shape[1])
        caused = term.columns @ values[part]
        size = float(np.linalg.norm(values[part])) if term.pitch is not None else float(values[part][0])
        ahead = values[part] / (size or 1.0) if term.pitch is not None else np.ones(1)
        u = float(np.sqrt(max(ahead @ covariance[part, part] @ ahead, 0.0)))
        found.append((term, term.scale * size, term.scale * u, float(np.ptp(caused))))
    whole = sum(extent for *_, extent in found) or 1.0
    largest = sorted(
        (
            Contribution(
                error=term.error, of=term.of, value=value, u=u, unit=term.unit, range=extent, share=extent / whole,
                pitch=term.pitch,
            )
            for term, value, u, extent in found
        ),
        key=lambda one: -one.range,
    )  # fmt: skip
    about = deviation - set_up @ np.linalg.lstsq(set_up, deviation, rcond=None)[0]
    rest = np.asarray(fit.resid)
    return Contributions(
        largest=tuple(largest),
        left_out=tuple(left_out),
        radius=(float(values[0]), float(np.sqrt(covariance[0, 0]))),
        residual=float(np.sqrt(np.mean(rest**2))),
        explained=1.0 - float(rest @ rest) / max(float(about @ about), 1e-300),
    )
