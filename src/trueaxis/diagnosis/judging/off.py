"""An instrument that is off, and what else it may be: other effects that make the same of the readings."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.result import FloatArray
from trueaxis.effects.kind import Effect


@dataclass(frozen=True, slots=True, eq=False)
class Instead:
    """An effect that makes the same of the readings; values, u: of its parameters, mm, rad or 1."""

    effect: Effect
    values: FloatArray
    u: FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Off:
    """An instrument that is off in the runs of its effect.

    values, u: of its parameters, mm or 1; signal: (n,), mm; instead: what else it may be.
    """

    effect: Effect
    values: FloatArray
    u: FloatArray
    p_value: float
    signal: FloatArray
    instead: tuple[Instead, ...] = ()


def with_instead(rows: Rows, off: Sequence[Off]) -> tuple[Off, ...]:
    """Each with what may be in its place."""
    return tuple(replace(one, instead=_instead(rows, one)) for one in off)


def _instead(rows: Rows, off: Off) -> tuple[Instead, ...]:
    """A laser that reads short on one line alone may have stood askew; a zero that all runs by the ball bar have may be
    the length of the bar.
    """
    bars = {rows.runs[index].id for index in rows.present if rows.runs[index].instrument == "ballbar"}
    if off.effect.kind == "reading_zero" and set(off.effect.runs) == bars:
        return (Instead(Effect(kind="ballbar_length"), off.values, off.u),)
    mine = [index for index in rows.present if _is_of(rows, index, off.effect)]
    lines = {int(rows.setup[rows.of_run(index)][0]) for index in mine}
    if off.effect.kind == "laser_scale" and len(lines) == 1 and off.values[0] < 0.0:
        angle = np.sqrt(-2.0 * off.values)  # reads short by half its square
        return (Instead(Effect(kind="laser_cosine", runs=_ids(rows, mine)), angle, off.u / angle),)
    return ()


def _is_of(rows: Rows, index: int, effect: Effect) -> bool:
    run = rows.runs[index]
    return run.id in effect.runs if effect.runs else run.instrument == "laser"


def _ids(rows: Rows, runs: Sequence[int]) -> tuple[str, ...]:
    return tuple(rows.runs[index].id for index in runs)
