"""Load the generated kernels of a machine: NumPy always, C where it has been or can be compiled."""

import importlib.util
import logging
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt

from trueaxis.faults import Fault, InputError
from trueaxis.runtime.c_kernels import load_c_kernels
from trueaxis.spec.machine import Machine

FloatArray = npt.NDArray[np.float64]
Kernel = Callable[..., Any]

_LOG = logging.getLogger(__name__)

ABI = 1  # of the kernels that this runtime calls


@dataclass(frozen=True)
class Kernels:
    """The kernels of one machine: `kernels["tool_in_workpiece_deviation"](positions, errors, parameters, point)`.

    meta: META of the generated module. backend: "numpy" or "c"; note: why it is not C, empty if it
    is or if NumPy was asked for. C kernels take `threads=k` besides.
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


def load_kernels(machine: Machine, spec: Path, folder: Path, *, backend: str | None = None) -> Kernels:
    """The kernels in `folder`/NAME, checked to be those of this machine and of this runtime.

    backend: "auto" (C if it can be had, else NumPy, which is said once), "c" or "numpy"; by default what the
    environment variable TRUEAXIS_BACKEND says, else "auto".
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
    backend = backend or os.environ.get("TRUEAXIS_BACKEND", "auto")
    if backend == "numpy":
        return Kernels(module.META, module, routines, "numpy", "")
    source = path.with_name("kernels.c")
    compiled, reason = load_c_kernels(source, machine.name, machine.digest, ABI, module.META["routines"])
    if compiled:
        return Kernels(module.META, module, compiled, "c", "")
    if backend == "c":
        raise InputError([Fault(str(source), "", reason, "a C compiler, or TRUEAXIS_BACKEND=numpy")])
    note = f"running on NumPy, several times slower than C: {reason}"
    _LOG.warning(note)
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
