"""Curves that are rougher than the base has them: they compete with the causes for what is left, and have no name.

What a curve of the machine leaves beyond the degree of the base looks most like a cyclic error of a long period, or
like an effect of another axis. Values that are given, and true, leave nothing; those of zero, or of long ago, do.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from trueaxis.diagnosis.null_model.base import DEGREE, ROUGH, Base, base_of
from trueaxis.diagnosis.null_model.by_run import ByRun
from trueaxis.diagnosis.null_model.freedom import Freedom
from trueaxis.diagnosis.null_model.null import Null
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.null_model.whiten import Whitening
from trueaxis.diagnosis.result import FloatArray, IntArray
from trueaxis.estimation.tails import LN10, log_chi2_tail, log_f_tail
from trueaxis.model.model import MachineModel

# degrees beyond those of the base that are looked at besides all: most of what a curve leaves is in the next ones, and
# the others would only be tries
FURTHER_DEGREES = (1, 2, 4)
# Standard deviations of a local change of a curve that is looked at besides, in shares of the range over the roughest
# degree, at two places a share: what the base leaves of it are a few waves, and all further degrees would be tries
WIDTHS = (0.5, 1.0, 2.0)
LEFT = 1e-9  # of the largest square: of a change of which the base leaves less there is nothing to see


@dataclass(frozen=True, slots=True)
class Rough:
    """A component whose higher degrees explain readings; evidence, preference: as of a candidate (`scan.Scanned`)."""

    component: str
    evidence: float
    preference: float


@dataclass(frozen=True, slots=True, eq=False)
class Higher:
    """Columns in mm of all components with degrees beyond those of a base, and the places of these among them, whatever
    the noise is. local: (k, m) of every component, local changes by its degrees beyond.
    """

    base: Base
    columns: ByRun
    places: Mapping[str, IntArray]
    local: Mapping[str, FloatArray]


@dataclass(frozen=True, slots=True, eq=False)
class Roughness:
    """higher: (n, k) columns of each component beyond the base, whitened; products: (k, k), of what the base without
    causes leaves of them; local: see `Higher`.
    """

    higher: Mapping[str, ByRun]
    products: Mapping[str, FloatArray]
    local: Mapping[str, FloatArray]

    def roughest(
        self, projection: Projection, values: FloatArray, freedom: Freedom, *, local: bool = False
    ) -> Rough | None:
        """Of what the base, with causes, leaves of the readings, (n,) whitened; None where none explains any of it.

        local: whether changes at one place are looked at, too: what the base leaves of these looks periodic.
        """
        left, every = projection.rest(values), np.arange(values.size)
        back, found = projection.rest_transposed(left), []
        for name, columns in self.higher.items():
            dense = columns.dense()  # of one at a time: all would be as large as the base
            of_causes = projection.inner_causes.T @ dense
            products = self.products[name] - of_causes.T @ of_causes
            each = list(_of_degrees(projection, dense, products, left))
            each += _of_places(self.local[name], dense, products, back) if local else ()
            for combination, k, tries in each:
                statistic = float(combination @ back)
                if k == 0 or statistic <= 0.0:
                    continue
                of_noise = freedom.of(every, combination[:, np.newaxis] * freedom.sigma[:, np.newaxis])
                evidence = -log_f_tail(statistic / k, k, of_noise) / LN10 - tries
                found.append(Rough(name, evidence, -log_chi2_tail(statistic, k) / LN10 - tries))
        return max(found, key=lambda one: one.preference, default=None)


def _of_degrees(
    projection: Projection, dense: FloatArray, products: FloatArray, left: FloatArray
) -> Iterator[tuple[FloatArray, int, float]]:
    """The best combination of the next degrees, (n,) whitened, of how many it is one, and the logarithm of how many are
    tried. dense: (n, k), the degrees; products: (k, k) of what the base with causes leaves of them; left: (n,), of the
    readings.
    """
    counts = [count for count in FURTHER_DEGREES if count < dense.shape[1]] + [dense.shape[1]]
    every = np.arange(left.size)
    for count in counts:
        some = dense[:, :count]
        weights, k = projection.explaining(every, some, left, products[:count, :count])
        yield some @ weights, k, float(np.log10(len(counts)))


def _of_places(
    local: FloatArray, dense: FloatArray, products: FloatArray, back: FloatArray
) -> Iterator[tuple[FloatArray, int, float]]:
    """The same of the likeliest local change, if any is seen. local: (k, m); back: (n,), what each whitened reading
    says, by what is left of all.
    """
    size = np.einsum("km,km->m", local, products @ local)
    seen = size > LEFT * size.max(initial=0.0)
    if seen.any():
        local, size = local[:, seen], size[seen]
        inside = local.T @ (dense.T @ back)
        best = int(np.argmax(inside**2 / size))
        yield dense @ local[:, best] * (inside[best] / size[best]), 1, float(np.log10(size.size))


def _local(base: Base, name: str, rows: Rows, beyond: slice) -> FloatArray:
    """(k, m): local changes of a component, by its degrees beyond others, as the columns of the base have them; none
    of an axis that stands.
    """
    at, curve = base.curve(name, rows)
    apart = np.ptp(at) / ROUGH
    if apart == 0.0:
        return np.zeros((beyond.stop - beyond.start, 0))
    places = np.linspace(at[0], at[-1], 2 * ROUGH + 1)
    bumps = [np.exp(-0.5 * ((at[:, np.newaxis] - places) / (width * apart)) ** 2) for width in WIDTHS]
    expected = base.expected[np.flatnonzero(np.array(base.components) == name)]
    found = expected[:, np.newaxis] * np.linalg.lstsq(curve, np.hstack(bumps), rcond=None)[0]
    return np.asarray(found[beyond])


def higher_of(model: MachineModel, null: Null) -> Higher:
    """Linear in the number of readings, times columns of all components."""
    names = [name for name in null.base.bases if name not in null.base.rough]
    base = base_of(model, null.rows, names)
    of_component = np.array(base.components)
    beyond = {name: slice(DEGREE, base.bases[name].degree) for name in names}
    higher = {name: np.flatnonzero(of_component == name)[beyond[name]] for name in names}
    local = {name: _local(base, name, null.rows, beyond[name]) for name in names}
    return Higher(base=null.base, columns=base.machine, places=higher, local=local)


def roughness_of(higher: Higher, whitening: Whitening, base: Projection) -> Roughness:
    """With the noise of the readings as it is now. base: before causes are known."""
    white = higher.columns.whitened(whitening)  # once for all: what the columns are combined of is the same
    columns = {name: white.take(mine) for name, mine in higher.places.items()}
    every = np.arange(whitening.starts[-1])
    products = {name: base.products(every, one.dense()) for name, one in columns.items()}
    return Roughness(columns, products, higher.local)
