"""Whatever tiny data come, `plan` and `identify` end with an exit code of the contract: see random_data.py."""

from pathlib import Path

import pytest

from tests.generator.dmu60p import cubic_errors
from tests.generator.dmu60p import dmu60p as generator
from tests.identify.data import line, observed, tool
from tests.identify.machines import dmu60p
from tests.identify.random_data import ended
from trueaxis.identify.global_fit.method import identify_global
from trueaxis.identify.global_fit.result import GlobalOptions
from trueaxis.measure.setup import PointOn
from trueaxis.runtime.errors import ErrorValues


@pytest.mark.parametrize("seed", range(12))
def test_tiny_data_end_as_they_should(seed: int, tmp_path: Path) -> None:
    command, code, said = ended(seed, tmp_path)
    assert code in (0, 1, 2), (command, code)
    assert (tmp_path / "e.json").exists() <= (code != 2)
    assert bool(said) >= (code == 2)


@pytest.mark.parametrize("count", [1, 3])
def test_degrees_are_chosen_on_one_line_and_on_three(count: int) -> None:
    """The normal equations without the readings held out were singular: LinAlgError."""
    runs = [tool(f"X-{k}", "x", (10.0 * k, 0.0, 0.0), PointOn("bed")) for k in range(count)]
    data = observed(generator(cubic_errors()), runs, [line("X", 9)] * count)
    found = identify_global(dmu60p(), data, GlobalOptions(known=ErrorValues("dmu60p"), degree="auto"))
    assert found.report.orders is not None
