"""What is said of sizes of instrument unknowns: how small they came out, from how many values, u by the usual sizes."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from tests.generator.dmu60p import cubic_errors
from tests.identification.data import dmu60p_model, mixed_data
from tests.identification.test_paper import DIMENSIONS
from trueaxis.error_name import ErrorName
from trueaxis.estimation.instruments import CLASSES
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.identification.error_lines import by_usual_sizes
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.report import Identification
from trueaxis.identification.report_text import report_json
from trueaxis.identification.usual_sizes import LargerU
from trueaxis.model.errors import ErrorValues

GIVEN = IdentifyOptions(known=ErrorValues(machine="dmu60p", parameters=DIMENSIONS))


def identified(options: IdentifyOptions = GIVEN) -> Identification:
    """The readings hold instruments that nothing is wrong with: no centre is off, no zero, no drift."""
    return identify_estimated(dmu60p_model(), mixed_data(cubic_errors(), seed=1), options)


def notes_of(found: Identification) -> list[str]:
    return [note for note in found.report.caveats if note.startswith("u rests on sizes")]


def test_a_size_from_few_values_is_said_with_u_by_the_usual_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """The bracket is what an estimate comes to that takes the sizes of instruments as usual, which is another fit."""
    found = identified()
    (note,) = notes_of(found)
    assert re.search(r"ballbar centre 1\.\d+ um, from 3 values \(usual 50 um\)", note)
    assert "laser zero 0.0" in note
    pairs = re.findall(r"(\w+) ([\d.]+) \w+ \(([\d.]+) \w", note)
    told = {name: (float(now), float(then)) for name, now, then in pairs}
    now, then = told["EAZ"]
    assert then > 2.0 * now
    for name, one in CLASSES.items():
        monkeypatch.setitem(CLASSES, name, replace(one, factor=1.0))
    assert found.report.usual is not None
    assert "u rests on sizes" in json.loads(report_json(found.report))["caveats"][-1]
    second = found.covariance.usual
    assert second is not None
    rows = second.rows_of("EAZ")
    assert second.of_prior
    at = second.bases[second.components.index(ErrorName("EAZ"))](np.linspace(0.0, 600.0, 33))
    assert np.linalg.norm(at.T @ np.asarray(second.root)[rows], axis=1).max() == pytest.approx(then * 1e-6, rel=0.01)
    usual = identified()
    assert usual.covariance.usual is None
    u = {part.name: part.u for part in usual.report.components}
    assert not notes_of(usual)
    assert u["EAZ"] == pytest.approx(then * 1e-6, rel=0.3)
    assert usual.report.tool is not None
    assert usual.report.tool.u_rms * 1e3 == pytest.approx(told["volume"][1], rel=0.3)


@pytest.mark.parametrize("estimation", [EstimationOptions(prior=False), EstimationOptions(ideal=True)])
def test_nothing_is_said_where_no_size_is_estimated_or_the_prior_has_no_part(estimation: EstimationOptions) -> None:
    assert not notes_of(identified(replace(GIVEN, estimation=estimation)))


def test_an_error_whose_u_rests_on_such_sizes_has_both_in_its_line() -> None:
    one = LargerU(name="EX0B", u=9.92e-3, u_usual=45.4e-3, unit="mm")
    assert by_usual_sizes(one) == "; by the usual sizes u 45.4"
    assert by_usual_sizes(None) == ""
