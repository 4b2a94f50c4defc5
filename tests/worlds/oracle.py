"""The yardstick: a fit, apart from the package, that knows the true noise, the spreads of the instruments' unknowns and
the sizes of the machine's errors.

Posterior mean and covariance of a linear model with normal priors, y = J a + N b + e. Every component error is a sum
over the basis of its family of curves (curves.BASES), so that for machines whose curves are draws of the prior the fit
is the best there is, and for smooth ones nearly so. Unknowns of one run belong to the covariance of its noise; those
that runs share are unknowns of the fit. The model is made exact by linearising it again at the estimate.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import cholesky, solve_triangular

from tests.worlds.curves import BASES, Basis, Curve
from tests.worlds.design import Design
from tests.worlds.kinematics import sensitivities
from tests.worlds.machine import Array, Indices, Machine
from tests.worlds.readings import exact_readings
from tests.worlds.shop import Unknown
from tests.worlds.truth import Truth, span_of


@dataclass(frozen=True, eq=False)
class Oracle:
    """A design's half of the fit, the same for all machines.

    family: of the curves; q: (n, p), r: (p, p): of the whitened columns; whiteners: per run its rows and the Cholesky
    factor of their noise; spreads: (s,), of the unknowns that runs share.
    """

    design: Design
    family: str
    q: Array
    r: Array
    whiteners: tuple[tuple[Indices, Array], ...]
    spreads: Array

    def fit(self, sizes: Mapping[str, float], reading: Array, iterations: int = 1) -> "Fit":
        """sizes: name of each component error and location error -> mm or rad; reading: (n,), mm; iterations: how often
        the model is linearised again.
        """
        machine = self.design.machine
        scale = np.concatenate([prior_scale(machine, self.family, sizes), self.spreads])
        stacked = np.vstack([self.r * scale, np.eye(len(scale))])
        q, r = np.linalg.qr(stacked)
        spread = scale[:, None] * solve_triangular(r, np.eye(len(scale)))  # (p, p), a factor of the covariance
        measured = reading - self.design.jacobian.ideal
        found, chi2 = self._solve(q, spread, measured)
        for _ in range(iterations):
            beyond = self._beyond_first_order(found, sizes)
            found, chi2 = self._solve(q, spread, measured - beyond)
        count = sum(len(rows) for rows, _ in self.whiteners)
        return Fit(machine, self.family, found, spread, float(np.sqrt(chi2 / count)), sizes)

    def _solve(self, q: Array, spread: Array, measured: Array) -> tuple[Array, float]:
        """Posterior mean, and what the data cost: expected to be the number of readings."""
        white = self.whitened(measured)
        z = self.q.T @ white
        fitted = q[: len(z)].T @ z
        return spread @ fitted, float(white @ white - fitted @ fitted)

    def _beyond_first_order(self, found: Array, sizes: Mapping[str, float]) -> Array:
        """Exact readings less the linear ones, of the estimated machine."""
        machine, jac = self.design.machine, self.design.jacobian
        guess = machine_of(machine, self.family, found, sizes)
        linear = jac.ideal.copy()
        for name, curve in guess.curves.items():
            axis = name[2]
            linear += jac.here[name] * curve(jac.at[axis]) - jac.home[name] * curve(jac.at_home[axis])
        for name, value in guess.located.items():
            linear += jac.located[name] * value
        return np.asarray(exact_readings(self.design, [guess])[0] - linear, float)

    def whitened(self, values: Array) -> Array:
        """(k,) or (k, p): values of the good rows, of unit noise."""
        return np.concatenate([solve_triangular(low, values[rows], lower=True) for rows, low in self.whiteners])


@dataclass(frozen=True, eq=False)
class Fit:
    """mean: (p,), of coefficients, location errors and shared unknowns; spread: (p, p), covariance = spread spread';
    whitened_rms: 1 where the model is right.
    """

    machine: Machine
    family: str
    mean: Array
    spread: Array
    whitened_rms: float
    sizes: Mapping[str, float]

    def predict(
        self, positions: Mapping[str, Array], tool_point: Array, datum: str = "machine", columns: Array | None = None
    ) -> tuple[Array, Array]:
        """Deviation of the tool point and its standard uncertainty, (n, 3) each, mm; as Truth.deviation.

        columns: of `prediction_columns` at these positions, which all machines of a design share.
        """
        mean = machine_of(self.machine, self.family, self.mean, self.sizes).deviation(positions, tool_point, datum)
        change = columns
        if change is None:
            change = prediction_columns(self.machine, self.family, positions, tool_point, datum)
        used = change.shape[2]
        return mean, np.sqrt(np.sum((change @ self.spread[:used]) ** 2, axis=2))


def oracle(design: Design, family: str = "smooth") -> Oracle:
    """family: of the curves of the machines, `smooth` or `prior`."""
    machine, plan, shop, jac = design.machine, design.plan, design.shop, design.jacobian
    blocks = [jac.columns(name, _basis(machine, family, name)) for name in machine.components]
    blocks += [jac.located[name][:, None] for name in machine.locations]
    shared = [unknown for unknown in shop.unknowns if len(set(plan.run[unknown.rows].tolist())) > 1]
    for unknown in shared:
        column = np.zeros((plan.count, 1))
        column[unknown.rows, 0] = unknown.column
        blocks.append(column)
    whiteners = tuple(_whiteners(design))
    half = Oracle(design, family, np.zeros((0, 0)), np.zeros((0, 0)), whiteners, np.array([u.spread for u in shared]))
    q, r = np.linalg.qr(half.whitened(np.hstack(blocks)))
    if len(r) < r.shape[1]:  # fewer readings than unknowns
        q, r = np.pad(q, ((0, 0), (0, r.shape[1] - q.shape[1]))), np.pad(r, ((0, r.shape[1] - len(r)), (0, 0)))
    return Oracle(design, family, q, r, whiteners, half.spreads)


def _whiteners(design: Design) -> list[tuple[Indices, Array]]:
    """Per run: its rows without outliers, and the factor of their covariance with the run's own unknowns in it."""
    plan, shop = design.plan, design.shop
    own: dict[int, list[Unknown]] = {}
    for unknown in shop.unknowns:
        runs = set(plan.run[unknown.rows].tolist())
        if len(runs) == 1:
            own.setdefault(runs.pop(), []).append(unknown)
    found = []
    for index in range(len(plan.runs)):
        rows = plan.rows(index)
        covariance = shop.covariance(plan, index)
        for unknown in own.get(index, []):
            covariance = covariance + unknown.spread**2 * np.outer(unknown.column, unknown.column)
        good = ~np.isin(rows, shop.outliers)
        if good.any():
            found.append((rows[good], cholesky(covariance[np.ix_(good, good)], lower=True)))
    return found


