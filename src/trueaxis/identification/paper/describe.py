"""The report of the point-by-point method: blocks, values, and what is open, in words."""

from collections.abc import Sequence

import numpy as np

from trueaxis.estimation.machine import lever, units
from trueaxis.identification.paper.grid import IntArray, points_remark
from trueaxis.identification.paper.solution import PaperResult, sloped
from trueaxis.identification.paper.squareness import LinesFromAngles, covered
from trueaxis.identification.paper.steps import SolvedStep
from trueaxis.identification.report import BlockReport, ComponentReport, Known, LocationReport
from trueaxis.identification.words import Share, enumerated, only_slope, split_apart, together
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.errors import Undetermined

RULES = {
    "from-angles": "from the yaw and pitch curves (Sect. 3.6)",
    "convention": "least-squares lines of the straightness are level (ISO 230-1)",
    "known": "given",
}

FROM_ANGLES = (
    "squareness from the angles (Eqs. (39)-(43)) is wrong in general: it does not follow from pitch and yaw, and the "
    "printed sums and signs are not right either (docs/errata.md, E28 to E32); --squareness convention is right"
)
SMALLEST_LEAD = 1e-6
ROUNDING = 1e-9


def lever_of(result: PaperResult) -> float:
    """The length that rotations are scaled with, mm."""
    return lever(result.machine)


def blocks(result: PaperResult) -> tuple[BlockReport, ...]:
    """The steps in the order in which they were solved."""
    return tuple(
        BlockReport(
            runs=_runs(result, solved),
            components=tuple(result.grid.components[c] for c in solved.step.components),
            equations=solved.cells.size,
            unknowns=solved.nodes.size,
            rank=solved.inverse.rank,
            condition=solved.inverse.condition,
            remark=_remark(result, solved),
        )
        for solved in result.steps.steps
    )


def locations(result: PaperResult) -> tuple[LocationReport, ...]:
    """Values of the location errors and where they come from."""
    found = []
    unit = units(result.machine)[len(result.machine.components) :]
    has_rule = covered(result.rule)
    for index, name in enumerate(result.machine.location_errors):
        origin = RULES[result.options.squareness] if has_rule[index] else "taken as zero: no rule gives it"
        u = None if result.u_locations is None else _number(result.u_locations[index])
        if not result.free[index]:
            origin, u = "given", None
        elif result.response.open_locations[index]:
            origin += ", from errors that are undetermined"
        found.append(
            LocationReport(
                name=name, value=float(result.solution.locations[index]), u=u, unit=unit[index], origin=origin
            )
        )
    return tuple(found)


def components(result: PaperResult) -> tuple[ComponentReport, ...]:
    """Largest value and uncertainty of each component over the measured positions."""
    found = []
    by_rule = isinstance(result.rule, LinesFromAngles)
    for index, name in enumerate(result.grid.components):
        nodes = result.grid.nodes(index)
        nodes = nodes[result.steps.reached[nodes]]
        opened = result.response.open_nodes[nodes]
        known: Known = "determined"
        if name in result.given.motion_errors:
            known = "given"
        elif nodes.size == 0:
            known = "not measured"
        elif opened.any():
            known = "undetermined" if opened.all() else "partly"
        elif by_rule and sloped(result.response, result.free)[nodes].any():
            known = "up to a slope"
        u = None
        if result.u_nodes is not None and not opened.all():
            u = _number(np.max(result.u_nodes[nodes][~opened], initial=0.0))
        largest = float(np.max(np.abs(result.solution.nodes[nodes]), initial=0.0))
        found.append(ComponentReport(name=name, known=known, largest=largest, u=u, unit=name.unit))
    return tuple(found)


def undetermined(result: PaperResult) -> tuple[Undetermined, ...]:
    """Everything that the readings leave open, and what was done about it."""
    found = [_singular(result, solved) for solved in result.steps.steps if solved.null_columns]
    found += _consequences(result, found)
    found += [_gone_along(result, index) for index in range(len(result.machine.location_errors))]
    missing = [part.name for part in components(result) if part.known == "not measured"]
    if missing:
        found.append(Undetermined(f"{enumerated(missing)}: no run holds them, they are left at zero", tuple(missing)))
    return tuple(found)


