"""Cases small enough to work out with pencil and paper: above all the signs on the workpiece side."""

from typing import Any

import numpy as np
import pytest

from tests.kernels import call, kernels_of
from tests.machines import FIVE_AXIS, serial_text

E = 1e-6
POINT = np.array([[3.0], [5.0], [7.0]])
Y_TABLE = serial_text("Y", "XZ", Y={"position_errors": {"EC": "eps"}})
C_TABLE = serial_text("C", "X", C={"position_errors": {"EX": "off", "EC": "zero"}})
C_TABLE_BACKWARDS = serial_text("C", "X", C={"sense": -1})
B_HEAD = serial_text("", "XZB", B={"position": [0.0, 0.0, -50.0]})

ZERO_DEGREES, QUARTER = {"C": 0.0, "X": 0.0}, {"C": 90.0, "X": 0.0}


def ideal(text: str, view: str, pose: dict[str, float], point: Any = POINT) -> Any:
    return call(kernels_of(text), f"{view}_ideal", pose, {}, np.array(point).reshape(3, 1))[:, 0]


def deviation(text: str, view: str, pose: dict[str, float], point: Any = POINT, **errors: float) -> Any:
    return (
        call(kernels_of(text), f"{view}_deviation_first_order", pose, errors, np.array(point).reshape(3, 1))[:, 0] / E
    )


def is_close(found: Any, wanted: Any) -> None:
    np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-9)


def test_a_table_that_moves_along_y_moves_the_tool_point_back_along_y_in_its_frame() -> None:
    pose = {"X": 10.0, "Y": 20.0, "Z": 30.0}
    is_close(ideal(Y_TABLE, "tool_in_workpiece", pose), [13, 5 - 20, 37])
    is_close(ideal(Y_TABLE, "workpiece_in_bed", pose), [3, 25, 7])


def test_a_translation_error_of_the_table_displaces_the_image_of_the_tool_point_the_other_way() -> None:
    pose = {"X": 0.0, "Y": 20.0, "Z": 0.0}
    is_close(deviation(Y_TABLE, "tool_in_workpiece", pose, EXY=E, EZY=2 * E), [-1, 0, -2])
    is_close(deviation(Y_TABLE, "workpiece_in_bed", pose, EXY=E, EZY=2 * E), [1, 0, 2])
    is_close(deviation(Y_TABLE, "tool_in_workpiece", pose, EXX=E, EZZ=2 * E), [1, 0, 2])


def test_a_rotation_error_of_the_table_turns_the_image_of_the_tool_point_the_other_way() -> None:
    # The tool point stands at (3, 5, 7) in the bed, the table at y = 20, so at (3, -15, 7) before the table.
    # Turned by -ECY about z: -ECY z x p = -ECY (-p_y, p_x, 0) = ECY (p_y, -p_x, 0).
    pose = {"X": 0.0, "Y": 20.0, "Z": 0.0}
    is_close(deviation(Y_TABLE, "tool_in_workpiece", pose, ECY=E), [-15, -3, 0])
    # -EAY x x p = EAY (0, p_z, -p_y)
    is_close(deviation(Y_TABLE, "tool_in_workpiece", pose, EAY=E), [0, 7, 15])
    # -EBY y x p = EBY (-p_z, 0, p_x)
    is_close(deviation(Y_TABLE, "tool_in_workpiece", pose, EBY=E), [-7, 0, 3])
    # A point of the table itself turns with it: its own coordinates are the lever.
    is_close(deviation(Y_TABLE, "workpiece_in_bed", pose, ECY=E), [-5, 3, 0])


def test_squareness_acts_before_the_motion_and_a_motion_error_after_it() -> None:
    # eps turns the guide: the table's travel of 20 along y leads to -20 eps in x, its own point turns as with ECY.
    pose = {"X": 0.0, "Y": 20.0, "Z": 0.0}
    is_close(deviation(Y_TABLE, "workpiece_in_bed", pose, eps=E), [-25, 3, 0])
    is_close(deviation(Y_TABLE, "tool_in_workpiece", pose, eps=E), [5, -3, 0])


