"""What is left of the error of the mill of the tutorial: `python -m tests.laser_to_control.left`, in its folder.

The mill that was measured is known: the tip of tool 1 of the program is looked at on it, from the first point of the
program, where the work offset is touched off.
"""

import sys
from pathlib import Path

import numpy as np

import trueaxis as ta
from trueaxis.controllers.linuxcnc_kins import taken_by_module
from trueaxis.model.curves import FloatArray

TIP = np.array([[0.0], [0.0], [-95.0]])


def left(folder: Path) -> dict[str, float]:
    """RMS over the points of the program, mm: as programmed, compensated, as the kinematics module drives."""
    model = ta.load_model(folder / "mill.toml", folder / "generated")
    errors = ta.load_errors(folder / "errors.json", model)
    shop = folder / "shop"
    done = ta.compensate(
        model, errors, shop / "plate.nc", offsets=shop / "offsets.toml", tools=shop / "tools.toml", dialect="fanuc"
    )
    points = np.flatnonzero(np.isfinite(done.programmed).all(axis=0) & np.isfinite(done.compensated).all(axis=0))
    wanted, sent = done.programmed[:, points], done.compensated[:, points]
    known = model.with_values(errors.values)
    true = model.with_values(ta.load_errors(shop / "true_errors.json", model).values)
    driven = wanted - taken_by_module(known, TIP)(wanted, np.zeros(3))

    def off(commanded: FloatArray) -> float:
        error = true.ideal(commanded, TIP) + true.deviation(commanded, TIP) - true.ideal(wanted, TIP)
        error -= error[:, :1]
        return float(np.sqrt((error**2).sum(axis=0).mean()))

    return {"as programmed": off(wanted), "compensated program": off(sent), "LinuxCNC module": off(driven)}


if __name__ == "__main__":
    for name, value in left(Path(*sys.argv[1:2])).items():
        print(f"{name}: {value * 1e3:.1f} um")
