"""A sphere cycle whose centres are written along the bed and along the workpiece, as `plan` proposes it."""

from dataclasses import replace

import numpy as np

from tests.planning.data import model
from trueaxis.diagnosis.null_model.base import base_of
from trueaxis.diagnosis.null_model.frames import written_once
from trueaxis.diagnosis.null_model.noise import noise_of_runs
from trueaxis.diagnosis.null_model.rows import Rows, rows_of
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.readings import Readings
from trueaxis.measurement.setup import Setup
from trueaxis.model.model import MachineModel
from trueaxis.planning.candidates import Candidate, candidates
from trueaxis.planning.kit import Kit
from trueaxis.view import view_of

NOISE = 1e-3  # mm, of each coordinate of a centre


def cycle(machine: MachineModel) -> list[Candidate]:
    """C turns about a sphere: along x, y and z of the bed, and of the workpiece."""
    every = candidates(machine, Kit(instruments=("probe",), everywhere=False))
    return [one for one in every if "C turning at B0 about" in one.what]


def measured(machine: MachineModel, seed: int, keep: tuple[str, ...] = ("bed", "workpiece")) -> MeasuredData:
    """Noise alone, drawn along the bed for each pose; the workpiece turns with C."""
    draw = np.random.default_rng(seed)
    runs = [one for one in cycle(machine) if one.run.frame in keep]
    positions = np.hstack([one.positions for one in runs])
    count = [one.positions.shape[1] for one in runs]
    noise = draw.normal(0.0, NOISE, (3, count[0]))
    readings = []
    for one in runs:
        at, view = one.positions, view_of("workpiece", "bed")
        direction = np.array(one.run.direction)[:, np.newaxis]
        if one.run.frame == "workpiece":
            direction = machine.view_ideal(view, at, direction) - machine.view_ideal(view, at, np.zeros((3, 1)))
        readings.append(np.sum(direction * noise, axis=0))
    run = np.repeat(np.arange(len(runs)), count)
    return MeasuredData(
        Setup(machine=machine.name, runs=tuple(one.run for one in runs)),
        Readings(
            axes=machine.axes,
            run_ids=tuple(one.run.id for one in runs),
            run=run,
            seq=np.concatenate([np.arange(size) for size in count]),
            positions=positions,
            directions=np.ones(positions.shape, dtype=np.int8),
            reading=np.concatenate(readings),
        ),
    )


def noise_of(rows: Rows, machine: MachineModel) -> float:
    _, (noise,), _ = noise_of_runs(rows, base_of(machine, rows), rows.reading, None)
    return noise.sigma


def test_both_frames_hold_the_same_noise() -> None:
    """Each says what the other says: taken for two, noise may come out as next to none."""
    machine = model("dmu60p_5axis")
    rows = written_once(machine, rows_of(measured(machine, 1)))
    kept = {(rows.runs[index].frame, rows.runs[index].direction) for index in rows.present}
    assert kept == {("workpiece", (1.0, 0.0, 0.0)), ("workpiece", (0.0, 1.0, 0.0)), ("bed", (0.0, 0.0, 1.0))}
    assert 0.6 * NOISE < noise_of(rows, machine) < 1.6 * NOISE


def test_rows_that_say_more_are_kept() -> None:
    """Along the workpiece one direction alone: the bed's x says nothing where that is along it. At other places, or
    one after the other: all.
    """
    machine = model("dmu60p_5axis")
    data = measured(machine, 2)
    along_y = [
        k for k, run in enumerate(data.setup.runs) if (run.frame, run.direction) == ("workpiece", (0.0, 1.0, 0.0))
    ]
    some = np.where(data.readings.run == along_y, np.nan, data.readings.reading)
    every = rows_of(replace(data, readings=replace(data.readings, reading=some)))
    rows = written_once(machine, every)
    count = [rows.of_run(index) for index in rows.present]
    assert rows.size == 3 * data.readings.reading.size // 5  # of five coordinates at each place, three
    assert len(count) == 4  # x of the bed where C has turned the workpiece's away, y where it has not, z everywhere
    elsewhere = data.readings.positions.copy()
    bed = np.isin(data.readings.run, [k for k, run in enumerate(data.setup.runs) if run.frame == "bed"])
    elsewhere[0, bed] += 10.0
    every = rows_of(replace(data, readings=replace(data.readings, positions=elsewhere)))
    assert written_once(machine, every).size == every.size
    later = np.where(bed, 1e4, 0.0) + data.readings.seq.astype(np.float64)
    every = rows_of(replace(data, readings=replace(data.readings, time=later)))
    assert written_once(machine, every).size == every.size
