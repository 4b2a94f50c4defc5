"""Numbers without a decimal point."""

from typing import Any

import numpy as np
import pytest

from tests.compensation.analytic_machine import XyzMachine
from tests.compensation.control import Bench, execute
from trueaxis.io.faults import InputError


def shifted() -> XyzMachine:
    return XyzMachine({"EXX": lambda x: 0.02 + 0.0 * x})


def test_they_are_one_fault_with_the_lines_of_all(bench: Bench) -> None:
    with pytest.raises(InputError) as error:
        bench.run("G21 G90\nG0 X0 Y0 Z0\nX100\nG1 Y50. F500\nY100\nX5.\nG3 X5. Y90. I0 J-5\n", shifted())
    assert len(error.value.faults) == 1
    told = str(error.value.faults[0])
    assert told.startswith("in.nc: lines 3, 5, 7: J X Y without a decimal point: X100 is 100 mm on some")
    assert "--integers" in error.value.faults[0].remedy
    with pytest.raises(InputError, match="line 3: Y without a decimal point"):
        bench.run("G21 G90\nG0 X0 Y0 Z0\nY100\n", shifted())
    with pytest.raises(InputError, match="Q without a decimal point: Q100 is 100 mm on some"):
        bench.run("G21 G90\nG0 X0 Y0 Z9.\nG83 X1. Y0. Z-6. R2. Q3000 F100.\n", shifted())


def test_many_of_them_are_counted_and_hide_no_other_fault(bench: Bench) -> None:
    with pytest.raises(InputError) as error:
        bench.run("G21 G90\nG0 X0. Y0. Z0.\n" + "X7\n" * 60 + "G16\n", shifted())
    first, second = map(str, error.value.faults)
    assert first.startswith(f"in.nc: lines {', '.join(map(str, range(3, 52)))} and 11 more: X without")
    assert second.startswith("in.nc: line 63: G16 gives")


def test_other_letters_without_a_point_are_a_fault(bench: Bench) -> None:
    with pytest.raises(InputError, match="I without"):
        bench.run("G0 X0. Y0. Z0.\nG3 X0. Y2. J1. I0\nG3 X0. Y0. I5 J-1.\n")
    with pytest.raises(InputError, match="without a decimal point"):
        bench.run("G0 X0. Y0. Z0.\nX100\n", dialect="fanuc")


def test_zero_feeds_and_dwells_mean_the_same_either_way(bench: Bench) -> None:
    assert bench.run("G0 X0 Y0 Z0\nG1 X1. F100\nG4 X5\nG4 P500\nN10 S1000 M3 T5\n")


@pytest.mark.parametrize(
    "how", [("integers", "mm")] + [("dialect", name) for name in ("linuxcnc", "siemens", "heidenhain")]
)
def test_whole_millimetres(bench: Bench, how: tuple[str, str]) -> None:
    known: dict[str, Any] = {how[0]: how[1]}
    assert execute(bench.run("G0 X10 Y0 Z0\nX20\n", shifted(), **known))[0] == pytest.approx([9.98, 19.98])


def test_least_increments(bench: Bench) -> None:
    text = bench.run(
        "G21 G0 X10000 Y0 Z0\nX12.5 Y20000\nG20 X10000\nG91 Y-10000\n", shifted(), integers="least-increment"
    )
    assert execute(text) == pytest.approx(
        np.array([[9.98, 0, 0], [12.48, 20, 0], [25.38, 20, 0], [25.38, -5.4, 0]]).T, abs=2e-4
    )
    assert all("." in word for line in text.decode().splitlines() for word in line.split() if word[0] in "XY")


def test_arcs_in_least_increments(bench: Bench) -> None:
    dotted = bench.run("G0 X10. Y0 Z0\nG3 X0. Y10. I-10. F9\nX-10. Y0. R10.\n", chord_tolerance=0.01)
    program = "G0 X10000 Y0 Z0\nG3 X0 Y10000 I-10000 F9\nX-10000 Y0 R10000\n"
    whole = bench.run(program, chord_tolerance=0.01, integers="least-increment")
    assert execute(dotted)[:, 1:] == pytest.approx(execute(whole)[:, 1:])
