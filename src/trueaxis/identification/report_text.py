"""The identification report as a person reads it, and as JSON."""

import json
import math
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from trueaxis.identification.error_lines import by_usual_sizes, component_line, location_line, small_size, with_u
from trueaxis.identification.fit_quality import LACKING, MISFIT, MOST_RUNS, UNUSUAL, FitQuality, RunResidual
from trueaxis.identification.report import (
    BlockReport,
    CurveOrderReport,
    EffectParameterReport,
    EffectReport,
    IdentificationReport,
    InstrumentReport,
)
from trueaxis.identification.words import IN_COMBINATION, RULE, combination_text, enumerated, in_small, tool_sentence

WIDTH = 100
WORST = 5  # runs with a line of their own


def report_text(report: IdentificationReport) -> str:
    """Lines of text, ending with a newline."""
    lines = [
        f"{report.machine}: method {report.method}, {report.readings} readings, {report.iterations} iterations on the "
        f"exact model (last change {report.last_change:.1g} mm)",
        _residuals(report),
        f"squareness: {report.squareness}",
        *_wrapped(fit_text(report.quality), "fit:"),
    ]
    for caveat in report.caveats:
        lines[1:1] = _wrapped(caveat, "NOTE: ")
    lines += runs_table(report.quality.runs)
    if report.noise_groups:
        said = (f"{group.group} {group.noise_um:.4g} {group.unit}" for group in report.noise_groups)
        lines += _wrapped(", ".join(said), "noise by group:")
    if report.left_out:
        lines.append(f"left out (this method uses only laser and probe runs): {', '.join(report.left_out)}")
    if report.noise_um is None:
        lines.append("no standard uncertainties: the noise is unknown (state it with --noise-um)")
    if report.blocks:
        lines += ["", "solved, in this order:"]
    lines += [line for number, block in enumerate(report.blocks, 1) for line in _block(number, block)]
    if report.locations:
        lines += ["", "location errors:"]
        usual = {} if report.usual is None else {one.name: one for one in report.usual.errors}
        lines += [f"{location_line(one)}{by_usual_sizes(usual.get(one.name))}" for one in report.locations]
    lines += _components(report)
    if report.effects:
        lines += ["", "effects (U: expanded uncertainty, k = 2):"]
        lines += [line for one in report.effects for line in _effect(one)]
    if report.instruments:
        lines += ["", "unknowns of the instruments:"]
        lines += [line for one in report.instruments for line in _instrument(one)]
    if report.curve_orders:
        lines += ["", "powers of the polynomials, and rms at held-out positions:"]
        lines += [_curve_order(one) for one in report.curve_orders]
    lines += ["", "undetermined:" if report.undetermined else "undetermined: nothing"]
    for item in report.undetermined:
        lines += _wrapped(item.combination, "- ")
    lines += _known_of_tool(report)
    for note in report.notes:
        lines += _wrapped(note, "note: ")
    return "\n".join(lines) + "\n"


def _components(report: IdentificationReport) -> list[str]:
    """Lines on the motion errors, with the rule by which they are said to be determined."""
    if report.blocks:
        over = "error motions over the measured positions:"
    elif report.tool is None:
        over = "error motions over the travel: largest value, where, its u; largest u:"
    else:
        over = "error motions over the travel: largest value, where, its u; largest u (RMS of its parts):"
    lines = ["", over, *(component_line(component) for component in report.components)]
    if any(one.prior_rms is not None for one in report.components):
        lines += _wrapped(RULE, "  ")
    return lines


def _residuals(report: IdentificationReport) -> str:
    """Root mean squares of residuals and noise: of lengths, and of angles where there are such."""
    rms, noise = [], ["unknown"] if report.noise_um is None else []
    for unit, of_residuals, of_noise in (
        ("um", report.residual_rms_um, report.noise_um),
        ("urad", report.residual_rms_urad, report.noise_urad),
    ):
        if of_residuals is not None and math.isfinite(of_residuals):
            rms.append(f"{of_residuals:.4g} {unit}")
        if of_noise is not None and math.isfinite(of_noise):
            noise.append(f"{of_noise:.4g} {unit}")
    return f"residuals: rms {', '.join(rms)}; noise of a reading: {', '.join(noise)} ({report.noise_origin})"


def _known_of_tool(report: IdentificationReport) -> list[str]:
    """The uncertainty of the tool point, and which errors are known as a sum alone."""
    lines: list[str] = []
    if report.tool is not None:
        lines += ["", *_wrapped(tool_sentence(report.tool), "tool point:")]
    if report.combinations:
        lines += ["", f"{IN_COMBINATION}:"]
        for combination in report.combinations:
            lines += _wrapped(combination_text(combination), "- ")
    return lines


