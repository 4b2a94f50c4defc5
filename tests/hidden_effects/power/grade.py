"""What a diagnosis said of a case, and what that is worth."""

from collections.abc import Sequence
from dataclasses import dataclass

from scipy.stats import beta

from tests.hidden_effects.hidden import Hidden

FAILED = "failed"
GRADES = ("unique", "in set", "partial", "wrong", "unexplained", "silent", FAILED)


@dataclass(frozen=True, order=True)
class Name:
    """What an effect is called: kind, component, other axis, runs, end (only where it is the reference)."""

    kind: str
    component: str = ""
    axis: str = ""
    runs: tuple[str, ...] = ()
    end: str = ""


@dataclass(frozen=True)
class Said:
    """verdict; sets: of each cause the name and its rivals', the name first; sizes, u: first parameter of each cause
    and its standard uncertainty.
    """

    verdict: str
    sets: tuple[tuple[Name, ...], ...] = ()
    sizes: tuple[float, ...] = ()
    u: tuple[float, ...] = ()
    checks: tuple[str, ...] = ()


def name_of(effect: Hidden) -> Name:
    end = effect.end if effect.end == "reference" else ""
    return Name(effect.kind, effect.component, effect.axis, tuple(sorted(effect.runs)), end)


def grade(truth: Sequence[Name], said: Said) -> str:
    """One of GRADES. `unique`: every effect by its name alone; `in set`: every effect among its rivals, nothing else;
    `partial`: some of them; `wrong`: a name, or a set of them, that holds no effect that is there; `unexplained`: told
    that something is there, and no name; `silent`: nothing said; `failed`: the
    diagnosis broke down.
    """
    if said.verdict.startswith(FAILED):
        return FAILED
    if any(not set(names) & set(truth) for names in said.sets):
        return "wrong"
    if said.verdict == "unexplained_structure":
        return "unexplained"
    found = {name for names in said.sets for name in names if name in truth}
    if not said.sets:
        return "silent"
    if found != set(truth) or len(said.sets) < len(set(truth)):
        return "partial"
    return "unique" if all(len(names) == 1 for names in said.sets) else "in set"


def upper_limit(count: int, of: int, confidence: float = 0.95) -> float:
    """One-sided upper limit of a probability (Clopper and Pearson) after `count` of `of`."""
    return 1.0 if count == of else float(beta.ppf(confidence, count + 1, of - count))
