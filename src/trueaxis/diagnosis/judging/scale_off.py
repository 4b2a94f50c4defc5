"""The scale of a laser that was off in one session, as when its air was entered wrongly: by the values given.

Curves of the machine may take up such a scale where lines of an axis stand apart, and what they leave of it looks like
an effect. But where the values given are right beside one scale that is off, and it alone, it is that scale: so this is
asked before anything is searched for.
"""

from dataclasses import replace

import numpy as np
from scipy.special import ndtr

from trueaxis.diagnosis.judging.instruments import FALSE_ALARMS, KINDS
from trueaxis.diagnosis.judging.off import Off
from trueaxis.diagnosis.judging.stale import ALIKE, free_besides, stale_values
from trueaxis.diagnosis.null_model.freedom import freedom_of
from trueaxis.diagnosis.null_model.null import Null, again
from trueaxis.effects.kind import Effect

# p value of the values given from which on they are right beside a scale: of true ones one set of a hundred is not, and
# the scale is then looked for with all else
RIGHT = 1e-2


def less_scale_off(null: Null, noise_um: float | None) -> tuple[Null, tuple[Off, ...]]:
    """The readings without what a scale makes of them that was off in one session or of one device, and that.

    Nothing where there is one scale alone, which new values of the machine would hold as well, where none is farther
    off than its device states or its class is, where the values given are not right beside it, or where another scale
    explains the readings about as well.
    """
    base, count = null.base, null.base.by_chance.shape[1]
    unknowns = base.shared[len(base.shared) - count :]
    scales = [k for k, one in enumerate(unknowns) if KINDS.get(one.kind) == "laser_scale"]
    found: list[tuple[float, Off]] = []  # with the decades of likelihood that each explains
    for k in scales if len(scales) > 1 else ():
        unknown, column = unknowns[k], base.by_chance[:, k]
        others = replace(null, base=replace(base, by_chance=np.delete(base.by_chance, k, axis=1)))
        free = free_besides(others, (), ())
        seen, left = free.rest(null.whitening(column)), free.rest(null.whitening(null.values))
        if (information := float(seen @ seen)) <= 0.0:
            continue
        value, u = float(seen @ left) / information, information**-0.5
        p_value = 2.0 * float(ndtr(-abs(value) / np.hypot(unknown.unknown_class.factor, u))) * len(scales)
        if p_value >= FALSE_ALARMS:
            continue
        changes = stale_values(null, (column,), (), freedom_of(null.rows, null.whitening, null.noise))
        if changes.stale or changes.p_value < RIGHT:
            continue
        runs = tuple(null.rows.runs[index].id for index in unknown.runs if index in null.rows.present)
        size = np.array([unknown.size])
        off = Off(
            effect=Effect(kind="laser_scale", runs=runs),
            values=value * size,
            u=u * size,
            p_value=p_value,
            signal=value * column,
        )
        found.append((0.5 * value**2 * information / float(np.log(10.0)), off))
    if not found:
        return null, ()
    most, off = max(found, key=lambda one: one[0])
    if sum(decades > most - ALIKE for decades, _ in found) > 1:
        return null, ()
    return replace(again(null, off.signal, noise_um), values=null.values - off.signal), (off,)
