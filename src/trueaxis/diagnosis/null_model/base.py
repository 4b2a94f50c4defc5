"""The saturated base: everything that recalibration could change, so smooth that nothing smooth is left to hunt for.

Every component error is a Legendre curve of degree 12 of its axis, of a higher one where readings show that it is
rougher, every location error is free, and so is what nobody knows of the set-ups of the instruments. The scale and the
alignment of a laser are known to parts in a million, the length of a probe to hundredths: they vary by chance in that.
With parsimonious polynomials structure of a tenth of a micrometre that nobody asks for would count as a discovery.
"""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import block_diag
from scipy.sparse import csr_array, hstack

from trueaxis.diagnosis.null_model.by_run import ByRun, beside, by_run
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.result import BoolArray, FloatArray, IntArray
from trueaxis.error_name import ErrorName
from trueaxis.estimation.curve_prior import SHAPE, CurvePrior
from trueaxis.estimation.instruments import BALL_OF_RUN, CLASSES, STYLUSES, SharedUnknown, own_kinds
from trueaxis.estimation.jacobian import Derivative, derivatives
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.runs import MeasuredRun, measured_runs
from trueaxis.measurement.instrument_kinds import ARM
from trueaxis.model.bases import LegendreBasis
from trueaxis.model.covariance import Covariance
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, home_of
from trueaxis.model.uncertainty import open_steps

DEGREE = 12
ROUGH = 28  # of a curve that is rougher: of nine waves over the travel, which is as rough as pitch tables are
LARGEST = 256.0  # times what [prior] expects of an error: beyond, it is none of a machine
# of errors of the machine, in what [prior] expects of them: values given are nearly right, or zero, or [prior] is wrong
SIZES = (1 / 16, 1 / 4, 1.0, 4.0)
WIDE = 4.0  # times what is expected of errors of the machine: by that factor [prior] may be wrong
PER_UNIT = {"mm": 1.0, "rad": ARM}  # mm of a reading per unit of what is unknown of an instrument
PLACES = 201  # over the travel, at which a curve is looked at
# mm: what an error as large as [prior] has it changes of all readings together, below which it is a lever of the last
# digit of positions; it would be free to be anything, and take up noise
UNFELT = 1e-8
# mm: by which the ball of a set-up, or of a run whose noise nothing tells, may stand elsewhere
ANYWHERE = CLASSES[BALL_OF_RUN].size * CLASSES[BALL_OF_RUN].factor


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Base:
    """Columns in mm, not whitened, of n readings.

    columns: (n, p), per unknown in its unit, see `sizes`: those of the machine, then those of set-ups that
    runs share; of_machine: how many are the machine's; rough: components of higher degrees, see `rough_degree`;
    components: the component error or location error of each of the machine's; units: `mm` or `rad` of each of these;
    expected: (p,), standard deviation of each before anything is measured; sizes: (p,), mm or rad, the units; bases: of
    the curves; by_chance: (n, k), one standard deviation each; shared: the unknowns of the columns of set-ups, then of
    these; own: (n_r, k) of every run with readings; own_kinds: the class of each of these; runs: these runs.
    """

    columns: ByRun
    of_machine: int
    rough: tuple[str, ...]
    components: tuple[str, ...]
    units: Mapping[str, str]
    expected: FloatArray
    sizes: FloatArray
    bases: Mapping[str, LegendreBasis]
    by_chance: FloatArray
    shared: tuple[SharedUnknown, ...]
    own: tuple[FloatArray, ...]
    own_kinds: tuple[tuple[str, ...], ...]
    runs: tuple[MeasuredRun, ...]

    def wide(self, times: float = WIDE) -> FloatArray:
        """(p,): standard deviation of each unknown, in its unit, where errors of the machine may be so many times what
        is expected of them.
        """
        return np.where(np.arange(self.expected.size) < self.of_machine, times, 1.0) * self.expected

    @property
    def free(self) -> tuple[FloatArray, ...]:
        """(n_r, k) of every run: its own unknowns but for its drift and the place of its ball.

        Where each target is read in both directions before the next, a drift of some hundred micrometres and a curve
        against it come to the same as play: a drift that may be as large as that would hide it. So does a ball that
        may stand anywhere in each run hide what circles sense once in a turn: it is free in each set-up, and runs of
        one tell how far it goes between them.
        """
        return self._own_where(lambda kind: not CLASSES[kind].drift and kind != BALL_OF_RUN)

    @property
    def balls(self) -> tuple[FloatArray, ...]:
        """(n_r, 3) of every run by ball bar, (n_r, 0) of others: its readings by the place of its ball, mm per mm."""
        return self._own_where(lambda kind: kind == BALL_OF_RUN)

    @property
    def anywhere(self) -> tuple[FloatArray, ...]:
        """(n_r, k) of every run: its own unknowns but for its drift, its ball free."""
        return tuple(np.hstack(both) for both in zip(self.free, self.balls, strict=True))

    def _own_where(self, kept: Callable[[str], bool]) -> tuple[FloatArray, ...]:
        every = zip(self.own, self.own_kinds, strict=True)
        return tuple(own[:, [kept(kind) for kind in kinds]] for own, kinds in every)

    @property
    def drifts(self) -> tuple[float, ...]:
        """Of every run, mm: one standard deviation of its drift, as large as the factor of its class allows."""
        known = ([CLASSES[kind] for kind in kinds] for kinds in self.own_kinds)
        return tuple(sum(one.size * one.factor * PER_UNIT[one.unit] for one in of if one.drift) for of in known)

    @property
    def machine(self) -> ByRun:
        """(n, of_machine): the machine's own columns."""
        return self.columns.take(slice(self.of_machine))

    def only(self, keep: BoolArray) -> "Base":
        """Of some rows, (n,): a run of which none is kept is none."""
        place = np.cumsum(keep) - 1
        members = zip(self.runs, self.own, self.own_kinds, strict=True)
        kept = [one for one in members if keep[one[0].rows.at].any()]
        return replace(
            self,
            columns=self.columns.only(keep),
            by_chance=self.by_chance[keep],
            own=tuple(own[keep[run.rows.at]] for run, own, _ in kept),
            own_kinds=tuple(kinds for _, _, kinds in kept),
            runs=tuple(_renumbered(run.of(keep[run.rows.at]), place) for run, _, _ in kept),
        )

    def curve(self, name: str, rows: Rows) -> tuple[FloatArray, FloatArray]:
        """Positions (m,) of an error's axis within the readings, and (m, k): the error there, mm or rad, by its
        unknowns in units of what is expected; of a location error no position, and one row.
        """
        mine = np.array(self.components) == name
        if name not in self.bases:
            return np.zeros(0), (self.sizes * self.expected)[: self.of_machine][mine][np.newaxis]
        at = rows.positions[rows.axes.index(ErrorName(name).axis)]
        grid = np.linspace(float(at.min()), float(at.max()), PLACES)
        return grid, self.bases[name](grid).T * (self.sizes * self.expected)[: self.of_machine][mine]


