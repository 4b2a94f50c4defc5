"""Polynomials from the curves of an estimate: dense generalised least squares, prediction, curves that stay."""

import json
from pathlib import Path

import numpy as np
import pytest

from tests.identification.fit_loss import loss
from tests.identification.test_command import ERRORS, KERNELS, MACHINE, identify, simulated
from tests.machines import ROOT
from tests.worlds.estimates import world
from trueaxis.cli.main import main
from trueaxis.error_name import ErrorName
from trueaxis.identification.legendre_fit import fit_legendre, legendre_samples, whitening, with_polynomials
from trueaxis.machine import Machine, read_machine
from trueaxis.model.bases import travel_basis
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import FloatArray, LegendreCurve, PolynomialCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import home_of, load_model

DEGREE = 8
TRAVEL = (100.0, 540.0)  # without 0: home is its lower end


@pytest.fixture(scope="module")
def machine() -> Machine:
    return read_machine(MACHINE)


def estimate_of(coefficients: dict[str, FloatArray], root: FloatArray) -> tuple[ErrorValues, Covariance]:
    basis = travel_basis(TRAVEL, DEGREE)
    curves = {
        name: LegendreCurve(basis=basis, coefficients=tuple(c.tolist()), measured=TRAVEL)
        for name, c in coefficients.items()
    }
    errors = ErrorValues(machine="dmu60p", parameters={"eps_xy": 2e-5}, motion_errors=curves)
    covariance = Covariance(
        machine="dmu60p",
        components=tuple(map(ErrorName, curves)),
        bases=(basis,) * len(curves),
        locations=("eps_xy",),
        root=root,
        open=np.zeros((root.shape[0], 0)),
        of_prior=root.shape[1] // 2,
    )
    return errors, covariance


def cubic() -> FloatArray:
    """Legendre coefficients of 2e-5 (s - h) - 4e-11 (s^3 - h^3), mm, h = 100 mm."""
    basis, at = travel_basis(TRAVEL, DEGREE), np.linspace(*TRAVEL, DEGREE + 1)[1:]
    values: FloatArray = 2e-5 * (at - 100.0) - 4e-11 * (at**3 - 100.0**3)
    return np.asarray(np.linalg.solve(basis(at).T, values))


def test_whitened_values_are_independent() -> None:
    root = np.random.default_rng(1).normal(size=(6, 9)) * np.array([1e-3, 1, 1, 1e-2, 1, 1])[:, np.newaxis]
    white = whitening(root)
    np.testing.assert_allclose(white @ root @ (white @ root).T, np.eye(6), atol=1e-9)


def test_a_singular_covariance_keeps_what_is_known_exactly() -> None:
    root = np.zeros((3, 3))
    root[1:, 1:] = np.array([[2.0, 1.0], [0.0, 1.0]])
    white = whitening(root)
    assert np.linalg.norm(white @ np.array([1.0, 0.0, 0.0])) > 1e5


def test_a_polynomial_comes_back_whatever_the_covariance(machine: Machine) -> None:
    """Zero at home, which is not 0: there is a constant term."""
    root = 1e-6 * np.random.default_rng(2).normal(size=(DEGREE + 1, 20))
    errors, covariance = estimate_of({"EXX": cubic()}, root)
    fits, resting = fit_legendre(errors, covariance, machine, max_order=5, alpha=0.05)
    assert resting == ()
    fitted, after = with_polynomials(errors, covariance, machine, fits)
    curve = fitted.motion_errors["EXX"]
    assert isinstance(curve, PolynomialCurve)
    assert curve.measured == TRAVEL
    at = np.linspace(*TRAVEL, 50)
    np.testing.assert_allclose(curve(at), errors.motion_errors["EXX"](at), atol=3e-6)
    assert curve(np.array([100.0]))[0] == pytest.approx(0.0, abs=1e-12)
    assert curve.u is not None
    assert curve.u_readings is not None
    assert curve.u_prior is not None
    np.testing.assert_allclose(np.hypot(curve.u_readings, curve.u_prior), curve.u, rtol=1e-9)
    assert after.of_prior == covariance.of_prior


