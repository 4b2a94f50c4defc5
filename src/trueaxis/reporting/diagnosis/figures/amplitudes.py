"""Amplitude of a cause as each run shows it: a forest plot."""

import numpy as np
from matplotlib.figure import Figure

from trueaxis.diagnosis.result import Cause
from trueaxis.reporting.diagnosis.frame import room_for, stacked
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.quantity import COVERAGE_FACTOR, equals_p, shown_in
from trueaxis.reporting.diagnosis.svg import BLUE, INK, ORANGE, picture
from trueaxis.reporting.diagnosis.words import effect_title

MOST_GROUPS = 40
LONGEST = 26


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
            lambda: _figure(cause),
        )
    ]


def _figure(cause: Cause) -> Figure:
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
