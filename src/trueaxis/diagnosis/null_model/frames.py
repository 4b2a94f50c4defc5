"""Readings along the bed and along the workpiece that are one measurement: a place has three coordinates, not six."""

from collections import Counter
from collections.abc import Hashable, Sequence

import numpy as np

from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.result import FloatArray
from trueaxis.estimation.runs import measurements
from trueaxis.measurement.reading_model import sensed_directions
from trueaxis.model.model import MachineModel
from trueaxis.view import view_of

NEW = 1e-3  # length of what others leave of a direction, from where on a reading along it says more than they do


def written_once(model: MachineModel, rows: Rows) -> Rows:
    """Without readings along the bed of which those along the workpiece, and others along the bed, say all.

    They hold no other noise: a noise that is estimated would take what cannot differ for noise that is next to none.
    Those along the workpiece stay, since the zero of a run along the bed hides where an axis of the machine is.
    """
    keep = np.ones(rows.size, dtype=bool)
    for runs in _cycles(rows):
        said = [rows.of_run(index) for index in runs if rows.runs[index].frame == "workpiece"]
        spanned = [_along_bed(model, rows, one) for one in said]
        for index in (one for one in runs if rows.runs[one].frame == "bed"):
            mine = rows.of_run(index)
            direction = _along_bed(model, rows, mine)
            new = _left_of(direction, spanned) > NEW
            keep[mine] = new
            spanned.append(np.where(new, direction, 0.0))
    return rows if keep.all() else rows.only(keep)


def _cycles(rows: Rows) -> list[list[int]]:
    """Runs of one measurement in both frames, by index. What is measured twice is two, the first of each direction with
    the first of the others; a run along the bed is of one at whose times the workpiece was read, where there are times.
    """
    timed = measurements(rows.runs, rows.run, rows.positions, rows.time)
    along_workpiece = {timed[index] for index in rows.present if rows.runs[index].frame == "workpiece"}
    seen: Counter[Hashable] = Counter()
    cycles: dict[Hashable, list[int]] = {}
    untimed = measurements(rows.runs, rows.run, rows.positions, None)
    for index in rows.present:
        run = rows.runs[index]
        alike = untimed[index], run.frame, run.direction
        if run.frame == "workpiece" or timed[index] in along_workpiece:
            cycles.setdefault((untimed[index], seen[alike]), []).append(index)
        seen[alike] += 1
    return [runs for runs in cycles.values() if len({rows.runs[index].frame for index in runs}) > 1]


def _along_bed(model: MachineModel, rows: Rows, mine: slice) -> FloatArray:
    """(3, m): the directions that a run senses, as the bed has them."""
    run, positions = rows.runs[int(rows.run[mine.start])], rows.positions[:, mine]
    direction = sensed_directions(model, run, positions)
    if run.frame == "bed":
        return direction
    view = view_of("workpiece", "bed")
    turned = model.view_ideal(view, positions, direction) - model.view_ideal(view, positions, np.zeros((3, 1)))
    return np.asarray(turned)


def _left_of(direction: FloatArray, spanned: Sequence[FloatArray]) -> FloatArray:
    """(m,): length of what is left of directions (3, m) beside those that others sense at the same place."""
    others = np.stack([*spanned, np.zeros_like(direction)], axis=2).transpose(1, 0, 2)  # (m, 3, k)
    axes, strength, _ = np.linalg.svd(others, full_matrices=False)
    axes = axes * (strength > NEW)[:, np.newaxis, :]
    own = direction.T[:, :, np.newaxis]
    return np.asarray(np.linalg.norm(own - axes @ (axes.transpose(0, 2, 1) @ own), axis=(1, 2)))
