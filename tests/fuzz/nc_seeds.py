"""Valid programs in the languages of controls."""

from random import Random

from trueaxis.machine import Machine


def _at(machine: Machine, draw: Random, gap: str = " ", sign: str = "") -> str:
    """Words of the linear axes within the middle of their travel."""
    low_high = {axis: machine.travel[axis] for axis in machine.axes if axis in "XYZ"}
    inner = {axis: (low + 0.4 * (high - low), low + 0.6 * (high - low)) for axis, (low, high) in low_high.items()}
    return gap.join(f"{axis}{sign}{draw.uniform(*between):.3f}" for axis, between in inner.items())


def _rotary(machine: Machine, angle: str) -> str:
    return " ".join(f"{axis}{angle}" for axis in machine.axes if axis in "ABC")


def siemens(machine: Machine, draw: Random) -> str:
    """SINUMERIK: names, `=`, frames, increments, comments."""
    lines = [
        "%_N_PART_MPF", ";$PATH=/_N_WKS_DIR", "N10 G71 G90 G17 G94 ; part", f"G0 {_at(machine, draw)}",
        _rotary(machine, "0."), f"N20 G1 {_at(machine, draw, sign='=')} F200 M8", 'MSG("a (b")',
        f"{_at(machine, draw)}", "G641 ADIS=0.1", f"G1 {_at(machine, draw)} M9", "STOPRE",
    ]  # fmt: skip
    if {"X", "Y"} <= set(machine.axes):
        lines += ["G91 G1 X=1.5", "G90", "G2 X=IC(10) Y=IC(0) CR=5"]
    return "\n".join([*lines, "TRANS X=1.5" if draw.random() < 0.3 else "G60", "M30", ""])


def klartext(machine: Machine, draw: Random) -> str:
    """Heidenhain: lines, arcs about a pole, increments, cycles that are defined, M codes."""
    lines = ["BEGIN PGM PART MM", "; part", f"L {_at(machine, draw)} R0 FMAX M3",
             f"L {_rotary(machine, '+0')} FMAX", f"L {_at(machine, draw)} F500", f"L {_at(machine, draw)}",
             "CYCL DEF 9.0 DWELL TIME", "CYCL DEF 9.1 DWELL 0.5", "L M9"]  # fmt: skip
    if {"X", "Y"} <= set(machine.axes):
        lines += ["L IX+5 IY-2 R0", "CR IX+10 IY+0 R+5 DR-", "CC IX+5 IY+0", "CP IPA+90 DR+"]
    lines = [line for line in lines if line != "L  FMAX"]
    return "\n".join(f"{n} {text}" for n, text in enumerate([*lines, "L M2", "END PGM PART MM"])) + "\n"


def fanuc(machine: Machine, draw: Random) -> str:
    """Fanuc and the like: program number, tools, further offsets, reference points, cycles."""
    lines = ["%", "O1234 (PART)", "N1 G21 G90 G17 G40 G49 G80", "T1 M6", "G54.1 P3",
             f"G0 {_at(machine, draw)} S1000 M3", f"{_rotary(machine, '0.')}", f"G1 {_at(machine, draw)} F200.",
             f"G1 {_at(machine, draw)}"]  # fmt: skip
    if set("XYZ") <= set(machine.axes):
        x, y, z = (sum(machine.travel[axis]) / 2 for axis in "XYZ")
        lines += [f"G43 H1 Z{z:.3f}", f"G99 G81 X{x:.3f} Y{y:.3f} Z{z - 3:.3f} R{z - 1:.3f} F100.", "G80",
                  "G52 X1.", f"G0 X{x - 2:.3f} Y{y:.3f}", f"G2 X{x + 2:.3f} Y{y:.3f} R5. F90.", "G52 X0."]  # fmt: skip
    return "\n".join([*lines, "M30", "%", ""])


def point_control(machine: Machine, draw: Random) -> str:
    """Tool centre point control of a Fanuc."""
    return "\n".join([
        "O1 (TCP)", "G21 G90 G94", "T1 M6", f"G0 {_at(machine, draw)} {_rotary(machine, '0.')}", "G43.4 H1",
        f"G1 {_at(machine, draw)} F500.", f"{_rotary(machine, '1.5')}",
        f"{_at(machine, draw)} {_rotary(machine, '-2.')}", f"{_rotary(machine, '0.')}", "G49",
        f"G0 {_at(machine, draw)}", "M30", "",
    ])  # fmt: skip
