"""Lines of a laser that read longer or shorter than its scale and a beam out of line can make them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.identification.words import enumerated

# of the length that is read, by which no beam makes it short: at 3.2 mrad it has left its detector within some metres
FAR_SCALE = 5e-6
SURE = 3.0  # standard uncertainties
SCALES = ("laser scale", "stated scale")
PER_KELVIN = 11.5e-6  # 1/K: a scale of steel or glass ceramic is between nothing and this


@dataclass(frozen=True, slots=True, kw_only=True)
class FarScale:
    """Lines of one device in one session: runs, by id; low, high: what they read too long of a length."""

    runs: tuple[str, ...]
    session: str
    low: float
    high: float

    @property
    def of_scale(self) -> bool:
        """Whether several lines agree: one alone may be a beam out of line, or what the model lacks along it."""
        return len(self.runs) > 1

    def __str__(self) -> str:
        way = "long" if self.low > 0.0 else "short"
        near, far = sorted((abs(self.low) * 1e6, abs(self.high) * 1e6))
        where = f" in session {self.session}" if self.session else ""
        if len(self.runs) == 1:
            return f"the line {self.runs[0]}{where} reads {far:.3g} ppm too {way}"
        many = f"{far:.3g} ppm" if near == far else f"{near:.3g} to {far:.3g} ppm"
        return f"the lines {enumerated(self.runs)}{where} read {many} too {way}"


def as_scale(far: Sequence[FarScale]) -> str:
    """What is wrong where several lines are."""
    middles = [0.5 * (one.low + one.high) for one in far]
    kelvin = (max(*middles, 0.0) - min(*middles, 0.0)) / PER_KELVIN
    return (
        f"{'; '.join(map(str, far))}, beside the other readings. A beam out of line reads short, and not as much; the "
        "scale of the laser does that (its wavelength, its sensor of air, a wrong unit), and so does a machine that is "
        f"{kelvin:.2g} K warmer or colder in one session than in another: bring readings to one temperature, or "
        "identify the sessions by themselves (--runs)"
    )


def as_beam(far: FarScale) -> str:
    """What is wrong where one line is."""
    if far.low > 0.0:
        return f"{far} beside the other readings, as no beam out of line does: was the machine warmer then?"
    angle = float(np.sqrt(-2.0 * far.low)) * 1e3
    return f"{far} beside the other readings: its beam was {angle:.2g} mrad out of line, which the values allow for"


def far_scales(observed: Observations, found: Estimate) -> tuple[FarScale, ...]:
    """Of each device and session, those that read long and those that read short."""
    groups: dict[tuple[str, str, str, bool], list[tuple[str, float]]] = {}
    values, spread = (part[found.layout.of_shared].copy() for part in (found.unknowns, found.spread))
    # what all scales have in common may be the machine's: axes that are all too long are warm
    scales = np.array([one.kind in SCALES for one in found.layout.shared], dtype=bool)
    values[scales] -= values[scales].mean() if scales.any() else 0.0
    spread[scales] -= spread[scales].mean(axis=0) if scales.any() else 0.0
    for one, value, row in zip(found.layout.shared, values.tolist(), spread, strict=True):
        of_length = one.kind in SCALES or one.kind == "laser cosine"
        if of_length and abs(value) > max(FAR_SCALE, SURE * float(np.linalg.norm(row))):
            run = observed.runs[one.runs[0]]
            key = one.kind, run.session, run.device.id if run.device else "", value > 0.0
            groups.setdefault(key, []).extend((observed.runs[index].id, value) for index in one.runs)
    return tuple(_of_group(session, lines) for (_, session, _, _), lines in groups.items())


def _of_group(session: str, lines: Sequence[tuple[str, float]]) -> FarScale:
    each = [value for _, value in lines]
    return FarScale(runs=tuple(run for run, _ in lines), session=session, low=min(each), high=max(each))
