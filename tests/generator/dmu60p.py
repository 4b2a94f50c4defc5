"""The paper's machine as an independent generator: bodies as in Fig. 2, matrices as in Table 2."""

from collections.abc import Mapping

from tests.generator.machine import Body, Function, Generator, Rotations, polynomial, sine

TRAVEL = {"X": (0.0, 540.0), "Y": (0.0, 700.0), "Z": (0.0, 600.0)}

BODIES = (
    Body(2, lower=1, moves="Y"),
    Body(4, lower=2, position=("q_wx", "q_wy", "q_wz")),
    Body(5, lower=1, moves="X", position_errors={"EC": "eps_xy"}),
    Body(6, lower=5, moves="Z", position_errors={"EA": "eps_yz", "EB": "eps_xz"}),
    Body(9, lower=6, position=("q_Tx", "q_Ty", "q_Tz")),
)

PARAMETERS = {
    "q_wx": 270.0,
    "q_wy": -350.0,
    "q_wz": 12.5,
    "q_Tx": 1.25,
    "q_Ty": 3.0,
    "q_Tz": 400.0,
    "eps_xy": -5e-6,
    "eps_xz": 26e-6,
    "eps_yz": 10e-6,
}  # squareness: Table 6

LINEAR_SIZE, ANGULAR_SIZE = 1.5e-2, 3e-5  # at the end of a travel of 700: mm, rad


def coefficients() -> dict[str, dict[str, float]]:
    """A cubic for each of the 18 motion errors, of the paper's size, no two alike."""
    found = {}
    for number, name in enumerate(f"E{d}{axis}" for axis in "XYZ" for d in "XYZABC"):
        size = LINEAR_SIZE if name[1] in "XYZ" else ANGULAR_SIZE
        sign = -1.0 if number % 3 == 0 else 1.0
        found[name] = {
            "p1": sign * size / 700 * (1 + number / 7),
            "p2": -size / 700**2 * (1 - number / 11),
            "p3": sign * size / 700**3 * (number / 5 - 2),
        }
    return found


def cubic_errors() -> dict[str, Function]:
    return {name: polynomial(**terms) for name, terms in coefficients().items()}


def sine_errors() -> dict[str, Function]:
    names = [f"E{d}{axis}" for axis in "XYZ" for d in "XYZABC"]
    sizes = {name: (LINEAR_SIZE if name[1] in "XYZ" else ANGULAR_SIZE) for name in names}
    return {name: sine(sizes[name], 311.0 + 17 * n, 0.3 * n) for n, name in enumerate(names)}


def dmu60p(
    errors: Mapping[str, Function], parameters: Mapping[str, float] | None = None, rotations: Rotations = "small"
) -> Generator:
    located = PARAMETERS if parameters is None else parameters
    frames = {"bed": 1, "workpiece": 4, "tool": 9}
    return Generator(BODIES, ("X", "Y", "Z"), frames, located, errors, rotations)
