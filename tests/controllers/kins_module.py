"""The LinuxCNC kinematics module as a control calls it: compiled with a stub of LinuxCNC, or built by `halcompile`."""

import ctypes
import itertools
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tests.controllers.machines import FloatArray
from tests.machines import spec_text
from trueaxis.controllers.linuxcnc_kins import SOURCE, module_files
from trueaxis.machine.machine import Machine
from trueaxis.model.model import MachineModel

STUB = Path(__file__).parent / "rtapi_stub"
# -Os and the frame are those of LinuxCNC's Makefile.modinc
FLAGS = ("-std=gnu17", "-Os", "-fPIC", "-shared", "-Wall", "-Wextra", "-Werror", "-Wframe-larger-than=2560")
LETTERS = "XYZABCUVW"
ORIGIN = np.zeros((3, 1))
CYCLE = 1_000_000  # ns
IN = 16

_NUMBERS = itertools.count()
_TYPES = {
    ctypes.c_bool: ("enable", "reset", "settled", "fault", "converged"),
    ctypes.c_int32: ("steps",),
}


class Pose(ctypes.Structure):
    """EmcPose: x y z a b c u v w."""

    _fields_ = [(letter, ctypes.c_double) for letter in LETTERS.lower()]


def compiler() -> str | None:
    return shutil.which("gcc") or shutil.which("cc")


def write_module(folder: Path, model: MachineModel, kernels: Path, tool: FloatArray = ORIGIN) -> Path:
    """The sources, with the control.c and control.h that lie in `kernels`."""
    folder.mkdir()
    code = {name: (kernels / name).read_bytes() for name in ("control.c", "control.h")}
    for name, text in module_files(model, tool, code).items():
        (folder / name).write_text(text)
    return folder


def compiled(folder: Path, *flags: str) -> Path:
    library = folder / "module.so"
    words = [
        str(compiler()),
        *FLAGS,
        *flags,
        f"-I{STUB}",
        f"-I{folder}",
        str(folder / SOURCE),
        str(STUB / "hal_stub.c"),
    ]
    done = subprocess.run([*words, "-lm", "-o", str(library)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return library


class KinsModule:
    """A loaded module; pins by their names: `module["enable"] = True`."""

    def __init__(self, library: Path, coordinates: str = "", *, loads: bool = True) -> None:
        own = library.with_name(f"{next(_NUMBERS)}-{library.name}")  # a library that is loaded twice has one state
        shutil.copy(library, own)
        self._library = ctypes.CDLL(str(own))
        self._library.stub_pin.restype = ctypes.c_void_p
        self._library.stub_message.restype = ctypes.c_char_p
        self._library.stub_update.argtypes = [ctypes.c_long]
        self._kept = ctypes.create_string_buffer(coordinates.encode())
        if coordinates:
            self._library.stub_set_coordinates(self._kept)
        assert (self._library.rtapi_app_main() == 0) is loads

    @property
    def message(self) -> str:
        return bytes(self._library.stub_message()).decode()

    def direction(self, pin: str) -> int:
        return int(self._library.stub_direction(f"trueaxiskins.{pin}".encode()))

    def _pin(self, name: str) -> Any:
        kind: Any = next((kind for kind, names in _TYPES.items() if name in names), ctypes.c_double)
        address = self._library.stub_pin(f"trueaxiskins.{name}".encode())
        assert address, f"there is no pin {name}"
        return kind.from_address(address)

    def __getitem__(self, name: str) -> Any:
        return self._pin(name).value

    def __setitem__(self, name: str, value: float) -> None:
        self._pin(name).value = value

    def update(self, cycles: int = 1, period: int = CYCLE) -> None:
        for _ in range(cycles):
            self._library.stub_update(period)

    def switch_on(self, tool: Sequence[float] = (0.0, 0.0, 0.0)) -> None:
        """With all of the correction and this offset of G43."""
        self["enable"] = True
        self["ramp-time"] = 0.1
        for letter, value in zip("xyz", tool, strict=True):
            self[f"tool-{letter}"] = value
        self.update(202)
        assert self["settled"]

    def inverse(self, pose: Mapping[str, float], joints: int) -> tuple[int, list[float]]:
        """Code and joints for a pose by letters; letters that are not named are 0."""
        world = Pose(*(pose.get(letter, 0.0) for letter in LETTERS))
        found = (ctypes.c_double * 16)()
        code = self._library.kinematicsInverse(ctypes.byref(world), found, None, None)
        return code, list(found)[:joints]

    def forward(self, joints: Sequence[float]) -> tuple[int, dict[str, float]]:
        """Code and pose by letters."""
        world, given = Pose(), (ctypes.c_double * 16)(*joints)
        code = self._library.kinematicsForward(given, ctypes.byref(world), None, None)
        return code, {letter: getattr(world, letter.lower()) for letter in LETTERS}

    def time(self, low: Any, high: Any, calls: int, *, forward: bool) -> float:
        """ns a call; only of a library with timing.c."""
        self._library.stub_time.restype = ctypes.c_double
        return float(self._library.stub_time(low, high, calls, int(forward)))

    def type(self) -> int:
        return int(self._library.kinematicsType())


def bodies_text(machine: Machine) -> str:
    """The spec of a machine body by body, whatever it was read from."""
    bodies = []
    for body in machine.bodies:
        keys: dict[str, Any] = {"number": body.number, "name": body.name, "lower": body.lower}
        keys["position"] = list(body.position)
        if body.position_errors:
            keys["position_errors"] = dict(body.position_errors)
        if body.moves:
            keys |= {"moves": body.moves, "sense": body.sense, "travel": list(machine.travel[body.moves])}
            keys["motion_errors"] = list(body.motion_errors)
        bodies.append(keys)
    assert not machine.true_rotation
    return spec_text(bodies, machine.workpiece, machine.tool)
