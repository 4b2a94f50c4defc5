"""Runs that are not believable, and the slips of writing that would explain each by itself.

A wrong sense of an axis makes every run of a machine wrong: what one slip explains is one fault.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from trueaxis.identification.words import enumerated
from trueaxis.io.faults import Fault
from trueaxis.measurement.machine import FloatArray

SENSE = "sense of axis {axis} in the spec"


@dataclass(frozen=True, slots=True)
class Slip:
    """supposed: what would be so, as after "if"; file, remedy: of the fault that it is."""

    supposed: str
    file: str
    remedy: str


@dataclass(frozen=True, slots=True)
class Wrong:
    """fault: of the run by itself; slips: each would explain it, the likeliest first."""

    run: str
    fault: Fault
    slips: tuple[Slip, ...] = ()


def faults_of(wrong: Sequence[Wrong]) -> list[Fault]:
    """The slip that explains most runs first, with those that explain just these; then what explains most of the
    others; the runs that are left, those whose faults have all but their numbers in common together.
    """
    found, left = [], list(wrong)
    while left:
        members = {slip: [one for one in left if slip in one.slips] for one in left for slip in one.slips}
        mine = max(members.values(), key=len, default=[])
        if len(mine) < 2:
            break
        found.append(_of_slips([slip for slip, of_slip in members.items() if of_slip == mine], mine))
        left = [one for one in left if one not in mine]
    alike: dict[tuple[str, str, str], list[Wrong]] = {}
    for one in left:
        alike.setdefault((one.fault.file, one.fault.place, one.fault.remedy), []).append(one)
    return found + [_together(of_remedy) for of_remedy in alike.values()]


def _of_slips(slips: Sequence[Slip], wrong: Sequence[Wrong]) -> Fault:
    first = wrong[0]
    supposed, remedies = (
        enumerated(words, "or") for words in zip(*((s.supposed, s.remedy) for s in slips), strict=True)
    )
    problem = (
        f"{len(wrong)} runs contradict the machine, and none of them would if {supposed}; the first of them: "
        f"{first.fault.problem}"
    )
    return Fault(slips[0].file, "", problem, f"{remedies}; the runs are {enumerated([one.run for one in wrong])}")


def _together(wrong: Sequence[Wrong]) -> Fault:
    first, *others = wrong
    if not others:
        return first.fault
    return replace(first.fault, problem=f"{first.fault.problem}; likewise {enumerated([one.run for one in others])}")


def other_sense(axis: str, file: str) -> Slip:
    """That an axis is written the wrong way round."""
    return Slip(f"{axis} moved the other way", file, SENSE.format(axis=axis))


def other_way(positions: FloatArray, row: int) -> FloatArray:
    """(n_axes, n): as if one axis moved the other way."""
    found = positions.copy()
    found[row] *= -1.0
    return found
