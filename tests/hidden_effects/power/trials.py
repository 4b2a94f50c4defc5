"""The trials of each scenario: which effects are hidden, how large, in which data, and what would be right."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from tests.hidden_effects import noise, outside
from tests.hidden_effects.case import STANDARD, Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import OF_SETUP, Hidden
from tests.hidden_effects.power.bench import Bound
from tests.hidden_effects.power.grade import Name
from tests.hidden_effects.power.matched import matched_size
from tests.hidden_effects.power.outside_limit import outside_limit

TIMES = (0.3, 1.0, 3.0, 10.0)
OUTSIDE_TIMES = 5.0
LARGEST = {"point_offset": 20.0, "laser_cosine": 0.02, "servo_lag": 0.01}  # sizes that somebody would notice otherwise
LARGEST_LINEAR, LARGEST_ANGULAR = 0.1, 3e-4  # mm, rad
SHAPED = (
    "cyclic",
    "warm_up",
    "reversal_spike",
    "reversal_spike_time",
    "reversal_spike_path",
)  # the signature depends on more than the size
ROOTS = ("laser_cosine",)  # the readings go with the square of the parameter
SPANS = {"thermal_expansion": 1800.0, "thermal_offset": 3.0, "drift": 2e4, "laser_scale": 1000.0}
# mm K, K, s, mm: what a rate comes to in a campaign is bounded as other sizes are
NOISES = tuple(kind for kind in noise.KINDS if kind != "none")

Bounds = Callable[[Case], Sequence[Bound]]


@dataclass(frozen=True)
class Trial:
    """row: the line of the table that it counts in; truth: names that would be right; times: of its limit, in the
    readings of the case itself, that its one effect is still to be made; 0 where the size is set.
    """

    scenario: str
    row: str
    case: Case
    truth: tuple[Name, ...] = ()
    times: float = 0.0

    def sized(self) -> "Trial | None":
        """With the effect of its size; None where nobody has one of that size."""
        if self.times == 0.0:
            return self
        (effect,) = self.case.effects
        size = self.times * outside_limit(self.case)
        if size > LARGEST_LINEAR:
            return None
        effect = replace(effect, size=float(np.copysign(size, effect.size)))
        return replace(self, case=replace(self.case, effects=(effect,)), times=0.0)


def clean(count: int, bounds: Bounds) -> Iterator[Trial]:
    """Nothing is hidden: whatever is named is false."""
    for seed in range(count):
        kind = NOISES[seed % len(NOISES)]
        machine = "gantry" if seed % 4 == 3 else "table_mill"
        yield Trial("clean", f"noise {kind}", Case(10_000 + seed, machine, noise=kind))


def single(count: int, bounds: Bounds) -> Iterator[Trial]:
    """One effect that the audit calls observable, at multiples of its isolation limit."""
    for machine in ("table_mill", "gantry", "turntable_mill"):
        yield from single_of(machine, count, bounds)


def single_of(machine: str, count: int, bounds: Bounds, times: Sequence[float] = TIMES) -> Iterator[Trial]:
    """Those of one machine, of effects so many times their limits."""
    setting = Case(1, machine)
    yield from _scaled("single", setting, _by_kind(bounds(setting), "observable"), _share(count, machine), times)


def reduced(count: int, bounds: Bounds) -> Iterator[Trial]:
    """The same with lasers alone and with a ball bar alone."""
    for row, design in (("lasers only", Design(ball_bar=False)), ("ball bar only", Design(laser=False))):
        setting = Case(1, design=design)
        for trial in _scaled("reduced", setting, _by_kind(bounds(setting), "observable"), max(1, count // 4)):
            yield replace(trial, row=f"{row}, {trial.row.split(', ')[-1]}")


def confounded(count: int, bounds: Bounds) -> Iterator[Trial]:
    """An effect at ten times its detection limit and a third of its isolation limit or less: a set, never one name."""
    setting = Case(1)
    for kind, of_kind in _by_kind(bounds(setting), "confounded").items():
        found = [
            bound
            for bound in of_kind
            if _amplitude(bound, bound.isolation / bound.detection) > 30.0
            and _effect(bound, 10.0 * bound.detection / _limit(bound), 0) is not None
        ]
        if not found:
            continue
        for n in range(count):
            bound = found[n % len(found)]
            effect = _effect(bound, 10.0 * bound.detection / _limit(bound), 50_000 + n)
            if effect is not None:
                yield Trial("confounded", kind, _case(setting, 50_000 + n, effect), (bound.name,))


def separated(count: int, bounds: Bounds) -> Iterator[Trial]:
    """Pairs that only a further run tells apart: without it a set, with it one name."""
    scale = Design()
    pairs = {
        "laser_scale": (scale, replace(scale, gauge=True), Name("laser_scale")),
        "laser_cosine": (replace(scale, lines=3), replace(scale, lines=6), Name("laser_cosine", runs=_line("X1"))),
    }
    for kind, (without, with_it, name) in pairs.items():
        last = next((b for b in bounds(Case(1, design=with_it)) if b.name == name), None)
        if last is None or not np.isfinite(last.isolation):
            continue
        for n in range(count):
            effect = _effect(last, 10.0, 60_000 + n)
            if effect is not None:
                for row, design in (("without the run", without), ("with the run", with_it)):
                    case = _case(Case(1, design=design), 60_000 + n, effect)
                    yield Trial("separated", f"{kind}, {row}", case, (name,))


def pairs(count: int, bounds: Bounds) -> Iterator[Trial]:
    """Two observable effects of different kinds at once."""
    setting = Case(1)
    found = _by_kind(bounds(setting), "observable")
    for times in (3.0, 10.0):
        for n in range(count):
            source = np.random.default_rng([70_000, n])
            kinds = source.choice(sorted(found), 2, replace=False)
            both = [found[kind][source.integers(len(found[kind]))] for kind in kinds]
            effects = [_effect(bound, times, 70_000 + n) for bound in both]
            if None not in effects:
                case = replace(setting, seed=70_000 + n, effects=tuple(e for e in effects if e is not None))
                yield Trial("pairs", f"{times:g} times the limit", case, tuple(bound.name for bound in both))


def outsiders(count: int, bounds: Bounds) -> Iterator[Trial]:
    """Effects of no kind of the library, at five times what tells them from all that are of one."""
    setting = Case(1)
    for kind in outside.KINDS:
        for n in range(count):
            source = np.random.default_rng([80_000, n])
            component = str(source.choice(["EXX", "EYY", "EZZ", "EYX", "EXZ", "EZY"]))
            sign = float(source.choice((-1.0, 1.0)))
            effect = Hidden(kind, component if kind in outside.OF_COMPONENTS else "", size=sign, shape=n)
            yield Trial("outside", kind, _case(setting, 80_000 + n, effect), times=OUTSIDE_TIMES)


def tampered(count: int, bounds: Bounds) -> Iterator[Trial]:
    """Sound data named rightly, the same data spoilt: the name must go."""
    setting = Case(1)
    observable = _by_kind(bounds(setting), "observable")
    for how, kind, times in (("swap_directions", "backlash", 10.0), ("shuffle_time", "drift", 3.0)):
        possible = [one for one in observable[kind] if _effect(one, times, 0) is not None]
        for n in range(count if possible else 0):
            bound = possible[n % len(possible)]
            effect = _effect(bound, times, 90_000 + n)
            if effect is not None:
                sound = _case(setting, 90_000 + n, effect)
                yield Trial("tampered", f"{kind}, sound", sound, (bound.name,))
                yield Trial("tampered", f"{kind}, {how}", replace(sound, tamper=how), (bound.name,))


def values(count: int, bounds: Bounds) -> Iterator[Trial]:
    """Nothing is hidden, and the values given are right or stale."""
    for given in ("exact", "stale"):
        for n in range(count):
            yield Trial("values", given, Case(95_000 + n, given=given))


SCENARIOS: Mapping[str, Callable[[int, Bounds], Iterator[Trial]]] = {
    "clean": clean,
    "single": single,
    "reduced": reduced,
    "pairs": pairs,
    "confounded": confounded,
    "separated": separated,
    "outside": outsiders,
    "tampered": tampered,
    "values": values,
}


def _scaled(
    scenario: str, setting: Case, kinds: Mapping[str, Sequence[Bound]], count: int, every: Sequence[float] = TIMES
) -> Iterator[Trial]:
    for kind, found in kinds.items():
        for times in every:
            possible = [bound for bound in found if _effect(bound, times, 0) is not None]
            for n in range(count if possible else 0):
                bound = possible[n % len(possible)]
                seed = 20_000 + 1000 * sorted(kinds).index(kind) + n
                effect = _effect(bound, times, seed)
                if effect is not None and kind in SHAPED:
                    effect = _matched(setting, bound, effect, times)
                if effect is not None:
                    yield Trial(scenario, f"{kind}, {times:g}", _case(setting, seed, effect), (bound.name,))


def _matched(setting: Case, bound: Bound, effect: Hidden, times: float) -> Hidden | None:
    """The effect as plain as one at so many times the limit: the audit's limit is that of another pitch or constant."""
    size = matched_size(setting, effect, times * _limit(bound) / bound.detection)
    return replace(effect, size=float(np.copysign(size, effect.size))) if size <= _largest(bound) else None


