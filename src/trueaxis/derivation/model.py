"""The derivation in one step: from a machine (and runs, if it has any) to everything that is emitted."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from trueaxis.derivation import library, symbols
from trueaxis.derivation.effect_terms import effect_routines
from trueaxis.derivation.first_order import Squareness, squarenesses
from trueaxis.derivation.motion import MotionEquation, standard_motions
from trueaxis.derivation.routine import (
    Argument,
    Routine,
    build,
    errors_argument,
    parameters_argument,
    point_argument,
    positions_argument,
    vector_argument,
)
from trueaxis.derivation.systems import Identification, IdentificationSystem, RunPattern, identification
from trueaxis.machine.machine import Machine


@dataclass(frozen=True, kw_only=True)
class DerivedModel:
    """What a spec says, worked out; `identification` is None for a machine without runs."""

    machine: Machine
    routines: tuple[Routine, ...]
    motions: tuple[MotionEquation, ...]
    squareness: tuple[Squareness, ...]
    runs: tuple[RunPattern, ...]
    identification: Identification | None


def derive_model(machine: Machine, runs: Sequence[RunPattern] = ()) -> DerivedModel:
    """Derive all equations and routines of a machine and of the systems of its runs."""
    motions = standard_motions(machine)
    systems = identification(machine, runs) if runs else None
    routines = library.derive_routines(machine)
    routines += tuple(_motion_routine(machine, equation) for equation in motions)
    routines += tuple(_system_routines(machine, systems)) if systems else ()
    routines += effect_routines(machine)
    return DerivedModel(
        machine=machine,
        routines=routines,
        motions=motions,
        squareness=squarenesses(machine),
        runs=tuple(runs),
        identification=systems,
    )


def motion_name(moves: Sequence[str]) -> str:
    """`motion_XZ`."""
    return "motion_" + "".join(moves)


def system_name(index: int) -> str:
    """`system_1` for the first system to be solved."""
    return f"system_{index + 1}"


def _motion_routine(machine: Machine, equation: MotionEquation) -> Routine:
    points = [point_argument(seen, name=f"{seen}_point", prefix=f"r{seen[0].upper()}") for _, seen, _ in equation.terms]
    what = " minus ".join(f"{seen} point" for _, seen, _ in equation.terms)
    output = vector_argument("displacement", ("dx", "dy", "dz"), f"{what}, displacement since home, in the bed frame")
    ideal, deviation = equation.motion.ideal, equation.motion.deviation()
    axes = " and ".join(equation.moves)
    return build(
        motion_name(equation.moves),
        f"Motion equation of {axes}: displacement of the {what} since home, to first order.",
        "Eqs. (7)-(11)",
        (
            positions_argument(machine),
            errors_argument(machine),
            parameters_argument(machine),
            *points,
        ),
        (output,),
        {row: a + b for row, a, b in zip(output.rows, ideal, deviation, strict=True)},
    )


def _system_routines(machine: Machine, found: Identification) -> Iterator[Routine]:
    for index, system in enumerate(found.systems):
        if system.inverse is not None:
            yield _system_routine(machine, index, system, system.inverse)


def _system_routine(machine: Machine, index: int, system: IdentificationSystem, inverse: sp.Matrix) -> Routine:
    readings = tuple(f"L{number + 1}" for number in range(len(system.runs)))
    left = [symbols.named(row) - known for row, known in zip(readings, system.known, strict=True)]
    rows = tuple(f"identified_{name}" for name in system.unknowns)
    points = tuple(symbol.name for triple, _, _ in system.points for symbol in triple)
    what = ", ".join(f"xyz of {on} point {number + 1}" for number, (_, on, _) in enumerate(system.points))
    summary = f"{', '.join(system.unknowns)} from the readings {', '.join(system.runs)}."
    if system.rank < len(system.unknowns):
        summary += f" At the points of these runs the rank is {system.rank}: division by zero there."
    measured = f"displacements read in {', '.join(system.runs)}, less those of the error-free machine"
    return build(
        system_name(index),
        summary,
        "Sects. 3.2-3.5, closed form",
        (
            Argument(
                name="readings", rows=readings, shape=(len(readings),), per_point=True, unit="mm", description=measured
            ),
            positions_argument(machine),
            errors_argument(machine),
            parameters_argument(machine),
            Argument(
                name="points", rows=points, shape=(len(system.points), 3), per_point=False, unit="mm", description=what
            ),
        ),
        (
            Argument(
                name="unknowns",
                rows=rows,
                shape=(len(rows),),
                per_point=True,
                unit="mm, rad",
                description=", ".join(system.unknowns),
            ),
        ),
        {
            row: sp.Add(*(entry * value for entry, value in zip(entries, left, strict=True) if entry))
            for row, entries in zip(rows, inverse.tolist(), strict=True)
        },
    )