def test_all_polynomials_are_one_generalised_least_squares(machine: Machine) -> None:
    """Two curves whose sum is known ten times better than each, and a squareness that goes along, against a dense
    formula; a rough part that no polynomial follows counts as uncertainty.
    """
    draw = np.random.default_rng(4)
    n = 2 * DEGREE + 1
    each = 1e-4 * draw.normal(size=(DEGREE, DEGREE))
    root = np.zeros((n, 3 * DEGREE))
    root[:DEGREE, :DEGREE], root[DEGREE:-1, :DEGREE] = each, -each
    root[DEGREE:-1, DEGREE : 2 * DEGREE] = 1e-5 * np.eye(DEGREE)
    root[-1] = 1e-6 * draw.normal(size=3 * DEGREE)
    rough = 3e-6 * draw.normal(size=DEGREE)
    errors, covariance = estimate_of({"EXX": cubic() + rough, "EYX": 0.5 * cubic()}, root)
    fits, _ = fit_legendre(errors, covariance, machine, max_order=3, alpha=0.9)
    assert all(fit.after.powers for fit in fits.values())
    fitted, after = with_polynomials(errors, covariance, machine, fits)
    basis = travel_basis(TRAVEL, DEGREE)
    at = np.linspace(*TRAVEL, DEGREE + 1)[1:]
    inverse = np.linalg.inv(basis(at).T)
    design, start, sigma = np.zeros((n, 0)), np.zeros(n), root @ root.T
    for rows, name in ((slice(0, DEGREE), "EXX"), (slice(DEGREE, 2 * DEGREE), "EYX")):
        powers = np.array(fits[name].after.powers)
        terms = (at[:, np.newaxis] / 100.0) ** powers - 1.0
        part = np.zeros((n, powers.size))
        part[rows] = inverse @ terms
        design = np.hstack([design, part])
        values = errors.motion_errors[name](at)
        start[rows] = inverse @ values
        left = values - terms @ np.linalg.lstsq(terms, values, rcond=None)[0]
        size = float(left @ left) / (DEGREE - powers.size)
        sigma[rows, rows] += size * inverse @ inverse.T
    design = np.hstack([design, np.eye(n)[:, -1:]])
    weight = np.linalg.inv(sigma)
    numbers = np.linalg.solve(design.T @ weight @ design, design.T @ weight @ start)
    changed = design @ numbers
    for rows, name in ((slice(0, DEGREE), "EXX"), (slice(DEGREE, 2 * DEGREE), "EYX")):
        np.testing.assert_allclose(fitted.motion_errors[name](at), basis(at).T @ changed[rows], rtol=1e-4, atol=1e-8)
    assert fitted.parameters["eps_xy"] == pytest.approx(2e-5 + changed[-1], abs=1e-10)
    assert np.asarray(after.root).shape == (n, root.shape[1] + 1)
    np.testing.assert_allclose(after.matrix, root @ root.T + np.outer(changed - start, changed - start), atol=1e-12)


def test_where_a_curve_is_sampled_makes_no_difference() -> None:
    """As many positions as coefficients: the same least squares, and a covariance given the other values."""
    draw = np.random.default_rng(7)
    root = 1e-4 * draw.normal(size=(DEGREE + 3, DEGREE + 3))
    white: FloatArray = np.asarray(np.linalg.inv(root))
    precision = np.linalg.inv(root @ root.T)
    curve = LegendreCurve(basis=travel_basis(TRAVEL, DEGREE), coefficients=tuple(cubic().tolist()))
    even = legendre_samples(curve, white[:, :DEGREE], 5)
    at = np.sort(draw.uniform(150.0, 540.0, DEGREE))
    given_others = np.linalg.inv(precision[:DEGREE, :DEGREE])
    other = curve.basis(at).T @ given_others @ curve.basis(at)
    scale, powers = np.array([100.0, 1e4]), np.array([1.0, 2.0])
    first = (even.positions[:, np.newaxis] ** powers - 100.0**powers) / scale
    second = (at[:, np.newaxis] ** powers - 100.0**powers) / scale
    solved = np.linalg.lstsq(even.weighed(first), even.weighed(even.values), rcond=None)[0]
    weight = np.linalg.inv(other)
    expected = np.linalg.solve(second.T @ weight @ second, second.T @ weight @ curve(at))
    np.testing.assert_allclose(solved, expected, rtol=1e-3)


