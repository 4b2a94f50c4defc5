"""M codes: a code passes by itself only if it means the same on every control."""

import json

import pytest

from tests.compensation.analytic_machine import XyzMachine
from tests.compensation.control import Bench
from trueaxis.compensation.nc import m_codes
from trueaxis.io.faults import InputError

HEAD = "G21 G90 G17\nG0 X100. Y100. Z100.\n"


def test_modes_that_another_code_restores(bench: Bench) -> None:
    """On a control where M70 and M72 save and restore modes, the last block is absolute: X110, 100 mm away."""
    program = f"{HEAD}M70\nG91\nG1 X5. F1000\nM72\nG1 X110.\nM2\n"
    machine = XyzMachine({"EYX": lambda x: 1e-5 * x})
    with pytest.raises(InputError) as error:
        bench.run(program, machine)
    assert [fault.place for fault in error.value.faults] == ["line 3", "line 6"]
    assert "linuxcnc: saves or restores modes" in error.value.faults[0].problem
    assert "--pass-m 70 " in error.value.faults[0].remedy
    with pytest.raises(InputError, match="--pass-m does not pass it"):
        bench.run(program, machine, pass_m=(70, 72), dialect="linuxcnc")


@pytest.mark.parametrize("code", [10, 11, 13, 19, 21, 29, 48, 60, 73, 100, 123, 429, 1000])
def test_a_code_that_is_the_builders_needs_the_users_word(bench: Bench, code: int) -> None:
    program = f"{HEAD}M{code}\nG1 X5. F100\n"
    with pytest.raises(InputError, match=f"line 3: M{code} .*--pass-m {code} ") as error:
        bench.run(program)
    assert len(error.value.faults) == 1
    assert bench.run(program, pass_m=(code,)) == program.encode()


@pytest.mark.parametrize("code", sorted(m_codes.KNOWN.keys() - m_codes.END))
def test_what_means_the_same_everywhere_passes(bench: Bench, code: int) -> None:
    program = f"{HEAD}M{code}\nG1 X5. F100\n"
    assert bench.run(program) == program.encode()
    assert bench.report.passed == ()


@pytest.mark.parametrize("code", sorted(m_codes.HARMFUL))
def test_what_moves_axes_is_not_passed_whoever_vouches(bench: Bench, code: int) -> None:
    with pytest.raises(InputError, match=f"line 3: M{code} .*--pass-m does not pass it"):
        bench.run(f"{HEAD}M{code}\nG1 X5.\n", pass_m=(code,))


def test_passed_codes_are_reported_with_their_lines(bench: Bench) -> None:
    bench.run(f"{HEAD}M110\nM70\nX5. M110\n", pass_m=(70, 110, 9000))
    assert [(one.code, one.lines.points, one.lines.first) for one in bench.report.passed] == [
        (70, 1, (4,)),
        (110, 2, (3, 5)),
    ]
    assert "M110 passed" in bench.told
    assert "2 times, lines 3, 5" in bench.told
    found = json.loads(bench.report.to_json())
    assert found["passed"][1] == {"code": 110, "lines": {"points": 2, "first": [3, 5]}}
    assert found["settings"]["pass_m"] == [70, 110, 9000]


def test_a_code_of_unknown_timing_is_in_no_block_that_is_cut(bench: Bench) -> None:
    wave = XyzMachine({"EXX": lambda x: 1e-7 * x * x})
    for block in ("G3 X120. I10. F9 M110", "G1 X900. F9 M110"):
        with pytest.raises(InputError, match=r"line 3: the block becomes \d+ blocks, and whether M110 acts before"):
            bench.run(f"{HEAD}{block}\n", wave, pass_m=(110,))
    assert b"F9 M110" in bench.run(f"{HEAD}G1 X105. F9 M110\n", wave, pass_m=(110,))


def test_a_cutter_location_file_knows_the_same_codes(bench: Bench) -> None:
    program = "FROM/0,0,0\nFEDRAT/100\nGOTO/1,0,0\nAUXFUN/110\nGOTO/2,0,0\nFINI\n"
    with pytest.raises(InputError, match=r"line 4: M110 .*--pass-m 110"):
        bench.run(program, language="apt")
    assert b"\nM110\n" in bench.run(program, language="apt", pass_m=(110,))
    assert bench.report.passed[0].lines.first == (4,)
    with pytest.raises(InputError, match="line 4: M98 calls"):
        bench.run(program.replace("110", "98"), language="apt", pass_m=(98,))


@pytest.mark.parametrize("block", ["G187 P3", "N20 G187 P3. E.01", "G103", "G5.9 R2"])
def test_a_g_code_of_the_builder_passes_where_the_user_says_so(bench: Bench, block: str) -> None:
    program = f"{HEAD}{block}\nG1 X105. F100\n"
    code = block.removeprefix("N20 ").split()[0].removeprefix("G")
    with pytest.raises(InputError, match=f"line 3: G{code} is not a known code; say --pass-g {code} if") as error:
        bench.run(program)
    assert len(error.value.faults) == 1  # its P and E are no faults of their own
    assert bench.run(program, pass_g=(float(code),)) == program.encode()
    assert f"line 3: G{code} passes as --pass-g says" in bench.told


@pytest.mark.parametrize("block", ["G187 X5.", "G187 G1", "G187 M8", "G187 F100", "G187 I1."])
def test_it_passes_in_a_block_of_its_own(bench: Bench, block: str) -> None:
    with pytest.raises(InputError, match="line 3: G187, which --pass-g names, beside axis words or other codes"):
        bench.run(f"{HEAD}{block}\n", pass_g=(187.0,))


def test_what_moves_axes_is_no_g_code_to_pass(bench: Bench) -> None:
    with pytest.raises(InputError, match="line 3: G68 turns the coordinates"):
        bench.run(f"{HEAD}G68 X0. Y0. R30.\n", pass_g=(68.0,))
