"""A fleet of simulated machines on worker processes: does every row come, how fast, what goes over the wire.

Run from the repository:
python -m benchmarks.fleet [--machines 200] [--broken 10] [--measured 24] [--rounds 3] [--only fleet some tasks draws]

First the whole fleet on two workers, one of which is killed on the way. Then some of its machines on one and on two
workers and in this process without any, in turn, round by round, so that what else the machine does meets all alike;
then tasks that do nothing, and draws. Where other work keeps the cores busy the clock says little: seconds of the
processor, of all processes together, stand beside it.
"""

import argparse
import pickle
import resource
import shutil
import signal
import statistics
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import NamedTuple

import numpy as np
import psutil

import trueaxis as ta
from benchmarks.nothing import nothing
from trueaxis.cluster.tasks import Task, run_tasks
from trueaxis.cluster.workers import Workers, client_of
from trueaxis.fleets.fleet_file import read_fleet
from trueaxis.fleets.unit import chains_of
from trueaxis.jobs.fleet_unit import do_unit
from trueaxis.model.curves import PolynomialCurve

ROOT = Path(__file__).parents[1]
MACHINE = ROOT / "machines" / "cframe_mill.toml"
HOURS = 0.5  # of laser runs: 18 runs or so, a small plan
SLOPES = 1e-8  # mm/mm and rad/mm
DRAWS, POINTS = 100_000, 500
TASKS = 2000
PARTS = ("fleet", "some", "tasks", "draws")


class Took(NamedTuple):
    """Seconds by the clock, and of the processor, of this process and those that it started and that have ended."""

    clock: float
    processor: float


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--machines", type=int, default=200, metavar="N", help="%(default)s")
    parser.add_argument("--broken", type=int, default=10, metavar="K", help="of them (%(default)s)")
    parser.add_argument("--measured", type=int, default=24, metavar="M", help="machines of a round (%(default)s)")
    parser.add_argument("--rounds", type=int, default=3, metavar="R", help="%(default)s")
    parser.add_argument("--only", nargs="+", choices=PARTS, default=PARTS, help="default: all")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as text:
        folder = Path(text)
        if {"fleet", "some"} & set(args.only):
            write_machines(folder, args.machines, args.broken)
        if "fleet" in args.only:
            whole_fleet(folder, args.machines)
        if "some" in args.only:
            some_machines(folder, args.measured, args.rounds)
    if "tasks" in args.only:
        empty_tasks()
    if "draws" in args.only:
        draws(args.rounds)


