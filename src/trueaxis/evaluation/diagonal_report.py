"""A diagonal test as a person reads it, and as JSON."""

import json
import math
from dataclasses import asdict

from trueaxis.evaluation.diagonal_test import STANDARD, DiagonalFigures, DiagonalTest, Geometric, OfDiagonal
from trueaxis.evaluation.positioning_report import CONVENTIONS, cell
from trueaxis.evaluation.positioning_test import COVERAGE_FACTOR
from trueaxis.evaluation.positioning_test import STANDARD as DEFINITIONS

_FIGURES = ("E", "B", "R", "A", "M")
LEGEND = """\
Names: a letter each for X, Y and Z (those that there are), p where the axis goes in its positive direction as the
targets grow, n in its negative one. E systematic deviation, B reversal value, R repeatability, A accuracy, M range of
the mean bidirectional deviation, all by ISO 230-2 along the diagonal; Ed, Bd: the largest E and B. Scale: slope of the
mean bidirectional deviation. Scale errors of the axes act on all diagonals alike; different scales come from squareness
and, not told from it here, from straightness and angular errors. Equal diagonals do not prove a good machine: scale
errors of the axes that cancel each other show on none of them. Squareness: angle between the positive axes less 90 deg,
if the axes are straight and do not rotate as they move. u: standard uncertainty by the scatter of the cycles; it holds
no drift between the diagonals.
"""


def report_text(source: str, test: DiagonalTest, figures: DiagonalFigures) -> str:
    """Lines of ASCII text, ending with a newline. source: what was evaluated, as the user named it."""
    sides = ", ".join(f"{axis} {value:g}" for axis, value in test.lengths.items())
    lines = [
        f"{source}: diagonal test ({STANDARD}), figures by {DEFINITIONS}, k = {COVERAGE_FACTOR}",
        f"{sides} mm, diagonals of {test.length:.7g} mm",
        "",
        f"{'diagonal':<10}{'targets':>8}{'cycles':>8}"
        + "".join(f"{f'{name}, um':>10}" for name in _FIGURES)
        + f"{'scale, um/m':>14}{'u':>8}",
    ]
    for one in figures.diagonals:
        e = one.evaluation
        cells = "".join(cell(1e3 * getattr(e, name), 10) for name in _FIGURES)
        lines.append(f"{one.name:<10}{len(e.targets):>8}{e.cycles:>8}{cells}{_scales(one.scale, one.u_scale)}")
    at_e = max(figures.diagonals, key=lambda one: one.evaluation.E).name
    at_b = max(figures.diagonals, key=lambda one: one.evaluation.B).name
    lines += [
        "",
        f"{'largest systematic deviation Ed':<36}{1e3 * figures.E_d:>10.2f} um     ({at_e})",
        f"{'largest reversal value Bd':<36}{1e3 * figures.B_d:>10.2f} um     ({at_b})",
        f"{'range of the scales':<36}{1e6 * figures.scale_range:>10.2f} um/m",
    ]
    if figures.scale is not None:
        lines.append(_geometric("mean of the scales", figures.scale, "um/m"))
    lines += [_geometric(f"squareness {one.of}", one, "urad") for one in figures.squareness]
    if any(one.evaluation.cycles > 1 for one in figures.diagonals):
        lines += ["", CONVENTIONS[figures.diagonals[0].evaluation.repeatability]]
    lines += [f"note: {text}" for text in notes(test, figures)]
    return "\n".join([*lines, "", LEGEND])


def notes(test: DiagonalTest, figures: DiagonalFigures) -> list[str]:
    """What this test leaves open."""
    found = []
    if test.missing:
        missing = ", ".join(test.missing)
        found.append(f"Ed and Bd are of the diagonals above: {missing} missing; squareness needs all of them")
    single = [one.name for one in figures.diagonals if one.evaluation.cycles == 1]
    if single:
        found.append(f"one cycle ({', '.join(single)}): R, A and u are not estimated")
    return found


def report_json(test: DiagonalTest, figures: DiagonalFigures) -> str:
    """The same as JSON: lengths in mm, scales as ratios, squareness in rad; null where a test of one cycle tells
    nothing, or diagonals are missing.
    """
    tree = {
        "schema": 1,
        "standard": STANDARD,
        "definitions": DEFINITIONS,
        "coverage_factor": COVERAGE_FACTOR,
        "unit": "mm",
        "lengths": dict(test.lengths),
        "diagonals": [_of_diagonal(one) for one in figures.diagonals],
        "E_d": figures.E_d,
        "B_d": figures.B_d,
        "scale_range": figures.scale_range,
        "scale": None if figures.scale is None else asdict(figures.scale),
        "squareness": [asdict(one) for one in figures.squareness],
        "notes": notes(test, figures),
    }
    return json.dumps(tree, indent=1, allow_nan=False) + "\n"


def _of_diagonal(one: OfDiagonal) -> dict[str, object]:
    e = one.evaluation
    named = {name: getattr(e, name) for name in _FIGURES}
    return {
        "name": one.name,
        "cycles": e.cycles,
        "targets": e.targets.tolist(),
        "mean_deviation": {"positive": e.positive.mean.tolist(), "negative": e.negative.mean.tolist()},
        **{name: None if math.isnan(value) else value for name, value in named.items()},
        "scale": {"value": one.scale, "u": one.u_scale},
    }


def _geometric(name: str, one: Geometric, unit: str) -> str:
    u = "" if one.u is None else f"  u {1e6 * one.u:.2f}"
    return f"{name:<36}{1e6 * one.value:>z10.2f} {unit:<5}{u}".rstrip()


def _scales(scale: float, u: float | None) -> str:
    return f"{1e6 * scale:>z14.2f}" + (f"{'-':>8}" if u is None else f"{1e6 * u:>8.2f}")
