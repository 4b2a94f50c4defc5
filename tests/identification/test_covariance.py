"""From the readings' noise to the uncertainty of a predicted deviation: derivatives, Monte Carlo, coverage, files."""

import io
import json
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import polars as pl
import pytest

from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.generator.dmu60p import dmu60p as generator
from tests.identification.data import mixed_data, noisy, paper_data, with_estimation
from tests.identification.test_command import KERNELS, MACHINE, identify, known, simulated
from tests.identification.test_estimated import CONVENTION, KNOWN
from trueaxis.cli.main import main
from trueaxis.error_name import ErrorName
from trueaxis.estimation.observations import Observations
from trueaxis.identification.curve_fit import in_polynomials
from trueaxis.identification.estimated import Choice, identify_estimated
from trueaxis.identification.paper.method import identify_paper
from trueaxis.identification.paper.solution import PaperOptions
from trueaxis.identification.report import Identification
from trueaxis.identification.weighting import NoiseModel
from trueaxis.io.faults import InputError
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.points import PRIOR_COLUMNS, UNCERTAINTY_COLUMNS
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.model.bases import Basis, HatBasis, LegendreBasis, PowerBasis
from trueaxis.model.covariance import Covariance
from trueaxis.model.covariance_file import dump_covariance, read_covariance
from trueaxis.model.curves import Curve, PolynomialCurve, TableCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, home_of, load_model
from trueaxis.model.uncertainty import derivative, tool_uncertainty


def predicted_u(model: MachineModel, found: Covariance, positions: FloatArray, tool: FloatArray) -> FloatArray:
    """From home, which is the first position where it matters."""
    return tool_uncertainty(model, found, positions, tool, datum=home_of(model)).u


def legendre(found: Covariance) -> list[tuple[str, LegendreBasis]]:
    pairs = list(zip(found.components, found.bases, strict=True))
    return [(name, basis) for name, basis in pairs if isinstance(basis, LegendreBasis)]


LEAST_SQUARES = ["--prior", "none", "--degree", "3", "--squareness", "known", "--instruments", "ideal"]
QUIET_UM = 0.01  # with more noise some combinations are open
TOOL = np.array([[12.0], [-35.0], [60.0]])
AT = np.array([[0.0, 540.0, 200.0, 33.0], [0.0, 700.0, 100.0, 650.0], [0.0, 600.0, 333.0, 10.0]])
SIGMA = 3e-4


@cache
def machine() -> MachineModel:
    return load_model(MACHINE, None, Path(KERNELS[1]), backend="numpy")


def values_of(found: Covariance, values: FloatArray, others: dict[str, float]) -> ErrorValues:
    """Error values from coefficients of the bases, by powers."""
    curves, start = {}, 0
    for name, basis in legendre(found):
        powers = values[start : start + basis.degree] @ basis.powers
        curves[name] = PolynomialCurve(powers=tuple(range(1, basis.degree + 1)), coefficients=tuple(powers.tolist()))
        start += basis.degree
    located = dict(zip(found.locations, values[start:].tolist(), strict=True))
    return ErrorValues(machine="dmu60p", parameters={**others, **located}, motion_errors=curves)


@cache
def identified(squareness: Choice, count: int = 6) -> Identification:
    options = with_estimation(KNOWN if squareness == "known" else CONVENTION, degree=3)
    found = identify_estimated(
        machine(), mixed_data(cubic_errors(), count), replace(options, noise=NoiseModel(um=QUIET_UM))
    )
    assert found.covariance.open.shape[1] == 0
    return found


def model_and_covariance(squareness: Choice) -> tuple[MachineModel, Covariance]:
    return machine().with_values(ErrorValues(machine="dmu60p", parameters=PARAMETERS)), identified(
        squareness
    ).covariance


def test_derivative_is_that_of_finite_differences() -> None:
    model, found = model_and_covariance("convention")
    analytic = derivative(model, found, AT, TOOL)
    scale = 1e-3 + np.sqrt(np.diag(found.matrix))
    for index in range(found.count):
        step = np.zeros(found.count)
        step[index] = scale[index]
        ends = [
            machine().with_values(values_of(found, sign * step, PARAMETERS | dict.fromkeys(found.locations, 0.0)))
            for sign in (1.0, -1.0)
        ]
        by_difference = [end.view_deviation("tool_in_workpiece", AT, TOOL) for end in ends]
        slope = (by_difference[0] - by_difference[1]) / (2.0 * scale[index])
        assert np.allclose(slope, analytic[:, index], rtol=1e-4, atol=1e-4 * np.abs(analytic[:, index]).max() + 1e-9)


