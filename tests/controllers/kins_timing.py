"""Time and stack of a call of the kinematics module: `python -m tests.controllers.kins_timing`."""

import ctypes
import tempfile
from pathlib import Path

from tests.controllers.kins_machines import kernels_folder, machine_model, with_random_errors
from tests.controllers.kins_module import STUB, KinsModule, compiled, write_module

CALLS = 200_000
LETTERS = "XYZABC"


def main() -> None:
    print("machine, inverse ns, forward ns, stack of all functions bytes (flags of LinuxCNC: -Os)")
    for name in ("dmu60p", "gantry_mill", "trunnion_mill", "headhead_mill"):
        model = with_random_errors(machine_model(name), 1)
        with tempfile.TemporaryDirectory() as folder:
            sources = write_module(Path(folder) / "module", model, kernels_folder(name))
            library = compiled(sources, "-fstack-usage", str(STUB / "timing.c"))
            stack = sum(
                int(line.split("\t")[1])
                for file in sources.glob("*trueaxiskins.su")
                for line in file.read_text().splitlines()
            )
            module = KinsModule(library)
            module.switch_on((0.0, 0.0, 120.0))
            ends = [model.travel.get(letter, (0.0, 0.0)) for letter in LETTERS]
            low, high = ((ctypes.c_double * 6)(*(pair[end] for pair in ends)) for end in (0, 1))
            times = [module.time(low, high, CALLS, forward=forward) for forward in (False, True)]
        print(f"{name}, {times[0]:.0f}, {times[1]:.0f}, {stack}")


if __name__ == "__main__":
    main()
