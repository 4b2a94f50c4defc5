"""What a reader of identified values must know besides."""

from collections.abc import Sequence

from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.set_up import is_straightness
from trueaxis.identify.report import ComponentReport
from trueaxis.identify.words import enumerated
from trueaxis.runtime.errors import ErrorValues


def dimension_notes(machine: IdentifiedMachine, given: ErrorValues) -> tuple[str, ...]:
    """Dimensions that nobody gave."""
    silent = [n for n in machine.parameters if n not in machine.location_errors and n not in given.parameters]
    return (f"{enumerated(silent)}: not given (--known), taken as zero",) if silent else ()


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
