"""LinuxCNC tables of screw error compensation: nominal, forward, reverse.

COMP_FILE_TYPE 0: forward and reverse are where the joint really gets when it is sent to nominal; motion adds nominal
less that to the command. 1: they are what motion adds to the command (src/emc/motion/usrmotintf.cc and control.c).
"""

from collections.abc import Mapping, Sequence

from trueaxis.controllers.axis_tables import AxisTable, plain

DIGITS = 7
MOST_POINTS = 256  # EMCMOT_COMP_SIZE
ACTUAL, TRIM = FILE_TYPES = (0, 1)  # of COMP_FILE_TYPE


def comp_files(tables: Sequence[AxisTable], file_type: int = ACTUAL) -> Mapping[str, str]:
    """Name -> text: a table for every axis by itself, and the lines for the INI file. Joints count as in XYZ order."""
    files = {f"{table.of.lower()}.comp": comp_text(table, file_type) for table in tables}
    lines = []
    for joint, table in enumerate(tables):
        lines.append(f"[JOINT_{joint}]\nCOMP_FILE = {table.of.lower()}.comp\nCOMP_FILE_TYPE = {file_type}\n")
    files["joints.ini"] = "\n".join(lines)
    return files


def comp_text(table: AxisTable, file_type: int = ACTUAL) -> str:
    """Lines of nominal, forward and reverse, in ascending order, mm or deg. file_type: one of FILE_TYPES."""
    rows = zip(table.positions, table.forward, table.backward, strict=True)
    lines = [(at, -there, -back) if file_type == TRIM else (at, at + there, at + back) for at, there, back in rows]
    return "".join(" ".join(plain(cell, DIGITS) for cell in line) + "\n" for line in lines)
