"""Which location errors a machine needs: literature's numbers, and redundancies on the exact model."""

import numpy as np
import pytest

from tests.planning.data import model
from trueaxis.model.errors import ErrorValues
from trueaxis.planning.location_sets import PLACEMENTS, independent, location_sets
from trueaxis.planning.report import LocationSet

FIVE_AXES = ("dmu60p_5axis", "trunnion_mill", "headhead_mill")


def sets(name: str) -> dict[tuple[str, bool], LocationSet]:
    return {(one.placement, one.workpiece_free): one for one in location_sets(model(name), ErrorValues(machine=name))}


@pytest.mark.parametrize("name", FIVE_AXES)
def test_a_five_axis_machine_needs_eleven_with_a_known_tool_and_eight_with_any(name: str) -> None:
    """8 of the rotary axes and 3 squarenesses for a workpiece set up anyhow (ISO 230-7 has 4 for each rotary axis).

    Where the tool point may be anywhere, too, 8 in all: five lines have 14 parameters, 6 of which are a displacement
    of all together (Abbaszadeh-Mir et al. 2002).
    """
    found = sets(name)
    assert found[PLACEMENTS[1]].complete == 11
    assert found[PLACEMENTS[3]].complete == found[PLACEMENTS[3]].rank == 8
    assert found[PLACEMENTS[3]].missing == ()


@pytest.mark.parametrize("name", ["dmu60p", "gantry_mill", "bridge_cmm", "cframe_mill"])
def test_a_three_axis_machine_needs_three(name: str) -> None:
    found = sets(name)
    assert found[PLACEMENTS[1]].complete == found[PLACEMENTS[3]].complete == 3
    assert len(found[PLACEMENTS[1]].kept) + len(found[PLACEMENTS[1]].missing) == 3


def test_the_papers_squarenesses_are_the_smallest_set() -> None:
    for one in sets("dmu60p").values():
        assert one.kept == ("eps_xy", "eps_yz", "eps_xz")
        assert one.redundant == ()


def random_positions(name: str) -> np.ndarray:
    draw = np.random.default_rng(5)
    return np.array([draw.uniform(*model(name).travel[axis], 40) for axis in model(name).axes])


def test_displacements_of_two_axes_that_cancel() -> None:
    """dmu60p_5axis: EX0B is -EX0C, in words and on the exact model: X stands between nothing that turns."""
    found = sets("dmu60p_5axis")[PLACEMENTS[0]]
    assert [(one.name, one.stands_for) for one in found.redundant] == [("EX0B", "-1 EX0C")]
    positions, point = random_positions("dmu60p_5axis"), np.array([[3.0], [5.0], [-80.0]])

    def deviation(**values: float) -> np.ndarray:
        return (
            model("dmu60p_5axis")
            .with_values(ErrorValues(machine="dmu60p_5axis", parameters=values))
            .deviation(positions, point)
        )

    assert np.abs(deviation(EX0B=0.02) - deviation(EX0C=-0.02)).max() < 1e-12
    assert np.abs(deviation(EX0B=0.02)).max() > 0.01


def test_a_displaced_a_axis_is_a_displaced_tool_on_a_trunnion() -> None:
    """trunnion_mill: no rotary axis stands between A and the tool: the tool moved the other way does as well."""
    found = sets("trunnion_mill")[PLACEMENTS[2]]
    spare = {one.name: one.stands_for for one in found.redundant}
    assert spare == dict.fromkeys(("EY0A", "EZ0A", "EX0C"), "a displaced tool")
    positions, point = random_positions("trunnion_mill"), np.array([[0.0], [0.0], [-50.0]])
    machine = model("trunnion_mill")
    by_error = machine.with_values(ErrorValues(machine="trunnion_mill", parameters={"EZ0A": 0.01})).deviation(
        positions, point
    )
    by_tool = machine.ideal(positions, point - np.array([[0.0], [0.0], [0.01]])) - machine.ideal(positions, point)
    assert np.abs(by_error - by_tool).max() < 1e-12


def test_independent_columns_first_come_first_kept() -> None:
    draw = np.random.default_rng(1)
    a, b, c, free = draw.normal(size=(4, 30))
    columns = np.column_stack([a, 2.0 * a, b, a - 3.0 * b, c, free + b, np.zeros(30)])
    assert independent(columns, np.zeros((30, 0))) == [0, 2, 4, 5]
    assert independent(columns, free[:, np.newaxis]) == [0, 2, 4]
