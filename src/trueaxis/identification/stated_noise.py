"""Whether a noise that is stated is that of the readings, and what to do where it is not."""

from collections.abc import Mapping, Sequence

import numpy as np

from trueaxis.estimation.observations import Observations
from trueaxis.identification.fit_quality import MISFIT, RunResidual
from trueaxis.measurement.instrument_kinds import small_unit

OPTION, DEVICE = "--noise-{unit} states", "noise_{unit} of the device table (setup.toml) states"


def noise_remedies(
    observed: Observations, stated: Mapping[int, float], each: Sequence[RunResidual], *, by_device: bool
) -> dict[str, float]:
    """A sentence for each instrument whose residuals are far from its stated noise, and their ratio.

    stated: of runs by index, mm; each: residuals of every run over that noise; by_device: whether the device table says
    it, else the option. The middle run decides: of noise that is wrong all runs are off, of a faulty run that one.
    """
    ratio = {one.run: one.ratio for one in each if one.ratio is not None}
    found = {}
    for instrument in dict.fromkeys(observed.runs[index].instrument for index in stated):
        runs = [index for index in stated if observed.runs[index].instrument == instrument]
        known = [ratio[observed.runs[index].id] for index in runs if observed.runs[index].id in ratio]
        middle = float(np.median(known)) if known else 1.0
        if 1.0 / MISFIT <= middle <= MISFIT:
            continue
        unit, small = small_unit(instrument), 1e3 * float(np.median([stated[index] for index in runs]))
        times = f"{middle:.2g} times" if middle > 1.0 else f"1/{1.0 / middle:.2g} of"
        found[
            f"the residuals of {instrument} are {times} the noise that "
            f"{(DEVICE if by_device else OPTION).format(unit=unit)} ({small:.3g} {unit}): leave it out and the noise "
            f"is estimated, or state about {small * middle:.2g} {unit}"
        ] = middle
    return found
