"""The machines that effects are hidden in. A located error EC of the body that X moves is called EC0X here.

Tool frames lie amid the working volume: levers of the rotations about the carriages have both signs, so that lines at
several offsets tell a rotation from a translation.
"""

from tests.hidden_effects.machine import Joint, Machine

TABLE_MILL = Machine(
    "table_mill",
    (
        Joint(2, 1, "Y slide", "Y", (0.0, 700.0)),
        Joint(4, 2, "workpiece", position=("q_wx", "q_wy", "q_wz")),
        Joint(5, 1, "X slide", "X", (0.0, 540.0), located={"EC": "eps_xy"}),
        Joint(6, 5, "Z slide", "Z", (0.0, 600.0), located={"EA": "eps_yz", "EB": "eps_xz"}),
        Joint(9, 6, "tool", position=("q_Tx", "q_Ty", "q_Tz")),
    ),
    workpiece=4,
    tool=9,
    dimensions={"q_wx": 270.0, "q_wy": -350.0, "q_wz": 20.0, "q_Tx": 2.0, "q_Ty": -3.0, "q_Tz": -250.0},
)

GANTRY = Machine(
    "gantry",
    (
        Joint(2, 1, "workpiece", position=("q_wx", "q_wy", "q_wz")),
        Joint(3, 1, "gantry", "X", (0.0, 1500.0)),
        Joint(4, 3, "cross slide", "Y", (0.0, 900.0), located={"EC": "s_xy"}),
        Joint(5, 4, "ram", "Z", (-600.0, 0.0), located={"EA": "s_yz", "EB": "s_xz"}),
        Joint(6, 5, "tool", position=("q_Tx", "q_Ty", "q_Tz")),
    ),
    workpiece=2,
    tool=6,
    dimensions={"q_wx": 100.0, "q_wy": 50.0, "q_wz": -100.0, "q_Tx": 0.0, "q_Ty": 10.0, "q_Tz": 300.0},
)

FIVE_AXES = Machine(
    "turntable_mill",
    (
        Joint(2, 1, "Y slide", "Y", (0.0, 700.0)),
        Joint(
            3,
            2,
            "table",
            "C",
            (-360.0, 360.0),
            position=("q_Cx", "q_Cy", "q_Cz"),
            located={"EX": "EX0C", "EY": "EY0C", "EA": "EA0C", "EB": "EB0C"},
        ),
        Joint(4, 3, "workpiece", position=("q_wx", "q_wy", "q_wz")),
        Joint(5, 1, "X slide", "X", (0.0, 540.0), located={"EC": "eps_xy"}),
        Joint(6, 5, "Z slide", "Z", (0.0, 600.0), located={"EA": "eps_yz", "EB": "eps_xz"}),
        Joint(9, 6, "tool", position=("q_Tx", "q_Ty", "q_Tz")),
    ),
    workpiece=4,
    tool=9,
    dimensions={"q_Cx": 270.0, "q_Cy": -350.0, "q_Cz": 0.0, "q_wx": 0.0, "q_wy": 0.0, "q_wz": 30.0}
    | {"q_Tx": 2.0, "q_Ty": -3.0, "q_Tz": -250.0},
)

MACHINES = {machine.name: machine for machine in (TABLE_MILL, GANTRY, FIVE_AXES)}
