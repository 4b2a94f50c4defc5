"""Curves that are rougher than the base has them: they compete with the causes for what is left, and have no name.

What a curve of the machine leaves beyond the degree of the base looks most like a cyclic error of a long period, or
like an effect of another axis. Values that are given, and true, leave nothing; those of zero, or of long ago, do.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from trueaxis.diagnosis.causes.scan import LN10
from trueaxis.diagnosis.null_model.base import DEGREE, base_of
from trueaxis.diagnosis.null_model.by_run import ByRun
from trueaxis.diagnosis.null_model.freedom import Freedom
from trueaxis.diagnosis.null_model.null import Null
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.result import FloatArray
from trueaxis.estimation.tails import log_chi2_tail, log_f_tail
from trueaxis.model.model import MachineModel


@dataclass(frozen=True, slots=True)
class Rough:
    """A component whose higher degrees explain readings; evidence, preference: as of a candidate (`scan.Scanned`)."""

    component: str
    evidence: float
    preference: float


@dataclass(frozen=True, slots=True, eq=False)
class Roughness:
    """higher: (n, k) columns, whitened, of the degrees beyond the base of every component that has none of them yet."""

    higher: Mapping[str, ByRun]

    def roughest(self, projection: Projection, values: FloatArray, freedom: Freedom) -> Rough | None:
        """Of what the base, with causes, leaves of the readings, (n,) whitened; None where none explains any of it."""
        left, every = projection.rest(values), np.arange(values.size)
        back, found = projection.rest_transposed(left), []
        for name, columns in self.higher.items():
            combination, k = projection.explaining(every, columns.dense(), left)
            statistic = float(combination @ back)
            if k == 0 or statistic <= 0.0:
                continue
            of_noise = freedom.of(every, combination[:, np.newaxis] * freedom.sigma[:, np.newaxis])
            evidence = -log_f_tail(statistic / k, k, of_noise) / LN10
            found.append(Rough(name, evidence, -log_chi2_tail(statistic, k) / LN10))
        return max(found, key=lambda one: one.preference, default=None)


def roughness_of(model: MachineModel, null: Null) -> Roughness:
    """Linear in the number of readings, times columns of all components."""
    names = [name for name in null.base.bases if name not in null.base.rough]
    base = base_of(model, null.rows, names)
    of_component = np.array(base.components)
    higher = {name: np.flatnonzero(of_component == name)[DEGREE:] for name in names}
    white = base.machine.whitened(null.whitening)  # once for all: what the columns are combined of is the same
    return Roughness({name: white.take(mine) for name, mine in higher.items()})
