"""[[effect_kind]]: kinds of effects that a spec adds to the library.

Their expressions are checked: names, form, and that there is a value wherever it is needed.
"""

import math
import re
from collections.abc import Iterable, Sequence

from trueaxis.effects.evaluate import is_linear, sampled_parameters, sampled_positions, undefined_at
from trueaxis.effects.expression import FUNCTIONS, Expression, ExpressionError, names, parse
from trueaxis.effects.kind import Kind, Parameter
from trueaxis.effects.library import ALL_DIRECTIONS, BY_NAME
from trueaxis.effects.placement import VARIABLES, variables_of
from trueaxis.error_name import ErrorName
from trueaxis.machine.body import PROSE, PROSE_MEANING
from trueaxis.machine.fields import Fields, shown
from trueaxis.machine.machine import AXES, Body
from trueaxis.machine.structure import taken_for

MOST_KINDS = 20
MOST_PARAMETERS = 6
MOST_GRIDS = 2
LARGEST_GRID = 100  # values of one parameter
LARGEST_SEARCH = 1000  # combinations of values of all
_NAME = re.compile(r"[a-z][a-z0-9_]{0,39}")
_PARAMETER = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,39}")
_UNIT = r"(1|{0})([*/]{0})*".format(r"(u|axis|mm|deg|rad|s|K)(\^[2-9])?")
_UNIT_MEANING = (
    "units u (of the component), axis (of its axis), mm, deg, rad, s, K or 1, joined by * and /, such as u/K"
)


def read_effect_kinds(top: Fields, bodies: Sequence[Body] | None) -> tuple[Kind, ...]:
    """The machine's own kinds; complains of every fault. bodies: None while they are in doubt."""
    found: dict[str, Kind] = {}
    for index, fields in enumerate(top.tables("effect_kind")):
        if index == MOST_KINDS:
            top.fault("effect_kind", "has too many tables", f"{MOST_KINDS} kinds at most")
            break
        kind = _read_kind(fields, bodies)
        if kind.name in BY_NAME:
            fields.fault("name", f"{kind.name!r} is a kind of the library", "another name")
        elif kind.name in found:
            fields.fault("name", f"there is another kind {kind.name!r}", "a name of its own")
        elif kind.name:
            found[kind.name] = kind
    return tuple(found.values())


def component_errors(bodies: Sequence[Body]) -> list[ErrorName]:
    """The motion errors of all bodies, axis by axis."""
    moving = sorted((body for body in bodies if body.moves), key=lambda body: AXES.index(body.moves or ""))
    return [name for body in moving for name in body.motion_errors]


def _read_kind(fields: Fields, bodies: Sequence[Body] | None) -> Kind:
    name = fields.text("name")
    if name is not None and not _NAME.fullmatch(name):
        fields.fault("name", f"is {shown(name)}", "a small letter, then small letters, digits and _, 40 at most")
        name = None
    text = fields.text("expression") or ""
    acts = fields.texts("components", required=True) or ()
    other_axis = fields.flag("other_axis")
    sentence = fields.text(
        "sentence", default="an effect that the spec describes", pattern=PROSE, meaning=PROSE_MEANING
    )
    parameters = _read_parameters(fields)
    fields.refuse_others()
    kind = Kind(
        name=name or "",
        place="component",
        expression=text,
        parameters=tuple(parameters.values()),
        sentence=(sentence or "").rstrip("."),
        directions=tuple(part for part in acts if part in ALL_DIRECTIONS),
        components=tuple(part for part in acts if part not in ALL_DIRECTIONS),
        other_axis=other_axis,
    )
    _check_components(fields, kind, bodies)
    if text:
        _check_expression(fields, kind, bodies)
    return kind


def _read_parameters(fields: Fields) -> dict[str, Parameter]:
    told = isinstance(fields.raw.get("parameters"), dict)
    table = fields.table("parameters", required=True)
    found: dict[str, Parameter] = {}
    for name in table.raw:
        if not _PARAMETER.fullmatch(name):
            table.fault(name, "is no name", "a letter, then letters, digits and _, 40 at most")
        elif name in VARIABLES or name in FUNCTIONS or name == "pi":
            table.fault(name, "is a name of the language of expressions", "another name")
        elif len(name) > 1 and (what := taken_for(name)) is not None:
            table.fault(name, f"clashes with a name that generated code uses for {what}", "another name")
        elif re.match(r"term|context", name):
            table.fault(name, "clashes with names of generated code, term... and context...", "another name")
        found[name] = _read_parameter(table.table(name), name)
    grids = [parameter.values for parameter in found.values() if parameter.role == "grid"]
    linear = len(found) - len(grids)
    if len(found) > MOST_PARAMETERS:
        table.complain(table.path, f"are {len(found)}", f"{MOST_PARAMETERS} parameters at most")
    elif not linear and told:
        table.complain(
            table.path, "have no linear one", "a parameter without a grid, to which the term is proportional"
        )
    if len(grids) > MOST_GRIDS or math.prod(map(len, grids)) > LARGEST_SEARCH:
        problem = f"have {len(grids)} grids of {math.prod(map(len, grids))} combinations"
        table.complain(table.path, problem, f"{MOST_GRIDS} grids and {LARGEST_SEARCH} combinations at most")
    return found


