"""Load the generated kernels of a machine: NumPy always, C where it has been or can be compiled."""

import logging
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

from trueaxis.io.faults import Fault, InputError
from trueaxis.machine.machine import Machine
from trueaxis.model.c_kernels import load_c_kernels
from trueaxis.model.manifest import C_FILES, other_spec, spec_label, verified_code

Kernel = Callable[..., Any]

_LOG = logging.getLogger(__name__)

ABI = 3  # of the kernels that this runtime calls
BACKENDS = ("auto", "c", "numpy")


@dataclass(frozen=True, kw_only=True)
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
    Raises InputError when they are missing, changed since, of another ABI or made from another spec, with the command
    to run.
    """
    path = folder / machine.name / "kernels.py"
    other = other_spec(path.parent, spec_label(spec, folder), machine.digest)
    remedy = f"run: trueaxis derive {spec} --out {folder}"
    if other is not None:
        remedy = (
            f"{path.parent} is of {other}, another spec of this name; run: trueaxis derive {spec} --out OTHER, and "
            "give --kernels OTHER"
        )
    backend = backend or _asked_backend()
    code = verified_code(path.parent, abi=ABI, digest=machine.digest, spec=spec, remedy=remedy)
    kernels = numpy_kernels(code[path.name], path, remedy)
    if backend == "numpy":
        return kernels
    c_code = {name: code[name] for name in C_FILES}
    compiled, reason = load_c_kernels(c_code, machine.name, machine.digest, ABI, kernels.meta["routines"])
    if compiled:
        return replace(kernels, routines=compiled, backend="c")
    if backend == "c":
        raise InputError(
            [Fault(str(path.with_name("kernels.c")), "", reason, "a C compiler, or TRUEAXIS_BACKEND=numpy")]
        )
    note = f"running on NumPy, about ten times slower than C: {reason}"
    _LOG.warning(note)
    return replace(kernels, note=note)


def numpy_kernels(code: bytes, path: Path, remedy: str = "") -> Kernels:
    """The kernels that this content of kernels.py defines; it is run. path: what faults name, with the remedy.

    Raises InputError where it cannot be run, or does not say which routines it has.
    """
    module = _module(path, code, remedy)
    try:
        routines = {name: getattr(module, name) for name in module.META["routines"]}
    except (AttributeError, KeyError, TypeError) as error:
        raise InputError([Fault(str(path), "META", f"does not tell its routines: {error}", remedy)]) from None
    return Kernels(meta=module.META, module=module, routines=routines, backend="numpy", note="")


def _asked_backend() -> str:
    asked = os.environ.get("TRUEAXIS_BACKEND") or BACKENDS[0]
    if asked not in BACKENDS:
        problem = f"{asked} is no backend"
        raise InputError([Fault("environment variable TRUEAXIS_BACKEND", "", problem, f"one of {', '.join(BACKENDS)}")])
    return asked


def _module(path: Path, code: bytes, remedy: str) -> ModuleType:
    # Not by the import system, whose cached bytecode is taken for current when a file of the same size is written
    # again within the same second: kernels of two versions of a spec are such files.
    module = ModuleType(f"trueaxis_kernels_{path.parent.name}")
    module.__file__ = str(path)
    try:
        exec(_bytecode(code, str(path)), module.__dict__)
    except Exception as error:  # a file that was damaged may fail in any way
        problem = f"cannot be loaded: {type(error).__name__}: {error}"
        raise InputError([Fault(str(path), "", " ".join(problem.split()), remedy)]) from None
    return module


@lru_cache(maxsize=8)
def _bytecode(code: bytes, name: str) -> CodeType:
    """Compiled once in a process, for the last few machines: who loads one again saves a tenth of a second."""
    return compile(code, name, "exec")
