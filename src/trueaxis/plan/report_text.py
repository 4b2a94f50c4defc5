"""The report of a plan as a person reads it, and as JSON."""

import json
import math
from dataclasses import asdict
from typing import Any

from trueaxis.identify.words import enumerated
from trueaxis.plan.report import (
    Added,
    BlockReport,
    CurveReport,
    LocationReport,
    LocationSet,
    Move,
    PlanReport,
    Proposal,
    Repair,
)

WIDTH = 110


def report_text(report: PlanReport) -> str:
    """Lines of text, ending with a newline."""
    lines = [
        f"{report.machine}: {report.runs} runs, {report.readings} readings; motion errors as polynomials up to order "
        f"{report.degree}",
        *_wrapped(_rank(report), ""),
        "",
        "instruments:",
    ]
    for one in report.instruments:
        count = f" ({one.unknowns} unknowns)" if one.unknowns else ""
        lines += _wrapped(f"{one.assumed}{count}: {', '.join(one.runs)}", "  ")
    lines += ["", *_order(report)]
    per = f"standard uncertainty for readings of {report.noise_um:g} um"
    curves = [curve for curve in report.curves if curve.state != "given"]
    if curves:
        lines += ["", f"motion errors, largest {per}, over the positions measured:"]
        lines += [_curve(curve) for curve in curves]
    if report.locations:
        lines += ["", f"location errors, {per}:"]
        lines += [_location(location) for location in report.locations]
        lines += _wrapped(f"convention: {report.convention}", "  ")
    lines += ["", "undetermined:" if report.undetermined else "undetermined: nothing"]
    for item in report.undetermined:
        lines += _wrapped(item.combination, "- ")
    for placed in report.location_sets:
        lines += _set(placed, report.location_sets.index(placed) == 0)
    if report.repair is not None:
        lines += _repair(report.repair, report)
    if report.proposal is not None:
        lines += _proposal(report.proposal, report)
    lines += [""] if report.notes else []
    for note in report.notes:
        lines += _wrapped(note, "note: ")
    return "\n".join(lines) + "\n"


def report_json(report: PlanReport) -> str:
    """The same as JSON; NaN is null."""
    return json.dumps(_plain({"schema": 1, **asdict(report)}), indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def _rank(report: PlanReport) -> str:
    still_open = report.unknowns - report.rank - report.settled
    said = f"{report.settled} more settled by convention, " if report.settled else ""
    others = f"; {report.instrument_unknowns} unknowns of instruments besides" if report.instrument_unknowns else ""
    return (
        f"rank {report.rank} of {report.unknowns} unknowns, {said}{still_open} open; condition {report.condition:.4g} "
        f"(rotations times {report.lever:g} mm){others}"
    )


def _order(report: PlanReport) -> list[str]:
    lines = ["order in which blocks can be solved (identify --method paper):"]
    if not report.blocks:
        lines[0] += " none"
    for number, block in enumerate(report.blocks, 1):
        lines += _block(number, block)
    if report.blocks_fault:
        lines += _wrapped(f"not to be solved position by position: {report.blocks_fault}", "  ")
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


def _curve(curve: CurveReport) -> str:
    if curve.u_measured is None or curve.u_travel is None:
        part = f"{curve.determined} of {curve.unknowns} orders" if curve.state == "partly" else ""
        return f"  {curve.name:<4} {curve.state:<14} {part}".rstrip()
    text = f"  {curve.name:<4} {curve.state:<14} {_small(curve.u_measured, curve.unit)}"
    beyond = curve.u_travel > curve.u_measured * (1.0 + 1e-6)
    return f"{text} {_small(curve.u_travel, curve.unit)} over the travel".rstrip() if beyond else text.rstrip()


def _location(one: LocationReport) -> str:
    text = f"  {one.name:<10} {one.state:<14}"
    if one.u is not None:
        text += f" {_small(one.u, one.unit)}"
    if one.u_end_point is not None:
        text += f"   end points level: {_small(one.u_end_point, one.unit).strip()}"
    return text.rstrip()


def _small(value: float, unit: str) -> str:
    number = value * (1e3 if unit == "mm" else 1e6)
    return f"{number:10.4g} {'um' if unit == 'mm' else 'urad':<4}"


def _set(one: LocationSet, first: bool) -> list[str]:
    lines = ["", "location errors that the machine needs, from the rank over its volume:"] if first else []
    text = f"{one.placement}: {one.rank} of {one.rank + len(one.redundant)}: {' '.join(one.kept)}"
    if not one.placement.startswith("workpiece placed anyhow"):
        text += ""
    elif one.missing:
        text += f"; {one.complete} would be complete: without counterpart is a constant {enumerated(one.missing)}"
    else:
        text += "; complete"
    lines += _wrapped(text, "  ")
    for spare in one.redundant:
        lines += _wrapped(f"{spare.name} is redundant: {spare.stands_for}", "      ")
    return lines


def _repair(repair: Repair, report: PlanReport) -> list[str]:
    lines = ["", "points that would make the plan regular:" if repair.regular else "points that would help:"]
    for number, move in enumerate(repair.moves, 1):
        lines += _wrapped(f"{number}. {_move(move, report)}", "  ")
    if not repair.moves:
        lines.append("  no single target point raises the rank: the plan lacks runs, not points (--propose N)")
    if repair.others:
        lines += _wrapped("or instead of the first: " + "; ".join(_move(move, report) for move in repair.others), "  ")
    return [*lines, *_wrapped(repair.candidates, "  ")]


def _move(move: Move, report: PlanReport) -> str:
    return (
        f"{move.run}: target on the {move.carrier} from {_point(move.given)} to {_point(move.moved)}: rank {move.rank} "
        f"of {report.unknowns}, condition {move.condition:.4g}"
    )


def _point(point: tuple[float, float, float]) -> str:
    return f"({', '.join(f'{part:g}' for part in point)})"


def _proposal(proposal: Proposal, report: PlanReport) -> list[str]:
    lines = ["", "runs that would add most:"]
    lines += [line for number, one in enumerate(proposal.added, 1) for line in _added(number, one)]
    lines += _wrapped(proposal.candidates, "  ")
    lines += _wrapped(
        f"with them: rank {proposal.rank} of {proposal.unknowns}, {proposal.settled} more settled by convention, "
        f"condition {proposal.condition:.4g}; standard "
        "uncertainties before and after:",
        "  ",
    )
    pairs: list[tuple[CurveReport | LocationReport, CurveReport | LocationReport]] = [
        *zip(report.curves, proposal.curves, strict=True),
        *zip(report.locations, proposal.locations, strict=True),
    ]
    return lines + [_before_after(*pair) for pair in pairs if pair[0].state != "given"]


def _added(number: int, one: Added) -> list[str]:
    return _wrapped(f"{number}. {one.run}: {one.what}; {one.readings} readings; rank {one.rank}", "  ")


def _before_after(before: CurveReport | LocationReport, after: CurveReport | LocationReport) -> str:
    told = []
    for one in (before, after):
        u = one.u if isinstance(one, LocationReport) else one.u_travel
        told.append(_small(u, one.unit) if u is not None else f"{one.state:<15}")
    return f"    {before.name:<10} {told[0]} -> {told[1]}".rstrip()


def _wrapped(text: str, lead: str) -> list[str]:
    lines, current = [], lead
    for word in text.split():
        if len(current) + len(word) + 1 > WIDTH and current.strip():
            lines.append(current)
            current = " " * (len(lead) + 2)
        current += word if not current or current.endswith(" ") else f" {word}"
    return [*lines, current]


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
