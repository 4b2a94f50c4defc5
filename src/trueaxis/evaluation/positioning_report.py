"""The evaluation as a person reads it, in the order of the standard's table, and as JSON."""

import json
import math
from typing import Any

import numpy as np

from trueaxis.evaluation.positioning_test import COVERAGE_FACTOR, STANDARD, Evaluation, Unidirectional, Unit, departures
from trueaxis.evaluation.vdi3441 import GUIDELINE, SIGMAS, figures_of

CONVENTIONS = {
    "iso": "R = max R_i, R_i = max(2 s_i+ + 2 s_i- + |B_i|, R_i+, R_i-): the standard's, reversal included",
    "unidirectional": "R = max(R+, R-): NOT the standard's, which includes the reversal",
}
_COLUMNS = ("i", "P_i", "x_i+", "x_i-", "x_i", "B_i", "s_i+", "s_i-", "R_i+", "R_i-", "R_i")
_VDI_NAMES = {
    "P": "positional uncertainty P",
    "Pa": "positional deviation Pa",
    "Ps_max": "largest positional scatter Ps",
    "Ps_mean": "mean positional scatter Ps",
    "U_max": "largest reversal error U",
    "U_mean": "mean reversal error U",
}
# unit of positions -> factors and units in which deviations are shown, the first one in the table of the targets
SHOWN: dict[Unit, tuple[tuple[float, str], ...]] = {
    "mm": ((1e3, "um"),),
    "deg": ((3600.0, "arcsec"), (1e6 * math.pi / 180.0, "urad")),
}
_LEGEND = (
    "+ approached in the positive direction, - in the negative one; P_i target ({unit}); the rest in {small}: x_i mean",
    "deviation, B_i = x_i+ - x_i- reversal value, s_i estimator of the standard uncertainty, R_i repeatability (4 s_i",
    "in one direction; in both as below)",
)


def report_text(source: str, evaluation: Evaluation) -> str:
    """Lines of ASCII text, ending with a newline. source: what was evaluated, as the user named it."""
    e, plus, minus = evaluation, evaluation.positive, evaluation.negative
    head = (
        f"positioning by {STANDARD}, k = {COVERAGE_FACTOR}; {len(e.targets)} targets, {e.cycles} cycles, 2 directions"
    )
    factor, small = SHOWN[e.unit][0]
    sides = (plus.mean, minus.mean, e.mean, e.b, plus.s, minus.s, plus.r, minus.r, e.r)
    rows = [e.targets, *(factor * v for v in sides)]
    legend = [line.format(unit=e.unit, small=small) for line in _LEGEND]
    lines = [f"{source}: {head}", *legend, "", "".join(f"{name:>{_width(name)}}" for name in _COLUMNS)]
    for number, row in enumerate(zip(*rows, strict=True), start=1):
        cells = [f"{number:>{_width('i')}}", f"{row[0]:{_width('P_i')}.10g}", *(cell(v, 9) for v in row[1:])]
        lines.append("".join(cells))
    for factor, small in SHOWN[e.unit]:
        lines += ["", f"{f'of the axis ({small})':<33}{'+':>10}{'-':>10}{'both':>10}"]
        lines += [
            _axis(factor, "reversal value B", None, None, e.B),
            _axis(factor, "mean reversal value", None, None, e.B_mean),
            _axis(factor, "repeatability R", plus.R, minus.R, e.R),
            _axis(factor, "systematic deviation E", plus.E, minus.E, e.E),
            _axis(factor, "mean bidirectional deviation M", None, None, e.M),
            _axis(factor, "accuracy A", plus.A, minus.A, e.A),
        ]
    lines += ["", CONVENTIONS[e.repeatability]] if e.cycles > 1 else [""]
    lines += _by_vdi3441(e)
    return "\n".join(lines + [f"note: {note}" for note in notes(e)]) + "\n"


def _by_vdi3441(e: Evaluation) -> list[str]:
    found = figures_of(e)
    if found is None:
        return []
    units = SHOWN[e.unit]
    lines = [
        f"\nof the axis by {GUIDELINE}, whose scatter spans {SIGMAS} standard deviations (R above: "
        f"{2 * COVERAGE_FACTOR})\n{'':<33}" + "".join(f"{small:>10}" for _, small in units)
    ]
    for symbol, value in found.named().items():
        lines.append(f"{_VDI_NAMES[symbol]:<33}" + "".join(cell(factor * value, 10) for factor, _ in units))
    return [*lines, ""]


def notes(evaluation: Evaluation) -> list[str]:
    """Where the test is less than the standard asks, and where its directions are doubtful."""
    found = departures(evaluation)
    if np.all(evaluation.b > 0):
        found.append(
            "every B_i is positive, while lost motion makes it negative: the labels of direction may be the wrong way "
            "round (--swap-directions), or the axis compensates its reversal too much"
        )
    return found


def report_json(evaluation: Evaluation) -> str:
    """The same as JSON, all in mm, of a rotary axis in deg, and its parameters in arc seconds and urad besides; null
    where a test of one cycle tells nothing. vdi_dgq_3441: the figures of that guideline, of two cycles or more.
    """
    e = evaluation
    tree = {
        "schema": 1,
        "standard": STANDARD,
        "coverage_factor": COVERAGE_FACTOR,
        "unit": e.unit,
        "repeatability": {"convention": e.repeatability, "standard": e.repeatability == "iso"},
        "cycles": e.cycles,
        "targets": e.targets.tolist(),
        "positive": _direction(e.positive),
        "negative": _direction(e.negative),
        "bidirectional": {
            "mean_deviation": e.mean.tolist(),
            "reversal_value": e.b.tolist(),
            "repeatability_at_target": e.r.tolist(),
            "B": e.B,
            "B_mean": e.B_mean,
            "R": e.R,
            "E": e.E,
            "M": e.M,
            "A": e.A,
        },
        "notes": notes(e),
    }
    if (by_vdi := figures_of(e)) is not None:
        tree["vdi_dgq_3441"] = by_vdi.named()
    if e.unit == "deg":
        of_axis = {"B": e.B, "B_mean": e.B_mean, "R": e.R, "E": e.E, "M": e.M, "A": e.A}
        for factor, small in SHOWN["deg"]:
            tree[f"bidirectional_{small}"] = {name: factor * value for name, value in of_axis.items()}
    return json.dumps(_without_nan(tree), indent=1, allow_nan=False) + "\n"


def _without_nan(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _without_nan(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_without_nan(item) for item in value]
    return None if isinstance(value, float) and math.isnan(value) else value


def _direction(side: Unidirectional) -> dict[str, Any]:
    return {
        "mean_deviation": side.mean.tolist(),
        "standard_uncertainty": side.s.tolist(),
        "repeatability_at_target": side.r.tolist(),
        "R": side.R,
        "E": side.E,
        "A": side.A,
    }


def _width(name: str) -> int:
    return {"i": 4, "P_i": 12}.get(name, 9)


def _axis(factor: float, name: str, *values: float | None) -> str:
    return (f"{name:<33}" + "".join(" " * 10 if v is None else cell(factor * v, 10) for v in values)).rstrip()


def cell(value: float, width: int) -> str:
    """With two decimals; a dash where there is no value."""
    return f"{'-':>{width}}" if math.isnan(value) else f"{value:z{width}.2f}"
