"""First order: against derivatives of the exact matrices, and against the exact kernels as errors shrink."""

import numpy as np
import pytest

from tests.derivation.poses import VIEWS, drawn
from tests.derivation.topologies import OTHERS, THREE_AXIS
from tests.exact_chain import DIGITS, ExactChain
from tests.kernels import call, kernels_of
from tests.machines import machine_of
from trueaxis.derivation import symbols
from trueaxis.derivation.first_order import first_order
from trueaxis.derivation.routine import Binder
from trueaxis.derivation.views import views, walk

SAMPLE = OTHERS | {label: THREE_AXIS[label] for label in ("wbXYZt", "wXbYZt", "wYXbZt", "wXYZbt")}


def sensitivity(chain: ExactChain, view: str, seed: int) -> np.ndarray:
    """Central differences of the exact matrices at the error-free machine: step 1e-12 in 40 digits."""
    pose, values, point = drawn(chain, seed)
    dimensions = {name: values[name] for name in chain.dimensions}
    step = DIGITS.mpf("1e-12")
    columns = []
    for name in chain.components + chain.location_errors:
        up, down = (chain.place(view, pose, dimensions | {name: s * step}, point) for s in (1, -1))
        columns.append([float(v) for v in (up - down) / (2 * step)])
    return np.array(columns).T


@pytest.mark.parametrize("label", SAMPLE)
def test_sensitivities_are_the_derivatives_of_the_exact_matrices(label: str) -> None:
    chain, module = ExactChain(SAMPLE[label]), kernels_of(SAMPLE[label])
    for view in ("tool_in_workpiece", "tool_in_bed"):
        pose, values, point = drawn(chain, 2)
        found = call(module, f"{view}_sensitivity", pose, values, np.array(point)[:, None])[:, :, 0]
        np.testing.assert_allclose(found, sensitivity(chain, view, 2), rtol=1e-12, atol=2e-12)


@pytest.mark.parametrize("label", OTHERS)
def test_first_order_deviation_is_the_sum_of_sensitivity_times_error(label: str) -> None:
    chain, module = ExactChain(OTHERS[label]), kernels_of(OTHERS[label])
    pose, values, point = drawn(chain, 4)
    errors = np.array([values[name] for name in chain.components + chain.location_errors])
    for view in VIEWS:
        at = np.array(point)[:, None]
        columns = call(module, f"{view}_sensitivity", pose, values, at)[:, :, 0]
        found = call(module, f"{view}_deviation_first_order", pose, values, at)[:, 0]
        np.testing.assert_allclose(found, columns @ errors, rtol=0, atol=1e-15)


@pytest.mark.parametrize("label", OTHERS)
def test_what_first_order_leaves_out_falls_with_the_square_of_the_errors(label: str) -> None:
    chain, module = ExactChain(OTHERS[label]), kernels_of(OTHERS[label])

    def left_out(view: str, size: float) -> float:
        pose, values, point = drawn(chain, 6, size)
        at = np.array(point)[:, None]
        exact, linear = (call(module, f"{view}_deviation{n}", pose, values, at) for n in ("", "_first_order"))
        return float(np.linalg.norm(exact - linear))

    for view in VIEWS:
        if left_out(view, 1.0) > 0:
            assert left_out(view, 1.0) / left_out(view, 0.5) == pytest.approx(4, rel=1e-2)
    assert left_out("tool_in_workpiece", 1.0) > 1e-9


@pytest.mark.parametrize("label", ["five_axis", "shared", "table-table AC"])
def test_symbolic_deviation_is_what_the_first_order_walk_gives(label: str) -> None:
    # Two derivations of one thing: columns turned one by one, and a deviation carried along.
    for view in views(machine_of(OTHERS[label])):
        binder = Binder()
        walked = walk(view, symbols.point(), binder, exact=False)
        values = list(walked.deviation)
        for name, value in reversed(binder.assignments):
            values = [entry.xreplace({name: value}) for entry in values]
        derived = first_order(view, symbols.point()).deviation()
        assert [(a - b).expand() for a, b in zip(values, derived, strict=True)] == [0, 0, 0]


def test_errors_stand_in_the_order_met_and_none_is_missing() -> None:
    machine = machine_of(OTHERS["five_axis"])
    tool_in_workpiece = next(view for view in views(machine) if view.name == "tool_in_workpiece")
    columns = first_order(tool_in_workpiece, symbols.point()).columns
    assert set(columns) == set(machine.components + machine.location_errors)
