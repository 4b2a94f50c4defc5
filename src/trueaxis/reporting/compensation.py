"""What a compensation did, in sentences: first what is not as it should be or may cost a part, then what the operator
has to know, last how it was computed.
"""

import math
from collections.abc import Mapping

from trueaxis.compensation.elsewhere import NEAR, OffsetUse, UnknownPlaces, UnnamedFeeds
from trueaxis.compensation.logs import Lines
from trueaxis.compensation.machine import ROTARY
from trueaxis.compensation.report import CompensationReport, Errors, Failure
from trueaxis.compensation.settings import LEAST_INCH, MM_PER_INCH
from trueaxis.compensation.tools import ToolUse
from trueaxis.identification.words import enumerated
from trueaxis.reporting.compensation_checks import kinematics_text, position_text, senses_text, sign_check_text
from trueaxis.reporting.compensation_warnings import warnings_of

_LINES_NAMED = 10
_FAILURES: dict[Failure, str] = {
    "not converged": "points did not converge",
    "above tolerance": "points above the tolerance",
    "out of travel": "points out of travel",
    "tool axis above tolerance": "tool axis above its tolerance",
    "above within ranges of offsets": "not good for all work offsets in the ranges given",
    "above at other places of axes": "points above the tolerance where axes may stand that are not commanded yet",
    "nothing moves": "nothing in the program moves an axis",
}


def failure_text(report: CompensationReport) -> str:
    """Why what was written is not good, in a few words; empty where it is."""
    return ", ".join(_FAILURES[one] for one in report.failures)


def compensation_text(report: CompensationReport) -> str:
    """The report as lines of text."""
    settings = report.settings
    lines = [
        f"{report.program} ({report.language.upper()}): {report.blocks_in} blocks read, {report.blocks_out} written; "
        f"{report.moves} moves, {report.points} points"
        + (f", {report.short_blocks} passed in short blocks" if report.short_blocks else "")
        + (f", {report.take_ups} blocks that take up reversals" if report.take_ups else ""),
        *([f"not good, exit code 1: {failure_text(report)}"] if report.failures and not report.refused else []),
        *(f"WARNING: {warning}" for warning in warnings_of(report)),
        *_errors(report),
        *_troubles(report),
        *_places(report),
    ]
    lines.extend(
        f"M{one.code} passed, as --pass-m says that it moves nothing and changes no mode: "
        f"{one.lines.points} times, lines {_named_lines(one.lines)}"
        for one in report.passed
    )
    if report.parked_at_end.points:
        lines.append(
            "note: rapids in machine coordinates (G53) stop at the end of travel: "
            f"{_points(report.parked_at_end)}; nothing is cut there, and they count as no fault"
        )
    lines.extend(f"note: {note}" for note in (*_inch_words(report), *report.notes))
    lines.append(senses_text(report.senses))
    if report.sign_check is not None:
        lines.append(sign_check_text(report.sign_check))
    if report.kinematics_check is not None:
        lines.append(kinematics_text(report.kinematics_check))
    steps = ", ".join(f"{k}: {n} points" for k, n in enumerate(report.iterations) if n)
    lines.append(f"method {settings.method}, words {settings.words}, {_resolution(report)}; corrections made: {steps}")
    return "\n".join(lines)


def _resolution(report: CompensationReport) -> str:
    """The steps of words and the tolerances, in each unit that is written."""
    settings, found = report.settings, []
    for unit in report.units or ("mm",):
        step = settings.inch_step if unit == "inch" else settings.resolution
        found.append(f"resolution {step:.7g} {unit}, tolerance {settings.allowed(unit == 'inch'):g} mm")
    return ", ".join(found)


def _inch_words(report: CompensationReport) -> list[str]:
    """What the decimals of words in inch rely on, where no option says how many the control reads."""
    settings = report.settings
    if "inch" not in report.units or settings.inch_resolution is not None:
        return []
    if settings.inch_step >= LEAST_INCH:
        return [
            f"words of {settings.inch_step:g} inch, and the tolerance is one step of them ({report.tolerance:g} mm) "
            "unless --tolerance states it; --inch-resolution 0.00001 is finer, where the control reads it (IS-C)"
        ]
    if settings.dialect is None:
        return [
            "words in inch have five decimals: a control that reads four (IS-B of Fanuc and the like) rounds them, "
            f"which is up to 2.2 um off; --inch-resolution {LEAST_INCH:.4f} then writes and judges what it reads"
        ]
    return []


