"""The parts that both methods stand on, each against something that is not itself."""

import json
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import Polynomial
from numpy.polynomial.legendre import Legendre
from scipy.sparse import csr_array

from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.generator.dmu60p import dmu60p as generator
from tests.identification.data import P9_PRINTED, paper_data
from tests.identification.machines import dmu60p
from trueaxis.estimation.machine import units
from trueaxis.identification.curve_fit import fit_tables, polynomial_curves
from trueaxis.identification.paper.describe import reduced
from trueaxis.identification.paper.method import identify_paper
from trueaxis.identification.paper.pseudo_inverse import TooLargeError, pseudo_inverse
from trueaxis.identification.paper.solution import PaperOptions, noise
from trueaxis.identification.paper.squareness import accumulated_slope, angle_matrix, axis_lines, slope_weights
from trueaxis.identification.report_text import report_json, report_text
from trueaxis.model.bases import LegendreBasis, axis_basis
from trueaxis.model.curves import PolynomialCurve, TableCurve
from trueaxis.model.errors import ErrorValues


@pytest.mark.parametrize(
    "basis",
    [
        LegendreBasis(low=0.0, high=700.0, degree=7),
        LegendreBasis(low=-270.0, high=270.0, degree=5),
        LegendreBasis(low=-30.0, high=120.0, degree=6),
    ],
)
def test_basis_is_legendre_without_its_value_at_zero(basis: LegendreBasis) -> None:
    at = np.linspace(basis.low, basis.high, 13)
    for k, (values, powers) in enumerate(zip(basis(at), basis.powers, strict=True), 1):
        expected = Legendre.basis(k, domain=[basis.low, basis.high])
        assert np.allclose(values, expected(at) - expected(0.0), rtol=0, atol=1e-13)
        assert np.allclose(Polynomial([0.0, *powers])(at), values, rtol=0, atol=1e-9)  # 700^7 costs digits here
    assert np.abs(basis(np.zeros(1))).max() == 0.0


def test_powers_are_exact_before_rounding() -> None:
    """P_2 on [0, 4] less its value at 0: 6 (s/4)^2 - 6 (s/4)."""
    assert axis_basis((0.0, 4.0), 2).powers[1].tolist() == [float(Fraction(-6, 4)), float(Fraction(6, 16))]
    assert axis_basis((100.0, 600.0), 1).low == 0.0


@given(st.integers(0, 10**6))
def test_pseudo_inverse_of_many_parts_is_numpys_of_the_whole(seed: int) -> None:
    source = np.random.default_rng(seed)
    whole = np.zeros((14, 11))
    whole[:3, :3] = source.normal(size=(3, 3))
    whole[3:6, 3:6] = source.normal(size=(3, 3))
    whole[5, 3:6] = whole[4, 3:6]  # singular
    whole[6:11, 6:8] = source.normal(size=(5, 2))
    whole[11:12, 8:10] = source.normal(size=(1, 2))  # too few; unknown 10 is in no equation
    rows, columns = source.permutation(14), source.permutation(11)
    mixed = whole[rows][:, columns]
    found = pseudo_inverse(csr_array(mixed), 1e-8)
    assert found.rank == np.linalg.matrix_rank(mixed, tol=1e-8)
    assert found.null.shape[1] == 11 - found.rank
    assert np.allclose(mixed @ found.null.toarray(), 0.0, atol=1e-12)
    assert np.allclose(found.inverse.toarray(), np.linalg.pinv(mixed, rcond=1e-10), rtol=1e-6, atol=1e-6)


def test_one_part_too_large_is_refused() -> None:
    with pytest.raises(TooLargeError, match="3001"):
        pseudo_inverse(csr_array(np.ones((1, 3001))), 1e-8)


@given(st.integers(0, 10**6), st.integers(1, 4))
def test_reduced_basis_spans_the_same_space(seed: int, dimension: int) -> None:
    source = np.random.default_rng(seed)
    space = np.linalg.qr(source.normal(size=(9, dimension)))[0]
    basis, led = reduced(space, (8, 2))
    assert led == min(dimension, 2)
    assert np.linalg.matrix_rank(np.hstack([space, basis]), tol=1e-6) == dimension
    assert np.allclose(basis[[8, 2][:led]][:, :led], np.eye(led))


