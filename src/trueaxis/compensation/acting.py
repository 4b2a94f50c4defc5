"""Which effects of a machine act along a program, which can be compensated, and why the others cannot."""

from dataclasses import dataclass, replace

from trueaxis.compensation.machine import ErrorModel
from trueaxis.compensation.placed import ContextModel
from trueaxis.compensation.settings import Settings
from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.placement import REFERENCE_TEMPERATURE, SINCE_REVERSAL, context_of
from trueaxis.model.model import MachineModel

OF_INSTRUMENT = "an instrument's: no error of the machine"
NO_TIME = "depends on time: say --time"
NO_TEMPERATURE = f"temperature taken as {REFERENCE_TEMPERATURE:g} degC; another: --temperature"
_REVERSALS = ("direction", *SINCE_REVERSAL)


@dataclass(frozen=True, slots=True)
class EffectNote:
    """What is done about one effect of the machine: whether it is compensated, and how or why not."""

    effect: str
    compensated: bool
    how: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Acting:
    """A machine with those effects that are compensated.

    notes: on all of its effects. reversing: axes whose direction or distance since a reversal an effect depends on.
    moving: whether an effect depends on velocity, or on
    the time that motions take. time: s; temperature: degC.
    """

    model: ContextModel
    notes: tuple[EffectNote, ...]
    reversing: tuple[str, ...]
    moving: bool
    time: float
    temperature: float


def acting(model: ErrorModel, settings: Settings) -> Acting | None:
    """The effects of a machine along a program; None where its errors depend on positions alone."""
    if not isinstance(model, MachineModel) or not model.errors.effects:
        return None
    kinds = model.machine.kinds
    found = [(one, _note(one.effect, kinds[one.effect.kind], settings)) for one in model.errors.effects]
    kept = tuple(one for one, note in found if note.compensated)
    reversing: set[str] = set()
    moving = False
    for one in kept:
        for name in context_of(kinds[one.effect.kind]):
            own = name.removesuffix("_b")
            if own in _REVERSALS:
                axis = one.effect.axis if name.endswith("_b") else one.effect.own_axis
                reversing.add(axis or "")
            moving |= own in ("v", "d_time")
    return Acting(
        model=model.with_values(replace(model.errors, effects=kept)),
        notes=tuple(note for _, note in found),
        reversing=tuple(axis for axis in model.axes if axis in reversing),
        moving=moving,
        time=settings.time or 0.0,
        temperature=REFERENCE_TEMPERATURE if settings.temperature is None else settings.temperature,
    )


def _note(effect: Effect, kind: Kind, settings: Settings) -> EffectNote:
    if kind.place in ("reading", "point"):
        return EffectNote(effect.label, False, OF_INSTRUMENT)
    used = {name.removesuffix("_b") for name in context_of(kind)}
    if "t" in used and settings.time is None:
        return EffectNote(effect.label, False, NO_TIME)
    how = []
    if used.intersection(_REVERSALS):
        how.append("by blocks that take up what a reversal changes")
    if "v" in used:
        how.append("at the programmed feed, fading out towards stops and corners")
    if "d_time" in used and "v" not in used:
        how.append("at the programmed feed")
    if "t" in used:
        how.append(f"{settings.time:g} s after the start")
    if "T" in used:
        known = settings.temperature is not None
        how.append(f"at {settings.temperature:g} degC" if known else NO_TEMPERATURE)
    return EffectNote(effect.label, True, "; ".join(how) or "by position")
