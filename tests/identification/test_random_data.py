"""Whatever tiny data come, `plan` and `identify` end with an exit code of the contract: see random_data.py."""

from pathlib import Path

import numpy as np
import pytest

from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.generator.dmu60p import dmu60p as generator
from tests.identification.data import dmu60p_model, line, observed, tool
from tests.identification.random_data import ended
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.measurement.setup import PointOn
from trueaxis.model.errors import ErrorValues


@pytest.mark.parametrize("seed", range(12))
def test_tiny_data_end_as_they_should(seed: int, tmp_path: Path) -> None:
    command, code, said = ended(seed, tmp_path)
    assert code in (0, 1, 2), (command, code)
    assert (tmp_path / "e.json").exists() <= (code != 2)
    assert bool(said) >= (code == 2)


@pytest.mark.parametrize("prior", [True, False])
def test_one_line_is_enough_to_end_well(prior: bool) -> None:
    """Far fewer readings than unknowns, without noise: nothing is singular, and what is not read stays zero."""
    data = observed(generator(cubic_errors()), [tool("X-1", "x", (0.0, 0.0, 0.0), PointOn("bed"))], [line("X", 9)])
    options = IdentifyOptions(
        known=ErrorValues(machine="dmu60p", parameters=PARAMETERS), estimation=EstimationOptions(prior=prior)
    )
    found = identify_estimated(dmu60p_model(), data, options)
    assert found.values.fit is not None
    assert found.values.fit.state == "converged"
    determined = {name for name, by in found.values.determined.items() if by != "prior"}
    assert determined <= {"EXX", "EBX"}  # the target is 400 mm below the carriage
    assert np.abs(found.values.motion_errors["EYY"](np.linspace(0.0, 700.0, 5))).max() < 1e-12
