"""The deviation of the tool of the paper's machine at two points, and its sensitivity to the yaw of X at the first.

python examples/point.py

Needs NumPy alone; examples/main.c does the same in C.
"""

import importlib.util
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).parents[1] / "generated" / "dmu60p"


def main() -> None:
    """Print what main.c prints."""
    spec = importlib.util.spec_from_file_location("kernels", FOLDER / "kernels.py")
    kernels = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(kernels)
    meta = kernels.META

    positions = np.array([[270.0, 540.0], [350.0, 700.0], [300.0, 600.0]])
    sizes = {"mm": 2e-3, "rad": 5e-6}
    errors = np.array([[sizes[unit]] for unit in meta["component_units"]])
    values = {"q_Tx": 25.0, "q_Tz": -200.0, "eps_xy": -5e-6, "eps_yz": 10e-6, "eps_xz": 26e-6}
    parameters = np.array([values.get(name, 0.0) for name in meta["parameters"]])
    point = np.zeros((3, 1))

    deviation = kernels.tool_in_workpiece_deviation(positions, errors, parameters, point)
    sensitivity = kernels.tool_in_workpiece_sensitivity(positions, parameters, point)
    for x, y, z in deviation.T:
        print(f"{x:.12g} {y:.12g} {z:.12g}")
    print(f"{sensitivity[1, meta['components'].index('ECX'), 0]:.12g}")


if __name__ == "__main__":
    main()
