"""Residual of circles against the polar angle, before and after."""

import numpy as np
from matplotlib.figure import Figure

from trueaxis.diagnosis.result import Diagnosis, Residuals
from trueaxis.reporting.diagnosis.cloud import cloud
from trueaxis.reporting.diagnosis.frame import stacked
from trueaxis.reporting.diagnosis.lines import THINNED, Round, rounds_of, sample
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.quantity import UM
from trueaxis.reporting.diagnosis.svg import BLUE, INK, ORANGE, picture

MOST_POINTS = 600
_LOOK = {1: ("^", BLUE, BLUE, "counter-clockwise"), -1: ("v", ORANGE, "none", "clockwise")}


def around(diagnosis: Diagnosis) -> list[Picture]:
    """One picture for each plane; none without circles."""
    rounds = rounds_of(diagnosis.residuals)
    planes = sorted({one.plane for one in rounds})
    return [_picture(diagnosis.residuals, plane, [one for one in rounds if one.plane == plane]) for plane in planes]


def _picture(residuals: Residuals, plane: str, rounds: list[Round]) -> Picture:
    most = max(sum(one.rows.size for one in rounds if one.turn == turn) for turn in _LOOK)
    thinned = f" {THINNED}" if most > MOST_POINTS else ""
    return picture(
        f"around-{plane}",
        f"Residual around {plane} circles",
        f"Residual against polar angle of {len(rounds)} circles in {plane}, refitted above and extended model below.",
        f"{len(rounds)} runs, both panels of one scale; steps at 0, 90, 180 and 270 deg are reversals of an axis."
        f"{thinned}",
        lambda: _figure(residuals, rounds),
    )


def _figure(residuals: Residuals, rounds: list[Round]) -> Figure:
    figure, panels = stacked(4.0, 2, titled=True, sharey=True)
    for panel, values, title in zip(
        panels, (residuals.refitted, residuals.extended), ("refitted", "extended model"), strict=True
    ):
        panel.axhline(0.0, color=INK, linewidth=0.6)
        for turn, (marker, colour, face, label) in _LOOK.items():
            rows = [one.rows for one in rounds if one.turn == turn]
            if not rows:
                continue
            together = np.concatenate(rows)
            theta = np.degrees(residuals.theta[together]) % 360.0
            order = np.argsort(theta, kind="stable")
            theta, left = theta[order], 1e3 * values[together][order]
            kept = sample(left, MOST_POINTS)
            cloud(panel, theta[kept], left[kept], marker, colour, face, 2.4, label)
        panel.set_title(title)
        panel.set_ylabel(UM)
    panels[-1].set_xticks(range(0, 361, 90))
    panels[-1].set_xlabel("polar angle (deg)")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncols=2)
    return figure
