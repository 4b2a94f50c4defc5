"""Many machines, with measured data of many days each: done on worker processes, kept, and summed up."""

import os
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path

import polars as pl

from trueaxis.cluster.tasks import Ended, Task, run_tasks
from trueaxis.cluster.workers import Workers, client_of
from trueaxis.fleets.fleet_file import read_fleet
from trueaxis.fleets.rows import ROW_FILE, Row, Summary, read_row, row_text, rows_frame, summary_of
from trueaxis.fleets.unit import Chain, Unit, chains_of, inputs_digest, kept_row
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering
from trueaxis.io.safe_text import shown
from trueaxis.io.staging import written_by_one
from trueaxis.jobs.draws import workers_of
from trueaxis.jobs.fleet_unit import clear, do_unit, prepare
from trueaxis.jobs.printed import Printed
from trueaxis.jobs.tables import Tabular
from trueaxis.jobs.typed import AnyPath, typed
from trueaxis.measurement.table import table_bytes
from trueaxis.reporting.fleet import fleet_text

RESULTS, PAGE = "results.parquet", "index.html"
Show = Callable[[str], None]


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class FleetResult(Printed, Tabular):
    """What has been done of a fleet. rows: machine by machine, of each in the order of its dates; summary: what has
    changed, which machines share a cause, which failed; made: how many rows were made now; kept: how many are
    unchanged; files: the table and the page; folder: where everything is. Printed, it is the report of
    `trueaxis fleet`.
    """

    rows: tuple[Row, ...] = field(repr=False)
    summary: Summary = field(repr=False)
    made: int
    kept: int
    files: tuple[Path, ...]
    folder: Path

    @property
    def good(self) -> bool:
        """Whether no row has a fault, and the newest values of every machine fit their readings."""
        return not self.summary.failed and not self.summary.misfits

    def to_polars(self) -> pl.DataFrame:
        """A row for each machine and folder of data, as in results.parquet."""
        return rows_frame(self.rows)

    def __str__(self) -> str:
        return fleet_text(self.rows, self.summary, self.made, self.kept)


@typed
def fleet(
    file: AnyPath,
    out: AnyPath,
    *,
    workers: int | None = None,
    memory: float | None = None,
    scheduler: str | None = None,
    again: bool = False,
    show: Show = lambda _: None,
) -> FleetResult:
    """Identify, diagnose and document many machines, and summarise what has changed and which share a cause.

    file: FLEET.toml (docs/fleet.md); out: the folder to be written: results.parquet, index.html, and a folder for each
    machine and folder of its data with the files of the single commands. workers: processes on this computer (one for
    each core); memory: GB for each (that of the computer in equal parts); scheduler: address of a running
    Dask scheduler, whose workers are used instead and must see the same files at the same paths. again: repeat
    unchanged work, too. show: called with the progress.

    A machine that fails, or ends its worker, gets a row with its faults. Raises InputError with every fault of
    the file, where Dask is not installed or the scheduler does not answer; ValueError for arguments of another form.
    """
    asked = workers_of(workers, memory, scheduler)
    folder, source = Path(out), Path(file)
    found: list[Fault] = []
    chains: tuple[Chain, ...] = ()
    with gathering(found):
        if folder.exists() and not folder.is_dir():
            raise InputError([Fault(str(folder), "", "is a file", "a folder for --out")])
    with gathering(found):
        chains = chains_of(read_fleet(source), folder)
    if found:
        raise InputError(found)
    with written_by_one(folder):
        rows, made = _rows(chains, asked, again, show)
        ordered = tuple(row for chain in chains for row in _of(chain, rows))
        summary = summary_of(ordered)
        show("summary")
        files = _written(folder, source.name, ordered, summary)
    kept = sum(len(chain.units) for chain in chains) - made
    return FleetResult(rows=ordered, summary=summary, made=made, kept=kept, files=files, folder=folder)


def _rows(chains: tuple[Chain, ...], asked: Workers, again: bool, show: Show) -> tuple[dict[Path, Row], int]:
    """The row of every unit by its folder, and how many were made now."""
    rows: dict[Path, Row] = {}
    left: list[tuple[Unit, ...]] = []
    for chain in chains:
        kept = [] if again else _kept(chain)
        rows |= {unit.out: row for unit, row in zip(chain.units, kept, strict=False)}
        if rest := chain.units[len(kept) :]:
            left.append(rest)
    if not left:
        return rows, 0
    if again:
        for unit in (unit for units in left for unit in units):
            clear(unit.out)
    of_key = {str(unit.out): unit for units in left for unit in units}
    made, done = 0, 0
    with client_of(asked) as client:
        for ended in run_tasks(client, _tasks(left)):
            if ended.key not in of_key:
                continue
            unit = of_key[ended.key]
            row, new = ended.result if ended.result is not None else (_lost(unit, ended), True)
            rows[unit.out] = row
            made, done = made + new, done + 1
            show(f"{done} of {len(of_key)}")
    return rows, made


def _kept(chain: Chain) -> list[Row]:
    """Of the first units of the machine, as many as are unchanged."""
    found: list[Row] = []
    for unit in chain.units:
        row = kept_row(unit, inputs_digest(unit))
        if row is None:
            break
        found.append(row)
    return found


def _tasks(left: list[tuple[Unit, ...]]) -> list[Task]:
    """Kernels of each spec once, then the units of each machine one after the other."""
    specs = {units[0].spec: units[0].kernels for units in left}
    tasks = [
        Task(key=f"kernels {spec}", function=prepare, arguments=(spec, kernels)) for spec, kernels in specs.items()
    ]
    for units in left:
        before = f"kernels {units[0].spec}"
        for unit in units:
            tasks.append(Task(key=str(unit.out), function=do_unit, arguments=(unit,), after=(before,)))
            before = str(unit.out)
    return tasks


def _lost(unit: Unit, ended: Ended) -> Row:
    """The row of a unit that took its workers with it, or that no worker could take; it is written."""
    if ended.lost:
        fault = (
            f"given up: {ended.lost} workers were lost with it, killed or out of memory; give workers more memory "
            "(--memory), or fewer readings; it is tried again by the next run"
        )
    else:
        problem = f"{type(ended.error).__name__}: {ended.error}"
        fault = f"a worker could not do it: {problem}; all need this version of trueaxis and the folder of --out"
    before = None if unit.before is None else read_row(unit.before)
    newest = None
    if unit.before is not None and before is not None and before.newest is not None:
        newest = Path(os.path.relpath(unit.before / before.newest, unit.out)).as_posix()
    row = Row(machine=unit.machine, data=unit.data, date=unit.date, inputs="", tasks=unit.tasks)
    row = replace(row, faults=(shown(fault),), newest=newest)
    clear(unit.out)
    write_files({unit.out / ROW_FILE: row_text(row)})
    return row


def _of(chain: Chain, rows: dict[Path, Row]) -> list[Row]:
    return [chain.row] if chain.row is not None else [rows[unit.out] for unit in chain.units]


def _written(folder: Path, name: str, rows: tuple[Row, ...], summary: Summary) -> tuple[Path, ...]:
    from trueaxis.reporting.fleet import fleet_page  # noqa: PLC0415  Jinja2: for sound input

    files: dict[Path, bytes | str] = {
        folder / RESULTS: table_bytes(rows_frame(rows), ".parquet"),
        folder / PAGE: fleet_page(name, rows, summary),
    }
    write_files(files)
    return tuple(files)
