"""The emitted NumPy kernels of a machine, called by names instead of by rows."""

from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt

from tests.kept import kept
from tests.machines import machine_of
from trueaxis.codegen.numpy_source import numpy_source
from trueaxis.codegen.render import render
from trueaxis.derivation.model import DerivedModel, derive_model
from trueaxis.io.files import write_files

FloatArray = npt.NDArray[np.float64]


@cache
def model_of(text: str) -> DerivedModel:
    return derive_model(machine_of(text))


@cache
def kernels_of(text: str) -> ModuleType:
    def write(folder: Path) -> None:
        model = model_of(text)
        (folder / "kernels.py").write_text(numpy_source(model.machine, model.routines))

    module = ModuleType("kernels")
    exec((kept("kernels", text, write) / "kernels.py").read_text(), module.__dict__)
    return module


def emitted(text: str) -> Path:
    """The folder of all files of a machine, in a folder of its name; nothing in it may be changed."""

    def write(folder: Path) -> None:
        model = model_of(text)
        write_files({folder / model.machine.name / name: content for name, content in render(model).items()})

    return kept("all files", text, write)


def kernels_at(path: Path) -> ModuleType:
    return kernels_of(path.read_text())


def column(names: Sequence[str], values: Mapping[str, Any]) -> FloatArray:
    """Values in the order of the names, (n, 1); what is not named is zero."""
    return np.array([[float(values.get(name, 0.0))] for name in names])


def call(module: ModuleType, routine: str, pose: Mapping[str, float], values: Mapping[str, Any], *more: Any) -> Any:
    """A routine at one pose: positions and, where it takes them, errors and parameters; then whatever follows."""
    known = {
        "positions": column(module.META["axes"], pose),
        "errors": column(module.META["components"], values),
        "parameters": column(module.META["parameters"], values)[:, 0],
    }
    taken = [argument["name"] for argument in module.META["routines"][routine]["inputs"]]
    return getattr(module, routine)(*(known[name] for name in taken if name in known), *more)
