"""Cases run in a process that is watched: what crashes it, or takes too long, is a finding as well."""

import functools
import multiprocessing
import os
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from pathlib import Path

from tests.fuzz.judge import Case, Outcome, case_of, judged, minimised
from tests.fuzz.readers import DRILLS, READERS, Reader
from trueaxis.model import kernels

SECONDS = 20.0  # a case may take, and one more for every SLOWEST bytes: the machine may be busy
SLOWEST = 20_000
PATIENCE = 10  # times SECONDS, for a case that waits for the processor, or for ever
SAVED = 3  # inputs of one problem


@dataclass
class Tally:
    """What came of the cases: how many of each reader and state; findings by reader and problem, with seeds."""

    states: Counter[tuple[str, str]] = field(default_factory=Counter)
    findings: dict[tuple[str, str], list[int]] = field(default_factory=dict)
    details: dict[tuple[str, str], str] = field(default_factory=dict)

    def lines(self) -> list[str]:
        """A table: a line per reader, then one per finding."""
        states = ("read", "refused", "done", "answered no", "finding")
        lines = [f"{'reader':18} {'inputs':>8} " + " ".join(f"{state:>12}" for state in states)]
        for name in dict.fromkeys(name for name, _ in self.states):
            counts = [self.states[name, state] for state in states]
            lines.append(f"{name:18} {sum(counts):8} " + " ".join(f"{count:12}" for count in counts))
        lines.append(f"{'all':18} {sum(self.states.values()):8}")
        for (name, problem), seeds in self.findings.items():
            lines.append(f"FINDING {name}: {problem} ({len(seeds)} inputs, seeds {seeds[:5]})")
        return lines


class Worker:
    """The watched process. It is started anew after it died or had to be stopped."""

    def __enter__(self) -> "Worker":
        self._start()
        return self

    def __exit__(self, *_: object) -> None:
        self._stop()

    def _start(self) -> None:
        # Not forked: the libraries' threads would be missing in the copy.
        context = multiprocessing.get_context("spawn")
        self._pipe, theirs = context.Pipe()
        self._process = context.Process(target=_work, args=(theirs,), daemon=True)
        self._process.start()
        theirs.close()
        if not self._pipe.poll(120):
            raise TimeoutError("the process of the campaign does not start")
        self._pipe.recv()

    def _stop(self) -> None:
        self._process.kill()
        self._process.join()
        self._pipe.close()

    def _in_time(self, size: int) -> bool:
        """Whether the case that has not ended in SECONDS, of files of that size, ends before it has had enough time.

        Of a process that others keep waiting its own time counts, as far as the system tells it.
        """
        start, own = time.monotonic(), Path(f"/proc/{self._process.pid}/schedstat")
        used = int(own.read_text().split()[0]) if own.exists() else None
        while time.monotonic() - start < PATIENCE * SECONDS:
            if self._pipe.poll(1.0):
                return True
            now = int(own.read_text().split()[0]) if own.exists() else None
            had = time.monotonic() - start if used is None or now is None else (now - used) * 1e-9
            if had > SECONDS + size / SLOWEST:
                return False
        return False

    def outcome(self, reader: Reader, seed: int, valid: bool = False) -> Outcome:
        """What comes of a case."""
        self._pipe.send((reader.name, seed, valid))
        if not self._pipe.poll(SECONDS) and not self._in_time(max(map(len, case_of(reader, seed).files.values()))):
            self._stop()
            self._start()
            return Outcome("finding", "takes too long")
        try:
            found: Outcome = self._pipe.recv()
        except EOFError:
            self._stop()
            self._start()
            return Outcome("finding", "the process dies")
        return found


def _work(pipe: Connection) -> None:
    os.environ.update(TRUEAXIS_BACKEND="numpy", OPENBLAS_NUM_THREADS="1")
    warnings.simplefilter("ignore")
    kernels._module = functools.cache(kernels._module)  # read once: nothing changes them here
    readers = {reader.name: reader for reader in (*READERS, *DRILLS)}
    shared = Path("/dev/shm")
    with tempfile.TemporaryDirectory(dir=shared if shared.is_dir() else None) as folder:
        pipe.send("ready")
        while True:
            try:
                name, seed, valid = pipe.recv()
            except EOFError:
                return
            reader = readers[name]
            pipe.send(judged(reader, case_of(reader, seed, valid=valid), Path(folder) / "case"))


def run(readers: Sequence[Reader], seeds: Iterable[int], seconds: float, save: Path | None = None) -> Tally:
    """Run the cases of the seeds, reader by reader in turn, until the time is over; save findings in a folder."""
    tally, end = Tally(), time.monotonic() + seconds
    with Worker() as worker:
        for seed in seeds:
            for reader in readers:
                if seed % reader.every:
                    continue
                if time.monotonic() > end:
                    return tally
                outcome = worker.outcome(reader, seed)
                tally.states[reader.name, outcome.state] += 1
                if outcome.problem:
                    key = reader.name, outcome.problem
                    tally.findings.setdefault(key, []).append(seed)
                    tally.details.setdefault(key, outcome.detail)
                    if save is not None and len(tally.findings[key]) <= SAVED:
                        _save(save, reader, seed, outcome)
    return tally


def _save(folder: Path, reader: Reader, seed: int, outcome: Outcome) -> None:
    """The files of a finding, the hostile one made small where that needs no watched process."""
    case: Case = case_of(reader, seed)
    if outcome.detail:  # else it takes too long, or dies
        with tempfile.TemporaryDirectory() as scratch, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            case = minimised(reader, case, outcome.problem, Path(scratch) / "case")
    target = folder / f"{reader.name}-{seed}"
    for name, content in case.files.items():
        path = target / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    how = "trueaxis " + " ".join(reader.command) if case.by_command else "the reading function"
    (target / "finding.txt").write_text(f"{reader.file}: {outcome.problem}\n{how}\n\n{outcome.detail}\n")
