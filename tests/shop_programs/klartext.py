"""Grades programs of Heidenhain Klartext: run by the control of `tests/compensation`, on a machine of matrices."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np

from tests.compensation.klartext_control import KlartextControl
from tests.compensation.path_distance import apart, sampled
from tests.shop_programs.grade import LENGTHS, OFFSETS, SPACING, TOLERANCE, Grade, machine, settings_of
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.tools import Tool, ToolTable
from trueaxis.io.faults import InputError

KIND = "Klartext"
_MOTION = re.compile(r"(?im)^[ \t]*(?:\d+[ \t]+)?(?:L|C|CR|CP|LP)[ \t]+[^;\n]*[XYZ][-+Q\d]")

_TOOL = re.compile(r"TOOL DEF\s+(\d+)\s+L\s*([-+]?[\d.]+)")


def is_program(path: Path) -> bool:
    """Whether a file begins as such programs do."""
    return path.is_file() and b"BEGIN PGM" in path.read_bytes()[:2000]


def grade(program: Path, out: Path) -> Grade:
    """Grade one program; what is written goes to `out`."""
    name, text = program.name, program.read_bytes().decode("latin-1")
    if not _MOTION.search(text):
        return Grade(name, "no motion")
    lengths = LENGTHS | {int(tool): float(length) for tool, length in _TOOL.findall(text)}
    tools = ToolTable({tool: Tool(length=length) for tool, length in lengths.items()})
    made, settings = machine(), replace(settings_of(text), dialect="heidenhain", tools=tools)
    try:
        report = compensate_file(program, out, made, settings, language="nc")
    except InputError as error:
        return Grade(name, KIND, "refused", error.faults[0].problem)
    if not report.good:
        return Grade(name, KIND, "refused", "exit code 1: an error above the tolerance is left, and reported")
    meant, done = (
        KlartextControl([0.0, 0.0, 0.0], OFFSETS[0], lengths).run(one)
        for one in (text, out.read_bytes().decode("latin-1"))
    )
    if len(meant.runs) != len(done.runs) or len(meant.rapids) != len(done.rapids):
        return Grade(name, KIND, "wrong", "other runs of feed")
    before = after = 0.0
    for a, b, tip in zip(meant.paths(), done.paths(), meant.tips, strict=True):
        point = np.array([[0.0], [0.0], [-tip]])
        path, now = sampled(a, SPACING), sampled(b, SPACING)
        ideal = made.ideal(path, point)
        before = max(before, apart(made.actual(path, point), ideal))
        after = max(after, apart(made.actual(now, point), ideal))
    return Grade(name, KIND, "accepted" if after < TOLERANCE else "wrong", "", before, after, (report.moves, 0))
