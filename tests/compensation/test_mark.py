"""The mark of a compensated program, and its refusal."""

from pathlib import Path

import pytest

from tests.compensation.control import Bench
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.settings import Settings
from trueaxis.io.faults import InputError

MARK = b"(TRUEAXIS COMPENSATED)"


def written(bench: Bench, program: bytes, name: str = "in.nc", **settings: object) -> bytes:
    from tests.compensation.analytic_machine import XyzMachine

    path = bench.out.parent / name
    path.write_bytes(program)
    compensate_file(path, bench.out, XyzMachine(), Settings(**settings), name=name)  # type: ignore[arg-type]
    return bench.out.read_bytes()


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (b"", b"G0 X1. Y1. Z1.\n"),
        (b"%\n", b"G0 X1. Y1. Z1.\n%\n"),
        (b"%\r\nO1234 (PART)\r\n", b"(SIZE)\r\nG0 X1. Y1. Z1.\r\n"),
        (b"\r\n%PART\r\n:7\r\n\r\n", b"G0 X1. Y1. Z1."),
        (b"\xef\xbb\xbf", b"G0 X1. Y1. Z1.\n"),
        (b"\xef\xbb\xbf%\n", b"N10 G0 X1. Y1. Z1.\n"),
    ],
)
def test_it_stands_after_what_must_be_first(bench: Bench, before: bytes, after: bytes) -> None:
    eol = b"\r\n" if b"\r\n" in before else b"\n"
    text = written(bench, before + after)
    assert text == before + MARK + eol + after
    assert text.count(MARK) == 1


@pytest.mark.parametrize(
    ("name", "program", "settings"),
    [
        ("a.mpf", b"%_N_A_MPF\n;$PATH=/_N_WKS_DIR\nG0 X1. Y1. Z1.\n", {}),
        ("a.mpf", b"%_N_A_MPF\nG0 X1. Y1. Z1.\n", {}),
        ("a.nc", b"%_N_A_MPF\nG0 X1. Y1. Z1.\n", {"dialect": "siemens"}),
        ("a.nc", b"G0 X1. Y1. Z1. ; go\n", {}),
    ],
)
def test_it_is_a_comment_of_the_programs_own_kind(
    bench: Bench, name: str, program: bytes, settings: dict[str, object]
) -> None:
    lines = written(bench, program, name, **settings).splitlines()
    assert lines[-2] == b"; TRUEAXIS COMPENSATED"
    assert b"\n".join(lines[:-2] + lines[-1:]) + b"\n" == program


def test_a_marked_program_is_refused(bench: Bench) -> None:
    for first in (b"%\nO1\nG0 X1. Y1. Z1.\n", b"%\nG0 X1. Y1. Z1. ; go\n"):
        with pytest.raises(InputError) as error:
            written(bench, written(bench, first), "again.nc")
        (fault,) = error.value.faults
        assert fault.place in {"line 2", "line 3"}
        assert "compensated already" in fault.problem
        assert fault.remedy == "compensate the original program"


def test_a_marked_cutter_location_file_is_refused_and_its_program_marked(bench: Bench, tmp_path: Path) -> None:
    source = b"FROM/0,0,0\nFEDRAT/100\nGOTO/1,0,0\nFINI\n"
    text = written(bench, source, "a.cls")
    assert text.startswith(b"%\n" + MARK + b"\nG21 ")
    with pytest.raises(InputError, match="line 1: this program is compensated already"):
        written(bench, b"$$ (TRUEAXIS COMPENSATED)\n" + source, "b.cls")


@pytest.mark.parametrize("mark", [b"(trueaxis compensated)", b"; Trueaxis Compensated", b"G21 (TrueAxis COMPENSATED)"])
def test_the_mark_is_known_in_any_case(bench: Bench, mark: bytes) -> None:
    """An editor or a control may have changed the case of comments."""
    with pytest.raises(InputError, match="line 2: this program is compensated already"):
        written(bench, b"%\n" + mark + b"\nG0 X1. Y1. Z1.\n")
    with pytest.raises(InputError, match="line 1: this program is compensated already"):
        written(bench, b"$$ " + mark + b"\nFROM/0,0,0\nGOTO/1,0,0\nFINI\n", "b.cls")