def write_machines(folder: Path, count: int, broken: int) -> None:
    """Folders of data of as many machines; of some the header of the readings is wrong."""
    shutil.copy(MACHINE, folder / "mill.toml")
    model = ta.load_model(MACHINE, ROOT / "generated")
    plan = ta.plan(model, instruments=["laser"], hours=HOURS, out=folder / "plan").data
    for number in range(count):
        source = np.random.default_rng(number)
        slopes = {str(name): SLOPES * source.standard_normal() for name in model.components}
        curves = {name: PolynomialCurve(powers=(1,), coefficients=(slope,)) for name, slope in slopes.items()}
        values = ta.ErrorValues(machine=model.name, motion_errors=curves)
        truth = ta.Errors(values, ta.load_errors(write_zero(folder, model), model).covariance)
        data = ta.simulate(model, truth, plan, noise_um=0.3, seed=number, replace_all=True)
        ta.save_data(folder / "data" / f"M{number:04d}" / "2026-11-01", data)
    for number in range(0, count, count // broken)[:broken]:
        readings = folder / "data" / f"M{number:04d}" / "2026-11-01" / "readings.csv"
        readings.write_text(readings.read_text().replace("reading", "raeding", 1))


def write_zero(folder: Path, model: ta.MachineModel) -> Path:
    path = folder / "zero.json"
    path.write_text(f'{{"schema": 1, "machine": "{model.name}"}}')
    return path


def fleet_file(folder: Path, numbers: range) -> Path:
    tables = [
        f'[[machine]]\nid = "M{n:04d}"\nspec = "mill.toml"\ndata = "data/M{n:04d}/2026-*"\n' for n in numbers
    ]  # fmt: skip
    path = folder / f"FLEET-{len(numbers)}.toml"
    path.write_text("\n".join(tables))
    return path


def whole_fleet(folder: Path, count: int) -> None:
    killed = []

    def kill(stage: str) -> None:
        if stage.startswith(f"{count // 3} of"):
            own = [p for p in psutil.Process().children(recursive=True) if "--multiprocessing-fork" in p.cmdline()]
            own[0].send_signal(signal.SIGKILL)
            killed.append(own[0].pid)

    begin = time.perf_counter()
    done = ta.fleet(fleet_file(folder, range(count)), folder / "out", workers=2, show=kill)
    seconds = time.perf_counter() - begin
    failed = len(done.summary.failed)
    print(f"{count} machines, {len(killed)} worker killed, two workers: {len(done.rows)} rows, {failed} with faults, "
          f"{done.made} made, {seconds:.0f} s")  # fmt: skip
    begin = time.perf_counter()
    again = ta.fleet(fleet_file(folder, range(count)), folder / "out", workers=2)
    print(f"again: {again.made} made, {time.perf_counter() - begin:.1f} s")


def some_machines(folder: Path, count: int, rounds: int) -> None:
    """Many machines without faults, and one alone: the difference is without the start of the workers."""
    took: dict[tuple[str, int], list[Took]] = {(way, size): [] for size in (1, count) for way in ("here", "1", "2")}
    for number in range(rounds):
        for (way, size), found in took.items():
            file = fleet_file(folder, range(1, size + 1))
            found.append(timed(partial(run, file, folder / f"out-{number}-{way}-{size}", way)))
    chains = chains_of(read_fleet(fleet_file(folder, range(1, 2))), folder / "out-0-here-1")
    row, _ = do_unit(chains[0].units[0])
    print(f"{rounds} rounds in turn; median seconds of the processor (by the clock):")
    used = {key: [one.processor for one in found] for key, found in took.items()}
    for (way, size), found in took.items():
        clock = statistics.median(one.clock for one in found)
        print(f"  {size} machines, {way}: {statistics.median(used[way, size]):.1f} ({clock:.1f})")
    for way in ("1", "2"):
        whole = statistics.median(a / b for a, b in zip(used["here", count], used[way, count], strict=True))
        columns = (used["here", count], used["here", 1], used[way, count], used[way, 1])
        further = statistics.median((a - b) / (c - d) for a, b, c, d in zip(*columns, strict=True))
        print(f"efficiency on {way}, median of the ratios of each round: {whole:.2f}; without the start: {further:.2f}")
    print(f"bytes: {len(pickle.dumps(chains[0].units[0]))} to a worker, {len(pickle.dumps(row))} back, for each row")


def run(file: Path, out: Path, way: str) -> None:
    if way != "here":
        ta.fleet(file, out, workers=int(way))
        return
    for chain in chains_of(read_fleet(file), out):
        for unit in chain.units:
            do_unit(unit)


def timed(work: Callable[[], object]) -> Took:
    begin, used = time.perf_counter(), processor_seconds()
    work()
    return Took(time.perf_counter() - begin, processor_seconds() - used)


def processor_seconds() -> float:
    both = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(one.ru_utime + one.ru_stime for one in both)


def empty_tasks() -> None:
    """What a task costs beside its work."""
    for workers in (1, 2):
        with client_of(Workers(count=workers)) as client:
            for ahead in (0, 2):
                tasks = [Task(key=str(n), function=nothing, arguments=(n,)) for n in range(TASKS)]
                begin = time.perf_counter()
                assert sum(1 for _ in run_tasks(client, tasks, ahead)) == TASKS
                rate = TASKS / (time.perf_counter() - begin)
                print(f"tasks that do nothing, {workers} workers, {ahead} waiting at each: {rate:.0f} a second")


def draws(rounds: int) -> None:
    model = ta.load_model(ROOT / "machines" / "dmu60p.toml", ROOT / "generated")
    truth = ta.load_errors(ROOT / "machines" / "dmu60p_errors.json", model)
    plan = ta.load_data(ROOT / "machines" / "dmu60p_regular_runs", model)
    errors = ta.identify(model, ta.simulate(model, truth, plan, noise_um=0.3, seed=1, replace_all=True)).errors
    source = np.random.default_rng(1)
    at = {axis: source.uniform(*model.travel[axis], POINTS) for axis in model.axes}
    took: dict[int, list[Took]] = {1: [], 2: []}
    for _ in range(rounds):
        for workers, found in took.items():
            asked = ta.Draws(count=DRAWS, workers=workers)
            found.append(timed(partial(ta.predict, model, errors, at, draws=asked)))
    for workers, found in took.items():
        clock, processor = (statistics.median(one) for one in zip(*found, strict=True))
        rate = 1e-6 * DRAWS * POINTS / processor
        print(f"{DRAWS} draws at {POINTS} points, {workers} processes: {processor:.1f} s of the processor ({clock:.1f} "
              f"by the clock), {rate:.2f} million points a second")  # fmt: skip


if __name__ == "__main__":
    main()
