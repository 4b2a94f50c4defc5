"""Views: a point of one end seen in a frame of another, as the walk of factors that takes it there.

Four views carry everything: positions are compared (Eqs. 4-6), displacements measured (Eqs. 7-11) and errors
compensated (Eqs. 53-55) with them.
"""

from dataclasses import dataclass

from trueaxis.derivation.chain import Joint, Step, chains
from trueaxis.machine.machine import Machine
from trueaxis.view import Carrier, Frame, View


@dataclass(frozen=True)
class Factor:
    """One factor met by a point on its way, and whether it is met inverted."""

    step: Step
    inverted: bool


@dataclass(frozen=True)
class ViewWalk:
    """A point of `seen` in the frame of `frame`; `walk` lists the factors in the order in which they act on it."""

    name: View
    seen: Carrier
    frame: Frame
    walk: tuple[Factor, ...]


def views(machine: Machine) -> tuple[ViewWalk, ...]:
    """The views of a machine: tool_in_workpiece (Eq. 4), tool_in_bed and workpiece_in_bed (Eq. 53), bed_in_workpiece.

    A body below both ends stands on both branches; what it does to the view cancels only as far as it truly does.
    """
    workpiece, tool = chains(machine)
    up_tool, up_workpiece = _towards_bed(tool), _towards_bed(workpiece)
    down_workpiece = tuple(Factor(factor.step, True) for factor in reversed(up_workpiece))
    return (
        ViewWalk("tool_in_workpiece", "tool", "workpiece", up_tool + down_workpiece),
        ViewWalk("tool_in_bed", "tool", "bed", up_tool),
        ViewWalk("workpiece_in_bed", "workpiece", "bed", up_workpiece),
        ViewWalk("bed_in_workpiece", "bed", "workpiece", down_workpiece),
    )


def view(machine: Machine, name: View) -> ViewWalk:
    """The view of that name."""
    return next(candidate for candidate in views(machine) if candidate.name == name)


def _towards_bed(joints: tuple[Joint, ...]) -> tuple[Factor, ...]:
    return tuple(Factor(step, False) for part in reversed(joints) for step in reversed(part.steps))
