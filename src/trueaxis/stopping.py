"""A signal that asks the program to stop ends it in order: what is half done is undone, and the exit code says why."""

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

_LATER = 0.02  # s, after which a request that could not be met is made again
_IMPORTING = "<frozen importlib"  # file of the frames of Python's imports
# file of the frames in which a compiled library asks NumPy how old it is, when it first uses it (rust-numpy: it panics)
_ASKED_ITS_VERSION = "numpy/lib/_version.py"
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
    A signal that was ignored from the start (nohup) stays ignored. What is raised in a library that is being imported
    may be swallowed there, or turned into an error of its own (NumPy: ImportError): where there are timers it is raised
    after the import, and after a signal any error, and an end as if nothing had been, are the request to stop. Raised
    where Python cannot pass it on (a callback of a compiled library), it is raised once more a moment later.
    """
    numbers = [getattr(signal, name) for name in _NAMES if hasattr(signal, name)]
    numbers = [number for number in numbers if signal.getsignal(number) is not signal.SIG_IGN]

    def ignore() -> None:
        for number in numbers:
            signal.signal(number, signal.SIG_IGN)

    asked: list[int] = []

    def stop(number: int, frame: FrameType | None) -> None:
        ignore()
        asked.append(number)
        stop_now(number, frame)

    def stop_now(_: int, frame: FrameType | None) -> None:
        if hasattr(signal, "setitimer") and _cannot_pass_on(frame):
            stop_later()
        else:
            raise Stopped(asked[0])

    def stop_later() -> None:
        if hasattr(signal, "setitimer"):
            signal.signal(signal.SIGALRM, stop_now)
            signal.setitimer(signal.ITIMER_REAL, _LATER)

    def lost(what: "sys.UnraisableHookArgs") -> None:
        if isinstance(what.exc_value, Stopped):
            stop_later()
        else:
            told_before(what)

    told_before = sys.unraisablehook
    sys.unraisablehook = lost
    for number in numbers:
        signal.signal(number, stop)
    try:
        yield
    except Exception:
        if asked:
            raise Stopped(asked[0]) from None
        raise
    else:
        if asked:
            raise Stopped(asked[0])
    finally:
        ignore()
        if asked and hasattr(signal, "setitimer"):
            signal.setitimer(signal.ITIMER_REAL, 0.0)
        sys.unraisablehook = told_before


def _cannot_pass_on(frame: FrameType | None) -> bool:
    """Whether a library is being set up where the program is, a module imported or NumPy found by a compiled one."""
    while frame is not None:
        file = frame.f_code.co_filename.replace("\\", "/")
        if file.startswith(_IMPORTING) or file.endswith(_ASKED_ITS_VERSION):
            return True
        frame = frame.f_back
    return False
