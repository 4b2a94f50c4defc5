"""Circles of the ball bar: polar, with the extended model over them, and residuals against the polar angle."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trueaxis.diagnosis.result import Diagnosis, FloatArray, Residuals
from trueaxis.reporting.diagnosis.lines import THINNED, Round, rounds_of, sample
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.quantity import NBSP, UM
from trueaxis.reporting.diagnosis.svg import BLUE, INK, ORANGE, RULE, SOFT, cloud, picture, stacked

MOST_POINTS = 360  # of a trace, drawn as a line
SIDE = 3.9  # inches
LEGEND = 0.45
_NOMINAL, _OUTER, _EDGE = 2.4, 3.5, 4.15  # radii of the fitted circle, of the spokes, of the picture, in divisions
_LOOK = {1: (BLUE, "-", "counter-clockwise"), -1: (ORANGE, "--", "clockwise")}
Key = tuple[str, float]
MOST_AROUND = 600
_AROUND_LOOK = {1: ("^", BLUE, BLUE, "counter-clockwise"), -1: ("v", ORANGE, "none", "clockwise")}


def circles(diagnosis: Diagnosis) -> list[Picture]:
    """One picture for each plane and feed, both directions in it, all of one scale; none without circles."""
    residuals = diagnosis.residuals
    groups: dict[Key, list[Round]] = {}
    for one in rounds_of(residuals):
        groups.setdefault((one.plane, round(one.feed, 3) if np.isfinite(one.feed) else -1.0), []).append(one)
    if not groups:
        return []
    largest = max(float(np.abs(_centred(residuals, one)[0]).max()) for all_ in groups.values() for one in all_)
    tick = _round_up(largest)
    return [_picture(residuals, key, groups[key], tick) for key in sorted(groups)]


def _picture(residuals: Residuals, key: Key, rounds: list[Round], tick: float) -> Picture:
    plane, feed = key
    feed_text = f", {feed:g} mm/min" if feed >= 0.0 else ""
    left = [float(1e3 * residuals.extended[one.rows].std()) for one in rounds]
    named = ", ".join(f"{one.run} ({_LOOK[one.turn][2]})" for one in rounds)
    every = max(_stride(one) for one in rounds)
    thinned = f" Of {every} readings one is drawn." if every > 1 else ""
    return picture(
        f"circle-{plane}-{f'{feed:g}'.replace('.', '_').replace('-', 'n')}",
        f"Circle {plane}{feed_text}",
        f"Polar plot of radial deviations in {plane}{feed_text}: {named}, the extended model drawn over them; it "
        f"leaves {max(left):.2g} {UM} RMS at most.",
        f"{named}. Magnified about the fitted circle, the darker one: a division is {tick:g}{NBSP}{UM}.{thinned}",
        lambda: _figure(residuals, rounds, tick),
    )


def _figure(residuals: Residuals, rounds: list[Round], tick: float) -> Figure:
    # plain axes: polar ones take four times as long, and put the labels of the rings under the traces
    figure = Figure(figsize=(SIDE, SIDE + LEGEND))
    panel = figure.add_axes((0.0, LEGEND / (SIDE + LEGEND), 1.0, SIDE / (SIDE + LEGEND)))
    panel.set_axis_off()
    panel.set_xlim(-_EDGE * tick, _EDGE * tick)
    panel.set_ylim(-_EDGE * tick, _EDGE * tick)
    _rings(panel, tick)
    seen: set[int] = set()
    for one in rounds:
        colour, dash, label = _LOOK[one.turn]
        measured, model = _centred(residuals, one)
        theta = residuals.theta[one.rows]
        stride = slice(None, None, _stride(one))
        first = one.turn not in seen
        seen.add(one.turn)
        _trace(panel, theta[stride], measured[stride], tick, linestyle=dash, color=colour, linewidth=2.2, alpha=0.75,
               label=label if first else None)  # fmt: skip
        _trace(panel, theta[stride], model[stride], tick, linestyle=":" if one.turn < 0 else "-", color=INK,
               linewidth=1.1 if one.turn < 0 else 0.7, label=f"model, {label}" if first else None)  # fmt: skip
    figure.legend(loc="lower center", ncols=2)
    return figure


def _stride(one: Round) -> int:
    return max(1, one.rows.size // MOST_POINTS)


def _rings(panel: Axes, tick: float) -> None:
    """The fitted circle, one ring a division inside it and one outside, spokes every 45 deg."""
    around = np.linspace(0.0, 2.0 * np.pi, 121)
    for ring in (-1.0, 0.0, 1.0):
        own = {"color": SOFT, "linewidth": 0.8} if ring == 0.0 else {"color": RULE, "linewidth": 0.5}
        _trace(panel, around, np.full_like(around, ring * tick), tick, **own)
    for degrees in range(0, 360, 45):
        angle = np.radians(degrees)
        x, y = np.cos(angle), np.sin(angle)
        panel.plot([0.0, _OUTER * tick * x], [0.0, _OUTER * tick * y], color=RULE, linewidth=0.35)
        far = (_OUTER + 0.3) * tick
        panel.text(far * x, far * y, f"{degrees}\N{DEGREE SIGN}", ha="center", va="center")
    for ring, told in ((-1.0, f"\N{MINUS SIGN}{tick:g}"), (1.0, f"+{tick:g} {UM}")):
        at, low = (_NOMINAL + ring) * tick, np.radians(22.5)
        side = "left" if ring > 0.0 else "right"
        panel.text(at * np.cos(low), at * np.sin(low), f" {told} ", ha=side, va="center", fontsize=8.0)


def _trace(panel: Axes, theta: FloatArray, radial: FloatArray, tick: float, **look: Any) -> None:
    angles, deviation = _broken(theta, radial)
    radius = _NOMINAL * tick + deviation
    panel.plot(radius * np.cos(angles), radius * np.sin(angles), **look)


def _centred(residuals: Residuals, one: Round) -> tuple[FloatArray, FloatArray]:
    """Readings and what the extended model says, um, both about the centre fitted to the readings (ISO 230-4)."""
    theta = residuals.theta[one.rows]
    design = np.column_stack([np.ones_like(theta), np.cos(theta), np.sin(theta)])
    measured = residuals.reading[one.rows]
    circle = design @ np.linalg.lstsq(design, measured, rcond=None)[0]
    model = measured - residuals.extended[one.rows]
    return 1e3 * (measured - circle), 1e3 * (model - circle)


def _broken(theta: FloatArray, radial: FloatArray) -> tuple[FloatArray, FloatArray]:
    """With a break wherever more than 10 deg are missing."""
    gaps = np.flatnonzero(np.abs(np.angle(np.exp(1j * np.diff(theta)))) > np.radians(10.0)) + 1
    return np.insert(theta, gaps, np.nan), np.insert(radial, gaps, np.nan)


def _round_up(value: float) -> float:
    """The next 1, 2 or 5 times a power of ten."""
    if value <= 0.0:
        return 1.0
    power = 10.0 ** np.floor(np.log10(value))
    return float(next(step * power for step in (1.0, 2.0, 5.0, 10.0) if value <= step * power * (1.0 + 1e-9)))


def around(diagnosis: Diagnosis) -> list[Picture]:
    """One picture for each plane; none without circles."""
    rounds = rounds_of(diagnosis.residuals)
    planes = sorted({one.plane for one in rounds})
    return [
        _around_picture(diagnosis.residuals, plane, [one for one in rounds if one.plane == plane]) for plane in planes
    ]


def _around_picture(residuals: Residuals, plane: str, rounds: list[Round]) -> Picture:
    most = max(sum(one.rows.size for one in rounds if one.turn == turn) for turn in _AROUND_LOOK)
    thinned = f" {THINNED}" if most > MOST_AROUND else ""
    return picture(
        f"around-{plane}",
        f"Residual around {plane} circles",
        f"Residual against polar angle of {len(rounds)} circles in {plane}, refitted above and extended model below.",
        f"{len(rounds)} runs, both panels of one scale; steps at 0, 90, 180 and 270 deg are reversals of an axis."
        f"{thinned}",
        lambda: _around_figure(residuals, rounds),
    )


def _around_figure(residuals: Residuals, rounds: list[Round]) -> Figure:
    figure, panels = stacked(4.0, 2, titled=True, sharey=True)
    for panel, values, title in zip(
        panels, (residuals.refitted, residuals.extended), ("refitted", "extended model"), strict=True
    ):
        panel.axhline(0.0, color=INK, linewidth=0.6)
        for turn, (marker, colour, face, label) in _AROUND_LOOK.items():
            rows = [one.rows for one in rounds if one.turn == turn]
            if not rows:
                continue
            together = np.concatenate(rows)
            theta = np.degrees(residuals.theta[together]) % 360.0
            order = np.argsort(theta, kind="stable")
            theta, left = theta[order], 1e3 * values[together][order]
            kept = sample(left, MOST_AROUND)
            cloud(panel, theta[kept], left[kept], marker, colour, face, 2.4, label)
        panel.set_title(title)
        panel.set_ylabel(UM)
    panels[-1].set_xticks(range(0, 361, 90))
    panels[-1].set_xlabel("polar angle (deg)")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncols=2)
    return figure
