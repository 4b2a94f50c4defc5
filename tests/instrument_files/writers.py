"""Instrument files written from readings, as the instruments' own programs write them."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]


def rtl(
    targets: Sequence[float], deviations_um: FloatArray, *, axis: str = "", machine: str = "Mill", digits: int = 6
) -> str:
    """deviations_um: (runs, targets), of a .rta angles, in the order of the targets; every second run goes back over
    them."""
    runs, count = deviations_um.shape
    lines = ["HEADER::", "File type : LASER", "Owner : ", "Version no : 1.0", "", "TARGET DATA::", "Filetype: L"]
    lines += [f"Target-count: {count}", "Targets :"]
    lines += ["  ".join(f"{value:.6f}" for value in targets[at : at + 5]) for at in range(0, count, 5)]
    lines += ["Flags: 0 0 2 0", "", "USER-TEXT::", f"Machine: {machine}", "Serial No: 4711", "Date:12:30 Jan 02 2024"]
    lines += ["By: ", f"Axis: {axis}", "Location: ", "TITLE: ", "", "RUNS::", f"Run-count:{runs}", "", "DEVIATIONS::"]
    lines.append("Run Target Data:")
    for run in range(runs):
        order = range(count) if run % 2 == 0 else reversed(range(count))
        lines += [f"   {run + 1}   {target + 1}      {deviations_um[run, target]:.{digits}f}" for target in order]
    return "\r\n".join([*lines, "", "ENVIRONMENT::", "Air temp   : 20.0", "", "EOF::", ""])
