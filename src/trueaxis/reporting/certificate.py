"""The document as one HTML file that needs nothing else: no network, no script. Printed, it takes two pages of A4."""

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.figure import Figure

from trueaxis.effects.kind import Kind, Parameter
from trueaxis.identification.words import enumerated, small
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import Fit
from trueaxis.model.grid import Slice
from trueaxis.model.origin import Origin
from trueaxis.reporting.certificate_content import Content, ErrorLine, OverVolume
from trueaxis.reporting.diagnosis.html import rendered
from trueaxis.reporting.diagnosis.picture import Picture
from trueaxis.reporting.diagnosis.quantity import NBSP, UM, quantity, with_own_sign
from trueaxis.reporting.diagnosis.svg import picture
from trueaxis.reporting.diagnosis.tables import Table
from trueaxis.reporting.diagnosis.words import effect_title
from trueaxis.reporting.reliance import misfit_sentence

TEMPLATE = "certificate.html.j2"
DASH = "\N{EN DASH}"
CHANGED = 3.0  # standard uncertainties: of 60 curves and angles that stay as they are about one seems to have changed
DETERMINED = {"data": "readings", "partly": "partly the prior", "prior": "the prior", None: DASH}
LEVELS = 6
CAPTION = "What these values rest on"
NOT_SAID = "the error values do not say it"


def certificate(content: Content, kinds: dict[str, Kind]) -> str:
    """The page, the same for the same content to the byte. kinds: of the effects, by name."""
    compared = content.against is not None
    return rendered(
        TEMPLATE,
        machine=content.machine,
        title=content.title,
        facts=_facts(content),
        warnings=_warnings(content),
        basis=basis_table(content),
        volume=_volume(content),
        tables=[
            one
            for one in (
                _errors("Component errors, largest over the travel", content.components, compared),
                _errors("Location errors", content.locations, compared),
                _effects(content.effects, kinds),
            )
            if one.rows
        ],
        notes=_notes(content),
        picture=_map(content.slices) if content.slices else None,
    )


def _facts(content: Content) -> list[tuple[str, str]]:
    tool = ", ".join(f"{value:g}" for value in content.tool)
    found = [("error values", Path(content.source).name), ("tool point", f"{tool} mm in the tool frame")]
    if content.against is not None:
        found.append(("compared with", Path(content.against).name))
    return found


def _warnings(content: Content) -> list[str]:
    fit = content.fit
    found = [misfit_sentence(fit)] if fit is not None and fit.state == "misfit" else []
    if not any(math.isfinite(one.u) for one in (*content.components, *content.locations)):
        found.append("The file has no standard uncertainties: how far these values can be relied on is not known.")
    by_prior = [one.name for one in (*content.components, *content.locations) if one.determined == "prior"]
    if by_prior:
        found.append(
            f"Determined only by the expected sizes ([prior]), not by readings: {', '.join(by_prior)}. "
            "Their u includes that."
        )
    return found


def _volume(content: Content) -> Table:
    head = ("tool point from home", "RMS", "95 % below", "largest", "at", "u, RMS", "of it by the prior", "largest u")
    rows = [_of_volume("deviation", content.volume)]
    if content.changed is not None:
        rows.append(_of_volume("change", content.changed))
    return Table(
        caption="Length of the deviation over the volume",
        head=head,
        rows=tuple(rows),
        numbers=frozenset({1, 2, 3, 5, 6, 7}),
    )


def _of_volume(name: str, one: OverVolume) -> tuple[str, ...]:
    at = " ".join(f"{axis}{value:g}" for axis, value in one.largest_at.items())
    sizes = (quantity(value, "mm") for value in (one.rms, one.within, one.largest))
    known = (one.u_rms, one.u_prior_rms, one.u_largest)
    return (name, *sizes, at, *(quantity(u, "mm") if math.isfinite(u) else DASH for u in known))


def _errors(caption: str, lines: Sequence[ErrorLine], compared: bool) -> Table:
    curves = any(one.at is not None for one in lines)
    head = ["error", "value", *(["at"] if curves else []), "u", *(["RMS"] if curves else []), "determined by"]
    numbers = frozenset(range(1, len(head) - 1)) | {len(head), len(head) + 1}
    if compared:
        head += ["change, RMS" if curves else "change", "change / u", ""]
    rows = []
    for one in lines:
        row = [
            f"{one.name}: {one.meaning}" if one.meaning else one.name,
            quantity(one.value, one.unit),
            *([] if one.at is None else [f"{one.at:.4g}"]),
            quantity(one.u, one.unit) if math.isfinite(one.u) else DASH,
            *([] if one.at is None else [quantity(one.rms, one.unit)]),
            DETERMINED[one.determined],
        ]
        if compared and one.change is not None:
            row += [
                quantity(one.change.rms, one.unit),
                f"{one.change.in_u:.1f}" if math.isfinite(one.change.in_u) else DASH,
                _where(one),
            ]
        rows.append(tuple(row))
    return Table(caption=caption, head=tuple(head), rows=tuple(rows), numbers=numbers)


def _where(one: ErrorLine) -> str:
    change = one.change
    if change is None or not math.isfinite(change.in_u) or change.in_u < CHANGED:
        return ""
    return "changed" if change.at is None else f"changed, most at {change.at:g}"


def _effects(effects: Sequence[EffectValues], kinds: dict[str, Kind]) -> Table:
    rows = [
        (
            effect_title(one.effect),
            parameter.name,
            quantity(one.parameters[parameter.name], parameter.unit),
            _u(one, parameter),
        )
        for one in effects
        for parameter in kinds[one.effect.kind].parameters
        if parameter.name in one.parameters
    ]
    caption = "Effects, which depend on more than positions"
    return Table(
        caption=caption, head=("effect", "parameter", "value", "u"), rows=tuple(rows), numbers=frozenset({2, 3})
    )


