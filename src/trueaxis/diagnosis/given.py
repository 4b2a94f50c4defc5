"""How uncertain the values given are, as the base has errors of the machine."""

import numpy as np
from scipy.sparse import csr_array, hstack

from trueaxis.diagnosis.base import PLACES, Base
from trueaxis.diagnosis.result import FloatArray
from trueaxis.model.covariance import Covariance
from trueaxis.model.model import MachineModel
from trueaxis.model.uncertainty import home_of, open_steps


def given_by_chance(model: MachineModel, base: Base, covariance: Covariance) -> FloatArray:
    """(of_machine, k): independent deviations of the values given from true ones, each one standard deviation, in units
    of what is expected. What nothing determined may be as large as [prior] has it.
    """
    opened = open_steps(model.machine, covariance)
    root = csr_array((covariance.count, 0)) if covariance.root is None else csr_array(covariance.root)
    steps = csr_array(hstack([root, csr_array(opened)]))  # one step for each value of a table
    names, found = np.array(base.components), np.zeros((base.of_machine, steps.shape[1]))
    home = home_of(model)
    for name, basis in zip(covariance.components, covariance.bases, strict=True):
        if name in base.bases:
            at, own = np.linspace(*model.travel[name.axis], PLACES), base.bases[name]
            curves = (basis(at) - basis(home[model.axes.index(name.axis)])).T @ steps[covariance.rows_of(name)]
            found[names == name] = np.linalg.lstsq(own(at).T, curves, rcond=None)[0]
    start = sum(basis.count for basis in covariance.bases)
    for row, location in enumerate(covariance.locations, start):
        found[names == location] = steps[[row]].toarray()
    found /= (base.sizes * base.expected)[: base.of_machine, np.newaxis]
    return np.asarray(np.linalg.qr(found.T, mode="r")).T
