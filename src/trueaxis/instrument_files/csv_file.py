"""Tables of readings with named columns and units, of a laser, a probe or a ball bar."""

import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from trueaxis.evaluation.iso230_2.table_file import NEGATIVE, POSITIVE
from trueaxis.instrument_files.user_keys import RunKeys, UserKeys
from trueaxis.io.faults import Faults
from trueaxis.io.plain_text import shown
from trueaxis.measurement.delimited import (
    DelimitedText,
    Dimension,
    Heading,
    decimal,
    factor,
    heading,
    read_delimited,
    units_of,
)
from trueaxis.measurement.instrument_run import FloatArray, InstrumentRun, approach_of_passes
from trueaxis.measurement.limits import LONGEST_ID

MOST_FAULTS = 20
LONGEST_SHOWN = 40
LINEAR, ROTARY = "xyz", "abc"

# what a column holds, by the names that headers give it
NAMES: Mapping[str, tuple[str, ...]] = {
    "reading": ("reading", "deviation", "error"),
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
OF_BALL_BAR = ("angle", "radius")
DIRECTIONS = {**dict.fromkeys(POSITIVE, 1), **dict.fromkeys(NEGATIVE, -1), "0": 0}
ORDER = "rows were read in the order of the file"


def read_csv(path: Path, keys: UserKeys, *, ballbar: bool = False) -> tuple[InstrumentRun, ...]:
    """Read a table, a run for every value of its column `run`. ballbar: of a ball bar, else whatever its columns say.

    Raises InputError with every fault of the file; what it does not say is a question in `keys`.
    """
    table = read_delimited(path)
    faults = Faults(str(path))
    of_file = keys.of_run(str(path), path.stem)
    columns = _columns(table, of_file, faults)
    ballbar = ballbar or any(name in columns for name in OF_BALL_BAR)
    _check(columns, ballbar, faults)
    faults.raise_if_any()
    numbers = {name: _numbers(table, columns[name], name, of_file, faults) for name in columns if _dimension(name)}
    ids = _run_ids(table, columns, path.stem, faults)
    directions = _directions(table, columns, faults)
    faults.raise_if_any()
    runs = []
    for name in dict.fromkeys(ids):
        rows = np.array([row for row, of in enumerate(ids) if of == name])
        values = {key: column[rows] for key, column in numbers.items()}
        one = _run(str(path), name, values, None if directions is None else directions[rows], ballbar)
        runs.append(replace(one, assumed=(*one.assumed, *of_file.sentences())))
    return tuple(runs)


def is_ball_bar(header: tuple[str, ...]) -> bool:
    """Whether columns of these heads are those of a ball bar."""
    return any(heading(text).name in NAMES[of] for text in header for of in OF_BALL_BAR)


def _columns(table: DelimitedText, keys: RunKeys, faults: Faults) -> dict[str, tuple[int, Heading]]:
    """Which column of the table, and with which unit, holds what."""
    heads = [heading(text) for text in table.header]
    found: dict[str, tuple[int, Heading]] = {}
    for name, synonyms in NAMES.items():
        said = keys.said(f"column.{name}")
        matching = [index for index, head in enumerate(heads) if (head.text == said if said else head.name in synonyms)]
        if said and not matching:
            keys.wrong(f"column.{name}", said, f"a column of the header, line {table.header_line}")
        if len(matching) > 1:
            names = " and ".join(heads[index].text for index in matching)
            remedy = f"--map column.{name}=NAME says which"
            faults.add(f"line {table.header_line}", f"{names} could both be the {name}", remedy)
        if matching:
            index = matching[0]
            unit = table.units[index].strip("[]()").strip().lower() if table.units else heads[index].unit
            found[name] = index, Heading(heads[index].text, name, unit)
    return found


def _check(columns: Mapping[str, tuple[int, Heading]], ballbar: bool, faults: Faults) -> None:
    axes = [name for name in LINEAR + ROTARY if name in columns]
    if ballbar:
        if "reading" not in columns and "radius" not in columns:
            faults.add("", "has no readings of a ball bar", "a column deviation or radius; --map column.reading=NAME")
        if "angle" not in columns and len(axes) < 2:
            faults.add("", "does not say where the ball bar was read", "a column angle, or one per axis that moved")
        return
    if "reading" not in columns and not {"measured", "target"} <= columns.keys():
        right = "a column reading, deviation or error, or measured beside target; --map column.reading=NAME"
        faults.add("", "has no readings", right)
    if "target" not in columns and not axes:
        faults.add("", "has no positions", "a column target, or one per axis; --map column.target=NAME")


def _dimension(name: str) -> Dimension | None:
    if name in ("run", "direction"):
        return None
    if name in ("time", "feed", "temperature"):
        return name  # type: ignore[return-value]
    return "angle" if name == "angle" or name in ROTARY else "length"


def _numbers(table: DelimitedText, column: tuple[int, Heading], name: str, keys: RunKeys, faults: Faults) -> FloatArray:
    """A column in mm, deg, s, mm/min or degC, (n,); wrong cells are noted."""
    index, head = column
    scale = _scale(name, head, keys, faults, table)
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


def _scale(name: str, head: Heading, keys: RunKeys, faults: Faults, table: DelimitedText) -> float:
    dimension = _dimension(name) or "length"
    unit = head.unit
    if name == "target" and factor(unit, "angle") is not None:
        dimension = "angle"  # of a rotary axis
    if (said := keys.said(f"unit.{name}")) is not None or not unit:
        default = None if name in ("reading", "measured", "radius") else _usual(name)
        meaning, right = f"the unit of its column {head.text}", f"one of {units_of(dimension)}"
        unit = keys.text(f"unit.{name}", meaning, "um" if default is None else default, default=default) or ""
        if not unit:
            return 1.0
        scale = factor(unit, dimension)
        own = factor(head.unit, dimension) if head.unit else None
        if scale is None:
            keys.wrong(f"unit.{name}", said or unit, right)
        elif own is not None and own != scale:
            keys.wrong(f"unit.{name}", said or unit, f"the file's own unit, {head.unit}: leave the key out")
        return scale or 1.0
    scale = factor(unit, dimension)
    if scale is None:
        place = f"line {table.header_line}, column {shown(head.text, LONGEST_SHOWN)}"
        faults.add(place, f'unit "{shown(unit, LONGEST_SHOWN)}" is none of its {name}', units_of(dimension))
    return scale or 1.0


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
    file: str, name: str, values: Mapping[str, FloatArray], directions: "np.ndarray | None", ballbar: bool
) -> InstrumentRun:
    targets = values.get("target")
    reading = values["reading"] if "reading" in values else values.get("radius")
    if reading is None:
        reading = values["measured"] - values["target"]
    if directions is None and targets is not None:
        directions = approach_of_passes(_passes(targets), targets)
    return InstrumentRun(
        file=file,
        id=re.sub(r"\s+", " ", name).strip(),
        instrument="ballbar" if ballbar else None,
        reading=reading,
        whole_length=ballbar and "reading" not in values,
        targets=None if ballbar else targets,
        positions={axis.upper(): values[axis] for axis in LINEAR + ROTARY if axis in values},
        angle=np.radians(values["angle"]) if "angle" in values else None,
        directions=None if ballbar else directions,
        time=values.get("time"),
        feed=values.get("feed"),
        temperature=values.get("temperature"),
        assumed=(ORDER,),
    )


def _passes(targets: FloatArray) -> "np.ndarray":
    """(n,): the number of the pass over the targets that each row belongs to: a new one where the way turns round.

    A row at the position of the one before begins the next pass: there the axis went beyond and came back.
    """
    passes = np.zeros(targets.size, dtype=np.int64)
    way = 0.0
    for row in range(1, targets.size):
        step = np.sign(targets[row] - targets[row - 1])
        turned = step == 0.0 or way not in (0.0, step)
        passes[row] = passes[row - 1] + turned
        way = 0.0 if turned and step == 0.0 else step
    return passes
