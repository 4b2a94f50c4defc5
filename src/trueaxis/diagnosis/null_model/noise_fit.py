"""The noise of all instruments at once, by restricted maximum likelihood, and the scale of each run.

The likelihood and its slopes in closed form (Harville, J. Am. Stat. Assoc. 72, 1977): with P the inverse of the
covariance V less what the free columns take, -2 log L = log|V| + log|X' V^-1 X| + y' P y, and its slope by a parameter
of V is tr(P dV) - y' P dV P y. What the base gets wrong is a part of V: a value for each target, which repeats share.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from scipy.linalg import block_diag

from trueaxis.diagnosis.null_model.base import ANYWHERE
from trueaxis.diagnosis.null_model.descent import Here, least
from trueaxis.diagnosis.null_model.noise_blocks import Block, Part, Shapes
from trueaxis.diagnosis.null_model.noise_law import Found, Guess, Law
from trueaxis.diagnosis.null_model.noise_precision import Precision, factor_less_misfit, precision_of, solved
from trueaxis.diagnosis.result import FloatArray
from trueaxis.estimation.factors import few_of

# of an instrument: logarithm of white noise, slow noise, logarithm of its time constant, wandering, settling, misfit of
# the base, places of its balls; the time constant in typical steps, sizes as shares of a first guess, squared but for
# that of white noise: a variance of zero is no point from which nothing leads away
START = (-0.3, 0.16, np.log(8.0), 0.09, 0.09, 0.09, 1.0)
BOUNDS = ((-7.0, 3.0), (0.0, 400.0), (0.0, np.log(64.0)), (0.0, 1e4), (0.0, 1e4), (0.0, 1e12), (0.0, 1e12))
PER, AGE, MISFIT, BALLS = len(START), 2, 5, 6
SQUARES = (1, 3, 4, MISFIT, BALLS)  # places of the parameters that are squares
# before the readings have their say, normal: the logarithms of white noise, for which three readings would take zero,
# and of a time constant; slow noise, wandering and settling in units of the first guess; places of balls in mm, as far
# as their class may be wrong
USUAL = np.log(8.0)
SPREAD, SLOW = (1.0, 2.0, 1.0, 2.0, 2.0, np.inf, np.inf), (1, 3, 4, BALLS)
UNEVEN = 0.3  # standard deviation of the logarithm of a run's white noise about that of its instrument
FARTHEST = 2.0  # of this logarithm
NOISIEST = 3.0 * UNEVEN  # of this logarithm: what is left beyond is no noise
LEAST = 0.1  # of the first guess, from where a size starts that was smaller before
STEPS = 200  # of a standard deviation that is averaged
FAR_BELOW, FAR_ABOVE = 20.0, 5.0  # standard uncertainties of its square


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _Told:
    """What a part tells at some noise. shapes: of the readings of each run; number: of its instrument; white: (n,),
    variance of each reading; slow: of unit size, noise: mm^2, of the readings of each run; precision: of all, what is
    free taken away; weighed: (n,), precision of all readings times their values.
    """

    part: Part
    shapes: Sequence[Shapes]
    number: int
    white: FloatArray
    slow: list[FloatArray]
    noise: list[FloatArray]
    precision: Precision
    weighed: FloatArray

    def slopes(self, age: float, of_scale: FloatArray) -> FloatArray:
        """(PER,): of minus the logarithm of the likelihood by the logarithm of white noise, by the squares of slow
        noise, wandering, settling, misfit and places of balls, mm^2, and by the logarithm of the age, of slow noise of
        unit size.
        """
        found = np.zeros(PER)
        found[0] = of_scale.sum()
        for here, block, slow, shape in zip(
            self.part.runs, self.precision.blocks(), self.slow, self.shapes, strict=True
        ):
            half = 0.5 * (block - np.outer(self.weighed[here], self.weighed[here]))
            found[1] += np.vdot(half, slow)
            found[3] += np.vdot(half, shape.wander)
            found[4] += np.vdot(half, shape.settle)
            found[BALLS] += np.vdot(half, shape.ball)
            found[AGE] += np.vdot(half * slow, shape.gaps) / age
        shared = self.weighed @ self.part.repeated
        of_repeated = self.precision.within(self.part.repeated) - float(shared @ shared)
        found[MISFIT] = 0.5 * (of_repeated + float(np.sum((of_scale / self.white)[self.part.alone])))
        return found

    def changes(self, age: float) -> FloatArray:
        """(n, PER): what a change of each of the same adds to the covariance, times the weighed readings."""
        found, weighed = np.empty((self.weighed.size, PER)), self.weighed
        found[:, 0] = 2.0 * self.white * weighed
        for here, slow, shape in zip(self.part.runs, self.slow, self.shapes, strict=True):
            each = (slow, shape.wander, shape.settle, shape.ball, slow * shape.gaps / age)
            for place, of_change in zip((1, 3, 4, BALLS, AGE), each, strict=True):
                found[here, place] = of_change @ weighed[here]
        found[:, MISFIT] = self.part.repeated @ (weighed @ self.part.repeated) + self.part.alone * weighed
        return found

    def of_scale(self) -> FloatArray:
        """(n,): of the same by the logarithm of the white noise of each reading."""
        return np.asarray(self.white * (self.precision.diagonal() - self.weighed**2))


class Likelihood:
    """Of a block, minus its logarithm; instruments: of every run; first: a guess of each instrument.

    Parameters: START of each instrument, then the logarithm of the scale of each run.
    """

    def __init__(self, block: Block, instruments: Sequence[str], first: Mapping[str, Guess]) -> None:
        self.block = block
        self.shapes = [one.shapes() for one in block.parts]
        # the free columns of each part as combinations of a few: products with hundreds are formed of all parts at once
        few, weights = zip(*[few_of(block.free[one.rows]) for one in block.parts], strict=True)
        self.few, self.weights = few, np.vstack(weights)
        self.ends = np.cumsum([0, *(one.shape[1] for one in few)])
        self.squares = np.add.reduceat(self.weights**2, self.ends[:-1]) if self.ends[-1] else np.zeros((len(few), 0))
        self.units = np.array([one.noise for one in first.values()])
        self.of_run = np.array([list(first).index(name) for name in instruments])
        self.count = PER * self.units.size
        self.spread = np.tile(SPREAD, (self.units.size, 1))
        self.spread[:, BALLS] = ANYWHERE / self.units

    def __call__(self, x: FloatArray) -> Here:
        """At parameters x (q,), with their prior: normal, of squares exponential; the average information."""
        usual, spread, of_square = np.zeros(x.size), np.full(x.size, UNEVEN), np.zeros(x.size, dtype=bool)
        usual[AGE : self.count : PER] = USUAL
        spread[: self.count] = self.spread.ravel()
        of_square[: self.count].reshape(-1, PER)[:, SQUARES] = True
        apart = np.where(of_square, np.sqrt(np.abs(x)), x - usual) / spread
        slope = np.where(of_square, 0.5 / spread, apart) / spread
        information = np.diag(np.where(of_square, 0.0, spread**-2.0))
        value, told = self.told(x)
        sizes = self.sizes(x)
        for one in told:
            number, runs = one.number, np.unique(one.part.place)
            by_size = np.full(PER, self.units[number] ** 2)
            by_size[0], by_size[AGE] = 1.0, sizes[number, 1] ** 2
            age, of_scale = float(sizes[number, AGE]), one.of_scale()
            slope[self.count :] += np.bincount(one.part.place, of_scale, self.of_run.size)
            slope[PER * number : PER * (number + 1)] += by_size * one.slopes(age, of_scale)
            changes = by_size * one.changes(age)
            changes = np.hstack([changes, changes[:, :1] * (one.part.place[:, np.newaxis] == runs)])
            mine = np.concatenate([PER * number + np.arange(PER), self.count + runs])
            information[np.ix_(mine, mine)] += 0.5 * changes.T @ (one.precision @ changes)
        return Here(value + 0.5 * float(apart @ apart), slope, information)

    def sizes(self, x: FloatArray) -> FloatArray:
        """(instruments, PER): standard deviations, mm, and the time constant."""
        found = np.sqrt(np.abs(x[: self.count].reshape(-1, PER))) * self.units[:, np.newaxis]
        found[:, 0] = self.units * np.exp(x[: self.count : PER])
        found[:, AGE] = np.exp(x[AGE : self.count : PER])
        return np.asarray(found)

    def parameters(self, found: Found) -> FloatArray:
        """Where sizes and scales are as found; no size is so small that it would take long to grow."""
        relative = np.maximum(found.sizes / self.units[:, np.newaxis], LEAST) ** 2
        relative[:, 0], relative[:, AGE] = 0.5 * np.log(relative[:, 0]), np.log(found.sizes[:, AGE])
        within = np.clip(relative, *np.transpose(BOUNDS))
        return np.concatenate([within.ravel(), np.clip(np.log(found.scales), -FARTHEST, FARTHEST)])

    def told(self, x: FloatArray) -> tuple[float, list[_Told]]:
        """Minus the logarithm, and what each part tells."""
        found, held, root = [], [], 0.0
        sizes, values = self.sizes(x), self.block.values
        inside, of_values = np.empty_like(self.weights), np.empty(int(self.ends[-1]))
        least = np.empty(len(self.few))
        of_few = [slice(*both) for both in pairwise(self.ends.tolist())]
        for k, (part, shapes, few) in enumerate(zip(self.block.parts, self.shapes, self.few, strict=True)):
            number = int(self.of_run[part.place[0]])
            level, slow, age, wanders, settles, misfit, places = sizes[number]
            white = (level * np.exp(x[self.count + part.place])) ** 2
            slowly = [np.exp(one.gaps / -age) for one in shapes]
            alone = white + misfit**2 * part.alone  # what is read once differs from the base as it does from noise
            noise = []
            for of_slow, shape, here in zip(slowly, shapes, part.runs, strict=True):
                of_run = slow**2 * of_slow + wanders**2 * shape.wander + settles**2 * shape.settle
                of_run += places**2 * shape.ball
                of_run.ravel()[:: len(of_run) + 1] += alone[here]
                noise.append(of_run)
            precision, of_part = precision_of(noise, part.repeated, misfit, part.own)
            root += of_part
            through = precision @ np.column_stack([few, values[part.rows]])
            both = few.T @ through
            np.matmul(both[:, :-1], self.weights[of_few[k]], out=inside[of_few[k]])
            of_values[of_few[k]] = both[:, -1]
            least[k] = alone.min()
            held.append(through)
            found.append(
                _Told(
                    part=part,
                    shapes=shapes,
                    number=number,
                    white=white,
                    slow=slowly,
                    noise=noise,
                    precision=precision,
                    weighed=through[:, -1],
                )
            )
        squares = self.weights.T @ inside
        squares.ravel()[:: len(squares) + 1] += float(self.block.by_chance)
        factor = factor_less_misfit(squares, (1.0 / least) @ self.squares)  # few are orthonormal
        root += float(np.log(np.diag(factor)).sum())
        of_free = solved(factor, self.weights.T)
        taken = of_free.T @ solved(factor, (self.weights.T @ of_values)[:, np.newaxis])[:, 0]
        told = []
        for one, through, here in zip(found, held, of_few, strict=True):
            weighed = one.weighed - through[:, :-1] @ taken[here]
            rows = np.linalg.qr(of_free[:, here], mode="r") @ through[:, :-1].T
            told.append(replace(one, precision=one.precision.less(rows), weighed=weighed))
            root += 0.5 * float(values[one.part.rows] @ weighed)
        return root, told


def restricted(
    blocks: Sequence[Block], instruments: Sequence[str], first: Mapping[str, Guess], before: Found | None
) -> tuple[dict[str, Law], Found]:
    """The likeliest noise of every instrument by the first block, and with the scale of every run.

    instruments: of every run; first: a guess of each; before: what was found of nearly the same readings.
    """
    of = Likelihood(blocks[0], instruments, first)
    start = np.concatenate([np.tile(START, len(first)), np.zeros(len(instruments))])
    bounds = [*BOUNDS * len(first), *[(-FARTHEST, FARTHEST)] * len(instruments)]
    start[MISFIT : of.count : PER] = [one.misfit**2 for one in first.values()]
    if before is not None and before.scales.size == len(instruments):
        start = of.parameters(before)
    for number, one in enumerate(first.values()):
        if one.misfit == 0.0:  # nothing tells it from noise
            start[PER * number + MISFIT] = 0.0
            bounds[PER * number + MISFIT] = (0.0, 0.0)
    best, unlikely = least(of, start, *np.transpose(bounds))
    laws, information = _averaged(of, list(first), best)
    for block in blocks[1:]:
        information += _scaled(Likelihood(block, instruments, first), best)
    return laws, Found(sizes=of.sizes(best), scales=np.exp(best[of.count :]), told=information, unlikely=unlikely)


def _scaled(of: Likelihood, x: FloatArray) -> FloatArray:
    """Set the scales of the runs of a block: one step from 1, exact where noise is white. What the readings tell of
    their logarithms, (n_runs,).
    """
    slope, information = np.zeros((2, of.of_run.size))
    for one in of.told(x)[1]:
        slope -= np.bincount(one.part.place, one.of_scale(), of.of_run.size)
        information += _of_scales(one, one.precision.dense(), of.of_run.size)
    step = np.maximum(1.0 + 2.0 * slope / (information + UNEVEN**-2), np.exp(-2.0 * FARTHEST))
    x[of.count :] += np.where(information > 0.0, 0.5 * np.log(step), 0.0)
    return information


def _of_scales(one: _Told, precision: FloatArray, runs: int) -> FloatArray:
    """(runs,): expected information of a part on the logarithms of their scales."""
    both = (one.white * (one.white[:, np.newaxis] * precision**2)).sum(axis=0)
    return np.asarray(2.0 * np.bincount(one.part.place, both, runs), dtype=np.float64)


def _averaged(of: Likelihood, names: Sequence[str], x: FloatArray) -> tuple[dict[str, Law], FloatArray]:
    """The noise of the instruments, and what readings tell of the logarithms of the scales, (n_runs,).

    Slow parts are averaged over what the readings leave possible: of a variance of which little is known the likelihood
    is normal about its best value, and the standard deviation anything from 0 on.
    """
    slopes, information = np.zeros((2, len(names), len(SLOW)))
    freedom, sizes = np.zeros(len(names)), of.sizes(x)
    of_scales = np.zeros(of.of_run.size)
    for one in of.told(x)[1]:
        misfit = sizes[one.number, MISFIT]  # what it may be of readings that are alone is no noise that is known
        of_base = misfit**2 * float(one.precision.diagonal()[one.part.alone].sum())
        freedom[one.number] += sum(map(np.vdot, one.precision.blocks(), one.noise)) - of_base
        slopes[one.number] += one.slopes(1.0, one.of_scale())[list(SLOW)]
        whole = one.precision.dense()
        of_scales += _of_scales(one, whole, of.of_run.size)
        parts = zip(*[(each.wander, each.settle, each.ball) for each in one.shapes], strict=True)
        for k, shapes in enumerate((one.slow, *parts)):
            both = whole @ block_diag(*shapes)
            information[one.number, k] += 0.5 * float(np.sum(both * both.T))
    best = sizes[:, list(SLOW)] ** 2
    usual = (of.spread[:, list(SLOW)] * of.units[:, np.newaxis]) ** 2
    most = np.maximum(FAR_ABOVE**2 * usual, 4.0 * best)
    spread = np.minimum(1.0 / np.sqrt(np.maximum(information, 1e-300)), most)
    middle = np.maximum(best - slopes * spread**2, -FAR_BELOW * spread)
    farthest = np.minimum(np.maximum(middle, 0.0) + FAR_ABOVE * spread, most)
    possible = np.linspace(0.0, 1.0, STEPS)[:, np.newaxis, np.newaxis] ** 2 * farthest
    unlikely = 0.5 * (((possible - middle) / spread) ** 2 + possible / usual)
    weight = np.exp(unlikely.min(axis=0) - unlikely)
    slow, wanders, settles, places = np.sqrt(np.sum(weight * possible, axis=0) / np.sum(weight, axis=0)).T
    laws = {
        name: Law(
            white=float(sizes[k, 0]),
            slow=float(slow[k]),
            lasts=float(sizes[k, AGE]),
            wanders=float(wanders[k]),
            settles=float(settles[k]),
            places=float(places[k]),
            freedom=float(freedom[k]),
        )
        for k, name in enumerate(names)
    }
    return laws, of_scales
