"""The pages under test and the names of their formulas, made once."""

import tomllib
from functools import cache
from typing import Any

from tests.machines import ROOT
from tests.page.chain_names import ChainNames
from tests.page.numeric_chain import NumericChain
from tests.page.paper_names import PaperNames
from tests.page.rows import Row, rows_of
from trueaxis.codegen.equations import equations_page
from trueaxis.derivation.model import DerivedModel, derive_model
from trueaxis.jobs.derive import identification_runs
from trueaxis.machine import read_machine
from trueaxis.machine.machine import Machine


@cache
def derived(name: str) -> DerivedModel:
    spec = ROOT / "machines" / f"{name}.toml"
    machine = read_machine(spec)
    return derive_model(machine, identification_runs(machine, spec))


@cache
def page(name: str) -> str:
    return equations_page(derived(name))


@cache
def rows(name: str) -> tuple[Row, ...]:
    return tuple(rows_of(page(name)))


@cache
def names(name: str) -> ChainNames:
    tree = tomllib.loads((ROOT / "machines" / f"{name}.toml").read_text(encoding="utf-8"))
    chain = NumericChain(tree if "body" in tree else body_tables(derived(name).machine))
    return PaperNames(chain) if name == "dmu60p" else ChainNames(chain)


def body_tables(machine: Machine) -> dict[str, Any]:
    """What a spec that gives a structure code would say with tables of bodies."""
    tables = [
        {"number": body.number, "lower": body.lower, "sense": body.sense, "position": list(body.position)}
        | ({"moves": body.moves} if body.moves else {})
        | {"position_errors": dict(body.position_errors)}
        for body in machine.bodies
    ]
    return {"body": tables, "ends": {"workpiece": machine.workpiece, "tool": machine.tool}}
