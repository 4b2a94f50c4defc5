"""What a reader of identified values must know besides."""

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from trueaxis.estimation.curve_prior import DEGREE
from trueaxis.estimation.evidence import LIKELIER
from trueaxis.estimation.instruments import CLASSES, states_line
from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.estimation.noise_of_residuals import SHARES
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.orders import HIGHEST_DEGREE, told_to_their_end
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.runs import noise_groups
from trueaxis.estimation.set_up import is_straightness
from trueaxis.identification.far_scales import as_beam, far_scales
from trueaxis.identification.far_zeros import far_zeros
from trueaxis.identification.misreadings import misread_notes
from trueaxis.identification.report import ComponentReport
from trueaxis.identification.temperatures import temperature_notes
from trueaxis.identification.tip_lengths import resting_on_length
from trueaxis.identification.words import enumerated, some_of
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.instrument_kinds import small_unit
from trueaxis.measurement.setup import Setup
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel

SLOW = 3.0  # slow over white noise: instruments drift by about as much as they scatter
DRIFT = 3.0  # times the usual drift of a run of the instrument: a smaller slow part is no more than that
MOST_SLOW = 0.999 * float(np.sqrt(SHARES[-1]))  # of the noise: the largest that is looked for
MOST_OUTLIERS = 20  # named
ON_LINE = 1.0  # mm or deg, within which a laser was set to zero on the line of its run
SILENT = "setup.toml does not say whether a compensation of the control was active; none is assumed"


def dimension_notes(machine: IdentifiedMachine, given: ErrorValues) -> tuple[str, ...]:
    """Dimensions that nobody gave."""
    silent = [n for n in machine.parameters if n not in machine.location_errors and n not in given.parameters]
    if not silent:
        return ()
    return (
        f"dimensions {enumerated(silent)} are not given (--known) and taken as zero: what follows is of a machine "
        "with its axes and points there",
    )


def compensation_note(setup: Setup, folder: Path) -> str:
    """What a reader of identified values must know of the compensation while the readings were taken."""
    key = setup.compensation
    if key is None:
        return SILENT
    if key.file is None:
        return "no compensation was active while the readings were taken (setup.toml)"
    return (
        f"{folder / key.file} was active on the control: what it took from the readings was added again, to first "
        "order in the errors. The values are those of the machine without compensation: use them instead of the active "
        "ones, not on top of them"
    )


def unread_caveats(data: MeasuredData) -> tuple[str, ...]:
    """Runs of the set-up that have no reading, or not all of theirs yet."""
    planned, run = data.readings.planned, data.readings.run
    counts = {one.id: (int((run == k).sum()), int(planned[run == k].sum())) for k, one in enumerate(data.setup.runs)}
    unread = [name for name, (rows, empty) in counts.items() if rows == empty]
    partly = [f"{name} ({empty} of {rows} rows)" for name, (rows, empty) in counts.items() if 0 < empty < rows]
    said = [f"no reading yet in {enumerated(unread)}"] if unread else []
    said += [f"readings are missing in {enumerated(partly)}"] if partly else []
    return tuple(f"{one}: the others alone are used" for one in said)


def weak_notes(components: Sequence[ComponentReport]) -> tuple[str, ...]:
    """Components that are hardly larger than their uncertainty."""
    weak = [c.name for c in components if c.u is not None and 2.0 * c.u > c.largest]
    return (f"{enumerated(weak)}: less than twice the standard uncertainty everywhere",) if weak else ()


def alignment_notes(machine: IdentifiedMachine, observed: Observations) -> tuple[str, ...]:
    """Straightness runs whose line is taken to lie along the motion: no uncertainty covers that."""
    lines = [
        run.id
        for index, run in enumerate(observed.runs)
        if is_straightness(machine, run, observed.positions[:, observed.run == index])
    ]
    if not lines:
        return ()
    return (
        f"{enumerated(lines)}: straightness lines are taken as aligned with the axes to the last micrometre; "
        "squareness, and rotations found from several such lines, rest on that, which u does not hold; --method global "
        "fits offset and slope of each line",
    )


def estimate_notes(
    model: MachineModel, observed: Observations, found: Estimate, given: ErrorValues, *, prior: bool
) -> tuple[str, ...]:
    """On an estimate: what is wrong with single runs, what was taken as known, where expectations are far off."""
    notes = []
    fixed = [name for name in model.location_errors if name in given.parameters]
    if fixed:
        zero = [name for name in fixed if given.parameters[name] == 0.0]
        what = f", {enumerated(zero)} as exactly 0" if zero else ""
        notes.append(
            f"{enumerated(fixed)}: taken as known{what}, without uncertainty (--known, --squareness known); "
            "remove them from the file to have them estimated"
        )
    kinds = dict(zip(noise_groups(observed.runs), (run.instrument for run in observed.runs), strict=True))
    for name, one in found.noise.of_group.items():
        drift = CLASSES[f"{kinds[name]} drift"].size
        if one.slow > max(SLOW * one.white, DRIFT * drift):
            least = "at least " if one.slow >= MOST_SLOW * one.sigma else ""
            unit = small_unit(kinds[name])
            notes.append(
                f"the noise of {name} is mostly slow: its slow part, {one.slow * 1e3:.3g} {unit}, is {least}"
                f"{one.slow / one.white:.2g} times its white part and more than {DRIFT:g} times the usual drift "
                f"({drift * 1e3:.3g} {unit}). A large drift of the instrument looks like that, and so do a wrong sign, "
                "a wrong point in setup.toml and an effect that the model lacks; diagnose tells more"
            )
    expected = {
        "translation": (model.prior.translation * 1e3, "translation_um"),
        "rotation": (model.prior.rotation * 1e6, "rotation_urad"),
        "location rad": (model.prior.location_angle * 1e6, "location_urad"),
        "location mm": (model.prior.location_length * 1e3, "location_um"),
    }
    for kind, (size, key) in expected.items():
        # a size of which readings tell little may come out far from the expected one without meaning it
        if found.likelier.get(kind, 0.0) > LIKELIER:
            factor, unit = found.factors[kind], "urad" if key.endswith("urad") else "um"
            doubt = "; if this machine cannot have them, check units, directions and compensation in setup.toml"
            notes.append(
                f"[prior] says {key} = {size:g}, but the readings are {_times(found.likelier[kind])} as likely with "
                f"errors of about {size * factor:.3g} {unit}, which the estimate takes{doubt if factor > 1.0 else ''}"
            )
    return (
        *misread_notes(observed, found, prior=prior),
        *_of_instruments(observed, found),
        *notes,
        *_outliers(observed, found),
        *temperature_notes(model, observed),
        *(_rough(found) if prior else ()),
        *_alignment(observed, found),
    )