def test_predicted_uncertainty_is_the_scatter_of_drawn_error_values() -> None:
    """JCGM 101: 4000 draws of all values through the exact model; standard error of a standard deviation 1.1 %."""
    model, found = model_and_covariance("convention")
    scale = np.sqrt(np.diag(found.matrix)) + 1e-30
    squares, directions = np.linalg.eigh(found.matrix / np.outer(scale, scale))
    factor = scale[:, np.newaxis] * directions * np.sqrt(np.maximum(squares, 0.0))
    draws = np.random.default_rng(4).normal(size=(4000, found.count)) @ factor.T
    deviations = np.array(
        [
            machine().with_values(values_of(found, draw, PARAMETERS)).view_deviation("tool_in_workpiece", AT, TOOL)
            for draw in draws
        ]
    )
    u = predicted_u(model, found, AT, TOOL)
    from_home = deviations - deviations[:, :, :1]
    assert np.allclose(from_home.std(axis=0)[:, 1:], u[:, 1:], rtol=0.05)


@pytest.mark.parametrize("fitted", [False, True], ids=["tables", "polynomials"])
def test_u_of_the_stepwise_method_is_the_scatter_of_repeated_identification(fitted: bool) -> None:
    """60 draws: standard error 9 %. Polynomials are those of one draw: choosing them anew is no part of u."""
    clean = paper_data(generator(cubic_errors()), 6)
    options = PaperOptions(squareness="convention", noise_um=0.3)
    source, deviations = np.random.default_rng(9), []
    base = identify_paper(machine(), clean, options)
    covariance, at = base.covariance, AT[:, 1:]
    tables = base.values.motion_errors
    powers = {name: PolynomialCurve(powers=(1, 2, 3), coefficients=(0.0, 0.0, 0.0)) for name in tables}
    if fitted:
        covariance = in_polynomials(covariance, tables, powers)
    for _ in range(60):
        noisy = replace(clean, reading=clean.reading + source.normal(0.0, SIGMA, clean.reading.size))
        values = identify_paper(machine(), noisy, options).values
        if fitted:
            values = replace(values, motion_errors={n: cubic(c) for n, c in values.motion_errors.items()})
        deviations.append(machine().with_values(values).view_deviation("tool_in_workpiece", at, np.zeros((3, 1))))
    u = predicted_u(machine(), covariance, at, np.zeros((3, 1)))
    spread = np.std(np.array(deviations), axis=0, ddof=1) / u
    assert np.all((spread > 0.65) & (spread < 1.4)), spread
    assert spread.mean() == pytest.approx(1.0, abs=0.12)


def cubic(curve: Curve) -> PolynomialCurve:
    """Unweighted least squares by NumPy, through zero at zero."""
    assert isinstance(curve, TableCurve)
    x, y = np.array(curve.positions), np.array(curve.values)
    u = np.array(curve.u)[x != 0.0]
    weights = 1.0 / u if np.isfinite(u).all() and (u > 0.0).all() else np.ones(u.size)
    x, y = x[x != 0.0] / 700.0, y[x != 0.0]
    found = np.linalg.lstsq(weights[:, np.newaxis] * x[:, np.newaxis] ** [1, 2, 3], weights * y, rcond=None)[0]
    return PolynomialCurve(powers=(1, 2, 3), coefficients=tuple((found / 700.0 ** np.array([1, 2, 3])).tolist()))


def operator(data: Observations, found: Identification) -> FloatArray:
    """(n_values, n_readings): least squares by NumPy, from central differences of the expected readings."""
    columns = []
    covariance = found.covariance
    size = np.sqrt(np.diag(covariance.matrix))
    for index in range(covariance.count):
        step = np.zeros(covariance.count)
        step[index] = size[index]
        ends = [
            expected_readings(
                machine().with_values(values_of(covariance, sign * step, PARAMETERS)),
                data.runs,
                data.run,
                data.positions,
            )
            for sign in (1.0, -1.0)
        ]
        columns.append((ends[0] - ends[1]) / 2.0)
    return np.asarray(size[:, np.newaxis] * np.linalg.pinv(np.array(columns).T))


def coefficients(found: Identification) -> FloatArray:
    return np.concatenate([found.values.motion_errors[name].coefficients for name in found.covariance.components])  # type: ignore[union-attr]


