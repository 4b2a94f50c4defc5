"""What the paper claims of its own method and data (Sects. 3.2-3.7, 5), computed."""

from __future__ import annotations

from decimal import Decimal

import numpy as np
import pytest
import sympy as sp

from . import chain, reference
from . import claims_systems as systems
from .claims import agreeing, definitions, interval
from .claims_squareness import TRAVEL, cases, squareness_as_printed
from .errata import ERRATA
from .mending import Kind
from .notation import DIRECTIONS, MOTION_ERRORS, SQUARENESS, X_H, Z_H, delta, eps
from .printed.tables import IMPROVEMENTS, POINTS_LINKAGE, POINTS_SINGLE


def test_z_system_is_singular() -> None:
    """E33: the readings at P_k8 and P_k9 are one reading; a combination of the unknowns stays free."""
    matrices = systems.single_axis_matrices()
    assert [np.linalg.matrix_rank(m) for m in matrices.values()] == [3, 3, 2]
    z = sp.Matrix(matrices["Z"]).applyfunc(sp.nsimplify)
    assert z.row(1) == z.row(2)
    assert z.det() == 0
    # delta_z : epsilon_y : epsilon_x that no reading sees, mm : rad : rad.
    assert z * sp.Matrix([3042, 5, 46]) == sp.zeros(3, 1)


def test_one_open_combination_spreads_to_nine_errors() -> None:
    assert systems.undetermined() == [
        "delta_y(x)",
        "delta_z(x)",
        "epsilon_x(x)",
        "delta_z(y)",
        "delta_x(z)",
        "delta_y(z)",
        "delta_z(z)",
        "epsilon_x(z)",
        "epsilon_y(z)",
    ]
    assert systems.undetermined(systems.with_mended_z_point()) == []


def test_linkage_points_satisfy_their_conditions() -> None:
    """Sects. 3.3, 3.4: r_k1y differs from r_k2y, r_l1z from r_l2z."""
    assert POINTS_LINKAGE["XZ"]["k1"][1] == 31.8
    assert POINTS_LINKAGE["XZ"]["k2"][1] == 81.7
    assert (POINTS_LINKAGE["XY"]["l1"][2], POINTS_LINKAGE["XY"]["l2"][2]) == (75, 105)
    for (_, _, rows, unknowns), matrix in zip(systems.SYSTEMS[3:], systems.system_matrices()[3:], strict=True):
        assert np.linalg.matrix_rank(matrix) == len(rows) == len(unknowns)


@pytest.mark.parametrize("count", [1, 5])
def test_squareness_and_straightness_slope_are_one(count: int) -> None:
    """Three combinations stay open at any number of positions: a squareness and the slope of one straightness."""
    matrix = systems.stacked(count, systems.with_mended_z_point())
    assert systems.null_space(matrix).shape[1] == 3
    pairs = ((delta("y", "x"), X_H, 1), (delta("x", "z"), Z_H, 1), (delta("y", "z"), Z_H, -1))
    for column, (error, position, sign) in enumerate(pairs):
        trade = np.zeros(matrix.shape[1])
        trade[-3 + column] = 1.0
        for h in range(count):
            at = (h + 1) / count * 2 * systems.POSE[position]
            trade[18 * h + MOTION_ERRORS.index(error)] = -sign * at
        assert np.abs(matrix @ trade).max() < 1e-9


def test_collinear_points_make_a_system_singular() -> None:
    """Against claim 2 of Sect. 3.7: points of one line, or of one y for a linkage, determine nothing more."""
    line = POINTS_SINGLE | {"k3": (0.0, 30.0, 500.0)}
    assert np.linalg.matrix_rank(systems.system_matrices(line)[0]) == 2
    # And points that do satisfy the rank condition: a micrometre of noise makes microradians by their spacing.
    by_name = {a.name: a.standard for a in systems.amplification(systems.with_mended_z_point())}
    assert by_name["epsilon_z(x)"] == pytest.approx(192.48, abs=0.01)
    base = POINTS_LINKAGE["XY"]["l2"][2] - POINTS_LINKAGE["XY"]["l1"][2]
    own = by_name["epsilon_y(y)"] * np.sqrt(
        1
        - next(a.from_earlier for a in systems.amplification(systems.with_mended_z_point()) if a.name == "epsilon_y(y)")
    )
    assert own == pytest.approx(1e3 * np.sqrt(2) / base)


