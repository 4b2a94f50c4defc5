"""Commands that are killed or stopped at random moments leave whole files, and the next run clears up after them.

`python -m tests.test_stopping N` kills and stops each command N times and prints what was met.
"""

import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import psutil
import pytest

from tests.command_lines import COMMANDS, command_line, leftovers, prepare, run
from tests.loaded import Loaded
from tests.machines import ROOT

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")

SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)
AT_WORK = 1.3  # s of a processor, by which a command has loaded its libraries, however busy the machine is
FRESH = 3  # every so manieth command that is stopped loads its libraries first, as users' do
OF_PYTHON = 0.15  # s: before that a process may not have come to our code, and Python itself answers to a signal


def contents(folder: Path) -> dict[str, bytes]:
    """The files that a user sees below a folder."""
    found = {str(path.relative_to(folder)): path for path in folder.rglob("*") if path.is_file()}
    return {name: path.read_bytes() for name, path in found.items() if not name.split("/")[-1].startswith(".trueaxis-")}


class Trial:
    """A command in a folder of inputs, and what it writes when it is let alone.

    seconds: it takes as a user starts it, when its kernels are compiled, too; loaded_seconds: where its libraries are
    loaded and its kernels compiled.
    """

    def __init__(self, inputs: Path, name: str, scratch: Path, loaded: Loaded) -> None:
        self.inputs, self.name, self.out, self.loaded = inputs, name, scratch / name, loaded
        self.words, self.told = COMMANDS[name].format(out=self.out), scratch / f"told-{name}"
        compiler = scratch / f"cc-{name}"
        compiler.write_text('#!/bin/sh\nexec cc "$@" -O0\n')  # kernels that are soon compiled
        compiler.chmod(0o755)
        self.environment = {"TRUEAXIS_CACHE": str(scratch / f"cache-{name}"), "CC": str(compiler)}
        started = time.monotonic()
        done = run(inputs, self.words, env=self.environment)
        self.seconds = time.monotonic() - started
        assert done.returncode in (0, 1), done.stderr
        self.code, self.whole = done.returncode, contents(self.out)
        started = time.monotonic()
        assert self._run() == (self.code, ""), self.told.read_text()
        self.loaded_seconds = time.monotonic() - started
        assert contents(self.out) == self.whole
        # what a run meets: files of an earlier one
        self.old = {name: b"old " + content[:20] for name, content in self.whole.items()}

    def _run(self) -> tuple[int, str]:
        return self.loaded.start(self.inputs, self.words, self.told, self.environment).ended()

    def stopped(self, number: signal.Signals, share: float, cold: bool, fresh: bool) -> list[str]:
        """Faults met when the command gets a signal after this share of its time; cold: kernels are compiled anew;
        fresh: it has to load its libraries.
        """
        after = share * (self.seconds if fresh or cold else self.loaded_seconds)
        for name, content in self.old.items():
            (self.out / name).write_bytes(content)
        if cold:
            for library in Path(self.environment["TRUEAXIS_CACHE"]).rglob("*.so"):
                library.unlink()
        before = set(leftovers(self.out))  # of runs killed here, if this one is stopped before it clears up after them
        code, error = self._ended(number, after) if fresh else self._loaded_ended(number, after)
        faults = self._faults_of_files()
        if number != signal.SIGKILL:
            if code not in (128 + number, -number, self.code):
                faults.append(f"exit code {code}")
            if after > OF_PYTHON and ("Traceback" in error or "Exception ignored" in error):
                faults.append(f"traceback: {error[-300:]}")
            if code != -number and (left := sorted(set(leftovers(self.out)) - before)):
                faults.append(f"left behind: {left}")
        return [f"{number.name} after {after:.3f} s, fresh {fresh}: {fault}" for fault in faults]

    def _ended(self, number: signal.Signals, after: float) -> tuple[int, str]:
        process = subprocess.Popen(
            command_line(self.words), cwd=self.inputs, env=os.environ | self.environment,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
        )  # fmt: skip
        time.sleep(after)
        process.send_signal(number)
        _, error = process.communicate(timeout=120)
        return process.returncode, error

    def _loaded_ended(self, number: signal.Signals, after: float) -> tuple[int, str]:
        process = self.loaded.start(self.inputs, self.words, self.told, self.environment)
        time.sleep(after)
        process.send_signal(number)
        return process.ended()

    def _faults_of_files(self) -> list[str]:
        found = contents(self.out)
        faults = [f"{name} is new" for name in found.keys() - self.whole.keys()]
        faults += [f"{name} is gone" for name in self.whole.keys() - found.keys()]
        for name, content in found.items():
            if name in self.whole and content not in (self.old[name], self.whole[name]):
                faults.append(f"{name} is neither the old nor the new file")
        return faults

    def cleared(self) -> list[str]:
        """Faults of the next run: it writes everything, and nothing is left of those that were killed."""
        code, error = self._run()
        faults = [] if code == self.code else [f"the next run: {error}"]
        if contents(self.out) != self.whole:
            faults.append("the next run wrote something else")
        cache = Path(self.environment["TRUEAXIS_CACHE"])
        faults += [f"left behind: {name}" for name in leftovers(self.out)]
        if cache.exists():
            for library in cache.rglob("*.so"):  # compile once more: that is when a cache is swept
                library.unlink()
            self._run()
            faults += [f"left in the cache: {name}" for name in leftovers(cache)]
        return faults


