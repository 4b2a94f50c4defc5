"""Files that cannot be read are faults of the input, told together with those of other files."""

from pathlib import Path

import pytest

from trueaxis.io.faults import Fault, InputError
from trueaxis.io.input_files import gathering, input_bytes, utf8_text


def test_a_file_that_cannot_be_read_is_named_with_the_reason(tmp_path: Path) -> None:
    found: list[Fault] = []
    for path in (tmp_path / "none", tmp_path, Path("a\0b"), tmp_path / "a" / ("x" * 300)):
        with gathering(found):
            input_bytes(path)
    assert [fault.problem.split(":")[0] for fault in found[:3]] == [
        "there is no such file",
        "is a folder",
        "is not a file name",
    ]
    assert found[3].problem
    assert found[0].file == str(tmp_path / "none")


def test_gathering_lets_other_exceptions_pass() -> None:
    with pytest.raises(ZeroDivisionError), gathering([]):
        raise ZeroDivisionError


def test_text_is_utf8_with_or_without_a_mark() -> None:
    assert utf8_text(Path("f"), "\ufeffµm".encode()) == utf8_text(Path("f"), "µm".encode()) == "µm"
    with pytest.raises(InputError, match="f: line 3: byte 0xb5 is not UTF-8; save the file as UTF-8"):
        utf8_text(Path("f"), b"a\nb\n\xb5m")
