"""A figure as SVG inside a page: small, the same bytes each time, in the colours of the page."""

import re
from collections.abc import Callable
from html import escape
from io import StringIO

from matplotlib import style
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

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
