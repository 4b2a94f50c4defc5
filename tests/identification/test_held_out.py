"""Errors at positions held out, against plain numpy; the order that they choose."""

import numpy as np
import pytest

from trueaxis.identification.curve_fit import held_out, ordered_curves
from trueaxis.identification.polynomial import fit_optimal
from trueaxis.model.curves import PolynomialCurve, TableCurve

AT = np.linspace(60.0, 540.0, 9)


def test_nine_positions_are_left_out_one_by_one() -> None:
    values = 1e-5 * AT - 2e-8 * AT**2 + np.random.default_rng(3).normal(0.0, 2e-5, AT.size)
    found = held_out({"EXX": fit_optimal(AT, values)}, max_order=3)["EXX"]
    by_order = {}
    for order in (1, 2, 3):
        off = []
        for place in range(AT.size):
            rest = np.arange(AT.size) != place
            powers = (AT[:, np.newaxis] / 540.0) ** np.arange(1, order + 1)
            off.append(values[place] - powers[place] @ np.linalg.lstsq(powers[rest], values[rest])[0])
        by_order[order] = np.array(off) ** 2
    order = len(found.fit.powers)
    assert found.rms == pytest.approx(np.sqrt(by_order[order].mean()))
    best = min(by_order, key=lambda k: float(by_order[k].sum()))
    for lower in range(1, order):
        excess = by_order[lower] - by_order[best]
        assert excess.sum() > excess.std(ddof=1) * 3.0
    excess = by_order[order] - by_order[best]
    assert order == best or excess.sum() <= excess.std(ddof=1) * 3.0


def test_both_choices_stand_beside_each_other_and_the_lower_order_does_not_overfit() -> None:
    at = np.linspace(0.0, 540.0, 28)
    source = np.random.default_rng(8)
    lower, better = 0, 0
    for _ in range(10):
        values = np.where(at > 0.0, 1e-5 * at + source.normal(0.0, 3e-4, at.size), 0.0)
        table = {"EXX": TableCurve(tuple(at.tolist()), tuple(values.tolist()))}
        curves, notes, (order,) = ordered_curves(table, "held-out")
        assert notes == ()
        curve = curves["EXX"]
        assert isinstance(curve, PolynomialCurve)
        assert curve.powers == order.by_held_out
        lower += max(order.by_held_out) <= 2
        better += order.held_out <= order.held_out_by_paper
    assert lower >= 8  # the truth is a line
    assert better >= 5


def test_the_papers_choice_is_what_it_was() -> None:
    at = np.linspace(0.0, 540.0, 12)
    values = 1e-5 * at - 1e-8 * at**2 + np.where(at > 0.0, np.random.default_rng(1).normal(0.0, 1e-5, at.size), 0.0)
    table = {"EXX": TableCurve(tuple(at.tolist()), tuple(values.tolist()))}
    curves, _, (order,) = ordered_curves(table, "polynomial")
    expected = fit_optimal(at[1:], values[1:]).after
    curve = curves["EXX"]
    assert isinstance(curve, PolynomialCurve)
    assert curve.powers == expected.powers == order.by_paper


@pytest.mark.parametrize("count", [4, 5, 13])
def test_few_positions_and_zero_values_are_no_fault(count: int) -> None:
    at = np.linspace(0.0, 540.0, count)
    zero = TableCurve(tuple(at.tolist()), (0.0,) * count)
    slope = TableCurve(tuple(at.tolist()), tuple((1e-5 * at).tolist()))
    _, _, orders = ordered_curves({"EXX": zero, "EYX": slope}, "held-out")
    assert [order.by_held_out[:1] for order in orders][1] == (1,)
    assert all(order.held_out < 1e-12 for order in orders)
