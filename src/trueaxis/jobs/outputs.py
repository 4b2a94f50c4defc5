"""Outputs by name: no command writes over what it reads, or writes two things into one file."""

import os
from collections.abc import Mapping
from pathlib import Path

from trueaxis.io.faults import Fault
from trueaxis.io.safe_text import shown
from trueaxis.measurement import readings, setup
from trueaxis.model.manifest import KERNEL_FILES, MANIFEST

_DATA_FILES = (setup.FILE_NAME, readings.FILE_NAME, readings.PARQUET_NAME)
_ELSEWHERE = "another place to write"


def overwritten(
    inputs: Mapping[str, Path | None], outputs: Mapping[str, Path | None], kernels: Path | None = None
) -> list[Fault]:
    """Faults of outputs that are an input, a file of measured data in an input folder, a kernel, or another output.

    inputs, outputs: by the name of their option, as the user knows it; None where the option was not given. kernels:
    the folder of --kernels. A file is known again under every name: other spellings, symbolic and hard links.
    """
    found: list[Fault] = []
    written: list[tuple[str, Path]] = []
    given = {name: path for name, path in inputs.items() if path is not None}
    for option, path in outputs.items():
        if path is None:
            continue
        for name, source in given.items():
            if _same(path, source):
                found.append(Fault(str(path), "", f"is both {name}, which is read, and {option}", _ELSEWHERE))
            elif any(_same(path, source / file) for file in _DATA_FILES):
                found.append(Fault(str(path), "", f"{option} is a file of {name}, which is read", _ELSEWHERE))
        if kernels is not None and _among_kernels(path, kernels):
            found.append(Fault(str(path), "", f"{option} lies among the kernels of {kernels}", _ELSEWHERE))
        if other := next((name for name, earlier in written if _same(path, earlier)), None):
            found.append(Fault(str(path), "", f"is both {other} and {option}", "a file for each"))
        written.append((option, path))
    return found


def named(path: Path) -> str:
    """The path as a line of a report names it."""
    return shown(str(path))


def _among_kernels(path: Path, kernels: Path) -> bool:
    """Whether it is a file of derived kernels, or would be a further one in their folder."""
    folder = _real(path).parent
    if folder.parent == _real(kernels) and (path.name in KERNEL_FILES or (folder / MANIFEST).exists()):
        return True
    machines = [manifest.parent for manifest in kernels.glob(f"*/{MANIFEST}")] if kernels.is_dir() else []
    return any(_same(path, machine / file) for machine in machines for file in KERNEL_FILES)


def _same(one: Path, other: Path) -> bool:
    """Whether both name one file, or would."""
    try:
        return _real(one) == _real(other) or one.samefile(other)
    except (OSError, ValueError):  # one of them is not there, or is no name at all
        return False


def _real(path: Path) -> Path:
    return Path(os.path.realpath(path))
