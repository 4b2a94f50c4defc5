"""What was measured, with what and when: the head of the report."""

from collections.abc import Sequence

import numpy as np

from trueaxis.diagnosis.result import FloatArray, MeasuredWith
from trueaxis.diagnosis.rows import Rows, plane_of


def measured_with(rows: Rows) -> tuple[MeasuredWith, ...]:
    """One of each device, in the order of the runs; runs that do not name one are of one device."""
    members: dict[tuple[str, str], list[int]] = {}
    for index in rows.present:
        run = rows.runs[index]
        members.setdefault((run.instrument, run.device.id if run.device else ""), []).append(index)
    return tuple(_of_device(rows, indices) for indices in members.values())


def _of_device(rows: Rows, indices: Sequence[int]) -> MeasuredWith:
    runs = [rows.runs[index] for index in indices]
    mine = np.isin(rows.run, indices)
    device = runs[0].device
    return MeasuredWith(
        instrument=runs[0].instrument,
        device=device.id if device else "",
        serial=device.serial if device else "",
        sessions=tuple(dict.fromkeys(run.session for run in runs if run.session)),
        runs=len(runs),
        readings=int(mine.sum()),
        motions=tuple(dict.fromkeys(plane_of(rows, rows.run == index) for index in indices)),
        time_s=_range(rows.time, mine),
        temperature_c=_range(rows.temperature, mine),
    )


def _range(values: FloatArray | None, mine: np.ndarray) -> tuple[float, float] | None:
    known = np.zeros(0) if values is None else values[mine & np.isfinite(values)]
    return (float(known.min()), float(known.max())) if known.size else None
