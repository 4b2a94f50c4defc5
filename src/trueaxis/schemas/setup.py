"""The schema of setup.toml, the runs of measured data (docs/files.md)."""

from typing import get_args

from trueaxis.machine.machine import AXES
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

_LABEL = TEXT | {"maxLength": LONGEST_ID}
_SENSING = tuple(name for name in INSTRUMENTS if name != "ballbar")


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
