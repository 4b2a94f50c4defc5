"""The schemas of TOML files, which people write.

machines/NAME.toml is a machine spec (docs/machine.md), setup.toml the runs of measured data (docs/files.md).
"""

from typing import get_args

from trueaxis.effects.library import ALL_DIRECTIONS, KINDS
from trueaxis.error_name import DIRECTIONS
from trueaxis.machine.body import FARTHEST
from trueaxis.machine.effect_kinds import LARGEST_GRID, MOST_KINDS, MOST_PARAMETERS
from trueaxis.machine.effects import ENDS
from trueaxis.machine.machine import AXES, REFERENCE_CODES
from trueaxis.machine.prior import LARGEST_SIZE, SIZES
from trueaxis.machine.read import LABEL, MOST_BODIES, NAME, ROTATIONS
from trueaxis.measurement.devices import LARGEST_PPM, LARGEST_UM, LARGEST_URAD
from trueaxis.measurement.instrument_kinds import ANGLE, INSTRUMENTS
from trueaxis.measurement.limits import FARTHEST_POINT, LONGEST_ID
from trueaxis.measurement.setup_reader import LARGEST_EXPANSION, LONGEST_BAR
from trueaxis.schemas.pieces import (
    FIRST_SCHEMA,
    NUMBER,
    TEXT,
    Schema,
    above_zero,
    among,
    array,
    by_name,
    document,
    numbers,
    said,
    table,
    where,
    within,
)
from trueaxis.view import Frame

_PARAMETER = r"^[A-Za-z][A-Za-z0-9_]*$"
_INTEGER: Schema = {"type": "integer"}
_LABEL = TEXT | {"maxLength": LONGEST_ID}
_SENSING = tuple(name for name in INSTRUMENTS if name != "ballbar")


def machine_schema() -> Schema:
    """Of a machine spec: bodies one by one, or a structure code."""
    by_code = {"required": ["structure"], "not": {"anyOf": [{"required": ["body"]}, {"required": ["ends"]}]}}
    by_body = {"required": ["body", "ends"], "not": {"required": ["structure"]}}
    return document(
        "Machine spec of trueaxis",
        "A machine tool as a tree of bodies, its errors, and what is expected of them.",
        table(
            {
                "schema": FIRST_SCHEMA,
                "name": said({"type": "string", "pattern": f"^{NAME}$"}, "folder and prefix of what is generated"),
                "title": said(TEXT, "heading of the generated files"),
                "structure": said(TEXT, "ISO 10791-6, such as [w C' Y' b X Z B t], or YFXZ, or XZB+YC"),
                "axis": said(table({axis: table(_joint()) for axis in AXES}), "what the axes of the structure are"),
                "workpiece": said(table(_fixed()), "where the workpiece stands on the last body of its side"),
                "tool": said(table(_fixed()), "where the tool stands on the last body of its side"),
                "body": said(array(_body(), minItems=1, maxItems=MOST_BODIES), "bodies; body 1, the bed, is implied"),
                "ends": said(table({"workpiece": _INTEGER, "tool": _INTEGER}, ["workpiece", "tool"]), "their numbers"),
                "curves": table({"degree": said(_INTEGER | {"minimum": 1, "maximum": 15}, "of polynomial kernels")}),
                "runs": said(TEXT, "a folder of measured data or a plan, whose systems are derived too"),
                "references": said(by_name(TEXT, LABEL), "numbers of equations in the literature"),
                "rotations": said(among(ROTATIONS), "of errors: the paper's matrix, or a true rotation"),
                "effect": said(array(_effect()), "what the machine has beside its geometric errors"),
                "effect_kind": said(array(_kind(), maxItems=MOST_KINDS), "kinds of effects of one's own"),
                "prior": _prior(),
                "start": said(_positions(), "axis positions before a program, mm and deg"),
                "reference_points": table({code: said(_positions(), f"where {code} goes") for code in REFERENCE_CODES}),
            },
            ["schema", "name"],
            oneOf=[by_code, by_body],
        ),
    )


def _fixed() -> dict[str, Schema]:
    """Keys of a body, whether it moves or not."""
    entry = {"anyOf": [within(-FARTHEST, FARTHEST), {"type": "string", "pattern": _PARAMETER}]}
    parameter = said({"type": "string", "pattern": _PARAMETER}, "name of the location error")
    return {
        "name": said(TEXT, "for people"),
        "sense": said({"enum": [1, -1]}, "-1 where a positive command moves the body the other way"),
        "position": said(array(entry, minItems=3, maxItems=3), "home position, mm or names of parameters"),
        "motion_errors": said(_motion_errors(), '"all", or a list such as ["EXY", "ECY"]'),
        "position_errors": said(table(dict.fromkeys(DIRECTIONS, parameter)), "location errors by direction"),
    }


def _joint() -> dict[str, Schema]:
    return _fixed() | {"travel": said(numbers(2), "lower and upper end, mm or deg")}


def _body() -> Schema:
    number = said(_INTEGER | {"minimum": 2}, "from 2, gaps allowed")
    lower = said(_INTEGER, "the body it stands on; 1 is the bed")
    moves = said(among(AXES), "the axis that moves it; absent: fixed")
    fixed = {"properties": {"travel": False, "sense": False, "motion_errors": {"maxItems": 0}}}
    return table(
        {"number": number, "lower": lower, "moves": moves} | _joint(),
        ["number", "lower"],
        **{"if": {"required": ["moves"]}, "then": {"required": ["travel"]}, "else": fixed},
    )


