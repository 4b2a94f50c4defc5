"""The text of a setup.toml with runs added: what it says is kept, new runs stand behind it."""

import tomllib
from collections.abc import Sequence

from trueaxis.io.faults import Fault, InputError
from trueaxis.measurement.setup import run_table, toml_text
from trueaxis.planning.candidates import Candidate


def setup_text(given: str, added: Sequence[Candidate], file: str) -> str:
    """The text of setup.toml with a [[run]] table for every run added.

    file: named in the fault. Raises InputError where tables cannot be added to the text.
    """
    text = given.rstrip("\n") + "\n" + "".join(f"\n# {one.what}\n{run_table(one.run)}" for one in added)
    try:
        count = len(tomllib.loads(text).get("run", []))
    except tomllib.TOMLDecodeError:
        count = 0
    if count != len(tomllib.loads(given).get("run", [])) + len(added):
        problem = "runs cannot be added behind its text"
        raise InputError([Fault(file, "key run", problem, "write the runs as [[run]] tables")])
    return text


def new_setup(machine: str) -> str:
    """The text of a setup.toml without runs."""
    return f"schema = 1\nmachine = {toml_text(machine)}\n"
