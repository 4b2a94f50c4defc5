"""Specs of many topologies by label."""

from typing import Any

from tests.machines import DMU60P, FIVE_AXIS, serial_text, spec_text, three_axis_texts

THREE_AXIS = dict(three_axis_texts())

TILTED: dict[str, dict[str, Any]] = {
    "A": {"position": [1.5, "q_A", -7.25], "position_errors": {"EY": "aY", "EB": "aB", "EC": "aC"}},
    "B": {"position": ["q_B", 0.1, 30.0], "sense": -1, "position_errors": {"EX": "bX", "EZ": "bZ", "EA": "bA"}},
    "C": {"position": [10.0, -20.0, "q_C"], "position_errors": {"EX": "cX", "EA": "cA", "EB": "cB"}},
    "Y": {"sense": -1, "position": [0.0, 5.5, 0.0]},
}


def shared_text() -> str:
    """Both ends stand on a moving body with errors; fixed bodies with errors lie between moving ones."""
    travel = {"travel": [-100.0, 300.0]}
    return spec_text(
        [
            {"number": 20, "name": "base", "lower": 1, "position": [1.0, 2.0, "q_b"], "position_errors": {"EA": "b0"}},
            {"number": 3, "name": "X", "lower": 20, "moves": "X", **travel, "position_errors": {"EB": "b1"}},
            {"number": 4, "name": "A", "lower": 3, "moves": "A", **travel, **TILTED["A"]},
            {"number": 5, "name": "bracket", "lower": 4, "position": [0.0, 11.5, 0.0], "position_errors": {"EX": "b2"}},
            {"number": 7, "name": "work", "lower": 5, "position": ["q_1", "q_2", "q_3"]},
            {"number": 6, "name": "Z", "lower": 3, "moves": "Z", **travel, "motion_errors": ["EAZ", "EXZ"]},
            {"number": 9, "name": "tool", "lower": 6, "position_errors": {"EC": "b3", "EY": "b4"}},
        ],
        7,
        9,
    )


OTHERS = {
    "dmu60p": DMU60P.read_text(),
    "five_axis": FIVE_AXIS.read_text(),
    "table-table AC": serial_text("YAC", "XZ", **TILTED),
    "head-head CB": serial_text("X", "YZCB", **TILTED),
    "table B, head A": serial_text("ZB", "XYA", **TILTED),
    "all on the tool side": serial_text("", "XYZAB", **TILTED),
    "all on the workpiece side": serial_text("ZAC", "", **TILTED),
    "shared": shared_text(),
}
