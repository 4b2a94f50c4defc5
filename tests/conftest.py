"""What the tests of several files share."""

from pathlib import Path

import pytest

from tests.command_lines import prepare


@pytest.fixture(scope="module")
def prepared(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The inputs of tests.command_lines.COMMANDS in a folder."""
    folder = tmp_path_factory.mktemp("commands") / "inputs"
    prepare(folder)
    return folder
