"""One line of a terminal that says how far a command is; nothing where no person looks on, but with -v a line each."""

import logging
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from trueaxis.io.told import Told

_LOG = logging.getLogger(__name__)
Progress = Callable[[str], None]


@contextmanager
def progress() -> Iterator[Progress]:
    """Gives what shows a stage in the place of the last one; leaves no trace of it."""
    stream = sys.stderr
    if not isinstance(stream, Told) or not stream.isatty() or _LOG.getEffectiveLevel() != logging.WARNING:
        yield _logged
        return
    try:
        yield stream.show_status
    finally:
        stream.show_status("")


def _logged(stage: str) -> None:
    if stage:
        _LOG.info("%s", stage)
