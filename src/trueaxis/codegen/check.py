"""`derive --check`: whether the files on disk are those that would be emitted, and how they differ."""

import difflib
from pathlib import Path

from trueaxis.io.files import write_files


def differences(folder: Path, files: dict[str, bytes], context: int = 2) -> list[str]:
    """Lines that say what differs: missing and left-over files, and unified diffs of changed ones; empty if nothing."""
    present = {path.name for path in folder.iterdir() if path.is_file()} if folder.is_dir() else set()
    lines = [f"{folder / name}: is missing" for name in files if name not in present]
    lines += [f"{folder / name}: is not generated from this spec" for name in sorted(present - files.keys())]
    for name, new in files.items():
        if name in present and (old := (folder / name).read_bytes()) != new:
            before, after = (text.decode(errors="replace").splitlines() for text in (old, new))
            label = str(folder / name)
            diff = difflib.unified_diff(before, after, label, f"{label} (as derived now)", n=context, lineterm="")
            lines += list(diff) or [f"{label}: differs in the ends of its lines"]
    return lines


def write(folder: Path, files: dict[str, bytes]) -> None:
    """Write all files of a machine, or none."""
    write_files({folder / name: content for name, content in files.items()})
