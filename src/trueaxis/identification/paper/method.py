"""`identify --method paper`: from readings to tables of every component, step by step, with their covariance."""

from dataclasses import replace

import numpy as np
from scipy.sparse import csr_array, vstack

from trueaxis.estimation.effects.faults import check_columns
from trueaxis.estimation.effects.signature import added_by, all_rows, ground_of
from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.estimation.observations import Observations, copied_runs
from trueaxis.identification.fit_quality import (
    FitQuality,
    NotConvergedError,
    Residuals,
    expected_sizes,
    quality,
    stands_still,
)
from trueaxis.identification.notes import alignment_notes, dimension_notes, weak_notes
from trueaxis.identification.paper import describe
from trueaxis.identification.paper.grid import BoolArray, Cells, IntArray, equations, grid_and_cells
from trueaxis.identification.paper.solution import (
    Exact,
    Noise,
    PaperOptions,
    PaperResult,
    Response,
    Solution,
    natural,
    noise,
    sloped,
    solve,
    tables,
    with_rule,
)
from trueaxis.identification.paper.squareness import LinesFromAngles, Squareness, covered, squareness_rule
from trueaxis.identification.paper.steps import RANK_TOLERANCE, Steps, solve_steps, steps_in_order
from trueaxis.identification.repeat_noise import noise_of_repeats
from trueaxis.identification.report import CurveOrderReport, Identification, IdentificationReport
from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.bases import HatBasis, unmeasured_basis
from trueaxis.model.covariance import Covariance
from trueaxis.model.effect_values import identity
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel


def identify_paper(
    machine: IdentifiedMachine, observed: Observations, options: PaperOptions | None = None
) -> Identification:
    """Identify the way of Sects. 3.2-3.6 of the paper.

    machine: its own error values do not matter. Effects of known values are taken off the readings. Raises InputError
    where the machine has effects of unknown values, where no run can be used, and where a run visits a position of an
    axis at which what it needs was not measured before; NotConvergedError where the solution does not stand still.
    """
    options = options or PaperOptions()
    given = options.known or ErrorValues(machine=machine.name)
    given = replace(given, u={}, undetermined=())
    observed = _without_effects(machine.with_values(given), observed, given)
    bare = replace(given, effects=())
    machine = machine.with_values(bare)
    usable, left_out = _usable(observed)
    grid, cells = grid_and_cells(machine, usable)
    given_components = np.array([name in given.motion_errors for name in machine.components], dtype=bool)
    free = np.array([name not in given.parameters for name in machine.location_errors], dtype=bool)
    system = equations(machine, usable, grid, cells, given_components)
    order = steps_in_order(system, grid, cells, len(usable.runs))
    steps = solve_steps(order, system, grid, cells, usable)
    rule = squareness_rule(
        options.squareness, machine, grid, steps.reached, free, _of_free(natural(steps, system)[1], free)
    )
    response = with_rule(steps, system, rule)
    solution = solve(Exact(machine=machine, given=bare, observed=usable, grid=grid, cells=cells), response, rule)
    found, rms = _noise(steps, cells, solution, options.noise_um)
    judged = _quality(machine, usable, cells, solution, (found, options.noise_um))
    variances = response.variances(cells)
    if not stands_still(solution.step / response.node_scale, np.sqrt(variances[0]) / response.node_scale, found.sigma):
        raise NotConvergedError(judged.runs, solution.iterations)
    u_nodes, u_locations = _uncertainty(response, variances, rule, found, free)
    result = PaperResult(
        machine=machine, observed=usable, left_out=left_out, given=given, options=options, grid=grid, cells=cells,
        equations=system, steps=steps, response=response, rule=rule, free=free, solution=solution, noise=found,
        u_nodes=u_nodes, u_locations=u_locations, residual_rms=rms, quality=judged,
    )  # fmt: skip
    return _identification(result)


def _usable(observed: Observations) -> tuple[Observations, tuple[str, ...]]:
    """Displacements of lasers and probes: a ball bar senses no fixed direction, its equations are of no others."""
    others = [index for index, run in enumerate(observed.runs) if run.instrument not in ("laser", "probe")]
    keep = np.flatnonzero(~np.isin(observed.run, others))
    left_out = tuple(observed.runs[index].id for index in others)
    if keep.size == 0:
        problem = "the point-by-point method needs laser or probe readings, and there are none"
        raise InputError([Fault(observed.source, "", problem, "use --method global")])
    return observed.of(keep), left_out