def _u(one: EffectValues, parameter: Parameter) -> str:
    u = one.u.get(parameter.name, math.nan)
    return quantity(u, parameter.unit) if math.isfinite(u) else DASH


def _notes(content: Content) -> list[str]:
    found = [
        "E, direction, axis: ISO 230-1; values are actual minus ideal. u: standard uncertainty; 95 % lie within 2 u. "
        "Positions: mm, deg.",
        "Tool point: deviation in the workpiece frame minus that at home. Largest u: of one coordinate.",
    ]
    if content.effects:
        found.append(
            "Maps and figures of the volume are without effects, which depend on directions, times and temperatures."
        )
    if content.against is not None:
        found.append(
            "change / u: the largest over the travel, u of both files taken as independent; from "
            f"{CHANGED:g} on it counts as changed."
        )
    return found


def _map(slices: Sequence[Slice]) -> Picture:
    largest = max(float(one.values.max()) for one in slices)
    alt = "; ".join(f"{one.axes[0]}{one.axes[1]}: largest {1e3 * float(one.values.max()):.3g} {UM}" for one in slices)
    caption = (
        f"Length of the deviation from home, {UM}; the other axes in the middle of their travel, rotary axes at home."
    )
    return picture(
        "volume", "Deviation of the tool point over the volume", alt, caption, lambda: _figure(slices, largest)
    )


def _figure(slices: Sequence[Slice], largest: float) -> Figure:
    figure = Figure(figsize=(2.9 * len(slices) + 0.7, 2.9), layout="constrained")
    panels = figure.subplots(1, len(slices), squeeze=False)[0]
    drawn = [_panel(panel, one, 1e3 * largest) for panel, one in zip(panels, slices, strict=True)]
    bar = figure.colorbar(drawn[-1], ax=list(panels), shrink=0.85)
    bar.set_label(f"deviation ({UM})")
    return figure


def _panel(panel: Axes, one: Slice, top: float) -> QuadMesh:
    um = 1e3 * one.values
    drawn = panel.pcolormesh(
        one.first, one.second, um, cmap="viridis", vmin=0.0, vmax=top, shading="nearest", rasterized=True
    )
    if float(np.ptp(um)) > 0.0:
        lines = panel.contour(one.first, one.second, um, levels=LEVELS, colors="white", linewidths=0.7)
        panel.clabel(lines, fontsize=7, fmt="%.3g")
    at = ", ".join(f"{axis}{value:g}" for axis, value in one.at.items())
    panel.set_title(at.replace(" ", NBSP) if at else " ")
    panel.set_xlabel(f"{one.axes[0]} (mm)")
    panel.set_ylabel(f"{one.axes[1]} (mm)")
    panel.grid(visible=False)
    return drawn


def basis_table(content: Content) -> Table:
    """Readings, noise, fit, prior, sizes of instrument unknowns, and what setup.toml says of the measurement."""
    origin = content.origin
    rows = [("readings", NOT_SAID)] if origin is None else _of_readings(origin)
    rows.append(("fit", fit_text(content.fit)))
    if origin is not None:
        prior = "errors are expected to have the sizes of [prior], which the readings may correct"
        none = "none: what the readings do not determine is zero, and has no u"
        rows.append(("prior", prior if origin.prior else none))
        rows += _usual(content, origin)
    return Table(caption=CAPTION, head=("", ""), rows=tuple(rows), numbers=frozenset())


def fit_text(fit: Fit | None) -> str:
    """How the identification ended, and whether its residuals could be judged."""
    if fit is None:
        return NOT_SAID
    if fit.chi2 is None:
        why = "no noise was stated, and too little is repeated" if fit.unjudged else "as many unknowns as readings"
        judged = f"the residuals could not be judged: {why}"
        return f"{fit.state}; {judged}" if fit.state == "converged" else fit.state
    apart = f"; not judged: {enumerated(fit.unjudged)}, whose noise is not known" if fit.unjudged else ""
    return f"{fit.state}, chi-square per degree of freedom {fit.chi2:.3g}{apart}"


def _of_readings(origin: Origin) -> list[tuple[str, str]]:
    out = f"; {origin.outliers} left out as outliers" if origin.outliers else ""
    noise = [
        f"{one.instrument} {one.value:.3g} {one.unit} ({'stated' if one.stated else 'estimated from the readings'})"
        for one in origin.noise
    ]
    rows = [(key, text) for key, text in origin.report.items()]
    rows.append(("readings", f"{origin.readings} in {origin.runs} runs, data folder {origin.folder}{out}"))
    rows.append(("method", f"identify --method {origin.method}"))
    return [*rows, ("noise of a reading", with_own_sign("; ".join(noise)) or "not known")]


def _usual(content: Content, origin: Origin) -> list[tuple[str, str]]:
    """What u is by the usual sizes of instrument unknowns; nothing where that is not known."""
    if not origin.usual_sizes:
        return []
    sizes = [
        f"{one.unknown} {small(one.size, one.unit)} from {one.values} value{'s' * (one.values != 1)} "
        f"(usual {small(one.usual, one.unit)})"
        for one in origin.usual_sizes
    ]
    u = content.volume.u_usual_rms
    by_these = f": {quantity(u, 'mm')} RMS of the tool point" if math.isfinite(u) else ""
    return [
        (
            "instruments",
            f"the readings make these unknowns far smaller than usual: {with_own_sign('; '.join(sizes))}. u on this "
            f"page counts by these sizes; by the usual ones it is larger{by_these}",
        )
    ]