def _singular(result: PaperResult, solved: SolvedStep) -> Undetermined:
    """A step with fewer values than unknowns."""
    grid = result.grid
    null = result.steps.null[:, list(solved.null_columns)]
    mine = np.zeros(grid.count, dtype=bool)
    mine[solved.nodes] = True
    own = null.tocsr()[solved.nodes].toarray()
    names = [grid.components[c] for c in solved.step.components]
    taking_part = [name for name in names if (own[_of(result, solved.nodes, name)] != 0.0).any()]
    ranks = enumerated(
        [f"{rank} equations for {count} unknowns" for rank, count in solved.inverse.ranks if rank < count]
    )
    basis, _ = reduced(own)
    shares = _shares(result, solved.nodes, basis[:, 0] * result.equations.node_scale[solved.nodes])
    text = (
        f"{enumerated(taking_part)} at {_places(result, solved)}: {ranks}, in runs {enumerated(_runs(result, solved))}"
        f"{_in_brackets(_remark(result, solved))}; at {shares[1]}, for one, {together(shares[0])} changes none of these"
        " readings; the solution of least norm is given"
    )
    return Undetermined(text, tuple(taking_part))


def _consequences(result: PaperResult, singular: list[Undetermined]) -> list[Undetermined]:
    """Components of later steps that rest on what is open."""
    named = {name for one in singular for name in one.parameters}
    opened = result.response.open_nodes
    counts = {
        name: int(np.count_nonzero(opened[result.grid.nodes(index)]))
        for index, name in enumerate(result.grid.components)
        if name not in named
    }
    resting = {name: count for name, count in counts.items() if count}
    located = [
        name
        for name, is_open in zip(result.machine.location_errors, result.response.open_locations, strict=True)
        if is_open
    ]
    if not resting and not located:
        return []
    parts = [f"{name} (at {count} positions)" for name, count in resting.items()] + located
    text = f"{enumerated(parts)}: found from undetermined values above, and as undetermined as these"
    return [Undetermined(text, (*resting, *located))]


def _gone_along(result: PaperResult, index: int) -> Undetermined:
    """A location error and the components that can take its place in all readings."""
    name = result.machine.location_errors[index]
    origin = locations(result)[index].origin
    unit = units(result.machine)[len(result.machine.components) + index]
    along = np.asarray(result.response.along[:, [index]].todense()).ravel()
    seen = result.equations.located[:, [index]].toarray().ravel() * 1.0
    scaled = along / result.equations.node_scale * result.equations.location_scale[index]
    held = np.unique(np.concatenate([step.cells for step in result.steps.steps] or [np.zeros(0, dtype=np.int64)]))
    left = np.abs(seen + result.equations.nodes @ scaled)[held]
    if left.size and left.max() > 1e-9 * max(1.0, float(np.abs(seen).max())):
        text = f"{name}: surplus readings would determine it, which this method does not use (--method global does)"
        return Undetermined(f"{text}; {origin}", (name,))
    if not along.any():
        return Undetermined(f"{name}: no reading that was used holds it; {origin}", (name,))
    shares, partners = [Share(name, 1.0, unit)], []
    for component_index, component in enumerate(result.grid.components):
        nodes = result.grid.nodes(component_index)
        nodes = nodes[result.steps.reached[nodes]]
        if nodes.size == 0 or np.abs(scaled[nodes]).max() < 1e-9:
            continue
        axis = result.grid.axis[component_index]
        knots = result.grid.knots[axis]
        slope = only_slope(
            knots[nodes - result.grid.offset[component_index]], along[nodes], float(knots[result.grid.reference[axis]])
        )
        partners.append(component)
        if slope is None:
            far = int(np.abs(along[nodes]).argmax())
            shares.append(Share(f"the curve of {component}", float(along[nodes][far]), component.unit))
        else:
            shares.append(Share(component, slope, component.slope_unit))
    text = f"{split_apart([name], partners, shares)}; {name}: {origin}"
    return Undetermined(text, (name, *partners))


