"""The schemas of JSON files, which commands write: errors.json (docs/files.md), diagnosis.json (docs/diagnosis.md).

Objects of diagnosis.json may get further keys: a program that reads the file passes over what it does not know.
"""

from typing import get_args

from trueaxis.diagnosis.result import Verdict
from trueaxis.error_name import DIRECTIONS
from trueaxis.machine.effects import ENDS
from trueaxis.machine.machine import AXES
from trueaxis.model.curve_json import HIGHEST_POWER, LARGEST_U, MOST_TERMS
from trueaxis.model.errors import DETERMINED, FIT_STATES
from trueaxis.model.origin import METHODS
from trueaxis.schemas.pieces import (
    FIRST_SCHEMA,
    NUMBER,
    Schema,
    among,
    array,
    by_name,
    document,
    numbers,
    said,
    table,
    uncertain,
    within,
)

_TEXT: Schema = {"type": "string"}
_U = uncertain(within(0.0, LARGEST_U))
_KNOWN = uncertain(NUMBER)
_STAGES = ("given", "refitted", "extended")


def errors_schema() -> Schema:
    """Of errors.json."""
    curve: Schema = {"$ref": "#/definitions/curve"}
    names = [str(direction.motion_error(axis)) for axis in AXES for direction in DIRECTIONS]
    return document(
        "Error values of trueaxis",
        "Values of a machine's errors: lengths mm, angles rad, positions mm or deg. What is not named is zero.",
        table(
            {
                "schema": FIRST_SCHEMA,
                "machine": _TEXT,
                "fit": table(
                    {"state": among(FIT_STATES), "chi2": NUMBER, "runs": array(_TEXT), "unjudged": array(_TEXT)},
                    ["state"],
                ),
                "covariance": table({"file": _TEXT, "sha256_of_values": _TEXT}, ["file", "sha256_of_values"]),
                "parameters": said(by_name(NUMBER), "dimensions and location errors by name"),
                "u": said(by_name(_U), "standard uncertainties of the parameters"),
                "u_readings": by_name(_U),
                "u_prior": by_name(_U),
                "motion_errors": said(table(dict.fromkeys(names, curve)), "curves by component error"),
                "effects": array(_effect()),
                "determined": said(by_name(among(DETERMINED)), "by what each error is determined"),
                "undetermined": array(
                    table({"combination": _TEXT, "parameters": array(_TEXT)}, ["combination", "parameters"])
                ),
                "origin": said(_origin(), "what identify made the values of"),
                "chain": said(_TEXT, "the axes of the spec that they were identified with, from workpiece to tool"),
            },
            ["schema", "machine"],
            definitions={"curve": _curve()},
        ),
    )


