"""The demonstration, step by step: real commands, each shown as a user would type it, run in the results folder."""

import json
from pathlib import Path

import numpy as np

from trueaxis.compensation.files import commanded_ends
from trueaxis.demo import inputs
from trueaxis.demo.evaluate import (
    ESTIMATE,
    NOISE_UM,
    PROPOSED,
    STEPWISE,
    circles,
    left_um,
    path_errors,
    read_wanted,
    study,
    study_text,
)
from trueaxis.demo.summary import Figures, format_summary
from trueaxis.io.files import write_files
from trueaxis.io.told import NOT_DELIVERED
from trueaxis.model.model import MachineModel, load_errors, load_model
from trueaxis.own_python import own_python
from trueaxis.reporting.pictures.standard_tests import Trace, polar_plot
from trueaxis.reporting.pictures.tool_point import PathErrors, error_map, noise_picture

MACHINE, TRUTH = "machine/dmu60p.toml", "machine/dmu60p_errors.json"
PAPER_NOISE_UM = 0.004  # what the residual error of the paper implies
BALLBAR_NOISE_UM = 0.1
PLAN_HOURS, PLAN_NOISE_UM = (
    7,
    0.3,
)  # what `plan` reckons for the paper's 18 runs with all set-ups; of a laser as they are
PROPOSE = f"plan {MACHINE} --with laser --hours {PLAN_HOURS} --noise-um {PLAN_NOISE_UM} --out proposed_plan"
WAYS = {
    "ordinary": "--method ordinary",
    "iterative": "--method iterative",
    "iterative-ends": "--words ends",
    "iterative-middles": "--words middles",
}


class StepError(RuntimeError):
    """A command of the demonstration did not end as it should."""


def run_demo(out: Path, noise_um: float, seed: int) -> str:
    """Do the whole job in `out`; returns the summary, which is also out/summary.txt. Raises StepError.

    noise_um: of the laser by which the three ways to the errors are compared; the paper's own figures are compared at
    PAPER_NOISE_UM.
    """
    inputs.copy_machine(out / "machine")
    _command(out, f"derive {MACHINE}")
    left = _three_ways(out, noise_um, seed)
    _as_the_paper(out, seed)
    summary = format_summary(_figures(out, noise_um, left))
    write_files({out / "summary.txt": summary})
    return summary


def run_study(out: Path, seeds: int) -> str:
    """The three ways at many noises, over seeds, in `out`; returns the table, also out/noise.md, beside out/noise.png.

    Raises StepError.
    """
    inputs.copy_machine(out / "machine")
    _command(out, f"derive {MACHINE}")
    _command(out, PROPOSE)
    truth = load_model(out / MACHINE, out / TRUTH, out / "generated")
    text = ""
    for found in study(truth, out / "machine/dmu60p_regular_runs", out / "proposed_plan", seeds):
        text = "\n".join(study_text(found)) + "\n"
        print(f"{found.noise_um[-1]:g} um: {len(found.noise_um)} of {len(NOISE_UM)}", flush=True)
    title = f"The paper's machine, simulated, compensated: mean and range of {seeds} seeds"
    picture = noise_picture(found.noise_um, found.left, found.nothing, title)
    write_files({out / "noise.md": text, out / "noise.png": picture})
    return text


def _three_ways(out: Path, noise_um: float, seed: int) -> dict[str, float]:
    """What compensation leaves of the error of the tool point by the errors of each way (volume.left_um), um."""
    noise = f"--noise-um {noise_um:g}"
    simulate = f"simulate {MACHINE} --errors {TRUTH} {noise} --seed {seed}"
    _command(out, f"{simulate} --data machine/dmu60p_regular_runs --out laser")
    _command(out, f"identify {MACHINE} --data laser --out laser_points.json --method stepwise {noise}")
    # 1: at more noise a small component has no significant polynomial, and fit says which.
    _command(out, f"fit {MACHINE} --errors laser_points.json --out laser_stepwise.json", allowed=(0, 1))
    _command(out, f"identify {MACHINE} --data laser --out laser_estimate.json --method global")
    _command(out, PROPOSE)
    _command(out, f"{simulate} --data proposed_plan --out proposed")
    _command(out, f"identify {MACHINE} --data proposed --out proposed_estimate.json --method global")
    truth = load_model(out / MACHINE, out / TRUTH, out / "generated")
    files = {STEPWISE: "laser_stepwise.json", ESTIMATE: "laser_estimate.json", PROPOSED: "proposed_estimate.json"}
    left = {way: left_um(truth, load_errors(out / file, truth.machine)) for way, file in files.items()}
    return {"not compensated": left_um(truth, None)} | left


