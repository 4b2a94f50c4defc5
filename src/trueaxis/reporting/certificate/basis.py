"""The block of the document that says what its values rest on."""

import math

from trueaxis.identification.words import enumerated, small
from trueaxis.model.errors import Fit
from trueaxis.model.origin import Origin
from trueaxis.reporting.certificate.content import Content
from trueaxis.reporting.diagnosis.quantity import quantity, with_own_sign
from trueaxis.reporting.diagnosis.tables import Table

CAPTION = "What these values rest on"
NOT_SAID = "the error values do not say it"


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
        judged = "the residuals could not be judged: no noise was stated, and too little is repeated"
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