def _errors(report: CompensationReport) -> list[str]:
    """The tables of errors."""
    lines = [
        f"{'error of the tool point (um)':34s}{'mean':>10s}{'sd':>10s}{'largest':>10s}  at line of file",
        *_rows(report),
        *_uncertainty(report),
    ]
    if report.ball is not None:
        lines += ["|E| along the ball bar, Eq. (6) (um)", *_rows(report.ball)]
    if report.orientation is not None:
        kept = report.settings.orientation == "keep"
        corrected = "kept: linear axes alone are corrected" if kept else "corrected"
        lines += [f"orientation of the tool axis, {corrected} (urad)", *_rows(report.orientation, 1.0)]
    return lines


def _uncertainty(report: CompensationReport) -> list[str]:
    """A line of the table: how far off these errors, those of the values, may be of the machine's."""
    known = None if report.reliance is None else report.reliance.uncertainty
    if known is None or not known.largest_u:
        return []
    return [f"{f'  u of the values, from {known.datum}':34s}{'':20s}{1e3 * known.largest_u:10.2f}"]


def _rows(of: CompensationReport | Errors, unit: float = 1e3) -> list[str]:
    """A line for each stage; unit: what its figures are multiplied by."""
    table = (
        ("  as programmed", of.before),
        ("  compensated, words not rounded", of.solved),
        ("  compensated, as written", of.after),
        ("  along the executed feed blocks", of.along),
    )
    return [
        f"{name:34s}{unit * part.mean:10.2f}{unit * part.sd:10.2f}{unit * part.largest:10.2f}  {part.line}"
        for name, part in table
        if part is not None
    ]


def _named_lines(lines: Lines) -> str:
    """The first of them."""
    more = " ..." if len(lines.first) > _LINES_NAMED else ""
    return ", ".join(map(str, lines.first[:_LINES_NAMED])) + more


def _points(lines: Lines) -> str:
    return f"{lines.points} points, lines {_named_lines(lines)}"


def _out_of_travel(beyond: Mapping[str, float]) -> str:
    by = enumerated([f"{axis} by up to {far:.4f} {'deg' if axis in ROTARY else 'mm'}" for axis, far in beyond.items()])
    return f"out of travel, words stop at its end ({by}; if it goes so far, say so in travel of the spec)"


def _troubles(report: CompensationReport) -> list[str]:
    """Points that are not as they are to be, and why."""
    settings = report.settings
    kinds = (
        ("not converged", report.not_converged),
        ("above tolerance", report.over_tolerance),
        (_out_of_travel(report.beyond_travel), report.out_of_travel),
        (f"above {settings.orientation_tolerance_urad:g} urad", report.over_orientation),
        ("singular poses, one direction of the tool axis not corrected (no fault between rapids)", report.singular),
    )
    return [
        *(_coarse_words(report) if report.over_tolerance.points else []),
        *(f"{name}: {_points(found)}" for name, found in kinds if found.points),
        *_left_by_held_axes(report),
    ]


def _left_by_held_axes(report: CompensationReport) -> list[str]:
    """Lines above the tolerance because an axis gets no word there."""
    found = [line for line in report.over_tolerance.first if line in report.uncommanded.first]
    if not found:
        return []
    lines = _named_lines(Lines(len(found), tuple(found)))
    return [
        f"lines {lines}: an axis has no word there, so its error is left (see the notes): command it in this frame "
        "before, by G90"
    ]


def _coarse_words(report: CompensationReport) -> list[str]:
    """Where the rounding of words alone passes the tolerance, so that no compensation can reach it."""
    settings, found = report.settings, []
    for inch in (False, True):
        step, unit = (settings.inch_step, "inch") if inch else (settings.resolution, "mm")
        off = 0.5 * math.sqrt(3.0) * step * (MM_PER_INCH if inch else 1.0)
        if off > settings.allowed(inch) and unit in report.units:
            finer = "--inch-resolution" if inch else "--resolution"
            found.append(
                f"words of {step:g} {unit} are up to {1e3 * off:.1f} um off, more than the tolerance: it cannot be "
                f"reached everywhere with these words; a finer {finer} where the control reads it, or --tolerance "
                f"{math.ceil(1e4 * off) / 1e4:g}"
            )
    return found


