"""Effects and verdicts in plain words."""

import re
from collections.abc import Iterable, Sequence

from trueaxis.diagnosis.further_runs.of_plan import Placed
from trueaxis.diagnosis.judging.structure import Check, StructureClass
from trueaxis.diagnosis.null_model.noise import UNKNOWN
from trueaxis.diagnosis.result import Cause, Diagnosis, Estimate, Evidence, Stale, Verdict
from trueaxis.effects.kind import Effect
from trueaxis.effects.library import BY_NAME
from trueaxis.error_name import ErrorName
from trueaxis.identification.words import enumerated
from trueaxis.reporting.diagnosis.quantity import (
    NBSP,
    probability,
    quantity,
    with_expanded,
    with_own_sign,
    written,
)
from trueaxis.reporting.diagnosis.structures import check_name

TITLES: dict[Verdict, str] = {
    "no_discrepancy": "No discrepancy",
    "recalibrate": "Recalibrate",
    "explained": "Explained",
    "ambiguous": "Ambiguous",
    "unexplained_structure": "Unexplained structure",
}
MOST_STRUCTURES = 5  # named in a line
MOST_MISFITS = 5
MOST_ALTERNATIVES = 4  # to a cause that are named in a line
ESTIMATED = frozenset({"repeats", "courses", "expected"})  # origins of a noise that has degrees of freedom


def effect_title(effect: Effect) -> str:
    """`Backlash in EXX`, `Cross axis in EXX with Y`, `Laser cosine of X1, X2`."""
    words = effect.kind.replace("_", " ")
    text = words[:1].upper() + words[1:]
    rest = effect.label.removeprefix(effect.kind)
    return text + (f" in{rest}" if effect.component else rest)


def size_open(cause: Cause) -> str:
    """Why a cause that is sure may have a U as large as its size; empty where it has not."""
    size = cause.parameters[0]
    if not 2.0 * size.u >= abs(size.value):  # NaN where nothing tells it
        return ""
    return (
        "hardly told by these readings: a real effect differs from the term, and another size would show as this does"
    )


def lower_case(title: str) -> str:
    """A title within a sentence."""
    return title[:1].lower() + title[1:]


def joint(effect: Effect) -> str:
    """Where an effect acts: `positioning error of the X axis (EXX)`."""
    if effect.component is None:
        where = f"readings of {', '.join(effect.runs)}" if effect.runs else "readings of the instrument"
        return f"set-up of {', '.join(effect.runs) or 'the runs'}" if effect.end else where
    name, axis = effect.error, effect.own_axis
    if name.is_location:
        return f"squareness: location error {name.direction} of the {axis} axis ({name})"
    if name.is_positioning:
        return f"positioning error of the {axis} axis ({name})"
    if name.is_rotation:
        return f"rotation of the {axis} axis about {name.direction.line} ({name})"
    error = "straightness" if name.is_straightness else "error motion"
    return f"{error} of the {axis} axis in {name.direction.line} ({name})"


def size_of(cause: Cause | Evidence) -> str:
    """`width 6.10 um +/- 0.40 um (k = 2)`, of the first parameter."""
    if not cause.parameters:
        return ""
    first = cause.parameters[0]
    return f"{first.name} {with_expanded(first.value, first.u, first.unit)}"


def period(one: Placed) -> str:
    """`21.09 mm`: that of a candidate."""
    return ", ".join(f"{written(value, '.4g')}{NBSP}{one.effect.error.axis_unit}" for value in one.point.values())


def shortened(words: Sequence[str]) -> list[str]:
    """The first of many, and how many more."""
    more = len(words) - MOST_ALTERNATIVES
    return [*words[:MOST_ALTERNATIVES], f"{more} more"] if more > 1 else [*words]


def alternatives(cause: Cause) -> list[str]:
    """A cause and its rivals: `Cyclic in EXX of pitch 16.00 mm or 21.09 mm`, `Backlash in EXX`."""
    same = [one for one in cause.rivals if one.differs_by]
    others = [effect_title(one.effect) for one in cause.rivals if not one.differs_by]
    title = effect_title(cause.effect)
    if same:
        name = same[0].differs_by
        values = [_value_of(one, name) for one in (cause.parameters, *(one.parameters for one in same))]
        title += f" of {name} {enumerated(shortened(values), 'or')}"
    return [title, *shortened(others), *changed_instead(cause)]


