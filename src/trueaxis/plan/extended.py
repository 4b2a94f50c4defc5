"""A plan with runs added, as a folder of measured data: the text of its setup kept, new runs behind it."""

import tomllib
from collections.abc import Sequence

import numpy as np

from trueaxis.faults import Fault, InputError
from trueaxis.measure.approach import approach_directions
from trueaxis.measure.reading_model import home_positions
from trueaxis.measure.readings import Readings
from trueaxis.measure.setup import Run
from trueaxis.measure.setup_writer import run_table
from trueaxis.plan.candidates import Candidate


def setup_text(given: str, added: Sequence[Candidate], file: str) -> str:
    """The text of setup.toml with a [[run]] table for every run added.

    file: named in the fault. Raises InputError where tables cannot be added to the text.
    """
    text = given.rstrip("\n") + "\n" + "".join(f"\n# {one.what}\n{run_table(one.run)}" for one in added)
    try:
        count = len(tomllib.loads(text)["run"])
    except tomllib.TOMLDecodeError:
        count = 0
    if count != len(tomllib.loads(given)["run"]) + len(added):
        problem = "runs cannot be added behind its text"
        raise InputError([Fault(file, "key run", problem, "write the runs as [[run]] tables")])
    return text


def with_runs(given: Readings, added: Sequence[Candidate]) -> Readings:
    """The readings with empty rows for every run added."""
    counts = [one.positions.shape[1] for one in added]
    seq = [np.arange(count) for count in counts]
    index = np.repeat(np.arange(len(added)) + len(given.run_ids), counts)
    directions = [
        approach_directions(number, one.positions, _start(one.run, given.axes))
        for number, one in zip(seq, added, strict=True)
    ]
    empty = np.full(sum(counts), np.nan)

    def longer(column: np.ndarray | None) -> np.ndarray | None:
        return None if column is None else np.concatenate([column, empty])

    return Readings(
        axes=given.axes,
        run_ids=(*given.run_ids, *(one.run.id for one in added)),
        run=np.concatenate([given.run, index]),
        seq=np.concatenate([given.seq, *seq]),
        positions=np.hstack([given.positions, *(one.positions for one in added)]),
        directions=np.hstack([given.directions, *directions]),
        reading=np.concatenate([given.reading, empty]),
        given_directions=given.given_directions,
        time=longer(given.time),
        feed=longer(given.feed),
        temperature=longer(given.temperature),
    )


def _start(run: Run, axes: Sequence[str]) -> "np.ndarray | None":
    home = home_positions(run, axes)
    return None if home is None else home[:, 0]
