"""How a step of the curved fit is taken, halved or given up."""

from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from trueaxis.identify.global_fit import solve as module

NOW = (np.zeros(2), np.array([3.0, 4.0]))
STILL = cast(Any, SimpleNamespace(projector=np.eye(2)))
DESIGN = cast(Any, SimpleNamespace(roots=None, within=lambda _: True))


@pytest.fixture
def tried(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """First unknowns of the steps that are tried; squares fall below a tenth of the first one."""
    found: list[float] = []

    def residuals(_: object, __: object, unknowns: np.ndarray) -> np.ndarray:
        found.append(float(unknowns[0]))
        return np.array([3.0, 3.9 if unknowns[0] < 0.1 else 4.1])

    monkeypatch.setattr(module, "residuals", residuals)
    return found


def test_a_step_is_halved_until_it_is_none_for_the_worse(tried: list[float]) -> None:
    unknowns, residual = module._careful(DESIGN, cast(Any, None), STILL, NOW, np.array([1.0, 0.0]), promised=1.0)
    assert tried == [1.0, 0.5, 0.25, 0.125, 0.0625]
    assert unknowns[0] == 0.0625
    assert residual[1] == 3.9


def test_a_step_that_promises_nothing_is_tried_once(tried: list[float]) -> None:
    found = module._careful(DESIGN, cast(Any, None), STILL, NOW, np.array([1.0, 0.0]), promised=1e-12)
    assert tried == [1.0]
    assert found is NOW


def test_a_step_that_is_next_to_nothing_is_taken_as_it_is(tried: list[float]) -> None:
    unknowns, _ = module._careful(DESIGN, cast(Any, None), STILL, NOW, np.array([1e-7, 0.0]), promised=0.0)
    assert unknowns[0] == 1e-7
