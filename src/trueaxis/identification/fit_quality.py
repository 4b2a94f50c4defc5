"""How a fit ended: whether it stands still, and whether its residuals are of the size of the noise that is known.

What size readings may be expected to have is that of the prior; where a noise that is stated is not that of the
readings, it is said what to do.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from scipy.special import chdtri, fdtri

from trueaxis.estimation.first_order import sensed, sensed_at_home
from trueaxis.estimation.machine import IdentifiedMachine, IntArray, component_axes, units
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.runs import noise_groups
from trueaxis.estimation.undone import unit_of
from trueaxis.identification.words import READS, enumerated
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.instrument_kinds import SmallUnit, small_unit
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import home_positions
from trueaxis.measurement.setup import Run
from trueaxis.model.errors import Fit
from trueaxis.model.model import MachineModel

STEP = 1e-3  # of the standard uncertainty of an unknown: a last step below it changes nothing that is said of it
LEAST_STEP = 1e-12  # mm: below it a step is rounding
RESOLUTION = 1e-6  # mm: no instrument resolves less, however small the residuals are

# Residuals over noise. No model is complete: lost motion or heat of the size of the noise double the residuals, and are
# for `diagnose` to find. At three times the noise eight ninths of the residual variance are not noise: the
# uncertainties, which follow from the noise, are wrong by that factor. A factor, other than a p-value, does not grow
# with the number of readings.
MISFIT = 3.0
MISFIT_OF_RUN = 5.0  # a run may have one reading: beyond five standard deviations it is no noise either
DISCREPANCY = 0.01  # of the prior size of a reading: what any model of a machine leaves, however small the stated noise

FAR_FROM_NOISE = {
    True: "the residuals are far from the noise that is stated",
    False: "the residuals are far from the noise that repeated readings show",
}
# Residuals over noise from which on a converged fit is said to lack something: half of the residual variance and more
# is no noise then. Errors of 1 % of [prior], which `DISCREPANCY` allows, are no misfit, and are said all the same.
LACKING = float(np.sqrt(2.0))
UNUSUAL = 0.01  # share of the data sets in which noise alone makes a run of them as large
MOST_RUNS = 10  # named
OPTION, DEVICE = "--noise-{unit} states", "noise_{unit} of the device table (setup.toml) states"


@dataclass(frozen=True, slots=True, kw_only=True)
class RunResidual:
    """Residuals of a run: how many readings, their rms (um), and that over the noise; None where that is unknown.

    unit: "urad" of an angle instrument, whose rms is in it; most: the ratio that noise alone reaches in `UNUSUAL` of
    the data sets; infinite where that is unknown.
    """

    run: str
    readings: int
    rms_um: float
    ratio: float | None
    most: float = np.inf
    unit: SmallUnit = "um"

    @property
    def unusual(self) -> bool:
        """Whether it is more than noise gives."""
        return self.ratio is not None and self.ratio > self.most


@dataclass(frozen=True, slots=True)
class FitQuality:
    """How the fit ended, the residuals of every run, worst first, and why it is a misfit, in words; else empty.

    misread: ids of runs that were misread for sure.
    """

    fit: Fit
    runs: tuple[RunResidual, ...]
    reason: str = ""
    misread: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Residuals:
    """Residuals of readings, or of groups of readings of one run at one position.

    run: (n,), index into the runs; count: (n,), readings of each; squares: (n,), sums of their squared residuals, mm^2;
    noise: (n,), standard deviation of a reading that is stated or from repeats, mm; NaN where unknown; size: (n,), by
    errors of their prior sizes, mm; None without a prior; freedom: degrees of freedom left; copied: runs, by index,
    whose repeats are mostly equal to the last digit; estimated: (n,), as noise where that is not known, which then
    judges no fit but shows which runs stand out; independent: of runs, by index, how many independent readings scatter
    as its readings; else all of them do; stated: runs, by index, whose noise was stated; else it is that of repeats;
    noise_freedom: degrees of freedom that tell the noise of runs, by index; else it is known.
    """

    run: IntArray
    count: FloatArray
    squares: FloatArray
    noise: FloatArray
    size: FloatArray | None
    freedom: int
    copied: tuple[int, ...] = ()
    estimated: FloatArray | None = None
    independent: Mapping[int, float] = field(default_factory=dict)
    stated: tuple[int, ...] = ()
    noise_freedom: Mapping[int, float] = field(default_factory=dict)


class NotConvergedError(RuntimeError):
    """A fit that does not stand still: there are no values. `runs`: the residuals of every run, worst first."""

    def __init__(self, runs: Sequence[RunResidual], iterations: int, remedies: Sequence[str] = ()) -> None:
        self.runs = tuple(runs)
        self.iterations = iterations
        super().__init__("; ".join([f"the fit has not converged in {iterations} iterations", *remedies]))


def stands_still(step: FloatArray, u: FloatArray, sigma: float | None) -> bool:
    """Whether the last step (n,), mm, is small; u: (n,), standard uncertainties for readings of noise 1; sigma: mm."""
    largest = STEP * u * max(sigma or 0.0, RESOLUTION)
    return bool(np.all(np.abs(step) <= np.maximum(largest, LEAST_STEP)))


def expected_sizes(
    machine: IdentifiedMachine, runs: Sequence[Run], run: IntArray, positions: FloatArray
) -> FloatArray | None:
    """(n,): see `expected_size`, rows of several runs; None where the machine has no prior."""
    if not isinstance(machine, MachineModel):
        return None
    found = np.zeros(run.size)
    for index, one in enumerate(runs):
        rows = np.flatnonzero(run == index)
        if rows.size:
            found[rows] = expected_size(machine, one, np.ascontiguousarray(positions[:, rows]))
    return found


def quality(residuals: Residuals, runs: Sequence[Run]) -> FitQuality:
    """Judge the residuals of a fit that stands still: by their noise where it is known, by [prior] where it is not."""
    each = run_residuals(residuals, runs)
    if residuals.freedom <= 0:
        return FitQuality(Fit("converged"), each)
    counted, told = residuals.count > 0.0, np.isfinite(residuals.noise)
    known, unknown = counted & told, counted & ~told
    silent, groups = np.unique(residuals.run[unknown]).tolist(), noise_groups(runs)
    others, unjudged = [runs[index] for index in silent], tuple(sorted({groups[index] for index in silent}))
    chi2, far = _far_from_noise(residuals, runs, known) if known.any() else (None, None)
    if far is None:
        far = _larger_than_prior(residuals, unknown, [one.run for one in each if one.run in {run.id for run in others}])
    if far is None:
        return FitQuality(Fit("converged", chi2, unjudged=unjudged), each)
    return FitQuality(Fit("misfit", chi2, far[1], unjudged), each, far[0])


def _larger_than_prior(residuals: Residuals, of: BoolArray, named: Sequence[str]) -> tuple[str, tuple[str, ...]] | None:
    """Why residuals are a misfit that are larger than errors of the sizes of [prior] would be, and which runs, of those
    named.
    """
    if residuals.size is None or not of.any():
        return None
    readings = residuals.count[of].sum()
    rms = float(np.sqrt(residuals.squares[of].sum() / readings))
    prior = float(np.sqrt((residuals.count[of] * residuals.size[of] ** 2).sum() / readings))
    if rms <= max(prior, RESOLUTION):
        return None
    reason = f"the residuals are larger than errors of the sizes of [prior] would be ({prior * 1e3:.3g} um)"
    return reason, tuple(named[:MOST_RUNS])


def _far_from_noise(
    residuals: Residuals, runs: Sequence[Run], of: BoolArray
) -> tuple[float, tuple[str, tuple[str, ...]] | None]:
    """Chi-square per degree of freedom, and if the residuals are far from the noise why, and which runs.

    Degrees of freedom are shared in proportion to the readings.
    """
    freedom = residuals.freedom * float(residuals.count[of].sum() / residuals.count.sum())
    noise, allowed = np.maximum(residuals.noise, RESOLUTION), _with_discrepancy(residuals)
    chi2 = float((residuals.squares / noise**2)[of].sum()) / freedom
    ratio = float(np.sqrt((residuals.squares / allowed**2)[of].sum() / freedom))
    of_runs = _ratios(residuals, allowed, len(runs))
    worst = sorted(np.flatnonzero(of_runs > MISFIT), key=lambda index: -of_runs[index])
    if ratio <= MISFIT and of_runs.max(initial=0.0) <= MISFIT_OF_RUN:
        return chi2, None
    named = tuple(runs[int(index)].id for index in worst) or (runs[int(of_runs.argmax())].id,)
    stated = bool(np.isin(named[0], [runs[index].id for index in residuals.stated]))
    reason = FAR_FROM_NOISE[stated] + ("" if stated else _copies(residuals, runs))
    if stated and float(np.median(of_runs[of_runs > 0.0])) > MISFIT:
        reason += "; most runs are: the stated noise may be too small"
    return chi2, (reason, named)


def _copies(residuals: Residuals, runs: Sequence[Run]) -> str:
    if not residuals.copied:
        return ""
    named = enumerated([runs[index].id for index in residuals.copied[:MOST_RUNS]])
    return f"; repeats of {named} are equal to the last digit, which makes this noise too small: are rows copied?"


def run_residuals(residuals: Residuals, runs: Sequence[Run]) -> tuple[RunResidual, ...]:
    """Of every run with readings, worst first: by the noise, else by the rms."""
    count = np.bincount(residuals.run, weights=residuals.count, minlength=len(runs))
    squares = np.bincount(residuals.run, weights=residuals.squares, minlength=len(runs))
    present = np.flatnonzero(count)
    rms = np.sqrt(squares[present] / count[present])
    noise = residuals.noise
    if residuals.estimated is not None:
        noise = np.where(np.isfinite(noise), noise, residuals.estimated)
    known = np.zeros(len(runs), dtype=bool)
    known[residuals.run] = np.isfinite(noise)
    ratio = _ratios(residuals, np.maximum(noise, RESOLUTION), len(runs))
    found = [
        RunResidual(
            run=runs[index].id,
            readings=int(count[index]),
            rms_um=float(of_run) * 1e3,
            ratio=float(ratio[index]) if known[index] else None,
            most=_most(
                residuals.independent.get(index, float(count[index])), residuals.noise_freedom.get(index), present.size
            ),
            unit=small_unit(runs[index].instrument),
        )
        for index, of_run in zip(present.tolist(), rms, strict=True)
    ]
    return tuple(sorted(found, key=lambda one: (-(one.rms_um if one.ratio is None else one.ratio), one.run)))


def _most(independent: float, noise_freedom: float | None, runs: int) -> float:
    """Ratio that the largest of so many runs exceeds in `UNUSUAL` of the data sets; noise_freedom: None: known."""
    if noise_freedom is None:
        return float(np.sqrt(chdtri(independent, UNUSUAL / runs) / independent))
    return float(np.sqrt(fdtri(independent, noise_freedom, 1.0 - UNUSUAL / runs)))


def _with_discrepancy(residuals: Residuals) -> FloatArray:
    noise = np.maximum(residuals.noise, RESOLUTION)
    return noise if residuals.size is None else np.hypot(noise, DISCREPANCY * residuals.size)


def _ratios(residuals: Residuals, noise: FloatArray, runs: int) -> FloatArray:
    """(runs,): rms of the residuals over the noise; 0 where a run has no readings, or its noise is not known."""
    known = np.isfinite(noise)
    count = np.bincount(residuals.run, weights=np.where(known, residuals.count, 0.0), minlength=runs)
    squares = np.bincount(residuals.run, weights=np.where(known, residuals.squares / noise**2, 0.0), minlength=runs)
    return np.sqrt(np.divide(squares, count, out=np.zeros(runs), where=count > 0))


def expected_size(machine: MachineModel, run: Run, positions: FloatArray) -> FloatArray:
    """(n,): standard deviation of readings of a run at positions (n_axes, n), mm: errors of their prior sizes together.

    Component errors are taken as independent at a position and at home, and equal where an axis has not left its home.
    """
    locations = len(machine.components)
    unit = units(machine)[locations:]
    sizes = [machine.prior.of_component(name) for name in machine.components]
    sizes += [machine.prior.of_location(name, of) for name, of in zip(machine.location_errors, unit, strict=True)]
    here, home = sensed(machine, run, positions), sensed_at_home(machine, run)
    share = here - home
    zeroed = home_positions(run, machine.axes)
    if zeroed is not None:
        moved = (positions != zeroed)[component_axes(machine)]
        share[:locations] = np.where(moved, np.hypot(here[:locations], home[:locations]), share[:locations])
    found: FloatArray = np.linalg.norm(share * np.array(sizes)[:, np.newaxis], axis=0)
    return found


def noise_remedies(
    observed: Observations, stated: Mapping[int, float], each: Sequence[RunResidual], *, by_device: bool
) -> dict[str, float]:
    """A sentence for each instrument (or device) whose residuals are far from its stated noise, and their ratio.

    stated: of runs by index, mm; each: residuals of every run over that noise; by_device: whether the device table says
    it, else the option. The middle run decides: of noise that is wrong all runs are off, of a faulty run that one.
    """
    ratio = {one.run: one.ratio for one in each if one.ratio is not None}
    found, groups = {}, noise_groups(observed.runs)
    for group in dict.fromkeys(groups[index] for index in stated):
        runs = [index for index in stated if groups[index] == group]
        known = [ratio[observed.runs[index].id] for index in runs if observed.runs[index].id in ratio]
        middle = float(np.median(known)) if known else 1.0
        if 1.0 / MISFIT <= middle <= MISFIT:
            continue
        unit, small = small_unit(observed.runs[runs[0]].instrument), 1e3 * float(np.median([stated[k] for k in runs]))
        times = f"{middle:.2g} times" if middle > 1.0 else f"1/{1.0 / middle:.2g} of"
        how = unit_of(middle, observed.runs[runs[0]].instrument)
        found[
            f"the residuals of {group} are {times} the noise that "
            f"{(DEVICE if by_device else OPTION).format(unit=unit)} ({small:.3g} {unit}): leave it out and the noise "
            f"is estimated, or state about {small * middle:.2g} {unit}{f'; they are {READS[how]}' if how else ''}"
        ] = middle
    return found
