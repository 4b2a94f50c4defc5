"""What is written to standard output and error is safe to show; what cannot be delivered is told by the exit code."""

import os
import subprocess
import sys
from io import StringIO
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.command_lines import COMMANDS, command_line, run, words_of
from trueaxis.cli.main import main
from trueaxis.io.faults import Fault
from trueaxis.io.safe_text import LONGEST, escaped, shown
from trueaxis.io.told import NOT_DELIVERED, Told

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="streams are closed by a POSIX shell")


@given(st.text(st.characters(codec=None), max_size=50))
def test_only_printable_characters_are_shown(text: str) -> None:
    told = shown(text)
    assert told.isprintable()
    told.encode()  # raises where a lone surrogate is left
    if text.isprintable():
        assert told == text


def test_ordinary_text_of_the_world_is_left_as_it_is() -> None:
    for text in ("µm ± 3°, Werkstück", "工作機械", "станок", "Ångström naïve", "e\u0301"):
        assert shown(text) == text


def test_what_steers_a_terminal_is_named() -> None:
    assert shown("a\x1b[2Jb\r\n\x07\u202e\u2066\u200b\ufeff\x9b\x7f") == (
        "a\\x1b[2Jb\\r\\n\\x07\\u202e\\u2066\\u200b\\ufeff\\x9b\\x7f"
    )
    assert shown("a\udcffb") == "a\\xffb"
    assert escaped("a\tb\nc\x1b", "\n\t") == "a\tb\nc\\x1b"


def test_a_long_part_shows_its_ends() -> None:
    fault = str(Fault("f" * 10**6, "start" + "p" * 10**6 + "end", "'" + "x" * 10**6 + "' is not a number", "a number"))
    assert len(fault) < 4 * (LONGEST + 100)
    assert "startppp" in fault
    assert "pppend" in fault
    assert fault.endswith("xxx' is not a number; a number")
    assert f"{10**6 + 8 - LONGEST} more characters" in fault


def test_a_fault_is_one_line_whatever_is_in_it() -> None:
    assert str(Fault("a\nb", "key\r", "is\u2028wrong", "\x00")) == "a\\nb: key\\r: is\\u2028wrong; \\x00"


def test_wrong_usage_is_safe_to_show(capsys: pytest.CaptureFixture[str]) -> None:
    for value in ("x" * 10**6, "\x1b[2J\n", "a\udcff"):
        with pytest.raises(SystemExit) as stop:
            main(["demo", "--seed", value])
        assert stop.value.code == 2
        told = capsys.readouterr().err
        assert len(told) < 2000
        assert "\x1b" not in told
        assert told.endswith("\n")


