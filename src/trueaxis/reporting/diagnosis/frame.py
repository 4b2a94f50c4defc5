"""The panels of a figure. Their margins are given, in inches: to have them measured takes longer than to draw them."""

from matplotlib.axes import Axes
from matplotlib.figure import Figure

WIDTH = 4.4  # inches, 317 points: on a phone letters keep their size
LEFT = 0.7  # for tick labels of five digits with a sign, and a label
RIGHT = 0.12
BELOW = 0.46  # tick labels and a label
LEGEND = 0.3
TITLE = 0.24
NAME = 0.0084  # of a letter on average, for each point of its size


def stacked(
    height: float,
    count: int = 1,
    *,
    left: float = LEFT,
    right: float = RIGHT,
    above: float = LEGEND,
    titled: bool = False,
    sharey: bool = False,
) -> tuple[Figure, list[Axes]]:
    """Panels one above the other in a figure of this height, over one x axis; above: what the legend takes;
    titled: whether each has a title.
    """
    figure = Figure(figsize=(WIDTH, height))
    gap = 0.14 + (TITLE if titled else 0.0)
    each = (height - above - BELOW - (TITLE if titled else 0.0) - (count - 1) * gap) / count
    panels = figure.subplots(
        count,
        1,
        sharex=True,
        sharey=sharey,
        squeeze=False,
        gridspec_kw={
            "left": left / WIDTH,
            "right": 1.0 - right / WIDTH,
            "bottom": BELOW / height,
            "top": 1.0 - (above + (TITLE if titled else 0.0)) / height,
            "hspace": gap / each,
        },
    )
    return figure, list(panels[:, 0])


def room_for(names: list[str], size: float = 8.5) -> float:
    """Inches on the left for tick labels that are names, of this size in points."""
    return 0.16 + NAME * size * max((len(name) for name in names), default=0)
