"""RMS before (given, refitted) and after (extended), held out and of all readings, beside the noise floor."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trueaxis.diagnosis.result import Diagnosis, Gain, GainOfAngles, Stage
from trueaxis.reporting.diagnosis.frame import room_for, stacked
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.quantity import UM, URAD, micrometres
from trueaxis.reporting.diagnosis.svg import BLUE, INK, ORANGE, SKY, SOFT, picture

NAMES = ("given", "refitted", "extended")
_ROWS = ("before: given", "before: refitted", "after: extended", "noise floor")
_LOOK = (SKY, ORANGE, BLUE, SOFT)


def stages(diagnosis: Diagnosis) -> list[Picture]:
    """A picture of bars of lengths, and one of angles."""
    gain, found = diagnosis.gain, []
    if np.isfinite(gain.floor) or gain.angles is None:
        found.append(_stages(gain, gain.split, "stages", "What is left, before and after", UM))
    if gain.angles is not None:
        title = "What is left of angles, before and after"
        found.append(_stages(gain.angles, gain.split, "stages-of-angles", title, URAD))
    return found


def _stages(gain: Gain | GainOfAngles, split: str, name: str, title: str, unit: str) -> Picture:
    told = "; ".join(
        f"{stage} {micrometres(getattr(gain.rms, stage))} {unit}, "
        f"held out {micrometres(getattr(gain.held_out, stage))} {unit}"
        for stage in NAMES
    )
    return picture(
        name,
        title,
        f"Bars of RMS. {told}. Noise floor {micrometres(gain.floor)} {unit}.",
        f"Held out: {split}; the model was fitted without them. Dashed: the noise floor.",
        lambda: _figure(gain, unit),
    )


def _figure(gain: Gain | GainOfAngles, unit: str) -> Figure:
    figure, panels = stacked(3.1, 2, left=room_for(list(_ROWS)), above=0.02, titled=True)
    for panel, stage, title in zip(panels, (gain.held_out, gain.rms), ("held out", "all readings kept"), strict=True):
        _bars(panel, stage, gain.floor)
        panel.set_title(title)
    largest = np.nanmax([*_values(gain.rms, gain.floor), *_values(gain.held_out, gain.floor), 0.0])
    panels[-1].set_xlim(0.0, 1.18 * max(1e-6, float(largest)))
    panels[-1].set_xlabel(f"RMS ({unit})")
    return figure


def _bars(panel: Axes, stage: Stage, floor: float) -> None:
    at = np.arange(len(_ROWS))
    values = _values(stage, floor)
    panel.barh(at, np.nan_to_num(values), 0.72, color=_LOOK)
    for y, value in zip(at, values, strict=True):
        panel.annotate(
            micrometres(1e-3 * value) if np.isfinite(value) else "none",
            (np.nan_to_num(value), y),
            xytext=(3, 0),
            textcoords="offset points",
            va="center",
            fontsize=8,
        )
    if np.isfinite(floor):
        panel.axvline(1e3 * floor, color=INK, linewidth=1.0, linestyle="--")
    panel.set_yticks(at, _ROWS)
    panel.set_ylim(len(_ROWS) - 0.5, -0.5)
    panel.tick_params(axis="y", length=0)
    panel.grid(visible=False, axis="y")


def _values(stage: Stage, floor: float) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    return 1e3 * np.array([stage.given, stage.refitted, stage.extended, floor])
