"""Which lines and branches of the source the tests run, counted in all workers together, without tracing.

A plugin of pytest that has to be loaded before anything of the project is imported: dev.py names it in PYTEST_PLUGINS
where all tests are run. Code notes that it has run until it has done so often, then it runs as if nothing were counted.
"""

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings
from slipcover import FileMatcher, ImportManager, Slipcover, merge_coverage, print_coverage

ROOT = Path(__file__).resolve().parent.parent  # not from tests.machines, which imports what is to be counted
SOURCE = ROOT / "src" / "trueaxis"
TABLE = ROOT / "build" / "coverage.txt"
LEAST = 95  # percent of the lines and branches
SHOWN = 8  # files that miss most: a change that leaves much out is among them
_ALL = pytest.StashKey[dict[str, Any]]()

counted = Slipcover(branch=True)
from_workers: list[str] = []
ImportManager(counted, FileMatcher(sources=[SOURCE])).__enter__()  # for as long as the process lives
# Code is changed to note nothing more in the midst of any example, which may then take longer than others.
settings.register_profile("covered", settings(), deadline=None)
settings.load_profile("covered")


@pytest.hookimpl(optionalhook=True)  # of xdist
def pytest_testnodedown(node: Any) -> None:
    """What a worker has counted, unless it was lost."""
    if hasattr(node, "workeroutput"):
        from_workers.append(node.workeroutput["covered"])


def pytest_sessionfinish(session: pytest.Session) -> None:
    """A worker hands on what it has counted; all of it together fails the run where it is too little."""
    if hasattr(session.config, "workeroutput"):
        session.config.workeroutput["covered"] = json.dumps(counted.get_coverage())
        return
    counted.source = [str(SOURCE)]  # files that nothing imported count as well
    found = counted.get_coverage()
    for one in from_workers:
        merge_coverage(found, json.loads(one))
    session.config.stash[_ALL] = found
    if session.exitstatus == pytest.ExitCode.OK and found["summary"]["percent_covered"] < LEAST:
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """The share, the files that miss most, and where the lines are."""
    found = terminalreporter.config.stash[_ALL]
    TABLE.parent.mkdir(exist_ok=True)
    with TABLE.open("w", encoding="utf-8") as file:
        print_coverage(found, outfile=file, skip_covered=True)
    terminalreporter.section("coverage")
    share = found["summary"]["percent_covered"]
    terminalreporter.line(f"{share:.2f} % of lines and branches; {LEAST} % is the least. Missing, by line: {TABLE}")
    missing = {path: len(one["missing_lines"]) + len(one["missing_branches"]) for path, one in found["files"].items()}
    for path in sorted(missing, key=lambda path: -missing[path])[:SHOWN]:
        terminalreporter.line(f"{missing[path]:5} {path}")
