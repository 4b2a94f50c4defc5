"""trueaxis simulate: readings made from error values and a measuring plan."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.cli.arguments import noise_or_none, whole
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.input_files import gathering
from trueaxis.jobs.load import load_data, load_model, save_data
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.jobs.simulate import simulate
from trueaxis.machine import read_machine
from trueaxis.measurement import readings as readings_files
from trueaxis.measurement import setup as setup_file
from trueaxis.model.model import load_errors

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Fill in a measuring plan: every row of readings.csv in --data with an empty reading gets what the instrument would read
on the exact model, plus Gaussian noise if requested. Effects of the machine follow the directions, feeds, times and
temperatures of the plan. Rows with a reading keep it unless --replace is given. The folder --out gets readings.csv and
a copy of setup.toml. If setup.toml names an active compensation, readings are those of the compensated machine."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser(
        "simulate", help="make readings from error values and a measuring plan", description=DESCRIPTION
    )
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument("--errors", type=Path, required=True, metavar="E.json", help="its error values")
    parser.add_argument("--data", type=Path, required=True, metavar="DIR", help="folder with setup.toml, readings.csv")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="another folder, to be written")
    parser.add_argument(
        "--noise-um",
        type=noise_or_none,
        default=0.0,
        metavar="S",
        help="standard deviation of the noise, micrometres (0)",
    )
    parser.add_argument(
        "--noise-urad",
        type=noise_or_none,
        default=0.0,
        metavar="S",
        help="the same for angle instruments, microradians (0)",
    )
    parser.add_argument("--seed", type=whole(0), default=0, metavar="N", help="seed of the noise (%(default)s)")
    parser.add_argument("--replace", action="store_true", help="replace existing readings, too")
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR", help="folder of derived kernels (%(default)s)"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Simulate and write; raises InputError with the faults of every file."""
    found = _faults_of_out(args)
    machine = read_machine(args.machine)
    with gathering(found):
        model = load_model(args.machine, args.kernels)
    with gathering(found):
        values = load_errors(args.errors, machine)
    with gathering(found):
        plan = load_data(args.data, machine)
    if found:
        raise InputError(found)
    simulated = simulate(
        model,
        values,
        plan,
        noise_um=args.noise_um,
        noise_urad=args.noise_urad,
        seed=args.seed,
        replace_all=args.replace,
    )
    runs, readings = plan.data.setup.runs, plan.data.readings
    save_data(args.out, simulated)
    kept = 0 if args.replace else int((~readings.planned).sum())
    told = f"; {kept} were there already and stay (--replace makes them anew)" if kept else ""
    print(f"{named(args.out)}: {len(runs)} runs, {len(readings.run) - kept} readings made{told}")
    return 0


def _faults_of_out(args: argparse.Namespace) -> list[Fault]:
    out, data = args.out, args.data
    if out.resolve() == data.resolve():
        return [Fault(str(out), "", "is the folder of the data itself", "another folder for --out")]
    other = out / readings_files.PARQUET_NAME
    if other.exists():
        return [Fault(str(other), "", f"would stand beside the new {readings_files.FILE_NAME}", "remove it")]
    inputs = {"MACHINE.toml": args.machine, "--errors": args.errors, "--data": data}
    outputs = {f"{name} of --out": out / name for name in (setup_file.FILE_NAME, readings_files.FILE_NAME)}
    return overwritten(inputs, outputs, args.kernels)
