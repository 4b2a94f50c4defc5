"""LinuxCNC tables of screw error compensation: nominal, forward, reverse (COMP_FILE_TYPE 0).

forward and reverse are where the joint really gets when it is sent to nominal. Motion adds nominal less that to the
command (src/emc/motion/usrmotintf.cc and control.c).
"""

from collections.abc import Mapping, Sequence

from trueaxis.controllers.axis_tables import AxisTable, plain

DIGITS = 7
MOST_POINTS = 256  # EMCMOT_COMP_SIZE


def comp_files(tables: Sequence[AxisTable]) -> Mapping[str, str]:
    """Name -> text: a table for every axis by itself, and the lines for the INI file. Joints count as in XYZ order."""
    files = {f"{table.of.lower()}.comp": comp_text(table) for table in tables}
    lines = []
    for joint, table in enumerate(tables):
        lines.append(f"[JOINT_{joint}]\nCOMP_FILE = {table.of.lower()}.comp\nCOMP_FILE_TYPE = 0\n")
    files["joints.ini"] = "\n".join(lines)
    return files


def comp_text(table: AxisTable) -> str:
    """Lines of nominal, forward and reverse, in ascending order, mm or deg."""
    return "".join(
        f"{plain(at, DIGITS)} {plain(at + there, DIGITS)} {plain(at + back, DIGITS)}\n"
        for at, there, back in zip(table.positions, table.forward, table.backward, strict=True)
    )