@pytest.mark.parametrize(("table", "way"), [(C_TABLE, 1), (C_TABLE_BACKWARDS, -1)])
def test_error_motions_of_a_rotary_table_turn_with_it(table: str, way: int) -> None:
    # At 90 deg the table's x axis points along the bed's y, or along -y where the sense is reversed.
    is_close(ideal(table, "workpiece_in_bed", QUARTER), [-5 * way, 3 * way, 7])
    is_close(deviation(table, "workpiece_in_bed", QUARTER, EXC=E), [0, way, 0])
    for pose in (ZERO_DEGREES, QUARTER):
        is_close(deviation(table, "tool_in_workpiece", pose, EXC=E), [-1, 0, 0])


def test_a_displaced_rotary_axis_does_not_turn_with_the_table() -> None:
    is_close(deviation(C_TABLE, "workpiece_in_bed", QUARTER, off=E), [1, 0, 0])
    # Seen from the table, which has turned by 90 deg, the bed's -x is +y.
    is_close(deviation(C_TABLE, "tool_in_workpiece", QUARTER, off=E), [0, 1, 0])


def test_a_rotation_of_the_table_too_far_turns_the_image_of_the_tool_point_back() -> None:
    # At C = 90 the tool point (3, 5, 7) is (5, -3, 7) in the table; turned by -ECC: ECC (p_y, -p_x, 0).
    is_close(ideal(C_TABLE, "tool_in_workpiece", QUARTER), [5, -3, 7])
    is_close(deviation(C_TABLE, "tool_in_workpiece", QUARTER, ECC=E), [-3, -5, 0])
    is_close(deviation(C_TABLE, "tool_in_workpiece", QUARTER, zero=E), [-3, -5, 0])


def test_a_head_swings_the_tool_tip_by_its_length() -> None:
    # Tool tip 50 + 100 below the Z slide: EBB y x (0, 0, -100) = (-100 EBB, 0, 0), turned by B about y.
    tip, pose = [0.0, 0.0, -100.0], {"X": 0.0, "Z": 0.0, "B": 0.0}
    is_close(ideal(B_HEAD, "tool_in_workpiece", pose, tip), [0, 0, -150])
    is_close(deviation(B_HEAD, "tool_in_workpiece", pose, tip, EBB=E), [-100, 0, 0])
    down = pose | {"B": 90.0}
    is_close(ideal(B_HEAD, "tool_in_workpiece", down, tip), [-100, 0, -50])
    is_close(deviation(B_HEAD, "tool_in_workpiece", down, tip, EBB=E), [0, 0, 100])


def test_a_slide_turns_all_that_stands_on_it_with_the_travel_of_what_stands_on_it() -> None:
    # EBX of the X slide at Z = 40: the tool point is 40 + 7 above it.
    pose = {"X": 0.0, "Y": 0.0, "Z": 40.0}
    is_close(deviation(Y_TABLE, "tool_in_workpiece", pose, EBX=E), [47, 0, -3])
    is_close(deviation(Y_TABLE, "tool_in_workpiece", pose, EBZ=E), [7, 0, -3])


def test_home_positions_of_the_five_axis_machine_add_up() -> None:
    module = kernels_of(FIVE_AXIS.read_text())
    home = dict.fromkeys("XYZBC", 0.0)
    values = {"q_Cx": 1, "q_Cy": 2, "q_wx": 10, "q_wy": 20, "q_wz": 30, "q_Hz": 200, "q_Tx": 4, "q_Ty": 5, "q_Tz": 6}
    found = call(module, "tool_in_workpiece_ideal", home, values, POINT)[:, 0]
    is_close(found, [3 + 4 - 10 - 1, 5 + 5 - 40.25 - 20 - 2, 7 + 6 + 200 - 80 - 30 - 12.3])
