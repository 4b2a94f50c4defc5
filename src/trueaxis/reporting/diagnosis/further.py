"""What to measure next, what the data lack, what to be careful with: in sentences for a console.

Each of them becomes one for a page by `in_words`.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from trueaxis.diagnosis.further_runs.of_plan import Absence, NextRun, Placed, Separating, Told
from trueaxis.diagnosis.null_model.temperature import UNKNOWN
from trueaxis.diagnosis.result import Diagnosis, SecondOrder
from trueaxis.identification.words import enumerated
from trueaxis.reporting.diagnosis.gain_words import held_out_warning
from trueaxis.reporting.diagnosis.quantity import quantity
from trueaxis.reporting.diagnosis.structures import check_name, closer_look
from trueaxis.reporting.diagnosis.words import (
    alternatives,
    largest_structures,
    lower_case,
    noise_origin,
    period,
    shortened,
)

DIGITS = 2  # of sizes that are told apart
NAMED = 4  # runs; more of them are counted
# what tells the same of another error of the axis: at one place on the tool a rotation moves the tool point as a
# translation does
ELSEWHERE = "the same motion read with the optic, or the ball, elsewhere on the tool or on the workpiece"
_INSTRUMENTS = {"ballbar": "a ball bar", "laser": "a laser"}


@dataclass(frozen=True, slots=True)
class Proposal:
    """A further run: what to do, what for, what it would tell."""

    run: str
    purpose: str
    gain: str


def proposals(diagnosis: Diagnosis) -> tuple[Proposal, ...]:
    """Each run once, for the first of its purposes."""
    found: dict[str, Proposal] = {}
    for one in map(_proposal, diagnosis.next_runs):
        if one.run:
            found.setdefault(one.run, one)
    return tuple(found.values())


def of_verdict(diagnosis: Diagnosis) -> tuple[Proposal, ...]:
    """The proposals that bear on the verdict: on a cause that is named, structure without a name, an unknown noise. The
    others would tell effects apart that the readings show nothing of.
    """
    causes = diagnosis.causes
    named = {one.effect for one in causes} | {rival.effect for one in causes for rival in one.rivals}
    runs = [
        one
        for one in diagnosis.next_runs
        if one.told is None or named & {placed.effect for first, others in one.pairs for placed in (first, *others)}
    ]
    return proposals(replace(diagnosis, next_runs=tuple(runs)))


def _proposal(one: NextRun) -> Proposal:
    if one.check is not None:
        purpose = f"see whether the structure returns ({check_name(one.check)})"
        return Proposal(closer_look(one.check), purpose, f"{quantity(one.check.rms, 'mm')} RMS without a name")
    if one.told is None:
        run, purpose = f"every run of the {one.instrument} three times", f"determine the noise of the {one.instrument}"
        return Proposal(run, purpose, "noise from repeats, where no effect counts as noise")
    pairs = [f"{_label(effect, others)} from {_labels(effect, others)}" for effect, others in one.pairs]
    return Proposal(_times(one.run, one.times), f"separate {'; also '.join(pairs)}", _smallest(one.told))


def separating_run(separating: Separating) -> str:
    """The run that tells a cause from its rivals, from which size on, and what it leaves open."""
    if separating.told is None:
        own = separating.cause.effect
        elsewhere = any(
            one.effect.kind == own.kind and one.effect.component != own.component for one in separating.left
        )
        takes = ELSEWHERE if elsewhere else separating.broken_by
        other = f"; it takes: {takes}" if takes else ""
        return f"none of the runs considered separates it from {_labels(separating.cause, separating.left)}{other}"
    apart = _labels(separating.cause, separating.apart)
    text = f"{_times(separating.run, separating.times)}, separates it from {apart}: {_smallest(separating.told)}"
    if separating.needed > separating.times:
        text += f"; the size found needs it about {separating.needed} times"
    return text + (
        f"; {_labels(separating.cause, separating.left)} cannot be excluded by it" if separating.left else ""
    )


def absences(diagnosis: Diagnosis) -> tuple[str, ...]:
    """A sentence for each."""
    terms = [diagnosis.second_order] if diagnosis.second_order.largest > 0.0 else []
    return (*map(absence_sentence, diagnosis.absences), *map(_second_order, terms))


def absence_sentence(one: Absence) -> str:
    """What is lacking, and what that costs."""
    match one.lack:
        case "column":
            lacking, size = one.empty
            where = f"with {one.place} empty in {lacking} of {size} readings" if lacking < size else ""
            return f"{where or f'without {one.place}'}: {enumerated(one.kinds)} cannot be seen"
        case "temperature":
            runs = enumerated(one.runs) if len(one.runs) <= NAMED else f"{len(one.runs)} runs"
            return f"{runs} without temperature_c: taken as the mean of the other runs, give or take {UNKNOWN:g} K"
        case "instrument":
            without = enumerated([_INSTRUMENTS[name] for name in one.lacking], "or")
            where = f"without {without}" if without else "in these runs"
            return f"{where}: {enumerated(one.kinds)} cannot be distinguished from new values of the errors"
        case "one_side":
            return f"lines of {one.place} from one side only: they show nothing of its backlash"
        case "one_direction":
            return f"circles in {one.place} in one direction only: play and servo lag look like errors of the geometry"
        case "one_feed":
            return f"circles in {one.place} at one feed only: only its form distinguishes servo lag from play"


def _second_order(terms: SecondOrder) -> str:
    told = "large enough to be seen" if terms.seen else "below what could be detected"
    size = f"{1e3 * terms.largest:.2g} um"
    return f"linearisation: second-order terms of the given errors reach {size}, {told}; the model has them"


def warnings(diagnosis: Diagnosis) -> Iterator[str]:
    """What to be careful with."""
    for one in diagnosis.noise:
        if one.origin not in ("repeats", "given"):
            yield f"noise of the {one.group}: {noise_origin(one.origin)}; repeat runs to determine it"
    if diagnosis.verdict == "unexplained_structure" and not diagnosis.misfits:
        yield "no known cause explains the remaining structure: no name is given"
    if any(one.remainder for one in diagnosis.causes):
        shown, _ = largest_structures(diagnosis.checks)
        left = [f"{check_name(one)} ({quantity(one.rms, 'mm')} RMS)" for one in shown]
        named = enumerated([one.effect.label for one in diagnosis.causes])
        yield f"beside {named} a remainder is left: {'; '.join(left)}"
    if not diagnosis.settled:
        yield (
            "the error values of the machine with these causes have not converged: no extended machine is written. "
            "Put the causes into the spec as [[effect]] tables and identify with it: that names the worst runs"
        )
    if held_out_warning(diagnosis.gain):
        yield held_out_warning(diagnosis.gain)
    for cause in diagnosis.causes:
        if cause.rivals:
            titles = [lower_case(title) for title in alternatives(cause)]
            alike = "make the same of these readings, but for less than real effects deviate from their formulas"
            yield f"{enumerated(titles)} {alike}"
    if diagnosis.outliers:
        count = len(diagnosis.outliers)
        yield f"left out as outliers: {count} {'reading' if count == 1 else 'readings'}"


def _smallest(told: Told) -> str:
    """From which size on an effect is told from others."""
    now = (
        f"{quantity(told.without, told.unit, DIGITS)} without it" if math.isfinite(told.without) else "none without it"
    )
    return f"smallest distinguishable {told.effect.label}: {quantity(told.with_run, told.unit, DIGITS)} with it, {now}"


def _times(run: str, times: int) -> str:
    return run + (f", {times} times" if times > 1 else "")


def _label(one: Placed, others: Sequence[Placed]) -> str:
    """With its period where another has no other name."""
    return one.effect.label + (f" of {period(one)}" if any(each.effect == one.effect for each in others) else "")


def _labels(one: Placed, others: Sequence[Placed]) -> str:
    """What one is to be told from: other effects, or the same of other periods."""
    labels = [period(each) if each.effect == one.effect else each.effect.label for each in others]
    return enumerated(shortened(labels))
