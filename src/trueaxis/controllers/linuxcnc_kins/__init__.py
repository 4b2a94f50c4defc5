"""A LinuxCNC kinematics module made of the emitted kernels of a machine and its error values.

trueaxiskins.c, joints.h and curves.h are the same for every machine; control.c and control.h are the kernels that were
derived of it; machine.h holds its error values.
"""

from collections.abc import Mapping
from pathlib import Path

from trueaxis.controllers.linuxcnc_kins.machine_header import machine_header
from trueaxis.model.curves import FloatArray
from trueaxis.model.manifest import CONTROL_FILES
from trueaxis.model.model import MachineModel

SOURCE = "trueaxiskins.c"  # what halcompile is given
_SAME_FOR_ALL = (SOURCE, "joints.h", "curves.h", "trueaxiskins.hal")


def module_files(model: MachineModel, tool: FloatArray, kernels: Mapping[str, bytes]) -> dict[str, str]:
    """Name -> text of the sources of the module.

    tool: (3, 1), the point in the tool frame from which tool lengths are measured, mm; kernels: the content of each of
    CONTROL_FILES.
    """
    folder = Path(__file__).parent
    files = {name: (folder / name).read_text(encoding="utf-8") for name in _SAME_FOR_ALL}
    files |= {name: kernels[name].decode() for name in CONTROL_FILES}
    return files | {"machine.h": machine_header(model, tool)}
