"""Compensation files read as the controls' manuals say, by code that shares nothing with the package.

Each reader gives, by (axis that is corrected, axis by whose position), the positions and by how much the control takes
the axis to be off there: (n,), (n,) forward and (n,) backward.
"""

import re
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
Tables = Mapping[tuple[str, str], tuple[FloatArray, FloatArray, FloatArray]]

_ENC = re.compile(r"\$AA_ENC_COMP(_[A-Z_]+)?\[0,(?:(\d+),)?([XYZABC])1\]=(-?[0-9.]+)")
_CEC = re.compile(r"\$AN_CEC(_[A-Z_]+)?\[(\d+)(?:,(\d+))?\]=(?:(-?[0-9.]+)|\(([XYZABC])1\))")


def siemens_enc(text: str) -> Tables:
    """A positive value moves the axis in the negative direction: it takes the axis to be too far by the value."""
    found: dict[str, dict[str, dict[int, float]]] = {}
    for line in _statements(text):
        name, index, axis, value = _match(_ENC, line)
        found.setdefault(axis, {}).setdefault(name or "", {})[int(index or 0)] = float(value)
    return {(axis, axis): _regular(parts) for axis, parts in found.items()}


def siemens_cec(text: str) -> Tables:
    found: dict[int, dict[str, dict[int, float]]] = {}
    axes: dict[int, dict[str, str]] = {}
    for line in _statements(text):
        name, table, index, value, axis = _match(_CEC, line)
        if axis:
            axes.setdefault(int(table), {})[name] = axis
        else:
            found.setdefault(int(table), {}).setdefault(name or "", {})[int(index or 0)] = float(value)
    assert sorted(found) == list(range(len(found)))
    return {(axes[t]["_OUTPUT_AXIS"], axes[t]["_INPUT_AXIS"]): _regular(parts) for t, parts in found.items()}


def _statements(text: str) -> list[str]:
    lines = [line for line in text.splitlines() if not line.startswith(";")]
    assert lines[0].startswith("%_N_")
    assert lines[0].endswith("_INI")
    assert lines[1] == "CHANDATA(1)"
    assert lines[-1] == "M17"
    return lines[2:-1]


def _match(pattern: re.Pattern[str], line: str) -> tuple[str, ...]:
    match = pattern.fullmatch(line)
    assert match is not None, line
    return match.groups()


def _regular(parts: Mapping[str, Mapping[int, float]]) -> tuple[FloatArray, FloatArray, FloatArray]:
    step, low, high = (parts[f"_{name}"][0] for name in ("STEP", "MIN", "MAX"))
    assert parts["_IS_MODULO"][0] == 0
    count = round((high - low) / step) + 1
    assert sorted(parts[""]) == list(range(count)), "gaps keep values of earlier tables"
    values = np.array([parts[""][index] for index in range(count)])
    return np.array([low + step * index for index in range(count)]), values, values


def linuxcnc(folder: Path, axes: str = "XYZ") -> Tables:
    """src/emc/motion/usrmotintf.cc: nominal, forward, reverse. Added to the command is, with a file of type 0, nominal
    less forward, and forward itself with one of type 1.
    """
    found = {}
    for joint, block in enumerate((folder / "joints.ini").read_text().strip().split("\n\n")):
        head, file, kind = block.splitlines()
        assert head == f"[JOINT_{joint}]"
        assert kind in ("COMP_FILE_TYPE = 0", "COMP_FILE_TYPE = 1")
        rows = np.loadtxt(folder / file.removeprefix("COMP_FILE = "))
        assert (np.diff(rows[:, 0]) > 0).all()
        assert len(rows) <= 256
        trim = rows[:, 1:] if kind.endswith("1") else rows[:, :1] - rows[:, 1:]
        found[axes[joint], axes[joint]] = rows[:, 0], -trim[:, 0], -trim[:, 1]
    return found


def heidenhain(folder: Path) -> Tables:
    """[axis of the column of *.com] = F(axis of the column of *.cma in which the *.com is entered)."""
    head, row = _table(folder / "config.cma")
    assert (head[:2], row[:2]) == (["NR", "ACTIVE"], ["0", "*"])
    found = {}
    for by, file in zip(head[2:], row[2:], strict=True):
        columns, *rows = _table(folder / file)
        assert [line[0] for line in rows] == [str(number) for number in range(len(rows))]
        assert len(rows) <= 256
        cells = {name: np.array([float(line[at]) for line in rows]) for at, name in enumerate(columns)}
        for of in (name for name in columns if len(name) == 1):
            back = cells.get("BACKLASH", cells[of]) if of == by else cells[of]
            found[of, by] = cells["AXISPOS"], cells[of], back
    return found


def _table(path: Path) -> list[list[str]]:
    lines = path.read_text().splitlines()
    assert lines[0] == f"BEGIN {path.name.upper()} MM"
    assert lines[-1] == "[END]"
    return [line.split() for line in lines[1:-1]]


IsgTables = dict[str, tuple[dict[str, FloatArray], dict[str, FloatArray]]]


def isg(text: str) -> tuple[dict[str, FloatArray], IsgTables]:
    """Points (by their first two characters and axis) and, by axis, arguments by letter and components."""
    blocks = text.split("#\n")
    points: dict[str, FloatArray] = {}
    tables: IsgTables = {}
    for block in blocks:
        lines = [line.split() for line in block.splitlines() if not line.startswith("//")]
        cells = dict(zip(lines[0], np.array([[float(cell) for cell in line] for line in lines[1:]]).T, strict=True))
        if lines[0][0] in "XYZABC":
            arguments = {name: cells.pop(name) for name in lines[0] if len(name) == 1}
            tables[next(iter(cells))[2]] = arguments, cells
            continue
        for name in ("P0", *(f"P{axis}" for axis in "ABC")):
            letters = [f"P{c}0" if name == "P0" else f"P{c}{name[1]}" for c in "XYZ"]
            keys = [f"P0{c}" for c in "XYZ"] if name == "P0" else letters
            if keys[0] in cells:
                points[name] = np.array([cells[key][0] for key in keys])
    return points, tables


def isg_value(arguments: Mapping[str, FloatArray], column: FloatArray, position: Mapping[str, float]) -> float:
    """Interpolation `GRID` (P-VOLC-00014): linear in each argument, on rows that are a grid in any order."""
    if not arguments:
        (value,) = column
        return float(value)
    name, *others = arguments
    places = np.unique(arguments[name])
    values = []
    for place in places:
        rows = arguments[name] == place
        values.append(isg_value({other: arguments[other][rows] for other in others}, column[rows], position))
    return float(np.interp(position[name], places, values))