def _renumbered(run: MeasuredRun, place: IntArray) -> MeasuredRun:
    return replace(run, rows=replace(run.rows, at=place[run.rows.at]))


def _few_of_run(parts: Sequence[Derivative]) -> tuple[FloatArray, FloatArray]:
    return block_diag(*(one.by_few for one in parts)), np.vstack([one.others for one in parts])


def base_of(model: MachineModel, rows: Rows, rough: Collection[str] = (), degree: int = DEGREE) -> Base:
    """The base of some rows; dimensions keep the values that the model has.

    degree: of the curves, but for those of rough components.
    """
    dimensions = {name: model.errors.parameters.get(name, 0.0) for name in model.dimensions}
    known = ErrorValues(machine=model.name, parameters=dimensions)
    bare = model.with_values(known)
    observed = Observations(
        source="",
        runs=rows.runs,
        run=rows.run,
        positions=rows.positions,
        reading=rows.reading,
        seq=rows.seq,
        directions=rows.directions.astype(np.int8),
        context=rows.context,
    )
    layout = layout_of(
        bare,
        observed,
        known,
        degree=degree,
        other_degrees={ErrorName(name): rough_degree(rows, name) for name in rough},
    )
    runs = measured_runs(observed)
    parts = [list(derivatives(layout, one.rows)) for one in runs]
    own = tuple(np.vstack([each.own for each in one]) for one in parts)
    kinds = tuple(own_kinds(one.rows.run, layout.straightness[one.rows.index]) for one in runs)
    balls = _balls_of_set_ups(rows, runs)
    of_balls = [_of_balls(balls, one, *of) for one, of in zip(runs, zip(own, kinds, strict=True), strict=True)]
    everything = by_run(beside(map(_few_of_run, parts), of_balls))
    shared = [*layout.shared, *balls]
    chance = np.zeros(layout.of_machine + len(shared), dtype=bool)
    chance[layout.of_machine :] = [unknown.unknown_class.unit == "1" or unknown.kind in STYLUSES for unknown in shared]
    counts = [basis.count for basis in layout.bases]
    weights = [_weights(basis, name in rough) for name, basis in zip(layout.components, layout.bases, strict=True)]
    expected = np.concatenate([*weights, np.ones(int((~chance).sum()) - sum(counts))])
    columns = everything.take(~chance)
    unfelt = np.linalg.norm(columns.weights, axis=0) * expected < UNFELT
    return Base(
        columns=replace(columns, weights=np.where(unfelt, 0.0, columns.weights)),
        of_machine=layout.of_machine,
        rough=tuple(sorted(rough)),
        components=(*np.repeat(layout.components, counts).tolist(), *layout.locations),
        units={name: name.unit for name in layout.components}
        | {name: model.machine.parameter_unit(name) for name in layout.locations},
        expected=expected,
        sizes=np.concatenate([layout.sizes, [one.size for one in balls]])[~chance],
        bases=dict(zip(layout.components, layout.bases, strict=True)),
        by_chance=everything.take(chance).dense(),
        shared=tuple(shared[k] for k in np.argsort(chance[layout.of_machine :], kind="stable")),
        own=own,
        own_kinds=kinds,
        runs=tuple(runs),
    )


