"""No wrong result leaves `identify` with exit code 0: not converged, misfit, and good fits of many readings."""

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.identification.random_plans import Drawn, drawn, outcome
from tests.identification.test_command import ERRORS, KERNELS, LEAST_SQUARES, MACHINE, identify, simulated, values
from trueaxis.cli.main import main
from trueaxis.estimation.observations import Observations, copied_runs
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.fit_quality import NotConvergedError, Residuals, quality, stands_still
from trueaxis.identification.paper.method import identify_paper
from trueaxis.identification.paper.solution import PaperOptions
from trueaxis.identification.report_text import fit_text
from trueaxis.identification.weighting import NoiseModel
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.errors import ErrorValues

RUNS = tuple(
    Run(
        id=name,
        instrument="laser",
        target=PointOn("tool"),
        reference=PointOn("bed"),
        frame="bed",
        home={"X": 0.0},
        direction=(1.0, 0.0, 0.0),
    )
    for name in ("a", "b")
)


def residuals(of_a: float, of_b: float, noise: float | None = 1e-3, size: float | None = None) -> Residuals:
    """A hundred readings of each run, with that residual each, mm."""
    squares = np.repeat([of_a**2, of_b**2], 100)
    return Residuals(
        run=np.repeat([0, 1], 100),
        count=np.ones(200),
        squares=squares,
        noise=np.full(200, np.nan if noise is None else noise),
        size=None if size is None else np.full(200, size),
        freedom=150,
    )


@pytest.mark.parametrize(
    ("judged", "state", "runs"),
    [
        (residuals(1e-3, 1e-3), "converged", ()),
        (residuals(2e-3, 2e-3), "converged", ()),  # a model that lacks as much as the noise is no misfit
        (residuals(4e-3, 3.5e-3), "misfit", ("a", "b")),
        (residuals(1e-4, 6e-3), "misfit", ("b",)),
        (residuals(5e-4, 5e-4, noise=1e-5, size=0.04), "converged", ()),  # no model is right to a hundredth of a um
        (residuals(5e-3, 5e-3, noise=1e-5, size=0.04), "misfit", ("a", "b")),
        (residuals(5e-3, 5e-3, noise=None, size=0.04), "converged", ()),
        (residuals(5e-2, 5e-2, noise=None, size=0.04), "misfit", ("a", "b")),
    ],
)
def test_residuals_are_judged_by_the_noise_or_by_the_prior(
    judged: Residuals, state: str, runs: tuple[str, ...]
) -> None:
    found = quality(judged, RUNS)
    assert found.fit.state == state
    assert found.fit.runs == runs
    assert (found.fit.chi2 is None) == bool(np.isnan(judged.noise).any())


@pytest.mark.parametrize(
    ("of_a", "of_b", "state", "runs"),
    [
        (1e-3, 1e-3, "converged", ()),
        (4e-3, 1e-3, "misfit", ("a",)),
        (1e-3, 8e-3, "converged", ()),  # nothing says what the ball bar's readings scatter by
        (1e-3, 5e-2, "misfit", ("b",)),  # but more than any machine can be off by
    ],
)
def test_an_instrument_whose_noise_is_known_is_judged_beside_one_whose_noise_is_not(
    of_a: float, of_b: float, state: str, runs: tuple[str, ...]
) -> None:
    """A ball bar without repeats left the laser unjudged, too."""
    both = residuals(of_a, of_b, size=0.02)
    both = replace(both, noise=np.where(both.run == 0, 1e-3, np.nan))
    found = quality(both, (RUNS[0], replace(RUNS[1], instrument="ballbar")))
    assert found.fit.state == state
    assert found.fit.runs == runs
    assert found.fit.unjudged == ("ballbar",)
    assert found.fit.chi2 == pytest.approx((of_a / 1e-3) ** 2 * 200 / 150)
    if state == "converged":
        assert "the residuals of ballbar could not be judged: no noise is stated for it" in fit_text(found)


def test_as_many_unknowns_as_readings_leave_nothing_to_judge_by() -> None:
    """Whether or not the noise is stated: it was said that none is."""
    found = quality(replace(residuals(1e-3, 1e-3, size=0.02), freedom=0), RUNS)
    assert found.fit.chi2 is None
    assert "as many unknowns as readings" in fit_text(found)
    assert "noise" not in fit_text(found)


