"""The topology of a machine: its lower-body array of all orders and its two branches (Sect. 2.1 of the paper).

The lower-body array L gives each body its lower body; L^n is L applied n times, L^0 the body itself, and L^n(j) = 1
where the branch of body j has reached the bed after n steps (Eqs. 2 and 3). Beyond the bed the array holds 0.
"""

from trueaxis.machine.machine import BED, Body, Machine


def lower_body_array(machine: Machine) -> tuple[tuple[int, ...], ...]:
    """Rows L^0, L^1, ... L^n over the bodies (the bed first), n the first order at which all have left the bed."""
    lower = {BED: 0, 0: 0} | {body.number: body.lower for body in machine.bodies}
    rows = [(BED, *(body.number for body in machine.bodies))]
    while any(rows[-1]):
        rows.append(tuple(lower[number] for number in rows[-1]))
    return tuple(rows)


def branch(machine: Machine, end: int) -> tuple[Body, ...]:
    """The bodies from the bed (not among them) to an end, in the order of the factors of Eqs. (2) and (3)."""
    bodies: list[Body] = []
    while end != BED:
        bodies.append(machine.body(end))
        end = bodies[-1].lower
    return tuple(reversed(bodies))


def branches(machine: Machine) -> tuple[tuple[Body, ...], tuple[Body, ...]]:
    """The two ways from the bed: to the workpiece (Eq. 2) and to the tool (Eq. 3).

    A body on which both stand belongs to both; its errors move both and their difference is what is seen.
    """
    return branch(machine, machine.workpiece), branch(machine, machine.tool)


def tool_senses(machine: Machine) -> dict[str, int]:
    """Which way a positive command of each axis moves the tool along that axis of the workpiece, or turns it about the
    axis (right-handed): 1 or -1. 0 where both ends stand on the axis, which moves them together. Rotary axes are at 0.
    """
    to_workpiece, to_tool = branches(machine)
    movers = {axis: machine.mover(axis) for axis in machine.axes}
    return {axis: body.sense * ((body in to_tool) - (body in to_workpiece)) for axis, body in movers.items()}


def format_lower_body_array(machine: Machine) -> str:
    """The array as an aligned text table."""
    rows = lower_body_array(machine)
    width = max(len(str(number)) for number in rows[0]) + 2
    return "\n".join(f"L^{order}" + "".join(str(n).rjust(width) for n in row) for order, row in enumerate(rows)) + "\n"
