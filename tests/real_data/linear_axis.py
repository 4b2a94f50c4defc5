"""What the diagnosis says of the real linear axis: python -m tests.real_data.linear_axis"""

import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
import numpy.typing as npt

from tests.kernels import kernels_of
from tests.real_data.linear_axis_data import FILE, SPEC, readings, write
from trueaxis.cli.main import main as trueaxis
from trueaxis.diagnosis.procedure import diagnose
from trueaxis.diagnosis.result import Cause, Diagnosis
from trueaxis.evaluation.positioning_table_file import read_positioning_test
from trueaxis.io.faults import Faults
from trueaxis.machine.read import parse_machine
from trueaxis.measurement.data import read_data
from trueaxis.model.errors import ErrorValues
from trueaxis.model.kernels import Kernels
from trueaxis.model.model import MachineModel

FloatArray = npt.NDArray[np.float64]
TARGETS, CYCLES, FITTED = 9, 5, 3  # FITTED: cycles to which terms are fitted; the other two are predicted

TURNING = """
[[effect_kind]]
name = "turning_play"
expression = "(a*cos(2*pi*q/pitch) + b*sin(2*pi*q/pitch))*direction"
components = ["along"]
parameters.a = { unit = "u", meaning = "cosine of half the lost motion's swing" }
parameters.b = { unit = "u", meaning = "its sine" }
parameters.pitch = { unit = "axis", meaning = "period", grid = [11.0, 12.0, 13.0, 14.0, 16.0, 18.0, 20.0, 25.0, 30.0] }
sentence = "lost motion that changes as something turns"
"""
BOWED = """
[[effect_kind]]
name = "bowed_drift"
expression = "rate*t*s*(1 - s)"
components = ["along"]
parameters.rate = { unit = "u/s", meaning = "four times the change per second in the middle" }
sentence = "the middle of the axis creeps while its ends stand"
"""


def diagnosis(*, swapped: bool = False, clock: bool = True, without: int = 0, kinds: str = "") -> Diagnosis:
    """Diagnosed in process. without: a cycle left out; kinds: TOML of kinds of one's own."""
    spec = SPEC.read_text() + kinds
    model = _model(spec)
    with tempfile.TemporaryDirectory() as name:
        folder = write(Path(name), swapped=swapped, clock=clock, without=without)
        return diagnose(model, read_data(folder.data, model.machine))


@cache
def _model(spec: str) -> MachineModel:
    module = kernels_of(spec)
    kernels = Kernels(
        meta=module.META,
        module=module,
        routines={name: getattr(module, name) for name in module.META["routines"]},
        backend="numpy",
        note="",
    )
    return MachineModel(parse_machine(spec, Faults(SPEC.name)), kernels, ErrorValues(machine="linear_axis"))


@dataclass(frozen=True)
class Gained:
    """RMS in um: inside, of all readings fitted; ahead, of cycles 4 and 5 predicted from 1 to 3. value, u: of the last
    term, um (drifts: um per reading), u by the scatter of the residuals as if they were independent.
    """

    inside: float
    ahead: float
    value: float
    u: float


def gained(names: Sequence[str]) -> Gained:
    """Plain least squares with a mean for each target and these terms: no part of the package has a hand in it."""
    table = readings(read_positioning_test(FILE))
    x, way, y = (table[name].to_numpy().astype(np.float64) for name in ("X", "dir_X", "reading"))
    number = np.arange(x.size, dtype=np.float64)
    share = (x - x.min()) / np.ptp(x)
    terms = {
        "backlash": way / 2.0,
        "backlash by target": way[:, np.newaxis] * (x[:, np.newaxis] == np.unique(x)) / 2.0,
        "backlash_slope": way * (share - 0.5),
        "drift": number,
        "bowed drift": number * share * (1.0 - share),
    }
    columns = np.column_stack([x[:, np.newaxis] == np.unique(x), *(terms[name] for name in names)]).astype(np.float64)
    fitted = number < FITTED * 2 * TARGETS
    ahead = y[~fitted] - columns[~fitted] @ np.linalg.lstsq(columns[fitted], y[fitted])[0]
    value = np.linalg.lstsq(columns, y)[0]
    rest = y - columns @ value
    covariance = np.linalg.pinv(columns.T @ columns) * (rest @ rest) / (x.size - columns.shape[1])
    return Gained(*(1e3 * float(v) for v in (_rms(rest), _rms(ahead), value[-1], np.sqrt(covariance[-1, -1]))))


