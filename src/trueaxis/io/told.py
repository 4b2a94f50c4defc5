"""Standard output and error as the program writes them: every text is safe to show, and no failure is lost."""

import errno
import io
import os
import sys
from contextlib import suppress
from types import TracebackType
from typing import TextIO

from trueaxis.io.safe_text import escaped

NOT_DELIVERED = 1  # exit code: all was done, but standard output could not take the text
_LAYOUT = "\n\t"


class Told(io.TextIOBase):
    """A text stream that escapes control characters and does not raise when its reader is gone or its disk full.

    failure: the first OSError met while writing, after which nothing more is written; None if there was none.
    """

    def __init__(self, stream: TextIO | None) -> None:
        super().__init__()
        self._stream = stream
        self.failure: OSError | None = None

    def fileno(self) -> int:
        """That of the stream; raises OSError where there is none."""
        if self._stream is None:
            raise OSError(errno.EBADF, os.strerror(errno.EBADF))
        return self._stream.fileno()

    def isatty(self) -> bool:
        """Whether a person looks on."""
        return self._stream is not None and self._stream.isatty()

    def writable(self) -> bool:
        """Always."""
        return True

    def write(self, text: str) -> int:
        """Write the text with control characters, line ends aside, as escapes."""
        self._write(escaped(text, _LAYOUT))
        return len(text)

    def show_status(self, text: str) -> None:
        """Show one line of a terminal in the place of the last such line; an empty text clears it."""
        self._write(f"\r{escaped(text)}\x1b[K\r")
        self.flush()

    def flush(self) -> None:
        """Hand on what was written."""
        if self._stream is not None and self.failure is None:
            try:
                self._stream.flush()
            except OSError as error:
                self.failure = error

    def _write(self, text: str) -> None:
        if self.failure is not None or not text:
            return
        try:
            if self._stream is None:
                raise OSError(errno.EBADF, os.strerror(errno.EBADF))
            encoding = self._stream.encoding or "utf-8"
            self._stream.write(text.encode(encoding, "backslashreplace").decode(encoding))
        except OSError as error:
            self.failure = error


class StandardStreams:
    """A context in which sys.stdout and sys.stderr are Told. out, error: the two."""

    def __init__(self) -> None:
        self._before = sys.stdout, sys.stderr
        self.out, self.error = Told(sys.stdout), Told(sys.stderr)

    def __enter__(self) -> "StandardStreams":
        sys.stdout, sys.stderr = self.out, self.error
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None
    ) -> None:
        for told, stream in zip((self.out, self.error), self._before, strict=True):
            told.flush()
            if told.failure is not None and stream is not None:
                _give_up(stream)
        sys.stdout, sys.stderr = self._before


def _give_up(stream: TextIO) -> None:
    """Let what the stream still holds go nowhere: Python would try once more at its end, and complain."""
    with suppress(OSError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)
