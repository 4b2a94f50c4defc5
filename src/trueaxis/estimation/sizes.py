"""The sizes of errors and instrument unknowns, about what was expected of them.

Every class of unknowns has a size, every component one of its own about that of its class, every axis that turns round
one of its harmonics about that of its components, and the curves have a shape. The logarithms have normal priors.
"""

from collections.abc import Sequence

import numpy as np

from trueaxis.estimation.curve_prior import FALLING_FACTOR, SHAPE, WAVES_FACTOR, CurvePrior
from trueaxis.estimation.instruments import CLASSES
from trueaxis.estimation.layout import EFFECT, Layout
from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.posterior import Posterior
from trueaxis.measurement.machine import FloatArray

CLASS_FACTOR = 4.0  # by which a size may be other than expected, one standard deviation
FIXED = 1.0  # of a size that is not estimated
FLAT = 1e4  # times the sizes of [prior]: with no prior to speak of, no error of any machine is drawn towards zero
# By which the sizes of components of one class differ. One size for all of a class costs 28 and 13 % of the error of
# predictions on worlds 441 and 442.
COMPONENT_FACTOR = 1.6
# By which the harmonics of an axis may be more or less than half of its errors: nearly all of an axis that repeats with
# the turn, next to nothing of one that is driven by a gear.
TURNS_FACTOR = 3.0
COMPONENT, TURNS = "of ", "of turns of "  # before a component, an axis: the name of its own size
# Of a standard normal number: how far the size of a component and the shape of curves may be from expected before a run
# that alone sees them counts as wrong. On 9009, a world as it should be, a probe that alone sees two curves of an axis
# was 8.9 times too far by the sizes and the shape that the others tell, 2.4 times by these; a set of twelve circles of
# 9845 1.8 and 1.0 times; a home 200 mm elsewhere 5.0 and 4.0.
WIDEST = 2.0
IDEAL = 1e-9  # times the sizes of what is unknown of instruments: nothing is


