"""On the paper's plan the estimate makes the machine better at any noise of a laser; the stepwise method does not."""

import pytest

from tests.estimation.paper_plan import both, true_machine

NOTHING_UM = 12.0  # of the machine as it is


@pytest.mark.parametrize(("noise_um", "most_um"), [(0.3, 4.0), (3.0, 8.0)])
def test_the_estimate_is_better_than_doing_nothing(noise_um: float, most_um: float) -> None:
    stepwise, estimated = both(true_machine(), noise_um, 1)
    assert estimated < most_um < NOTHING_UM
    assert estimated < 0.7 * stepwise
