"""Evidence of the candidates beside the threshold."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from trueaxis.diagnosis.result import Diagnosis
from trueaxis.reporting.diagnosis.frame import room_for, stacked
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.svg import BLUE, INK, ORANGE, SKY, picture
from trueaxis.reporting.diagnosis.words import short_title

MOST_BARS = 24


def evidence(diagnosis: Diagnosis) -> list[Picture]:
    """The candidates of the scan, the strongest first; none where nothing was scanned."""
    if not diagnosis.scan:
        return []
    ranked = sorted(diagnosis.scan, key=lambda one: -_number(one.evidence))
    over = sum(_number(one.evidence) >= diagnosis.threshold for one in ranked)
    more = len(ranked) - MOST_BARS
    rest = f" {more} more lie below these." if more > 0 else ""
    best = f"{short_title(ranked[0].effect)} leads with {_number(ranked[0].evidence):.3g}."
    return [
        picture(
            "evidence",
            "Evidence of the candidates",
            f"Bars of evidence of {len(ranked)} candidates, threshold {diagnosis.threshold:.3g}; "
            f"{over} reach it. {best}",
            f"Evidence = \N{MINUS SIGN}log10(p \N{MULTIPLICATION SIGN} tries); {over} of {len(ranked)} candidates "
            f"reach the threshold of {diagnosis.threshold:.3g} on their own.{rest}",
            lambda: _figure(diagnosis),
        )
    ]


def _figure(diagnosis: Diagnosis) -> Figure:
    ranked = sorted(diagnosis.scan, key=lambda one: -_number(one.evidence))[:MOST_BARS]
    named = {one.effect for one in diagnosis.causes}
    rivals = {rival.effect for one in diagnosis.causes for rival in one.rivals}
    names = [short_title(one.effect) for one in ranked]
    figure, (panel,) = stacked(0.8 + 0.19 * len(ranked), left=room_for(names))
    at = np.arange(len(ranked))
    values = np.array([max(_number(one.evidence), 0.0) for one in ranked])
    groups = (
        ("named", ORANGE, "", [one.effect in named for one in ranked]),
        ("rival", SKY, "////", [one.effect in rivals - named for one in ranked]),
        ("other", BLUE, "", [one.effect not in named | rivals for one in ranked]),
    )
    for label, colour, hatch, chosen in groups:
        if any(chosen):
            face = "none" if hatch else colour
            panel.barh(
                at[chosen], values[chosen], 0.66, color=face, edgecolor=colour, hatch=hatch, linewidth=0.8, label=label
            )
    panel.axvline(diagnosis.threshold, color=INK, linewidth=1.0, linestyle="--", label="threshold")
    if values.max() > 20.0 * diagnosis.threshold:
        panel.set_xscale("symlog", linthresh=diagnosis.threshold)
        panel.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    panel.set_xlim(left=0.0)
    panel.set_yticks(at, names)
    panel.set_ylim(len(ranked) - 0.5, -0.5)
    panel.tick_params(axis="y", length=0)
    panel.grid(visible=False, axis="y")
    panel.set_xlabel("evidence")
    figure.legend(loc="upper right", ncols=4)
    return figure


def _number(value: float) -> float:
    """Evidence of a p-value that underflowed is as large as can be drawn; NaN is none."""
    return float(np.nan_to_num(value, nan=0.0, posinf=330.0, neginf=0.0))
