"""-v, -q and completion: what is said on standard error, before and behind a command; the report stays the same."""

import logging
import subprocess
import sys
import types
from pathlib import Path

import pytest

from tests.machines import DMU60P, ROOT
from trueaxis.cli.main import build_parser, main
from trueaxis.cli.progress import progress

ERRORS = ROOT / "machines" / "dmu60p_errors.json"


def predicted(folder: Path, *words: str, behind: bool) -> subprocess.CompletedProcess[str]:
    """`predict` in a process of its own, on kernels that no compiler can be found for: a warning."""
    (folder / "points.csv").write_text("X,Y,Z\n1,2,3\n")
    command = ["predict", str(DMU60P), "--errors", str(ERRORS), "--at", "points.csv", "--out", "out.csv"]
    command += ["--kernels", str(ROOT / "generated")]
    whole = [*command, *words] if behind else [*words, *command]
    environment = {"PYTHONPATH": str(ROOT / "src"), "PATH": str(folder), "HOME": str(folder)}
    environment |= {"XDG_CACHE_HOME": str(folder)}
    return subprocess.run(
        [sys.executable, "-m", "trueaxis", *whole],
        capture_output=True,
        text=True,
        cwd=folder,
        env=environment,
        check=True,
    )


@pytest.mark.parametrize("behind", [False, True])
def test_what_is_said(tmp_path: Path, behind: bool) -> None:
    plain = predicted(tmp_path, behind=behind)
    loud = predicted(tmp_path, "-v", behind=behind)
    quiet = predicted(tmp_path, "--quiet", behind=behind)
    assert plain.stdout == loud.stdout == quiet.stdout == "out.csv: 1 points\n"
    assert plain.stderr.startswith("trueaxis: running on NumPy, about ten times slower than C")
    assert quiet.stderr == ""
    said = loud.stderr.splitlines()
    assert f"trueaxis: reading {ERRORS}" in said
    assert said[-1] == "trueaxis: written: out.csv"


def test_faults_are_told_whatever_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["-q", "derive", "no_such.toml"]) == 2
    assert capsys.readouterr().err == "trueaxis: no_such.toml: there is no such file\n"


def test_a_command_imports_no_other_for_it() -> None:
    code = (
        "import sys; from trueaxis.cli.main import main; main(['-q', 'derive', 'no.toml'])\n"
        "print('trueaxis.cli.plan' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"


def test_stages_are_lines_where_they_are_asked_for(caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level(logging.INFO, "trueaxis"), progress() as show:
        show("reading")
        show("")
    assert [record.getMessage() for record in caplog.records] == ["reading"]


def test_completion_is_that_of_the_parser(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    stand_in = types.ModuleType("shtab")
    stand_in.complete = lambda parser, shell: f"{shell}: {parser.prog}"  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "shtab", stand_in)
    with pytest.raises(SystemExit) as ended:
        main(["--print-completion", "zsh"])
    assert (ended.value.code, capsys.readouterr().out) == (0, "zsh: trueaxis\n")


@pytest.mark.parametrize(
    ("shell", "told"), [("fish", "one of bash, zsh, tcsh"), ("bash", "pip install 'trueaxis[completion]'")]
)
def test_what_it_lacks_is_told_by_name(
    shell: str, told: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "shtab", None)
    with pytest.raises(SystemExit) as ended:
        main(["--print-completion", shell])
    assert ended.value.code == 2
    assert told in capsys.readouterr().err


def test_shtab_takes_the_whole_parser() -> None:
    shtab = pytest.importorskip("shtab")
    assert "identify" in shtab.complete(build_parser(), shell="bash")
