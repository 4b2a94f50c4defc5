"""A LinuxCNC configuration without hardware and without a display, for a machine and its kinematics module."""

import json
import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from tests.controllers.machines import FloatArray
from trueaxis.controllers.linuxcnc_kins import SOURCE

DRIVE = Path(__file__).parent / "drive.py"
MODULES = Path("/usr/lib/linuxcnc/modules")  # where LinuxCNC's packages look for modules
LIBRARY = f"{Path(SOURCE).stem}.so"
SECONDS = 300
JOINT_ACCELERATION = 11000  # mm/s2, deg/s2: a tenth more than the axes have
NOBODY = "65534"  # the simulator's real-time part does not run as root

INI = """[EMC]
MACHINE = {name}
VERSION = 1.1
[DISPLAY]
DISPLAY = ./drive.py
[TASK]
TASK = milltask
CYCLE_TIME = 0.001
[RS274NGC]
PARAMETER_FILE = sim.var
[EMCMOT]
EMCMOT = motmod
COMM_TIMEOUT = 1.0
SERVO_PERIOD = 1000000
[EMCIO]
EMCIO = io
CYCLE_TIME = 0.05
TOOL_TABLE = tool.tbl
[HAL]
HALFILE = sim.hal
HALFILE = trueaxiskins.hal
[TRAJ]
COORDINATES = {spaced}
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
DEFAULT_LINEAR_VELOCITY = 500
MAX_LINEAR_VELOCITY = 2000
[KINS]
KINEMATICS = {kinematics} coordinates={letters}
JOINTS = {count}
"""
AXIS = """[AXIS_{axis}]
MIN_LIMIT = {low}
MAX_LIMIT = {high}
MAX_VELOCITY = 1000
MAX_ACCELERATION = 10000
[JOINT_{joint}]
TYPE = {kind}
MIN_LIMIT = {joint_low}
MAX_LIMIT = {joint_high}
MAX_VELOCITY = 1100
MAX_ACCELERATION = {most}
HOME_SEQUENCE = 0
"""
HAL = """loadrt [KINS]KINEMATICS
loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS
addf motion-command-handler servo-thread
addf motion-controller servo-thread
net estop iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in
net prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared
net change iocontrol.0.tool-change => iocontrol.0.tool-changed
"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Session:
    """What was done: a record after each command, errors that LinuxCNC told, the work offset at the end, mm, joints
    (n, n_joints) in every cycle of 1 ms, mm or deg, and everything printed.
    """

    done: list[dict[str, Any]]
    errors: list[str]
    offset: list[float]
    joints: FloatArray
    log: str


def unavailable() -> str:
    """Why the simulator cannot be run here; empty where it can."""
    if not (shutil.which("linuxcnc") and shutil.which("halcompile")):
        return "LinuxCNC and halcompile are not installed"
    if not os.access(MODULES, os.W_OK):
        return f"{MODULES} cannot be written"
    return f"{MODULES / LIBRARY} is there already" if (MODULES / LIBRARY).exists() else ""


@contextmanager
def installed(sources: Path) -> Iterator[str]:
    """The module, built by halcompile, where LinuxCNC finds it; what halcompile said."""
    words = ["halcompile", "--compile", SOURCE]
    built = subprocess.run(words, cwd=sources, capture_output=True, text=True, check=False)
    assert built.returncode == 0, built.stderr
    target = MODULES / LIBRARY
    try:
        shutil.copy(sources / LIBRARY, target)
        yield built.stdout + built.stderr
    finally:
        target.unlink(missing_ok=True)


def run(
    name: str,
    travel: Mapping[str, tuple[float, float]],
    hal: str,
    tools: str,
    commands: Sequence[str],
    tables: Mapping[str, str] | None = None,
) -> Session:
    """Write the configuration and run it; the module is installed. travel: by axis, joints in this order. tables: the
    files of linuxcnc-comp by name, which are loaded instead of the module, with kinematics of LinuxCNC's own.
    """
    with tempfile.TemporaryDirectory() as made:
        Path(made).chmod(0o777)  # the real-time part, which is nobody's, makes its pipe there
        _configure(Path(made), name, travel, hal, tools, commands, module=tables is None)
        _load(Path(made), tables or {})
        return _run(Path(made))


def _load(folder: Path, tables: Mapping[str, str]) -> None:
    """As the page of linuxcnc-comp says: the tables beside the INI file, the lines of joints.ini in its sections."""
    ini = (folder / "sim.ini").read_text()
    for block in tables.get("joints.ini", "").strip().split("\n\n"):
        section = block.partition("\n")[0]
        ini = ini.replace(f"{section}\n", f"{block}\n") if section else ini
    (folder / "sim.ini").write_text(ini)
    for file, content in tables.items():
        (folder / file).write_text(content)


def _configure(
    folder: Path,
    name: str,
    travel: Mapping[str, tuple[float, float]],
    hal: str,
    tools: str,
    commands: Sequence[str],
    *,
    module: bool,
) -> None:
    axes = "".join(travel)
    kinematics = Path(SOURCE).stem if module else "trivkins"
    text = INI.format(name=name, kinematics=kinematics, letters=axes, spaced=" ".join(axes), count=len(axes))
    for joint, (axis, (low, high)) in enumerate(travel.items()):
        kind, room = ("LINEAR", 5.0) if axis in "XYZ" else ("ANGULAR", 0.0)
        text += AXIS.format(
            axis=axis,
            low=low,
            high=high,
            joint=joint,
            kind=kind,
            joint_low=low - room,
            joint_high=high + room,
            most=JOINT_ACCELERATION,
        )
    links = f"loadrt sampler depth=16000 cfg={'f' * len(axes)}\naddf sampler.0 servo-thread\n"
    for n in range(len(axes)):
        links += f"net j{n} joint.{n}.motor-pos-cmd => joint.{n}.motor-pos-fb sampler.0.pin.{n}\n"
    files = {"sim.ini": text, "sim.hal": HAL + links, "trueaxiskins.hal": hal, "tool.tbl": tools}
    files["commands.json"] = json.dumps({"joints": len(axes), "module": module, "commands": list(commands)})
    for file, content in files.items():
        (folder / file).write_text(content)
    shutil.copy(DRIVE, folder / "drive.py")
    (folder / "drive.py").chmod(0o755)


def _run(folder: Path) -> Session:
    environment = os.environ | {"RTAPI_UID": NOBODY, "RTAPI_FIFO_PATH": str(folder / "fifo"), "HOME": str(folder)}
    for variable in ("PYTHONPATH", "PYTHONHOME", "VIRTUAL_ENV"):
        environment.pop(variable, None)
    words = ["linuxcnc", "-r", "sim.ini"]
    ended = subprocess.run(
        words, cwd=folder, env=environment, capture_output=True, text=True, check=False, timeout=SECONDS
    )
    log = ended.stdout + ended.stderr
    assert (folder / "done.json").exists(), log
    record = json.loads((folder / "done.json").read_text())
    rows = (folder / "samples.txt").read_text().splitlines()
    joints = np.array([[float(word) for word in row.split()] for row in rows if "overrun" not in row])
    return Session(done=record["done"], errors=record["errors"], offset=record["offset"], joints=joints, log=log)
