"""Tasks on a cluster of processes: killed workers, tasks that need too much, order; nothing is lost."""

import os
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from tests.cluster import work
from trueaxis.cluster.tasks import Ended, Task, run_tasks
from trueaxis.cluster.workers import Workers, client_of

MEMORY = 400_000_000  # bytes of a worker: twice what one has that does nothing


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    with client_of(Workers(count=2, memory=MEMORY)) as found:
        yield found


def task(key: str, function: Any, *arguments: object, after: tuple[str, ...] = ()) -> Task:
    return Task(key=key, function=function, arguments=arguments, after=after)


def by_key(ended: Iterator[Ended]) -> dict[str, Ended]:
    found = list(ended)
    assert len({one.key for one in found}) == len(found)
    return {one.key: one for one in found}


def test_workers_are_processes_that_say_nothing(client: Any, capfd: pytest.CaptureFixture[str]) -> None:
    found = by_key(run_tasks(client, [task(str(n), work.square, n) for n in range(20)], ahead=2))
    assert {key: one.result[0] for key, one in found.items()} == {str(n): n**2 for n in range(20)}
    processes = {one.result[1] for one in found.values()}
    assert len(processes) == 2
    assert os.getpid() not in processes
    assert capfd.readouterr() == ("", "")


def test_workers_have_an_environment_of_their_own_and_this_process_keeps_its(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("PYTHONSAFEPATH", "PYTHONHASHSEED"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("OPENBLAS_NUM_THREADS", "2")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(Path.cwd()), "/elsewhere", ""]))
    before = dict(os.environ)
    with client_of(Workers(count=1, memory=MEMORY)) as client:
        of_worker = by_key(run_tasks(client, [task("e", work.environment)]))["e"].result
    assert (of_worker["OPENBLAS_NUM_THREADS"], of_worker["PYTHONSAFEPATH"]) == ("1", "1")
    assert of_worker["PYTHONWARNINGS"] == "ignore"  # Dask warns of a slow disk before a worker is silent
    assert of_worker["PYTHONPATH"] == "/elsewhere"
    assert dict(os.environ) == before


def test_nothing_of_it_is_reached_from_another_computer(client: Any) -> None:
    own = [psutil.Process(), *psutil.Process().children(recursive=True)]
    listening = [one.laddr for process in own for one in process.net_connections() if one.status == "LISTEN"]
    assert len(listening) >= 3
    assert {address.ip for address in listening} == {"127.0.0.1"}


def test_a_task_waits_for_those_it_names_and_no_longer(client: Any, tmp_path: Path) -> None:
    tasks = [
        task("b", work.noted, str(tmp_path), "b", after=("a",)),
        task("c", work.noted, str(tmp_path), "c", after=("b", "bad", "unknown")),
        task("a", work.noted, str(tmp_path), "a"),
        task("bad", work.raising),
    ]
    found = by_key(run_tasks(client, tasks))
    assert [name.partition("-")[0] for name in found["c"].result] == ["a", "b"]
    assert str(found["bad"].error) == "this one does not work"
    assert found["bad"].lost == 0


def test_a_worker_that_is_killed_costs_no_task_but_that_which_kills(
    client: Any, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    for name in ("others", "killed", "once"):
        (tmp_path / name).mkdir()
    others = [task(f"o{n}", work.slow, str(tmp_path / "others"), f"o{n}") for n in range(12)]
    tasks = [*others[:4], task("killed", work.killed, str(tmp_path / "killed")), *others[4:]]
    tasks += [task("once", work.killed_once, str(tmp_path / "once")), task("last", work.square, 2, after=("killed",))]
    found = by_key(run_tasks(client, tasks))
    assert found.keys() == {one.key for one in tasks}
    assert found["killed"].lost == 3  # a bounded number of times
    assert len(list((tmp_path / "killed").iterdir())) == 3
    assert found["once"].result == "done"
    assert found["last"].result[0] == 4
    assert [found[one.key].result for one in others] == [one.key for one in others]
    counts = Counter(path.name.partition("-")[0] for path in (tmp_path / "others").iterdir())
    assert counts.keys() == {one.key for one in others}
    assert counts.total() <= 12 + 4  # what a worker had done and not yet told when it was killed is done again
    assert capfd.readouterr() == ("", "")


def test_a_task_that_needs_too_much_memory_is_given_up(client: Any, capfd: pytest.CaptureFixture[str]) -> None:
    found = by_key(run_tasks(client, [task("hungry", work.hungry), *(task(str(n), work.square, n) for n in range(8))]))
    assert found["hungry"].lost == 3
    assert {found[str(n)].result[0] for n in range(8)} == {n**2 for n in range(8)}
    assert capfd.readouterr() == ("", "")


def test_nothing_is_left_of_it() -> None:
    before = {process.pid for process in psutil.Process().children(recursive=True)}
    with client_of(Workers(count=1)) as client:
        (ended,) = run_tasks(client, [task("a", work.square, 3)])
        assert ended.result[0] == 9
        workers = psutil.Process().children(recursive=True)
        assert len(workers) > len(before)
    left = {process.pid for process in psutil.Process().children(recursive=True)} - before
    assert not [pid for pid in left if any("spawn_main" in word for word in psutil.Process(pid).cmdline())]