def _basis(machine: Machine, family: str, component: str) -> Basis:
    return BASES[family](span_of(machine, component[2]))


def _orders(machine: Machine, family: str) -> int:
    """Coefficients of a curve."""
    axis = machine.axes[0]
    return int(BASES[family](span_of(machine, axis))(np.array([machine.home(axis)])).shape[1])


def prior_scale(machine: Machine, family: str, sizes: Mapping[str, float]) -> Array:
    """Standard deviations of all coefficients, then of the location errors."""
    each = [np.full(_orders(machine, family), sizes[name]) for name in machine.components]
    return np.concatenate([*each, [sizes[name] for name in machine.locations]])


def machine_of(machine: Machine, family: str, found: Array, sizes: Mapping[str, float]) -> Truth:
    """The machine of an estimate."""
    orders, curves = _orders(machine, family), {}
    for number, name in enumerate(machine.components):
        curves[name] = Curve(_basis(machine, family, name), found[number * orders : (number + 1) * orders])
    start = orders * len(machine.components)
    located = {name: float(found[start + number]) for number, name in enumerate(machine.locations)}
    return Truth(machine, curves, located, sizes, family)


def prediction_columns(
    machine: Machine, family: str, positions: Mapping[str, Array], tool_point: Array, datum: str = "machine"
) -> Array:
    """Change of the deviation per coefficient and location error, (n, 3, p), to first order."""
    change = sensitivities(machine, "tool", "workpiece", positions, tool_point)
    blocks = []
    for name in machine.components:
        basis = _basis(machine, family, name)(positions[name[2]])
        blocks.append(change[name][:, :, None] * basis[:, None, :])
    blocks += [change[name][:, :, None] for name in machine.locations]
    found = np.concatenate(blocks, axis=2)
    if datum == "home":  # where all curves are zero
        home = {axis: np.array([machine.home(axis)]) for axis in machine.axes}
        found = found - prediction_columns(machine, family, home, tool_point)
    return found


@dataclass(frozen=True)
class Figures:
    """Over machines, points and coordinates: root mean squares of the true deviation, of the error of the prediction
    and of its u, um; share of the errors within 1.96 u; true deviation and error relative to the tool point at home,
    where work offsets are touched off; whitened RMS of the readings.
    """

    true_um: float
    error_um: float
    u_um: float
    coverage: float
    home_true_um: float
    home_error_um: float
    whitened: float


def figures(fits: Sequence[Fit], truths: Sequence[Truth], positions: Mapping[str, Array], tool_point: Array) -> Figures:
    """How good fits are at positions such as those of `random_points`."""
    true = [truth.deviation(positions, tool_point) for truth in truths]
    # the machines are of one design: what a prediction changes by is the same for all
    there, home = (
        prediction_columns(fits[0].machine, fits[0].family, positions, tool_point, datum)
        for datum in ("machine", "home")
    )
    predicted = [fit.predict(positions, tool_point, columns=there) for fit in fits]
    error = [mean - own for (mean, _), own in zip(predicted, true, strict=True)]
    u = [spread for _, spread in predicted]
    home_true = [truth.deviation(positions, tool_point, "home") for truth in truths]
    home_error = [
        fit.predict(positions, tool_point, "home", home)[0] - own for fit, own in zip(fits, home_true, strict=True)
    ]
    return Figures(
        _rms_um(true),
        _rms_um(error),
        _rms_um(u),
        float((np.abs(np.array(error)) <= 1.96 * np.array(u)).mean()),
        _rms_um(home_true),
        _rms_um(home_error),
        float(np.sqrt(np.mean([fit.whitened_rms**2 for fit in fits]))),
    )


def _rms_um(values: Sequence[Array]) -> float:
    """Of a coordinate of vectors (..., 3), mm."""
    return 1e3 * float(np.sqrt(np.mean(np.array(values) ** 2)))
