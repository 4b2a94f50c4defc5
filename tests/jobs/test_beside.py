"""Work in a second process: the same result as here, its faults too, and nothing lost where there is no process."""

import os
import subprocess
import sys
from collections.abc import Callable

import pytest

from trueaxis.jobs import beside as module
from trueaxis.jobs.beside import beside

Process = subprocess.Popen[bytes]


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch) -> list[Process]:
    """The processes that are started, two cores being there."""
    found: list[Process] = []
    start = module._started

    def remembered(name: str) -> Process | None:
        process = start(name)
        assert process is not None
        found.append(process)
        return process

    monkeypatch.setattr(module, "_started", remembered)
    monkeypatch.setattr(module, "cores", lambda: 2)
    return found


@pytest.mark.parametrize("cores", [1, 2])
def test_what_is_started_gives_its_result(cores: int, started: list[Process], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "cores", lambda: cores)
    with beside("math") as start:
        waiting = start("hypot", 3.0, 4.0)
        assert waiting() == 5.0
    assert len(started) == cores - 1


def test_it_is_another_process_where_there_is_more_than_one_core(
    started: list[Process], monkeypatch: pytest.MonkeyPatch
) -> None:
    with beside("os") as start:
        assert start("getpid")() == started[0].pid
    monkeypatch.setattr(module, "cores", lambda: 1)
    with beside("os") as start:
        assert start("getpid")() == os.getpid()


@pytest.mark.usefixtures("started")
@pytest.mark.parametrize("cores", [1, 2])
def test_a_fault_is_raised_where_the_result_is_asked_for(cores: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "cores", lambda: cores)
    with beside("math") as start:
        waiting = start("sqrt", -1.0)
        with pytest.raises(ValueError, match=r"math domain|nonnegative"):
            waiting()


def test_a_process_that_dies_loses_nothing(started: list[Process]) -> None:
    with beside("math") as start:
        started[0].kill()
        assert start("hypot", 3.0, 4.0)() == 5.0
    with beside("math") as start:
        waiting = start("hypot", 3.0, 4.0)
        started[1].kill()
        assert waiting() == 5.0


def test_nor_does_one_that_cannot_be_had(monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(*_: object, **__: object) -> Process:
        raise OSError

    monkeypatch.setattr(subprocess, "Popen", refused)
    with beside("math") as start:
        assert start("hypot", 3.0, 4.0)() == 5.0


def test_an_interruption_does_not_wait_for_the_second_process(started: list[Process]) -> None:
    def interrupted(start: Callable[..., object]) -> None:
        start("sleep", 3600.0)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt), beside("time") as begin:
        interrupted(begin)
    assert started[0].poll() is not None


def test_it_ends_when_the_first_process_is_gone() -> None:
    process = subprocess.Popen([sys.executable, "-m", module.__name__, "math"], stdin=subprocess.PIPE)
    assert process.stdin is not None
    process.stdin.close()
    assert process.wait(timeout=60.0) == 0
