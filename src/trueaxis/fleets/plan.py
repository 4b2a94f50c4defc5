"""The units of a fleet: what is to be done, where it is read and where it is written."""

from dataclasses import dataclass
from pathlib import Path

from trueaxis import __version__
from trueaxis.fleets.data_folders import data_folders
from trueaxis.fleets.fleet_file import Fleet, FleetMachine
from trueaxis.fleets.row import Row
from trueaxis.fleets.unit import Unit
from trueaxis.io.faults import Fault, InputError

MACHINES, KERNELS = "machines", "kernels"  # folders of the results: of each machine, and of the kernels of each spec
GIVEN = "given"  # folder of a machine whose values are shown as they are given


@dataclass(frozen=True, slots=True)
class Chain:
    """The units of a machine in the order of their dates; or the one row that says why it has none."""

    units: tuple[Unit, ...]
    row: Row | None = None


def chains_of(fleet: Fleet, out: Path) -> tuple[Chain, ...]:
    """One for each machine. out: folder of the results. Raises InputError where an input lies among the results."""
    base, out = fleet.folder.resolve(), out.resolve()
    chains = tuple(_chain(base, machine, out) for machine in fleet.machines)
    if faults := _among_results(chains, out):
        raise InputError(faults)
    return chains


def _chain(base: Path, machine: FleetMachine, out: Path) -> Chain:
    own = out / MACHINES / machine.id
    try:
        folders = data_folders(base, machine.data)
    except InputError as error:
        told, data = tuple(map(str, error.faults)), ", ".join(machine.data)
        return Chain((), Row(machine=machine.id, data=data, date=None, inputs="", tasks=machine.tasks, faults=told))
    errors = None if machine.errors is None else base / machine.errors
    units: list[Unit] = []
    for folder in folders or (None,):
        name = GIVEN if folder is None else folder.path.name
        units.append(
            Unit(
                machine=machine.id, data="" if folder is None else folder.name,
                date=None if folder is None or folder.date is None else folder.date.isoformat(), tasks=machine.tasks,
                base=base, spec=base / machine.spec, errors=errors, folder=None if folder is None else folder.path,
                out=own / name, before=units[-1].out if units else None, kernels=out / KERNELS, version=__version__,
            )
        )  # fmt: skip
    return Chain(tuple(units))


def _among_results(chains: tuple[Chain, ...], out: Path) -> list[Fault]:
    """Inputs that lie where results are written: they would be written over while they are read."""
    written = [out / MACHINES, out / KERNELS]
    found: dict[Path, Fault] = {}
    for unit in (unit for chain in chains for unit in chain.units):
        for path in (unit.spec, unit.errors, unit.folder):
            if path is None or path in found:
                continue
            real = path.resolve()
            if any(real.is_relative_to(folder) for folder in written):
                problem = "lies among the results of --out, which are written"
                found[path] = Fault(str(path), "", problem, "a copy of it elsewhere, or another folder for --out")
    return list(found.values())
