"""diagnosis.json: the findings for programs."""

import json
import math
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from trueaxis.diagnosis.further_runs.of_plan import Limit
from trueaxis.diagnosis.judging.structure import Check
from trueaxis.diagnosis.null_model.noise import UNKNOWN
from trueaxis.diagnosis.result import Cause, Circle, Diagnosis, Estimate, Evidence, GainOfAngles, NoiseOf, Stage, Stale
from trueaxis.effects.kind import Effect
from trueaxis.measurement.instrument_kinds import small_unit
from trueaxis.reporting.diagnosis.further import absences, proposals, separating_run, warnings
from trueaxis.reporting.diagnosis.structures import check_meaning, check_name
from trueaxis.reporting.diagnosis.tables import units_of_runs
from trueaxis.reporting.diagnosis.words import ESTIMATED

SCHEMA = 1


def diagnosis_json(diagnosis: Diagnosis, extended_machine: str | None, extended_errors: str | None) -> str:
    """Strict JSON, ending with a newline; what is not a finite number is null.

    extended_machine, extended_errors: the files of the extended model, as a reader of diagnosis.json finds them.
    Lengths whose key does not say otherwise are in the unit beside them (mm, rad, ...).
    """
    gain, units = diagnosis.gain, units_of_runs(diagnosis)
    content = {
        "schema": SCHEMA,
        "machine": diagnosis.machine,
        "verdict": diagnosis.verdict,
        "report": dict(diagnosis.report),
        "measured": [asdict(one) for one in diagnosis.measured],
        "misfits": list(diagnosis.misfits),
        "errors": [asdict(one) for one in diagnosis.errors],
        "noise_um": _um(noise(diagnosis)),
        "causes": [_cause(one) for one in diagnosis.causes],
        "gain": {
            "rms_um": _stage(gain.rms),
            "held_out_rms_um": _stage(gain.held_out),
            "held_out_standardised": gain.standardised,
            "held_out": gain.split,
            "floor_um": _um(gain.floor),
            **_of_angles(gain.angles),
        },
        "extended_machine": extended_machine,
        "extended_errors": extended_errors,
        "stale": [_stale(one) for one in diagnosis.stale],
        "recalibration_p": diagnosis.recalibration_p,
        "warnings": list(warnings(diagnosis)),
        "absences": list(absences(diagnosis)),
        "next_runs": [asdict(one) for one in proposals(diagnosis)],
        "noise": [_noise(one) for one in diagnosis.noise],
        "circularity": [_circularity(one) for one in diagnosis.circles],
        "checks": [_check(one) for one in diagnosis.checks],
        "outliers": [
            {"run": one.run, "seq": one.seq, f"deviation_{units[one.run]}": _um(one.deviation), "z": one.z}
            for one in diagnosis.outliers
        ],
        "threshold": diagnosis.threshold,
        "evidence": [_evidence(one) for one in diagnosis.scan],
        "limits": [_limit(one) for one in diagnosis.limits],
    }
    return json.dumps(_plain(content), indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def noise(diagnosis: Diagnosis) -> float:
    """RMS of the noise over the readings of lengths that are kept, each with the noise of its instrument, mm; NaN where
    it is unknown.
    """
    residuals = diagnosis.residuals
    sigma = {
        one.group: one.sigma for one in diagnosis.noise if small_unit(one.instrument) == "um" and one.origin != UNKNOWN
    }
    groups, counts = np.unique(
        np.array([residuals.noise_groups[k] for k in residuals.run], dtype=str), return_counts=True
    )
    known = [(sigma[str(name)], int(n)) for name, n in zip(groups, counts, strict=True) if str(name) in sigma]
    if not known:
        return float(np.sqrt(np.mean(np.square(list(sigma.values()))))) if sigma else math.nan
    return math.sqrt(sum(n * value**2 for value, n in known) / sum(n for _, n in known))


def _stale(one: Stale) -> dict[str, Any]:
    """from, to: positions of the axis, null of a location error; value, u: in `unit`."""
    return {
        "component": one.component,
        "from": one.first,
        "to": one.last,
        "value": one.value,
        "u": one.u,
        "unit": one.unit,
        "p_value": one.p_value,
        "from_straight_line": one.bent,
        "cannot_be_told_from": [*({"component": other} for other in one.alike), *map(_effect, one.effects)],
    }


def _circularity(one: Circle) -> dict[str, Any]:
    return {
        "run": one.run,
        "measured_um": _um(one.measured),
        "left_um": {"given": _um(one.given), "refitted": _um(one.refitted), "extended": _um(one.extended)},
    }


def _check(one: Check) -> dict[str, Any]:
    return {
        "id": one.structure.value,
        "place": one.place,
        "check": check_name(one),
        "meaning": check_meaning(one),
        "p_value": one.p_value,
        "fired": one.fired,
        "rms_um": _um(one.rms),
    }


def _cause(one: Cause) -> dict[str, Any]:
    return {
        **_effect(one.effect),
        "parameters": _parameters(one.parameters),
        "evidence": {
            "p_value": one.p_value,
            "held_out_gain": one.held_out_gain,
            "evidence": one.evidence,
            "rms_um": _um(one.rms),
            "homogeneous_p": one.homogeneous_p,
        },
        "cannot_be_told_from": [
            {**_evidence(rival), "parameters": _parameters(rival.parameters)} for rival in one.rivals
        ],
        "or_changed": list(one.or_changed),
        "separating": "" if one.separating is None else separating_run(one.separating),
        "remainder": one.remainder,
        "sentence": one.sentence,
        "formula": one.formula,
        "amplitudes": [{"group": at.group, "value": at.value, "u": at.u} for at in one.amplitudes],
    }


def _parameters(parameters: Sequence[Estimate]) -> dict[str, Any]:
    return {one.name: {"value": one.value, "u": one.u, "unit": one.unit} for one in parameters}


def _effect(effect: Effect) -> dict[str, Any]:
    """The keys of an [[effect]], `effect` for its kind; of an instrument where it acts on no component."""
    of = {"of": "instrument"} if effect.component is None else {"component": effect.component}
    told: dict[str, Any] = {"effect": effect.kind, **of}
    if effect.axis:
        told["axis"] = effect.axis
    if effect.runs:
        told["runs"] = list(effect.runs)
    if effect.end:
        told["end"] = effect.end
    return told


def _evidence(one: Evidence) -> dict[str, Any]:
    return {
        **_effect(one.effect),
        "evidence": one.evidence,
        "p_value": one.p_value,
        "tries": one.tries,
        "freedom": one.freedom,
    }


def _limit(one: Limit) -> dict[str, Any]:
    return {
        **_effect(one.effect),
        "state": one.state,
        "reason": one.reason,
        "parameter": one.size,
        "unit": one.unit,
        "detection": one.detection,
        "isolation": one.isolation,
        "share": one.share,
        "nearest": None if one.nearest is None else _effect(one.nearest),
        "r2": one.r2,
    }


def _of_angles(angles: GainOfAngles | None) -> dict[str, Any]:
    """What was gained of readings of angles, urad; nothing where there are none."""
    if angles is None:
        return {}
    rms, held_out = _stage(angles.rms), _stage(angles.held_out)
    return {"rms_urad": rms, "held_out_rms_urad": held_out, "floor_urad": _um(angles.floor)}


def _noise(one: NoiseOf) -> dict[str, Any]:
    """In um, of an angle instrument in urad."""
    unit = small_unit(one.instrument)
    return {
        "instrument": one.instrument,
        "group": one.group,
        f"white_{unit}": _um(one.white),
        f"correlated_{unit}": _um(one.correlated),
        "correlation": one.correlation,
        f"settles_{unit}": _um(one.settles),
        f"wanders_{unit}": _um(one.wanders),
        f"places_{unit}": _um(one.places),
        "freedom": one.freedom if one.origin in ESTIMATED else None,
        "origin": one.origin,
    }


def _stage(stage: Stage) -> dict[str, float]:
    return {"given": _um(stage.given), "refitted": _um(stage.refitted), "extended": _um(stage.extended)}


def _um(length: float) -> float:
    return 1e3 * length


def _plain(value: Any) -> Any:
    """Without NumPy's types, without numbers that JSON does not know, minus signs as programs have them."""
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, str):
        return value.replace("\N{MINUS SIGN}", "-")
    return None if isinstance(value, float) and not math.isfinite(value) else value
