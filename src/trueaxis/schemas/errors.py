"""The schema of errors.json, error values (docs/files.md)."""

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
    values = {"basis": {"const": "table"}, "positions": numbers() | {"minItems": 1}, "values": numbers()}
    return {
        "oneOf": [
            table(polynomial, ["basis", "powers", "coefficients"]),
            table(legendre, ["basis", "range", "coefficients"]),
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
