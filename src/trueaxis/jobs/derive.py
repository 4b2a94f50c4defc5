"""From a machine spec to its kernels and equations."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.io.faults import Fault, InputError
from trueaxis.jobs.printed import Printed
from trueaxis.jobs.typed import AnyPath, typed
from trueaxis.machine import Machine, read_machine
from trueaxis.model.manifest import other_spec, spec_label
from trueaxis.view import Carrier

if TYPE_CHECKING:
    from trueaxis.derivation.systems import RunPattern
    from trueaxis.measurement.data import MeasuredData
    from trueaxis.measurement.setup import PointOn


KERNELS = "generated"  # the folder that `derive` writes


@dataclass(frozen=True, slots=True, kw_only=True)
class SolvedSystem:
    """An identification system: from which runs, for which unknowns; rank: below their number where it is singular."""

    runs: tuple[str, ...]
    unknowns: tuple[str, ...]
    rank: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Derivation(Printed):
    """What was derived of a machine.

    folder: of its kernels and equations; files: what was written, none where it was compared; differences: lines that
    say how the folder differs from what the spec derives to; systems: in the order of solution; tool_ranges: linear
    axis -> coordinate of the workpiece, mm, to which its lowest and highest position take the origin of the tool frame.
    """

    machine: Machine
    folder: Path
    files: tuple[Path, ...]
    differences: tuple[str, ...]
    systems: tuple[SolvedSystem, ...]
    tool_ranges: Mapping[str, tuple[float, float]]

    def __str__(self) -> str:
        if self.differences:
            return "\n".join(self.differences)
        files = f"{len(self.files)} files written to {self.folder}" if self.files else f"{self.folder} is up to date"
        return f"{self.machine.name}: {files}; {len(self.systems)} identification systems"


@typed
def derive(machine: AnyPath, out: AnyPath = KERNELS, *, runs: AnyPath | None = None, check: bool = False) -> Derivation:
    """Derive the error model of a machine spec and write OUT/NAME/: kernels.py, kernels.c, kernels.h, of a machine with
    three linear axes control.c and control.h, equations.md, manifest.json.

    runs: folder of measured data or a plan, whose identification systems are derived (default: that of the spec);
    check: write nothing, compare. Raises InputError with every fault of the spec or the runs.
    """
    # SymPy takes a second to import; nothing else needs it
    from trueaxis.codegen.check import differences, write  # noqa: PLC0415
    from trueaxis.codegen.render import render  # noqa: PLC0415
    from trueaxis.derivation.model import derive_model  # noqa: PLC0415
    from trueaxis.derivation.tool_ranges import tool_ranges  # noqa: PLC0415

    spec, folder = Path(machine), Path(out)
    record = read_machine(spec)
    if faults := [] if check else faults_of_folder(record, spec, Path(out)):
        raise InputError(faults)
    check_kinds(record, spec)
    model = derive_model(record, identification_runs(record, spec, None if runs is None else Path(runs)))
    files = render(model, spec_label(spec, folder))
    folder = folder / record.name
    differing = tuple(differences(folder, files)) if check else ()
    if not check:
        write(folder, files)
    systems = model.identification.systems if model.identification else ()
    return Derivation(
        machine=record,
        folder=folder,
        files=() if check else tuple(folder / name for name in files),
        differences=differing,
        systems=tuple(SolvedSystem(runs=one.runs, unknowns=one.unknowns, rank=one.rank) for one in systems),
        tool_ranges=tool_ranges(record),
    )


def faults_of_folder(machine: Machine, spec: Path, out: Path) -> list[Fault]:
    """A folder that holds what was derived of another spec, of the same name: its machine would lose its kernels."""
    folder = out / machine.name
    other = other_spec(folder, spec_label(spec, out), machine.digest)
    if other is None:
        return []
    problem = f"holds the kernels of {other}, another spec of the name {machine.name}"
    return [Fault(str(folder), "", problem, "another folder by --out, or remove this one if that spec is no more")]


def check_kinds(machine: Machine, spec: Path) -> None:
    """Raise InputError where a kind of effect of the spec's own has no finite value or derivative."""
    from trueaxis.codegen.check import faults_of_kinds  # noqa: PLC0415  as in derive

    if faults := faults_of_kinds(machine, str(spec)):
        raise InputError(faults)


def identification_runs(machine: Machine, spec: Path, given: Path | None = None) -> "tuple[RunPattern, ...]":
    """The runs of the folder given, else of the one that the spec names, whose identification systems are derived.

    Raises InputError where it is not there or its files are wrong.
    """
    folder = given or (spec.parent / machine.runs if machine.runs else None)
    if folder is None:
        return ()
    if not folder.is_dir():
        key = "--runs" if given else "key runs"
        raise InputError(
            [Fault(str(spec), key, f"there is no folder {folder}", "a folder with setup.toml and readings.csv")]
        )
    from trueaxis.measurement.data import read_data  # noqa: PLC0415  Polars; few specs have runs

    return run_patterns(machine, read_data(folder, machine))


def run_patterns(machine: Machine, data: "MeasuredData") -> "tuple[RunPattern, ...]":
    """The laser and probe runs of a data set, as patterns: which axes move is seen from the readings."""
    from trueaxis.derivation.systems import RunPattern  # noqa: PLC0415  as in derive

    patterns: list[RunPattern] = []
    for index, each in enumerate(data.setup.runs):
        if each.instrument not in ("laser", "probe") or each.direction is None:
            continue  # a ball bar's reading is no linear form of the position; an angle is none of a point's
        rows = data.readings.of_run(index)
        positions = data.readings.positions[:, rows]
        moves = tuple(axis for axis, row in zip(machine.axes, positions, strict=True) if (row != each.home[axis]).any())
        patterns.append(
            RunPattern(
                name=each.id,
                moves=moves,
                direction=each.direction,
                frame=each.frame,
                target=_end(each.target),
                reference=_end(each.reference),
            )
        )
    return tuple(patterns)


def _end(end: "PointOn") -> tuple[Carrier, tuple[float, float, float]]:
    return end.on, end.point
