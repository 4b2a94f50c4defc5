"""What a report says under tool centre point control: where the axes stand, and that it is not known."""

import re
from pathlib import Path

import numpy as np
import pytest

from tests.compensation.five_axes import TEXTS, FiveAxes
from tests.compensation.test_point_control import AXES, CASES, LENGTH, Narrow, axes_at, program_of, run, tips
from trueaxis.io.faults import InputError
from trueaxis.reporting.compensation import compensation_text


@pytest.mark.parametrize(("dialect", "name", "rotary"), CASES)
def test_the_control_shows_whether_its_kinematics_are_those_of_the_spec(
    tmp_path: Path, dialect: str, name: str, rotary: str
) -> None:
    machine = FiveAxes(TEXTS[name])
    report, _ = run(tmp_path, source := program_of(dialect, rotary), machine, dialect)
    check = report.kinematics_check
    assert check is not None
    places = [axes_at(machine, tip) for _, tip in tips(source, rotary, machine)]
    shown = [check.position[axis] for axis in AXES + rotary]
    assert min(np.abs(place - shown).max() for place in places) < 1e-6
    assert check.turned > 5.0
    assert f"at the end of line {check.line}, under tool centre point control" in compensation_text(report)
    no_turn = re.sub(rf"([{rotary}])-?[\d.]+", r"\g<1>0.", source.replace("TOOL CALL", "TOOL_CALL"))
    report, _ = run(tmp_path, no_turn.replace("TOOL_CALL", "TOOL CALL"), machine, dialect)
    assert report.kinematics_check is None


def test_travel_is_not_judged_where_the_axes_may_stand_anywhere(tmp_path: Path) -> None:
    """A rapid of X and Y before Z is known was out of travel at the place that Z was taken to stand at."""
    machine = FiveAxes(TEXTS["table-table"])
    source = (
        "G71 G90 G94\nT1 M6\nD1\nG0 A30 C40\nTRAORI\nG0 X{} Y20\nG0 Z60\nG1 X25 Y10 Z50 F500\nTRAFOOF\nM30\n"
    ).format
    narrow = Narrow(machine.model, dict(machine.model.travel))
    known = {row: axes_at(machine, np.array([20.0, 20.0, z + LENGTH, 30.0, 40.0]))[1] for row, z in enumerate((0, 60))}
    middle = 0.5 * (known[0] + known[1])
    limits = (middle, 1e4) if known[1] > known[0] else (-1e4, middle)
    narrow.travel |= {"X": (-1e4, 1e4), "Y": limits, "Z": (-1e4, 1e4)}
    report, written = run(tmp_path, source(20), narrow, "siemens")
    assert not report.out_of_travel.points
    assert report.warnings[-1].startswith("line 6: where Z stands is not known, and with rotary axes turned")
    wide = Narrow(machine.model, dict.fromkeys(machine.model.axes, (-1e4, 1e4)))
    assert run(tmp_path, source(20), wide, "siemens")[1] == written  # and no word is taken to the end of a travel
    with pytest.raises(InputError, match=r"line 7: Y = .* is outside its travel"):
        run(tmp_path, source(20).replace("Z60", "Z-20"), narrow, "siemens")
    with pytest.raises(InputError, match="line 4: C = 400 is outside its travel"):
        run(tmp_path, source(20).replace("C40", "C400"), Narrow(machine.model, wide.travel | {"C": (-360.0, 360.0)}),
            "siemens")  # fmt: skip
