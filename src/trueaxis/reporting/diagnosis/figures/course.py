"""Residual against time and against temperature, before and after."""

import numpy as np
from matplotlib.figure import Figure

from trueaxis.diagnosis.result import Diagnosis, FloatArray, Residuals
from trueaxis.reporting.diagnosis.cloud import cloud
from trueaxis.reporting.diagnosis.frame import stacked
from trueaxis.reporting.diagnosis.lines import THINNED, sample
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.quantity import UM, written
from trueaxis.reporting.diagnosis.svg import BLUE, GREEN, INK, ORANGE, picture

MOST_POINTS = 600
_LOOK = {
    "laser": ("o", BLUE, BLUE),
    "ballbar": ("s", ORANGE, "none"),
    "probe": ("D", GREEN, "none"),
    "angle": ("^", ORANGE, ORANGE),
    "displacement": ("v", GREEN, GREEN),
}


def course(diagnosis: Diagnosis) -> list[Picture]:
    """A picture for the time and one for the temperature, where the readings have them."""
    residuals = diagnosis.residuals
    found = []
    if _varies(residuals.time):
        assert residuals.time is not None
        factor, unit = (1.0 / 60.0, "min") if np.nanmax(residuals.time) < 7200.0 else (1.0 / 3600.0, "h")
        found.append(_picture(residuals, "time", factor * residuals.time, f"time ({unit})"))
    if _varies(residuals.temperature):
        assert residuals.temperature is not None
        found.append(_picture(residuals, "temperature", residuals.temperature, "temperature (\N{DEGREE SIGN}C)"))
    return found


def _varies(values: FloatArray | None) -> bool:
    if values is None:
        return False
    known = values[np.isfinite(values)]
    return known.size > 1 and bool(np.ptp(known) > 0.0)


def _picture(residuals: Residuals, name: str, across: FloatArray, label: str) -> Picture:
    known = np.isfinite(across)
    correlated = [
        written(float(np.corrcoef(across[known], values[known])[0, 1]) if np.ptp(values[known]) > 0.0 else 0.0, ".2f")
        for values in (residuals.refitted, residuals.extended)
    ]
    drawn = np.bincount(residuals.run[known], minlength=len(residuals.runs))
    most = max(int(drawn[np.array(residuals.instruments) == name].sum()) for name in _LOOK)
    thinned = f" {THINNED}" if most > MOST_POINTS else ""
    return picture(
        f"course-{name}",
        f"Residual against {name}",
        f"Residual against {name}, refitted above and extended model below; correlation {correlated[0]} before, "
        f"{correlated[1]} after.",
        f"Correlation with {name}: {correlated[0]} refitted, {correlated[1]} with the extended model.{thinned}",
        lambda: _figure(residuals, across, label),
    )


def _figure(residuals: Residuals, across: FloatArray, label: str) -> Figure:
    figure, panels = stacked(4.0, 2, titled=True, sharey=True)
    instrument = np.array(residuals.instruments)[residuals.run]
    for panel, values, title in zip(
        panels, (residuals.refitted, residuals.extended), ("refitted", "extended model"), strict=True
    ):
        panel.axhline(0.0, color=INK, linewidth=0.6)
        for name, (marker, colour, face) in _LOOK.items():
            rows = np.flatnonzero((instrument == name) & np.isfinite(across))
            rows = rows[np.argsort(across[rows], kind="stable")]
            rows = rows[sample(values[rows], MOST_POINTS)]
            if rows.size:
                cloud(panel, across[rows], 1e3 * values[rows], marker, colour, face, 2.2, name)
        panel.set_title(title)
        panel.set_ylabel(UM)
    panels[-1].set_xlabel(label)
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncols=3)
    return figure
