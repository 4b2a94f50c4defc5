"""Many points as one path: an element for each, as matplotlib writes markers, is slow to write and slow to scroll."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backend_bases import RendererBase
from matplotlib.colors import to_rgba
from matplotlib.lines import Line2D
from matplotlib.path import Path
from matplotlib.transforms import IdentityTransform

from trueaxis.diagnosis.result import FloatArray

# corners of a marker of size 1 about its point; a dot is a stroke with round ends and next to no length
SHAPES: dict[str, tuple[tuple[float, float], ...]] = {
    "^": ((0.0, 0.5), (-0.5, -0.5), (0.5, -0.5)),
    "v": ((0.0, -0.5), (0.5, 0.5), (-0.5, 0.5)),
    "s": ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)),
    "D": ((0.0, -0.7), (0.7, 0.0), (0.0, 0.7), (-0.7, 0.0)),
}
DOT = "o"
_SPECK = ((0.0, 0.0), (0.02, 0.0))


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