def campaign(trial: Trial, count: int, seed: int) -> tuple[Counter[str], list[str]]:
    """Stop a command `count` times; how often by which signal, and the faults met."""
    draw = random.Random(f"{trial.name} {seed}")
    tally: Counter[str] = Counter()
    faults: list[str] = []
    for turn in range(count):
        number, share = draw.choice(SIGNALS), draw.uniform(0.0, 1.1)
        found = trial.stopped(number, share, cold=draw.random() < 0.3, fresh=turn % FRESH == 0)
        tally[number.name] += 1
        faults += [f"{trial.name}, {fault}" for fault in found]
    return tally, faults + [f"{trial.name}: {fault}" for fault in trial.cleared()]


@pytest.fixture(scope="module")
def loaded() -> Iterator[Loaded]:
    process = Loaded()
    yield process
    process.close()


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in COMMANDS if name != "init"])  # which refuses files of an earlier run
def test_every_command_may_be_stopped_at_any_moment(prepared: Path, tmp_path: Path, loaded: Loaded, name: str) -> None:
    _, faults = campaign(Trial(prepared, name, tmp_path, loaded), 6, seed=2)
    assert faults == []


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
@pytest.mark.parametrize("name", ["compensate", "diagnose", "demo"])
def test_the_code_names_the_signal(prepared: Path, tmp_path: Path, name: str, number: signal.Signals) -> None:
    if signal.getsignal(number) == signal.SIG_IGN:
        pytest.skip(f"{number.name} is ignored here, as nohup has it, and so by what is started")
    if name == "compensate":  # a program that takes long
        long = tmp_path / "long.nc"
        long.write_text("G90 G1 F1000 X270. Y350. Z150.\n" + "X280.\nX270.\n" * 400_000)
        words = COMMANDS[name].replace("part.nc", str(long)).format(out=tmp_path / "out")
    else:
        words = {**COMMANDS, "demo": "demo --out {out}"}[name].format(out=tmp_path / "out")
        words = words.replace("of_x", "regular")  # of all axes, which takes long enough
    told = tmp_path / "told.txt"  # a pipe that nobody reads would stop a command that says much
    with (
        told.open("w") as end,
        subprocess.Popen(
            command_line(words), cwd=prepared, stdout=subprocess.DEVNULL, stderr=end, start_new_session=True
        ) as process,
    ):
        while process.poll() is None and _worked(process.pid) < AT_WORK:
            time.sleep(0.01)
        process.send_signal(number)
        process.wait(timeout=60)
    error = told.read_text()
    assert process.returncode == 128 + number
    assert error.splitlines()[-1] == "trueaxis: stopped"
    assert "Traceback" not in error
    assert leftovers(tmp_path) == []
    assert name == "demo" or not (tmp_path / "out").exists()  # whose steps write as they end


def _worked(number: int) -> float:
    """Seconds of a processor of a process and of all that it has started."""
    process = psutil.Process(number)
    seconds: float = sum(process.cpu_times()[:4])  # with children that have ended
    for child in process.children(recursive=True):
        with suppress(psutil.NoSuchProcess):
            seconds += sum(child.cpu_times()[:4])
    return seconds


@pytest.mark.skipif(sys.platform != "linux", reason="prctl of Linux")
def test_a_command_does_not_outlive_the_tests(tmp_path: Path) -> None:
    code = (
        "import subprocess, sys, time\nfrom tests.command_lines import command_line\n"
        "process = subprocess.Popen(command_line(f'demo --out {sys.argv[1]}'), stdout=subprocess.DEVNULL)\n"
        "print(process.pid, flush=True)\ntime.sleep(60)"
    )
    words = [sys.executable, "-c", code, str(tmp_path / "out")]
    with subprocess.Popen(words, cwd=ROOT, stdout=subprocess.PIPE, text=True) as tests:
        assert tests.stdout is not None
        command = int(tests.stdout.readline())
        while not (tmp_path / "out").exists():  # it is at work
            assert tests.poll() is None, "the command did not start"
            time.sleep(0.02)
        tests.kill()
    status = Path(f"/proc/{command}/status")
    end = time.monotonic() + 20.0
    while status.exists() and "\nState:\tZ" not in status.read_text():
        assert time.monotonic() < end, "the command runs on"
        time.sleep(0.02)


