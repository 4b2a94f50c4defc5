"""What workers are given to do in tests: functions of a module that they can import."""

import os
import signal
import sys
import time
from pathlib import Path


def square(number: int) -> tuple[int, int]:
    print("a worker speaks", number)
    print("and complains", file=sys.stderr)
    return number**2, os.getpid()


def noted(folder: str, name: str) -> list[str]:
    """What was there before this one; leaves a trace of each time that it is called."""
    before = sorted(path.name for path in Path(folder).iterdir())
    Path(folder, f"{name}-{os.getpid()}-{time.monotonic_ns()}").touch()
    return before


def slow(folder: str, name: str) -> str:
    time.sleep(0.2)
    noted(folder, name)
    return name


def killed(folder: str) -> None:
    noted(folder, "killed")
    os.kill(os.getpid(), signal.SIGKILL)


def killed_once(folder: str) -> str:
    if not noted(folder, "once"):
        os.kill(os.getpid(), signal.SIGKILL)
    return "done"


def hungry() -> None:
    taken = []
    while True:
        taken.append(b"x" * 20_000_000)
        time.sleep(0.005)


def raising() -> None:
    raise RuntimeError("this one does not work")


def environment() -> dict[str, str]:
    return dict(os.environ)