@pytest.mark.parametrize("travel", [(-360.0, 360.0), (0.0, 360.0), (-540.0, 540.0)])
@pytest.mark.parametrize(("wave", "follows"), [(0.0, True), (2e-2, False)])
def test_a_polynomial_follows_no_turn(
    machine: Machine, travel: tuple[float, float], wave: float, follows: bool
) -> None:
    """A line and, three times a turn, a wave that is 1000 times its uncertainty: what is evenly sampled shows it."""
    basis = travel_basis(travel, 6, harmonics=3)
    coefficients = np.zeros(basis.count)
    coefficients[0], coefficients[-2] = 1e-2, wave
    curve = LegendreCurve(basis=basis, coefficients=tuple(coefficients.tolist()), measured=travel)
    covariance = Covariance(
        machine="dmu60p",
        components=(ErrorName("EXX"),),
        bases=(basis,),
        locations=(),
        root=2e-5 * np.random.default_rng(5).normal(size=(basis.count, 2 * basis.count)),
        open=np.zeros((basis.count, 0)),
    )
    errors = ErrorValues(machine="dmu60p", motion_errors={"EXX": curve})
    fits, _ = fit_legendre(errors, covariance, machine, max_order=5, alpha=0.05)
    assert bool(fits["EXX"].after.powers) == follows
    fitted, _ = with_polynomials(errors, covariance, machine, fits)
    at = np.linspace(*travel, 50)
    np.testing.assert_allclose(fitted.motion_errors["EXX"](at), curve(at), atol=1e-4)
    assert isinstance(fitted.motion_errors["EXX"], PolynomialCurve if follows else LegendreCurve)


def off(errors: Path) -> float:
    """Root mean square of a coordinate of the error of the predicted tool point, from home, over the volume, um."""
    model, true = (load_model(MACHINE, path, ROOT / "generated") for path in (errors, ERRORS))
    draw = np.random.default_rng(9)
    positions = np.array([draw.uniform(*model.travel[axis], 300) for axis in model.axes])
    tool, home = np.zeros((3, 1)), home_of(model)
    moved = [one.deviation(positions, tool) - one.deviation(home, tool) for one in (model, true)]
    return 1e3 * float(np.sqrt(((moved[0] - moved[1]) ** 2).mean()))


def test_readme_s_way_loses_little(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """identify, fit, compensate, with a laser of 0.3 um on the paper's machine."""
    data = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.3", "--seed", "1")
    out, fitted = tmp_path / "e.json", tmp_path / "f.json"
    assert identify(data, out, "--method", "global") == 0
    assert main(["fit", str(MACHINE), "--errors", str(out), "--out", str(fitted), *KERNELS]) == 0
    assert off(fitted) < 1.2 * off(out)
    tree = json.loads(fitted.read_text())
    bases = {name: curve["basis"] for name, curve in tree["motion_errors"].items()}
    assert bases["EXX"] == bases["EYY"] == bases["EZZ"] == "polynomial"
    assert "the Legendre curve is kept" in capsys.readouterr().out
    (tmp_path / "part.nc").write_text("G21 G90\nG1 X270. Y350. Z150. F1000\nX280.\n")
    words = ["compensate", str(MACHINE), "--errors", str(fitted), str(tmp_path / "part.nc")]
    assert main([*words, "--out", str(tmp_path / "c.nc"), *KERNELS]) == 0
    assert tree["determined"]["EXX"] == "data"


def test_a_silent_curve_stays_and_is_drawn_as_such(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.3")
    rows = (data / "readings.csv").read_text().splitlines()
    column = rows[0].split(",").index("run")
    kept = [rows[0], *(row for row in rows[1:] if row.split(",")[column].startswith("X-"))]
    (data / "readings.csv").write_text("\n".join(kept) + "\n")
    head, *runs = (data / "setup.toml").read_text().split("[[run]]")
    (data / "setup.toml").write_text("[[run]]".join([head, *(run for run in runs if 'id = "X-' in run)]))
    out, fitted = tmp_path / "e.json", tmp_path / "f.json"
    assert identify(data, out, "--method", "global") == 0
    capsys.readouterr()
    words = ["fit", str(MACHINE), "--errors", str(out), "--out", str(fitted), *KERNELS]
    assert main([*words, "--picture", str(tmp_path / "p.png")]) == 0
    before, after = (json.loads(path.read_text()) for path in (out, fitted))
    assert before["determined"]["EYY"] == "prior"
    assert after["motion_errors"]["EYY"]["basis"] == "legendre"
    assert after["motion_errors"]["EXX"]["basis"] == "polynomial"
    said = capsys.readouterr().out
    assert "the readings do not determine these errors; their Legendre curves are kept" in said
    assert "EYY: " not in said.split("note:")[0]  # no statistics of what no reading tells
    assert (tmp_path / "p.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.slow
def test_the_loss_on_smooth_curves_that_are_no_polynomials(tmp_path: Path) -> None:
    got = loss(world(408, tmp_path, 3), 408)
    assert got.polynomials < 1.5 * got.curves
    assert got.coverage_after >= 0.9
    assert got.fitted > got.components / 3.0
