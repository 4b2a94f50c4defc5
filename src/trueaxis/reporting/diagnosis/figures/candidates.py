"""Evidence of the candidates beside the threshold, and which of them look alike.

Alike is by R^2 of what the base leaves of their signatures.
"""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter
from scipy.optimize import isotonic_regression

from trueaxis.diagnosis.result import Diagnosis, FloatArray
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.svg import BLUE, INK, ORANGE, RULE, SKY, WIDTH, picture, room_for, stacked
from trueaxis.reporting.diagnosis.words import effect_title, short_title

MOST_BARS = 24
CONFOUNDED = 0.95
MOST_NAMES = 26  # beyond, kinds are named instead of candidates
LINE = 0.13  # inches, from one name of a kind to the next
LONGEST = 22
SIZE = 7.5  # points
CROOKED = 0.22  # inches, from a name to its rows
BELOW = 0.28


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
            lambda: _bars(diagnosis),
        )
    ]


def _bars(diagnosis: Diagnosis) -> Figure:
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


def isolability(diagnosis: Diagnosis) -> list[Picture]:
    """The heat map; none for fewer than two candidates."""
    count = len(diagnosis.isolability)
    if count < 2:
        return []
    above = np.triu(np.nan_to_num(diagnosis.correlation), 1) >= CONFOUNDED
    pairs = [(int(i), int(j)) for i, j in np.argwhere(above)]
    named = [
        f"{effect_title(diagnosis.isolability[i])} and {effect_title(diagnosis.isolability[j])}" for i, j in pairs[:5]
    ]
    more = f" and {len(pairs) - 5} more pairs" if len(pairs) > 5 else ""
    told = f"Confounded: {'; '.join(named)}{more}." if pairs else "No pair is confounded."
    many = count > MOST_NAMES
    mark = "orange:" if many else "crosses:"
    grouped = " Candidates of a kind stand together, in brackets how many." if many else ""
    return [
        picture(
            "isolability",
            "Isolability",
            f"Heat map of R squared between {count} candidates. {told}",
            f"R\N{SUPERSCRIPT TWO} between the signatures of candidates, before any reading; {mark} "
            f"pairs from {CONFOUNDED:g} on, which these runs cannot distinguish. {told}{grouped}",
            lambda: _matrix(diagnosis),
        )
    ]


def _matrix(diagnosis: Diagnosis) -> Figure:
    effects = diagnosis.isolability
    count = len(effects)
    kinds = list(dict.fromkeys(one.kind for one in effects))
    order = sorted(range(count), key=lambda k: kinds.index(effects[k].kind)) if count > MOST_NAMES else range(count)
    r2 = np.clip(np.nan_to_num(diagnosis.correlation), 0.0, 1.0)[np.ix_(order, order)]
    groups = [(kind, sum(one.kind == kind for one in effects)) for kind in kinds]
    names = [f"{short_title(e)}  {k + 1}" for k, e in enumerate(effects)]
    if count > MOST_NAMES:
        names = [_told(*one) for one in groups]
    size = SIZE if count > MOST_NAMES else 7.0 if count > 15 else 8.0
    left = room_for(names, size) + (CROOKED if count > MOST_NAMES else 0.0)
    side = WIDTH - left - 0.05
    tall = max(side, LINE * len(groups)) if count > MOST_NAMES else side
    figure = Figure(figsize=(WIDTH, tall + BELOW))
    panel = figure.add_axes(
        (left / WIDTH, (0.5 * (tall - side) + BELOW) / (tall + BELOW), side / WIDTH, side / (tall + BELOW))
    )
    panel.imshow(_cells(r2), interpolation="none", aspect="equal")
    if count <= MOST_NAMES:
        rows, columns = np.nonzero((r2 >= CONFOUNDED) & ~np.eye(count, dtype=bool))
        panel.plot(columns, rows, "x", color=INK, markersize=min(5.0, 140.0 / count), markeredgewidth=0.7, linestyle="")
        panel.set_yticks(range(count), names)
        panel.set_xticks(range(count), [str(k + 1) for k in range(count)])
        panel.tick_params(labelsize=size)
    else:
        _name_groups(panel, groups, names, LINE / side * count)
    panel.tick_params(length=0)
    panel.grid(visible=False)
    for edge in ("top", "right"):
        panel.spines[edge].set_visible(True)
    return figure


def _told(kind: str, count: int) -> str:
    words = kind.replace("_", " ")
    cut = words if len(words) <= LONGEST else f"{words[: LONGEST - 1]}\N{HORIZONTAL ELLIPSIS}"
    return f"{cut} ({count})"


def _name_groups(panel: Axes, groups: list[tuple[str, int]], names: list[str], line: float) -> None:
    """Lines between the kinds, and their names on the left, moved apart where the kinds are narrow. line: height of
    a name in cells.
    """
    edges = np.cumsum([0, *(size for _, size in groups)]) - 0.5
    middles = 0.5 * (edges[1:] + edges[:-1])
    for edge in edges[1:-1]:
        panel.axhline(edge, color=RULE, linewidth=0.4)
        panel.axvline(edge, color=RULE, linewidth=0.4)
    panel.set_xticks([])
    panel.set_yticks([])
    whole = edges[-1] - edges[0]
    crook = CROOKED / LINE * line
    for name, middle, at in zip(names, middles, spread(middles, line, float(edges[0]), float(edges[-1])), strict=True):
        panel.plot([-0.5, -0.5 - 0.3 * crook, -0.5 - 0.8 * crook, -0.5 - crook], [middle, middle, at, at], color=RULE,
                   linewidth=0.5, clip_on=False)  # fmt: skip
        panel.text(-0.5 - 1.15 * crook, at, name, ha="right", va="center", fontsize=SIZE)
    panel.set_xlim(-0.5, whole - 0.5)
    panel.set_ylim(whole - 0.5, -0.5)


def spread(wanted: FloatArray, apart: float, low: float, high: float) -> FloatArray:
    """Places near those wanted (ascending), at least so far apart, between the bounds if there is room, as a whole as
    near as may be: least squares under order, by pooling neighbours that collide.
    """
    steps = apart * np.arange(wanted.size)
    slack = high - low - apart * (wanted.size - 1)
    first = low + 0.5 * min(slack, 0.0)
    placed: FloatArray = np.clip(isotonic_regression(wanted - steps).x, first, first + max(slack, 0.0)) + steps
    return placed


def _cells(r2: FloatArray) -> FloatArray:
    """(g, g, 4): colour as opacity, so that it works on light and on dark; confounded pairs in another colour."""
    red_green_blue = {colour: [int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)] for colour in (BLUE, ORANGE)}
    cells = np.empty((*r2.shape, 4))
    cells[..., :3] = np.where((r2 >= CONFOUNDED)[..., None], red_green_blue[ORANGE], red_green_blue[BLUE])
    cells[..., 3] = 0.9 * r2
    cells[np.diag_indices(len(r2))] = [0.5, 0.5, 0.5, 0.35]
    return cells
