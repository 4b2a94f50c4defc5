"""A circular test as a person reads it, and as JSON."""

import json
from dataclasses import asdict

import numpy as np

from trueaxis.evaluation.circular_contributions import Contributions
from trueaxis.evaluation.circular_test import STANDARD, CircularFigures, CircularTest

SENSES = {1: "ccw", -1: "cw"}
NAMES = {
    "squareness": "squareness",
    "scale_mismatch": "scale mismatch",
    "straightness": "straightness",
    "servo_mismatch": "servo mismatch",
    "reversal_error": "reversal error",
    "lateral_play": "lateral play",
    "reversal_spike": "reversal spike",
    "cyclic_error": "cyclic error",
}
LEGEND = """\
squareness: angle between the positive axes less 90 deg; scale mismatch: first axis less second; straightness A in B:
sag of the motion of A in the direction of B over the diameter; reversal error, at either end of an axis: position
approached in the positive direction less that in the negative one (lost motion is negative); lateral play: shift across
with the direction of the axis, positive where it goes with the other axis; reversal spike: outwards; servo mismatch:
time by which the first axis follows later; cyclic error: peak to peak. u: standard uncertainty, of noise and of what no
error of the list explains; range: of the radial deviations that the error causes alone; share: of
the sum of all ranges.
"""


def report_text(source: str, test: CircularTest, figures: CircularFigures, parts: Contributions) -> str:
    """Lines of ASCII text, ending with a newline. source: what was evaluated, as the user named it."""
    plane = "".join(test.plane)
    feed = "feed unknown" if test.feed is None else f"{test.feed:g} mm/min"
    count = sum(arc.angle.size for arc in test.arcs)
    lines = [
        f"{source}: circular test by {STANDARD}, plane {plane}, radius {test.radius:g} mm, {feed}; {count} readings"
    ]
    lines += ["", f"{'deviation, um':<34}{'sense':>6}{'G':>10}{'F max':>10}{'F min':>10}{'G min. zone':>13}"]
    for one in figures.arcs:
        cells = "".join(f"{1e3 * value:>z10.2f}" for value in (one.G, one.F_max, one.F_min))
        lines.append(f"{one.id:<34}{SENSES[one.sense]:>6}{cells}{1e3 * one.zone:>13.2f}")
    both = "-" if figures.G_b is None else f"{1e3 * figures.G_b:.2f}"
    lines += [
        f"{'both senses, G(b)':<40}{both:>10}",
        f"{'mean radial deviation D':<40}{1e3 * figures.D:>z10.2f}",
        "",
        f"{'':>4} {'error':<18}{'of':<14}{'value':>10}{'u':>9} {'unit':<6}{'range, um':>10}{'share':>8}",
    ]
    for rank, part in enumerate(parts.largest, 1):
        pitch = "" if part.pitch is None else f"  period {part.pitch:.3g} mm"
        digits = _decimals(part.u)
        lines.append(
            f"{rank:>4} {NAMES[part.error]:<18}{part.of:<14}{part.value:>z10.{digits}f}{part.u:>9.{digits}f} "
            f"{part.unit:<6}{1e3 * part.range:>10.2f}{part.share:>8.0%}{pitch}"
        )
    value, u = parts.radius
    lines += [
        "",
        f"radius: {1e3 * value:z.2f} um above nominal (u {1e3 * u:.2f} um): scale of both axes and length of the bar",
        f"left over: {1e3 * parts.residual:.2f} um RMS; the errors explain {parts.explained:.1%} of the mean square",
    ]
    lines += [f"note: {text}" for text in notes(test, parts)]
    return "\n".join([*lines, "", LEGEND])


def _decimals(u: float) -> int:
    """Of a value, so that its uncertainty has two digits, or one above 10."""
    return int(np.clip(1.0 - np.floor(np.log10(max(u, 1e-9))), 0, 4))


def notes(test: CircularTest, parts: Contributions) -> list[str]:
    """What this test leaves open."""
    found = []
    if len(test.senses) == 1:
        found.append(f"all arcs run {SENSES[test.senses[0]]}: the standard's test has both senses; G(b) needs them")
    if parts.left_out:
        named = "; ".join(f"{NAMES[error]} {of}" for error, of in parts.left_out)
        remedy = " (another sense of rotation tells them)" if len(test.senses) == 1 else ""
        found.append(f"not told from the errors above and zero here: {named}{remedy}")
    if test.feed is None and any(part.error == "servo_mismatch" for part in parts.largest):
        found.append("without a feed (column feed, or --feed) servo mismatch is a following error, um, not a time")
    return found


def report_json(test: CircularTest, figures: CircularFigures, parts: Contributions) -> str:
    """The same as JSON; lengths in mm but for values of errors, whose units are beside them."""
    tree = {
        "schema": 1,
        "standard": STANDARD,
        "unit": "mm",
        "plane": "".join(test.plane),
        "radius": test.radius,
        "feed": test.feed,
        "arcs": [asdict(one) | {"sense": SENSES[one.sense]} for one in figures.arcs],
        "G_b": figures.G_b,
        "D": figures.D,
        "errors": [asdict(part) for part in parts.largest],
        "not_told": [{"error": error, "of": of} for error, of in parts.left_out],
        "radius_deviation": {"value": parts.radius[0], "u": parts.radius[1]},
        "residual_rms": parts.residual,
        "explained": parts.explained,
        "notes": notes(test, parts),
    }
    return json.dumps(tree, indent=1, allow_nan=False) + "\n"
