"""M codes in blocks of Heidenhain Klartext: which are not known, and what the user vouches for."""

from trueaxis.compensation.klartext.blocks import MACHINE_COORDINATES, RETRACT, KlartextBlock
from trueaxis.compensation.klartext.cycles import PLAIN_CYCLES
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.moves import Notes
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.settings import Settings

_CALL, _EACH_POSITION = 99, 89  # call the cycle that is defined before


def known_codes(number: int, block: KlartextBlock, settings: Settings, faults: FaultLog, notes: Notes) -> None:
    """Note faults of M codes, and what is passed."""
    if block.retracts and block.coordinates:
        faults.add(number, "M140 and a position in one block", "a block for each")
    for code in block.codes:
        if code == MACHINE_COORDINATES or code in m_codes.POINT_CONTROL["heidenhain"]:
            continue
        if code == RETRACT and block.retracts:
            continue
        if problem := m_codes.problem_of(code, settings.pass_m, "heidenhain"):
            calls = code in (_CALL, _EACH_POSITION)
            faults.add(number, problem[0], f"{m_codes.NOT_PASSED}; {PLAIN_CYCLES}" if calls else problem[1])
        elif m_codes.vouched_for(code, settings.pass_m):
            notes.pass_code(number, code)