def _curve() -> Schema:
    u = {key: array(_U) for key in ("u", "u_readings", "u_prior")}
    measured = {"measured": said(numbers(2), "lowest and highest measured position")}
    powers = array({"type": "number", "minimum": 0, "maximum": HIGHEST_POWER, "multipleOf": 1}, uniqueItems=True)
    polynomial = {"basis": {"const": "polynomial"}, "powers": powers, "coefficients": numbers()} | u | measured
    terms = numbers() | {"maxItems": MOST_TERMS}
    legendre = {"basis": {"const": "legendre"}, "range": numbers(2), "coefficients": terms} | u | measured
    harmonics = {"type": "number", "minimum": 1, "maximum": MOST_TERMS // 2, "multipleOf": 1}
    turn = legendre | {"basis": {"const": "turn"}, "harmonics": harmonics}
    values = {"basis": {"const": "table"}, "positions": numbers() | {"minItems": 1}, "values": numbers()}
    return {
        "oneOf": [
            table(polynomial, ["basis", "powers", "coefficients"]),
            table(legendre, ["basis", "range", "coefficients"]),
            table(turn, ["basis", "range", "harmonics", "coefficients"]),
            table(values | {"u": array(_U)}, ["basis", "positions", "values"]),
        ]
    }


def _origin() -> Schema:
    text, count, truth = _TEXT, {"type": "number", "minimum": 0}, {"type": "boolean"}
    noise = {"instrument": text, "value": count, "unit": text, "stated": truth}
    size = {"unknown": text, "size": count, "usual": count, "unit": text, "values": count}
    keys = {
        "folder": text,
        "method": among(METHODS),
        "prior": truth,
        "runs": count,
        "readings": count,
        "outliers": count,
        "noise": array(table(noise, list(noise))),
        "usual_sizes": array(table(size, list(size))),
        "report": by_name(text),
    }
    return table(keys, list(keys))


def _effect() -> Schema:
    keys = {
        "kind": _TEXT,
        "component": _TEXT,
        "axis": among(AXES),
        "runs": array(_TEXT),
        "end": among(ENDS),
        "parameters": by_name(NUMBER),
        "u": by_name(_U),
    }
    return table(keys, ["kind", "parameters"])


def diagnosis_schema() -> Schema:
    """Of diagnosis.json."""
    texts, stages = array(_TEXT), _growing(dict.fromkeys(_STAGES, _KNOWN))
    gain = {
        "rms_um": stages,
        "held_out_rms_um": stages,
        "held_out_standardised": said(_KNOWN, "held-out residuals over their predicted scatter; 1 where it is right"),
        "held_out": said(_TEXT, "how the data were split"),
        "floor_um": said(_KNOWN, "the noise"),
    }
    required = {
        "schema": FIRST_SCHEMA,
        "machine": _TEXT,
        "verdict": among(get_args(Verdict)),
        "report": by_name(_TEXT),
        "measured": array({"type": "object"}),
        "misfits": said(texts, "runs that no errors of the machine fit"),
        "errors": array({"type": "object"}),
        "noise_um": _KNOWN,
        "causes": said(array(_cause()), "in the order of what they explain"),
        "gain": _growing(gain),
        "extended_machine": said(uncertain(_TEXT), "file beside this one"),
        "extended_errors": said(uncertain(_TEXT), "file beside this one"),
        "stale": array(_growing(dict.fromkeys(("value", "u", "p_value"), _KNOWN) | {"component": _TEXT})),
        "recalibration_p": _KNOWN,
        "warnings": texts,
        "absences": said(texts, "what the readings could not tell, and why"),
        "next_runs": array({"type": "object"}),
        "noise": array({"type": "object"}),
        "circularity": array({"type": "object"}),
        "checks": array(_growing({"id": _TEXT, "p_value": _KNOWN, "fired": {"type": "boolean"}})),
        "outliers": array(_growing({"run": _TEXT, "seq": {"type": "integer"}})),
        "threshold": _KNOWN,
        "evidence": array(_growing(_named() | {"evidence": _KNOWN, "p_value": _KNOWN}, ("evidence", "p_value"))),
        "limits": array(_growing(_named() | {"state": _TEXT, "unit": _TEXT}, ("state", "unit"))),
    }
    return document("Diagnosis of trueaxis", "What `trueaxis diagnose` found.", _growing(required))


def _growing(keys: dict[str, Schema], required: tuple[str, ...] | None = None) -> Schema:
    """An object with these keys, all of them required if not said otherwise, and perhaps others."""
    return {"type": "object", "properties": keys, "required": list(keys if required is None else required)}


def _named() -> dict[str, Schema]:
    """What says which effect it is."""
    return {
        "effect": said(_TEXT, "the kind"),
        "component": _TEXT,
        "of": {"const": "instrument"},
        "axis": among(AXES),
        "runs": array(_TEXT),
        "end": among(ENDS),
    }


def _cause() -> Schema:
    value = _growing({"value": _KNOWN, "u": _KNOWN, "unit": _TEXT})
    evidence = _growing(dict.fromkeys(("p_value", "held_out_gain", "evidence", "rms_um", "homogeneous_p"), _KNOWN))
    rest = {
        "parameters": by_name(value),
        "evidence": evidence,
        "cannot_be_told_from": array(_growing(_named() | {"parameters": by_name(value)}, ("effect",))),
        "separating": said(_TEXT, "the run that would tell them apart"),
        "sentence": _TEXT,
    }
    changed = {"or_changed": said(array(_TEXT), "components whose values may have changed in its place")}
    return _growing(_named() | rest | changed, ("effect", *rest))