def _of_free(along: csr_array, free: BoolArray) -> FloatArray:
    """(n_nodes, n_location_errors): given location errors move nothing."""
    dense = np.asarray(along.toarray(), dtype=np.float64)
    dense[:, ~free] = 0.0
    return dense


def _noise(steps: Steps, cells: Cells, solution: Solution, given_um: float | None) -> tuple[Noise, float]:
    """The noise, and the rms of the residuals (mm) of the readings that stand in steps."""
    used = np.unique(np.concatenate([step.cells for step in steps.steps])) if steps.steps else np.zeros(0, dtype=int)
    squares = float(cells.repeats[used] @ solution.residual[used] ** 2 + cells.scatter[used].sum())
    readings = int(cells.repeats[used].sum())
    rank = sum(step.inverse.rank for step in steps.steps)
    return noise(squares, readings, rank, given_um), float(np.sqrt(squares / max(readings, 1)))


def _quality(
    machine: IdentifiedMachine,
    observed: Observations,
    cells: Cells,
    solution: Solution,
    noise: tuple[Noise, float | None],
) -> FitQuality:
    """noise: that of the fit, and what was given, um."""
    found, given_um = noise
    known, freedom = np.full(cells.run.size, np.nan if given_um is None else given_um * 1e-3), dict[int, float]()
    if given_um is None:
        sigma, of_repeats = noise_of_repeats(observed)
        of_run = dict(zip(observed.run.tolist(), sigma.tolist(), strict=True))
        known = np.array([of_run[run] for run in cells.run.tolist()])
        freedom = dict(zip(observed.run.tolist(), of_repeats.tolist(), strict=True))
    squares = cells.repeats * solution.residual**2 + cells.scatter
    size = expected_sizes(machine, observed.runs, cells.run, cells.positions)
    copied = tuple(copied_runs(observed).tolist()) if given_um is None else ()
    return quality(
        Residuals(
            run=cells.run,
            count=cells.repeats,
            squares=squares,
            noise=known,
            size=size,
            freedom=found.freedom,
            copied=copied,
            stated=() if given_um is None else tuple(np.unique(cells.run).tolist()),
            noise_freedom={run: of for run, of in freedom.items() if of > 0.0},
        ),
        observed.runs,
    )


def _uncertainty(
    response: Response, variances: tuple[FloatArray, FloatArray], rule: Squareness, found: Noise, free: BoolArray
) -> tuple[FloatArray | None, FloatArray | None]:
    if found.sigma is None:
        return None, None
    nodes, locations = (found.sigma * np.sqrt(variance) for variance in variances)
    opened = response.open_nodes
    locations[response.open_locations | ~covered(rule)] = np.nan
    if isinstance(rule, LinesFromAngles):
        # The rule is no measurement of the squareness: how far it is off is not a matter of noise.
        locations[free] = np.nan
        opened = opened | sloped(response, free)
    return np.where(opened, np.nan, nodes), locations


def _identification(result: PaperResult) -> Identification:
    grid, machine = result.grid, result.machine
    curves = tables(grid, result.solution.nodes, result.steps.reached, result.u_nodes)
    found = describe.components(result)
    notes = weak_notes(found)
    notes += alignment_notes(result.machine, result.observed)
    if result.options.squareness == "from-angles":
        notes += (describe.FROM_ANGLES,)
    orders: tuple[CurveOrderReport, ...] = ()
    covariance = _covariance_of(result)
    if result.options.curves != "table":
        # statsmodels takes long to import
        from trueaxis.identification.curve_fit import in_polynomials, ordered_curves  # noqa: PLC0415

        tabled = curves
        curves, more, orders = ordered_curves(tabled, result.options.curves)
        covariance = in_polynomials(covariance, tabled, curves)
        notes += more
    undetermined = describe.undetermined(result)
    located = dict(zip(machine.location_errors, result.solution.locations.tolist(), strict=True))
    u = {}
    if result.u_locations is not None:
        pairs = zip(machine.location_errors, result.u_locations.tolist(), strict=True)
        u = {name: value for (name, value), free in zip(pairs, result.free, strict=True) if free}
    values = ErrorValues(
        machine=machine.name,
        parameters={**result.given.parameters, **located},
        motion_errors={**curves, **result.given.motion_errors},
        u=u,
        undetermined=undetermined,
        effects=result.given.effects,
        fit=result.quality.fit,
    )
    report = IdentificationReport(
        machine=machine.name,
        method="paper",
        squareness=describe.RULES[result.options.squareness],
        readings=result.cells.readings,
        left_out=result.left_out,
        lever=describe.lever_of(result),
        rank_tolerance=RANK_TOLERANCE,
        blocks=describe.blocks(result),
        iterations=result.solution.iterations,
        last_change=result.solution.change,
        residual_rms_um=result.residual_rms * 1e3,
        freedom=result.noise.freedom,
        noise_um=result.noise.um,
        noise_origin=result.noise.origin,
        locations=describe.locations(result),
        components=found,
        undetermined=undetermined,
        quality=result.quality,
        notes=notes,
        curve_orders=orders,
        caveats=dimension_notes(machine, result.given),
    )
    return Identification(values, report, covariance)


