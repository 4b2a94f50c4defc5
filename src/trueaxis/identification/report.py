"""What identification has to say besides the values: blocks, rank, residuals, uncertainty, what stayed open."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from trueaxis.effects.kind import Role
from trueaxis.estimation.combinations import Combination
from trueaxis.estimation.tool_point import ToolSummary
from trueaxis.identification.fit_quality import FitQuality
from trueaxis.identification.usual_sizes import ByUsualSizes
from trueaxis.measurement.instrument_kinds import SmallUnit
from trueaxis.model.covariance import Covariance
from trueaxis.model.errors import ErrorValues, Undetermined
from trueaxis.model.origin import Origin, ReadingNoise

Method = Literal["paper", "global"]
FROM_READINGS = "from the readings"
Known = Literal["determined", "up to a slope", "partly", "undetermined", "not measured", "given"]


@dataclass(frozen=True, slots=True, kw_only=True)
class BlockReport:
    """Unknowns that were solved together.

    runs and components by name; equations, unknowns and rank: counts; condition: the largest ratio of singular
    values over the positions, rotations scaled by the lever of the report; remark: what is wrong, may be empty.
    """

    runs: tuple[str, ...]
    components: tuple[str, ...]
    equations: int
    unknowns: int
    rank: int
    condition: float
    remark: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class LocationReport:
    """A location error: value and standard uncertainty (None: unknown) in `unit`, and where it comes from.

    u_readings, u_prior: the parts of u by the readings and by the prior, None where they are not known; prior: what the
    prior lets expect, None without one. These three say what determines it.
    """

    name: str
    value: float
    u: float | None
    unit: str
    origin: str
    u_readings: float | None = None
    u_prior: float | None = None
    prior: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class ComponentReport:
    """A component over the measured positions: largest value and largest standard uncertainty (None: unknown), mm or
    rad.

    at: where the largest value is, mm or deg, u_there: its standard uncertainty, None where not known. u_readings_rms,
    u_prior_rms, prior_rms: root mean squares over the travel of the parts of u by the readings and by the prior, and
    of what the prior lets expect, None without a prior: these three say what determines it. origin: where it comes
    from, in words, empty where `known` says it.
    """

    name: str
    known: Known
    largest: float
    u: float | None
    unit: str
    at: float | None = None
    u_there: float | None = None
    u_readings_rms: float | None = None
    u_prior_rms: float | None = None
    prior_rms: float | None = None
    origin: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class InstrumentReport:
    """An unknown of an instrument: value and standard uncertainty (None: unknown) in `unit`; in how many runs."""

    name: str
    value: float
    u: float | None
    unit: str
    origin: str


@dataclass(frozen=True, slots=True, kw_only=True)
class EffectParameterReport:
    """A parameter of an effect: value and standard uncertainty (None: unknown) in `unit`; role: as in its kind."""

    name: str
    value: float
    u: float | None
    unit: str
    role: Role


@dataclass(frozen=True, slots=True)
class EffectReport:
    """An effect of the machine and where its values come from."""

    effect: str
    parameters: tuple[EffectParameterReport, ...]
    origin: str


@dataclass(frozen=True, slots=True, kw_only=True)
class NoiseGroupReport:
    """Noise of the readings of an instrument (um, or as `unit` says), and what is said of it; stated: by the user."""

    group: str
    noise_um: float
    unit: SmallUnit = "um"
    instrument: str = ""
    stated: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class CurveOrderReport:
    """Powers of a component's polynomial by the paper's procedure and by held-out positions, and by what each is off at
    positions held out (rms, mm or rad); none by the paper: no term is significant.
    """

    name: str
    by_paper: tuple[int, ...]
    by_held_out: tuple[int, ...]
    held_out_by_paper: float
    held_out: float
    unit: str


@dataclass(frozen=True, slots=True, kw_only=True)
class IdentificationReport:
    """Everything besides the values. Lengths mm and angles rad unless a name says otherwise.

    readings: those used; left_out: runs that the method cannot use; iterations of the exact model and the last
    change (mm); residual_rms_um: of all readings of lengths used, NaN where there are none; freedom: degrees of freedom
    left; noise_um: standard deviation of a reading of a length, None where neither given nor to be had from the data;
    noise_origin says which; residual_rms_urad, noise_urad: the same of angles, None where there are none; undetermined
    as in the error values; notes: everything else a reader must know; instruments: their unknowns; noise_groups: of
    each instrument; curve_orders: of tables that were made polynomials; effects: those of the machine; quality: how the
    fit ended, and the residuals of each run; combinations: errors of which the readings tell a sum much better than its
    parts; tool: how well the tool point is known over the volume, None without a prior; measurement: free text of
    setup.toml about it; caveats: what must be known before all else; usual: where the usual sizes of instrument
    unknowns make u far larger; outliers: readings that were left out.
    """

    machine: str
    method: Method
    squareness: str
    readings: int
    left_out: tuple[str, ...]
    lever: float
    rank_tolerance: float
    blocks: tuple[BlockReport, ...]
    iterations: int
    last_change: float
    residual_rms_um: float
    freedom: int
    noise_um: float | None
    noise_origin: str
    locations: tuple[LocationReport, ...]
    components: tuple[ComponentReport, ...]
    undetermined: tuple[Undetermined, ...]
    quality: FitQuality
    notes: tuple[str, ...] = ()
    instruments: tuple[InstrumentReport, ...] = ()
    noise_groups: tuple[NoiseGroupReport, ...] = ()
    curve_orders: tuple[CurveOrderReport, ...] = ()
    effects: tuple[EffectReport, ...] = ()
    combinations: tuple[Combination, ...] = ()
    residual_rms_urad: float | None = None
    noise_urad: float | None = None
    tool: ToolSummary | None = None
    measurement: Mapping[str, str] = field(default_factory=dict)
    caveats: tuple[str, ...] = ()
    usual: ByUsualSizes | None = None
    outliers: int = 0

    @property
    def nothing_determined(self) -> bool:
        """Whether the data gave no value at all."""
        told = any(component.known in ("determined", "up to a slope", "partly") for component in self.components)
        return not told and not any(one.origin == FROM_READINGS for one in self.effects)


@dataclass(frozen=True, slots=True)
class Identification:
    """Error values, the report on them, and their covariance with what the readings leave open."""

    values: ErrorValues
    report: IdentificationReport
    covariance: Covariance


def origin_of(report: IdentificationReport, folder: str, prior: bool) -> Origin:
    """What identified values say of the readings that they are from.

    folder: name of the data folder; prior: whether errors of the sizes of [prior] were expected.
    """
    groups = [
        ReadingNoise(instrument=one.instrument, value=one.noise_um, unit=one.unit, stated=one.stated)
        for one in report.noise_groups
    ]
    if not groups and report.noise_um is not None:
        stated = report.noise_origin == "stated"
        groups = [ReadingNoise(instrument="all", value=report.noise_um, unit="um", stated=stated)]
    return Origin(
        folder=folder,
        method="stepwise" if report.method == "paper" else "global",
        prior=prior,
        runs=len(report.quality.runs),
        readings=report.readings,
        outliers=report.outliers,
        noise=tuple(groups),
        usual_sizes=() if report.usual is None else report.usual.sizes,
        report=dict(report.measurement),
    )
