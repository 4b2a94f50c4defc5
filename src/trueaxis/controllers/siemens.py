"""SINUMERIK tables: leadscrew and encoder error ($AA_ENC_COMP), sag and angularity between axes ($AN_CEC).

In both a positive value moves the axis in the negative direction (Function Manual Extended Functions, K3), so that
values are the deviations themselves, actual minus commanded.
"""

from collections.abc import Sequence

from trueaxis.controllers.axis_tables import AxisTable, plain

DIGITS = 6  # nm
ENC_HEAD = "%_N_AX_EEC_INI\nCHANDATA(1)\n"
CEC_HEAD = "%_N_NC_CEC_INI\nCHANDATA(1)\n"


def encoder_text(tables: Sequence[AxisTable], notes: Sequence[str] = ()) -> str:
    """The text of $AA_ENC_COMP for tables of axes by themselves; the machine axes are named X1, Y1 ..."""
    lines = [ENC_HEAD, *(f"; {note}\n" for note in notes)]
    for table in tables:
        axis = f"{table.of}1"
        lines.append(f"; axis {axis}: MD38000 $MA_MM_ENC_COMP_MAX_POINTS[0,{axis}] >= {table.positions.size}\n")
        lines += [f"$AA_ENC_COMP[0,{index},{axis}]={plain(value, DIGITS)}\n" for index, value in enumerate(table.mean)]
        lines.append(f"$AA_ENC_COMP_STEP[0,{axis}]={plain(table.step, 9)}\n")
        lines.append(f"$AA_ENC_COMP_MIN[0,{axis}]={plain(table.positions[0], DIGITS)}\n")
        lines.append(f"$AA_ENC_COMP_MAX[0,{axis}]={plain(table.positions[-1], DIGITS)}\n")
        lines.append(f"$AA_ENC_COMP_IS_MODULO[0,{axis}]=0\n")
    return "".join([*lines, "M17\n"])


def sag_text(tables: Sequence[AxisTable], notes: Sequence[str] = ()) -> str:
    """The text of $AN_CEC for tables of axes by others, numbered from 0 in their order."""
    lines = [CEC_HEAD, *(f"; {note}\n" for note in notes)]
    for number, table in enumerate(tables):
        lines.append(f"; table {number}: axis {table.of}1 by axis {table.by}1; ")
        lines.append(f"MD18342 $MN_MM_CEC_MAX_POINTS[{number}] >= {table.positions.size}\n")
        lines += [f"$AN_CEC[{number},{index}]={plain(value, DIGITS)}\n" for index, value in enumerate(table.mean)]
        lines.append(f"$AN_CEC_INPUT_AXIS[{number}]=({table.by}1)\n")
        lines.append(f"$AN_CEC_OUTPUT_AXIS[{number}]=({table.of}1)\n")
        lines.append(f"$AN_CEC_STEP[{number}]={plain(table.step, 9)}\n")
        lines.append(f"$AN_CEC_MIN[{number}]={plain(table.positions[0], DIGITS)}\n")
        lines.append(f"$AN_CEC_MAX[{number}]={plain(table.positions[-1], DIGITS)}\n")
        lines.append(f"$AN_CEC_DIRECTION[{number}]=0\n")
        lines.append(f"$AN_CEC_MULT_BY_TABLE[{number}]=0\n")
        lines.append(f"$AN_CEC_IS_MODULO[{number}]=0\n")
    return "".join([*lines, "M17\n"])
