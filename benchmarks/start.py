"""From process start to kernels, for machines of three and five axes: python -m benchmarks.start [--rounds 5]

Each row is a process of its own, its compiler included: seconds of the processor and by the clock, the least of the
rounds. Ours writes all files of a machine, some 35 routines, in NumPy and C, and the page of equations; then compiles
them, with an empty cache, and calls one. wrenfold derives, emits and compiles one routine, the deviation to first order
with the sensitivity to every error, from a chain that wrenfold_chain.py walks as ours is.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MACHINES = ("dmu60p", "dmu60p_5axis")
SYMPY = "import sympy"
DERIVE = "import sys, trueaxis; trueaxis.derive(sys.argv[1], sys.argv[2])"
CALL = """import sys, numpy, trueaxis
model = trueaxis.load_model(sys.argv[1], sys.argv[2])
rest = numpy.zeros((len(model.axes), 1))
assert model.kernels.backend == "c" and model.ideal(rest, numpy.zeros((3, 1))).shape == (3, 1)"""
WRENFOLD = "import sys; from benchmarks.wrenfold_chain import compile_deviation; compile_deviation(*sys.argv[1:])"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=5)
    rounds = parser.parse_args().rounds
    print(f"{'machine':16}{'process':44}{'processor':>10}{'clock':>8}")
    for machine in MACHINES:
        spec = ROOT / "machines" / f"{machine}.toml"
        codes = {
            SYMPY: SYMPY,
            "derive, all files": DERIVE,
            "derived: compile all, load, first call": CALL,
            "wrenfold: derive, emit, compile one routine": WRENFOLD,
        }
        took: dict[str, list[tuple[float, float]]] = {label: [] for label in codes}
        for _ in range(rounds):
            with tempfile.TemporaryDirectory() as folder:
                for label, code in codes.items():
                    took[label].append(cost(code, spec, folder))
        for label, found in took.items():
            processor, clock = (min(values) for values in zip(*found, strict=True))
            print(f"{machine:16}{label:44}{processor:10.2f}{clock:8.2f}", flush=True)


def cost(code: str, spec: Path, folder: str) -> tuple[float, float]:
    """Seconds of the processor and by the clock of a process that runs `code`, and of what it starts."""
    paths = os.pathsep.join([str(ROOT / "src"), str(ROOT), os.environ.get("PYTHONPATH", "")])
    environment = os.environ | {"PYTHONPATH": paths, "TRUEAXIS_CACHE": str(Path(folder) / "cache")}
    start = time.perf_counter()
    with subprocess.Popen([sys.executable, "-c", code, spec, folder], env=environment) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit(f"a process failed: {code}")
    return usage.ru_utime + usage.ru_stime, time.perf_counter() - start


if __name__ == "__main__":
    main()