def _motion_errors() -> Schema:
    names = [str(direction.motion_error(axis)) for axis in AXES for direction in DIRECTIONS]
    return {"anyOf": [{"const": "all"}, array(among(names), maxItems=len(DIRECTIONS), uniqueItems=True)]}


def _effect() -> Schema:
    kinds = {"anyOf": [among(kind.name for kind in KINDS), {"type": "string", "pattern": "^[a-z][a-z0-9_]{0,39}$"}]}
    return table(
        {
            "kind": said(kinds, "of the library (docs/effects.md) or of the spec's own"),
            "component": said(TEXT, "the component error that it acts on, such as EXX"),
            "axis": said(among(AXES), "the other axis, where the kind takes one"),
            "runs": said(array(TEXT, minItems=1, uniqueItems=True), "the runs that it is in"),
            "end": said(among(ENDS), "which point is off"),
        },
        ["kind"],
    )


def _kind() -> Schema:
    parameter = table(
        {
            "unit": said(TEXT, "u (of the component), axis, mm, deg, rad, s, K, 1, joined by * and /"),
            "meaning": TEXT,
            "grid": said(array(NUMBER, minItems=1, maxItems=LARGEST_GRID, uniqueItems=True), "values to be searched"),
        },
        ["unit"],
    )
    return table(
        {
            "name": {"type": "string", "pattern": "^[a-z][a-z0-9_]{0,39}$"},
            "expression": said(TEXT, "the term, in the variables of its axis and its parameters"),
            "components": said(array(TEXT, minItems=1, uniqueItems=True), f"names, or {' '.join(ALL_DIRECTIONS)}"),
            "parameters": by_name(parameter, "[A-Za-z][A-Za-z0-9_]{0,39}") | {"maxProperties": MOST_PARAMETERS},
            "other_axis": {"type": "boolean"},
            "sentence": said(TEXT, "the cause in words, for reports"),
        },
        ["name", "expression", "components", "parameters"],
    )


def _prior() -> Schema:
    size = above_zero(LARGEST_SIZE)
    one = {"anyOf": [table({"um": size}, ["um"]), table({"urad": size}, ["urad"])]}
    sizes = {key: said(size, f"default {value:g}") for key, value in SIZES.items()}
    return said(
        {"type": "object", "properties": sizes, "additionalProperties": one},
        "sizes to expect, one standard deviation; a table for a component or location error of which more is known",
    )


def _positions() -> Schema:
    return table(dict.fromkeys(AXES, NUMBER))


def setup_schema() -> Schema:
    """Of setup.toml."""
    return document(
        "Set-up of measured data for trueaxis",
        "The runs of a folder: what each instrument read, of which points, in which direction.",
        table(
            {
                "schema": FIRST_SCHEMA,
                "machine": said(TEXT, "name of the machine"),
                "compensation": said(TEXT, '"none", or the error values that were active on the control'),
                "device": said(by_name(_device()), "instruments by name"),
                "report": said(by_name({"type": "string"}), "texts of your own, printed in reports"),
                "run": array(_run(), minItems=1),
            },
            ["schema", "machine", "run"],
        ),
    )


def _device() -> Schema:
    um, urad = above_zero(LARGEST_UM), above_zero(LARGEST_URAD)
    return table(
        {
            "serial": TEXT,
            "resolution_um": said(um, "step of its display"),
            "noise_um": said(um, "standard deviation of a reading"),
            "resolution_urad": said(urad, "of angle instruments"),
            "noise_urad": said(urad, "of angle instruments"),
            "length_u_um": said(um, "ball bar, probe: standard uncertainty of its length"),
            "scale_u_ppm": said(above_zero(LARGEST_PPM), "laser: standard uncertainty of its scale"),
            "line_u_urad": said(urad, "straightness: how well the direction of the line is known"),
        }
    )


def _run() -> Schema:
    return table(
        {
            "id": said(_LABEL, "the run's name in readings.csv"),
            "instrument": among(INSTRUMENTS),
            "direction": said(array(within(-1.000001, 1.000001), minItems=3, maxItems=3), "unit vector, in `frame`"),
            "frame": said(among(get_args(Frame)), "bed (default) or workpiece"),
            "target": said(_point(("tool", "workpiece")), "the moving optic, sensor or ball"),
            "reference": said(_point(("tool", "workpiece", "bed")), "the resting one (default: the bed)"),
            "home": said(table(dict.fromkeys(AXES, NUMBER)), "where the reading was set to zero"),
            "length": said(above_zero(LONGEST_BAR), "ball bar: nominal length, mm"),
            "device": said(_LABEL, "a table [device.ID]"),
            "session": said(_LABEL, "what was set up together"),
            "normalised_ppm_k": said(within(0.0, LARGEST_EXPANSION), "readings are normalised to 20 degC by this"),
        },
        ["id", "instrument", "target"],
        allOf=[
            where("instrument", ("ballbar",), {"required": ["length", "reference"]} | _without("direction")),
            where("instrument", _SENSING, {"required": ["direction"]} | _without("length")),
            where("instrument", (name for name in INSTRUMENTS if name != ANGLE), {"properties": _placed()}),
        ],
    )


def _without(key: str) -> Schema:
    return {"properties": {key: False}}


def _placed() -> dict[str, Schema]:
    """Points that have to be given: of every instrument but those of angles, and of every body but the bed."""
    given = where("on", ("tool", "workpiece"), {"required": ["point"]})
    return {"target": given, "reference": given}


def _point(carriers: tuple[str, ...]) -> Schema:
    coordinate = within(-FARTHEST_POINT, FARTHEST_POINT)
    point = said(numbers(3) | {"items": coordinate}, "in the frame of that body, mm")
    return table({"on": among(carriers), "point": point}, ["on"])
