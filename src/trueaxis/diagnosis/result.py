"""What a diagnosis comes to: plain records, from which report and diagnosis.json are written."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from trueaxis.diagnosis.further_runs.of_plan import Absence, Limit, NextRun, Separating
from trueaxis.diagnosis.judging.structure import Check
from trueaxis.effects.kind import Effect
from trueaxis.model.errors import Determined, ErrorValues

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]
BoolArray = npt.NDArray[np.bool_]

Verdict = Literal["no_discrepancy", "recalibrate", "explained", "ambiguous", "unexplained_structure"]


@dataclass(frozen=True, slots=True, kw_only=True)
class NoiseOf:
    """Noise of the readings of a group of runs (`runs.noise_groups`), mm: white, and slow (correlation: from one
    reading to the next). instrument: kind of their instrument; group: name of the group, the kind or one device of it.

    settles: by which its runs change after their start; wanders: random walk of a run, at its end; places: by which the
    balls of its runs stand elsewhere, each way, 0 where it has none; freedom: degrees of freedom of the estimate;
    origin: where it is from, see diagnose.noise.
    """

    instrument: str
    group: str
    white: float
    correlated: float
    correlation: float
    settles: float
    freedom: float
    origin: str
    wanders: float = 0.0
    places: float = 0.0

    @property
    def sigma(self) -> float:
        """Standard deviation of a reading, mm."""
        return float(np.hypot(self.white, self.correlated))


@dataclass(frozen=True, slots=True)
class Estimate:
    """Value and standard uncertainty of a parameter."""

    name: str
    value: float
    u: float
    unit: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Evidence:
    """-log10(p m) of one candidate in one round of the search. parameters: of a rival, fitted in place of the cause;
    differs_by: of a rival of the same effect, the parameter that differs, a period.
    """

    effect: Effect
    evidence: float
    p_value: float
    tries: float
    freedom: int
    parameters: tuple[Estimate, ...] = ()
    differs_by: str = ""


@dataclass(frozen=True, slots=True)
class AmplitudeOf:
    """The amplitude of a cause as one run (or line) alone shows it, in the unit of its first parameter."""

    group: str
    value: float
    u: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Cause:
    """One named cause, or the best of a set that the readings cannot tell apart.

    rms: of its signature over the readings, mm; held_out_gain: share by which it lowers the held-out RMS, noise
    included; rivals: what explains the readings about as well: other effects, or the same of another period;
    homogeneous_p: of the test that all groups have one amplitude; remainder: whether structure is left beside it;
    formula: its term in LaTeX, values not filled in; separating: the further run that would tell it from its rivals,
    None where it has none; or_changed: components whose values may have changed instead, where new values would explain
    all that it does: it is likelier, as it is one number, and no reading shows more.
    """

    effect: Effect
    parameters: tuple[Estimate, ...]
    sentence: str
    formula: str
    p_value: float
    evidence: float
    rms: float
    held_out_gain: float
    rivals: tuple[Evidence, ...]
    amplitudes: tuple[AmplitudeOf, ...]
    homogeneous_p: float
    remainder: bool
    separating: "Separating | None"
    or_changed: tuple[str, ...] = ()

    @property
    def alone(self) -> bool:
        """Whether nothing else explains the readings about as well."""
        return not self.rivals and not self.or_changed


@dataclass(frozen=True, slots=True)
class Outlier:
    """A reading far from what base and repeats say, left out; deviation: mm; z: in standard deviations of the noise."""

    run: str
    seq: int
    deviation: float
    z: float


@dataclass(frozen=True, slots=True)
class Stage:
    """RMS in mm of what is left, over all readings kept and over held-out ones, with values as given, refitted, and
    with the extended model; floor: that of the noise (pure error).
    """

    given: float
    refitted: float
    extended: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Stale:
    """Values given that are no longer true: the component or location error, from where to where (mm or deg; None of a
    location error), its change where that is clearest, with its standard uncertainty, mm or rad; p_value: of all its
    values being right, the others stale; bent: whether the change is that, halfway, from the straight line between the
    two places; alike: other components whose change explains the readings about as well; effects: of the library that
    do.
    """

    component: str
    first: float | None
    last: float | None
    value: float
    u: float
    unit: str
    p_value: float
    bent: bool = False
    alike: tuple[str, ...] = ()
    effects: tuple[Effect, ...] = ()


@dataclass(frozen=True, slots=True)
class GainOfAngles:
    """What was gained of the readings of angle instruments, mm at ARM: urad where lengths are um."""

    rms: Stage
    held_out: Stage
    floor: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Gain:
    """What was gained. rms, held_out: of readings of lengths, NaN where there are none; split: how the held-out
    readings were chosen; floor: RMS of the pure error, mm; standardised: root mean square of held-out residuals over
    their predictive standard deviations, 1 where the model is right; angles: of readings of angles, None where there
    are none.
    """

    rms: Stage
    held_out: Stage
    split: str
    floor: float
    standardised: float = float("nan")
    angles: GainOfAngles | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Circle:
    """Circularity of a circle by ball bar, mm, ISO 230-4 (largest minus smallest radius about the fitted centre):
    measured; what is left of it without the given, the refitted, the extended model.
    """

    run: str
    measured: float
    given: float
    refitted: float
    extended: float


@dataclass(frozen=True, slots=True)
class SecondOrder:
    """Terms of second order in the errors given: the largest in any reading, mm, and whether they could be seen."""

    largest: float
    seen: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class ErrorNow:
    """An error of the machine as these readings have it. given, now, change: of a component what is largest over the
    travel; u: standard uncertainty of the change, NaN where combinations are open; determined: by what; mm or rad.
    """

    name: str
    unit: str
    given: float
    now: float
    change: float
    u: float
    determined: Determined


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredWith:
    """What one device measured. device, serial: empty where setup.toml names none; sessions: named ones; motions: axes
    that move, of runs; time_s, temperature_c: from, to; None where the readings have none.
    """

    instrument: str
    device: str
    serial: str
    sessions: tuple[str, ...]
    runs: int
    readings: int
    motions: tuple[str, ...]
    time_s: tuple[float, float] | None
    temperature_c: tuple[float, float] | None


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Residuals:
    """Readings kept, one per row, mm: (n,) each. whitened: of the final model, of variance 1 if the model holds.

    run: index into runs; positions, directions: (n_axes, n); theta: polar angle (rad) of circles, NaN elsewhere;
    along: ideal displacement sensed (mm) of lines.
    """

    runs: tuple[str, ...]
    instruments: tuple[str, ...]
    noise_groups: tuple[str, ...]
    axes: tuple[str, ...]
    row: IntArray
    run: IntArray
    seq: IntArray
    positions: FloatArray
    directions: FloatArray
    time: FloatArray | None
    temperature: FloatArray | None
    feed: FloatArray | None
    theta: FloatArray
    along: FloatArray
    reading: FloatArray
    given: FloatArray
    refitted: FloatArray
    extended: FloatArray
    whitened: FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Diagnosis:
    """Everything that was found. correlation: (g, g), R^2 between the candidates of `isolability`, base projected out;
    threshold: evidence that a candidate had to reach; absences: what the data lack; report: what
    setup.toml says of the measurement in free words; errors: all of the machine, as `identify` has them from these
    readings beside the causes; none where its fit did not stand still; misfits: runs that no errors fit, worst first;
    values: of the machine with the causes named, None where none extends it; settled: whether these have
    converged: there are none where they have not.
    """

    machine: str
    verdict: Verdict
    noise: tuple[NoiseOf, ...]
    causes: tuple[Cause, ...]
    limits: tuple[Limit, ...]
    isolability: tuple[Effect, ...]
    correlation: FloatArray
    scan: tuple[Evidence, ...]
    threshold: float
    checks: tuple[Check, ...]
    outliers: tuple[Outlier, ...]
    stale: tuple[Stale, ...]
    gain: Gain
    circles: tuple[Circle, ...]
    recalibration_p: float
    next_runs: tuple[NextRun, ...]
    absences: tuple[Absence, ...]
    second_order: SecondOrder
    residuals: Residuals
    measured: tuple[MeasuredWith, ...]
    report: Mapping[str, str]
    errors: tuple[ErrorNow, ...] = ()
    misfits: tuple[str, ...] = ()
    values: ErrorValues | None = None
    settled: bool = True
