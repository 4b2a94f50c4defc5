"""Output files are written whole or not at all."""

import errno
import os
import tempfile
from collections.abc import Mapping
from contextlib import ExitStack
from pathlib import Path


def write_files(contents: Mapping[Path, bytes | str]) -> None:
    """Write all files, or none: each is written beside its target first, then all are moved into place.

    Raises OSError when a file cannot be written; targets are then what they were, and folders made for them are gone.
    """
    for target in contents:
        if target.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(target))
    kept: list[Path] = []
    with ExitStack() as undo:
        staged: list[tuple[Path, Path]] = []
        for target, content in contents.items():
            for folder in _missing(target.parent):
                folder.mkdir(exist_ok=True)
                undo.callback(folder.rmdir)
            data = content.encode() if isinstance(content, str) else content
            staged.append((_beside(target, data, undo), target))
        for new, target in staged:
            if target.exists():
                kept.append(_beside(target, target.read_bytes(), undo))
                undo.callback(kept[-1].replace, target)
            else:
                undo.callback(target.unlink, missing_ok=True)
            new.replace(target)
        undo.pop_all()
    for old in kept:
        old.unlink()


def _missing(folder: Path) -> list[Path]:
    """The folder and those above it that are not there, the topmost first."""
    return [path for path in reversed([folder, *folder.parents]) if not path.exists()]


def _beside(target: Path, data: bytes, undo: ExitStack) -> Path:
    """A new file beside the target, removed when `undo` closes."""
    try:
        handle, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name[:100]}.")
    except OSError as error:  # the user knows the target, not the file beside it
        raise OSError(error.errno, error.strerror, str(target)) from None
    undo.callback(Path(name).unlink, missing_ok=True)
    with os.fdopen(handle, "wb") as file:
        file.write(data)
    Path(name).chmod(0o644)
    return Path(name)
