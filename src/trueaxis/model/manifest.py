"""What `derive` wrote of a machine: manifest.json holds the digest of every file, and no other content is run.

`spec_label` is how generated files name the spec that they come from.
"""

import hashlib
import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.io.input_files import gathering, input_bytes

MANIFEST = "manifest.json"
C_FILES = ("kernels.c", "kernels.h")
CODE_FILES = ("kernels.py", *C_FILES)
CONTROL_FILES = ("control.c", "control.h")  # of machines with three linear axes
KERNEL_FILES = (*CODE_FILES, *CONTROL_FILES, "equations.md", MANIFEST)
UNNAMED = "the machine's spec"
# What a comment of C, Python and Markdown may hold: no end of a comment, no second line.
_NAMEABLE = re.compile(r"(?!.*(?:--|\.\.))[\w. /-]+")


def verified_code(folder: Path, *, abi: int, digest: str, spec: Path, remedy: str) -> dict[str, bytes]:
    """The content of each of CODE_FILES in a machine's folder, checked to be what was derived from this spec.

    abi: of the kernels that can be called; digest: of the spec. Raises InputError, with the command that mends it, when
    a file is missing or was changed since, or the kernels are of another ABI or another spec. The digests tell a file
    that was edited or damaged; they are no signature, and who can write one file can write the manifest, too.
    """
    if not (folder / CODE_FILES[0]).is_file():
        raise InputError([Fault(str(folder / CODE_FILES[0]), "", "there are no kernels of this machine", remedy)])
    record = _record(folder / MANIFEST, remedy)
    faults = Faults(str(folder / MANIFEST))
    if record.get("kernel_abi") != abi:
        faults.add("kernel_abi", f"is {record.get('kernel_abi')!r}, not {abi}", remedy)
    elif record.get("spec_sha256") != digest:
        faults.add("spec_sha256", f"is not that of {spec} as it is now", remedy)
    faults.raise_if_any()
    return _as_derived(folder, CODE_FILES, record, remedy)


def other_spec(folder: Path, label: str, digest: str) -> str | None:
    """The spec that the kernels in a machine's folder come from, where it is another one than `label` with this digest;
    None where it is the same machine, nothing is there, or it is not known what.
    """
    try:
        record = _record(folder / MANIFEST, "")
    except InputError:
        return None
    told = record.get("spec") if record.get("spec_sha256") != digest else None
    return told if isinstance(told, str) and told != label and UNNAMED not in (told, label) else None


def verified_control_code(folder: Path, *, remedy: str) -> dict[str, bytes]:
    """The content of each of CONTROL_FILES in a machine's folder, checked to be what was derived.

    The folder is one whose code was verified before. Raises InputError, with the command that mends it, when a file is
    missing, as in folders of earlier versions, or was changed since.
    """
    return _as_derived(folder, CONTROL_FILES, _record(folder / MANIFEST, remedy), remedy)


def _as_derived(folder: Path, names: Sequence[str], record: Mapping[str, Any], remedy: str) -> dict[str, bytes]:
    """The content of files whose digests are in the manifest's record."""
    found: list[Fault] = []
    code: dict[str, bytes] = {}
    for name in names:
        with gathering(found):
            if name not in record["files"]:
                raise InputError([Fault(str(folder / name), "", "was not derived with these kernels", remedy)])
            code[name] = input_bytes(folder / name)
            if hashlib.sha256(code[name]).hexdigest() != record["files"][name]:
                problem = f"is not as it was derived: its SHA-256 is not that in {MANIFEST}"
                raise InputError([Fault(str(folder / name), "", problem, remedy)])
    if found:
        raise InputError(found)
    return code


def _record(path: Path, remedy: str) -> Mapping[str, Any]:
    if not path.is_file():
        raise InputError([Fault(str(path), "", "there is no manifest of these kernels", remedy)])
    try:
        record = json.loads(input_bytes(path))
    except (ValueError, RecursionError) as error:
        raise InputError([Fault(str(path), "", f"is no manifest: {error}", remedy)]) from None
    if not isinstance(record, dict) or not isinstance(record.get("files"), dict):
        raise InputError([Fault(str(path), "files", "is no list of files with their digests", remedy)])
    return record


def spec_label(spec: Path, out: Path) -> str:
    """How generated files name the spec that was given: from the folder that holds OUT, else by its name alone.

    So the name does not depend on where the command was run, and holds no folder outside the user's own tree.
    """
    root, given = out.resolve().parent, spec.resolve()
    label = given.relative_to(root).as_posix() if given.is_relative_to(root) else given.name
    return label if _NAMEABLE.fullmatch(label) else UNNAMED
