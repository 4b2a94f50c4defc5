"""Null-space combinations in words: what a set of runs cannot tell apart."""

from collections.abc import Mapping

import sympy as sp

from trueaxis.machine.machine import Machine


def combination_text(machine: Machine, combination: Mapping[str, sp.Rational]) -> str:
    """One sentence on a combination of changes that leaves every reading as it is."""
    location = [name for name in combination if name in machine.location_errors]
    curves = [name for name in machine.components if name in combination]
    if location:
        change = ", ".join(f"{_signed(combination[n])} {machine.parameter_unit(n)} in {n}" for n in location)
        if not curves:
            return f"{', '.join(location)}: a change of {change} changes no reading; the runs do not see it at all."
        if not all(n.is_of_linear_axis for n in curves):
            return (
                f"{', '.join(location)}: the curves of {', '.join(curves)} can take up a change of {change} "
                "position by position, and no reading changes."
            )
        names = f"{', '.join(location)} and the slope of {', '.join(curves)}"
        slopes = ", ".join(f"{_signed(combination[n])} {n.unit} per {n.axis_unit} in the slope of {n}" for n in curves)
        text = f"{names}: a change of {change} with {slopes} changes no reading"
        if len(location) == len(curves) == 1:
            sign = "-" if combination[curves[0]] / combination[location[0]] > 0 else "+"
            ratio = abs(combination[curves[0]] / combination[location[0]])
            factor = "" if ratio == 1 else f"{float(ratio):g} "
            return f"{text}; only (slope of {curves[0]}) {sign} {factor}{location[0]} is determined."
        return f"{text}."
    return (
        f"{', '.join(curves)}: at every position one combination of them is free, because the equations that hold "
        "them are not independent at the points of these runs."
    )


def _signed(value: sp.Rational) -> str:
    number = float(value)
    return f"{number:+g}"