def lost_motion() -> FloatArray:
    """(9, 5), um: reversal values, forward less backward as the .dat labels them, by target and cycle."""
    test = read_positioning_test(FILE)
    return 1e3 * (test.positive - test.negative)


def _rms(values: FloatArray) -> float:
    return float(np.sqrt(np.mean(values**2)))


TERMS: tuple[tuple[str, ...], ...] = (
    (),
    ("backlash",),
    ("backlash", "backlash_slope"),
    ("backlash", "drift"),
    ("backlash", "bowed drift"),
    ("backlash by target",),
    ("backlash by target", "bowed drift"),
)


def main() -> int:
    """Run the command on the axis, with the labels right and swapped, and print what terms gain; 1 without data."""
    if not FILE.exists():
        print(f"there are no data: {FILE} is missing", file=sys.stderr)
        return 1
    for title, swapped, kinds in (
        ("labels of the .dat", False, ""),
        ("labels swapped", True, ""),
        ("a kind of one's own: lost motion that turns", False, TURNING),
        ("a kind of one's own: a bowed drift", False, BOWED),
    ):
        print(f"\n{title}")
        command(swapped=swapped, kinds=kinds)
    (noise,) = diagnosis().noise
    print(f"\nnoise, um: white {1e3 * noise.white:.1f}, correlated {1e3 * noise.correlated:.1f}")
    print("\nnames found with a cycle left out")
    for cycle in range(1, CYCLES + 1):
        found = diagnosis(without=cycle)
        print(f"  without cycle {cycle}: {found.verdict:<22} {', '.join(map(_named, found.causes))}")
    print("\nlost motion, um: target, mean, cycles 1 to 5")
    for target, of_cycles in zip(read_positioning_test(FILE).targets, lost_motion(), strict=True):
        print(f"  {target:4.0f} mm {of_cycles.mean():7.1f}   {' '.join(f'{one:6.1f}' for one in of_cycles)}")
    print("\nplain least squares, um: all readings fitted, cycles 4 and 5 predicted, the last term")
    for names in TERMS:
        one = gained(names)
        last = f"{one.value:8.3f} +- {one.u:.3f}" if names and "by target" not in names[-1] else ""
        print(f"  {', '.join(('means of targets', *names)):<60} {one.inside:6.2f} {one.ahead:6.2f} {last}")
    return 0


def _named(cause: Cause) -> str:
    width = cause.parameters[0]
    return f"{cause.effect.label} {1e3 * width.value:.1f} um +- {2e3 * width.u:.1f} um (k = 2)"


def command(*, swapped: bool = False, clock: bool = True, kinds: str = "") -> int:
    """`trueaxis derive` and `trueaxis diagnose`; the exit code of the latter."""
    with tempfile.TemporaryDirectory() as name:
        folder = write(Path(name), swapped=swapped, clock=clock)
        spec, kernels, out = (Path(name) / one for one in (SPEC.name, "generated", "out"))
        spec.write_text(SPEC.read_text() + kinds)
        trueaxis(["derive", str(spec), "--out", str(kernels)])
        options = ["--errors", str(folder.errors), "--data", str(folder.data), "--kernels", str(kernels)]
        return trueaxis(["diagnose", str(spec), *options, "--out", str(out)])


if __name__ == "__main__":
    sys.exit(main())
