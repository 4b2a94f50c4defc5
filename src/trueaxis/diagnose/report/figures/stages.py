"""RMS and held-out RMS, given, refitted and extended, beside the noise floor."""

import numpy as np
from matplotlib.figure import Figure

from trueaxis.diagnose.report.frame import room_for, stacked
from trueaxis.diagnose.report.quantity import UM, micrometres
from trueaxis.diagnose.report.svg import BLUE, INK, ORANGE, Picture, picture
from trueaxis.diagnose.result import Diagnosis, Stage

NAMES = ("given", "refitted", "extended")


def stages(diagnosis: Diagnosis) -> list[Picture]:
    """One picture of bars."""
    gain = diagnosis.gain
    told = "; ".join(
        f"{name} {micrometres(getattr(gain.rms, name))} {UM}, held out {micrometres(getattr(gain.held_out, name))} {UM}"
        for name in NAMES
    )
    return [
        picture(
            "stages",
            "What is left, before and after",
            f"Bars of RMS. {told}. Noise floor {micrometres(gain.floor)} {UM}.",
            f"Held out: {gain.split}. Dashed: noise floor, {micrometres(gain.floor)} {UM}.",
            lambda: _figure(diagnosis),
        )
    ]


def _figure(diagnosis: Diagnosis) -> Figure:
    gain = diagnosis.gain
    figure, (panel,) = stacked(2.6, left=room_for(list(NAMES)))
    at = np.arange(len(NAMES))
    for stage, shift, colour, hatch, label in (
        (gain.rms, -0.19, BLUE, "", "all readings kept"),
        (gain.held_out, 0.19, ORANGE, "////", "held out"),
    ):
        values = _values(stage)
        face = "none" if hatch else colour
        panel.barh(at + shift, np.nan_to_num(values), 0.34, color=face, edgecolor=colour, hatch=hatch, label=label)
        for y, value in zip(at + shift, values, strict=True):
            panel.annotate(
                micrometres(1e-3 * value) if np.isfinite(value) else "none",
                (np.nan_to_num(value), y),
                xytext=(3, 0),
                textcoords="offset points",
                va="center",
                fontsize=8,
            )
    if np.isfinite(gain.floor):
        panel.axvline(1e3 * gain.floor, color=INK, linewidth=1.0, linestyle="--", label="noise floor")
    panel.set_yticks(at, NAMES)
    panel.set_ylim(len(NAMES) - 0.5, -0.5)
    panel.set_xlim(0.0, 1.18 * max(1e-6, float(np.nanmax([*_values(gain.rms), *_values(gain.held_out), 0.0]))))
    panel.tick_params(axis="y", length=0)
    panel.grid(visible=False, axis="y")
    panel.set_xlabel(f"RMS ({UM})")
    figure.legend(loc="upper center", ncols=3)
    return figure


def _values(stage: Stage) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    return 1e3 * np.array([stage.given, stage.refitted, stage.extended])
