"""What is hidden in a case, and how large: drawn from the seed of its world and its number."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cache, cached_property

import numpy as np

from tests.hidden_effects.power.grade import Name
from tests.worlds import effects as known
from tests.worlds.design import Design, draw_design
from tests.worlds.diagnosis.library import NEEDS, may_act_on
from tests.worlds.diagnosis.limits import (
    CONFOUNDED,
    Ground,
    Limit,
    flat_ground,
    limit_of,
    limit_of_outsider,
    stated_ground,
)
from tests.worlds.diagnosis.signatures import ROOTS, is_curve, largest, name_of, pitch_of, signature
from tests.worlds.diagnosis.wear import Wear, draw_wear
from tests.worlds.effects import Effect
from tests.worlds.machine import LINEAR
from tests.worlds.truth import Truth, draw_machine

Source = np.random.Generator

MIX = {  # what is hidden -> share of the cases
    "nothing": 0.30,
    "effect": 0.35,
    "outside": 0.10,
    "two": 0.08,
    "stale": 0.08,
    "stale_effect": 0.05,
    "instrument": 0.04,
}
INTERVENTIONS = ("swapped", "shuffled", "taken_away")  # of data in which one effect is plain; drawn where asked for
KINDS = (*MIX, *INTERVENTIONS)
TIMES = {  # what is hidden -> sizes in limits, and their shares
    "effect": ((1.0, 3.0, 10.0), (0.25, 0.35, 0.4)),
    "outside": ((5.0,), (1.0,)),
    "two": ((5.0, 10.0), (0.5, 0.5)),
    "stale_effect": ((5.0, 10.0), (0.5, 0.5)),
}
AT_PLAIN = ((10.0,), (1.0,))
GIVEN, GIVEN_SHARES = ("truth", "zeros", "identified"), (0.55, 0.25, 0.2)
GIVEN_STALE, GIVEN_STALE_SHARES = ("truth", "identified"), (0.65, 0.35)
TRIES = 10
LASTS = 0.5  # share of what shows, without two neighbours of each run, below which outliers take the effect away
FLAWED = 0.97  # share of what shows of an effect below which it is rather what no form of the library has
BETTER = 4.0  # by which a rival lowers the sum of squares further than the own form, so that readings speak for it
ABSORBED_SIGMA = 300.0  # norm of the signature of an effect that no reading shows: rounding stays below the noise
# probability with which one that cannot be named is kept all the same
NOT_WANTED = {
    "absorbed": 0.12,
    "mute": 0.15,
    "curve": 0.3,
    "imitated": 0.1,
    "flawed": 0.1,
    "outlying": 0.1,
    "too small": 0.0,
}
MACHINES_APART = 1000
OF_BARS = ("servo_lag", "reversal_spike_time")  # axes stand on lines
DIRECTIONAL = ("backlash", "backlash_slope", "reversal_spike")
TEMPORAL = ("drift", "warm_up", "thermal_offset", "thermal_expansion")


@dataclass(frozen=True)
class Hidden:
    """state: isolable, confounded (with the rival), absorbed (no reading shows it), too small (even the largest is
    below its limit), mute (a column without which nobody knows it is missing), imitated (outside, but candidates can do
    the same), curve (outside, and read as a changed curve of the machine), flawed (what shows of it is not the form of
    the library: own is the share that is), outlying (what shows of it is mostly two neighbours in each run, which are
    taken for outliers); times: size over the larger of both limits, of detection where rivals cannot be told from it;
    detection, isolation: in the unit of the size.
    """

    effect: Effect
    name: Name
    state: str
    times: float
    detection: float
    isolation: float
    r2: float = 0.0
    rival: Name = field(default_factory=lambda: Name(""))
    own: float = 1.0


@dataclass(frozen=True, eq=False)
class Case:
    """truth: of the machine as it is measured, effects included; given: truth, zeros or identified."""

    world: int
    number: int
    kind: str
    truth: Truth
    given: str
    hidden: tuple[Hidden, ...] = ()
    wear: Wear | None = None

    @property
    def seed(self) -> int:
        """Of the machine, the noise and the values of the shop."""
        return MACHINES_APART * self.world + self.number

    @property
    def left_out(self) -> tuple[str, ...]:
        return tuple(one.effect.component for one in self.hidden if one.effect.kind in known.ON_LOCATIONS)


@dataclass(frozen=True, eq=False)
class Bench:
    """A world with what all its cases share."""

    design: Design

    @cached_property
    def flat(self) -> Ground:
        return flat_ground(self.design)

    @cached_property
    def stated(self) -> Ground:
        return stated_ground(self.design)

    def without(self, left_out: str) -> Ground:
        return _without(self, left_out)


@cache
def _without(bench: Bench, left_out: str) -> Ground:
    return flat_ground(bench.design, (left_out,))


def bench_of(seed: int) -> Bench:
    return Bench(draw_design(seed))


def draw_case(bench: Bench, number: int, only: Sequence[str] = ()) -> Case:
    """only: of KINDS, else by MIX."""
    design = bench.design
    source = np.random.default_rng([design.seed, 71, number])
    kinds = tuple(only) or tuple(MIX)
    shares = np.array([MIX.get(kind, 0.1) for kind in kinds])
    kind = str(source.choice(kinds, p=shares / shares.sum()))
    seed = MACHINES_APART * design.seed + number
    truth = draw_machine(design.machine, seed, curves="smooth" if source.random() < 0.5 else "prior")
    stale = kind.startswith("stale")
    given = str(source.choice(GIVEN_STALE if stale else GIVEN, p=GIVEN_STALE_SHARES if stale else GIVEN_SHARES))
    case = Case(design.seed, number, kind, truth, given)
    if stale:
        case = replace(case, wear=draw_wear(source, bench.flat, truth, seed))
    if kind in ("nothing", "stale"):
        return case
    hidden = tuple(_hidden(source, bench, case))
    if any(one.effect.kind == "point_offset" for one in hidden):
        case = replace(case, given="truth")  # else nobody knows how the machine turns
    for one in hidden:
        if one.effect.kind in known.ON_LOCATIONS:
            truth = replace(truth, located=dict(truth.located) | {one.effect.component: 0.0})
    return replace(case, hidden=hidden, truth=truth.hiding(*(one.effect for one in hidden)))


def _hidden(source: Source, bench: Bench, case: Case) -> list[Hidden]:
    if case.kind == "outside":
        return [_drawn(source, bench, case, _outsiders(bench.design))]
    if case.kind == "instrument":
        return [_drawn(source, bench, case, _instruments(bench.design))]
    wanted = {"swapped": DIRECTIONAL, "shuffled": TEMPORAL}.get(case.kind, ())
    kinds = tuple(kind for kind in _library(bench.design) if not wanted or kind in wanted)
    first = _drawn(source, bench, case, kinds)
    if case.kind != "two":
        return [first]
    for _ in range(TRIES):
        second = _drawn(source, bench, case, tuple(kind for kind in kinds if kind != first.effect.kind))
        left = [bench.flat.left_of(signature(bench.design, case.truth, one.effect)) for one in (first, second)]
        squares = [float(one @ one) for one in left]
        if min(squares) > 0 and float(left[0] @ left[1]) ** 2 < 0.8 * squares[0] * squares[1]:
            break
    return [first, second]


def _library(design: Design) -> tuple[str, ...]:
    """Kinds of the library that the instruments of a design could show."""
    laser, circles = (
        any(run.instrument == "laser" for run in design.plan.runs),
        any(r.plane for r in design.plan.runs),
    )
    bars = any(run.instrument == "ballbar" for run in design.plan.runs)
    found = [kind for kind in known.ON_COMPONENTS if kind in known.KNOWN]
    found = [kind for kind in found if bars or kind not in OF_BARS]
    found += ["laser_step", "laser_step", "point_offset"] if laser else []
    return (*found, *(["ballbar_lobes", "ballbar_lobes"] if circles else []), "squareness")


def _outsiders(design: Design) -> tuple[str, ...]:
    circles = any(run.plane for run in design.plan.runs)
    return tuple(kind for kind in known.OUTSIDE if circles or kind != "dragged_lobes")


def _instruments(design: Design) -> tuple[str, ...]:
    runs = design.plan.runs
    found = ["reading_zero"] if any(run.instrument != "ballbar" for run in runs) else []
    found += ["reading_slope"] if any(run.across for run in runs) else []
    found += ["laser_scale", "laser_cosine"] if any(run.instrument == "laser" for run in runs) else []
    return (*found, *(["ballbar_length", "ballbar_centre"] if any(r.instrument == "ballbar" for r in runs) else []))


def _drawn(source: Source, bench: Bench, case: Case, kinds: Sequence[str]) -> Hidden:
    """One that shows, where a few tries find one."""
    times, shares = TIMES.get(case.kind, AT_PLAIN)
    wanted = float(source.choice(times, p=shares))
    instrument = case.kind == "instrument"
    hidden = _sized(source, bench, case.truth, _draw_effect(source, bench.design, kinds), wanted, instrument)
    for _ in range(TRIES):
        if source.random() < NOT_WANTED.get(hidden.state, 1.0):
            break
        hidden = _sized(source, bench, case.truth, _draw_effect(source, bench.design, kinds), wanted, instrument)
    return hidden


def _draw_effect(source: Source, design: Design, kinds: Sequence[str]) -> Effect:
    """Of size 0."""
    kind, shape = str(source.choice(kinds)), int(source.integers(1, 2**31))
    runs = design.plan.runs
    if kind in known.ON_LOCATIONS:
        names = [name for name, direction in design.machine.locations.items() if direction[1] in "ABC"]
        return Effect(kind, str(source.choice(names)), shape=shape)
    if kind in ("laser_step", "chatter", "reading_zero", "reading_slope"):
        fits = [
            run.id
            for run in runs
            if (run.across if kind == "reading_slope" else run.instrument != "ballbar" or kind == "chatter")
            and (kind != "laser_step" or run.instrument == "laser")
        ]
        return Effect(kind, runs=(str(source.choice(fits)),), shape=shape)
    if kind in ("laser_cosine", "point_offset", "ballbar_centre", "ballbar_length"):
        own = [r for r in runs if r.instrument == ("ballbar" if kind.startswith("ball") else "laser")]
        own = [r for r in own if kind != "laser_cosine" or not r.across]
        one = own[source.integers(len(own))]
        key = "session" if kind == "ballbar_length" else "mount"
        chosen = tuple(run.id for run in own if getattr(run, key) == getattr(one, key))
        ends = [end for end in ("target", "reference") if getattr(one, end)[0] != "bed"]
        end = str(source.choice(ends)) if kind == "point_offset" else "target"
        return Effect(
            kind, str(source.choice(list("XYZ"))) if kind in known.ON_POINTS else "", 0.0, "", chosen, end, shape
        )
    if kind in known.ON_READINGS:
        return Effect(kind, shape=shape)
    components = [name for name in design.machine.components if np.any(design.jacobian.here[name])]
    if kind in known.OUTSIDE:
        components = [name for name in components if name[1] in LINEAR]
    component = str(source.choice([name for name in components if may_act_on(kind, name)] or components))
    others = [axis for axis in design.machine.axes if axis != component[2]]
    return Effect(kind, component, 0.0, str(source.choice(others)) if kind == "cross_axis" else "", shape=shape)


def _sized(source: Source, bench: Bench, truth: Truth, effect: Effect, times: float, instrument: bool) -> Hidden:
    """At so many times its limit."""
    design, most = bench.design, largest(effect)
    name, outside = name_of(design.machine, effect), effect.kind in known.OUTSIDE
    ground = bench.stated if instrument else bench.flat
    if effect.kind in known.ON_LOCATIONS:
        ground = bench.without(effect.component)
    shown = signature(design, truth, replace(effect, size=most))
    found = limit_of_outsider(ground, shown) if outside else limit_of(ground, shown, name, pitch_of(effect))
    detection, isolation = (_in_unit(effect, most, value) for value in (found.detection, found.isolation))
    state = _state(design, effect, found, outside)
    limit = max(detection, isolation) if state == "isolable" else detection
    if state == "absorbed":
        whole = float(np.linalg.norm(ground.noisy(shown)))
        size = _in_unit(effect, most, min(0.3, ABSORBED_SIGMA / max(whole, 1e-300)))
    else:
        size = _in_unit(effect, limit, times)
    if size > most and state != "absorbed":
        state, size = "too small", most
    strength = found.strength * (size / most) ** (4 if effect.kind in ROOTS else 2)
    if state == "confounded" and strength * (found.alike - found.own) > BETTER:
        state = "flawed"
    sign = 1.0 if effect.kind in ROOTS else float(source.choice([-1.0, 1.0]))
    over = (size / limit) ** (2 if effect.kind in ROOTS else 1) if np.isfinite(limit) else 0.0
    sized = replace(effect, size=sign * size)
    return Hidden(sized, name, state, round(over, 4), detection, isolation, found.r2, found.rival, found.own)


def _in_unit(effect: Effect, size: float, times: float) -> float:
    """The size of a signature `times` as large."""
    return size * float(np.sqrt(times) if effect.kind in ROOTS else times)


def _state(design: Design, effect: Effect, found: Limit, outside: bool) -> str:
    needed = NEEDS.get(effect.kind)
    if found.strength == 0.0:
        return "absorbed"
    if needed is not None and needed not in design.columns:
        return "mute"
    if found.r2 > CONFOUNDED:
        return "imitated" if outside else "confounded"
    if outside and is_curve(design, effect):
        return "curve"
    if found.lasting < LASTS:
        return "outlying"
    return "isolable" if found.own > FLAWED else "flawed"
