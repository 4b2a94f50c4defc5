"""How long `diagnose` takes and what memory it needs: python -m benchmarks.diagnose [--cores N]

The standard campaign of the tests' generator (three axes, twelve laser lines three times each, circles by ball bar, one
effect hidden) with more and more targets and samples; realistic noise. Each size in a process of its own: memory is the
largest size of that process less that before. Ratios of one run: time per reading, over that of the smallest size. Then
the whole command, from the start of Python to the last file written: search, report, extended machine derived, its
values found anew. All of it on so many cores, where the system lets a process choose them (Linux).
"""

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tests.hidden_effects.case import Case, generate
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from trueaxis.cli import ONE_THREAD
from trueaxis.cli import main as trueaxis
from trueaxis.commands.beside import cores
from trueaxis.diagnose.procedure import DiagnoseOptions, diagnose
from trueaxis.diagnose.rows import rows_of
from trueaxis.measure.data import read_data
from trueaxis.runtime.model import load_model

SIZES = (2_500, 10_000, 40_000)
LINES, REPEATS, CIRCLES = 12, 3, 12
SHARE = 0.6  # of the readings that are on lines
ROOT = Path(__file__).parents[1]


def case(readings: int) -> None:
    """Diagnose once, and print what it took."""
    targets = round(SHARE * readings / (2 * LINES * REPEATS))
    samples = round((1.0 - SHARE) * readings / CIRCLES)
    design = Design(repeats=REPEATS, targets=targets, samples=samples)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        generate(Case(seed=1, design=design, effects=(Hidden("backlash", "EXX", size=2e-3),))).write(folder)
        trueaxis(["derive", str(folder / "machine.toml"), "--out", str(folder / "kernels")])
        model = load_model(folder / "machine.toml", folder / "errors.json", folder / "kernels")
        data = read_data(folder / "data", model.machine)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        start = time.perf_counter()
        with ThreadPoolExecutor(cores()) as pool:
            found = diagnose(model, data, DiagnoseOptions(each=pool.map))
        seconds = time.perf_counter() - start
        memory = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
        whole = _command(folder)
    causes = ", ".join(one.effect.label for one in found.causes) or "none"
    print(f"{rows_of(data).size} {seconds:.3f} {whole:.3f} {memory:.0f} {found.verdict}: {causes}", file=sys.stderr)


def _command(folder: Path) -> float:
    """Seconds of `trueaxis diagnose`."""
    words = ["diagnose", folder / "machine.toml", "--errors", folder / "errors.json", "--data", folder / "data"]
    words += ["--kernels", folder / "kernels", "--out", folder / "found"]
    start = time.perf_counter()
    done = subprocess.run([sys.executable, "-m", "trueaxis", *map(str, words)], check=False, stdout=subprocess.DEVNULL)
    assert done.returncode in (0, 1), "0: named or noise, 1: several causes, or none that is known"
    return time.perf_counter() - start


def measured(readings: int) -> tuple[int, float, float, float, str]:
    """Readings used, seconds of the search and of the command, MB and what was found, by a process of its own."""
    threads = dict.fromkeys(ONE_THREAD, "1")  # as the command has it
    command = [sys.executable, "-m", "benchmarks.diagnose", "--case", str(readings)]
    done = subprocess.run(
        command, check=True, cwd=ROOT, env={**threads, **os.environ}, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL
    )
    used, seconds, whole, memory, found = done.stderr.decode().strip().splitlines()[-1].split(" ", 4)
    return int(used), float(seconds), float(whole), float(memory), found


def main() -> int:
    """Every size in a process of its own."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--cores", type=int, default=2, help="cores to be used (%(default)s)")
    parser.add_argument("--case", type=int, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.case:
        case(options.case)
        return 0
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[: options.cores])
        print(f"on {options.cores} of {os.cpu_count()} cores")
    print("readings  seconds  us/reading  ratio  command       MB  found")
    first = None
    for size in SIZES:
        used, seconds, whole, memory, found = measured(size)
        each = 1e6 * seconds / used
        first = first or each
        print(
            f"{used:8d} {seconds:8.2f} {each:11.0f} {each / first:6.2f} {whole:8.2f} {memory:8.0f}  {found}", flush=True
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