def _weights(basis: LegendreBasis, rough: bool) -> FloatArray:
    """(count,): standard deviations expected of a curve. One that readings show to be rough has not the shape that
    [prior] expects, and may be as large at every degree.
    """
    found = np.exp(CurvePrior(basis).log_weights(np.zeros(len(SHAPE)))[0])
    return np.full_like(found, found.max()) if rough else found


def _balls_of_set_ups(rows: Rows, runs: Sequence[MeasuredRun]) -> list[SharedUnknown]:
    """Three of each set-up of a ball bar: machine and bar are set to zero anew for every plane."""
    members: dict[int, list[int]] = {}
    for one in runs:
        if one.instrument == "ballbar":
            members.setdefault(int(rows.mounted[one.rows.at[0]]), []).append(one.rows.index)
    return [
        SharedUnknown(kind=BALL_OF_RUN, of=of, runs=tuple(of_runs), coordinate=k, size=ANYWHERE)
        for of, of_runs in members.items()
        for k in range(3)
    ]


def _of_balls(balls: Sequence[SharedUnknown], run: MeasuredRun, own: FloatArray, kinds: Sequence[str]) -> FloatArray:
    """(n_r, k): the readings of a run by each of them, one standard deviation; own: (n_r, m), its own columns."""
    mine = own[:, np.isin(kinds, BALL_OF_RUN)]
    none = np.zeros(own.shape[0])
    found = [mine[:, one.coordinate] * one.size if run.rows.index in one.runs else none for one in balls]
    return np.column_stack([*found, np.zeros((own.shape[0], 0))])


def rough_degree(rows: Rows, component: str) -> int:
    """Of a rougher curve: no more than one for two positions at which a run was read, or all together, else it would
    follow anything.

    Lines at targets of their own tell such a curve together. On four lines of 15 targets it was out of reach, and what
    a change of 3 um over 60 mm left was called a periodic error of 130 mm.
    """
    at = rows.positions[rows.axes.index(ErrorName(component).axis)]
    of_run = max(np.unique(at[rows.of_run(index)]).size for index in rows.present)
    apart = np.ptp(at) / (2 * ROUGH)  # nearer positions tell no more of the roughest curve than one
    together = np.unique(np.floor((at - at.min()) / apart)).size if apart > 0.0 else 1
    return max(DEGREE, min(ROUGH, max(of_run, together) // 2))


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
            own = base.bases[name]
            at = own.evenly(PLACES)
            curves = (basis(at) - basis(home[model.axes.index(name.axis)])).T @ steps[covariance.rows_of(name)]
            found[names == name] = np.linalg.lstsq(own(at).T, curves, rcond=None)[0]
    start = sum(basis.count for basis in covariance.bases)
    for row, location in enumerate(covariance.locations, start):
        found[names == location] = steps[[row]].toarray()
    found /= (base.sizes * base.expected)[: base.of_machine, np.newaxis]
    return np.asarray(np.linalg.qr(found.T, mode="r")).T
