"""The schema of diagnosis.json, which `diagnose` writes (docs/diagnosis.md).

Objects may get further keys: a program that reads the file passes over what it does not know.
"""

from typing import get_args

from trueaxis.diagnosis.result import Verdict
from trueaxis.machine.effects import ENDS
from trueaxis.machine.machine import AXES
from trueaxis.schemas.pieces import FIRST_SCHEMA, NUMBER, Schema, among, array, by_name, document, said, uncertain

_TEXT: Schema = {"type": "string"}
_KNOWN = uncertain(NUMBER)
_STAGES = ("given", "refitted", "extended")


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
    return _growing(_named() | rest, ("effect", *rest))
