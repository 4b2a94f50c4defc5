"""The pages under test and the names of their formulas, made once."""

from functools import cache

from tests.machines import ROOT
from tests.page.chain_names import ChainNames
from tests.page.numeric_chain import NumericChain
from tests.page.paper_names import PaperNames
from tests.page.rows import Row, rows_of
from trueaxis.commands.derive import identification_runs
from trueaxis.derive.model import DerivedModel, derive_model
from trueaxis.emit.equations import equations_page
from trueaxis.spec import read_machine


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
    chain = NumericChain((ROOT / "machines" / f"{name}.toml").read_text(encoding="utf-8"))
    return PaperNames(chain) if name == "dmu60p" else ChainNames(chain)
