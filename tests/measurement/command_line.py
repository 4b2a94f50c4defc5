"""Running one command module as the command line does."""

import argparse
from pathlib import Path
from types import ModuleType
from typing import Any

from tests.generator.dmu60p import PARAMETERS, coefficients

ROOT = Path(__file__).parents[2]
MACHINE = ROOT / "machines" / "dmu60p.toml"
KERNELS = ROOT / "generated"
PLAN = ROOT / "machines" / "dmu60p_runs"


def run(command: ModuleType, *arguments: object) -> int:
    return command_line(command, MACHINE, KERNELS, *arguments)


def command_line(command: ModuleType, machine: Path, kernels: Path, *arguments: object) -> int:
    parser = argparse.ArgumentParser()
    command.add_parser(parser.add_subparsers())
    name = command.__name__.rsplit(".", 1)[-1]
    args = parser.parse_args([name, str(machine), *map(str, arguments), "--kernels", str(kernels)])
    return int(args.run(args))


def errors_tree() -> dict[str, Any]:
    """The errors of the independent machine with cubic curves, as an error-values file."""
    curves = {
        name: {
            "basis": "polynomial",
            "powers": [int(power[1:]) for power in terms],
            "coefficients": list(terms.values()),
        }
        for name, terms in coefficients().items()
    }
    return {"schema": 1, "machine": "dmu60p", "parameters": PARAMETERS, "motion_errors": curves}
