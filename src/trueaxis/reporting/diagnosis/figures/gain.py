"""What causes explain: RMS before and after, beside the noise floor, and the amplitude of a cause in each run.

Before is given and refitted, after is extended; held out and of all readings.
"""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trueaxis.diagnosis.result import Cause, Diagnosis, Gain, GainOfAngles, Stage
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.quantity import COVERAGE_FACTOR, UM, URAD, equals_p, micrometres, shown_in
from trueaxis.reporting.diagnosis.svg import BLUE, INK, ORANGE, SKY, SOFT, picture, room_for, stacked
from trueaxis.reporting.diagnosis.words import effect_title

NAMES = ("given", "refitted", "extended")
_ROWS = ("before: given", "before: refitted", "after: extended", "noise floor")
_LOOK = (SKY, ORANGE, BLUE, SOFT)
MOST_GROUPS = 40
LONGEST = 26


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
        lambda: _stages_figure(gain, unit),
    )


def _stages_figure(gain: Gain | GainOfAngles, unit: str) -> Figure:
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


def amplitudes(cause: Cause, number: int) -> list[Picture]:
    """The plot of one cause; none where fewer than two groups show it."""
    shown = [one for one in cause.amplitudes if np.isfinite(one.value) and np.isfinite(one.u)]
    if len(shown) < 2 or not cause.parameters:
        return []
    first = cause.parameters[0]
    agree = equals_p(cause.homogeneous_p)
    left_out = f" The first {MOST_GROUPS} of {len(shown)}." if len(shown) > MOST_GROUPS else ""
    return [
        picture(
            f"amplitude-{number}",
            f"{first.name} by run",
            f"Forest plot of {first.name} of {effect_title(cause.effect)} in {len(shown)} groups of readings, each "
            f"with its expanded uncertainty; one common value: {agree}.",
            f"Each group alone, bars U (k = {COVERAGE_FACTOR:g}); band: all together. One common value: "
            f"{agree}.{left_out}",
            lambda: _forest(cause),
        )
    ]


def _forest(cause: Cause) -> Figure:
    shown = [one for one in cause.amplitudes if np.isfinite(one.value) and np.isfinite(one.u)][:MOST_GROUPS]
    first = cause.parameters[0]
    factor, unit = shown_in(max(abs(first.value), COVERAGE_FACTOR * np.nan_to_num(first.u)), first.unit)
    names = [_short(one.group) for one in shown]
    figure, (panel,) = stacked(0.55 + 0.21 * len(shown), left=room_for(names), above=0.05)
    at = np.arange(len(shown))
    value = factor * np.array([one.value for one in shown])
    expanded = COVERAGE_FACTOR * factor * np.array([one.u for one in shown])
    if np.isfinite(first.u):
        half = COVERAGE_FACTOR * first.u
        panel.axvspan(factor * (first.value - half), factor * (first.value + half), color=ORANGE, alpha=0.25, lw=0)
    panel.axvline(factor * first.value, color=ORANGE, linewidth=1.0)
    panel.axvline(0.0, color=INK, linewidth=0.7)
    panel.errorbar(value, at, xerr=expanded, fmt="s", color=BLUE, markersize=3.5, linewidth=1.0, capsize=2.0)
    panel.set_yticks(at, names)
    panel.set_ylim(len(shown) - 0.4, -0.6)
    panel.tick_params(axis="y", length=0)
    panel.grid(visible=False, axis="y")
    panel.set_xlabel(f"{first.name} ({unit})" if unit else first.name)
    return figure


def _short(text: str) -> str:
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 1]}\N{HORIZONTAL ELLIPSIS}"