def _as_the_paper(out: Path, seed: int) -> None:
    """Its method, at its noise, on its path and its circle."""
    ball = ",".join(str(part) for part in inputs.BALL_S_PATH)
    files = {"s_path.cl": inputs.s_path(), "circle_ccw.nc": inputs.circle(False), "circle_cw.nc": inputs.circle(True)}
    write_files({out / "programs" / name: text for name, text in files.items()})

    noise = f"--noise-um {PAPER_NOISE_UM:g}"
    simulate = f"simulate {MACHINE} --errors {TRUTH}"
    compensate = f"compensate {MACHINE} --errors identified.json"
    for plan, data in (("dmu60p_runs", "measured_as_published"), ("dmu60p_regular_runs", "measured")):
        _command(out, f"{simulate} --data machine/{plan} --out {data} {noise} --seed {seed}")
    for data, found, options in (
        ("measured_as_published", "identified_as_published.json", "--report identification_as_published.json"),
        ("measured", "identified_points.json", "--report identification.json"),
    ):
        _command(out, f"identify {MACHINE} --data {data} --out {found} --method stepwise {noise} {options}")
    pictured = "--picture error_curves.png"
    # 1: at more noise a small component has no significant polynomial, and fit says which.
    _command(out, f"fit {MACHINE} --errors identified_points.json --out identified.json {pictured}", allowed=(0, 1))
    for way, options in WAYS.items():
        written = f"--out compensated/s_path_{way}.nc --report compensated/s_path_{way}.json"
        _command(out, f"{compensate} programs/s_path.cl {written} --ball {ball} {options}")
    for run in ("ccw", "cw"):
        _command(
            out, f"{compensate} programs/circle_{run}.nc --out compensated/circle_{run}.nc {inputs.circle_options()}"
        )
    _ballbar_plans(out)
    for when in ("before", "after"):
        plan = f"--data ballbar_{when}_plan --out ballbar_{when}"
        _command(out, f"{simulate} {plan} --noise-um {BALLBAR_NOISE_UM:g} --seed {seed}")


def _command(out: Path, words: str, allowed: tuple[int, ...] = (0,)) -> None:
    print(f"\n$ trueaxis {words}", flush=True)
    with own_python("-m", "trueaxis", *words.split(), cwd=out) as process:
        try:
            code = process.wait()
        finally:
            process.terminate()  # where the demonstration is stopped; else it has ended
    if code not in (*allowed, NOT_DELIVERED):
        raise StepError(f"trueaxis {words.split(maxsplit=1)[0]} ended with exit code {code}")


def _ballbar_plans(out: Path) -> None:
    """The positions to be read: the programmed circle, and the blocks of the compensated programs."""
    for when in ("before", "after"):
        rows = ["run,seq,X,Y,Z,feed,reading"]
        for direction in ("ccw", "cw"):
            if when == "before":
                positions = inputs.circle_positions(direction == "cw")
            else:
                ends = commanded_ends(out / f"compensated/circle_{direction}.nc", ("X", "Y", "Z"))
                positions = [(x, y, z) for x, y, z in ends.T.tolist()]
            rows += [f"{direction},{k},{x!r},{y!r},{z!r},1000,,"[:-1] for k, (x, y, z) in enumerate(positions)]
        folder = out / f"ballbar_{when}_plan"
        write_files({folder / "setup.toml": inputs.ballbar_setup(), folder / "readings.csv": "\n".join(rows) + "\n"})


def _figures(out: Path, noise_um: float, left: dict[str, float]) -> Figures:
    found, truth = (load_model(out / MACHINE, out / name, out / "generated") for name in ("identified.json", TRUTH))
    wanted = read_wanted(out / "programs/s_path.cl")
    ball = np.array(inputs.BALL_S_PATH)[:, None]
    programs = {"not compensated": wanted} | {
        way: commanded_ends(out / f"compensated/s_path_{way}.nc", found.axes) for way in WAYS
    }
    on_model = {way: path_errors(found, wanted, ends, ball) for way, ends in programs.items()}
    on_machine = {way: path_errors(truth, wanted, ends, ball) for way, ends in programs.items()}
    _draw_map(out, found, wanted, on_model)

    before, after = (circles(truth, out / f"ballbar_{when}") for when in ("before", "after"))
    names = {"ccw": "counter-clockwise", "cw": "clockwise"}
    panels = [
        (title, [Trace(names[run], angles, found_circle.radial) for run, (angles, found_circle) in runs.items()])
        for title, runs in (("not compensated", before), ("compensated, words along the bar", after))
    ]
    title = "Ball bar 300 mm, XY, the arcs that 540 mm of X allow"
    write_files({out / "ball_bar.png": polar_plot(panels, title)})
    return Figures(
        folder=out.name,
        noise_um=noise_um,
        left=left,
        paper_noise_um=PAPER_NOISE_UM,
        found=found,
        truth=truth,
        on_model=on_model,
        on_machine=on_machine,
        along={way: _along(out / f"compensated/s_path_{way}.json") for way in WAYS},
        circularity={run: (before[run][1].deviation, after[run][1].deviation) for run in before},
    )


def _along(report: Path) -> tuple[float, float]:
    """Mean and largest |E| (mm) at the ends and middles of all executed blocks, as `compensate` reports them."""
    along = json.loads(report.read_text())["ball"]["along"]
    return along["mean"], along["largest"]


def _draw_map(out: Path, model: MachineModel, wanted: np.ndarray, errors: dict[str, PathErrors]) -> None:
    shown = {way: one for way, one in errors.items() if way != "ordinary"}  # its words are those of `iterative`, nearly
    path = model.ideal(wanted, np.zeros((3, 1)))
    write_files(
        {out / "error_map.png": error_map(path, shown, "S path: positioning error E (Eq. 6), words of 0.001 mm")}
    )
