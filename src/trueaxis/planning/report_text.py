"""The report of a plan as a person reads it, and as JSON."""

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from trueaxis.error_name import ErrorName
from trueaxis.identification.words import (
    DETERMINED_BY,
    IN_COMBINATION,
    RULE,
    combination_text,
    enumerated,
    in_small,
    level_rule,
    parts_of_u,
    small,
    tool_sentence,
)
from trueaxis.io.safe_text import plain_zero
from trueaxis.planning.propose import LEAST_FREEDOM
from trueaxis.planning.report import (
    BlockReport,
    ErrorReport,
    Expectations,
    ExpectedEffect,
    ExpectedParameter,
    LocationSet,
    NoiseReport,
    PlanReport,
    ProposalReport,
)

WIDTH = 110
STATES = {"silent": "no reading depends on it", "given": "given"}
APART = "no run separates it from the errors of the machine: u would be a tenth or less if they were known"


def report_text(report: PlanReport) -> str:
    """Lines of text, ending with a newline."""
    lines = [f"{report.machine}: {_size(report)}"]
    for caveat in report.caveats:
        lines += _wrapped(caveat, "NOTE: ")
    if report.expected is not None:
        lines += _expectations(report.expected)
    lines += _order(report)
    for placed in report.location_sets:
        lines += _set(placed, report.location_sets.index(placed) == 0)
    if report.proposal is not None:
        lines += _proposal(report.proposal, report.expected)
    lines += [""] if report.notes else []
    for note in report.notes:
        lines += _wrapped(note, "note: ")
    return "\n".join(lines) + "\n"