def test_errors_are_handed_down() -> None:
    """Against claim 3 of Sect. 3.7: delta_y(x) carries 36 times a reading's noise, nearly all from earlier runs."""
    by_name = {a.name: a for a in systems.amplification(systems.with_mended_z_point())}
    assert by_name["delta_y(x)"].standard > 30
    assert by_name["delta_y(x)"].from_earlier > 0.99
    assert by_name["delta_x(x)"].from_earlier == pytest.approx(0, abs=1e-12)


def test_noise_table_against_sampling() -> None:
    """The covariance against 20 000 noisy solutions one system after the other, as the paper solves them."""
    whole = systems.jacobian(systems.with_mended_z_point())[:, :18]
    names = [str(e) for e in MOTION_ERRORS]
    noise = np.random.default_rng(20).normal(0, 1e-3, (18, 20_000))
    found = np.zeros((18, 20_000))
    for _, _, rows, unknowns in systems.SYSTEMS:
        at = [systems.PAPER_READINGS.index(q) for q in rows]
        columns = [names.index(u) for u in unknowns]
        found[columns] = np.linalg.solve(whole[np.ix_(at, columns)], noise[at] - whole[at] @ found)
    for item in systems.amplification(systems.with_mended_z_point()):
        unit = 1e6 if item.name.startswith("epsilon") else 1e3
        assert found[names.index(item.name)].std() * unit == pytest.approx(item.standard, rel=0.03)


def test_squareness_is_blind_to_squareness() -> None:
    """E30: no reading that determines pitch and yaw contains a squareness error, so Eq. (43) cannot either."""
    for run in ("X", "Y", "Z"):
        used = {"X": "x", "Y": "y", "Z": "z"}[run]
        for label in reference.RUN_LABELS[run]:
            expression = reference.readings(run)[sp.Symbol(f"L_{label}{used}h", real=True)]
            assert not expression.free_symbols & set(SQUARENESS)
    found = {(c.machine, c.parameter): c for c in cases()}
    assert all(abs(c.found - c.truth) > 4 for c in found.values())


def test_turning_the_whole_machine_is_no_squareness() -> None:
    """E29: both carriages turned alike leave the angle; the mended signs give 0, the printed ones twice the yaw."""
    yaw = 10e-6
    along = {
        "x": sp.Matrix([0, 0, yaw]).cross(sp.Matrix([1, 0, 0])),
        "y": sp.Matrix([0, 0, yaw]).cross(sp.Matrix([0, 1, 0])),
    }
    assert along["x"][1] + along["y"][0] == 0
    assert squareness_as_printed({"yx": lambda _: yaw, "xy": lambda _: yaw}, 18)["epsilon_xy"] > 10 * yaw


def test_printed_squareness_grows_with_the_number_of_samples() -> None:
    """E28: the sum of angle times position is no length of the machine; twice the samples, about twice the result."""
    coarse, fine = (c.found for c in cases()[-2:])
    assert fine / coarse == pytest.approx(2, rel=0.1)
    assert TRAVEL["x"] / 18 == 30