def _places(report: CompensationReport) -> list[str]:
    """What effects, axes without words, work offsets, tools and unknown places come to."""
    lines = [
        f"effect {one.effect}: {'compensated' if one.compensated else 'left alone'}, {one.how}"
        for one in report.effects
    ]
    if any(one.compensated for one in report.effects):
        lines.append("with effects all arcs become chords: a reversal may lie in the midst of one")
    if report.uncommanded_left is not None:
        left = report.uncommanded_left
        lines.append(
            f"axes not commanded yet in the frame in force get no words: {_points(report.uncommanded)}; "
            f"largest error left {left.largest:.4f} mm at line {left.line}"
        )
    if report.kept_holes is not None:
        of = report.kept_holes
        lines.append(
            f"{of.count} holes of cycles that are kept: X and Y are those of the middle of the hole, Z and R those "
            f"of its ends; what errors differ by along a hole is left, {of.largest:.4f} mm at most at an end (line "
            f"{of.line})"
        )
    lines += [*map(offset_text, report.offsets), *map(_tool, report.tools)]
    if report.over_range:
        lines.append("above tolerance, or out of travel, at work offsets within the ranges given")
    if report.unknown_places is not None:
        lines.append(_unknown_places(report.unknown_places))
    if report.unnamed_feeds is not None:
        lines.append(_unnamed_feeds(report.unnamed_feeds))
    if report.over_places:
        lines.append(
            "above tolerance if these axes stand elsewhere: say by --start where they stand at its start; after a "
            "tool change or a stop, command them anew, or say by --pass-m that it moves none"
        )
    return lines


def offset_text(use: OffsetUse) -> str:
    """A work offset, how much it counts, and what that means for the part."""
    parts = [
        f"{axis}{value:.9g}" + (f" +/- {use.half_range[axis]:.9g}" if use.half_range[axis] else "")
        for axis, value in use.value.items()
    ]
    slopes = ", ".join(f"{10e3 * slope:.2f} um for {axis}" for axis, slope in use.slopes.items())
    rotary = " (deg)" if set(use.value) - set("XYZ") else ""
    text = (
        f"{use.system} is taken at {' '.join(parts)} in machine coordinates; if its zero is 10 mm{rotary} "
        f"elsewhere, compensated positions change by at most {slopes} (length of the vector)"
    )
    if use.change is not None:
        text += f"; within the range by at most {1e3 * use.change:.2f} um, which is added to the errors above"
    if use.leaves_travel:
        text += "; positions leave the travel at an end of the range"
    return f"{text}\n  {use.zero.sentence(use.system)}"


def _tool(use: ToolUse) -> str:
    x, y, z = (value + 0.0 for value in use.tool_point)
    return f"tool {use.number}: the point {x:.9g}, {y:.9g}, {z:.9g} of the tool frame is compensated"


def _unknown_places(of: UnknownPlaces) -> str:
    return (
        f"{of.change.count} rapids while the position of {' '.join(of.assumed)} is unknown: their words are "
        f"for {position_text(of.assumed)} (or the position before a tool change) and would differ by at most "
        f"{of.change.largest:.4f} mm (line {of.change.line}) elsewhere in the travel; it gets no word"
    )


def _unnamed_feeds(of: UnnamedFeeds) -> str:
    parts = [f"feed motions before the program commands {' '.join(of.places)}, assumed at {position_text(of.places)}"]
    if of.left is not None:
        parts.append(
            f"it gets no word, and an error of at most {of.left.largest:.4f} mm (line {of.left.line}) is left "
            "along it, which does not count, because the program does not command it"
        )
    if of.near is not None:
        parts.append(f"{NEAR:g} mm elsewhere changes the other words by at most {of.near.largest:.4f} mm")
    if of.anywhere is not None:
        parts.append(
            f"elsewhere in its travel the other words would differ by at most {of.anywhere.largest:.4f} mm (line "
            f"{of.anywhere.line}), which is added to the errors above"
        )
    return "; ".join(parts)
