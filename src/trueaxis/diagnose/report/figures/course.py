"""Residual against time and against temperature, before and after."""

import numpy as np
from matplotlib.figure import Figure

from trueaxis.diagnose.report.frame import stacked
from trueaxis.diagnose.report.lines import sample
from trueaxis.diagnose.report.quantity import UM
from trueaxis.diagnose.report.svg import BLUE, GREEN, INK, ORANGE, Picture, picture
from trueaxis.diagnose.result import Diagnosis, FloatArray, Residuals

MOST_POINTS = 600
_LOOK = {
    "laser": ("o", BLUE, BLUE),
    "ballbar": ("s", ORANGE, "none"),
    "probe": ("D", GREEN, "none"),
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
        round(float(np.corrcoef(across[known], values[known])[0, 1]), 2) + 0.0 if np.ptp(values[known]) > 0.0 else 0.0
        for values in (residuals.refitted, residuals.extended)
    ]
    return picture(
        f"course-{name}",
        f"Residual against {name}",
        f"Residual against {name}, refitted above and extended model below; correlation {correlated[0]:.2f} before, "
        f"{correlated[1]:.2f} after.",
        f"Correlation with {name}: {correlated[0]:.2f} refitted, {correlated[1]:.2f} with the extended model.",
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
                panel.plot(
                    across[rows],
                    1e3 * values[rows],
                    marker,
                    color=colour,
                    markerfacecolor=face,
                    markersize=2.2,
                    markeredgewidth=0.5,
                    label=name,
                )
        panel.set_title(title)
        panel.set_ylabel(UM)
    panels[-1].set_xlabel(label)
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncols=3)
    return figure
