"""White and slow noise of an instrument by restricted maximum likelihood, and the scale of each of its runs."""

from collections.abc import Sequence
from itertools import product

import numpy as np

from trueaxis.diagnose.noise_blocks import Block
from trueaxis.diagnose.result import BoolArray, FloatArray
from trueaxis.estimation.noise import Noise, Whitening
from trueaxis.estimation.noise_of_residuals import AS_MANY, LASTING, SHARES, SMALLEST

ENOUGH = 1500.0  # degrees of freedom: they tell the noise to 2 %
ALLOWED = 1.35  # of log-likelihood: 90 % confidence
HELD = 0.05  # of a reading's variance: where the free columns leave less, it says nothing of the noise
FAR = 5.0  # robust standard deviations: such readings tell nothing of the noise
NORMAL_MEDIAN = 0.6744897501960817  # of the absolute value of a standard normal variable
SMALLER, OF_SMALLER = 0.9, 0.623  # share of the squares of a run, and their mean if they are of normal noise
LESS_EFFICIENT = 1.5  # variance of an estimate by these, over that by all


def restricted(blocks: Sequence[Block], alone: Sequence[Block], members: Sequence[int]) -> tuple[Noise, FloatArray]:
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


def _enough(blocks: Sequence[Block]) -> int:
    """How many of the blocks, the first ones, tell the noise of an instrument well enough."""
    return int(np.searchsorted(np.cumsum([one.freedom for one in blocks]), ENOUGH)) + 1


def _best(blocks: Sequence[Block], good: Sequence[BoolArray], scale: dict[int, float]) -> Noise:
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


def _lasting(blocks: Sequence[Block]) -> list[float]:
    """Durations of the slow part: no longer than a run."""
    longest = max((one.lasting for one in blocks), default=1.0)
    return [one for one in LASTING if one <= max(longest, 1.0)]


def _near(block: Block) -> BoolArray:
    """(n,): readings that are not far off, by what the free columns leave of them; those that they hold are not."""
    share = 1.0 - np.sum(block.free**2, axis=1)
    left = np.abs(block.values - block.free @ (block.free.T @ block.values)) / np.sqrt(np.maximum(share, HELD))
    telling = share > HELD
    spread = float(np.median(left[telling])) / NORMAL_MEDIAN if telling.any() else 0.0
    near = (left <= FAR * spread) | ~telling if spread > 0.0 else np.ones(left.size, dtype=bool)
    return near if near.sum() > block.free.shape[1] else np.ones(left.size, dtype=bool)


def _whitened(block: Block, good: BoolArray, unit: Noise, scale: dict[int, float]) -> tuple[FloatArray, float]:
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
    blocks: Sequence[Block], good: Sequence[BoolArray], scale: dict[int, float], share: float, lasts: float
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
    blocks: Sequence[Block], good: Sequence[BoolArray], noise: Noise, members: Sequence[int]
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
