"""Tables of readings with named columns and units, of a laser, a probe, an angle instrument or a ball bar."""

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np

from trueaxis.evaluation.positioning_table_file import NEGATIVE, POSITIVE
from trueaxis.instrument_files.conventions import ONE_WAY, passes_of
from trueaxis.instrument_files.user_keys import RunKeys, UserKeys
from trueaxis.io.faults import Faults
from trueaxis.io.safe_text import shown
from trueaxis.measurement.delimited import (
    DelimitedText,
    Dimension,
    Heading,
    called,
    decimal,
    factor,
    heading,
    read_delimited,
    units_of,
)
from trueaxis.measurement.instrument_run import FloatArray, InstrumentRun, approach_of_passes
from trueaxis.measurement.limits import LONGEST_ID

MOST_FAULTS = 20
LONGEST_SHOWN, LONGEST_HEADER = 40, 200  # characters in a message
LINEAR, ROTARY = "xyz", "abc"
ANGLES = ("pitch", "yaw", "roll", "tilt", "slope")  # names of readings; a table may have several of them

# what a column holds, by the names that headers give it
NAMES: Mapping[str, tuple[str, ...]] = {
    "reading": ("reading", "deviation", "error", *ANGLES),
    "measured": ("measured", "actual"),
    "target": ("target", "position", "nominal"),
    "angle": ("angle", "theta"),
    "radius": ("radius", "length", "distance"),
    **{axis: (axis,) for axis in LINEAR + ROTARY},
    "run": ("run",),
    "direction": ("direction",),
    "time": ("time",),
    "feed": ("feed",),
    "temperature": ("temperature",),
}
OF_BALL_BAR = ("angle", "radius")  # beside a column target `angle` is what was read
DIFFERENCE = ("measured", "target")  # of which the reading is made where there is no other
DIRECTIONS = {**dict.fromkeys(POSITIVE, 1), **dict.fromkeys(NEGATIVE, -1), "0": 0}
ORDER = "rows were read in the order of the file"


def read_csv(path: Path, keys: UserKeys, *, ballbar: bool = False) -> tuple[InstrumentRun, ...]:
    """Read a table, a run for every value of its column `run` and, where it has several of ANGLES, for each of them.

    ballbar: of a ball bar, else whatever its columns say. Raises InputError with every fault of the file; what it does
    not say is a question in `keys`.
    """
    table = read_delimited(path)
    angles = [head.text for head in map(heading, table.header) if head.name in ANGLES]
    if len(angles) < 2 or keys.of_run(str(path), path.stem).said("column.reading"):
        return _runs(path, table, keys, ballbar, None)
    return tuple(run for reading in angles for run in _runs(path, table, keys, ballbar, reading))


def _runs(
    path: Path, table: DelimitedText, keys: UserKeys, ballbar: bool, of_several: str | None
) -> tuple[InstrumentRun, ...]:
    """of_several: the head of the column of readings where the table has several."""
    faults = Faults(str(path))
    of_file = keys.of_run(str(path), path.stem)
    columns = _columns(table, of_file, faults, of_several)
    ballbar = ballbar or _of_ball_bar(columns)
    if not ballbar and "angle" in columns:
        columns.setdefault("reading", columns.pop("angle"))
    _check(columns, ballbar, table, faults)
    faults.raise_if_any()
    scales = {
        name: _scale(name, columns[name][1], of_file, faults, table, ballbar) for name in columns if _dimension(name)
    }
    numbers = {name: _numbers(table, columns[name], scale, faults) for name, (_, scale) in scales.items()}
    angles = not ballbar and _are_angles(scales, columns, faults)
    ids = _run_ids(table, columns, path.stem, faults)
    directions = _directions(table, columns, faults)
    faults.raise_if_any()
    instrument: Literal["ballbar", "angle"] | None = "ballbar" if ballbar else "angle" if angles else None
    runs = []
    for name in dict.fromkeys(ids):
        rows = np.array([row for row, of in enumerate(ids) if of == name])
        values = {key: column[rows] for key, column in numbers.items()}
        whole = name if of_several is None else f"{name}-{heading(of_several).name}"
        one = _run(str(path), whole, values, None if directions is None else directions[rows], instrument)
        runs.append(replace(one, assumed=(*one.assumed, *of_file.sentences()), unused=_unused(table, columns)))
    return tuple(runs)


def _unused(table: DelimitedText, columns: Mapping[str, tuple[int, Heading]]) -> tuple[str, ...]:
    """Heads of the columns that nothing is taken from; other angles are runs of their own."""
    used = {index for index, _ in columns.values()}
    return tuple(one for k, one in enumerate(table.header) if k not in used and heading(one).name not in ANGLES)