def test_intervals_of_95_percent_cover_95_percent() -> None:
    """2000 draws of all readings' noise: every value and deviations anywhere, against the truth of the generator.

    Least squares are linear in the readings within the size of the errors (1e-4): of each draw the identification is
    the one without noise, which gives the truth, plus a matrix times the noise. Whole identifications agree with that.
    """
    clean = mixed_data(cubic_errors(), 6)
    options = with_estimation(KNOWN, degree=3)
    base = identified("known")
    sigma = QUIET_UM * 1e-3
    gain = operator(clean, base)
    u = np.sqrt(np.diag(base.covariance.matrix))
    for seed in range(3):
        spoilt = noisy(clean, seed, sigma)
        whole = identify_estimated(machine(), spoilt, replace(options, noise=NoiseModel(um=QUIET_UM)))
        off = coefficients(whole) - coefficients(base) - gain @ (spoilt.reading - clean.reading)
        assert np.abs(off / u).max() < 1e-2
    wrong = gain @ np.random.default_rng(12).normal(0.0, sigma, (clean.reading.size, 2000))
    quantile = 1.959964
    each = (np.abs(wrong) <= quantile * u[:, np.newaxis]).mean(axis=1)
    assert 0.94 < each.mean() < 0.96
    assert np.abs(each - 0.95).max() < 0.02  # 4 standard errors of 0.5 %
    model = machine().with_values(base.values)
    by_value = derivative(model, base.covariance, AT[:, 1:], TOOL) - derivative(model, base.covariance, AT[:, :1], TOOL)
    at_tool = np.einsum("ikn,kd->ind", by_value, wrong)
    of_point = predicted_u(model, base.covariance, AT[:, 1:], TOOL)[..., np.newaxis]
    share = (np.abs(at_tool) <= quantile * of_point).mean(axis=2)
    assert np.abs(share - 0.95).max() < 0.02
    assert 0.94 < share.mean() < 0.96


def test_commands_write_and_read_it(tmp_path: Path) -> None:
    data = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.05")
    out, file = tmp_path / "e.json", tmp_path / "c.npz"
    options = [*LEAST_SQUARES, "--known", str(known(tmp_path))]
    assert identify(data, out, *options, "--covariance", str(file)) == 0
    again = tmp_path / "again.npz"
    assert identify(data, tmp_path / "e2.json", *options, "--covariance", str(again)) == 0
    assert file.read_bytes() == again.read_bytes()
    points = tmp_path / "points.csv"
    points.write_text("X,Y,Z,tool_x\n540,700,600,0\n10,20,30,50\n")
    arguments = ["predict", str(MACHINE), "--errors", str(out), "--covariance", str(file), "--at", str(points)]
    assert main([*arguments, "--out", str(tmp_path / "p.csv"), *KERNELS]) == 0
    table = pl.read_csv(tmp_path / "p.csv")
    assert table.columns[-9:] == ["dx", "dy", "dz", *UNCERTAINTY_COLUMNS, *PRIOR_COLUMNS]
    assert table["u_prior_dx"].to_list() == [0.0, 0.0]  # plain least squares
    assert table["u_dx"][0] > table["u_dx"][1] > 0.0
    assert table["u_dx"][0] < 0.02


def test_what_is_open_has_no_uncertainty(tmp_path: Path) -> None:
    """The published points: what Z is rests on what they leave open; what X does along itself does not."""
    data = simulated(tmp_path, "dmu60p_runs", "--noise-um", "0.01")
    out, file = tmp_path / "e.json", tmp_path / "c.npz"
    options = [*LEAST_SQUARES, "--known", str(known(tmp_path))]
    assert identify(data, out, *options, "--covariance", str(file)) == 0
    model = load_model(MACHINE, out, Path(KERNELS[1]), backend="numpy")
    found = read_covariance(file, model.machine)
    u = predicted_u(model, found, np.array([[300.0, 0.0], [0.0, 0.0], [0.0, 400.0]]), np.zeros((3, 1)))
    assert np.isfinite(u[0, 0])
    assert np.isnan(u[2, 1])


@pytest.mark.parametrize("damage", ["text", "cut", "machine", "shape"])
def test_damaged_files_are_told(tmp_path: Path, damage: str) -> None:
    found = identified("known").covariance
    file = tmp_path / "c.npz"
    data = dump_covariance(replace(found, open=found.open[:3]) if damage == "shape" else found)
    file.write_bytes({"text": b"no archive", "cut": data[:-40]}.get(damage, data))
    with pytest.raises(InputError):
        read_covariance(file, replace(machine().machine, name="other") if damage == "machine" else machine().machine)


def small_archive() -> dict[str, Any]:
    """The arrays of a valid covariance file of two values."""
    covariance = Covariance(
        machine="dmu60p",
        components=(ErrorName("EXX"),),
        bases=(LegendreBasis(low=0.0, high=540.0, degree=2),),
        locations=(),
        root=np.eye(2) * 1e-6,
        open=np.zeros((2, 1)),
    )
    with np.load(io.BytesIO(dump_covariance(covariance))) as archive:
        return {key: np.array(archive[key]) for key in archive}