def changed_instead(cause: Cause) -> list[str]:
    """`changed values of EAX and EZX`, where these may be there in its place."""
    return [f"changed values of {enumerated(cause.or_changed)}"] if cause.or_changed else []


def rival_title(rival: Evidence) -> str:
    """Of another effect its name, of the same its period."""
    name = rival.differs_by
    return f"{name}{NBSP}{_value_of(rival.parameters, name)}" if name else effect_title(rival.effect)


def _value_of(parameters: Sequence[Estimate], name: str) -> str:
    """`21.091 mm`: with as many digits as are known."""
    (found,) = (one for one in parameters if one.name == name)
    return with_expanded(found.value, found.u, found.unit).split(" ", 1)[0]


def in_words(text: str, kinds: Iterable[str]) -> str:
    """A text made for a console: `cross_axis EXX with Y` becomes `cross axis in EXX with Y`, um the unit's own sign."""
    names = "|".join(sorted(map(re.escape, {*kinds, *BY_NAME}), key=len, reverse=True))

    def spoken(match: re.Match[str]) -> str:
        return match.group(1).replace("_", " ") + (" in " if match.group(2) else "")

    text = re.sub(rf"\b({names})\b( (?=E[A-Z0-9]{{2,3}}\b))?", spoken, text)
    return with_own_sign(text)


def headline(diagnosis: Diagnosis) -> str:
    """The verdict as one sentence."""
    causes = [f"{effect_title(one.effect)}, {size_of(one)}".removesuffix(", ") for one in diagnosis.causes]
    match diagnosis.verdict:
        case "no_discrepancy":
            blind, seeing = not_judged(diagnosis), [one.group for one in diagnosis.noise]
            if not blind:
                return "The readings agree with the model: the residuals are noise."
            told = enumerated([name for name in seeing if name not in blind])
            agree = f"The readings of {told} agree with the model" if told else "Nothing can be said of the model"
            return f"{agree}; those of {enumerated(blind)} cannot be judged: they are too few to know their noise."
        case "recalibrate":
            return "The form of the model suffices, but its values are stale: recalibrate."
        case "explained":
            return f"{'Causes' if len(causes) > 1 else 'Cause'} found: {enumerated(causes)}."
        case "ambiguous":
            sets = [enumerated(alternatives(one), "or") for one in diagnosis.causes]
            return f"{'; '.join(sets)}: these readings cannot tell which."
        case "unexplained_structure":
            wrong = f"No errors of the machine fit {misfits_named(diagnosis)}: look at these runs first."
            unknown = "The residuals are not noise, and no known effect explains them: no cause is named."
            return wrong if diagnosis.misfits else unknown


def explanation(diagnosis: Diagnosis) -> str:
    """What the verdict means, and what to do."""
    meaning = _MEANING[diagnosis.verdict]
    if diagnosis.verdict == "no_discrepancy" and not_judged(diagnosis):
        meaning = (
            "What only readings of unknown noise show would not have been found. Repeat their runs, or state the noise "
            "of a reading."
        )
    if diagnosis.misfits:
        return f"I{_ASK_OF_MISFITS.removeprefix('i')}. {_BESIDE_MISFITS}"
    return f"{meaning} {_detail(diagnosis)}".rstrip()


def not_judged(diagnosis: Diagnosis) -> list[str]:
    """Instruments whose readings are too few to know their noise: what they read is no evidence of anything."""
    return [one.group for one in diagnosis.noise if one.origin == UNKNOWN]


_MEANING: dict[Verdict, str] = {
    "no_discrepancy": (
        "No test finds more in the residuals than the noise of the repeats, and refitting the values brings no more "
        "than chance would. No correction is needed; effects below their detection limits cannot be excluded."
    ),
    "recalibrate": (
        "With new values the same model leaves only noise, so no effect has to be added: identify the errors "
        "again from readings such as these and compensate with them."
    ),
    "explained": (
        "The model with the terms named below leaves only noise (or a remainder, where a cause says so), and it "
        "predicts runs that it was not fitted to."
    ),
    "ambiguous": (
        "The readings show something beyond the model, but several causes predict the same. The one that fits best is "
        "shown with the size that it would have, with its rivals and the run that would tell them apart."
    ),
    "unexplained_structure": (
        "No effect of the library leaves noise alone, so that to name the nearest one would be a guess. The checks say "
        "what the structure looks like. Search there, by hand or with an effect kind of your own in the machine file."
    ),
}

