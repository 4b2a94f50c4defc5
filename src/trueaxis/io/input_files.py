"""Reading an input file whose absence or encoding is the user's fault, not the program's."""

import logging
from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from trueaxis.io.faults import Fault, Faults, InputError

_LOG = logging.getLogger(__name__)


@contextmanager
def gathering(found: list[Fault]) -> Iterator[None]:
    """Add the faults of the input read inside to `found`, so that the faults of several files are told together."""
    try:
        yield
    except InputError as error:
        found += error.faults


def said_of(problem: OSError) -> tuple[str, str]:
    """What is wrong with a file that cannot be opened, and what would be right."""
    if isinstance(problem, FileNotFoundError):
        return "there is no such file", ""
    if isinstance(problem, IsADirectoryError):
        return "is a folder", "name a file"
    return problem.strerror or str(problem), ""


def input_bytes(path: Path) -> bytes:
    """The file's content. Raises InputError when the file cannot be read."""
    faults = Faults(str(path))
    _LOG.info("reading %s", path)
    try:
        return path.read_bytes()
    except (FileNotFoundError, IsADirectoryError) as error:
        faults.add("", *said_of(error))
    except OSError as error:
        faults.add("", f"cannot be read: {error.strerror}")
    except ValueError as error:  # a NUL character in the name
        faults.add("", f"is not a file name: {error}")
    raise InputError(faults.found)


def utf8_text(path: Path, data: bytes) -> str:
    """The file's content as text, without a byte order mark. Raises InputError where it is not UTF-8."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        faults = Faults(str(path))
        line = data.count(b"\n", 0, error.start) + 1
        faults.add(f"line {line}", f"byte {data[error.start]:#04x} is not UTF-8", "save the file as UTF-8")
        raise InputError(faults.found) from None


def decoded(data: bytes) -> str:
    """The text: UTF-16 with its mark, UTF-8, else GB 2312 (machines and operators are named in Chinese), else as bytes.

    Not GBK, which has a character for the sign of micro before a letter as a German or French file has it.
    """
    for encoding in ("utf-16",) if data.startswith((BOM_UTF16_LE, BOM_UTF16_BE)) else ("utf-8-sig", "gb2312"):
        with suppress(UnicodeDecodeError):
            return data.decode(encoding)
    return data.decode("latin-1")
