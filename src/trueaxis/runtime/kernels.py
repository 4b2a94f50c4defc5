"""Load the generated kernels of a machine: NumPy always, C where it has been or can be compiled."""

import importlib.util
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt

from trueaxis.faults import Fault, InputError
from trueaxis.spec.machine import Machine

FloatArray = npt.NDArray[np.float64]
Kernel = Callable[..., FloatArray]

ABI = 1  # of the kernels that this runtime calls


@dataclass(frozen=True)
class Kernels:
    """The kernels of one machine: `kernels["tool_in_workpiece_deviation"](positions, errors, parameters, point)`.

    meta: the META record of the generated module. backend: "numpy" or "c"; note: why it is not C, if it is not.
    """

    meta: Mapping[str, Any]
    module: ModuleType
    routines: Mapping[str, Kernel]
    backend: str
    note: str

    def __getitem__(self, name: str) -> Kernel:
        return self.routines[name]

    def __contains__(self, name: str) -> bool:
        return name in self.routines


def load_kernels(machine: Machine, spec: Path, folder: Path, *, backend: str = "auto") -> Kernels:
    """The kernels in `folder`/NAME, checked to be those of this machine and of this runtime.

    backend: "auto" (C if it can be had, else NumPy), "c" or "numpy".
    Raises InputError when they are missing, of another ABI or made from another spec, with the command to run.
    """
    path = folder / machine.name / "kernels.py"
    remedy = f"run: trueaxis derive {spec} --out {folder}"
    if not path.is_file():
        raise InputError([Fault(str(path), "", "there are no kernels of this machine", remedy)])
    module = _module(path)
    if getattr(module, "ABI", None) != ABI:
        raise InputError([Fault(str(path), "ABI", f"is {getattr(module, 'ABI', None)!r}, not {ABI}", remedy)])
    if getattr(module, "SPEC_HASH", None) != machine.digest:
        raise InputError([Fault(str(path), "SPEC_HASH", f"is not that of {spec} as it is now", remedy)])
    routines = {name: getattr(module, name) for name in module.META["routines"]}
    note = "NumPy as asked"
    if backend != "numpy":
        compiled, note = _compiled(path.with_name("kernels.c"), machine, module)
        if compiled:
            return Kernels(module.META, module, compiled, "c", "")
        if backend == "c":
            raise InputError([Fault(str(path.with_name("kernels.c")), "", note, "a C compiler, or --backend numpy")])
    return Kernels(module.META, module, routines, "numpy", note)


def _module(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"trueaxis_kernels_{path.parent.name}", path)
    if spec is None or spec.loader is None:
        raise InputError([Fault(str(path), "", "is no Python module")])
    module = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except (SyntaxError, ValueError, NameError, OSError) as error:
        raise InputError([Fault(str(path), "", f"cannot be loaded: {error}")]) from error
    return module


def _compiled(source: Path, machine: Machine, module: ModuleType) -> tuple[Mapping[str, Kernel], str]:
    return {}, "no C kernels"
