"""A signal that asks the program to stop ends it in order: what is half done is undone, and the exit code says why."""

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

_NAMES = ("SIGINT", "SIGTERM", "SIGHUP")  # the last is not known to every system


class Stopped(BaseException):
    """Raised where the program is when it is asked to stop. code: its exit code, as shells have it."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.code = 128 + number


@contextmanager
def stoppable() -> Iterator[None]:
    """Raise Stopped in this process's main thread at the first signal; later ones do not disturb the clearing up.

    Afterwards such signals are ignored: all is done, and Python's own end is not to be interrupted halfway.
    A signal that was ignored from the start (nohup) stays ignored. A library that is being imported may turn what is
    raised in it into an error of its own (NumPy: ImportError): after a signal any error is the request to stop.
    """
    numbers = [getattr(signal, name) for name in _NAMES if hasattr(signal, name)]
    numbers = [number for number in numbers if signal.getsignal(number) is not signal.SIG_IGN]

    def ignore() -> None:
        for number in numbers:
            signal.signal(number, signal.SIG_IGN)

    asked: list[int] = []

    def stop(number: int, _: FrameType | None) -> None:
        ignore()
        asked.append(number)
        raise Stopped(number)

    for number in numbers:
        signal.signal(number, stop)
    try:
        yield
    except Exception:
        if asked:
            raise Stopped(asked[0]) from None
        raise
    finally:
        ignore()