def test_a_signal_that_was_ignored_stays_ignored() -> None:
    code = (
        "import os, signal, sys; signal.signal(signal.SIGHUP, signal.SIG_IGN)\n"
        "from trueaxis.stopping import stoppable\n"
        "with stoppable(): os.kill(os.getpid(), signal.SIGHUP); print('went on')"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, cwd=ROOT)
    assert (done.returncode, done.stdout) == (0, "went on\n")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        prepare(Path(place) / "inputs")
        total: Counter[str] = Counter()
        met: list[str] = []
        once = Loaded()
        for command in COMMANDS:
            trial = Trial(Path(place) / "inputs", command, Path(place), once)
            tally, faults = campaign(trial, int(sys.argv[1]), seed=3)
            total += tally
            met += faults
        once.close()
        print(f"{sum(total.values())} runs of {len(COMMANDS)} commands stopped: {dict(sorted(total.items()))}")
        print(f"{len(met)} faults", *met, sep="\n")


def test_a_library_that_swallows_the_request_does_not_undo_it() -> None:
    """As NumPy does, whose start imports datetime and takes every failure for a broken installation."""
    code = (
        "import os, signal\nfrom trueaxis.stopping import Stopped, stoppable\n"
        "try:\n  with stoppable():\n    try:\n      os.kill(os.getpid(), signal.SIGTERM)\n"
        "    except BaseException:\n      raise ImportError('a bad install') from None\n"
        "except Stopped as stopped:\n  raise SystemExit(stopped.code)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (143, "")


def test_a_request_that_python_cannot_pass_on_is_made_again() -> None:
    """As in a finaliser or a callback of a compiled library: Python prints what is raised there, and goes on."""
    code = (
        "import os, signal, sys, time\nfrom trueaxis.stopping import Stopped, stoppable\n"
        "class Ends:\n  def __del__(self):\n    os.kill(os.getpid(), signal.SIGTERM)\n    time.sleep(1.0)\n"
        "try:\n  with stoppable():\n    Ends()\n    time.sleep(30.0)\n"
        "except Stopped as stopped:\n  sys.exit(stopped.code)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=20.0)
    assert (done.returncode, done.stderr) == (143, "")


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="a signal is raised at once where there are no timers")
def test_a_compiled_library_that_looks_for_numpy_is_not_disturbed() -> None:
    """It panics, and says so, where it cannot ask NumPy for its version."""
    code = (
        "import os, re, signal, sys, time\nfrom trueaxis.stopping import Stopped, stoppable\n"
        "import numpy.lib._version as version\n"
        "class Stops:\n  def match(self, *_):\n    os.kill(os.getpid(), signal.SIGTERM)\n"
        "    time.sleep(0.01)\n    print('asked', flush=True)\n    return re.match(r'.*', '1.0.0')\n"
        "version.re = Stops()\n"
        "try:\n  with stoppable():\n    version.NumpyVersion('1.0.0')\n    time.sleep(30.0)\n"
        "except Stopped as stopped:\n  sys.exit(stopped.code)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=20.0)
    assert (done.returncode, done.stdout, done.stderr) == (143, "asked\n", "")


SWALLOWS = """
import time
print("loading", flush=True)
end = time.monotonic() + 1.0
while time.monotonic() < end:
    try:
        time.sleep(0.05)
    except BaseException:
        pass
"""
LOADS = """
import sys, time
from trueaxis.stopping import Stopped, stoppable
try:
    with stoppable():
        import swallows
        time.sleep(30.0)
except Stopped as stopped:
    sys.exit(stopped.code)
"""


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="a signal is raised at once where there are no timers")
def test_a_signal_that_a_library_would_swallow_as_it_loads_stops_after_that(tmp_path: Path) -> None:
    (tmp_path / "swallows.py").write_text(SWALLOWS)
    paths = os.pathsep.join([str(tmp_path), str(ROOT / "src")])
    process = subprocess.Popen(
        [sys.executable, "-c", LOADS], env=os.environ | {"PYTHONPATH": paths}, stdout=subprocess.PIPE, text=True
    )
    try:
        assert process.stdout is not None
        assert process.stdout.readline() == "loading\n"
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=20.0) == 130
    finally:
        process.kill()
        process.communicate()
