"""A figure as SVG inside a page: small, the same bytes each time, in the colours of the page.

The margins of its panels are given, in inches: to have them measured takes longer than to draw them. Many points are
one path: an element for each, as matplotlib writes markers, is slow to write and slow to scroll.
"""

import re
from collections.abc import Callable
from html import escape
from io import StringIO
from typing import Any

import numpy as np
from matplotlib import style
from matplotlib.axes import Axes
from matplotlib.backend_bases import RendererBase
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.path import Path
from matplotlib.transforms import IdentityTransform

from trueaxis.diagnosis.result import FloatArray
from trueaxis.reporting.diagnosis.picture import Picture

# Of Okabe and Ito: told apart by all eyes. The page gives each its value, light or dark, by a CSS variable.
BLUE, ORANGE, GREEN, SKY, PURPLE = "#0072b2", "#d55e00", "#009e73", "#56b4e9", "#cc79a7"
INK, SOFT, RULE = "#010203", "#040506", "#070809"  # text, lesser text, lines of the axes: stand-ins, never shown

VARIABLES = {
    BLUE: "blue",
    ORANGE: "orange",
    GREEN: "green",
    SKY: "sky",
    PURPLE: "purple",
    INK: "ink",
    SOFT: "soft",
    RULE: "rule",
}
_FONT = "DejaVu Sans"  # ships with matplotlib: the layout is the same everywhere; the page sets its own font

_STYLE = {
    "svg.fonttype": "none",
    "font.family": "sans-serif",
    "font.sans-serif": [_FONT],
    "font.size": 9.0,
    "axes.titlesize": 9.5,
    "axes.titlelocation": "left",
    "axes.titley": 1.0,  # given: else every title measures the axes below it
    "axes.labelsize": 9.0,
    "axes.edgecolor": RULE,
    "axes.linewidth": 0.7,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.unicode_minus": True,
    "axes.formatter.useoffset": False,
    "grid.color": RULE,
    "grid.linewidth": 0.35,
    "text.color": INK,
    "axes.labelcolor": INK,
    "xtick.color": RULE,
    "ytick.color": RULE,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "xtick.labelsize": 8.5,
    "ytick.labelsize": 8.5,
    "legend.frameon": False,
    "legend.fontsize": 8.5,
    "axes.facecolor": "none",
    "figure.facecolor": "none",
    "axes.axisbelow": True,
    "axes.xmargin": 0.03,
    "path.simplify": True,
}
WIDTH = 4.4  # inches, 317 points: on a phone letters keep their size
LEFT = 0.7  # for tick labels of five digits with a sign, and a label
RIGHT = 0.12
BELOW = 0.46  # tick labels and a label
LEGEND = 0.3
TITLE = 0.24
NAME = 0.0084  # of a letter on average, for each point of its size

# corners of a marker of size 1 about its point; a dot is a stroke with round ends and next to no length
SHAPES: dict[str, tuple[tuple[float, float], ...]] = {
    "^": ((0.0, 0.5), (-0.5, -0.5), (0.5, -0.5)),
    "v": ((0.0, -0.5), (0.5, 0.5), (-0.5, 0.5)),
    "s": ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)),
    "D": ((0.0, -0.7), (0.7, 0.0), (0.0, 0.7), (-0.7, 0.0)),
}
DOT = "o"
_SPECK = ((0.0, 0.0), (0.02, 0.0))


def picture(name: str, title: str, alt: str, caption: str, draw: Callable[[], Figure]) -> Picture:
    """Draws in the style of the page, whatever a user's matplotlibrc says."""
    with style.context(["default", {**_STYLE, "svg.hashsalt": name}]):
        buffer = StringIO()
        # not savefig: it draws every figure twice, for a layout that ours does not need
        FigureCanvasSVG(draw()).print_svg(buffer, metadata={"Date": None})  # type: ignore[no-untyped-call]
    return Picture(name=name, title=title, alt=alt, caption=caption, svg=_inline(buffer.getvalue(), name, title, alt))


def _inline(text: str, name: str, title: str, alt: str) -> str:
    """The svg element alone: named, without what other figures of the page would clash with, shortened."""
    body = text[text.index("<svg") :]
    box = re.search(r'viewBox="([^"]*)"', body)
    assert box is not None, "matplotlib writes a viewBox"
    body = body[body.index(">") + 1 : body.rindex("</svg>")]
    body = re.sub(r"<metadata>.*?</metadata>", "", body, flags=re.DOTALL)
    body = re.sub(r'<defs>\s*<style type="text/css">.*?</style>\s*</defs>', "", body, flags=re.DOTALL)  # in the page
    body = re.sub(r"font: ([\d.]+px) '[^;\"]*", r"font-size: \1", body)
    body = re.sub(r" font-family: [^;\"]*;?", "", body)
    body = _styled_once(body)
    body = body.replace("xlink:href", "href")
    body = re.sub(r' transform="rotate\(-0 [^"]*"', "", body)
    body = _shortened(_named(body, name))
    for colour, variable in VARIABLES.items():
        body = body.replace(colour, f"var(--{variable})")
    head = f'<svg viewBox="{box.group(1)}" role="img" aria-labelledby="{name}-title {name}-desc">'
    told = f'<title id="{name}-title">{escape(title)}</title><desc id="{name}-desc">{escape(alt)}</desc>'
    return f"{head}{told}{body}</svg>"


