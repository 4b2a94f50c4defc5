"""The diagnosis on the console."""

import math
from collections.abc import Iterator

from trueaxis.diagnosis.result import Cause, Diagnosis, Gain, GainOfAngles
from trueaxis.effects.library import BY_NAME
from trueaxis.reporting.diagnosis.further import of_verdict, proposals, separating_run, warnings
from trueaxis.reporting.diagnosis.gain_words import given_note, held_out_change, predicted_scatter
from trueaxis.reporting.diagnosis.quantity import ascii_only, micrometres, probability, with_expanded
from trueaxis.reporting.diagnosis.structures import check_meaning, check_name
from trueaxis.reporting.diagnosis.words import (
    changed_instead,
    effect_title,
    headline,
    joint,
    largest_structures,
    misfit,
    rival_title,
    shortened,
    size_open,
    stale_change,
)


def summary_text(diagnosis: Diagnosis) -> str:
    """A few lines in ASCII, the verdict first, ending with a newline."""
    return ascii_only("\n".join(_lines(diagnosis))) + "\n"


def _lines(diagnosis: Diagnosis) -> Iterator[str]:
    yield f"{diagnosis.verdict}: {headline(diagnosis)}"
    for number, cause in enumerate(diagnosis.causes, 1):
        yield from _cause(number, cause)
    if diagnosis.misfits:
        yield misfit(diagnosis)
    elif diagnosis.verdict == "unexplained_structure":
        shown, more = largest_structures(diagnosis.checks)
        yield from (
            f"looks like: {check_name(one)}: {check_meaning(one)} "
            f"({micrometres(one.rms)} um RMS, p {probability(one.p_value)})"
            for one in shown
        )
        if more:
            yield f"looks like: {more} more classes, smaller or the same seen otherwise (report.html)"
    yield from (
        f"stale: {stale_change(one)} (p of the whole change {probability(one.p_value)})" for one in diagnosis.stale
    )
    yield from _gain(diagnosis.gain)
    yield from filter(None, [given_note(diagnosis)])
    further = of_verdict(diagnosis)
    yield from (f"next: {one.run}, to {one.purpose}: {one.gain}" for one in further)
    if others := len(proposals(diagnosis)) - len(further):
        runs = "run" if others == 1 else "runs"
        yield f"report.html names {others} more {runs}, to distinguish effects of which these readings show nothing"
    yield from (f"warning: {text}" for text in warnings(diagnosis))


def _gain(gain: Gain) -> Iterator[str]:
    parts: list[tuple[str, str, Gain | GainOfAngles]] = []
    if math.isfinite(gain.floor):
        parts.append(("", "um", gain))
    if gain.angles is not None:
        parts.append((" of angles", "urad", gain.angles))
    for of, unit, part in parts:
        for what, stage in ((f"RMS{of}", part.rms), (f"held-out RMS{of} ({gain.split})", part.held_out)):
            if not math.isfinite(stage.given):
                yield f"{what}: none, the zeros of their instruments absorb all of these readings"
                continue
            yield (
                f"{what}: given {micrometres(stage.given)}, refitted {micrometres(stage.refitted)}, "
                f"extended {micrometres(stage.extended)} {unit}; noise floor {micrometres(part.floor)} {unit}"
            )
    if predicted_scatter(gain):
        yield predicted_scatter(gain)


def _cause(number: int, cause: Cause) -> Iterator[str]:
    yield f"cause {number}: {effect_title(cause.effect)}: {cause.sentence}"
    yield f"  where: {joint(cause.effect)}"
    kind = BY_NAME.get(cause.effect.kind)
    term = kind.expression if kind else cause.formula  # places on a body are moved by no term
    if term:
        yield f"  term: {term}"
    for one in cause.parameters:
        yield f"  {one.name} = {with_expanded(one.value, one.u, one.unit)}"
    if size_open(cause):
        yield f"  size: {size_open(cause)}"
    yield (
        f"  evidence: p {probability(cause.p_value)}, {micrometres(cause.rms)} um RMS, "
        f"held-out RMS {held_out_change(cause)}"
    )
    if not cause.alone:
        others = [*shortened([rival_title(one) for one in cause.rivals]), *changed_instead(cause)]
        yield f"  cannot be distinguished from: {', '.join(others)}"
    if cause.separating is not None:
        yield f"  run that would tell: {separating_run(cause.separating)}"
    if cause.remainder:
        yield "  this cause leaves a remainder unexplained"