def is_ball_bar(header: tuple[str, ...]) -> bool:
    """Whether columns of these heads are those of a ball bar."""
    names = [heading(text).name for text in header]
    return _of_ball_bar({of for of, synonyms in NAMES.items() if not set(synonyms).isdisjoint(names)})


def _of_ball_bar(columns: Collection[str]) -> bool:
    return "target" not in columns and any(name in columns for name in OF_BALL_BAR)


def _columns(
    table: DelimitedText, keys: RunKeys, faults: Faults, of_several: str | None
) -> dict[str, tuple[int, Heading]]:
    """Which column of the table, and with which unit, holds what. of_several: see `_runs`."""
    heads = [heading(text) for text in table.header]
    found: dict[str, tuple[int, Heading]] = {}
    for name, synonyms in NAMES.items():
        said = keys.said(f"column.{name}") or (of_several if name == "reading" else None)
        matching = called(said, heads) if said else [k for k, head in enumerate(heads) if head.name in synonyms]
        if said and not matching:
            keys.wrong(f"column.{name}", said, f"a column of the header, line {table.header_line}: {_listed(table)}")
        if len(matching) > 1:
            problem = " and ".join(heads[index].text for index in matching) + f" could both be the {name}"
            faults.add(f"line {table.header_line}", problem, f"--map column.{name}=NAME says which")
        if matching:
            head = heads[matching[0]]
            unit = table.units[matching[0]].strip("[]()").strip().lower() if table.units else head.unit
            found[name] = matching[0], Heading(head.text, name, unit)
    return found


def _check(columns: Mapping[str, tuple[int, Heading]], ballbar: bool, table: DelimitedText, faults: Faults) -> None:
    axes = [name for name in LINEAR + ROTARY if name in columns]
    line, has = f"line {table.header_line}", f"its columns: {_listed(table)}"
    if ballbar and "reading" not in columns and "radius" not in columns:
        right = f"a column deviation or radius; --map column.reading=NAME ({has})"
        faults.add(line, "has no readings of a ball bar", right)
    if ballbar and "angle" not in columns and len(axes) < 2:
        faults.add(line, "does not say where the ball bar was read", f"a column angle, or two axes ({has})")
    if not ballbar and "reading" not in columns and not {"measured", "target"} <= columns.keys():
        right = f"a column reading, deviation or error, or measured beside target; --map column.reading=NAME ({has})"
        faults.add(line, "has no readings", right)
    if not ballbar and "target" not in columns and not axes:
        right = f"a column target (ball bar: angle) or X, Y, ...; --map column.target=NAME ({has})"
        faults.add(line, "has no positions", right)


def _listed(table: DelimitedText) -> str:
    return shown(", ".join(table.header), LONGEST_HEADER)


def _dimension(name: str) -> Dimension | None:
    if name in ("run", "direction"):
        return None
    if name in ("time", "feed", "temperature"):
        return name  # type: ignore[return-value]
    return "angle" if name == "angle" or name in ROTARY else "length"


def _numbers(table: DelimitedText, column: tuple[int, Heading], scale: float, faults: Faults) -> FloatArray:
    """A column in mm, deg, s, mm/min or degC, (n,); wrong cells are noted."""
    index, head = column
    values = np.zeros(len(table.rows))
    wrong = 0
    for row, cells in enumerate(table.rows):
        value = decimal(cells[index])
        if value is None:
            wrong += 1
            if wrong <= MOST_FAULTS:
                cell = f'"{shown(cells[index], LONGEST_SHOWN)}" is not a number' if cells[index] else "is empty"
                faults.add(f"line {table.lines[row]}, column {shown(head.text, LONGEST_SHOWN)}", cell, "a number")
        values[row] = (value or 0.0) * scale
    if wrong > MOST_FAULTS:
        faults.add(f"column {shown(head.text, LONGEST_SHOWN)}", f"and so {wrong - MOST_FAULTS} more cells")
    return values


