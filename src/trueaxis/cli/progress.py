"""One line of a terminal that says how far a command is; nothing where no person looks on."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from trueaxis.io.told import Told

Progress = Callable[[str], None]


@contextmanager
def progress() -> Iterator[Progress]:
    """Gives what shows a stage in the place of the last one; leaves no trace of it."""
    stream = sys.stderr
    if not isinstance(stream, Told) or not stream.isatty():
        yield lambda _: None
        return
    try:
        yield stream.show_status
    finally:
        stream.show_status("")
