"""The range of positions over which the readings hold a component."""

import numpy as np

from trueaxis.identify.global_fit.design import Design
from trueaxis.measure.reading_model import home_positions


def measured_ranges(design: Design) -> list[tuple[float, float] | None]:
    """Of each component, the lowest and highest position at which a reading, or its zero at home, holds it."""
    plan, observed = design.layout, design.observed
    low, high = np.full(plan.components.size, np.inf), np.full(plan.components.size, -np.inf)
    for rows, piece in design.pieces():
        positions = observed.positions[:, rows]
        home = home_positions(observed.runs[int(observed.run[rows[0]])], plan.machine.axes)
        for place, axis in enumerate(plan.axis):
            held = piece[:, plan.of_component(place)].any(axis=1)
            if held.any():
                at = positions[axis, held] if home is None else np.append(positions[axis, held], home[axis])
                low[place], high[place] = min(low[place], at.min()), max(high[place], at.max())
    return [(float(a), float(b)) if a <= b else None for a, b in zip(low, high, strict=True)]
