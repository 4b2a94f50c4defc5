"""What the tests of several files share."""

import shutil
from pathlib import Path

import pytest

from tests.command_lines import prepare
from tests.kept import derived
from tests.machines import ROOT

# Files that take more than 25 s of a processor, the longest first, so that none is left for the end, when the other
# workers have nothing to do.
LONG = (
    "hidden_effects/test_fast_set.py", "diagnosis/test_page.py", "diagnosis/test_rivals.py",
)  # fmt: skip


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
