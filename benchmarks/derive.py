"""What `derive` takes from a cold start, phase by phase: python -m benchmarks.derive [--rounds 5] [--before SRC]

Seconds of the processor, median and most of the rounds, each round a process of its own per machine. `--before`: the
`src` of another version, measured in turns with this one. The last row is `trueaxis.derive` as a person runs it, less
the two rows of SymPy. SymPy imports its tensors with the first sum, which is its own row.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STRUCTURES = {3: "[w Y' b X Z t]", 4: "[w C' Y' b X Z t]", 5: "[w C' A' Y' b X Z t]", 6: "[w C' A' Y' b X Z B t]"}
SPEC = """schema = 1
name = "mill_{axes}"
title = "Mill of {axes} axes"
structure = "{structure}"
{travels}"""
ALL = "all, without SymPy"
SYMPY = ("import sympy", "first sum of SymPy")

PHASES = """
import json, sys, time
from pathlib import Path
marks = [("start of Python", 0.0), ("import sympy", time.process_time())]
import sympy
marks.append(("first sum of SymPy", time.process_time()))
sympy.Symbol("x") + 1
marks.append(("import numpy", time.process_time()))
import numpy
marks.append(("import trueaxis", time.process_time()))
from trueaxis.codegen import c_source, equations, numpy_source, render
from trueaxis.codegen.templates import environment
from trueaxis.derivation.model import derive_model
from trueaxis.jobs.derive import check_kinds, identification_runs, read_machine
marks.append(("spec", time.process_time()))
spec = Path(sys.argv[1])
machine = read_machine(spec)
check_kinds(machine, spec)
marks.append(("runs of the spec, Polars", time.process_time()))
runs = identification_runs(machine, spec)
marks.append(("derivation", time.process_time()))
model = derive_model(machine, runs)
marks.append(("compile templates", time.process_time()))
for name in ("kernels.py", "kernels.c", "kernels.h", "control.c", "control.h", "equations.md"):
    environment().get_template(f"{name}.j2")
marks.append(("kernels.py", time.process_time()))
numpy_source.numpy_source(machine, model.routines)
marks.append(("kernels.c, .h", time.process_time()))
c_source.c_source(machine, model.routines), c_source.c_header(machine, model.routines)
marks.append(("control.c, .h", time.process_time()))
c_source.control_sources(machine, model.routines)
marks.append(("equations.md", time.process_time()))
equations.equations_page(model)
marks.append(("", time.process_time()))
print(json.dumps({name: end - begin for (name, begin), (_, end) in zip(marks, marks[1:])}))
"""
WHOLE = """
import json, sys, time, trueaxis
trueaxis.derive(sys.argv[1], sys.argv[2])
print(json.dumps({"whole": time.process_time()}))
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--before", type=Path, metavar="SRC")
    args = parser.parse_args()
    sources = [*([args.before] if args.before else []), ROOT / "src"]
    with tempfile.TemporaryDirectory() as folder:
        specs = [ROOT / "machines" / f"{name}.toml" for name in ("dmu60p", "dmu60p_5axis")]
        specs += [written(axes, Path(folder)) for axes in STRUCTURES]
        for spec in specs:
            found: list[list[dict[str, float]]] = [[] for _ in sources]
            for _ in range(args.rounds):
                for source, rounds in zip(sources, found, strict=True):
                    rounds.append(measured(source, spec))
            print(f"\n{spec.stem:28}" + "".join(f"{source.parent.name:>24}" for source in sources))
            for row in found[0][0]:
                cells = ([one[row] for one in rounds] for rounds in found)
                print(f"{row:28}" + "".join(f"{statistics.median(c):14.3f} ({max(c):.3f})" for c in cells), flush=True)


def written(axes: int, folder: Path) -> Path:
    """The spec of a mill of so many axes."""
    structure = STRUCTURES[axes]
    moved = sorted(set(structure) & set("XYZABC"))
    travels = "\n".join(f"[axis.{axis}]\ntravel = {[-90.0, 90.0] if axis in 'ABC' else [0.0, 500.0]}" for axis in moved)
    path = folder / f"mill_{axes}.toml"
    path.write_text(SPEC.format(axes=axes, structure=structure, travels=travels))
    return path


def measured(source: Path, spec: Path) -> dict[str, float]:
    """Seconds of the processor by phase, and of the whole."""
    phases = run(source, PHASES, spec)
    whole = run(source, WHOLE, spec)["whole"]
    return phases | {ALL: whole - sum(phases[name] for name in SYMPY)}


def run(source: Path, code: str, spec: Path) -> dict[str, float]:
    """What a process prints that runs the code."""
    threads = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    with tempfile.TemporaryDirectory() as out:
        command = [sys.executable, "-c", code, str(spec), out]
        environment = os.environ | threads | {"PYTHONPATH": str(source)}
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    result: dict[str, float] = json.loads(done.stdout.splitlines()[-1])
    return result


if __name__ == "__main__":
    main()