def _styled_once(body: str) -> str:
    """The style of a marker at the marker, where all its uses have the same: thousands of points are drawn so."""
    styles: dict[str, set[str]] = {}
    for marker, look in re.findall(r'<use xlink:href="#([^"]*)"[^>]*? style="([^"]*)"', body):
        styles.setdefault(marker, set()).add(look)
    for marker, looks in styles.items():
        if len(looks) == 1:
            body = re.sub(rf'(<use xlink:href="#{marker}"[^>]*?) style="[^"]*"', r"\1", body)
            body = re.sub(rf'(<path id="{marker}"[^>]*?)(?: style="[^"]*")?/>', rf'\1 style="{min(looks)}"/>', body)
    return body


def _named(body: str, name: str) -> str:
    """Ids that something refers to are the figure's name and a number, the others go."""
    used = dict.fromkeys(re.findall(r'(?:url\(#|href="#)([^)"]+)', body))
    short = {old: f"{name}-{number}" for number, old in enumerate(used)}
    body = re.sub(r' id="([^"]*)"', lambda m: f' id="{short[m.group(1)]}"' if m.group(1) in short else "", body)
    return re.sub(r'(url\(#|href="#)([^)"]+)', lambda m: m.group(1) + short[m.group(2)], body)


def _shortened(body: str) -> str:
    """Two decimals of a point are enough; line breaks, spaces about commands, groups without attributes say nothing."""
    body = re.sub(r"<!--.*?-->", "", body, flags=re.DOTALL)
    body = re.sub(r">\s+<", "><", body).strip()
    parts = re.split("(>[^<]+<)", body)  # every other one is what is read, not a tag
    for at in range(0, len(parts), 2):
        tags = re.sub(r"(?<=\.\d\d)\d+", "", parts[at].replace("\n", " "))
        parts[at] = re.sub(r"(?<=[\dz]) +(?=[MLz] )", "", tags).replace("L ", "L").replace("M ", "M")
    return "".join(parts)


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


class Cloud(Line2D):
    """Points without a line between them; in a legend one marker, as of any line."""

    def draw(self, renderer: RendererBase) -> None:
        """One path of all points."""
        points = self.get_transform().transform(self.get_xydata())
        size = float(renderer.points_to_pixels(self.get_markersize()))  # type: ignore[arg-type]
        context = renderer.new_gc()
        context.set_clip_rectangle(self.axes.bbox if self.axes is not None else None)
        context.set_foreground(self.get_markeredgecolor())
        if self.get_marker() == DOT:
            context.set_linewidth(size)
            context.set_capstyle("round")
            renderer.draw_path(context, one_path(points, _SPECK), IdentityTransform())
        else:
            context.set_linewidth(size * self.get_markeredgewidth() / self.get_markersize())
            face = self.get_markerfacecolor()
            path = one_path(points, size * np.array(SHAPES[str(self.get_marker())]))
            renderer.draw_path(context, path, IdentityTransform(), None if face == "none" else to_rgba(face))
        context.restore()


def one_path(points: FloatArray, corners: Any) -> Path:
    """A polygon with these corners (k, 2) about each of the points (n, 2), closed where there are three and more."""
    codes = [Path.MOVETO, *[Path.LINETO] * (len(corners) - 1)]
    if len(corners) > 2:
        corners, codes = np.concatenate([corners, corners[:1]]), [*codes, Path.CLOSEPOLY]
    around = np.asarray(points)[:, None, :] + np.asarray(corners)[None]
    return Path(around.reshape(-1, 2), np.tile(codes, len(points)))


def cloud(
    panel: Axes, x: FloatArray, y: FloatArray, marker: str, colour: str, face: str, size: float, label: str
) -> None:
    """Points in a panel. marker: DOT or one of SHAPES; face: `none` or a colour, its edge is of the colour."""
    panel.add_line(
        Cloud(
            x,
            y,
            linestyle="",
            marker=marker,
            markeredgecolor=colour,
            markerfacecolor=face,
            markersize=size,
            markeredgewidth=0.5,
            label=label,
        )
    )
    panel.autoscale_view()
