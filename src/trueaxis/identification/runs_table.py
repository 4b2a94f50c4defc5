"""The runs whose residuals are largest beside their noise, as lines of text."""

from collections.abc import Sequence

from trueaxis.identification.fit_quality import UNUSUAL, RunResidual

WORST = 5  # runs with a line of their own


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
        within = "all within what noise gives" if not many else f"{many} of them unusual"
        lines.append(f"  and {len(rest)} more, {within}")
    elif rest:
        lines.append(f"  and {len(rest)} more")
    if known:
        lines.append(f"  (by noise up to: the largest ratio of all runs in {1.0 - UNUSUAL:.0%} of data sets)")
    return lines
