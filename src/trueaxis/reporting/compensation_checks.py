"""What is to be compared with the machine before a compensated program first runs, in sentences."""

from collections.abc import Mapping

from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.sign_check import KinematicsCheck, Senses, SignCheck
from trueaxis.machine.machine import Machine

_SHOWN = 0.00005  # mm, half of the last decimal that is shown


def sign_check_text(check: SignCheck) -> str:
    """How to see with a gauge whether the signs are right."""
    turned = "" if check.axis == check.direction else f"; {check.axis} moves the tool along {check.direction} there"
    offset = abs(check.datum - check.at_home) >= _SHOWN
    why = " (not zero, as home itself is not corrected)" if offset else ""
    moved = f"{check.axis}{check.command:.9g} ({check.command - check.position[check.axis]:+.4f} mm{turned})"
    return (
        f"sign check before first use: set a gauge or laser between table and tool, along {check.direction} of the "
        f"workpiece frame, to zero at home ({position_text(check.home)}) and go to {position_text(check.position)} "
        f"(line {check.line}), {_axis_units(check.position)}: no work offset and no tool length may be in force.\n"
        f"  Without compensation it must show {check.since_home:+.4f} mm (above 0: the tool stands too far "
        f"towards {check.direction}+ of the workpiece).\n"
        f"  With the compensated program, which commands {moved}, it must show {check.compensated:+.4f} mm{why}.\n"
        "  If the first reading has the other sign, so have the error values: do not run the program."
    )


def _axis_units(at: Mapping[str, float]) -> str:
    """What positions are, whatever the program's unit."""
    return f"in machine coordinates, mm{'' if set(at) <= set(LINEAR) else ' and deg'}"


def kinematics_text(check: KinematicsCheck) -> str:
    """How to see on the control whether its rotary axes are those of the spec."""
    position = {axis: round(value, 3) for axis, value in check.position.items()}
    return (
        f"kinematics check before first use: at the end of line {check.line}, under tool centre point control, the "
        f"control must show {position_text(position)} in machine coordinates, to some hundredths of a mm (the "
        "corrections), with the work offset and the tool length as they were given here.\n"
        f"  Turned rotary axes have moved the linear ones by {check.turned:.1f} mm there. If it shows something else, "
        "its kinematics are not those of the spec (sense or place of a rotary axis): do not run the program."
    )


# about which direction of the workpiece frame, right-handed: from where to where that is
_TURNS = {"X+": "Y+ to Z+", "X-": "Z+ to Y+", "Y+": "Z+ to X+", "Y-": "X+ to Z+", "Z+": "X+ to Y+", "Z-": "Y+ to X+"}


def senses_text(senses: Senses) -> str:
    """Which way the model takes the axes to go."""
    parts: list[str] = []
    for axis, way in senses.towards.items():
        first = " move the tool" if not parts else ""
        workpiece = " of the workpiece" if not parts else ""
        table = f" (as where the table moves to {way[0]}+)" if way[1] == "-" else ""
        parts.append(f"{axis}+ commands{first} to {way}{workpiece}{table}")
    parts += [f"{axis}+ turns it from {_TURNS[way]}" for axis, way in senses.about.items()]
    at = f"at {position_text(senses.rotary)} " if senses.rotary else ""
    return (
        f"the model takes it that {at}{', '.join(parts)}. "
        "If that is not so on the machine, `sense` in the spec is wrong: do not run the program."
    )


def tool_frame_sentences(machine: Machine, parameters: Mapping[str, float]) -> list[str]:
    """From where lengths of tools count, where the spec puts the tool frame elsewhere than the spindle's body has its
    own.
    """
    body = machine.body(machine.tool)
    values = [parameters.get(part, 0.0) if isinstance(part, str) else part for part in body.position]
    if not any(values):
        return []
    names = [part for part in body.position if isinstance(part, str)]
    named = f" ({', '.join(names)})" if names else ""
    return [
        f"the spec puts the tool frame at {', '.join(f'{value:.9g}' for value in values)}{named} of the body that "
        "carries it, and lengths of --tools count from there: if that is the length of a tool, and not where the "
        "spindle ends, it counts twice"
    ]


def position_text(at: Mapping[str, float]) -> str:
    """Axis positions, mm and deg."""
    return " ".join(f"{axis}{value + 0.0:.9g}" for axis, value in at.items())
