"""Output files are written whole or not at all: the one way by which the program writes files."""

import errno
import logging
import os
import shutil
import stat
import sys
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from types import TracebackType

from trueaxis.io.faults import Fault, InputError
from trueaxis.io.staging import hold, staged_file, staged_name, sweep

_LOG = logging.getLogger(__name__)
_PERMISSIONS = 0o777
_BUFFER = 1 << 16
_STREAMS = {1: "standard output", 2: "standard error"}


def write_files(contents: Mapping[Path, bytes | str]) -> None:
    """Write all files, or none; texts as UTF-8. Raises what OutputFiles raises."""
    with OutputFiles() as outputs:
        for target, content in contents.items():
            # what a file name holds besides UTF-8 may be quoted in a text
            data = content.encode("utf-8", "backslashreplace") if isinstance(content, str) else content
            outputs.open(target).write(data)
        outputs.commit()


def remove_files(paths: Iterable[Path]) -> None:
    """Remove files, one after the other; those that are not there are passed over."""
    for path in paths:
        path.unlink(missing_ok=True)


class OutputFile:
    """A file that is being written beside its target."""

    def __init__(self, target: Path, destination: Path, staged: tuple[Path, int]) -> None:
        self.target, self.destination = target, destination
        self.path, handle = staged
        self.file = os.fdopen(handle, "wb", buffering=_BUFFER)

    def write(self, data: bytes) -> None:
        """Append bytes. Raises OSError that names the target."""
        with _naming(self.target):
            self.file.write(data)

    def finish(self) -> None:
        """Bring all to the disk, with the mode and, where that may be, the owner of the file to be replaced."""
        with _naming(self.target):
            self.file.flush()
            if self.destination.exists() and sys.platform != "win32":
                old = self.destination.stat()
                with suppress(PermissionError):
                    os.chown(self.file.fileno(), old.st_uid, old.st_gid)
                self.path.chmod(old.st_mode & _PERMISSIONS)
            os.fsync(self.file.fileno())
            if sys.platform == "win32":
                self.file.close()  # no open file can be moved there


class OutputFiles:
    """Files that come into place together, when `commit` is called; if it is not, everything is as it was.

    Each is written under a temporary name beside its target and moved there. A target that is a symbolic link is
    written through; a file that is there keeps its mode. Folders are made where they are missing.
    Raises InputError where a target is no place for a file (a folder, a device, a pipe, the file that standard output
    goes to), OSError, which names the target, where it cannot be written.
    """

    def __init__(self) -> None:
        self._outputs: list[OutputFile] = []
        self._temporary = ExitStack()  # what goes in any case
        self._made = ExitStack()  # what goes unless all is done
        self._swept: set[Path] = set()

    def __enter__(self) -> "OutputFiles":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None
    ) -> None:
        for output in self._outputs:
            with suppress(OSError):  # what could not be written was told when it was
                output.file.close()
        self._temporary.close()
        self._made.close()

    def open(self, target: Path) -> OutputFile:
        """A file to be written that will be `target`."""
        destination = _destination(target)
        with _naming(target):
            self._make_folder(target, destination.parent)
            if destination.parent not in self._swept:
                sweep(destination.parent)
                self._swept.add(destination.parent)
            output = OutputFile(target, destination, staged_file(destination.parent, self._temporary))
        self._outputs.append(output)
        return output

    def commit(self) -> None:
        """Move all files into place; where one cannot be moved, those before it are moved back."""
        for output in self._outputs:
            output.finish()
        with ExitStack() as undo:
            for output in self._outputs:
                with _naming(output.target):
                    self._keep_old(output.destination, undo)
                    output.path.replace(output.destination)
            undo.pop_all()
            self._made.pop_all()
        for output in self._outputs:
            _LOG.info("written: %s", output.target)

    def _make_folder(self, target: Path, folder: Path) -> None:
        for path in (*target.parents, folder):
            if path.exists() and not path.is_dir():
                raise InputError([Fault(str(path), "", "is a file", "a folder to write to")])
        for path in reversed([folder, *folder.parents]):
            if not path.exists():
                self._made.callback(_remove_empty, path)
                path.mkdir(exist_ok=True)

    def _keep_old(self, destination: Path, undo: ExitStack) -> None:
        """Keep the old file under a temporary name until all is done; it comes back when `undo` closes."""
        if not destination.exists():
            undo.callback(destination.unlink, missing_ok=True)
            return
        old = self._linked(destination) or self._copied(destination)
        undo.callback(old.replace, destination)

    def _linked(self, destination: Path) -> Path | None:
        """Another name of the file, locked; None where there are no links, or while another run has the lock."""
        old = staged_name(destination.parent)
        self._temporary.callback(old.unlink, missing_ok=True)
        with suppress(PermissionError):  # a file that may be written, but not read
            handle = os.open(destination, os.O_RDONLY)
            self._temporary.callback(os.close, handle)
            if not hold(handle):
                return None
        try:
            os.link(destination, old)
        except OSError:  # a file system without links
            return None
        return old

    def _copied(self, destination: Path) -> Path:
        """A locked copy of the file."""
        old, handle = staged_file(destination.parent, self._temporary)
        if sys.platform == "win32":
            os.close(handle)  # no open file can be moved there
        else:
            self._temporary.callback(os.close, handle)
        shutil.copy2(destination, old)
        return old


def _destination(target: Path) -> Path:
    """The file that the target is, through symbolic links. Raises InputError where it cannot be a file."""
    try:
        destination = Path(os.path.realpath(target))
        there = target.stat()  # of the target itself: what /dev/stdout leads to may have no name
    except (FileNotFoundError, NotADirectoryError):
        return destination
    except ValueError as error:  # a NUL character in the name
        raise InputError([Fault(str(target), "", f"is not a file name: {error}")]) from None
    except OSError as error:
        raise InputError([Fault(str(target), "", f"cannot be written: {error.strerror}", "another file")]) from None
    problem = ""
    if stat.S_ISDIR(there.st_mode):
        problem = "is a folder"
    elif not stat.S_ISREG(there.st_mode):
        problem = "is a device, a pipe or a socket"
    for number, name in _STREAMS.items():
        with suppress(OSError):
            if os.path.samestat(os.fstat(number), there):
                problem = f"is where {name} goes"
    if problem:
        raise InputError([Fault(str(target), "", problem, "the name of a file of its own")])
    if not os.access(destination, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(target))
    return destination


def _remove_empty(folder: Path) -> None:
    with suppress(OSError):  # another program may have written there meanwhile
        folder.rmdir()


@contextmanager
def _naming(target: Path) -> Iterator[None]:
    """Name the target in what the system reports: the user knows no other."""
    try:
        yield
    except OSError as error:
        if error.errno is None:
            raise
        raise OSError(error.errno, error.strerror, str(target)) from None
