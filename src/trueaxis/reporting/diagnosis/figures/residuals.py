"""Residuals before and after: against position, of every axis along which lines were measured, time and temperature.

Are the whitened ones white and normal? Their quantiles and their autocorrelation.
"""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from scipy.special import ndtri

from trueaxis.diagnosis.result import Diagnosis, FloatArray, IntArray, Residuals
from trueaxis.reporting.diagnosis.lines import THINNED, Line, lines_of, sample
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.quantity import UM, written
from trueaxis.reporting.diagnosis.svg import BLUE, DOT, GREEN, INK, ORANGE, SOFT, cloud, picture, stacked

MOST_POINTS = 900  # of a panel; beyond, only a sample is drawn
STAGES = ("given", "refitted", "extended")
TITLES = {"given": "values as given", "refitted": "refitted", "extended": "extended model"}
_WAYS = ((1, "^", BLUE, BLUE, "coming up (+)"), (-1, "v", ORANGE, "none", "coming down (\N{MINUS SIGN})"))
MOST_OVER_COURSE = 600

_COURSE_LOOK = {
    "laser": ("o", BLUE, BLUE),
    "ballbar": ("s", ORANGE, "none"),
    "probe": ("D", GREEN, "none"),
    "angle": ("^", ORANGE, ORANGE),
    "displacement": ("v", GREEN, GREEN),
}
MOST_QUANTILES = 400
MOST_LAGS = 30


def positions(diagnosis: Diagnosis) -> list[Picture]:
    """One picture for each axis; none without lines."""
    lines = lines_of(diagnosis.residuals)
    return [_picture(diagnosis.residuals, [one for one in lines if one.axis == axis], axis) for axis in _axes(lines)]


def _axes(lines: tuple[Line, ...]) -> list[int]:
    return sorted({one.axis for one in lines})


def _picture(residuals: Residuals, lines: list[Line], axis: int) -> Picture:
    name = residuals.axes[axis]
    rows = np.concatenate([one.rows for one in lines])
    rms = ", ".join(f"{TITLES[s]} {_rms(residuals, s, rows):.3g} {UM}" for s in STAGES)
    thinned = rows.size > MOST_POINTS
    caption = (
        f"{rows.size} readings of {len(lines)} runs. "
        + (f"{THINNED} " if thinned else "A line joins one pass of a run. ")
        + "The upper panel has a scale of its own."
    )
    return picture(
        f"position-{name}",
        f"Residual against {name}",
        f"Residual against position {name} in three panels. RMS: {rms}.",
        caption,
        lambda: _figure(residuals, lines, axis, thinned),
    )


def _figure(residuals: Residuals, lines: list[Line], axis: int, thinned: bool) -> Figure:
    figure, panels = stacked(5.6, 3, titled=True)
    panels[1].sharey(panels[2])
    for panel, stage in zip(panels, STAGES, strict=True):
        panel.axhline(0.0, color=INK, linewidth=0.6)
        values = 1e3 * getattr(residuals, stage)
        for way, marker, colour, face, label in _WAYS:
            _draw(panel, residuals, lines, axis, values, way, thinned, (marker, colour, face, label))
        _still(panel, residuals, lines, axis, values)
        panel.set_title(TITLES[stage])
        panel.set_ylabel(UM)
    unit = "mm" if residuals.axes[axis] in "XYZ" else "deg"
    panels[-1].set_xlabel(f"{residuals.axes[axis]} ({unit})")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncols=3)
    return figure