def _read_parameter(fields: Fields, name: str) -> Parameter:
    unit = fields.text("unit", pattern=_UNIT, meaning=_UNIT_MEANING)
    meaning = fields.text("meaning", default=name, pattern=PROSE, meaning=PROSE_MEANING)
    fields.known.add("grid")
    grid = fields.raw.get("grid")
    fields.refuse_others("unit, meaning, grid")
    if "grid" not in fields.raw:
        return Parameter(name=name, unit=unit or "1", meaning=meaning or name)
    values = [fields.finite(part) for part in grid] if isinstance(grid, list) else []
    numbers = tuple(value for value in values if value is not None)
    if not 1 <= len(values) <= LARGEST_GRID or len(set(numbers)) < len(values):
        fields.fault("grid", f"is {shown(grid)}", f"a list of 1 to {LARGEST_GRID} different finite numbers")
    return Parameter(
        name=name, unit=unit or "1", meaning=meaning or name, role="grid", grid="given", values=numbers or (1.0,)
    )


def _check_components(fields: Fields, kind: Kind, bodies: Sequence[Body] | None) -> None:
    there = None if bodies is None else component_errors(bodies)
    for component in kind.components:
        name = ErrorName.parse(component)
        if name is None or name.is_location or (there is not None and name not in there):
            right = f"of {' '.join(there)}" if there else "a component error of this machine"
            problem = f"{shown(component)} is no component error of this machine"
            fields.fault("components", problem, f"{' '.join(ALL_DIRECTIONS)}, or one {right}")


def _check_expression(fields: Fields, kind: Kind, bodies: Sequence[Body] | None) -> None:
    """Complain of every fault of a kind's expression: its form, its names, linearity, values.

    bodies: None while they are in doubt; travels are theirs.
    """
    try:
        expression = parse(kind.expression)
    except ExpressionError as error:
        fields.fault("expression", error.problem, f"expected: {error.expected}\n{error.marked}")
        return
    parameters = {parameter.name: parameter for parameter in kind.parameters}
    variables = [variable.name for variable in variables_of(kind)]
    used = names(expression)
    unknown = [name for name in used if name.name not in parameters and name.name not in variables]
    for name in unknown:
        problem, right = f"{name.name} is unknown", f"a parameter of this kind, or one of {' '.join(variables)}"
        if name.name in VARIABLES:
            belongs = name.name.endswith("_b")
            problem = f"{name.name} is no variable of this kind"
            right = "other_axis = true, for the variables of another axis" if belongs else right
        at = ExpressionError(kind.expression, name.column, problem, right)
        fields.fault("expression", problem, f"{right}\n{at.marked}")
    if kind.other_axis and not any(name.name.endswith("_b") and name.name in VARIABLES for name in used):
        fields.fault("other_axis", "is true, but no variable of another axis is used", "one such as s_b, or false")
    there = {name.name for name in used}
    for idle in (name for name in parameters if name not in there and name.isidentifier()):  # else it could not be
        fields.fault("parameters", f"{idle} is not in the expression", "use it, or leave it out")
    if not unknown:
        _check_linear(fields, expression, kind.parameters)
        _check_values(fields, expression, kind.parameters, bodies)


def _check_linear(fields: Fields, expression: Expression, parameters: Iterable[Parameter]) -> None:
    linear = [parameter.name for parameter in parameters if parameter.role == "linear"]
    used = {name.name for name in names(expression)}
    if not linear or not used.issuperset(linear):
        return
    if is_linear(expression, linear):
        return
    right = f"a sum of terms with one of {', '.join(linear)} as a factor each"
    fields.fault("expression", f"is not linear in {', '.join(linear)}", f"{right}; a grid for any other parameter")


def _check_values(
    fields: Fields, expression: Expression, parameters: Sequence[Parameter], bodies: Sequence[Body] | None
) -> None:
    positions = sampled_positions(body.travel for body in bodies or () if body.travel)
    at = undefined_at(expression, positions, sampled_parameters(parameters))
    if at is not None:
        where = ", ".join(f"{name} = {value:g}" for name, value in at.items())
        problem = "has no finite value" + (f" where {where}" if where else "")
        fields.fault("expression", problem, "one that has a value at all positions, speeds and times")
