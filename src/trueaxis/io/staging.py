"""Files and folders that are made under a temporary name, and what killed runs left of them.

Whoever makes one holds a lock on it for as long as it lives, which the system lets go when its process ends in whatever
way. What bears such a name and is not locked was left behind, and the next run that writes to the folder removes it.
"""

import os
import re
import shutil
import stat
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

from trueaxis.io.faults import Fault, InputError

if sys.platform != "win32":
    import fcntl

_NAME = re.compile(r"\.trueaxis-[0-9a-f]{16}\.tmp")
_TRIES = 100  # another run may take a new file for one that was left, before it is locked


def staged_file(folder: Path, undo: ExitStack) -> tuple[Path, int]:
    """A new empty file in the folder, locked, with the mode of new files; its path, and what it is open under.

    The file goes, unless it was moved, when `undo` closes; whoever asked for it closes what it is open under.
    Raises OSError when there can be none.
    """
    for _ in range(_TRIES):
        path = staged_name(folder)
        undo.callback(path.unlink, missing_ok=True)  # before it is made: a signal may come in between
        handle = os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY | getattr(os, "O_BINARY", 0), 0o666)
        if hold(handle) and os.fstat(handle).st_nlink:
            return path, handle
        os.close(handle)
    raise _taken_away(folder)


@contextmanager
def staged_folder(folder: Path) -> Iterator[Path]:
    """A new folder in `folder` for its owner alone, locked; it goes with all that is in it. Raises OSError."""
    with ExitStack() as undo:
        yield _held_folder(folder, undo)


def _held_folder(folder: Path, undo: ExitStack) -> Path:
    for _ in range(_TRIES):
        path = staged_name(folder)
        undo.callback(shutil.rmtree, path, ignore_errors=True)
        path.mkdir(mode=0o700)
        if sys.platform == "win32":
            return path
        with suppress(FileNotFoundError):  # taken before it was opened
            handle = os.open(path, os.O_RDONLY)
            undo.callback(os.close, handle)
            if hold(handle) and path.is_dir():
                return path
    raise _taken_away(folder)


def _taken_away(folder: Path) -> TimeoutError:
    return TimeoutError(0, "other programs keep taking its temporary files away", str(folder))


def staged_name(folder: Path) -> Path:
    """A temporary name in the folder that nothing has."""
    return folder / f".trueaxis-{os.urandom(8).hex()}.tmp"


def hold(handle: int) -> bool:
    """Lock what is open until it is closed or the process ends; whether nobody else holds it."""
    if sys.platform == "win32":
        return True
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:  # a file system without locks: nothing is swept there either
        return True
    return True


def sweep(folder: Path) -> None:
    """Remove what killed runs left in the folder. What cannot be judged or removed stays."""
    if sys.platform == "win32":
        return
    with suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if _NAME.fullmatch(entry.name):
                with suppress(OSError):
                    _remove_if_left(Path(entry.path))


def _remove_if_left(path: Path) -> None:
    handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        mode = os.fstat(handle).st_mode
        if stat.S_ISREG(mode):
            path.unlink()
        elif stat.S_ISDIR(mode):
            shutil.rmtree(path, ignore_errors=True)
    finally:
        os.close(handle)


@contextmanager
def written_by_one(folder: Path) -> Iterator[None]:
    """Hold the folder while it is written. Raises InputError where another run holds it."""
    made = not folder.exists()
    folder.mkdir(parents=True, exist_ok=True)
    if sys.platform == "win32":  # no folder can be locked there
        yield
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        if not hold(handle):
            raise InputError(
                [Fault(str(folder), "", "is being written by another run", "wait for it, or another folder")]
            )
        yield
    finally:
        os.close(handle)
        if made and not any(folder.iterdir()):  # nothing came of it
            folder.rmdir()