def _scale(
    name: str, head: Heading, keys: RunKeys, faults: Faults, table: DelimitedText, ballbar: bool
) -> tuple[Dimension, float]:
    """Of what the numbers of a column are, and what one of them is in mm, deg, s, mm/min or degC."""
    may_be = _dimensions(name, head, ballbar)
    own, right = _of_unit(head.unit, may_be), units_of(*may_be)
    said = keys.said(f"unit.{name}")
    if said is None and head.unit:
        if own is None:
            place = f"line {table.header_line}, column {shown(head.text, LONGEST_SHOWN)}"
            faults.add(place, f'unit "{shown(head.unit, LONGEST_SHOWN)}" is none of its {name}', right)
        return own or (may_be[0], 1.0)
    default = None if name in ("reading", "measured", "radius") else _usual(name)
    example = default or ("urad" if may_be == ("angle",) else "um")
    unit = keys.text(f"unit.{name}", f"the unit of its column {head.text}", example, default=default)
    if unit is None:
        return may_be[0], 1.0
    found = _of_unit(unit, may_be)
    if found is None:
        keys.wrong(f"unit.{name}", said or unit, f"one of {right}")
    elif own is not None and own != found:
        keys.wrong(f"unit.{name}", said or unit, f"the file's own unit, {head.unit}: leave the key out")
    return found or (may_be[0], 1.0)


def _dimensions(name: str, head: Heading, ballbar: bool) -> tuple[Dimension, ...]:
    """Of what the numbers of a column may be, the usual first."""
    if heading(head.text).name in (*ANGLES, "angle"):
        return ("angle",)
    usual = _dimension(name) or "length"
    if name == "target" or (name in ("reading", "measured") and not ballbar):
        return usual, "angle"  # targets of a rotary axis, readings of an angle instrument
    return (usual,)


def _of_unit(unit: str, may_be: Sequence[Dimension]) -> tuple[Dimension, float] | None:
    return next(((one, scale) for one in may_be if (scale := factor(unit, one)) is not None), None)


def _are_angles(
    scales: Mapping[str, tuple[Dimension, float]], columns: Mapping[str, tuple[int, Heading]], faults: Faults
) -> bool:
    """Whether what was read are angles; positions that are measured must be of what their targets are."""
    if "reading" in scales:
        return scales["reading"][0] == "angle"
    measured, target = (scales[name][0] for name in DIFFERENCE)
    if measured != target:
        names = " and ".join(columns[name][1].text for name in DIFFERENCE)
        faults.add("", f"{names} are lengths and angles: no difference can be taken", "units of one kind")
    return measured == "angle"


def _usual(name: str) -> str:
    return {"time": "s", "feed": "mm/min", "temperature": "degC"}.get(
        name, "deg" if _dimension(name) == "angle" else "mm"
    )


def _run_ids(table: DelimitedText, columns: Mapping[str, tuple[int, Heading]], stem: str, faults: Faults) -> list[str]:
    if "run" not in columns:
        return [stem] * len(table.rows)
    index = columns["run"][0]
    ids = [cells[index] for cells in table.rows]
    for row, name in enumerate(ids):
        if (not name or not name.isprintable() or len(name) > LONGEST_ID) and len(faults.found) < MOST_FAULTS:
            faults.add(f"line {table.lines[row]}, column run", "is no name of a run", f"up to {LONGEST_ID} characters")
    return ids


def _directions(
    table: DelimitedText, columns: Mapping[str, tuple[int, Heading]], faults: Faults
) -> "np.ndarray | None":
    if "direction" not in columns:
        return None
    index = columns["direction"][0]
    found = np.zeros(len(table.rows), dtype=np.int8)
    for row, cells in enumerate(table.rows):
        direction = DIRECTIONS.get(cells[index].lower())
        if direction is None and len(faults.found) < MOST_FAULTS:
            cell = shown(cells[index], LONGEST_SHOWN)
            faults.add(f"line {table.lines[row]}, column direction", f'"{cell}" is no direction', "+1, -1 or 0")
        found[row] = direction or 0
    return found


def _run(
    file: str,
    name: str,
    values: Mapping[str, FloatArray],
    directions: "np.ndarray | None",
    instrument: Literal["ballbar", "angle"] | None,
) -> InstrumentRun:
    ballbar = instrument == "ballbar"
    targets = values.get("target")
    reading = values["reading"] if "reading" in values else values.get("radius")
    if reading is None:
        reading = values["measured"] - values["target"]
    if instrument == "angle":
        reading = np.radians(reading)
    one_way = False
    if directions is None and targets is not None:
        passes, one_way = passes_of(targets)
        directions = approach_of_passes(passes, targets)
    return InstrumentRun(
        file=file,
        id=re.sub(r"\s+", " ", name).strip(),
        instrument=instrument,
        reading=reading,
        whole_length=ballbar and "reading" not in values,
        targets=None if ballbar else targets,
        positions={axis.upper(): values[axis] for axis in LINEAR + ROTARY if axis in values},
        angle=np.radians(values["angle"]) if "angle" in values else None,
        directions=None if ballbar else directions,
        time=values.get("time"),
        feed=values.get("feed"),
        temperature=values.get("temperature"),
        assumed=(ORDER, ONE_WAY) if one_way else (ORDER,),
    )
