"""Work in a second process: the same result as here, its faults too, and nothing lost where there is no process."""

import math
import os
from concurrent.futures import Future
from concurrent.futures.process import BrokenProcessPool
from functools import partial

import pytest

from trueaxis.commands import beside as module
from trueaxis.commands.beside import beside


@pytest.mark.parametrize("worth", [True, False])
def test_what_is_started_gives_its_result(worth: bool) -> None:
    with beside("math", worth=worth) as start:
        waiting = start("hypot", 3.0, 4.0)
        assert waiting() == 5.0


def test_it_is_another_process_where_there_is_more_than_one_core(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "cpu_count", lambda: 2)
    with beside("os") as start:
        assert start("getpid")() != os.getpid()
    monkeypatch.setattr(os, "cpu_count", lambda: 1)
    with beside("os") as start:
        assert start("getpid")() == os.getpid()


@pytest.mark.parametrize("worth", [True, False])
def test_a_fault_is_raised_where_the_result_is_asked_for(worth: bool) -> None:
    with beside("math", worth=worth) as start:
        waiting = start("sqrt", -1.0)
        with pytest.raises(ValueError, match=r"math domain|nonnegative"):
            waiting()


def test_a_process_that_dies_loses_nothing() -> None:
    dead: Future[float] = Future()
    dead.set_exception(BrokenProcessPool())
    assert module._awaited(dead, partial(math.hypot, 3.0, 4.0)) == 5.0
