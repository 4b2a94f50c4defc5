"""Names of a routine's quantities as variables of generated code."""

from collections.abc import Collection, Mapping

from trueaxis.derivation.routine import Argument, Routine


def variable_names(routine: Routine, taken: Collection[str]) -> Mapping[str, str]:
    """Every symbol's variable: its own name, with `_` added where that is an argument's name or one of `taken`."""
    kept = {*taken, *(a.name for a in routine.inputs + routine.outputs)}
    symbols = [row for a in routine.inputs + routine.outputs for row in a.rows]
    symbols += [target.name for stage in (routine.batch, routine.preparation, routine.body) for target, _ in stage]
    names: dict[str, str] = {}
    for symbol in symbols:
        name = symbol
        while name in kept or (name != symbol and name in symbols):
            name += "_"
        names[symbol] = name
    return names


def rows_text(argument: Argument) -> str:
    """The names of an argument's rows in their order, where they are few enough to be read."""
    if len(argument.rows) <= 40:
        return " ".join(argument.rows)
    return f"{argument.rows[0]} {argument.rows[1]} .. {argument.rows[-1]}, last index fastest"
