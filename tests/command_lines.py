"""Every command with small inputs in a folder of its own, run as users run it: in a process."""

import contextlib
import io
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import polars as pl

from tests.instrument_files.writers import rtl
from tests.machines import DMU60P, ROOT, serial_text
from trueaxis.cli.main import main

KERNELS = ROOT / "generated"
ERRORS = ROOT / "machines" / "dmu60p_errors.json"
PLAN = ROOT / "machines" / "dmu60p_runs"
REGULAR = ROOT / "machines" / "dmu60p_regular_runs"
OTHER_AXES = "# Table 4, Y"  # where its set-up goes on with them: a diagnosis of the runs of X alone is soon done
STEPS = [0.0, 60.0, 120.0, 180.0, 240.0, 300.0, 360.0, 420.0, 480.0, 540.0]
NC = "G90 G1 X270. Y350. Z150. F1000\nX280.\n"
# a machine of one axis and its run, which is derived in no time
SMALL = serial_text("", "X", X={"motion_errors": ["EXX"]}).replace('"test"', '"small"')
SMALL_RUN = """schema = 1
machine = "small"

[[run]]
id = "X-1"
instrument = "laser"
direction = [1.0, 0.0, 0.0]
target = { on = "tool", point = [0.0, 0.0, 0.0] }
"""
PROGRAM = "import sys; from trueaxis.__main__ import main; sys.exit(main())"
# on Linux a process that a test starts is killed with the test run: prctl(PR_SET_PDEATHSIG, SIGKILL)
WITH_ITS_PARENT = "import ctypes; ctypes.CDLL(None).prctl(1, 9); " if sys.platform == "linux" else ""

# name of a run -> its words; {out} is where it writes
COMMANDS: Mapping[str, str] = {
    "derive": "derive small.toml --out {out}/generated --runs small_runs",
    "predict": "predict m.toml --errors e.json --at points.parquet --out {out}/p.csv",
    "simulate": "simulate m.toml --errors e.json --data dmu60p_runs --out {out}/data --noise-um 0.01",
    "plan": "plan m.toml --data dmu60p_runs --report {out}/plan.json",
    "identify": "identify m.toml --data data --out {out}/i.json --report {out}/r.json",
    "fit": "fit m.toml --errors tables.json --out {out}/f.json --picture {out}/f.png",
    "compensate": "compensate m.toml --errors e.json part.nc --out {out}/c.nc --report {out}/c.json",
    "diagnose": "diagnose m.toml --errors e.json --data of_x --out {out}/d --noise-um 0.3",
    "init": "init {out}/new.toml --structure FXYZ --travel X=0:1 Y=0:1 Z=0:1",
    "import": "import x.rtl --replace --machine m.toml --out {out}/imported --map target.point=0,0,0 at.Y=0 at.Z=0",
    "export": "export m.toml --errors e.json --format siemens-enc --out {out}/enc.ini",
    "evaluate": "evaluate test.csv --out {out}/t.json --picture {out}/t.png",
}


def prepare(folder: Path) -> None:
    """The inputs of COMMANDS: a machine, its errors, a plan, data, tables, points, a program and a positioning test."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "m.toml").write_bytes(DMU60P.read_bytes())
    (folder / "e.json").write_bytes(ERRORS.read_bytes())
    shutil.copytree(PLAN, folder / PLAN.name)
    (folder / "small.toml").write_text(SMALL)
    (folder / "small_runs").mkdir()
    (folder / "small_runs" / "setup.toml").write_text(SMALL_RUN)
    (folder / "small_runs" / "readings.csv").write_text("run,seq,X,reading\nX-1,0,0,\nX-1,1,100,\n")
    (folder / "part.nc").write_text(NC)
    pl.DataFrame({"X": [270.0], "Y": [350.0], "Z": [150.0]}).write_parquet(folder / "points.parquet")
    rows = [f"{t},{c},{d},{t + 0.001 * c * d}" for t in (0, 100, 200) for c in (1, 2, 3, 4, 5) for d in (1, -1)]
    (folder / "test.csv").write_text("\n".join(["target,cycle,direction,measured", *rows]) + "\n")
    (folder / "x.rtl").write_text(rtl([0.0, 100.0, 200.0], np.array([[0.0, 1.5, -2.0]]), axis="X"))
    (folder / "x_runs").mkdir()
    (folder / "x_runs" / "setup.toml").write_text((REGULAR / "setup.toml").read_text().partition(OTHER_AXES)[0])
    lines = (REGULAR / "readings.csv").read_text().splitlines(keepends=True)
    (folder / "x_runs" / "readings.csv").write_text(lines[0] + "".join(line for line in lines if line.startswith("X-")))
    of_x = "simulate m.toml --errors e.json --data x_runs --out of_x --noise-um 0.3"
    regular = f"simulate m.toml --errors e.json --data {REGULAR} --out regular --noise-um 0.3"
    tables = {
        name: {"basis": "table", "positions": STEPS, "values": [round(1e-8 * x**2, 4) for x in STEPS]}
        for name in ("EXX", "EYX")
    }
    (folder / "tables.json").write_text(json.dumps({"schema": 1, "machine": "dmu60p", "motion_errors": tables}))
    for words in (COMMANDS["simulate"].format(out="."), of_x, regular):
        with contextlib.chdir(folder), contextlib.redirect_stdout(io.StringIO()):
            assert main(words_of(words.split())) == 0


def words_of(words: Sequence[str]) -> list[str]:
    """With the kernels of the repository where the command takes some."""
    without = words[0] in ("init", "derive", "fit", "evaluate", "demo")
    return list(words) if without else [*words, "--kernels", str(KERNELS)]


def command_line(words: str) -> list[str]:
    """What starts the program as its script does; the process ends with the one that starts it."""
    return [sys.executable, "-P", "-c", WITH_ITS_PARENT + PROGRAM, *words_of(words.split())]


def run(folder: Path, words: str, **options: Any) -> "subprocess.CompletedProcess[str]":
    """Run a command in a folder."""
    environment = os.environ | options.pop("env", {})
    return subprocess.run(
        command_line(words), cwd=folder, capture_output=True, text=True, env=environment, check=False, **options
    )


def leftovers(folder: Path) -> list[str]:
    """Temporary files of ours below a folder."""
    return sorted(str(path.relative_to(folder)) for path in folder.rglob(".*") if path.name.startswith(".trueaxis-"))
