"""What `diagnose` costs: python -m benchmarks.diagnose [--cores N]

The standard campaign of the tests' generator (three axes, twelve laser lines three times each, circles by ball bar, one
effect hidden, the whole library) with more and more targets and samples. Each size in a process of its own, all stages
in one thread: seconds of the processor, and the largest memory of the process, Python and libraries included. Then the
whole command by the clock, on so many cores, where the system lets a process choose them (Linux). With two of them a
second process does the stages with a star.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import contextmanager, redirect_stdout
from importlib import import_module
from pathlib import Path

import numpy as np

from tests.hidden_effects.case import Case, generate
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from trueaxis.cli.main import ONE_THREAD
from trueaxis.cli.main import main as trueaxis

SIZES = (3_750, 15_000, 60_000)
LINES, REPEATS, CIRCLES = 12, 3, 12
SHARE = 0.6  # of the readings that are on lines
ROOT = Path(__file__).parents[1]
START, REST, WHOLE, CLOCK, MEMORY = "start", "rest", "all stages", "command, by the clock", "memory, MiB"
STAGES = (  # functions, and the stage that their time counts for; of one within another, for the inner one
    ("cli.diagnose", "_read", "reading"),
    ("diagnosis.null_model.null", "noise_of_runs", "noise"),
    ("diagnosis.procedure", "null_of", "null"),
    ("diagnosis.procedure", "again", "null"),
    ("diagnosis.procedure", "readings_of", "null"),
    ("diagnosis.procedure", "_searched", "search"),
    ("diagnosis.procedure", "likeliest", "search"),
    ("diagnosis.judging.judgement", "with_rivals", "search"),
    ("diagnosis.procedure", "with_best_periods", "search"),
    ("diagnosis.procedure", "audit", "audit"),
    ("diagnosis.judging.judgement", "amplitudes_of", "checks"),
    ("diagnosis.judging.judgement", "run_checks", "checks"),
    ("diagnosis.judging.judgement", "stale_values", "stale"),
    ("diagnosis.judging.judgement", "contest", "stale"),
    ("diagnosis.judging.judgement", "instruments_off", "stale"),
    ("diagnosis.judging.judgement", "misfits", "runs"),
    ("diagnosis.procedure", "fit", "gain"),
    ("diagnosis.procedure", "predicted", "gain"),
    ("diagnosis.write_up", "fit", "gain"),
    ("diagnosis.write_up", "predicted", "gain"),
    ("diagnosis.procedure", "prospect_of", "next runs"),
    ("diagnosis.write_up", "ahead_of", "next runs"),
    ("diagnosis.write_up", "next_runs", "next runs"),
    ("diagnosis.procedure", "identified_anew", "values anew"),
    ("jobs.drawn_and_derived", "drawn_and_derived", "kernels *"),
    ("jobs.drawn_and_derived", "pictures_of", "figures *"),
    ("reporting.diagnosis.html", "report_html", "writing"),
    ("reporting.diagnosis.json_file", "diagnosis_json", "writing"),
)


class Stages:
    """Seconds of the processor, by stage."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {START: time.process_time()}
        self._within = [REST]
        self._since = time.process_time()

    def change(self, within: list[str]) -> None:
        """The time since the last change counts for the stage until now."""
        now = time.process_time()
        stage = self._within[-1]
        self.seconds[stage] = self.seconds.get(stage, 0.0) + now - self._since
        self._within, self._since = within, now

    def watch(self, module: str, name: str, stage: str) -> None:
        """The time of a function counts for a stage."""
        home = import_module(f"trueaxis.{module}")
        function: Callable[..., object] = getattr(home, name)

        def timed(*args: object, **kwargs: object) -> object:
            before = self._within
            self.change([*before, stage])
            try:
                return function(*args, **kwargs)
            finally:
                self.change(before)

        setattr(home, name, timed)


class InTurn:
    """Takes the place of a pool of threads: one thing after another."""

    def __init__(self, _: int) -> None:
        self.map = map

    def __enter__(self) -> "InTurn":
        return self

    def __exit__(self, *_: object) -> None:
        return None


@contextmanager
def _here(module: str):  # type: ignore[no-untyped-def]
    """Takes the place of a second process: the call is made here."""
    yield lambda function, *given: lambda: getattr(import_module(module), function)(*given)


def made(folder: Path, readings: int) -> None:
    """Files of a case, in a folder."""
    targets = round(SHARE * readings / (2 * LINES * REPEATS))
    samples = round((1.0 - SHARE) * readings / CIRCLES)
    design = Design(repeats=REPEATS, targets=targets, samples=samples)
    generate(Case(seed=1, design=design, effects=(Hidden("backlash", "EXX", size=2e-3),))).write(folder)
    with Path(os.devnull).open("w", encoding="utf-8") as nothing, redirect_stdout(nothing):
        trueaxis(["derive", str(folder / "machine.toml"), "--out", str(folder / "kernels")])


def _words(folder: Path) -> list[str]:
    words = ["diagnose", folder / "machine.toml", "--errors", folder / "errors.json", "--data", folder / "data"]
    return [str(one) for one in [*words, "--kernels", folder / "kernels", "--out", folder / "found"]]


def of_stages(folder: Path) -> None:
    """Run the command in this process, and print what each stage took."""
    stages = Stages()
    for module, name, stage in STAGES:
        stages.watch(module, name, stage)
    import_module("trueaxis.jobs.diagnose").ThreadPoolExecutor = InTurn  # type: ignore[attr-defined]
    import_module("trueaxis.cli.diagnose").beside = _here  # type: ignore[attr-defined]
    stages.seconds[START] = time.process_time()
    stages.change([REST])
    trueaxis(_words(folder))
    stages.change([REST])
    found = {**stages.seconds, WHOLE: sum(stages.seconds.values())}
    found[MEMORY] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(json.dumps(found), file=sys.stderr)


def measured(readings: int) -> tuple[int, dict[str, float]]:
    """Readings written, and what they cost, by a process of its own."""
    environment = {**dict.fromkeys(ONE_THREAD, "1"), **os.environ}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        made(folder, readings)
        one = [sys.executable, "-m", "benchmarks.diagnose", "--case", name]
        done = subprocess.run(
            one, check=True, cwd=ROOT, env=environment, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL
        )
        found = json.loads(done.stderr.decode().strip().splitlines()[-1])
        start = time.perf_counter()
        command = [sys.executable, "-m", "trueaxis", *_words(folder)]
        done = subprocess.run(command, check=False, stdout=subprocess.DEVNULL)
        assert done.returncode in (0, 1), "0: named or noise, 1: several causes, or none that is known"
        found[CLOCK] = time.perf_counter() - start
        used = len((folder / "data" / "readings.csv").read_text().splitlines()) - 1
    return used, found


def main() -> int:
    """Every size, and by which power of the readings each stage grows."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--cores", type=int, default=2, help="cores to be used (%(default)s)")
    parser.add_argument("--case", type=Path, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.case:
        of_stages(options.case)
        return 0
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[: options.cores])
    cases = [measured(size) for size in SIZES]
    names = [*dict.fromkeys(stage for *_, stage in STAGES)]
    print(f"{'seconds of the processor':24s}" + "".join(f"{used:9d}" for used, _ in cases) + "    power")
    for name in (START, *names, REST, WHOLE, CLOCK, MEMORY):
        costs = np.array([max(found.get(name, 0.0), 1e-3) for _, found in cases])
        power = np.log(costs[-1] / costs[-2]) / np.log(cases[-1][0] / cases[-2][0])
        print(f"{name:24s}" + "".join(f"{cost:9.2f}" for cost in costs) + f"{power:9.2f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
