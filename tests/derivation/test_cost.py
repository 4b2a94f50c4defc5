"""What a derivation and its kernels cost, counted and compared, never in seconds."""

import json
import time

import pytest
import sympy as sp

from tests.derivation.test_routine import models
from tests.machines import FIVE_AXIS, ROOT, machine_at
from trueaxis.derivation import symbols
from trueaxis.derivation.chain import chains, product
from trueaxis.derivation.first_order import first_order
from trueaxis.derivation.views import view

BASELINE = ROOT / "tests" / "data" / "operation_counts.json"
UPDATE = "PYTHONPATH=src:. python -m tests.derivation.test_cost"


def counts() -> dict[str, dict[str, list[int]]]:
    """Machine -> routine -> operations [per point, per call]."""
    return {
        name: {routine.name: [routine.operations, routine.batch_operations] for routine in model.routines}
        for name, model in models().items()
    }


@pytest.mark.parametrize("machine", ["dmu60p", "five_axis"])
def test_no_kernel_costs_more_than_it_did(machine: str) -> None:
    kept, now = json.loads(BASELINE.read_text())[machine], counts()[machine]
    grown = {name: (kept[name], now[name]) for name in kept.keys() & now.keys() if now[name][0] > kept[name][0]}
    assert not grown, f"operations per point grew (was, is): {grown}; if that is meant, run: {UPDATE}"
    assert kept == now, f"operations changed; if they fell or a routine came or went, keep that: run: {UPDATE}"


def test_first_order_of_five_axes_is_no_harder_than_differentiating_one_branch_of_three() -> None:
    # The other way is to multiply the chain out, expand it and differentiate by every error. Done for the tool branch
    # alone up to its third body, it must already take longer than the whole view by first order.
    machine = machine_at(FIVE_AXIS)
    start = time.perf_counter()
    columns = first_order.__wrapped__(view(machine, "tool_in_workpiece"), symbols.point()).columns
    ours = time.perf_counter() - start
    assert len(columns) == len(machine.components) + len(machine.location_errors)
    start = time.perf_counter()
    tool = chains(machine)[1][:3]
    position = (product(tool) * sp.Matrix([*symbols.point(), 1])).applyfunc(sp.expand)
    errors = [sp.Symbol(name, real=True) for part in tool for name in part.motion_error.names if name]
    zero = dict.fromkeys(errors, 0)
    derivatives = [position.diff(error).subs(zero) for error in errors]
    other = time.perf_counter() - start
    assert len(derivatives) == 12
    print(f"\nfirst order of five axes: {ours:.3f} s; two axes expanded and differentiated: {other:.3f} s")
    assert ours < 2 * other


def test_no_entry_of_a_chain_is_ever_expanded() -> None:
    # The size of the derived columns: sums of few products, where the expanded chain has thousands of terms.
    columns = first_order(view(machine_at(FIVE_AXIS), "tool_in_workpiece"), symbols.point()).columns
    assert max(sp.count_ops(entry) for column in columns.values() for entry in column) < 120


if __name__ == "__main__":
    BASELINE.write_text(json.dumps(counts(), indent=1) + "\n")