@pytest.mark.parametrize(
    ("name", "value"),
    [("data", 1e308), ("data", np.nan), ("open", 1e308), ("open", np.inf), ("indices", 7), ("indptr", 99)],
)
def test_numbers_that_no_identification_writes_are_told(tmp_path: Path, name: str, value: float) -> None:
    arrays = small_archive()
    arrays[name].flat[0] = value
    file = tmp_path / "c.npz"
    np.savez(file, **arrays)
    with pytest.raises(InputError, match=r"c\.npz"):
        read_covariance(file, machine().machine)


@pytest.mark.parametrize("change", ["text", "dates", "columns", "rows", "float indices", "falling"])
def test_arrays_that_no_identification_writes_are_told(tmp_path: Path, change: str) -> None:
    arrays = small_archive()
    head = json.loads(arrays["head"].tobytes())
    if change in ("columns", "rows"):
        head["shape"][change == "columns"] = 10**12
    arrays |= {
        "head": np.frombuffer(json.dumps(head).encode(), dtype=np.uint8),
        **({"data": np.array(["a", "b"])} if change == "text" else {}),
        **({"open": np.array([["2026-01-01"], ["2026-01-02"]], dtype="datetime64[D]")} if change == "dates" else {}),
        **({"indices": np.array([0.5, 1.0])} if change == "float indices" else {}),
        **({"indptr": np.array([0, 2, 1])} if change == "falling" else {}),
    }
    file = tmp_path / "c.npz"
    np.savez(file, **arrays)
    with pytest.raises(InputError, match=r"c\.npz: is no covariance file"):
        read_covariance(file, machine().machine)


def test_every_basis_comes_back(tmp_path: Path) -> None:
    bases = (
        LegendreBasis(low=100.0, high=540.0, degree=2, home=100.0),
        LegendreBasis(low=-360.0, high=360.0, degree=1, harmonics=2),
        HatBasis((0.0, 10.0)),
        PowerBasis((1, 3)),
    )
    covariance = Covariance(
        machine="dmu60p",
        components=tuple(map(ErrorName, ("EXX", "EYX", "EZX", "EAX"))),
        bases=bases,
        locations=(),
        root=np.eye(11),
        open=np.zeros((11, 0)),
    )
    file = tmp_path / "c.npz"
    file.write_bytes(dump_covariance(covariance))
    assert read_covariance(file, machine().machine).bases == bases


@pytest.mark.parametrize(
    "basis",
    [
        LegendreBasis(low=-1e300, high=0.0, degree=2),
        LegendreBasis(low=0.0, high=np.inf, degree=2),
        LegendreBasis(low=0.0, high=360.0, degree=4, harmonics=-1),
        HatBasis((0.0, np.nan)),
        PowerBasis((1, 500)),
    ],
)
def test_bases_that_no_identification_writes_are_told(tmp_path: Path, basis: Basis) -> None:
    covariance = Covariance(
        machine="dmu60p",
        components=(ErrorName("EXX"),),
        bases=(basis,),
        locations=(),
        root=np.eye(2),
        open=np.zeros((2, 0)),
    )
    file = tmp_path / "c.npz"
    file.write_bytes(dump_covariance(covariance))
    with pytest.raises(InputError, match="bases"):
        read_covariance(file, machine().machine)


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (
            ["--robust", "huber", "--covariance", "c.txt", "--curves", "table"],
            ["--robust", "--curves", "not a .npz file"],
        ),
        (
            [
                "--method",
                "stepwise",
                "--prior",
                "none",
                "--degree",
                "3",
                "--instruments",
                "ideal",
                "--noise-um",
                "laser=1",
            ],
            ["--prior", "--degree", "--instruments", "--noise-um"],
        ),
    ],
)
def test_every_fault_of_the_options_is_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], options: list[str], told: list[str]
) -> None:
    out = tmp_path / "e.json"
    assert identify(MACHINE.parent / "dmu60p_regular_runs", out, *options) == 2
    said = capsys.readouterr().err
    for words in told:
        assert words in said
    assert not out.exists()


@pytest.mark.parametrize(
    ("options", "remedy"),
    [(["--degree", "auto"], "--prior spec"), (["--instruments", "offset,centre"], "'real', 'ideal'")],
)
def test_options_that_are_no_more_name_what_takes_their_place(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], options: list[str], remedy: str
) -> None:
    with pytest.raises(SystemExit) as caught:
        identify(MACHINE.parent / "dmu60p_regular_runs", tmp_path / "e.json", *options)
    assert caught.value.code == 2
    assert remedy in capsys.readouterr().err
