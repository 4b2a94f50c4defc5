"""Candidates may be gone through by several threads: what is found is the same to the last digit."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from tests.diagnosis.prepared import SMALL, Prepared, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.hidden import Hidden
from trueaxis.diagnosis.procedure import DiagnoseOptions, diagnose
from trueaxis.diagnosis.result import Diagnosis
from trueaxis.reporting.diagnosis.json_file import diagnosis_json

EFFECTS = (Hidden("backlash", "EXX", size=-2e-3), Hidden("cyclic", "EYY", size=1e-3))


@pytest.fixture(scope="module")
def given() -> Prepared:
    return prepared(Case(seed=4, design=SMALL, effects=EFFECTS))


@pytest.fixture(scope="module")
def alone(given: Prepared) -> Diagnosis:
    return diagnose(given.model, given.data)


@pytest.mark.parametrize("threads", [1, 4])
def test_threads_change_nothing(threads: int, given: Prepared, alone: Diagnosis) -> None:
    assert alone.causes
    stages: list[str] = []
    with ThreadPoolExecutor(threads) as pool:
        beside = diagnose(given.model, given.data, DiagnoseOptions(progress=stages.append, each=pool.map))
    assert diagnosis_json(beside, None, None) == diagnosis_json(alone, None, None)
    for of in ("given", "refitted", "extended", "whitened"):
        assert np.array_equal(getattr(beside.residuals, of), getattr(alone.residuals, of))
    candidates = [stage for stage in stages if stage.startswith("scan ")]
    assert candidates[0].startswith("scan 1 of ")
    assert candidates[len(alone.scan) - 1].startswith(f"scan {len(alone.scan)} of {len(alone.scan)}: ")


def test_an_interruption_ends_it_all() -> None:
    given = prepared(Case(seed=4, design=SMALL))

    def told(stage: str) -> None:
        if stage.startswith("scan 3 "):
            raise KeyboardInterrupt

    with ThreadPoolExecutor(2) as pool, pytest.raises(KeyboardInterrupt):
        diagnose(given.model, given.data, DiagnoseOptions(progress=told, each=pool.map))