def report_json(report: PlanReport) -> str:
    """The same as JSON; NaN is null; combinations carry their text."""
    tree = _plain({"schema": 1, **asdict(report)})
    parts = [(tree["expected"], report.expected)]
    if report.proposal is not None:
        parts.append((tree["proposal"]["after"], report.proposal.after))
    for of_tree, of in parts:
        if of is not None:
            for one, combination in zip(of_tree["combinations"], of.combinations, strict=True):
                one["text"] = combination_text(combination)
    return json.dumps(tree, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def _size(report: PlanReport) -> str:
    found = report.expected
    if found is None:
        return "a plan from nothing"
    return f"{found.runs} runs, {found.readings} readings, about {found.minutes / 60.0:.1f} h with all set-ups"


def _expectations(found: Expectations) -> list[str]:
    lines = [*_wrapped(tool_sentence(found.tool), "tool point:"), "", "noise:"]
    for one in found.noise:
        lines += _wrapped(_noise(one), "  ")
    lines += ["", "error motions: standard uncertainty over the travel, RMS and largest (its parts and [prior], RMS)"]
    lines += _errors(found.components)
    lines += _wrapped(RULE, "  ")
    if found.locations:
        level = level_rule(ErrorName(one.name).axis for one in found.components)
        what = f"location errors: standard uncertainty (its parts and [prior]); {level}"
        lines += ["", *_wrapped(f"{what}: the location errors take their slopes", "")]
        lines += _errors(found.locations)
    lines += _effects(found.effects)
    lines += ["", f"{IN_COMBINATION}:" if found.combinations else f"{IN_COMBINATION}: nothing"]
    for combination in found.combinations:
        lines += _wrapped(combination_text(combination), "- ")
    return lines


def _noise(one: NoiseReport) -> str:
    low, high = one.um
    noise = f"{low:g} {one.unit}" if low == high else f"{low:g} to {high:g} {one.unit}"
    text = f"{one.instrument}: {noise} assumed, {one.runs} run{'s' * (one.runs > 1)}, {one.readings} readings"
    if one.freedom == 0:
        return (
            f"{text}; nothing is repeated: identify takes the noise from the residuals, where an effect that the model "
            "lacks counts as noise"
        )
    share = 100.0 / math.sqrt(2.0 * one.freedom)
    enough = "" if one.freedom >= LEAST_FREEDOM else f"; {LEAST_FREEDOM} would give it to a sixth"
    return f"{text}; repeats leave {one.freedom} degrees of freedom: the noise will be known to {share:.0f} %{enough}"


def _errors(found: Sequence[ErrorReport]) -> list[str]:
    given = [one.name for one in found if one.state == "given"]
    lines = [_error(one) for one in found if one.state != "given"]
    return lines + (_wrapped(f"given: {', '.join(given)}", "  ") if given else [])


def _error(one: ErrorReport) -> str:
    assert one.state != "given"
    assert one.u is not None
    assert one.u_rms is not None
    assert one.prior is not None
    assert one.u_readings is not None
    assert one.u_prior is not None
    u = _column(one.u, one.unit)
    parts = u if one.u == one.u_rms else f"{_column(one.u_rms, one.unit)} {u}"
    judged = parts_of_u(one.u_readings, one.u_prior, one.prior, one.unit)
    return f"  {one.name:<8} {DETERMINED_BY[one.state]:<23}{parts} ({judged})"


def _effects(found: Sequence[ExpectedEffect]) -> list[str]:
    """Lines on the effects of the spec, none where it has none."""
    lines = ["", "effects: standard uncertainty"] if found else []
    for one in found:
        lines += _wrapped(f"{one.effect}: {_effect(one)}", "  ")
    return lines


def _effect(one: ExpectedEffect) -> str:
    if one.state == "lacking":
        columns = enumerated([f"column {name}" for name in one.missing])
        return f"cannot be predicted: {columns} {'is' if len(one.missing) == 1 else 'are'} missing or has gaps"
    if one.state in STATES:
        return STATES[one.state]
    told = [f"{parameter.name} {_size_of(parameter, parameter.u)}" for parameter in one.parameters if parameter.u]
    at = [f"{parameter.name} {_size_of(parameter, parameter.value)}" for parameter in one.parameters if parameter.value]
    silent = [parameter.name for parameter in one.parameters if parameter.u is None]
    text = ", ".join(told)
    text += f"; at {enumerated(at)}{'' if one.stated else ' (assumed: --effects)'}" if at else ""
    text += f"; the runs do not determine {enumerated(silent)}" if silent else ""
    return f"{text}; {APART}" if one.state == "errors" else text


def _size_of(one: ExpectedParameter, value: float) -> str:
    """Sizes in micrometres or microradians, periods, times and phases as they are."""
    factor, unit = in_small(one.unit) if one.role in ("linear", "root") else (1.0, one.unit)
    return f"{factor * value:.3g} {'' if unit == '1' else unit}".rstrip()


def _column(value: float, unit: str) -> str:
    return f"{plain_zero(value * (1e3 if unit == 'mm' else 1e6)):10.3g} {'um' if unit == 'mm' else 'urad':<4}"


def _order(report: PlanReport) -> list[str]:
    if report.expected is None:
        return []
    lines = ["", "order of blocks in identify --method stepwise (RANK in capitals: singular, not solved everywhere):"]
    if not report.blocks:
        lines[-1] += " none"
    for number, block in enumerate(report.blocks, 1):
        lines += _block(number, block)
    if report.blocks_fault:
        lines += _wrapped(f"cannot be solved position by position: {report.blocks_fault}", "  ")
    if report.free_of_order:
        lines += _wrapped(f"with all others at once (--method global): {', '.join(report.free_of_order)}", "  ")
    return lines


def _block(number: int, block: BlockReport) -> list[str]:
    text = f"{number}. {' '.join(block.runs)} -> {' '.join(block.components)}"
    if block.ranks:
        ranks = enumerated(
            [f"rank {rank} of {count}" if rank == count else f"RANK {rank} OF {count}" for rank, count in block.ranks]
        )
        text += f": {ranks} at a position, condition {block.condition:.4g}"
    return _wrapped(text + (f"; {block.because}" if block.because else ""), "  ")


def _set(one: LocationSet, first: bool) -> list[str]:
    lines = ["", "location errors that the machine needs, from the rank over its volume:"] if first else []
    text = f"{one.placement}: {one.rank} of {one.rank + len(one.redundant)}: {' '.join(one.kept)}"
    if one.workpiece_free:
        if one.missing:
            text += (
                f"; {one.complete} would be complete: no location error stands for a constant {enumerated(one.missing)}"
            )
        else:
            text += "; complete"
    lines += _wrapped(text, "  ")
    for spare in one.redundant:
        lines += _wrapped(f"{spare.name} is redundant: {spare.stands_for}", "      ")
    return lines


def _proposal(proposal: ProposalReport, before: Expectations | None) -> list[str]:
    what = "the tool point over the volume" if proposal.wanted == "volume" else proposal.wanted
    minutes = sum(one.minutes for one in proposal.added)
    lines = [
        "",
        *_wrapped(
            f"runs that lower the uncertainty of {what} most per minute, of {proposal.candidates} candidates (from "
            f"{small(proposal.before, proposal.unit)} RMS; about {minutes / 60.0:.1f} h):",
            "",
        ),
    ]
    for number, one in enumerate(proposal.added, 1):
        text = f"{number}. {one.run}: {one.what}; {one.readings} readings, {one.minutes:.0f} min"
        lines += _wrapped(f"{text}; u {small(one.u, proposal.unit)}", "  ")
    if not proposal.added:
        lines.append("  none is worth its time")
    lines += ["", "with these runs:" if before is None else "with them, and those of the plan:"]
    if before is None:
        return [*lines, *_expectations(proposal.after)]
    lines += _wrapped(tool_sentence(proposal.after.tool), "  tool point:")
    pairs = [
        *zip(before.components, proposal.after.components, strict=True),
        *zip(before.locations, proposal.after.locations, strict=True),
    ]
    lines += [f"    {'u, RMS':<10} {'before':>12}    {'after':>12}"]
    return lines + [_before_after(*pair) for pair in pairs if pair[0].state != "given"]


def _before_after(before: ErrorReport, after: ErrorReport) -> str:
    columns = [_column(one.u_rms, one.unit) for one in (before, after) if one.u_rms is not None]
    return f"    {before.name:<10} {' -> '.join(columns)}".rstrip()


def _wrapped(text: str, lead: str) -> list[str]:
    lines, current = [], lead
    for word in text.split():
        if len(current) + len(word) + 1 > WIDTH and current.strip():
            lines.append(current)
            current = " " * (len(lead) + 2)
        current += word if not current or current.endswith(" ") else f" {word}"
    return [*lines, current]


def _plain(value: Any) -> Any:
    if isinstance(value, Mapping):
        unit = value.get("unit") if "um" in value else None  # of a noise, whose key is its unit
        return {unit if key == "um" and unit else key: _plain(item) for key, item in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [_plain(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
