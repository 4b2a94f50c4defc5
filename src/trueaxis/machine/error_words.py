"""Component and location errors in words (ISO 230-1, ISO 230-7)."""

from trueaxis.error_name import Direction, ErrorName, line_of
from trueaxis.machine.machine import BED, LINEAR, Body, Machine


def component_words(component: ErrorName) -> str:
    """`straightness error of X in Y`, `tilt error motion of C about X`."""
    axis, line = component.axis, component.direction.line
    if component.is_of_linear_axis:
        if component.is_rotation:
            return f"roll error of {axis}" if line == axis else f"angular error of {axis} about {line} (pitch or yaw)"
        return f"positioning error of {axis}" if line == axis else f"straightness error of {axis} in {line}"
    if component.is_positioning:
        return f"angular positioning error of {axis}"
    if component.is_rotation:
        return f"tilt error motion of {axis} about {line}"
    own = component.direction.line == line_of(axis)
    return f"axial error motion of {axis}, along {line}" if own else f"radial error motion of {axis} in {line}"


def location_words(machine: Machine, name: str) -> str:
    """`squareness error of Z to Y, about X; Z slide on the bed`: of a location error of a machine."""
    body = next(body for body in machine.bodies if name in (one for _, one in body.position_errors))
    lower = "the bed" if body.lower == BED else machine.body(body.lower).name
    return f"{_of_axis(machine, body, machine.location_direction(name))}; {body.name} on {lower}"


def _of_axis(machine: Machine, body: Body, direction: Direction) -> str:
    axis, line = body.moves, direction.line
    if axis is None:
        return f"rotation about {line}" if direction.is_rotation else f"displacement along {line}"
    own = line == line_of(axis)
    if not direction.is_rotation:
        zero = own and axis in LINEAR
        return f"zero position error of {axis}" if zero else f"error of the position of {axis} in {line}"
    if own:
        return (
            f"error of the orientation of {axis} about itself" if axis in LINEAR else f"zero position error of {axis}"
        )
    third = next(letter for letter in LINEAR if letter not in (line, line_of(axis)))
    if axis in LINEAR and third in machine.axes:
        return f"squareness error of {axis} to {third}, about {line}"
    return f"error of the orientation of {axis} about {line}"
