"""The expression of a kind that a spec adds: its names, its form, and that it has a value wherever it is needed."""

from collections.abc import Iterable, Sequence

from trueaxis.effects.domain import sampled_parameters, sampled_positions, undefined_at
from trueaxis.effects.expression import Expression, names, parse
from trueaxis.effects.kind import Kind, Parameter
from trueaxis.effects.linearity import is_linear
from trueaxis.effects.placement import variables_of
from trueaxis.effects.tokens import ExpressionError
from trueaxis.effects.variables import VARIABLES
from trueaxis.machine.fields import Fields
from trueaxis.machine.machine import Body


def check_expression(fields: Fields, kind: Kind, bodies: Sequence[Body] | None) -> None:
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
