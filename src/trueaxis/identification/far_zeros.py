"""Runs whose readings start far from zero, beside the others of their class and beside what is usual of it."""

from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.instruments import CLASSES, SET_UP_FACTOR, own_kinds
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.identification.words import in_digits, in_small, some_of

FAR_ZERO = 6.0  # times the median of the zeros of a class: of normal ones one in 20 000 is


@dataclass(frozen=True, slots=True, kw_only=True)
class FarZeros:
    """kind: the class; of_run: zeros of the runs, by id, mm or rad, the farthest first; among: runs of the class;
    usual: the size up to which none is far, mm or rad.
    """

    kind: str
    of_run: dict[str, float]
    among: int
    usual: float

    @property
    def of_bars(self) -> bool:
        """Of ball bars. One bar has one length: where its other runs start near zero, a run that does not tells of
        balls that are elsewhere, or of what other instruments have got wrong. A laser may not have been set to zero.
        """
        return self.kind == "ballbar zero"

    def __str__(self) -> str:
        factor, unit = in_small(CLASSES[self.kind].unit)
        named = [f"{run} by {in_digits(value * factor, 3)} {unit}" for run, value in self.of_run.items()]
        of = f"{len(self.of_run)} of {self.among} runs"
        said = f"the {self.kind} of {of} is larger than {in_digits(self.usual * factor, 3)} {unit}"
        why = (
            "no bar does that beside its other runs. Is their bar another one, do their balls stand where setup.toml "
            "says, are the dimensions in the spec right, is what other instruments say of the machine, by the length "
            "of a probe or the place of a sphere?"
            if self.of_bars
            else "the estimate attributes that to the instrument, not to the machine"
        )
        return f"{said}: {some_of(named)}; {why}"


def far_zeros(observed: Observations, found: Estimate) -> list[FarZeros]:
    """Of every class that has some."""
    zeros: dict[str, dict[str, float]] = {}
    for index, own in found.own.items():
        for kind, value in zip(own_kinds(observed.runs[index], found.layout.straightness[index]), own, strict=True):
            if CLASSES[kind].zero:
                zeros.setdefault(kind, {})[observed.runs[index].id] = float(value)
    each = []
    for kind, of_run in zeros.items():
        usual = max(SET_UP_FACTOR * CLASSES[kind].size, FAR_ZERO * float(np.median(np.abs([*of_run.values()]))))
        far = sorted((run for run in of_run if abs(of_run[run]) > usual), key=lambda run: -abs(of_run[run]))
        if far:
            each.append(FarZeros(kind=kind, of_run={run: of_run[run] for run in far}, among=len(of_run), usual=usual))
    return each
