"""The work offsets and tools that a program used, as its report names them."""

from collections.abc import Mapping

import numpy as np

from trueaxis.compensation.datum import Datum
from trueaxis.compensation.elsewhere import OffsetUse, offset_use, unplaced_change
from trueaxis.compensation.machine import ErrorModel, FloatArray, Place, rotary_rows
from trueaxis.compensation.moves import Setup
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.tools import ToolUse
from trueaxis.compensation.touched_off import TouchedOff
from trueaxis.compensation.visited import Visited


def tools_used(visited: Mapping[Setup, Visited]) -> tuple[ToolUse, ...]:
    """The tools of --tools with which the program moved."""
    points = {setup.tool: one.tool_point for setup, one in visited.items() if one.positions.size}
    return tuple(
        ToolUse(tool, (float(point[0, 0]), float(point[1, 0]), float(point[2, 0])))
        for tool, point in points.items()
        if tool
    )


def offsets_used(model: ErrorModel, visited: Mapping[Setup, Visited], settings: Settings) -> tuple[OffsetUse, ...]:
    """The work offsets under which the program moved."""
    used: dict[Setup, list[tuple[FloatArray, FloatArray]]] = {}  # whatever the tool
    lengths: dict[str, float] = {}  # of the first tool under each whose length counts
    turned: dict[str, dict[str, float]] = {}  # where rotary axes stand at the first feed motion under each
    tools = {} if settings.tools is None else settings.tools.tools
    for setup, one in visited.items():
        if setup.system and one.positions.size:
            used.setdefault(setup._replace(tool=None, point_control=False), []).append((one.positions, one.tool_point))
            if (tool := tools.get(setup.tool or 0)) is not None:
                lengths.setdefault(setup.system, tool.shift[2])
            if (at := one.first_fed) is not None:
                turned.setdefault(setup.system, {model.axes[row]: float(at[row]) for row in rotary_rows(model.axes)})
    point = np.array(settings.tool_point, dtype=np.float64)[:, np.newaxis]

    def datum(system: str) -> Datum:
        return Datum(_touched(system, settings), point, lengths.get(system, 0.0), turned.get(system, {}))

    return tuple(
        offset_use(
            model,
            places,
            setup.system,
            dict(zip(model.axes, setup.values, strict=True)),
            np.array(setup.spread),
            datum(setup.system),
        )
        for setup, places in used.items()
    )


def unplaced(model: ErrorModel, visited: Mapping[Setup, Visited]) -> float | None:
    """By how much words may change with the zero of a program of which no work offset is known, mm; None: it moves
    nowhere.
    """
    places = [
        (one.positions, one.tool_point) for setup, one in visited.items() if not setup.system and one.positions.size
    ]
    return unplaced_change(model, places) if places else None


def datum_of(setup: Setup, axes: tuple[str, ...], settings: Settings) -> Place | None:
    """From where corrections count; None: home."""
    touched = _touched(setup.system, settings)
    if not touched:
        return None
    zero = dict(zip(axes, setup.values, strict=True))
    return f"the datum of {setup.system}", np.array(touched[0].position(axes, zero))[:, np.newaxis]


def _touched(system: str, settings: Settings) -> list[TouchedOff]:
    return [one for one in settings.touched_off if one.system == system]
