"""Squareness (Sect. 3.6): scalar products of the directions in which the exact chain moves."""

import numpy as np
import pytest

from tests.derivation.topologies import OTHERS, THREE_AXIS
from tests.exact_chain import DIGITS, ExactChain
from tests.machines import machine_of
from trueaxis.derivation.first_order import squarenesses

CASES = OTHERS | {label: THREE_AXIS[label] for label in ("wXYZbt", "wbZYXt", "wYbXZt")}


def numeric(text: str, axes: tuple[str, str], location: dict[str, float]) -> float:
    """Sine of what is missing from the right angle: the unit directions of two axes, from two poses each."""
    chain = ExactChain(text)

    def direction(axis: str) -> object:
        number = next(n for n, body in chain.bodies.items() if body.get("moves") == axis)
        home = dict.fromkeys(chain.axes, 0.0)
        there, here = (chain.to_bed(number, home | {axis: at}, location)[:3, 3] for at in (1.0, 0.0))
        return (there - here) / DIGITS.norm(there - here)

    one, two = direction(axes[0]), direction(axes[1])
    return float(sum(one[k] * two[k] for k in range(3)))  # type: ignore[index]


@pytest.mark.parametrize("label", CASES)
def test_products_are_the_angles_of_the_exact_directions_to_first_order(label: str) -> None:
    chain = ExactChain(CASES[label])
    for pair in squarenesses(machine_of(CASES[label])):
        for seed in range(3):
            rng = np.random.default_rng(seed)
            location = {name: 1e-9 * rng.uniform(-1, 1) for name in chain.location_errors}
            product = float(pair.product.subs({s: location[s.name] for s in pair.product.free_symbols}))
            assert product == pytest.approx(numeric(CASES[label], pair.axes, location), abs=1e-16)


def test_the_papers_machine_has_its_three_squareness_errors() -> None:
    # By hand: X turned by +eps_xy about z leans towards +y; Z turned by eps_xz about y leans towards +x and by eps_yz
    # about x towards -y. X.Y = eps_xy; Y.Z = -eps_yz; X.Z: both stand on X, so eps_xy cancels and eps_xz is left.
    found = {pair.axes: str(pair.product) for pair in squarenesses(machine_of(OTHERS["dmu60p"]))}
    assert found == {("X", "Y"): "eps_xy", ("X", "Z"): "eps_xz", ("Y", "Z"): "-eps_yz"}
