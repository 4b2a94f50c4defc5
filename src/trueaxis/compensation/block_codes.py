"""What the M codes of a block that moves nothing do to the program; for readers that make such blocks."""

import re

from trueaxis.compensation import m_codes
from trueaxis.compensation.commanded import CommandedAxes
from trueaxis.compensation.fault_log import FaultLog
from trueaxis.compensation.moves import STOP, TOOL_CHANGE, Notes
from trueaxis.compensation.settings import Settings

_M_CODE = re.compile(r"\bM(\d+)\b")


def follow_codes(
    block: str, line: int, commanded: CommandedAxes, settings: Settings, faults: FaultLog, notes: Notes
) -> bool:
    """Follow the M codes of a block; returns whether one ends the program."""
    codes = [int(code) for code in _M_CODE.findall(block)]
    for code in codes:
        if problem := m_codes.problem_of(code, settings.pass_m, settings.dialect):
            faults.add(line, *problem)
        elif m_codes.vouched_for(code, settings.pass_m):
            notes.pass_code(line, code)
        elif code == m_codes.TOOL_CHANGE:
            notes.add(line, TOOL_CHANGE)
            commanded.displace()
        elif code in m_codes.STOPS:
            notes.add(line, STOP)
            commanded.stop()
    return not m_codes.END.isdisjoint(codes)