def test_a_good_fit_of_many_readings_is_no_misfit() -> None:
    rng = np.random.default_rng(1)
    many = 100_000
    squares = rng.normal(0.0, 1.02e-3, many) ** 2  # 2 % more than the noise: a p-value of zero
    one = Residuals(
        run=np.zeros(many, dtype=np.int64),
        count=np.ones(many),
        squares=squares,
        noise=np.full(many, 1e-3),
        size=None,
        freedom=many - 100,
    )
    assert quality(one, RUNS).fit.state == "converged"


def test_a_step_is_judged_by_the_uncertainty() -> None:
    u = np.array([2.0, 1.0])
    assert stands_still(np.array([1e-6, 0.0]), u, 1e-3)
    assert not stands_still(np.array([3e-6, 0.0]), u, 1e-3)
    assert not stands_still(np.array([np.inf, 0.0]), u, 1e-3)
    assert stands_still(np.array([1e-12, 1e-12]), 0.0 * u, None)


def wrong_centre(one: Drawn) -> Drawn:
    """The workpiece balls 200 mm from where they are."""
    runs = tuple(
        replace(run, reference=PointOn("workpiece", (run.reference.point[0] + 200.0, *run.reference.point[1:])))
        if run.instrument == "ballbar"
        else run
        for run in one.observed.runs
    )
    return replace(one, observed=replace(one.observed, runs=runs))


@pytest.mark.parametrize("prior", [True, False])
def test_a_fit_that_leads_away_is_none_that_converged(prior: bool) -> None:
    """With a ball 200 mm off coefficients grew to 1e43 and were written."""
    one = wrong_centre(drawn(np.random.default_rng(3), "dmu60p", 2, 2, 60, 0.3))
    known = ErrorValues(machine="dmu60p", parameters=one.truth.parameters)
    options = IdentifyOptions(known=known, estimation=EstimationOptions(prior=prior, degree=5))
    if prior:
        with pytest.raises(NotConvergedError) as caught:
            identify_estimated(one.model, one.observed, options)
        assert caught.value.runs[0].run.startswith("circle")
        return
    fit = identify_estimated(one.model, one.observed, options).values.fit
    assert fit is not None
    assert fit.state == "misfit"
    assert fit.runs[0].startswith("circle")


@pytest.mark.parametrize("seed", range(4))
def test_random_plans_end_well_and_u_holds_anywhere(seed: int) -> None:
    """A few lines and circles: nothing is open, what is off is as u says, and less than doing nothing."""
    rng = np.random.default_rng(seed)
    one = drawn(rng, ("dmu60p", "gantry_mill", "bridge_cmm", "trunnion_mill")[seed], 12, 2, 30, 0.3)
    end = outcome(
        one, IdentifyOptions(noise=NoiseModel(um=one.noise_um), estimation=EstimationOptions(degree=7)), points=100
    )
    assert end.state == "converged"
    assert 0.7 < end.ratio < 1.1
    assert end.open == 0.0
    assert 0.3 < end.off_in_u < 1.5
    assert end.off_um < 0.45 * end.deviation_um