def _draw(
    panel: Axes,
    residuals: Residuals,
    lines: list[Line],
    axis: int,
    values: FloatArray,
    way: int,
    thinned: bool,
    look: tuple[str, str, str, str],
) -> None:
    marker, colour, face, label = look
    passes = [one for line in lines for one in _passes(residuals, line.rows, axis, way)]
    if not passes:
        return
    points = np.concatenate(passes)
    if thinned:
        points = points[np.argsort(residuals.positions[axis, points], kind="stable")]
        points = points[sample(values[points], MOST_POINTS // 2)]
    else:
        gap = np.array([np.nan])
        x = np.concatenate([part for one in passes for part in (residuals.positions[axis, one], gap)])
        y = np.concatenate([part for one in passes for part in (values[one], gap)])
        panel.plot(x, y, "-", color=colour, linewidth=0.5, alpha=0.55)
    cloud(panel, residuals.positions[axis, points], values[points], marker, colour, face, 2.6, label)


def _passes(residuals: Residuals, rows: IntArray, axis: int, way: int) -> list[IntArray]:
    """Rows of a run cut where its direction changes; those that came the given way."""
    direction = np.sign(residuals.directions[axis, rows])
    cut = np.split(np.arange(rows.size), np.flatnonzero(np.diff(direction)) + 1)
    return [rows[part] for part in cut if direction[part[0]] == way]


def _still(panel: Axes, residuals: Residuals, lines: list[Line], axis: int, values: FloatArray) -> None:
    """Readings before the axis has moved at all."""
    rows = np.concatenate([one.rows for one in lines])
    rows = rows[residuals.directions[axis, rows] == 0.0][:MOST_POINTS]
    if rows.size:
        x = residuals.positions[axis, rows]
        cloud(panel, x, values[rows], DOT, SOFT, SOFT, 2.2, "not moved yet")


def _rms(residuals: Residuals, stage: str, rows: IntArray) -> float:
    return float(1e3 * np.sqrt(np.mean(getattr(residuals, stage)[rows] ** 2)))


def course(diagnosis: Diagnosis) -> list[Picture]:
    """A picture for the time and one for the temperature, where the readings have them."""
    residuals = diagnosis.residuals
    found = []
    if _varies(residuals.time):
        assert residuals.time is not None
        factor, unit = (1.0 / 60.0, "min") if np.nanmax(residuals.time) < 7200.0 else (1.0 / 3600.0, "h")
        found.append(_course_picture(residuals, "time", factor * residuals.time, f"time ({unit})"))
    if _varies(residuals.temperature):
        assert residuals.temperature is not None
        found.append(_course_picture(residuals, "temperature", residuals.temperature, "temperature (\N{DEGREE SIGN}C)"))
    return found


def _varies(values: FloatArray | None) -> bool:
    if values is None:
        return False
    known = values[np.isfinite(values)]
    return known.size > 1 and bool(np.ptp(known) > 0.0)


def _course_picture(residuals: Residuals, name: str, across: FloatArray, label: str) -> Picture:
    known = np.isfinite(across)
    correlated = [
        written(float(np.corrcoef(across[known], values[known])[0, 1]) if np.ptp(values[known]) > 0.0 else 0.0, ".2f")
        for values in (residuals.refitted, residuals.extended)
    ]
    drawn = np.bincount(residuals.run[known], minlength=len(residuals.runs))
    most = max(int(drawn[np.array(residuals.instruments) == name].sum()) for name in _COURSE_LOOK)
    thinned = f" {THINNED}" if most > MOST_OVER_COURSE else ""
    return picture(
        f"course-{name}",
        f"Residual against {name}",
        f"Residual against {name}, refitted above and extended model below; correlation {correlated[0]} before, "
        f"{correlated[1]} after.",
        f"Correlation with {name}: {correlated[0]} refitted, {correlated[1]} with the extended model.{thinned}",
        lambda: _course_figure(residuals, across, label),
    )


def _course_figure(residuals: Residuals, across: FloatArray, label: str) -> Figure:
    figure, panels = stacked(4.0, 2, titled=True, sharey=True)
    instrument = np.array(residuals.instruments)[residuals.run]
    for panel, values, title in zip(
        panels, (residuals.refitted, residuals.extended), ("refitted", "extended model"), strict=True
    ):
        panel.axhline(0.0, color=INK, linewidth=0.6)
        for name, (marker, colour, face) in _COURSE_LOOK.items():
            rows = np.flatnonzero((instrument == name) & np.isfinite(across))
            rows = rows[np.argsort(across[rows], kind="stable")]
            rows = rows[sample(values[rows], MOST_OVER_COURSE)]
            if rows.size:
                cloud(panel, across[rows], 1e3 * values[rows], marker, colour, face, 2.2, name)
        panel.set_title(title)
        panel.set_ylabel(UM)
    panels[-1].set_xlabel(label)
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncols=3)
    return figure


def whiteness(diagnosis: Diagnosis) -> list[Picture]:
    """The Q-Q plot and the autocorrelation; none for fewer than eight readings."""
    whitened = diagnosis.residuals.whitened
    whitened = np.sort(whitened[np.isfinite(whitened)])
    if whitened.size < 8:
        return []
    spread = float(np.std(whitened))
    lags, correlation, count = _autocorrelation(diagnosis.residuals)
    bound = 1.96 / np.sqrt(count)
    outside = int(np.sum(np.abs(correlation) > bound))
    return [
        picture(
            "quantiles",
            "Q-Q plot of the whitened residuals",
            f"Quantiles of {whitened.size} whitened residuals against those of a normal distribution; "
            f"standard deviation {spread:.3g}.",
            f"On the line where the residuals are normal noise of the size of the repeats; standard deviation "
            f"{spread:.3g}."
            + (
                f" A selection of the {whitened.size} is drawn, evenly over the axis."
                if whitened.size > MOST_QUANTILES
                else ""
            ),
            lambda: _quantiles(whitened),
        ),
        picture(
            "autocorrelation",
            "Autocorrelation of the whitened residuals",
            f"Autocorrelation up to lag {lags.size}; {outside} of {lags.size} lie outside the 95 % band.",
            f"From one reading of a run to later ones; {outside} of {lags.size} outside the 95 % band of independent "
            f"readings (chance: {0.05 * lags.size:.1f}; curves that were fitted to them move some more out of it).",
            lambda: _correlogram(lags, correlation, bound),
        ),
    ]


def _quantiles(whitened: FloatArray) -> Figure:
    figure, (panel,) = stacked(3.2)
    expected = ndtri((np.arange(1, whitened.size + 1) - 0.5) / whitened.size)
    ends = np.array([expected[0], expected[-1]])
    kept = np.unique(
        np.searchsorted(expected, np.linspace(expected[0], expected[-1], MOST_QUANTILES)).clip(0, whitened.size - 1)
    )
    panel.plot(ends, ends, "--", color=INK, linewidth=0.9, label="noise as estimated")
    cloud(panel, expected[kept], whitened[kept], DOT, BLUE, BLUE, 2.4, "residuals")
    panel.set_xlabel("normal quantile")
    panel.set_ylabel("whitened residual")
    figure.legend(loc="upper center", ncols=2)
    return figure


def _autocorrelation(residuals: Residuals) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Lags, correlation at each, and the number of pairs; pairs within a run only."""
    order = np.lexsort((residuals.seq, residuals.run))
    run, values = residuals.run[order], np.nan_to_num(residuals.whitened[order])
    lags = np.arange(1, min(MOST_LAGS, values.size // 4) + 1)
    power = float(np.mean(values**2)) or 1.0
    correlation, count = np.zeros(lags.size), np.zeros(lags.size)
    for k, lag in enumerate(lags):
        same = run[lag:] == run[:-lag]
        count[k] = max(1, int(same.sum()))
        correlation[k] = float(np.sum(values[lag:][same] * values[:-lag][same])) / (count[k] * power)
    return lags.astype(float), correlation, count


def _correlogram(lags: FloatArray, correlation: FloatArray, bound: FloatArray) -> Figure:
    figure, (panel,) = stacked(3.2)
    panel.fill_between(lags, -bound, bound, color=ORANGE, alpha=0.25, linewidth=0, label="95 % of white noise")
    panel.axhline(0.0, color=INK, linewidth=0.7)
    panel.vlines(lags, 0.0, correlation, color=BLUE, linewidth=1.3)
    panel.plot(lags, correlation, "o", color=BLUE, markersize=2.6, label="autocorrelation")
    largest = max(0.2, 1.15 * float(np.abs(correlation).max()))
    panel.set_ylim(-largest, largest)
    panel.set_xlabel("lag (readings)")
    figure.legend(loc="upper center", ncols=2)
    return figure
