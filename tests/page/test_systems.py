"""The systems of a page that is not in the paper's order: the paper's runs on a spec without its numbers."""

from dataclasses import replace
from functools import cache

import numpy as np

from tests.page.chain_names import AXES, Names, column
from tests.page.checking import problem
from tests.page.pages import derived, names
from tests.page.rows import Row, rows_of
from tests.page.test_mutants import survivors
from trueaxis.codegen.equations import equations_page
from trueaxis.derivation.model import DerivedModel
from trueaxis.derivation.systems import IdentificationSystem


@cache
def unnumbered() -> DerivedModel:
    model = derived("dmu60p")
    return replace(model, machine=replace(model.machine, references=()))


@cache
def system_rows() -> tuple[Row, ...]:
    return tuple(row for row in rows_of(equations_page(unnumbered())) if row.section == "Identification systems")


def system_names(system: IdentificationSystem) -> Names:
    """Readings by the numeric chain at points drawn for the page's names; b and D by their derivatives."""
    own = names("dmu60p")
    runs = {run.name: run for run in unnumbered().runs}
    at, found = {}, dict(own.base)
    for triple, on, coordinates in system.points:
        rng = np.random.default_rng(abs(hash(coordinates)) % 2**32)
        at[on, coordinates] = column(*rng.uniform(0.3, 1.7, 3), 1)
        label = str(triple[0]).removesuffix("x")
        found |= {f"r_{label[1:]}{a}": float(at[on, coordinates][i, 0]) for i, a in enumerate(AXES)}

    def readings(values: dict[str, float]) -> np.ndarray:
        result = []
        for name in system.runs:
            run = runs[name]
            ends: dict[str, np.ndarray] = {end[0]: at[end] for end in (run.target, run.reference) if end[0] != "bed"}
            _, first = own.chain.displacement("".join(run.moves), ends, values)
            result.append(float(np.dot(run.direction, first[:3, 0])))
        return np.array(result)

    whole = readings(own.values)
    matrix = np.array(
        [whole - readings({**own.values, unknown: own.values[unknown] - 1.0}) for unknown in system.unknowns]
    ).T
    right = matrix @ np.array([own.values[unknown] for unknown in system.unknowns])
    found |= {f"L_{k + 1}": value for k, value in enumerate(whole)}
    return found | {f"b_{k + 1}": value for k, value in enumerate(right)} | {"D": float(np.linalg.det(matrix))}


def formulas() -> list[tuple[str, Names]]:
    model = unnumbered()
    assert model.identification is not None
    systems = {str(k): system for k, system in enumerate(model.identification.systems, 1)}
    return [(row.text, system_names(systems[row.title.split(".")[0]])) for row in system_rows()]


def test_every_formula_of_the_systems_holds() -> None:
    found = {text: problem(text, known) for text, known in formulas()}
    assert len(found) > 40
    assert {text: why for text, why in found.items() if why} == {}


def test_no_slip_in_the_systems_survives() -> None:
    assert survivors(formulas()[::2])[0] == []
