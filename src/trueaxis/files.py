"""Output files are written whole or not at all."""

import errno
import os
import tempfile
from collections.abc import Mapping
from pathlib import Path


def write_files(contents: Mapping[Path, bytes | str]) -> None:
    """Write all files, or none: each is written beside its target first, then all are moved into place.

    Raises OSError when a file cannot be written; no target has then been touched.
    """
    for target in contents:
        if target.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(target))
    staged: list[tuple[str, Path]] = []
    try:
        for target, content in contents.items():
            target.parent.mkdir(parents=True, exist_ok=True)
            data = content.encode() if isinstance(content, str) else content
            handle, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
            staged.append((name, target))
            with os.fdopen(handle, "wb") as file:
                file.write(data)
            Path(name).chmod(0o644)
        for name, target in staged:
            Path(name).replace(target)
        staged.clear()
    finally:
        for name, _ in staged:
            Path(name).unlink(missing_ok=True)