def test_slope_weights_are_those_of_the_least_squares_line() -> None:
    at = np.array([0.0, 20.0, 50.0, 130.0])
    values = np.array([1.0, -2.0, 0.5, 3.0])
    assert slope_weights(at) @ values == pytest.approx(np.polyfit(at, values, 1)[0])
    assert slope_weights(np.array([7.0])).tolist() == [0.0]


def test_accumulated_slope_sums_outwards_on_both_sides() -> None:
    at, angle = np.array([-40.0, -10.0, 0.0, 30.0, 50.0]), np.array([4.0, 1.0, 9.0, 2.0, -3.0])
    right = [30.0 * 2.0, 30.0 * 2.0 - 50.0 * 3.0]
    left = [-10.0 * 1.0, -10.0 * 1.0 - 40.0 * 4.0]
    expected = np.polyfit([-40.0, -10.0, 30.0, 50.0], [left[1], left[0], *right], 1)[0]
    assert accumulated_slope(at, 2) @ angle == pytest.approx(expected)


def test_axis_lines_are_those_of_table_2() -> None:
    machine = dmu60p().with_values(ErrorValues(machine="dmu60p", parameters=PARAMETERS))
    lines = {line.axis: line for line in axis_lines(machine)}
    assert machine.location_errors == ("eps_xy", "eps_yz", "eps_xz")
    assert np.allclose(lines["X"].by_location, [[0, 0, 0], [1, 0, 0], [0, 0, 0]])
    assert np.allclose(lines["Y"].by_location, 0.0)
    assert np.allclose(lines["Z"].by_location, [[0, 0, 1], [0, -1, 0], [0, 0, 0]])
    # pairs XY, XZ, YZ: pi/2 less the angle is eps_xy, eps_xz and -eps_yz
    assert np.allclose(angle_matrix(tuple(lines[a] for a in "XYZ")), [[1, 0, 0], [0, 0, 1], [0, -1, 0]])
    assert units(machine) == ("mm", "mm", "mm", "rad", "rad", "rad") * 3 + ("rad",) * 3


def test_noise_given_estimated_or_unknown() -> None:
    assert noise(8.0, 12, 10, None).sigma == 2.0
    assert noise(8.0, 12, 10, 3.0).sigma == 0.003
    assert noise(0.0, 10, 10, None).sigma is None


def test_tables_become_polynomials() -> None:
    at = np.linspace(0.0, 500.0, 26)
    values = 2e-5 * at - 3e-8 * at**2 + np.random.default_rng(1).normal(0.0, 1e-5, at.size)
    table = TableCurve(tuple(at), tuple(values), (0.0, *(1e-5,) * 25))
    short = TableCurve((0.0, 10.0), (0.0, 1e-5))
    tables = {"EXX": table, "EYX": short}
    curves, notes = polynomial_curves(tables, fit_tables(tables))
    fitted = curves["EXX"]
    assert isinstance(fitted, PolynomialCurve)
    assert np.abs(fitted(at) - (2e-5 * at - 3e-8 * at**2)).max() < 2e-5
    assert curves["EYX"] is short
    assert notes == ("EYX stays a table: too few positions for a polynomial",)


def test_report_reads_well_and_is_json() -> None:
    options = PaperOptions("known", ErrorValues(machine="dmu60p", parameters=PARAMETERS), noise_um=0.3)
    report = identify_paper(dmu60p(), paper_data(generator(cubic_errors()), 4, P9_PRINTED), options).report
    text = report_text(report)
    assert "RANK 6 OF 9" in text
    assert "3. Z-7 Z-8 Z-9 -> EZZ EAZ EBZ" in text
    assert max(map(len, text.splitlines())) <= 100 + 5
    tree = json.loads(report_json(report))
    assert tree["blocks"][2]["rank"] == 6
    assert tree["noise_um"] == 0.3


def test_nothing_of_the_symbolic_side_is_imported() -> None:
    folder = Path(__file__).parents[2] / "src" / "trueaxis" / "identification"
    sources = list(folder.rglob("*.py"))
    assert sources
    assert not [path for path in sources if "sympy" in path.read_text() or "trueaxis.derivation" in path.read_text()]