_ASK_OF_MISFITS = (
    "is the sign of the readings right, is direction, do they belong to this run, is its set-up as setup.toml says? "
    "The command identify says by how much they are off, and whether a run reads as if one of these were wrong"
)
_BESIDE_MISFITS = (
    "A run that is wrong spoils what is fitted to all: no cause, no stale value and no check is to be believed beside "
    "it. Put it right or leave it out, and diagnose again."
)


def _detail(diagnosis: Diagnosis) -> str:
    if diagnosis.verdict == "recalibrate":
        changed = [stale_change(one) for one in diagnosis.stale[:MOST_STRUCTURES]]
        if more := len(diagnosis.stale) - len(changed):
            changed.append(f"{more} more, listed below")
        listed = f"Changed: {'; '.join(changed)}. " if changed else ""
        p = probability(diagnosis.recalibration_p)
        return f"{listed}Were all values given true, readings would be as far from them with a probability of {p}."
    if diagnosis.verdict == "unexplained_structure":
        shown, more = largest_structures(diagnosis.checks)
        said = [f"{check_name(one)} ({quantity(one.rms, 'mm')} RMS)" for one in shown]
        said += [f"{more} more classes, listed under the checks"] if more else []
        return f"It looks like: {enumerated(said)}." if said else ""
    return ""


def stale_change(one: Stale) -> str:
    """`EYY from 300 to 400 mm by 0.7 um, u 0.1 um (or EYZ instead)`; a location error has no range."""
    size = f"by{NBSP}{quantity(one.value, one.unit)}, u{NBSP}{quantity(one.u, one.unit, 2)}"
    start, end = stale_range(one)
    where = f"{one.component} from {start} to {end}" if start else one.component
    form = " from the straight line between its ends" if one.bent else ""
    others = [*one.alike, *(each.label for each in one.effects)]
    instead = f" (or {enumerated(others, 'or')} instead)" if others else ""
    return f"{where} {size}{form}{instead}"


def stale_range(one: Stale) -> tuple[str, str]:
    """From where to where values have changed, `300` and `400 mm`; empty of a location error."""
    if one.first is None or one.last is None:
        return "", ""
    unit = ErrorName(one.component).axis_unit
    return written(one.first, ".4g"), f"{written(one.last, '.4g')}{NBSP}{unit}"


def largest_structures(checks: Iterable[Check]) -> tuple[list[Check], int]:
    """The classes that fired, the largest ones first; how many more there are. One structure makes many fire."""
    fired = [one for one in checks if one.fired]
    fired.sort(key=lambda one: (one.structure is StructureClass.LACK_OF_FIT, -one.rms))
    return fired[:MOST_STRUCTURES], len(fired[MOST_STRUCTURES:])


def short_title(effect: Effect, longest: int = 26) -> str:
    """`effect_title`, cut where a figure has no room for more."""
    title = effect_title(effect)
    return title if len(title) <= longest else f"{title[: longest - 1]}\N{HORIZONTAL ELLIPSIS}"


def noise_origin(origin: str) -> str:
    """Where the noise of an instrument comes from, in words."""
    return {
        "repeats": "repeats",
        "courses": "nothing is repeated, from the residuals of the null model",
        "expected": "nothing is repeated, and targets are few: what errors of the size of [prior] leave",
        "given": "given",
        "unknown": "unknown: too few readings",
    }[origin]


def misfit(diagnosis: Diagnosis) -> str:
    """Runs that no errors of the machine fit; empty where there are none."""
    if not diagnosis.misfits:
        return ""
    return f"no errors of the machine fit {misfits_named(diagnosis)}: {_ASK_OF_MISFITS}"


def misfits_named(diagnosis: Diagnosis) -> str:
    """`X-1 and Y-3`, the first of many."""
    more = len(diagnosis.misfits) - MOST_MISFITS
    return enumerated([*diagnosis.misfits[:MOST_MISFITS], *([f"{more} more"] if more > 0 else [])])