def _outliers(observed: Observations, found: Estimate) -> Iterator[str]:
    """Which readings are left out."""
    rows = np.flatnonzero(found.readings.outliers)
    if not rows.size:
        return
    seq = rows if observed.seq is None else observed.seq[rows]
    named = [
        f"{observed.runs[index].id} seq {number}"
        for index, number in zip(observed.run[rows].tolist(), seq.tolist(), strict=True)
    ]
    rest = f" and {len(named) - MOST_OUTLIERS} more" if len(named) > MOST_OUTLIERS else ""
    yield (
        f"{rows.size} of {found.readings.outliers.size} readings {'is' if rows.size == 1 else 'are'} left out as "
        f"{'an outlier' if rows.size == 1 else 'outliers'}, too far from the others of their run: "
        f"{', '.join(named[:MOST_OUTLIERS])}{rest}"
    )


def _of_instruments(observed: Observations, found: Estimate) -> Iterator[str]:
    """What the estimate attributes to them, or cannot tell from them, and where they were set to zero."""
    yield from homes_notes(found.layout.model, observed)
    yield from (str(one) for one in far_zeros(observed, found) if not one.of_bars)
    yield from (as_beam(one) for one in far_scales(observed, found) if not one.of_scale)
    yield from (str(one) for one in resting_on_length(observed, found) if not one.far)


def homes_notes(model: MachineModel, observed: Observations) -> tuple[str, ...]:
    """Lines by laser that were set to zero where they do not lead: their beam is nowhere else."""
    away = []
    for index, run in enumerate(observed.runs):
        positions = observed.positions[:, observed.run == index]
        if run.instrument != "laser" or not positions.size:
            continue
        still = np.ptp(positions, axis=1) == 0.0
        home = np.array([run.home[axis] for axis in model.axes])
        off = still & (np.abs(positions[:, 0] - home) > ON_LINE)
        if off.any():
            away.append(f"{run.id} ({enumerated([axis for axis, far in zip(model.axes, off, strict=True) if far])})")
    if not away:
        return ()
    return (
        f"{some_of(away)}: on these lines the axes in brackets stand elsewhere than at `home` in "
        "setup.toml (0 where the key is left out). A laser is set to zero on its line; what the machine is off by "
        "between the two counts as error",
    )


def _times(log_ratio: float) -> str:
    """`40 times`, `more than 10 000 times`."""
    return f"{np.exp(log_ratio):.0f} times" if log_ratio < np.log(1e4) else "more than 10 000 times"


def _rough(found: Estimate) -> Iterator[str]:
    """Curves whose last orders are told: u holds nothing of what is beyond them."""
    degrees = dict(zip(found.layout.components, (basis.degree for basis in found.layout.bases), strict=True))
    by_degree: dict[int, list[str]] = {}
    for name in told_to_their_end(found.layout, found.spread, found.scale):
        if degrees[name] == DEGREE:
            continue  # the estimate would have taken more orders, had readings clearly told them
        by_degree.setdefault(degrees[name], []).append(name)
    for degree, names in by_degree.items():
        yield (
            f"{enumerated(names)}: readings tell waves as fine as the curve can follow (order {degree}), and may hold "
            "finer ones (of a pitch table, of each turn of a rotary axis), or lost motion that the spec does not have: "
            "the noise then holds what is between the targets, and beyond the outermost ones the curve may be off by "
            "several u; read home and both ends of the travel"
            + (f"; --degree {HIGHEST_DEGREE} takes more orders" if degree < HIGHEST_DEGREE else "")
        )


def _alignment(observed: Observations, found: Estimate) -> Iterator[str]:
    """How well lines of straightness are taken to be aligned: what is known of directions from home rests on it."""
    if found.ideal:
        return
    lines = [
        run.id
        for index, run in enumerate(observed.runs)
        if index in found.own and found.layout.straightness[index] and not states_line(run)
    ]
    if lines:
        size = CLASSES["straightness slope"].size * found.factors["straightness slope"]
        yield (
            f"{enumerated(lines)}: lines of straightness are taken as aligned to {size * 1e6:.2g} urad, which the "
            "readings make likely; squareness and directions from home rest on that. Lines that were turned until both "
            "ends read alike say nothing of these: state line_u_urad = 1000 of their [device] in setup.toml"
        )
