"""What the tests of several files share."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import coverage
import pytest

from tests.command_lines import prepare
from tests.kept import derived
from tests.machines import ROOT
from trueaxis.diagnosis.result import Diagnosis

# Files that take more than 20 s, the longest first: one that begins last keeps all other workers waiting.
LONG = (
    "hidden_effects/test_fast_set.py",
    "diagnosis/test_rivals.py",
    "diagnosis/test_page.py",
    "test_stopping.py",
    "planning/test_command.py",
    "compensation/test_effects.py",
    "jobs/test_fleet.py",
    "estimation/test_effects.py",
    "cli/test_diagnose.py",
    "controllers/test_linuxcnc_simulator.py",
    "measurement/test_readings.py",
    "fuzz/test_fuzz.py",
    "demo/test_demo.py",
    "test_data_not_run.py",
    "test_told.py",
    "test_output_files.py",
    "worlds/diagnosis/test_fast_set.py",
    "estimation/test_misread.py",
    "diagnosis/test_next_runs.py",
    "worlds/test_oracle.py",
    "worlds/diagnosis/test_campaign.py",
    "estimation/test_left_out.py",
    "jobs/test_draws.py",
)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Files that take long first; tests of a file stay together and in their order."""
    place = {ROOT / "tests" / name: number for number, name in enumerate(LONG)}
    items.sort(key=lambda item: place.get(item.path, len(LONG)))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """Slow tests are not counted in the coverage, which is that of the fast ones; without it they take less time."""
    stopped: list[coverage.Coverage] = []  # in a worker pytest-cov starts two, one within the other
    while item.get_closest_marker("slow") and (measured := coverage.Coverage.current()):
        measured.stop()
        stopped.append(measured)
    try:
        return (yield)
    finally:
        for measured in reversed(stopped):
            measured.start()


class _FailuresFirst:
    """What the process that starts the workers tells: a failure as soon as it is known, and fast tests before slow."""

    def __init__(self, config: pytest.Config) -> None:
        self.told = config.pluginmanager.getplugin("terminalreporter")

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.failed:
            self.told.write_line(f"\nfailed: {report.nodeid} ({report.when})", red=True)

    def pytest_sessionfinish(self) -> None:
        for one in ("failed", "error"):
            self.told.stats.get(one, []).sort(key=lambda report: "slow" in report.keywords)


def pytest_sessionstart(session: pytest.Session) -> None:
    """Kernels of the machines whose files are not checked in, beside those that are; once, not by every worker."""
    if hasattr(session.config, "workerinput"):
        return
    if session.config.getoption("numprocesses", None):
        session.config.pluginmanager.register(_FailuresFirst(session.config))
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
    monkeypatch.setattr("trueaxis.reporting.diagnosis.pictures.pictures_of", none)