class Sizes:
    """All sizes as one vector of standard normal numbers, zero where everything is as expected.

    of_errors: classes of the machine's errors, the first ones; flat: the machine's errors have next to no prior, and no
    size that could be estimated; ideal: nothing is unknown of the instruments.
    """

    def __init__(
        self, layout: Layout, kinds: Sequence[Sequence[str]], *, flat: bool = False, ideal: bool = False
    ) -> None:
        self.layout, self.flat, self._ideal = layout, flat, ideal
        self._own_kinds = kinds
        classes = list(dict.fromkeys(layout.kinds))
        own = list(dict.fromkeys(kind for of_run in kinds for kind in of_run))
        self.of_errors = tuple(kind for kind in classes if kind not in CLASSES and kind != EFFECT)
        bases = list(zip(layout.components, layout.bases, strict=True))
        turning = list(dict.fromkeys(name.axis for name, basis in bases if basis.harmonics))
        of_components = [f"{COMPONENT}{name}" for name in layout.components]
        self.names = (*classes, *of_components, *(f"{TURNS}{axis}" for axis in turning), *own, *SHAPE)
        self._own_at = {kind: self.names.index(kind) for kind in own}
        of_machine = [CLASS_FACTOR, COMPONENT_FACTOR, TURNS_FACTOR, WAVES_FACTOR, FALLING_FACTOR]
        of_class, of_component, of_turns, *of_shape = [FIXED] * 5 if flat else of_machine
        factors = [
            *(self._factor(kind, of_class) for kind in classes),
            *([of_component] * len(bases)),
            *([of_turns] * len(turning)),
            *(self._factor(kind, FIXED) for kind in own),
            *of_shape,
        ]
        self.spread = np.log(factors)
        counts = [basis.count for basis in layout.bases]
        one_each = layout.count - sum(counts)
        members = [classes.index(kind) for kind in layout.kinds]
        self._class: IntArray = np.repeat(members, [*counts, *([1] * one_each)]).astype(np.int64)
        self._component: IntArray = np.repeat(np.arange(len(counts)) + len(classes), counts).astype(np.int64)
        waves = [  # which unknowns are harmonics, and the size of those
            (first + np.arange(basis.degree, basis.count), self.names.index(f"{TURNS}{name.axis}"))
            for (name, basis), first in zip(bases, layout.offsets[:-1].tolist(), strict=True)
            if basis.harmonics
        ]
        self._waves: IntArray = np.concatenate([np.zeros(0), *(at for at, _ in waves)]).astype(np.int64)
        self._turns: IntArray = np.repeat([size for _, size in waves], [at.size for at, _ in waves]).astype(np.int64)

    def scale(self, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(n,): logarithms of the prior sizes of the scaled unknowns, and (2, n) derivatives by the shape."""
        value = x * self.spread
        log = value[self._class]
        curves = self._component.size
        log[:curves] += value[self._component]
        log[self._waves] += value[self._turns]
        slope = np.zeros((len(SHAPE), log.size))
        bases = self.layout.bases
        weights = {basis: CurvePrior(basis).log_weights(value[-len(SHAPE) :]) for basis in dict.fromkeys(bases)}
        if weights:
            log[:curves] += np.concatenate([weights[basis][0] for basis in bases])
            slope[:, :curves] = np.hstack([weights[basis][1] for basis in bases])
        if self.flat:
            log[: self.layout.of_machine] += np.log(FLAT)
        if self._ideal:
            log[self.layout.of_shared] += np.log(IDEAL)
        return log, slope

    def factors(self, x: FloatArray) -> dict[str, float]:
        """Estimated over expected size, by class, by component (`of EXX`), axis (`of turns of C`) and of the shape."""
        return dict(zip(self.names, np.exp(x * self.spread).tolist(), strict=True))

    def taken(self, others: "Sizes", x: FloatArray) -> FloatArray:
        """(n_sizes,): those that others, x, have as well, the rest as expected."""
        known = dict(zip(others.names, x.tolist(), strict=True))
        return np.array([known.get(name, 0.0) for name in self.names])

    def widest(self, x: FloatArray) -> FloatArray:
        """(n_sizes,): x with every component as much larger than its class, and all curves as wavy, as a machine may be
        by WIDEST standard deviations.
        """
        found, first = x.copy(), self.names.index("waves")
        components = [place for place, name in enumerate(self.names) if name.startswith(COMPONENT)]
        found[components] = np.maximum(x[components], WIDEST)
        found[first:] = max(x[first], WIDEST), min(x[first + 1], -WIDEST)  # more waves, less falling
        return found

    def own_scale(self, kinds: Sequence[str], x: FloatArray) -> FloatArray:
        """(k,): prior standard deviations of a run's own unknowns, mm or rad; as expected where no run has such."""
        whole = IDEAL if self._ideal else 1.0
        value = x * self.spread
        logs = [value[self._own_at[kind]] if kind in self._own_at else 0.0 for kind in kinds]
        return np.array([whole * CLASSES[kind].size * np.exp(log) for kind, log in zip(kinds, logs, strict=True)])

    def own_scales(self, x: FloatArray) -> list[FloatArray]:
        """The same of every run."""
        return [self.own_scale(kinds, x) for kinds in self._own_kinds]

    def information(self, posterior: Posterior, slope: FloatArray) -> FloatArray:
        """Expected Fisher information of x with the prior's, 1: what the readings tell of the sizes at all.

        In units of the sizes, 2 (1 - Sigma)_kl^2 for every pair of unknowns; those of single runs by themselves.
        """
        unit = posterior.spread / posterior.scale[:, np.newaxis]
        told = (np.eye(unit.shape[0]) - unit @ unit.T) ** 2
        member = np.zeros((unit.shape[0], self.spread.size))
        rows = np.arange(unit.shape[0])
        member[rows, self._class] += 1.0
        member[rows[: self._component.size], self._component] += 1.0
        member[self._waves, self._turns] += 1.0
        member[:, -len(SHAPE) :] = slope.T
        found = 2.0 * member.T @ told @ member
        for kind, value in posterior.own_told:
            found[self._own_at[kind], self._own_at[kind]] += 2.0 * value
        return np.asarray(np.eye(self.spread.size) + found * np.outer(self.spread, self.spread))

    def gradient(self, expected: FloatArray, own: Sequence[tuple[str, float]], slope: FloatArray) -> FloatArray:
        """Of the logarithm of the marginal likelihood by x. expected: (n,), E[u^2] - 1; own: the same, by class."""
        found = np.zeros(self.spread.size)
        np.add.at(found, self._class, expected)
        np.add.at(found, self._component, expected[: self._component.size])
        np.add.at(found, self._turns, expected[self._waves])
        for kind, value in own:
            found[self._own_at[kind]] += value
        found[-len(SHAPE) :] = slope @ expected
        return found * self.spread

    def _factor(self, kind: str, of_machine: float) -> float:
        """By what the size of a class may be other than expected."""
        if kind in CLASSES:
            return FIXED if self._ideal else CLASSES[kind].factor
        return FIXED if kind == EFFECT else of_machine