def test_tool_frame_coordinates_shift_the_errors() -> None:
    """E34: Eq. (15) with tool-frame coordinates gives the error of the tool's origin, not of the X carriage's."""
    q = sp.Matrix([sp.Symbol(f"q_T{d}", real=True) for d in DIRECTIONS])
    error = sp.Matrix([delta(d, "x") for d in DIRECTIONS])
    about = sp.Matrix([eps(d, "x") for d in DIRECTIONS])
    inside = {label: systems.points_of("X") for label in "123"}
    rows, readings = [], []
    for label in "123":
        table = [sp.nsimplify(inside[label][sp.Symbol(f"r_k{label}{d}", real=True)]) for d in DIRECTIONS]
        carriage = q + sp.Matrix(table)
        readings.append((error + about.cross(carriage))[0])
        rows.append([1, -table[1], table[2]])
    solved = sp.Matrix(rows).LUsolve(sp.Matrix(readings))
    assert sp.expand(solved[0] - (error + about.cross(q))[0]) == 0
    assert sp.expand(solved[1] - eps("z", "x")) == 0
    # Table 2's chain adds q_T itself: the displacement it predicts for O_T counts epsilon x q_T twice.
    moved = chain.first_order(chain.carried(chain.motion("x", "x"), list(q))[0]) - X_H - q[0]
    assert sp.expand(moved - solved[0]) == 0
    predicted = moved.xreplace({delta("x", "x"): solved[0]})
    assert sp.expand(predicted - moved - about.cross(q)[0]) == 0


def test_bar_error_is_blind_across_the_bar() -> None:
    """Eq. (6): 0.01 mm across a bar of 300 mm is an error of 0.00017 micrometres."""
    across = np.array([300.0, 0.01, 0.0])
    assert np.linalg.norm(across) - 300.0 == pytest.approx(0.01**2 / 600, rel=1e-3)


def test_pairs_of_points_meet_at_different_homes() -> None:
    """Table 5: r_l - r_k is the same for both XY points and another for YZ: the runs did not start at one pose."""
    xy, yz = POINTS_LINKAGE["XY"], POINTS_LINKAGE["YZ"]
    offsets = [np.subtract(t[a], t[b]) for t, a, b in ((xy, "l1", "k1"), (xy, "l2", "k2"), (yz, "l1", "k1"))]
    np.testing.assert_allclose(offsets[0], [317.8, 98, 124.127])
    np.testing.assert_allclose(offsets[1], offsets[0])
    np.testing.assert_allclose(offsets[2], [333, -73, 104])


@pytest.mark.parametrize("name", IMPROVEMENTS)
def test_printed_percentage_follows(name: str) -> None:
    before, after, printed = IMPROVEMENTS[name]
    low, high = interval(before, after)
    assert low <= Decimal(printed) <= high
    assert round(100 * (1 - Decimal(after) / Decimal(before)), 1) == Decimal(printed)


def test_derivation_mistakes_are_there() -> None:
    """Against claim 1 of Sect. 3.7: signs and formulas that a derivation gets right or wrong."""
    of_section_3 = [e.kind for e in ERRATA if e.number <= 35]
    assert (of_section_3.count(Kind.SIGN), of_section_3.count(Kind.FORMULA)) == (9, 6)


def test_squareness_needed_where_the_paper_says() -> None:
    """Sect. 3.6: straightness of Z in X and Y and of X in Y are found on the hypothesis of known squareness."""
    inverse = np.linalg.inv(systems.jacobian(systems.with_mended_z_point())[:, :18])
    carried = -inverse @ systems.jacobian(systems.with_mended_z_point())[:, 18:]
    needing = {
        (str(MOTION_ERRORS[i]), str(SQUARENESS[j])) for i, j in zip(*np.nonzero(np.abs(carried) > 1e-6), strict=True)
    }
    assert needing == {
        ("delta_y(x)", "epsilon_xy"),
        ("delta_x(z)", "epsilon_xz"),
        ("delta_y(z)", "epsilon_yz"),
    }


def test_equations_that_agree() -> None:
    assert agreeing() == [4, 5, 7, 8, 12, 14, 15, 16, 17, 29, 42, 46, 48]
    assert definitions() == [40, 44, 53, 55, 56]
