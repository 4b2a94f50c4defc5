"""Views: a point of one body, seen in the frame of another."""

from typing import Literal, get_args

Carrier = Literal["tool", "workpiece", "bed"]
Frame = Literal["bed", "workpiece"]
View = Literal["tool_in_workpiece", "tool_in_bed", "workpiece_in_bed", "bed_in_workpiece"]
VIEWS: tuple[View, ...] = get_args(View)


def view_of(carrier: Carrier, frame: Frame) -> View:
    """The view of points of the carrier in a frame. Raises ValueError where the frame is the carrier's own."""
    name = f"{carrier}_in_{frame}"
    if name not in VIEWS:
        raise ValueError(f"points of the {carrier} rest in the frame of the {frame}")
    return name
