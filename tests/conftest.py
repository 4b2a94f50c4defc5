"""What the tests of several files share."""

import shutil
from pathlib import Path

import pytest

from tests.command_lines import prepare
from tests.kept import derived
from tests.machines import ROOT
from trueaxis.diagnosis.result import Diagnosis
from trueaxis.estimation.wrong_runs import WrongRuns

# Files that take some 20 s of a processor or more, the longest first: one that begins last keeps the others waiting.
LONG = (
    "hidden_effects/test_fast_set.py",
    "diagnosis/test_rivals.py",
    "diagnosis/test_page.py",
    "test_stopping.py",
    "estimation/test_effects.py",
    "estimation/test_misread.py",
    "jobs/test_fleet.py",
    "cli/test_diagnose.py",
    "fuzz/test_fuzz.py",
    "diagnosis/test_misfit.py",
    "controllers/test_linuxcnc_simulator.py",
    "worlds/test_oracle.py",
    "estimation/test_left_out.py",
    "estimation/test_estimate.py",
    "worlds/diagnosis/test_fast_set.py",
    "worlds/test_against_the_package.py",
    "test_tutorials.py",
    "identification/test_fit_quality.py",
    "diagnosis/test_extend.py",
    "diagnosis/test_next_runs.py",
    "demo/test_demo.py",
    "compensation/test_klartext.py",
    "diagnosis/test_spoilt_values.py",
    "test_told.py",
    "test_output_files.py",
    "measurement/test_readings.py",
    "worlds/diagnosis/test_campaign.py",
    "test_data_not_run.py",
    "diagnosis/test_scale_off.py",
    "reporting/diagnosis/test_html.py",
    "identification/test_stylus.py",
    "diagnosis/test_scan.py",
    "worlds/test_design.py",
    "worlds/test_campaign.py",
    "planning/test_command.py",
    "identification/test_paper.py",
    "planning/test_effects.py",
    "derivation/test_five_axis_topologies.py",
    "real_data/test_headhead.py",
    "jobs/test_draws.py",
    "diagnosis/test_checks.py",
    "real_data/test_headhead_diagnosis.py",
    "jobs/test_notebooks.py",
    "diagnosis/test_roughness.py",
    "compensation/test_effects.py",
    "diagnosis/test_instruments.py",
    "cli/test_angle.py",
    "identification/test_covariance.py",
    "jobs/test_same_as_commands.py",
    "diagnosis/test_threads.py",
    "diagnosis/test_temperature.py",
    "identification/test_estimated.py",
    "monte_carlo/test_volume.py",
)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Files that take long first; tests of a file stay together and in their order."""
    place = {ROOT / "tests" / name: number for number, name in enumerate(LONG)}
    items.sort(key=lambda item: place.get(item.path, len(LONG)))


def pytest_sessionstart(session: pytest.Session) -> None:
    """Kernels of the machines whose files are not checked in, beside those that are; once, not by every worker."""
    if hasattr(session.config, "workerinput"):
        return
    tracked = (ROOT / ".gitignore").read_text(encoding="utf-8").splitlines()
    for spec in sorted((ROOT / "machines").glob("*.toml")):
        folder = ROOT / "generated" / spec.stem
        if f"!generated/{spec.stem}" in tracked:
            continue
        try:
            made = derived(spec) / spec.stem
        except Exception as problem:  # of the derivation: the tests that need these kernels fail, others may run
            print(f"{spec.name} could not be derived: {problem!r}")
            continue
        if not folder.is_dir() or any(_differs(file, folder / file.name) for file in made.iterdir()):
            shutil.copytree(made, folder, dirs_exist_ok=True)


def _differs(made: Path, there: Path) -> bool:
    return not there.is_file() or made.read_bytes() != there.read_bytes()


@pytest.fixture(scope="module")
def prepared(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The inputs of tests.command_lines.COMMANDS in a folder."""
    folder = tmp_path_factory.mktemp("commands") / "inputs"
    prepare(folder)
    return folder


@pytest.fixture
def values_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """For what looks at values, which an estimate has before it looks for runs that were misread: that takes longer."""
    monkeypatch.setattr("trueaxis.estimation.estimate.wrong_runs", lambda *_: WrongRuns())


@pytest.fixture
def without_second_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """For what looks at no page and no kernels of a diagnosis: drawing and deriving may take longer than it does."""
    from trueaxis.reporting.diagnosis.picture import Pictures

    def none(found: Diagnosis) -> Pictures:
        sections = ("gain", "residuals", "circles", "periods", "structure", "evidence", "limits")
        return Pictures(causes=((),) * len(found.causes), sections=dict.fromkeys(sections, ()))

    def neither(found: Diagnosis, _: object) -> tuple[Pictures, dict[str, bytes]]:
        return none(found), {}

    monkeypatch.setattr("trueaxis.jobs.beside.cores", lambda: 1)
    monkeypatch.setattr("trueaxis.jobs.drawn_and_derived.drawn_and_derived", neither)
    monkeypatch.setattr("trueaxis.reporting.diagnosis.figures.pictures_of", none)
