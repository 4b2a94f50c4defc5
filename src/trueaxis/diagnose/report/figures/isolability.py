"""Which candidates look alike: R^2 of what the base leaves of their signatures."""

import numpy as np
from matplotlib.figure import Figure

from trueaxis.diagnose.report.frame import WIDTH
from trueaxis.diagnose.report.svg import BLUE, INK, ORANGE, Picture, picture
from trueaxis.diagnose.report.words import effect_title, short_title
from trueaxis.diagnose.result import Diagnosis, FloatArray

CONFOUNDED = 0.95
MOST_NAMES = 26  # beyond, the axes carry the numbers of the table


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
    return [
        picture(
            "isolability",
            "Isolability",
            f"Heat map of R squared between {count} candidates. {told}",
            f"R\N{SUPERSCRIPT TWO} between the signatures of candidates, before any reading is looked at; a cross "
            f"marks pairs from {CONFOUNDED:g}, which these runs cannot tell apart. {told}"
            + ("" if count <= MOST_NAMES else " Numbers are those of the table of limits."),
            lambda: _figure(diagnosis),
        )
    ]


def _figure(diagnosis: Diagnosis) -> Figure:
    count = len(diagnosis.isolability)
    r2 = np.clip(np.nan_to_num(diagnosis.correlation), 0.0, 1.0)
    figure = Figure(figsize=(WIDTH, WIDTH if count > MOST_NAMES else 1.6 + 0.165 * count), layout="compressed")
    panel = figure.add_subplot()
    panel.imshow(_cells(r2), interpolation="none", aspect="equal")
    rows, columns = np.nonzero((r2 >= CONFOUNDED) & ~np.eye(count, dtype=bool))
    panel.plot(
        columns, rows, "x", color=INK, markersize=max(1.5, min(5.0, 140.0 / count)), markeredgewidth=0.7, linestyle=""
    )
    if count <= MOST_NAMES:
        panel.set_yticks(range(count), [f"{short_title(e)}  {k + 1}" for k, e in enumerate(diagnosis.isolability)])
        panel.set_xticks(range(count), [str(k + 1) for k in range(count)])
        panel.tick_params(labelsize=7.0 if count > 15 else 8.0)
    else:
        ticks = list(range(9, count, 10))
        panel.set_yticks(ticks, [str(k + 1) for k in ticks])
        panel.set_xticks(ticks, [str(k + 1) for k in ticks])
    panel.tick_params(length=0)
    panel.grid(visible=False)
    for side in ("top", "right"):
        panel.spines[side].set_visible(True)
    return figure


def _cells(r2: FloatArray) -> FloatArray:
    """(g, g, 4): colour as opacity, so that it works on light and on dark; confounded pairs in another colour."""
    red_green_blue = {colour: [int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)] for colour in (BLUE, ORANGE)}
    cells = np.empty((*r2.shape, 4))
    cells[..., :3] = np.where((r2 >= CONFOUNDED)[..., None], red_green_blue[ORANGE], red_green_blue[BLUE])
    cells[..., 3] = 0.9 * r2
    cells[np.diag_indices(len(r2))] = [0.5, 0.5, 0.5, 0.35]
    return cells
