"""Runs of instrument files as the texts of a data folder: setup.toml, with what was assumed, and readings.csv."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from trueaxis.instrument_files.data_run import DataRun
from trueaxis.instrument_files.user_keys import RunKeys
from trueaxis.io.safe_text import shown
from trueaxis.measurement.approach import approach_directions
from trueaxis.measurement.instrument_run import FloatArray, InstrumentRun
from trueaxis.measurement.limits import LONGEST_ID
from trueaxis.measurement.readings import Readings, dump_readings
from trueaxis.measurement.setup import run_table, toml_text

HEAD = "# Made by `trueaxis import`. What is marked `assumed` does not stand in the instrument files.\n"
# keys of --map that stand within a key of setup.toml
_WITHIN = {"target.point": "target", "reference.point": "reference"}


def renamed(runs: tuple[DataRun, ...]) -> tuple[DataRun, ...]:
    """The runs with ids of their own: files of different folders may have one name."""
    seen: set[str] = set()
    result = []
    for item in runs:
        name, number = item.run.id, 1
        while name in seen:
            number += 1
            ending = f"-{number}"
            name = item.run.id[: LONGEST_ID - len(ending)] + ending
        seen.add(name)
        result.append(replace(item, run=replace(item.run, id=name)))
    return tuple(result)


def setup_text(runs: Sequence[DataRun], machine: str, compensation: str | None) -> str:
    """The text of setup.toml. compensation: its value, None where nothing is known of it."""
    lines = [HEAD, f"schema = 1\nmachine = {toml_text(machine)}\n"]
    if compensation is not None:
        lines.append(f"compensation = {toml_text(compensation)}  # assumed: given by the user\n")
    report = report_texts([item.source for item in runs])
    if report:
        lines.append("\n[report]\n")
        lines += [f"{toml_text(key)} = {toml_text(value)}\n" for key, value in report.items()]
    for item in runs:
        lines.append(f"\n# {_name(item.source.file)}\n")
        behind, above = _assumptions(item.assumed)
        lines += [f"# assumed: {shown(sentence)}\n" for sentence in (*item.remarks, *above)]
        lines.append(run_table(item.run, behind))
    return "".join(lines)


def report_texts(sources: Sequence[InstrumentRun]) -> dict[str, str]:
    """The texts for [report]: under their own name where all files agree, else a line for each of them."""
    texts: dict[str, dict[str, list[str]]] = {}
    for source in sources:
        for key, value in source.report.items():
            texts.setdefault(key, {}).setdefault(value, []).append(_name(source.file))
    return {
        key: next(iter(values))
        if len(values) == 1
        else "; ".join(f"{value} ({', '.join(dict.fromkeys(files))})" for value, files in values.items())
        for key, values in texts.items()
    }


def readings_bytes(runs: Sequence[DataRun], axes: tuple[str, ...]) -> bytes:
    """The content of readings.csv."""
    counts = [item.reading.size for item in runs]
    seq = [np.arange(1, count + 1) for count in counts]
    given = tuple(
        axis
        for row, axis in enumerate(axes)
        if any(item.directions is not None and item.directions[row].any() for item in runs)
    )
    readings = Readings(
        axes=axes,
        run_ids=tuple(item.run.id for item in runs),
        run=np.repeat(np.arange(len(runs)), counts),
        seq=np.concatenate(seq),
        positions=np.hstack([item.positions for item in runs]),
        directions=np.hstack([_directions(item, order, axes) for item, order in zip(runs, seq, strict=True)]),
        reading=np.concatenate([item.reading for item in runs]),
        given_directions=given,
        time=_column(runs, lambda source: source.time),
        feed=_column(runs, lambda source: source.feed),
        temperature=_column(runs, lambda source: source.temperature),
    )
    return dump_readings(readings, [item.run for item in runs])


def _directions(item: DataRun, seq: "np.ndarray", axes: Sequence[str]) -> "np.ndarray":
    found = approach_directions(item.run, axes, seq, item.positions)
    return found if item.directions is None else np.where(item.directions != 0, item.directions, found)


def _column(runs: Sequence[DataRun], of: Callable[[InstrumentRun], FloatArray | None]) -> FloatArray | None:
    columns = [of(item.source) for item in runs]
    if all(column is None for column in columns):
        return None
    return np.concatenate(
        [
            np.full(item.reading.size, np.nan) if column is None else column
            for item, column in zip(runs, columns, strict=True)
        ]
    )


def _assumptions(assumed: RunKeys) -> tuple[dict[str, str], list[str]]:
    """Comments behind keys of setup.toml, and sentences on what has no key there."""
    behind: dict[str, set[str]] = {}
    above = []
    for key in assumed.sources:
        within = "home" if key.startswith("home.") else _WITHIN.get(key, key)
        if within in ("instrument", "direction", "frame", "target", "reference", "home", "length"):
            behind.setdefault(within, set()).add(assumed.why(key))
        elif within != "id":
            above.append(f"{key} = {assumed.values[key]}, {assumed.why(key)}")
    return {key: f"assumed: {' and '.join(sorted(why))}" for key, why in behind.items()}, above


def _name(file: str) -> str:
    return shown(Path(file).name)