def _shares(result: PaperResult, nodes: IntArray, vector: FloatArray) -> tuple[list[Share], str]:
    """One null vector, per rad or mm of its largest part, and where it acts."""
    taking_part = np.flatnonzero(vector)
    component = result.grid.component_of(nodes[taking_part])
    lead = int(np.abs(vector[taking_part] / result.equations.node_scale[nodes[taking_part]]).argmax())
    shares = [
        Share(
            result.grid.components[component[i]],
            float(vector[taking_part[i]] / vector[taking_part[lead]]),
            result.grid.components[component[i]].unit,
        )
        for i in [lead, *(i for i in range(taking_part.size) if i != lead)]
    ]
    where = dict.fromkeys(
        f"{result.grid.components[c].axis} = {result.grid.position_of(int(nodes[i])):g}"
        for c, i in zip(component, taking_part, strict=True)
    )
    return shares, ", ".join(where)


def _places(result: PaperResult, solved: SolvedStep) -> str:
    component = result.grid.component_of(solved.nodes)
    axes = dict.fromkeys(result.grid.components[c].axis for c in component)
    knots = {
        axis: len({result.grid.position_of(int(node)) for node in solved.nodes if _axis(result, node) == axis})
        for axis in axes
    }
    return enumerated([f"{count} positions of {axis}" for axis, count in knots.items()])


def _axis(result: PaperResult, node: int) -> str:
    return result.grid.components[int(result.grid.component_of(np.array([node]))[0])].axis


def _of(result: PaperResult, nodes: IntArray, name: str) -> IntArray:
    return np.flatnonzero(result.grid.component_of(nodes) == result.grid.components.index(name))


def _runs(result: PaperResult, solved: SolvedStep) -> tuple[str, ...]:
    return tuple(result.observed.runs[run].id for run in solved.step.runs)


def _remark(result: PaperResult, solved: SolvedStep) -> str:
    if solved.inverse.rank == solved.nodes.size:
        return ""
    return points_remark([result.observed.runs[run] for run in solved.step.runs]) or (
        "" if solved.step.closed else "too few runs hold these components"
    )


def _in_brackets(remark: str) -> str:
    return f" ({remark})" if remark else ""


def _number(value: float) -> float | None:
    return None if np.isnan(value) else float(value)


def reduced(null: FloatArray, first: Sequence[int] = (), rounding: float = ROUNDING) -> tuple[FloatArray, int]:
    """The same space (n, d) with another basis: reduced echelon form of the transpose; entries below
    `rounding` times the largest are set to zero.

    first: rows that are to lead a basis vector each where they can; then the largest entry left leads the next one.
    Returns the basis, each vector 1 at its lead and 0 at the others', and how many of `first` lead one.
    """
    rows = null.T.copy()
    led = 0
    for column in first:
        if led < rows.shape[0]:
            row = led + int(np.abs(rows[led:, column]).argmax())
            if abs(rows[row, column]) >= SMALLEST_LEAD:
                _lead(rows, led, row, column)
                led += 1
    for place in range(led, rows.shape[0]):
        row, column = divmod(int(np.abs(rows[place:]).argmax()), rows.shape[1])
        _lead(rows, place, place + row, column)
    rows[np.abs(rows) < rounding * np.abs(rows).max(initial=0.0)] = 0.0
    return rows.T, led


def _lead(rows: FloatArray, place: int, row: int, column: int) -> None:
    """Let the row lead at the column, as the row of that place."""
    rows[[place, row]] = rows[[row, place]]
    rows[place] /= rows[place, column]
    others = np.delete(np.arange(rows.shape[0]), place)
    rows[others] -= np.outer(rows[others, column], rows[place])
