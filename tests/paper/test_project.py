"""What trueaxis derives against the same printed equations: equal to what follows, never to a slip."""

from __future__ import annotations

import json
import re
import tomllib

import numpy as np
import pytest
import sympy as sp

from trueaxis.demo import inputs
from trueaxis.derivation.chain import chains, matrix
from trueaxis.derivation.first_order import first_order
from trueaxis.derivation.systems import RunPattern, identification, point_values
from trueaxis.derivation.views import view
from trueaxis.machine.topology import branches, lower_body_array
from trueaxis.view import Carrier

from . import chain, project, reference
from .claims_systems import PAPER_READINGS, SYSTEMS, jacobian
from .entries import LOWER_BODY, branch, follows
from .errata import ERRATA
from .notation import DIRECTIONS, MOTION_ERRORS, POSITION, SQUARENESS, Formula
from .numeric import mended
from .printed import PRINTED
from .printed.compensation import STROKES
from .printed.conditions import TEST_CONDITIONS
from .printed.tables import POINTS_LINKAGE, POINTS_SINGLE, SQUARENESS_VALUES

DERIVED = [
    (n, part)
    for n, item in PRINTED.items()
    for part in item.parts
    if isinstance(part, Formula) and (part.run in reference.RUN_LABELS or part.run == "chain")
]


def named(value: object) -> str:
    return f"({value})" if isinstance(value, int) else getattr(value, "label", str(value))


@pytest.mark.parametrize(("source", "part"), DERIVED, ids=named)
def test_derived_is_what_follows_and_not_the_slip(source: int | str, part: Formula) -> None:
    known = project.known(part.run)
    assert known is not None
    assert reference.residual(mended(source, part, ERRATA), known) == 0
    wrong = any((mend.source, mend.label) == (source, part.label) for e in ERRATA for mend in e.mends)
    assert (reference.residual(part, known) != 0) == wrong


def test_numbered_equations_compared_with_the_derivation() -> None:
    """Eqs. (5), (6), (22), (28), (36), (39)-(42) are no derivation from the machine."""
    elsewhere = {1, 2, 3, 4, 43}
    assert {n for n, _ in DERIVED} | elsewhere == set(range(1, 44)) - {5, 6, 22, 28, 36, 39, 40, 41, 42}


def test_factors_are_those_of_table_2_mended() -> None:
    machine = project.machine()
    renamed = project.names()
    for joint in (j for side in chains(machine) for j in side):
        for part, step in zip(("p", "pe", "s", "se"), joint.steps, strict=True):
            name = f"S{joint.body.lower}{joint.body.number}_{part}"
            assert matrix(step).xreplace(renamed).as_immutable() == follows()["Table 2", name], name


def test_products_are_those_of_eqs_2_and_3() -> None:
    machine = project.machine()
    workpiece, tool = branches(machine)
    for bodies, end in ((workpiece, 4), (tool, 9)):
        assert tuple(f"S{body.lower}{body.number}" for body in bodies) == branch(end)
    first = dict(zip(*lower_body_array(machine)[:2], strict=True))
    assert first == {1: 0} | {number: LOWER_BODY[number] for number in first if number != 1}


def test_first_order_point_of_eq_4() -> None:
    """Eq. (4) to first order against the derivative of the inverse product composed here."""
    machine = project.machine()
    point = sp.symbols("X_T Y_T Z_T", real=True)
    seen = first_order(view(machine, "tool_in_workpiece"), point)
    offset = {end: sp.Matrix([sp.Symbol(f"q_{end}{d}", real=True) for d in DIRECTIONS]) for end in "wT"}
    bed = sp.Matrix(chain.carried(chain.tool_branch("xz"), list(sp.Matrix(point) + offset["T"])))
    ideal, error = (m for m in chain.workpiece_branch("y"))
    # w solves ideal * error(t) * (w + q_w) = bed(t); order by order in t:
    shifted = bed - ideal[:3, 3]
    w0 = shifted.subs(chain.SCALE, 0)
    slope = error.diff(chain.SCALE)
    w1 = shifted.diff(chain.SCALE).subs(chain.SCALE, 0) - (slope * sp.Matrix([*w0, 1]))[:3, :]
    for row in range(3):
        derived = (seen.ideal[row] + seen.deviation()[row]).xreplace(project.names())
        assert sp.expand(derived - (w0 - offset["w"] + w1)[row]) == 0


def test_right_angles_are_those_of_eq_43_mended() -> None:
    xy, xz, yz = SQUARENESS
    # pi/2 minus the angle: Eq. (43) mended gives eps_xy and eps_xz with this sign, eps_yz with the other.
    assert project.right_angles() == {xy: xy, xz: xz, yz: -yz}


