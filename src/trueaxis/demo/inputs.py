"""What the demonstration starts from: the machine that ships with the package, and two programs."""

import math
from pathlib import Path

from trueaxis.io.files import write_files

# The S path of Sect. 5.2 (its figure gives no size) and the circle of Table 7, in axis positions, mm.
CENTRE = (270.0, 350.0)
HEIGHT = 150.0
S_RADIUS, S_STEP = 100.0, 1.0
BAR = 300.0
BALL_S_PATH = (150.0, -240.0, 0.0)  # workpiece ball of the S path, in the workpiece frame, off its centre
CIRCLE_HEIGHT = 200.0
STROKE_X = 540.0
MACHINE_FILES = ("dmu60p.toml", "dmu60p_errors.json", "dmu60p_runs", "dmu60p_regular_runs")


def machines_folder() -> Path:
    """The machines of the installed package, or of the repository beside `src`."""
    package = Path(__file__).resolve().parent.parent
    folders = [package / "machines", package.parent.parent / "machines"]
    return next(folder for folder in folders if folder.is_dir())


def copy_machine(out: Path) -> None:
    """Copy the paper's machine, its measuring plans and the example errors to `out`."""
    folder = machines_folder()
    files = [file for name in MACHINE_FILES for file in (folder / name, *sorted((folder / name).rglob("*")))]
    write_files({out / file.relative_to(folder): file.read_bytes() for file in files if file.is_file()})


def s_path() -> str:
    """An S (as the workpiece sees it, whose Y is minus the axis's) of two arcs as a CL file, a GOTO per millimetre."""
    steps = round(1.5 * math.pi * S_RADIUS / S_STEP)
    upper = [1.5 * math.pi * k / steps for k in range(steps + 1)]
    points = [(S_RADIUS * math.cos(a), S_RADIUS * (1.0 + math.sin(a))) for a in upper]
    points += [(-x, -y) for x, y in reversed(points[:-1])]
    lines = ["PARTNO/S PATH", "UNITS/MM", "RAPID", _goto(points[0]), "FEDRAT/1000,MMPM"]
    return "\n".join([*lines, *(_goto(point) for point in points[1:]), "FINI"]) + "\n"


def _goto(point: tuple[float, float]) -> str:
    return f"GOTO/{CENTRE[0] + point[0]:.6f},{CENTRE[1] - point[1]:.6f},{HEIGHT:.6f}"


def reach() -> float:
    """Polar angle (rad) from which on a circle of the bar's length stays within the stroke of X."""
    return math.acos((STROKE_X / 2.0 - 0.5) / BAR)


def circle(clockwise: bool) -> str:
    """The two arcs of the 300 mm circle that the stroke of X allows, as an NC program."""
    a = reach()
    arcs = [(a, math.pi - a), (math.pi + a, 2.0 * math.pi - a)]
    if clockwise:
        arcs = [(end, start) for start, end in reversed(arcs)]
    lines = ["%", "(BALL BAR XY 300 MM)", "G17 G21 G90"]
    for start, end in arcs:
        x, y = _on_circle(start)
        to_x, to_y = _on_circle(end)
        i, j = CENTRE[0] - x, CENTRE[1] - y
        lines += [
            f"G0 X{x:.6f} Y{y:.6f} Z{CIRCLE_HEIGHT:.3f}",
            f"{'G2' if clockwise else 'G3'} X{to_x:.6f} Y{to_y:.6f} I{i:.6f} J{j:.6f} F1000",
        ]
    return "\n".join([*lines, "M30", "%"]) + "\n"


def circle_options() -> str:
    """The options that choose words along the bar of the circle, whose program is in machine coordinates."""
    return f"--ball {CENTRE[0]},{-CENTRE[1]},{CIRCLE_HEIGHT} --words ends --offset G54=X0,Y0,Z0"


def circle_angles(clockwise: bool, count: int = 400) -> list[float]:
    """Polar angles (rad) at which the uncompensated circle is read, in the order of the program."""
    a = reach()
    angles = [s + (math.pi - 2.0 * a) * k / (count - 1) for s in (a, math.pi + a) for k in range(count)]
    return angles[::-1] if clockwise else angles


def _on_circle(angle: float) -> tuple[float, float]:
    return CENTRE[0] + BAR * math.cos(angle), CENTRE[1] + BAR * math.sin(angle)


def ballbar_setup() -> str:
    """setup.toml of the circles: the workpiece ball at the centre, which the workpiece frame sees at -Y."""
    runs = "".join(
        f'\n[[run]]\nid = "{name}"\ninstrument = "ballbar"\nlength = {BAR}\n'
        'target = { on = "tool", point = [0.0, 0.0, 0.0] }\n'
        f'reference = {{ on = "workpiece", point = [{CENTRE[0]}, {-CENTRE[1]}, {CIRCLE_HEIGHT}] }}\n'
        for name in ("ccw", "cw")
    )
    return f'schema = 1\nmachine = "dmu60p"\n{runs}'


def circle_positions(clockwise: bool) -> list[tuple[float, float, float]]:
    """Axis positions of the uncompensated circle, mm."""
    return [(*_on_circle(angle), CIRCLE_HEIGHT) for angle in circle_angles(clockwise)]
