"""The summary that a person reads at the end of the demonstration."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from trueaxis.model.model import MachineModel
from trueaxis.reporting.pictures.tool_point import PathErrors

# Sect. 5.2 of the paper: largest, mean and standard deviation of E, mm; Table 8: circularity, um.
PAPER = {"ordinary": (0.0021, 0.00119, 0.000249), "iterative": (0.00053, 0.000244, 0.000119)}
PAPER_CIRCULARITY = {"ordinary": 42.1, "iterative": 25.1}


@dataclass(frozen=True, kw_only=True)
class Figures:
    """Everything the summary says. left: way -> what it leaves at noise_um (`volume.left_um`), um; all else is at
    paper_noise_um. along: way -> (mean, largest) |E| along all executed blocks, mm;
    circularity: run -> (before, after), mm.
    """

    folder: str
    noise_um: float
    left: Mapping[str, float]
    paper_noise_um: float
    found: MachineModel
    truth: MachineModel
    on_model: Mapping[str, PathErrors]
    on_machine: Mapping[str, PathErrors]
    along: Mapping[str, tuple[float, float]]
    circularity: Mapping[str, tuple[float, float]]


def format_summary(figures: Figures) -> str:
    """The summary as text."""
    return "\n".join(_lines(figures)) + "\n"


def _lines(figures: Figures) -> Iterator[str]:
    yield f"trueaxis: the paper's machine, simulated, a laser with noise of {figures.noise_um:g} um"
    yield ""
    yield from _volume(figures)
    yield ""
    yield f"beside the paper's figures: its method, at the noise its residuals imply, {figures.paper_noise_um:g} um"
    yield ""
    yield from _identification(figures)
    yield ""
    yield from _path(figures)
    yield ""
    yield from _circle(figures)
    yield ""
    yield f"{figures.folder}/: pictures error_curves.png, error_map.png, ball_bar.png; the errors in identified.json,"
    yield "the NC programs in compensated/, the equations in generated/dmu60p/equations.md, this text in summary.txt"


def _volume(figures: Figures) -> Iterator[str]:
    yield "what compensation leaves of the error of the tool point on the machine as it is, RMS of a coordinate over"
    yield "the volume, um, seen from home (the error vector is longer by sqrt(3))"
    for way, left in figures.left.items():
        yield f"  {way:52s}{left:8.2f}"
    yield "  one seed, the tool at the origin of its frame; mean and spread of ten, noise of 0.01 to 3 um:"
    yield "  trueaxis demo --seeds 10"


def _identification(figures: Figures) -> Iterator[str]:
    yield "identified from 18 laser runs, point by point as in Sect. 3, then as optimal polynomials (Sect. 4)"
    worst = {"um": 0.0, "urad": 0.0}
    for name in figures.truth.components:
        axis = figures.truth.axes.index(name.axis)
        low, high = figures.truth.travel[name.axis]
        positions = np.zeros((len(figures.truth.axes), 55))
        positions[axis] = np.linspace(low, high, 55)
        row = figures.truth.components.index(name)
        off = (figures.found.component_errors(positions) - figures.truth.component_errors(positions))[row]
        # Slope of straightness and squareness are told apart by convention only: the line is taken out.
        off = off - np.polynomial.Polynomial.fit(positions[axis], off, 1)(positions[axis])
        unit = "urad" if name.is_rotation else "um"
        worst[unit] = max(worst[unit], float(np.abs(off).max()) * (1e3 if unit == "um" else 1e6))
    off_um, off_urad = worst["um"], worst["urad"]
    yield f"  largest departure from the simulated curves, a straight line apart: {off_um:.3f} um, {off_urad:.3f} urad"
    for entry in figures.found.errors.undetermined:
        yield f"  these runs cannot tell apart: {entry.combination.split(':')[0]}"
    yield "  with the points as published the Z system is singular: P_k8 and P_k9 (Table 4) have the same x and y;"
    yield "  P_k9 is taken at y = +72 here (identification_as_published.json says what the published points leave open)"


def _path(figures: Figures) -> Iterator[str]:
    yield "S path, words of 0.001 mm: positioning error |E| (Eq. 6) and norm of the error vector, um"
    yield "                    at the points, identified errors        along all blocks  at the points, on the machine"
    yield "                    |E| mean      sd     max  vector max    |E| mean     max  |E| mean     max  vector max"
    for way, errors in figures.on_model.items():
        machine = figures.on_machine[way]
        e, true = 1e3 * np.abs(errors.positioning), 1e3 * np.abs(machine.positioning)
        along = "".join(f"{1e3 * value:8.4f}" for value in figures.along[way]) if way in figures.along else " " * 16
        yield (
            f"  {way:18s}{e.mean():8.4f}{e.std():8.4f}{e.max():8.4f}{1e3 * errors.vector.max():12.4f}    {along}"
            f"  {true.mean():8.4f}{true.max():8.4f}{1e3 * machine.vector.max():12.4f}"
        )
    for way, (largest, mean, sd) in PAPER.items():
        yield f"  {'paper, ' + way:18s}{1e3 * mean:8.4f}{1e3 * sd:8.4f}{1e3 * largest:8.4f}"
    yield "  the paper judges by the errors that it compensated, as the left columns do; the machine has the true ones"
    yield "  rounding words alone gives |E| a mean of 0.24 um: the mean of the paper's iterative figures"
    yield "  `middles` passes each point in the middle of a short block, where half steps can be reached"


def _circle(figures: Figures) -> Iterator[str]:
    yield "ball bar 300 mm in XY, circular deviation over two arcs (as ISO 230-4 has it for the circle), um"
    yield "(the circle of Table 7 needs 600 mm of X, the stroke is 540 mm: the two arcs within the stroke are run)"
    yield "                  before    after   reduction"
    for run, (before, after) in figures.circularity.items():
        yield f"  {run:12s}{1e3 * before:10.2f}{1e3 * after:9.2f}{100 * (1 - after / before):10.1f} %"
    ordinary, iterative = PAPER_CIRCULARITY["ordinary"], PAPER_CIRCULARITY["iterative"]
    reduction = 100 * (1 - iterative / ordinary)
    yield "  the paper, real machine: from ordinary to iterative compensation"
    yield f"  {'':12s}{ordinary:10.2f}{iterative:9.2f}{reduction:10.1f} %"