def test_names_in_reports_cannot_steer_the_terminal(
    prepared: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(prepared)
    assert main(COMMANDS["evaluate"].format(out=f"{tmp_path}/\x1b[31m").split()) == 0
    told = capsys.readouterr().out
    assert "\x1b" not in told
    assert "\\x1b[31m" in told


def test_a_stream_that_cannot_encode_gets_escapes() -> None:
    class Ascii(StringIO):
        encoding = "ascii"

    stream = Ascii()
    Told(stream).write("µm\n")
    assert stream.getvalue() == "\\xb5m\n"


def shell(prepared: Path, words: str, redirection: str) -> "subprocess.CompletedProcess[str]":
    line = subprocess.list2cmdline(["exec", *command_line(words)[:3]])
    code = command_line(words)[3].replace(";", "\n").replace("\n ", "\n")
    command = f'{line} "$PROGRAM" {" ".join(command_line(words)[4:])} {redirection}'
    environment = os.environ | {"PROGRAM": code}
    done = subprocess.run(["sh", "-c", command], cwd=prepared, env=environment, capture_output=True, check=False)
    return subprocess.CompletedProcess(command, done.returncode, done.stdout.decode(), done.stderr.decode())


REDIRECTIONS = {  # of a shell -> exit code, what is told
    ">&-": (NOT_DELIVERED, "standard output: Bad file descriptor"),
    "2>&-": (0, ""),
    "<&- 2>&-": (0, ""),
    ">&- 2>&-": (NOT_DELIVERED, ""),
    ">&- 2>&- <&-": (NOT_DELIVERED, ""),
    ">/dev/full": (NOT_DELIVERED, "standard output: No space left on device"),
    "2>/dev/full": (0, ""),
    ">/dev/full 2>/dev/full": (NOT_DELIVERED, ""),
}
# `derive` writes and tells as `evaluate` does; beside that it loads SymPy and Jinja2, with numbers free or without
CASES = [(name, one) for name in ("evaluate", "compensate") for one in REDIRECTIONS]
CASES += [("derive", one) for one in (">&-", ">&- 2>&- <&-", ">/dev/full")]


@pytest.mark.parametrize(("name", "redirection"), CASES)
def test_files_are_written_and_the_code_says_whether_the_text_was(
    prepared: Path, tmp_path: Path, name: str, redirection: str
) -> None:
    code, told = REDIRECTIONS[redirection]
    expected = {"evaluate": ["t.json", "t.png"], "compensate": ["c.json", "c.nc"], "derive": ["generated"]}
    done = shell(prepared, COMMANDS[name].format(out=tmp_path), redirection)
    assert done.returncode == code, done.stderr
    assert told in done.stderr
    assert "Traceback" not in done.stderr + done.stdout
    assert "Exception ignored" not in done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == expected[name]
    if name == "compensate":  # no text of ours got into an output that took the number of a closed stream
        assert (tmp_path / "c.nc").read_text().startswith("(TRUEAXIS COMPENSATED)\nG90")


@pytest.mark.parametrize("redirection", ["2>&-", ">&- 2>&-", "2>/dev/full", ">/dev/full 2>/dev/full"])
def test_wrong_input_is_2_though_nobody_hears_it(prepared: Path, tmp_path: Path, redirection: str) -> None:
    done = shell(prepared, f"predict none.toml --errors e.json --at p.csv --out {tmp_path}/p.csv", redirection)
    assert (done.returncode, done.stdout, list(tmp_path.iterdir())) == (2, "", [])


def test_a_reader_that_stops_early_changes_no_answer(prepared: Path, tmp_path: Path) -> None:
    """`derive --check` of another machine writes more than a pipe holds and answers 1."""
    assert run(prepared, COMMANDS["derive"].format(out=tmp_path)).returncode == 0
    for path in (tmp_path / "generated" / "small").iterdir():
        path.write_text(("other " * 200 + "\n") * 100)
    words = f"{COMMANDS['derive'].format(out=tmp_path)} --check"
    with subprocess.Popen(command_line(words), cwd=prepared, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.readline()
        process.stdout.close()
        assert process.stderr.read() == b""
        assert process.wait() == 1


@pytest.mark.parametrize(
    ("variable", "value", "told"),
    [
        ("CC", "'x", "environment variable CC: 'x cannot be split into words: No closing quotation"),
        ("TRUEAXIS_BACKEND", "gpu", "environment variable TRUEAXIS_BACKEND: gpu is no backend; one of auto, c, numpy"),
        ("TRUEAXIS_CACHE", "relative", "environment variable TRUEAXIS_CACHE: relative is not an absolute path"),
        ("TRUEAXIS_CACHE", "/dev/null", "environment variable TRUEAXIS_CACHE: /dev/null is not a folder"),
    ],
)
def test_wrong_variables_are_named(
    prepared: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
    variable: str, value: str, told: str,
) -> None:  # fmt: skip
    monkeypatch.chdir(prepared)
    monkeypatch.setenv(variable, value)
    assert main(words_of(COMMANDS["predict"].format(out=tmp_path).split())) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"trueaxis: {told}")
    assert list(tmp_path.iterdir()) == []