def _by_kind(bounds: Sequence[Bound], state: str) -> dict[str, list[Bound]]:
    found: dict[str, list[Bound]] = {}
    for bound in bounds:
        if bound.state == state and np.isfinite(bound.detection):
            found.setdefault(bound.name.kind, []).append(bound)
    return {kind: list(np.random.default_rng(3).permutation(np.array(b, object))) for kind, b in found.items()}


def _effect(bound: Bound, times: float, seed: int) -> Hidden | None:
    """At so many times the limit; None where that would be a size that nobody has."""
    source = np.random.default_rng([seed, 11])
    root = bound.name.kind in ROOTS
    size = _limit(bound) * (np.sqrt(times) if root else times)
    if size > _largest(bound):
        return None
    size *= 1.0 if root else source.choice((-1.0, 1.0))
    name = bound.name
    shift = bound.size.upper() if name.kind in OF_SETUP else ""
    return Hidden(name.kind, name.component, name.axis, name.runs, name.end, float(size), shift, seed)


def _amplitude(bound: Bound, times: float) -> float:
    """So many times the parameter, as times the signature."""
    return times**2 if bound.name.kind in ROOTS else times


def _limit(bound: Bound) -> float:
    return bound.isolation if bound.state == "observable" else bound.detection


def _largest(bound: Bound) -> float:
    angular = bound.name.component[1:2] in ("A", "B", "C")
    largest = LARGEST.get(bound.name.kind, LARGEST_ANGULAR if angular else LARGEST_LINEAR)
    return largest / SPANS.get(bound.name.kind, 1.0)


def _case(setting: Case, seed: int, effect: Hidden) -> Case:
    return replace(setting, seed=seed, effects=(effect,))


def _share(count: int, machine: str) -> int:
    return count if machine == "table_mill" else max(1, count // 4)


def _line(name: str) -> tuple[str, ...]:
    return tuple(f"{name}-{repeat + 1}" for repeat in range(STANDARD.repeats))