def _runs() -> list[RunPattern]:
    """The paper's 18 readings at the points of Tables 4 and 5."""
    runs = []
    for run, label, direction in PAPER_READINGS:
        table = POINTS_SINGLE if len(run) == 1 else POINTS_LINKAGE[run]
        tool, work = reference.point_names(run, label)
        ends: list[tuple[Carrier, tuple[float, float, float]]] = []
        both: tuple[tuple[Carrier, str | None], ...] = (("workpiece", work), ("tool", tool))
        for body, name in both:
            if name is not None:
                x, y, z = (float(c) for c in table[name])
                ends.append((body, (x, y, z)))
        along = [float(d == direction) for d in DIRECTIONS]
        target, other = (*ends, ("bed", (0.0, 0.0, 0.0)))[:2]
        runs.append(
            RunPattern(
                name=f"{run}-{label}{direction}",
                moves=tuple(run),
                direction=(along[0], along[1], along[2]),
                frame="bed",
                target=target,
                reference=other,
            )
        )
    return runs


def test_systems_of_the_project_at_the_published_points() -> None:
    """Same order of solution as Sects. 3.2-3.5, and E33: the project's Z system is singular there, no other."""
    systems = identification(project.machine(), _runs()).systems
    renamed = project.names()
    order = [tuple(str(renamed[sp.Symbol(u, real=True)]) for u in system.unknowns) for system in systems]
    # Unknowns stand in the paper's order; Eqs. (25) and (38) are taken apart into the blocks that they consist of.
    assert [*order[:3], order[3] + order[4], *order[5:7], order[7] + order[8]] == [each[3] for each in SYSTEMS]
    singular = [system.unknowns for system in systems if system.matrix.subs(point_values(system.points)).det() == 0]
    assert singular == [("EZZ", "EBZ", "EAZ")]


def test_open_combinations_of_the_project() -> None:
    """The project's exact null space against the numeric one of the readings composed here: the same four."""
    combinations = identification(project.machine(), _runs()).combinations
    assert len(combinations) == 4
    far = {"x": 540.0, "y": 700.0, "z": 600.0}
    pose = {POSITION[axis]: value for axis, value in far.items()}
    matrix = jacobian(pose=pose)
    columns = [str(e) for e in (*MOTION_ERRORS, *SQUARENESS)]
    machine = project.machine()
    for combination in combinations:
        vector = np.zeros(len(columns))
        for name, value in combination.items():
            symbol = project.names()[sp.Symbol(name, real=True)]
            scale = far[name[2].lower()] if name in machine.components else 1.0
            vector[columns.index(str(symbol))] = float(value) * scale
        assert np.abs(matrix @ vector).max() < 1e-9 * np.abs(vector).max()


def test_measuring_plan_has_the_printed_points() -> None:
    plan = tomllib.loads((project.MACHINE_FILE.parent / "dmu60p_runs" / "setup.toml").read_text(encoding="utf-8"))
    planned = {
        tuple(run[end]["point"]) for run in plan["run"] for end in ("target", "reference") if "point" in run[end]
    }
    printed = {tuple(map(float, p)) for t in (POINTS_SINGLE, *POINTS_LINKAGE.values()) for p in t.values()}
    assert planned == printed


def test_demonstration_is_under_the_conditions_of_table_7() -> None:
    """Plane, bar, feed and both directions; the whole circle only as far as the stroke of X allows (E42)."""
    assert inputs.BAR == TEST_CONDITIONS.bar == TEST_CONDITIONS.radius
    for word, direction in (("G2", "Clockwise"), ("G3", "Counterclockwise")):
        program = inputs.circle(clockwise=direction == "Clockwise")
        arcs = re.findall(r"^(G[23]) X(\S+) Y(\S+) I(\S+) J(\S+) F(\S+)$", program, re.MULTILINE)
        assert {arc[0] for arc in arcs} == {word}
        assert direction in TEST_CONDITIONS.directions
        assert {float(arc[5]) for arc in arcs} == {TEST_CONDITIONS.feed}
        assert "G17" in program
        assert TEST_CONDITIONS.plane == "XY"
    assert inputs.STROKE_X == STROKES["X"] < 2 * TEST_CONDITIONS.radius


def test_example_errors_have_the_squareness_of_table_6() -> None:
    errors = json.loads((project.MACHINE_FILE.parent / "dmu60p_errors.json").read_text(encoding="utf-8"))
    assert {n.replace("eps", "epsilon"): v for n, v in errors["parameters"].items() if "eps" in n} == SQUARENESS_VALUES
