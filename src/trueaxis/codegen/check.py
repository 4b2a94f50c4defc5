"""What `derive` checks: whether the files on disk are those that would be emitted, and whether own kinds have values.

Algebra may take from an expression what it had: `1/(pi - 4*pi/4)` becomes a division by zero, `((q/1000)^9)^9` a
quotient of two numbers that may both be too large.
"""

import difflib
import math
from pathlib import Path
from types import ModuleType

import numpy as np
import sympy as sp

from trueaxis.codegen.numpy_source import numpy_source
from trueaxis.derivation.effect_terms import effect_name, effect_routine, term
from trueaxis.derivation.routine import Routine
from trueaxis.effects.evaluate import sampled_parameters, sampled_positions, samples
from trueaxis.effects.expression import parse
from trueaxis.effects.kind import Kind
from trueaxis.effects.placement import context_of
from trueaxis.io.faults import Fault
from trueaxis.io.files import write_files
from trueaxis.machine.machine import Machine

_NO_NUMBERS = (sp.nan, sp.zoo, sp.oo, -sp.oo, sp.I)


def differences(folder: Path, files: dict[str, bytes], context: int = 2) -> list[str]:
    """Lines that say what differs: missing and left-over files, and unified diffs of changed ones; empty if nothing."""
    present = {path.name for path in folder.iterdir() if path.is_file()} if folder.is_dir() else set()
    lines = [f"{folder / name}: is missing" for name in files if name not in present]
    lines += [f"{folder / name}: is not generated from this spec" for name in sorted(present - files.keys())]
    for name, new in files.items():
        if name in present and (old := (folder / name).read_bytes()) != new:
            before, after = (text.decode(errors="replace").splitlines() for text in (old, new))
            label = str(folder / name)
            diff = difflib.unified_diff(before, after, label, f"{label} (as derived now)", n=context, lineterm="")
            lines += list(diff) or [f"{label}: differs in the ends of its lines"]
    return lines


def write(folder: Path, files: dict[str, bytes]) -> None:
    """Write all files of a machine, or none."""
    write_files({folder / name: content for name, content in files.items()})


def faults_of_kinds(machine: Machine, file: str) -> list[Fault]:
    """A fault for each kind of the spec whose term, or a derivative of it by a parameter, has no finite value."""
    found = []
    for index, kind in enumerate(machine.effect_kinds):
        if problem := _problem(machine, kind):
            place = f"key effect_kind[{index}].expression"
            found.append(Fault(file, place, problem, "another form of the expression, or another grid"))
    return found


def _problem(machine: Machine, kind: Kind) -> str:
    value = term(kind)
    if value.has(*_NO_NUMBERS) or not all(_is_double(number) for number in value.atoms(sp.Number)):
        return "has no finite value once it is simplified"
    routine = effect_routine(kind)
    if not all(_is_double(number) for _, part in routine.batch + routine.body for number in part.atoms(sp.Number)):
        return "has a derivative with a number that is too large"
    names = ("", *(f"has a derivative by {parameter.name} that " for parameter in kind.parameters))
    for name, at in zip(names, _infinite_at(machine, kind, routine), strict=True):
        if at:
            return f"{name}has no finite value where {at}"
    return ""


def _is_double(number: sp.Number) -> bool:
    try:
        return math.isfinite(float(number))
    except (OverflowError, TypeError, ValueError):
        return False


def _infinite_at(machine: Machine, kind: Kind, routine: Routine) -> list[str]:
    """For each row of the term a point at which it is not finite, as text; empty where all are."""
    module = ModuleType("kernels")
    exec(numpy_source(machine, (routine,)), module.__dict__)
    kernel = getattr(module, effect_name(kind))
    context, names = context_of(kind), [parameter.name for parameter in kind.parameters]
    positions, grids = sampled_positions(machine.travel.values()), sampled_parameters(kind.parameters)
    points: dict[tuple[float, ...], list[dict[str, float]]] = {}
    for values in samples(parse(kind.expression), positions, grids):
        points.setdefault(tuple(values.get(name, 0.0) for name in names), []).append(values)
    found = [""] * (1 + len(names))
    for parameters, group in points.items():
        rows = np.array([[values.get(name, 0.0) for values in group] for name in context])
        with np.errstate(all="ignore"):
            result = kernel(rows, np.array(parameters))
        for row, column in np.argwhere(~np.isfinite(result)):
            found[row] = found[row] or ", ".join(f"{name} = {value:g}" for name, value in group[column].items())
    return found