def report_json(report: IdentificationReport) -> str:
    """The same as JSON; NaN is null; combinations carry their text."""
    tree = _plain({"schema": 1, **asdict(report)})
    for one, combination in zip(tree["combinations"], report.combinations, strict=True):
        one["text"] = combination_text(combination)
    return json.dumps(tree, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def fit_text(judged: FitQuality) -> str:
    """How the fit ended, in a sentence."""
    chi2 = "" if judged.fit.chi2 is None else f"chi-square per degree of freedom {judged.fit.chi2:.3g}"
    if judged.fit.state == "misfit":
        return f"MISFIT, {judged.reason}{', ' if chi2 else ''}{chi2}; worst: {runs_text(judged.runs)}"
    if judged.fit.chi2 is None and not judged.fit.unjudged:
        return "converged; there are as many unknowns as readings, which leaves no residuals to judge by"
    if judged.fit.chi2 is None:
        return (
            "converged; the residuals could not be judged: no noise is stated (--noise-um), and too little is repeated"
        )
    if judged.fit.unjudged:
        names = enumerated(judged.fit.unjudged)
        chi2 += (
            f"; the residuals of {names} could not be judged: no noise is stated for it (--noise-um), and too little "
            "is repeated"
        )
    ratio = math.sqrt(judged.fit.chi2)
    if ratio <= LACKING:
        return f"converged, {chi2}"
    return (
        f"converged, {chi2}: the residuals are {ratio:.2g} times the noise. The model lacks something that these "
        "readings show, by at most three times the noise or 1 % of what [prior] expects of them; u, which follows from "
        "the noise, is too small; diagnose tells more"
    )


def runs_text(runs: Sequence[RunResidual]) -> str:
    """The worst runs with the rms of their residuals: `X1 12 um (40 times the noise)`, and how many more misfit."""
    said = [
        f"{one.run} {one.rms_um:.4g} {one.unit}" + ("" if one.ratio is None else f" ({one.ratio:.3g} times the noise)")
        for one in runs[:MOST_RUNS]
        if one.ratio is None or one.ratio > MISFIT or one is runs[0]
    ]
    more = sum(one.ratio is not None and one.ratio > MISFIT for one in runs[MOST_RUNS:])
    return ", ".join([*said, f"and {more} more"] if more else said)


def _curve_order(one: CurveOrderReport) -> str:
    sides = [
        f"{how} {' '.join(map(str, powers)) or 'none'}: {value:.4g} {unit}"
        for how, powers, off in (
            ("paper", one.by_paper, one.held_out_by_paper),
            ("held-out", one.by_held_out, one.held_out),
        )
        for value, unit in [small_size(off, one.unit)]
    ]
    return f"  {one.name}  {sides[0]:<36} {sides[1]}"


def _instrument(one: InstrumentReport) -> list[str]:
    value, unit = small_size(one.value, one.unit)
    return _wrapped(f"{one.name}: {value:+.4g} {unit} {with_u(one.u, one.unit).strip()} {one.origin}", "  ")


def _effect(one: EffectReport) -> list[str]:
    told = "; ".join(_effect_parameter(parameter) for parameter in one.parameters)
    return _wrapped(f"{one.effect}: {told}; {one.origin}", "  ")


def _effect_parameter(one: EffectParameterReport) -> str:
    """Sizes in micrometres or microradians, periods, times and phases as they are."""
    factor, unit = in_small(one.unit) if one.role in ("linear", "root") else (1.0, one.unit)
    unit = "" if unit == "1" else unit
    told = f"{one.name} {factor * one.value:.5g} {unit}".rstrip()
    return told if one.u is None else f"{told}, U {2.0 * factor * one.u:.2g} {unit}".rstrip()


def _block(number: int, block: BlockReport) -> list[str]:
    solved = f"rank {block.rank}" if block.rank == block.unknowns else f"RANK {block.rank} OF {block.unknowns}"
    head = f"{number}. {' '.join(block.runs)} -> {' '.join(block.components)}: "
    head += f"{block.equations} equations, {block.unknowns} unknowns, {solved}, condition {block.condition:.3g}"
    return _wrapped(head + (f"; {block.remark}" if block.remark else ""), "  ")


def _wrapped(text: str, lead: str) -> list[str]:
    lines, current = [], lead
    for word in text.split():
        if len(current) + len(word) + 1 > WIDTH and current.strip():
            lines.append(current)
            current = " " * (len(lead) + 1)
        current += word if current.endswith(" ") else f" {word}"
    return [*lines, current]


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        urad = value.get("unit") == "urad"
        return {
            f"{key.removesuffix('_um')}_urad" if urad and key.endswith("_um") else key: _plain(item)
            for key, item in value.items()
        }
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def runs_table(runs: Sequence[RunResidual]) -> list[str]:
    """runs: worst first. Without noise their residuals alone."""
    if not runs:
        return []
    width = max(len("run"), *(len(one.run) for one in runs[:WORST]))
    known = any(one.ratio is not None for one in runs)
    mixed = any(one.unit == "urad" for one in runs)  # angles among them: the unit has a column
    head = f"  {'run':<{width}}  readings  {'unit     RMS' if mixed else 'RMS um'}"
    if known:
        head += f"  {'   noise' if mixed else 'noise um'}  ratio  by noise up to"
    lines = ["residuals by run, worst first:", head]
    for one in runs[:WORST]:
        unit = f"{one.unit:<4}  " if mixed else ""
        line = f"  {one.run:<{width}}  {one.readings:>8}  {unit}{one.rms_um:>6.3g}"
        if one.ratio is not None:
            noise = one.rms_um / one.ratio if one.ratio > 0.0 else 0.0
            line += f"  {noise:>8.3g}  {one.ratio:>5.3g}  {one.most:>14.3g}{'  unusual' if one.unusual else ''}"
        lines.append(line)
    rest = runs[WORST:]
    if rest and known:
        many = sum(one.unusual for one in rest)
        within = "all within the noise" if not many else f"{many} of them unusual"
        lines.append(f"  and {len(rest)} more, {within}")
    elif rest:
        lines.append(f"  and {len(rest)} more")
    if known:
        lines.append(f"  (by noise up to: the largest ratio of all runs in {1.0 - UNUSUAL:.0%} of data sets)")
    return lines
