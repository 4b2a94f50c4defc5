"""What the kernels of the paper's systems take and return, in the symbols of the page."""

from collections.abc import Iterator

from trueaxis.codegen.latex import Latex, joined
from trueaxis.codegen.paper_layout import Pattern, Reading, System
from trueaxis.codegen.paper_notation import Form
from trueaxis.codegen.system_section import point_name
from trueaxis.derivation.model import DerivedModel, system_name
from trueaxis.derivation.systems import IdentificationSystem, Point, RunPattern
from trueaxis.view import Carrier

HOME = {"tool": ("k", "q_T"), "workpiece": ("l", "q_w")}
"""Letter of a carriage's points, and the home of the frame that stands on the carriage."""


def kernel_lines(
    model: DerivedModel, pattern: Pattern, system: System, forms: list[Form], latex: Latex
) -> Iterator[str]:
    """A sentence per kernel of a system, in the order of the system's unknowns: readings, points, order of return."""
    assert model.identification is not None
    numbered = dict(enumerate(model.identification.systems))
    own = {k: each for k, each in numbered.items() if set(each.unknowns) <= set(system.unknowns)}
    runs = {run.name: run for run in model.runs}
    for k, each in sorted(own.items(), key=lambda item: system.unknowns.index(item[1].unknowns[0])):
        taken = [system.readings.index(_reading(runs[name])) for name in each.runs]
        readings = ", ".join(f"${reduced(system.readings[n], forms[n], latex)}$" for n in taken)
        points = ", ".join(_points(each, pattern, [runs[name] for name in each.runs]))
        unknowns = ", ".join(f"${latex.symbol(name)}$" for name in each.unknowns)
        several = " in this order" if len(each.unknowns) > 1 else ""
        yield (
            f"`{system_name(k)}` takes the displacements less those of the error-free machine, {readings}, "
            f"and the points in TCS and WCS, {points}; it returns {unknowns}{several}."
        )


def reduced(reading: Reading, form: Form, latex: Latex) -> str:
    """A displacement less that of the error-free machine: L_{1xh} - x_h."""
    return joined([f"+ {reading.latex}", *latex.terms(-form.ideal)])


def _reading(run: RunPattern) -> Reading:
    label = run.name.partition("-")[2]
    return Reading(label[0], label[1:] or run.moves[0].lower())


def _points(system: IdentificationSystem, pattern: Pattern, runs: list[RunPattern]) -> Iterator[str]:
    """`r_{k1} - q_T` with the kernel's name for it."""
    labels: dict[tuple[Carrier, Point], str] = {}
    for run in runs:
        for end in (run.target, run.reference):
            labels.setdefault(end, _reading(run).label)
    above = f"^{{{pattern.axes}}}" if len(pattern.axes) > 1 else ""
    for triple, on, at in system.points:
        letter, home = HOME[on]
        yield f"$`r{above}_{{{letter}{labels[on, at]}}} - {home}`$ (`{point_name(triple)}`)"
