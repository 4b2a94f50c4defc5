"""No module is imported from the current folder: it holds data, and data are not run.

This module uses nothing but what Python has loaded at its start, so that it can be called before any other import.
"""

import os
import sys
from collections.abc import Iterable


def leave_current_folder_out() -> None:
    """Take the current folder off the import path of this process.

    `python -m` and an empty entry of PYTHONPATH put it there, in front of the standard library.
    """
    sys.path[:] = without_current_folder(sys.path)


def without_current_folder(entries: Iterable[str]) -> list[str]:
    """The entries of an import path, folders as absolute paths, less those that are the current folder.

    The folder that holds this package stays: the program could not go on without it.
    """
    package = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))  # noqa: PTH100, PTH120  pathlib is not loaded
    kept = []
    for entry in entries:
        absolute = os.path.abspath(entry)  # noqa: PTH100
        if absolute == package or not _is_current(absolute):
            # an entry that is no folder may be a name that an installer's import hook knows
            kept.append(absolute if os.path.isdir(absolute) else entry)  # noqa: PTH112
    return kept


def _is_current(folder: str) -> bool:
    try:
        return os.path.samefile(folder, os.curdir)  # noqa: PTH121
    except OSError:  # there is no such folder, or the current one was removed
        return False
