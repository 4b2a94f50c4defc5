"""The noise of the readings, from repeats: what differs between readings of the same target.

Readings of one target, from one side, with one set-up have one mean, whatever the model: this and the unknowns of each
run's instrument are taken as free, and what is left is fitted as white and slow noise by restricted maximum likelihood
(REML; Patterson and Thompson, Biometrika 58, 1971). Repeats may come in any order: passes, cycles, poses, further runs.
Without repeats the course of each run, smooth by direction, takes the place of the means.

Of all noise that the readings allow the slowest is taken: a cause that is none costs more than one not found.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.polynomial import legendre

from trueaxis.diagnose.base import Base
from trueaxis.diagnose.result import BoolArray, FloatArray, IntArray, NoiseOf
from trueaxis.diagnose.rows import Rows
from trueaxis.diagnose.whiten import SETTLED, RunNoise
from trueaxis.estimation.noise import Noise, Whitening
from trueaxis.estimation.noise_of_residuals import AS_MANY, LASTING, SHARES, SMALLEST
from trueaxis.estimation.runs import MeasuredRun

FEWEST = 4  # degrees of freedom, for a noise to be told
TARGETS = 40  # of a block: neighbours in the order of reading; the cost grows with their cube
ENOUGH = 1500.0  # degrees of freedom: they tell the noise to 2 %
ALLOWED = 1.35  # of log-likelihood: 90 % confidence
COURSE = 12  # degree of a run's own course, where nothing is repeated
PER_DEGREE = 6  # readings of a run for each of them
HELD = 0.05  # of a reading's variance: where the free columns leave less, it says nothing of the noise
FAR = 5.0  # robust standard deviations: such readings tell nothing of the noise
NORMAL_MEDIAN = 0.6744897501960817  # of the absolute value of a standard normal variable
SMALLER, OF_SMALLER = 0.9, 0.623  # share of the squares of a run, and their mean if they are of normal noise
LESS_EFFICIENT = 1.5  # variance of an estimate by these, over that by all
STRAIGHT = 1e-3  # of the length of a line: what targets may lie beside it
GIVEN = 1e6  # degrees of freedom of a noise that is given
REPEATS, COURSES, STATED, UNKNOWN = "repeats", "courses", "given", "unknown"  # where a noise comes from
DISPLAY = 12.0**-0.5  # of its step: the standard deviation of rounding
STEPS = tuple(digit * 10.0**power for power in range(-2, -7, -1) for digit in (5.0, 2.0, 1.0))  # of displays, mm


@dataclass(frozen=True, slots=True, eq=False)
class _Block:
    """Readings that tell of the noise. parts: of each run its place among the runs, its rows in the block and the time
    steps between these; free: (n, k), columns that may be anything; values: (n,), mm; lasting: in typical steps, the
    longest that its noise may last: what lasts longer the free columns hold.
    """

    parts: tuple[tuple[int, slice, FloatArray], ...]
    free: FloatArray
    values: FloatArray
    lasting: float

    @property
    def freedom(self) -> int:
        """At least so many degrees of freedom."""
        return int(self.values.size - self.free.shape[1])


def noise_of_runs(
    rows: Rows, base: Base, values: FloatArray, noise_um: float | None
) -> tuple[tuple[RunNoise, ...], tuple[NoiseOf, ...]]:
    """Of every run of the base, in its order, and of every instrument. values: (n,) mm, readings less what is expected.

    noise_um: of every reading, where it is known: white noise, and nothing is estimated.
    """
    noises: dict[str, Noise] = {}
    told: list[NoiseOf] = []
    scales = np.ones(len(base.runs))
    for name in dict.fromkeys(one.instrument for one in base.runs):
        members = [place for place, one in enumerate(base.runs) if one.instrument == name]
        origin, freedom = STATED, GIVEN
        if noise_um is not None:
            noises[name] = Noise(1e-3 * noise_um)
        else:
            noises[name], of_runs, origin, freedom = _of_instrument(rows, base, values, members)
            scales[members] = of_runs
        typical = noises[name]
        lasting = float(np.exp(-1.0 / typical.lasts)) if typical.slow else 0.0
        told.append(NoiseOf(name, typical.white, typical.slow, lasting, 0.0, freedom, origin))
    found = tuple(
        RunNoise(
            noise=noises[one.instrument],
            scale=float(scale),
            steps=one.rows.steps,
            settles=0.0,
            settling=np.exp(-one.rows.passed / SETTLED),
        )
        for one, scale in zip(base.runs, scales, strict=True)
    )
    return found, tuple(told)


def _of_instrument(
    rows: Rows, base: Base, values: FloatArray, members: Sequence[int]
) -> tuple[Noise, FloatArray, str, float]:
    """Noise, scale of every member, origin and degrees of freedom."""
    step = display_step(rows.reading[np.concatenate([base.runs[place].rows.at for place in members])])
    resolved = [base.runs[place].rows.run.device for place in members]
    step = max([step, *(one.resolution or 0.0 for one in resolved if one is not None)])
    # few repeats still are a better measure than none: the tests know how few they are
    for origin, blocks, fewest in ((REPEATS, _repeated, FEWEST), (COURSES, _courses, FEWEST), (REPEATS, _repeated, 1)):
        every = [one for one in blocks(rows, base, values, members) if one.freedom > 0]
        freedom = float(sum(one.freedom for one in every))
        if freedom >= fewest:
            hardly = _hardly_repeated(every, members) if origin == REPEATS else set()
            alone = [one for one in _courses(rows, base, values, sorted(hardly)) if one.freedom > 0]
            noise, scales = _restricted(every, alone, members)
            return _shown(noise, step, _readings_of_a_target(rows, base, members)), scales, origin, freedom
    mine = np.concatenate([base.runs[place].rows.at for place in members])
    size = max(float(np.sqrt(np.mean(values[mine] ** 2))), SMALLEST)
    return Noise(size), np.ones(len(members)), UNKNOWN, 1.0


def _readings_of_a_target(rows: Rows, base: Base, members: Sequence[int]) -> float:
    """How often a run reads the same target, on average."""
    readings = sum(base.runs[place].rows.at.size for place in members)
    targets = sum(np.unique(rows.target[base.runs[place].rows.at]).size for place in members)
    return readings / max(targets, 1)


def _shown(noise: Noise, step: float, times: float) -> Noise:
    """With the rounding of the display. times: readings of a target in a run.

    Where the noise is finer than the step, repeats are rounded alike, and no number of them tells more than one: each
    then has the rounding of all in its variance. Of two readings of normal noise the correlation of the rounding
    is exp(-(2 pi noise/step)^2) (first term of the series of Widrow and Kollar, Quantization Noise, 2008).
    """
    if step == 0.0:
        return noise
    alike = float(np.exp(-((2.0 * np.pi * noise.sigma / step) ** 2)))
    least = step * DISPLAY * float(np.sqrt(1.0 + (times - 1.0) * alike))
    return Noise(max(noise.white, least), noise.slow, noise.lasts)


def display_step(readings: FloatArray) -> float:
    """mm: the step of which all readings are multiples, 0 if they have none of those that displays have."""
    for step in STEPS:
        share = readings / step
        if np.abs(share - np.round(share)).max(initial=0.0) < 1e-6 and np.unique(readings).size > 1:
            return step
    return 0.0


def _enough(blocks: Sequence[_Block]) -> int:
    """How many of the blocks, the first ones, tell the noise of an instrument well enough."""
    return int(np.searchsorted(np.cumsum([one.freedom for one in blocks]), ENOUGH)) + 1


def _repeated(rows: Rows, base: Base, values: FloatArray, members: Sequence[int]) -> Iterator[_Block]:
    """Blocks of neighbouring targets that were read more than once with one set-up; first ones of all set-ups first."""
    of_setup: dict[int, list[int]] = {}
    for place in members:
        of_setup.setdefault(int(rows.setup[base.runs[place].rows.at[0]]), []).append(place)
    waiting = [_targets(rows, base, places) for places in of_setup.values()]
    for turn in range(max(map(len, waiting), default=0)):
        for places, targets in zip(of_setup.values(), waiting, strict=True):
            if turn < len(targets):
                yield _of_targets(rows, base, values, places, targets[turn])


def _targets(rows: Rows, base: Base, places: Sequence[int]) -> list[IntArray]:
    """Targets that are read more than once, in the order of the first reading, TARGETS at a time."""
    numbers = np.concatenate([rows.target[base.runs[place].rows.at] for place in places])
    unique, first, count = np.unique(numbers, return_index=True, return_counts=True)
    repeated = count > 1
    order = unique[repeated][np.argsort(first[repeated])]
    return [order[start : start + TARGETS] for start in range(0, order.size, TARGETS)]


def _of_targets(rows: Rows, base: Base, values: FloatArray, places: Sequence[int], targets: IntArray) -> _Block:
    parts, at, own = [], [], []
    start = 0
    for place in places:
        chosen = np.isin(rows.target[base.runs[place].rows.at], targets)
        if chosen.any():
            part = slice(start, start + int(chosen.sum()))
            parts.append((place, part, _steps(base.runs[place], chosen)))
            at.append(base.runs[place].rows.at[chosen])
            own.append((part, base.own[place][chosen]))
            start = part.stop
    mine = np.concatenate(at)
    means = (rows.target[mine][:, np.newaxis] == targets).astype(np.float64)
    columns = [means[:, means.any(axis=0)]]
    for part, one in own:
        block = np.zeros((mine.size, one.shape[1]))
        block[part] = one
        columns.append(block)
    longest = max(float(np.sum(steps)) for _, _, steps in parts)
    return _Block(tuple(parts), _independent(np.hstack(columns)), values[mine], longest)


def _steps(run: MeasuredRun, chosen: BoolArray) -> FloatArray:
    return np.diff(np.cumsum(run.rows.steps)[chosen], prepend=0.0)


def _courses(rows: Rows, base: Base, values: FloatArray, members: Sequence[int]) -> Iterator[_Block]:
    """Each run by itself, less a smooth course by direction."""
    for place in members:
        run = base.runs[place]
        count = run.rows.at.size
        degree = min(COURSE, count // PER_DEGREE)
        if degree < 1:
            continue
        if run.instrument != "ballbar" and not _on_a_line(run.rows.positions):
            continue
        leading = int(np.argmax(np.ptp(run.rows.positions, axis=1)))
        at, way = run.rows.positions[leading], rows.directions[leading, run.rows.at]
        turning = np.ptp(np.sign(np.gradient(at))) > 1.0 and run.instrument == "ballbar"
        along = run.rows.passed if turning or np.ptp(at) == 0.0 else (at - at.min()) / np.ptp(at)
        curve = legendre.legvander(2.0 * along - 1.0, (2 if turning else 1) * degree)
        sides = curve * way[:, np.newaxis] if np.unique(way).size > 1 and not turning else curve[:, :0]
        free = _independent(np.hstack([curve, sides, base.own[place]]))
        bend = float(np.sum(run.rows.steps)) / free.shape[1]
        yield _Block(((place, slice(0, count), run.rows.steps),), free, values[run.rows.at], bend)


def _on_a_line(positions: FloatArray) -> bool:
    """Whether positions (n_axes, n) lie on one line: poses of several axes follow no course of their order."""
    singular = np.linalg.svd(positions - positions.mean(axis=1, keepdims=True), compute_uv=False)
    return bool((singular[1:] <= STRAIGHT * singular[0]).all())


def _independent(columns: FloatArray) -> FloatArray:
    """(n, rank): an orthonormal basis of columns."""
    sized = columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
    left, singular, _ = np.linalg.svd(sized, full_matrices=False)
    return np.asarray(left[:, singular > 1e-9 * singular.max(initial=0.0)])


def _hardly_repeated(blocks: Sequence[_Block], members: Sequence[int]) -> set[int]:
    """Runs of which too few readings are repeated to tell that they have another noise than their instrument."""
    repeated = dict.fromkeys(members, 0)
    for one in blocks:
        for place, part, _ in one.parts:
            repeated[place] += part.stop - part.start
    return {place for place, count in repeated.items() if count < 2.0 * AS_MANY}


def _restricted(blocks: Sequence[_Block], alone: Sequence[_Block], members: Sequence[int]) -> tuple[Noise, FloatArray]:
    """The noise of one instrument by REML, and the scale of each of its runs. alone: of runs by themselves, which tell
    of their scale alone.
    """
    good, good_alone = [_near(one) for one in blocks], [_near(one) for one in alone]
    even = dict.fromkeys(members, 1.0)
    some = _enough(blocks)
    first = _best(blocks[:some], good[:some], even)
    scale = _scales([*blocks, *alone], [*good, *good_alone], first, members)
    best = _best(blocks[:some], good[:some], scale)
    return best, np.array([scale[place] for place in members])


def _best(blocks: Sequence[_Block], good: Sequence[BoolArray], scale: dict[int, float]) -> Noise:
    """Of every other shape the likeliest, then of those about it the slowest that the readings allow."""
    shares, lasting = SHARES[1:], _lasting(blocks)
    tried = {(0.0, 1.0): _likelihood(blocks, good, scale, 0.0, 1.0)}
    for share, lasts in product(shares[::2], lasting[::2]):
        tried[share, lasts] = _likelihood(blocks, good, scale, share, lasts)
    share, lasts = max(tried, key=lambda shape: tried[shape][0])
    for shape in product(_beside(shares, share), _beside(lasting, lasts)):
        if shape not in tried:
            tried[shape] = _likelihood(blocks, good, scale, *shape)
    most = max(likelihood for likelihood, _ in tried.values())
    return max((noise for likelihood, noise in tried.values() if likelihood >= most - ALLOWED), key=_slowness)


def _beside(values: Sequence[float], one: float) -> Sequence[float]:
    place = values.index(one) if one in values else 0
    return values[max(place - 1, 0) : place + 2]


def _slowness(noise: Noise) -> float:
    """The strength of the noise at low frequencies."""
    return noise.white**2 + noise.slow**2 * (1.0 + 2.0 * noise.lasts)


def _lasting(blocks: Sequence[_Block]) -> list[float]:
    """Durations of the slow part: no longer than a run."""
    longest = max((one.lasting for one in blocks), default=1.0)
    return [one for one in LASTING if one <= max(longest, 1.0)]


def _near(block: _Block) -> BoolArray:
    """(n,): readings that are not far off, by what the free columns leave of them; those that they hold are not."""
    share = 1.0 - np.sum(block.free**2, axis=1)
    left = np.abs(block.values - block.free @ (block.free.T @ block.values)) / np.sqrt(np.maximum(share, HELD))
    telling = share > HELD
    spread = float(np.median(left[telling])) / NORMAL_MEDIAN if telling.any() else 0.0
    near = (left <= FAR * spread) | ~telling if spread > 0.0 else np.ones(left.size, dtype=bool)
    return near if near.sum() > block.free.shape[1] else np.ones(left.size, dtype=bool)


def _whitened(block: _Block, good: BoolArray, unit: Noise, scale: dict[int, float]) -> tuple[FloatArray, float]:
    """(n, k + 1): free columns and values of the good readings, whitened, and half the log determinant of the noise."""
    both = np.column_stack([block.free, block.values])
    found, root = [], 0.0
    for place, part, steps in block.parts:
        kept = good[part]
        if kept.any():
            between = np.diff(np.cumsum(steps)[kept], prepend=0.0)
            whiten = Whitening(unit, between, scale[place])
            found.append(whiten(both[part][kept]))
            root += whiten.log_root
    return np.vstack(found), root


def _likelihood(
    blocks: Sequence[_Block], good: Sequence[BoolArray], scale: dict[int, float], share: float, lasts: float
) -> tuple[float, Noise]:
    """Restricted, maximal over the size, and the noise of that size."""
    unit = Noise(float(np.sqrt(1.0 - share)), float(np.sqrt(share)), lasts)
    squares, roots, freedom = 0.0, 0.0, 0
    for block, kept in zip(blocks, good, strict=True):
        white, root = _whitened(block, kept, unit, scale)
        k = white.shape[1] - 1
        r = np.asarray(np.linalg.qr(white, mode="r"))
        diagonal = np.abs(np.diag(r))[:k]
        held = diagonal > 1e-9 * diagonal.max(initial=0.0)
        squares += float(r[k, k] ** 2) if r.shape[0] > k else 0.0
        roots += root + float(np.log(diagonal[held]).sum())
        freedom += white.shape[0] - int(held.sum())
    variance = max(squares / max(freedom, 1), SMALLEST**2)
    sigma = float(np.sqrt(variance))
    return -0.5 * freedom * np.log(variance) - roots, Noise(sigma * unit.white, sigma * unit.slow, lasts)


def _scales(
    blocks: Sequence[_Block], good: Sequence[BoolArray], noise: Noise, members: Sequence[int]
) -> dict[int, float]:
    """Of every run: its readings as far as they tell that it has another noise than its instrument.

    By the mean of the smaller squares, which outliers do not move: of normal noise it tells as much as that of fewer.
    """
    left: dict[int, list[FloatArray]] = {place: [] for place in members}
    told, every_one = dict.fromkeys(members, 0.0), dict.fromkeys(members, 1.0)
    for block, kept in zip(blocks, good, strict=True):
        white, _ = _whitened(block, kept, noise, every_one)
        q = np.linalg.qr(white[:, :-1])[0]
        share = 1.0 - np.sum(q**2, axis=1)
        squares = (white[:, -1] - q @ (q.T @ white[:, -1])) ** 2 / np.maximum(share, HELD)
        start = 0
        for place, part, _ in block.parts:
            mine = slice(start, start + int(kept[part].sum()))
            left[place].append(squares[mine][share[mine] > HELD])
            told[place] += float(share[mine].sum()) / LESS_EFFICIENT
            start = mine.stop
    found = {}
    for place in members:
        every = np.concatenate([np.zeros(0), *left[place]])
        smaller = np.sort(every)[: int(np.ceil(SMALLER * every.size))]
        ratio = float(np.mean(smaller)) / OF_SMALLER if smaller.size else 1.0
        found[place] = float(np.sqrt((AS_MANY + told[place] * ratio) / (AS_MANY + told[place])))
    return found
