"""Runs as text of setup.toml."""

import json
from collections.abc import Mapping

from trueaxis.io.plain_text import escaped
from trueaxis.measurement.setup import PointOn, Run


def run_table(run: Run, comments: Mapping[str, str] | None = None) -> str:
    """A [[run]] table that reads back as the run; its device is named alone.

    comments: key -> what stands behind its line.
    """
    lines = {"id": toml_text(run.id), "instrument": toml_text(run.instrument)}
    if run.device is not None:
        lines["device"] = toml_text(run.device.id)
    if run.session:
        lines["session"] = toml_text(run.session)
    if run.length is not None:
        lines["length"] = repr(run.length)
    if run.direction is not None:
        lines["direction"] = repr(list(run.direction))
        lines["frame"] = toml_text(run.frame)
    lines["target"] = _point(run.target)
    lines["reference"] = _point(run.reference)
    if run.length is None:
        lines["home"] = f"{{ {', '.join(f'{axis} = {value!r}' for axis, value in run.home.items())} }}"
    if run.normalised is not None:
        lines["normalised_ppm_k"] = repr(run.normalised)
    said = comments or {}
    return "[[run]]\n" + "".join(
        f"{key} = {value}" + (f"  # {escaped(said[key])}" if key in said else "") + "\n" for key, value in lines.items()
    )


def toml_text(text: str) -> str:
    """A text in the quotes of TOML, whatever is in it."""
    return json.dumps(escaped(text), ensure_ascii=False)


def _point(end: PointOn) -> str:
    if end.on == "bed":
        return '{ on = "bed" }'
    return f'{{ on = "{end.on}", point = {list(end.point)!r} }}'