def _covariance_of(result: PaperResult) -> Covariance:
    """Of the tables of every component that was found, zero nodes included, and of the location errors.

    Open are the combinations that no step sees, and each location error with the curves that can take its place: the
    rule that chooses among these is no measurement, and matters where it moves the tool.
    """
    grid, response, machine = result.grid, result.response, result.machine
    kept = result.steps.reached | grid.fixed
    names, bases, rows = [], [], []
    for index, name in enumerate(grid.components):
        nodes = grid.nodes(index)
        if name in result.given.motion_errors or not result.steps.reached[nodes].any():
            continue
        nodes = nodes[kept[nodes]]
        names.append(name)
        bases.append(HatBasis(tuple(grid.knots[grid.axis[index]][nodes - grid.offset[index]].tolist())))
        rows.append(nodes)
    order = np.concatenate([*rows, np.zeros(0, dtype=np.int64)])
    free = np.flatnonzero(result.free)
    root = None
    if result.noise.sigma is not None:
        nodes_by_cell = (response.nodes + response.along @ csr_array(response.located))[order]
        by_cell = vstack([nodes_by_cell, csr_array(response.located[free])], format="csr")
        root = csr_array(by_cell.multiply(result.noise.sigma / np.sqrt(result.cells.repeats)[np.newaxis]))
    unmeasured = [name for name in grid.components if name not in names and name not in result.given.motion_errors]
    found = Covariance(
        machine=machine.name,
        components=tuple(names),
        bases=tuple(bases),
        locations=tuple(machine.location_errors[index] for index in free),
        root=root,
        open=_open(result, order, free),
        of_prior=0,
    )
    return found.with_open_components({name: unmeasured_basis(machine.travel, name) for name in unmeasured})


def _open(result: PaperResult, order: IntArray, free: IntArray) -> FloatArray:
    """(n_values, d): what no step sees, then each free location error with the nodes that go along with it."""
    response = result.response
    unseen = np.vstack([response.null.toarray()[order], response.null_located[free]])
    along = np.vstack([response.along.toarray()[np.ix_(order, free)], np.eye(free.size)])
    return np.hstack([unseen, along])


def _without_effects(machine: IdentifiedMachine, observed: Observations, given: ErrorValues) -> Observations:
    """The readings less what effects of known values add to them.

    Raises InputError where the machine has effects of unknown values: a table of one component tells nothing of them;
    and where the readings lack a column that an effect depends on.
    """
    if not isinstance(machine, MachineModel) or not machine.effects:
        return observed
    faults = Faults(observed.source)
    known = {identity(one.effect) for one in given.effects}
    for effect in machine.effects:
        if identity(effect) not in known:
            problem = f"the machine has the effect {effect.label}, whose values the point-by-point method cannot find"
            faults.add("", problem, "use --method global, or give its values with --known")
    faults.raise_if_any()
    ground = ground_of(machine, observed)
    pairs = [(effect, machine.kinds[effect.kind]) for effect in machine.effects]
    check_columns(ground, pairs, all_rows(observed, ground))
    ground = ground_of(machine, replace(observed, context=ground.context.filled()))
    return replace(observed, reading=observed.reading - added_by(ground, given.effects))
