"""The workers of a scheduler that runs already, and what is no such thing."""

import socket
import subprocess
import sys
import time
from contextlib import ExitStack
from pathlib import Path

import pytest

from tests.cluster import work
from tests.cluster.running import ENVIRONMENT, scheduler, worker_processes
from trueaxis.cluster.tasks import Task, run_tasks
from trueaxis.cluster.workers import Workers, client_of
from trueaxis.io.faults import InputError


def refused(address: str) -> str:
    start = time.monotonic()
    with pytest.raises(InputError) as error, client_of(Workers(scheduler=address)):
        pytest.fail("there is no such scheduler")
    assert time.monotonic() - start < 15.0
    (fault,) = error.value.faults
    assert fault.file == f"--scheduler {address}"
    return str(fault)


def test_its_workers_do_the_work() -> None:
    with scheduler() as address, ExitStack() as stack:
        assert "has no workers" in refused(address)
        stack.enter_context(worker_processes(address))
        client = stack.enter_context(client_of(Workers(scheduler=address)))
        tasks = [Task(key=str(n), function=work.square, arguments=(n,)) for n in range(10)]
        found = {one.key: one.result[0] for one in run_tasks(client, tasks)}
        assert found == {str(n): n**2 for n in range(10)}


def test_where_nothing_listens_is_told_at_once() -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        port = taken.getsockname()[1]
    start = time.monotonic()
    assert "nothing answers there: Connection refused" in refused(f"tcp://127.0.0.1:{port}")
    assert time.monotonic() - start < 3.0


def test_another_service_is_no_scheduler(capfd: pytest.CaptureFixture[str]) -> None:
    with socket.socket() as mute:
        mute.bind(("127.0.0.1", 0))
        mute.listen()
        told = refused(f"tcp://127.0.0.1:{mute.getsockname()[1]}")
    assert "no Dask scheduler answers there within 5 s" in told
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("address", ["", "nowhere", "tcp://", "http://127.0.0.1:80", "tcp://127.0.0.1:x", "1.2.3.4"])
def test_what_is_no_address_is_told(address: str) -> None:
    assert "is no address; an address such as tcp://" in refused(address)


def test_without_the_package_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("trueaxis.cluster.workers.find_spec", lambda _: None)
    with pytest.raises(InputError, match=r"pip install 'trueaxis\[cluster\]'"), client_of(Workers()):
        pytest.fail("Dask is not installed")


def test_nothing_of_the_program_needs_dask_before_it_is_asked_for() -> None:
    code = (
        "import sys, trueaxis.cli.main as m; m.build_parser()\n"
        "import trueaxis.jobs.fleet\n"
        "print(sorted({n.split('.')[0] for n in sys.modules} & {'dask', 'distributed', 'tornado'}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=Path("/"),
                          env=ENVIRONMENT)  # fmt: skip
    assert done.stdout.strip() == "[]"