@pytest.mark.parametrize("method", ["paper", "global"])
def test_a_run_that_does_not_fit_is_a_misfit(tmp_path: Path, method: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Readings of one run are those of another direction: repeated readings know better."""
    data, out = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.1"), tmp_path / "e.json"
    lines = (data / "readings.csv").read_text().splitlines()
    spoilt = [lines[0]]
    for number, line in enumerate(lines[1:]):
        start, _, reading = line.rpartition(",")
        off = 0.02 * (-1) ** number if line.startswith(("X-", "XZ-")) else 0.0
        spoilt += [f"{start},{float(reading) + off!r}"] * (2 if method == "paper" else 1)
        if method == "paper":
            run, _, rest = line.partition(",")
            seq, _, positions = rest.partition(",")
            spoilt[-1] = f"{run},{int(seq) + 1000},{positions.rpartition(',')[0]},{float(reading) - off!r}"
    (data / "readings.csv").write_text("\n".join(spoilt) + "\n")
    options = ["--method", method, "--noise-um", "0.1"]
    assert identify(data, out, *options) == 1
    shown = capsys.readouterr()
    assert shown.out.count("worst:") == 1  # the paragraph stands in the report alone
    assert "fit: MISFIT, the residuals are far from the noise that is stated" in " ".join(shown.out.split())
    assert shown.err.startswith("trueaxis: MISFIT, the residuals are far from the noise that is stated")
    assert shown.err.count("\n") == 1
    fit = values(out).fit
    assert fit is not None
    assert fit.state == "misfit"
    assert fit.chi2 is not None
    assert fit.chi2 > 9.0
    assert fit.runs[0].startswith(("X-", "XZ-"))


def test_a_noise_that_is_stated_far_too_small_is_a_misfit(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Values follow such a noise: whatever a model may lack is no excuse. The remedy is named."""
    data, out = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.5"), tmp_path / "e.json"
    assert identify(data, out, "--method", "global", "--noise-um", "0.5") == 0
    assert "leave it out" not in capsys.readouterr().out
    assert identify(data, out, "--method", "global", "--noise-um", "0.05") == 1
    fit = values(out).fit
    assert fit is not None
    assert fit.state == "misfit"
    told = " ".join(capsys.readouterr().err.split())
    assert re.search(
        r"the residuals of laser are \S+ times the noise that --noise-um states \(0.05 um\): leave it", told
    )
    assert identify(data, out, "--method", "global", "--noise-um", "5") == 0
    told = " ".join(capsys.readouterr().out.split())
    assert re.search(r"the residuals of laser are 1/\S+ of the noise that --noise-um states \(5 um\): leave it", told)
    lines = (data / "setup.toml").read_text().replace("[[run]]", "[[run]]\ndevice = 'L'")
    (data / "setup.toml").write_text(lines + "\n[device.L]\nnoise_um = 5.0\n")
    assert identify(data, out, "--method", "global") == 0
    told = " ".join(capsys.readouterr().out.split())
    assert "the noise that noise_um of the device table (setup.toml) states (5 um): leave it out" in told


def test_location_errors_that_are_fixed_at_zero_are_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data, out, known = simulated(tmp_path, "dmu60p_regular_runs"), tmp_path / "e.json", tmp_path / "known.json"
    known.write_text('{"schema": 1, "machine": "dmu60p", "parameters": {"eps_xy": 0.0, "eps_yz": 1e-5}}')
    assert identify(data, out, "--method", "global", "--noise-um", "0.1", "--known", str(known)) == 0
    told = " ".join(capsys.readouterr().out.split())
    assert "eps_xy and eps_yz: taken as known, eps_xy as exactly 0, without uncertainty" in told


@pytest.mark.parametrize("method", ["paper", "global"])
def test_a_good_fit_says_so(tmp_path: Path, method: str) -> None:
    data, out = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.1"), tmp_path / "e.json"
    assert identify(data, out, "--method", method, "--noise-um", "0.1") == 0
    fit = values(out).fit
    assert fit is not None
    assert fit.state == "converged"
    if method == "global":
        assert fit.chi2 == pytest.approx(1.0, abs=0.3)
    else:
        assert fit.chi2 is None  # as many unknowns as readings
    assert identify(data, out, "--method", method) == 0
    fit = values(out).fit
    assert fit is not None
    assert fit.chi2 is None  # nobody gave the noise, and no reading is repeated


@pytest.mark.parametrize("prior", ["spec", "none"])
def test_nothing_is_written_where_the_fit_has_not_converged(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, prior: str
) -> None:
    for name, value in (("MOST_STEPS", 1), ("STILL", 1e-30), ("LEAST_STEP", 0.0)):
        monkeypatch.setattr(f"trueaxis.estimation.estimate.{name}", value)
    data, out = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.1"), tmp_path / "e.json"
    options = ["--method", "global", "--prior", prior, "--report", str(tmp_path / "r.json")]
    assert identify(data, out, *options) == 1
    told = capsys.readouterr().err
    assert re.search(r"the fit has not converged in \d+ iterations; nothing was written", told)
    assert "residuals of the worst runs: " in told
    assert "diagnose says what readings show" in told
    assert not out.exists()
    assert not (tmp_path / "r.json").exists()


def test_the_paper_method_checks_its_convergence(monkeypatch: pytest.MonkeyPatch) -> None:
    one = drawn(np.random.default_rng(0), "dmu60p", 3, 0, 5, 0.3)
    options = PaperOptions(known=ErrorValues(machine="dmu60p", parameters=one.truth.parameters))
    identify_paper(one.model, one.observed, options)
    monkeypatch.setattr("trueaxis.identification.paper.solution.MOST_ITERATIONS", 1)
    with pytest.raises(NotConvergedError):
        identify_paper(one.model, one.observed, options)


def test_squareness_comes_back_right_by_default(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Noise-free readings with -5, 26 and 10 urad came back as 10, 65 and 48: Eqs. (39)-(43) give what they give."""
    tree = json.loads(ERRORS.read_text())
    squareness = {"eps_xy": -5e-6, "eps_yz": 26e-6, "eps_xz": 10e-6}
    tree["parameters"] |= squareness
    for name in ("EYX", "EZX", "EXY", "EZY", "EXZ", "EYZ"):
        tree["motion_errors"].pop(name, None)  # straight axes: nothing to level
    errors, data, out = tmp_path / "true.json", tmp_path / "data", tmp_path / "e.json"
    errors.write_text(json.dumps(tree))
    plan = str(MACHINE.parent / "dmu60p_regular_runs")
    start = ["simulate", str(MACHINE), "--errors", str(errors), "--data", plan, "--out", str(data)]
    assert main([*start, *KERNELS]) == 0
    dimensions = tmp_path / "known.json"
    known = {name: value for name, value in tree["parameters"].items() if name not in squareness}
    dimensions.write_text(json.dumps({"schema": 1, "machine": "dmu60p", "parameters": known}))
    for options in (["--method", "paper"], LEAST_SQUARES):
        assert identify(data, out, *options, "--known", str(dimensions)) == 0
        for name, true in squareness.items():
            assert values(out).parameters[name] == pytest.approx(true, abs=1e-8), (options, name)
    # the lines of straightness may be off their axes: what the prior says of that is in u
    assert identify(data, out, "--method", "global", "--known", str(dimensions)) == 0
    for name, true in squareness.items():
        assert abs(values(out).parameters[name] - true) < 2.0 * values(out).u[name] < 40e-6, name
    capsys.readouterr()
    assert identify(data, out, "--method", "paper", "--squareness", "sect36", "--known", str(dimensions)) == 0
    told = capsys.readouterr()
    assert "docs/errata.md, E28 to E32" in told.err
    assert "docs/errata.md, E28 to E32" in " ".join(told.out.split())
    assert abs(values(out).parameters["eps_yz"] - 26e-6) > 1e-5


@pytest.mark.parametrize("value", ["1e-300", "1e300", "laser=1e-300"])
def test_noise_that_no_instrument_has_is_refused(tmp_path: Path, value: str) -> None:
    with pytest.raises(SystemExit) as caught:
        identify(tmp_path, tmp_path / "e.json", "--method", "global", "--noise-um", value)
    assert caught.value.code == 2


def test_the_range_that_was_measured_is_written(tmp_path: Path) -> None:
    data, out = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.1"), tmp_path / "e.json"
    rows = (data / "readings.csv").read_text().splitlines()
    kept = [row for row in rows[1:] if all(float(value) <= 300.0 for value in row.split(",")[2:5])]
    (data / "readings.csv").write_text("\n".join([rows[0], *kept]) + "\n")
    for options in (
        ["--method", "global", "--prior", "none", "--degree", "3"],
        ["--method", "stepwise", "--curves", "polynomial"],
        ["--method", "stepwise", "--curves", "held-out"],
    ):
        assert identify(data, out, *options) == 0
        measured = {name: curve.measured for name, curve in values(out).motion_errors.items()}
        for name, ends in measured.items():
            assert ends is not None, name
            low, high = ends
            assert low == 0.0
            assert 200.0 <= high <= 300.0, name  # of a travel of 540 mm or more


@pytest.mark.parametrize("method", ["stepwise", "global"])
def test_a_misfit_by_copied_rows_names_them(tmp_path: Path, method: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Every row twice: the repeats seem to have no noise at all."""
    data = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "5")
    head, *rows = (data / "readings.csv").read_text().splitlines()
    seq = head.split(",").index("seq")
    twice = []
    for row in rows:
        cells = row.split(",")
        for copy in (0, 1):
            cells[seq] = str(2 * int(row.split(",")[seq]) + copy)
            twice.append(",".join(cells))
    (data / "readings.csv").write_text("\n".join([head, *twice]) + "\n")
    capsys.readouterr()
    assert identify(data, tmp_path / "e.json", "--method", method) == 1
    told = capsys.readouterr().err
    assert "are equal to the last digit, which makes this noise too small: are rows copied?" in told
    assert "X-1" in told


def test_a_coarse_display_is_no_copy() -> None:
    """Readings of 0.1 um steps: some repeats are equal, most are not."""
    draw = np.random.default_rng(3)
    count = 300
    positions = np.repeat(np.arange(100.0), 3)[np.newaxis] * np.ones((3, 1))
    run = np.zeros(count, dtype=np.int64)
    coarse = Observations(
        source="data", runs=RUNS, run=run, positions=positions, reading=np.round(draw.normal(0.0, 3e-4, count), 4)
    )
    assert copied_runs(coarse).size == 0
    assert copied_runs(replace(coarse, reading=np.repeat(draw.normal(size=100), 3))).tolist() == [0]
