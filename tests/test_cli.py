"""The command line: exit codes, every fault on standard error, no traceback, help that helps."""

import argparse
import contextlib
import io
import re
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from tests.command_lines import SMALL
from tests.machine.test_faults import BASE
from tests.machines import DMU60P
from trueaxis import __version__
from trueaxis.cli.main import COMMANDS, build_parser, main

FAULTY = BASE.replace("schema = 1", "schema = 7").replace("lower = 5", "lower = 6").replace("[0.0, 700.0]", "[9, 1]")
FAULTS = ("line 1, key schema", "line 31, key body[3].lower", "line 10, key body[0].travel", "line 35, key ends.tool")


def subparser(command: str) -> argparse.ArgumentParser:
    (action,) = (a for a in build_parser()._actions if isinstance(a, argparse._SubParsersAction))
    found = action.choices[command]
    assert isinstance(found, argparse.ArgumentParser)
    return found


ONE_OF = {("plan", "data"), ("predict", "at")}  # where one of several is required


def arguments(command: str, folder: Path, **given: Path) -> list[str]:
    """The command with a path for all that it must have: `given` by destination, else a name in `folder`."""
    words = [command]
    for action in subparser(command)._actions:
        if not action.required and (command, action.dest) not in ONE_OF:
            continue
        path = str(given.get(action.dest, folder / f"{action.dest}.txt"))
        if action.choices:
            path = str(next(iter(action.choices)))
        words += [action.option_strings[-1], path] if action.option_strings else [path]
    return words


TAKE_A_MACHINE = [c for c in COMMANDS if any(a.dest == "machine" for a in subparser(c)._actions)]


def test_commands_take_a_machine() -> None:
    assert {"derive", "predict", "simulate", "identify", "compensate"} <= set(TAKE_A_MACHINE)


@pytest.mark.parametrize("command", COMMANDS)
def test_help_tells_every_argument(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        main([command, "--help"])
    assert stop.value.code == 0
    shown = capsys.readouterr().out
    assert shown.startswith(f"usage: trueaxis {command}")
    parser = subparser(command)
    assert len(parser.description or "") > 60, "a sentence on what the command does"
    for action in parser._actions:
        assert action.help, f"{command} says nothing of {action.dest}"
        assert (action.option_strings[-1] if action.option_strings else str(action.metavar)) in shown


def test_the_help_of_all_names_every_command(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        main(["--help"])
    assert stop.value.code == 0
    shown = capsys.readouterr().out
    (action,) = (a for a in build_parser()._actions if isinstance(a, argparse._SubParsersAction))
    helps = {choice.dest: choice.help for choice in action._choices_actions}
    for command in COMMANDS:
        assert f"\n    {command} " in shown.replace("\n", " \n")
        assert helps[command], f"{command} has no line of help"
    assert "Exit codes" in shown


def test_the_version(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        main(["--version"])
    assert stop.value.code == 0
    assert capsys.readouterr().out == f"trueaxis {__version__}\n"


@pytest.mark.parametrize("words", [[], ["no-such-command"], ["derive"], ["derive", "a", "--no-such-option"]])
def test_wrong_usage_is_2_on_standard_error(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        main(words)
    assert stop.value.code == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert re.fullmatch(r"(trueaxis( derive)?): .+\n\1 --help lists what can be given\n", shown.err)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["diagnose", "m.toml", "--dat", "d", "--out", "o"], "there is no option --dat, did you mean --data?"),
        (["diagnose", "m.toml", "--data=d", "--outt=o"], "there is no option --outt, did you mean --out?"),
        (
            ["identify", "m.toml", "--noise", "1"],
            "there is no option --noise, did you mean --noise-um or --noise-urad?",
        ),
    ],
)
def test_options_are_typed_in_full_and_the_nearest_is_named(
    words: list[str], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as stop:
        main(words)
    assert stop.value.code == 2
    assert said in capsys.readouterr().err


@pytest.mark.parametrize("command", TAKE_A_MACHINE)
def test_every_fault_of_a_spec_is_told_and_nothing_is_written(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spec = tmp_path / "faulty.toml"
    spec.write_text(FAULTY)
    assert main(arguments(command, tmp_path, machine=spec)) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    for fault in FAULTS:
        assert f"trueaxis: {spec}: {fault}: " in shown.err
    assert all(line.startswith("trueaxis: ") for line in shown.err.splitlines())
    assert list(tmp_path.iterdir()) == [spec]


@pytest.mark.parametrize("command", TAKE_A_MACHINE)
def test_a_spec_that_is_not_there_is_2(command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(arguments(command, tmp_path)) == 2
    shown = capsys.readouterr()
    assert f"{tmp_path}/machine.txt: there is no such file" in shown.err
    assert shown.out == ""
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("command", [c for c in TAKE_A_MACHINE if c != "derive"])
def test_files_that_are_not_there_are_2_and_named(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(arguments(command, tmp_path, machine=DMU60P)) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert str(tmp_path) in shown.err
    assert list(tmp_path.iterdir()) == []


def test_a_traceback_is_shown_for_no_wrong_input(tmp_path: Path) -> None:
    spec = tmp_path / "faulty.toml"
    spec.write_bytes(b"\xff\xfe")
    done = subprocess.run(
        [sys.executable, "-m", "trueaxis", "derive", str(spec)], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == f"trueaxis: {spec}: line 1: byte 0xff is not UTF-8; save the file as UTF-8\n"


class Derived(NamedTuple):
    folder: Path
    shown: str


@pytest.fixture(scope="module")
def paper(tmp_path_factory: pytest.TempPathFactory) -> Derived:
    """The paper's machine."""
    folder, shown = tmp_path_factory.mktemp("generated"), io.StringIO()
    with contextlib.redirect_stdout(shown):
        assert main(["derive", str(DMU60P), "--out", str(folder)]) == 0
    return Derived(folder, shown.getvalue())


@pytest.fixture
def small(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    """The spec of a machine of one axis, with its files in `generated`."""
    spec = tmp_path / "small.toml"
    spec.write_text(SMALL)
    assert main(["derive", str(spec), "--out", str(tmp_path / "generated")]) == 0
    capsys.readouterr()
    return spec


class TestDerive:
    def test_it_writes_the_machines_files(self, paper: Derived) -> None:
        names = sorted(path.name for path in (paper.folder / "dmu60p").iterdir())
        assert names == [
            "control.c",
            "control.h",
            "equations.md",
            "kernels.c",
            "kernels.h",
            "kernels.py",
            "manifest.json",
        ]

    def test_it_shows_the_lower_body_array_and_the_order_of_systems(self, paper: Derived) -> None:
        shown = paper.shown
        assert "L^1  0  1  2  1  5  6" in shown
        assert "4. XZ-1x, XZ-2x -> EXZ, ECZ" in shown
        assert "\nX+ commands move the tool to X+ of the workpiece, from 0 to 540 mm there\n" in shown
        told = (
            "\nY+ commands move the tool to Y- of the workpiece, from 0 to -700 mm there: "
            "Y slide carriage moves to Y+ (`sense = -1` where the "
        )
        assert f"{told}control counts the other way)\n" in shown

    def test_it_says_which_way_rotary_axes_turn(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        spec = tmp_path / "mill.toml"
        for sense, minus in ((1, True), (-1, False)):
            spec.write_text(
                'schema = 1\nname = "mill"\nstructure = "[w C\' X\' b Y Z B t]"\n'
                f"[axis.C]\nsense = {sense}\n" + "".join(f"[axis.{axis}]\ntravel = [0.0, 400.0]\n" for axis in "XYZ")
            )
            assert main(["derive", str(spec), "--out", str(tmp_path / "generated")]) == 0
            shown = capsys.readouterr().out
            assert "\nB+ commands turn the tool from Z+ to X+ of the workpiece\n" in shown
            other = " turn the tool from Y+ to X+ of the workpiece: C table turns from X+ to Y+ (`sense = -1` where"
            assert (f"\nC+ commands{other}" in shown) is minus
            assert ("\nC+ commands turn the tool from X+ to Y+ of the workpiece\n" in shown) is not minus

    def test_check_is_0_where_nothing_differs(self, small: Path, capsys: pytest.CaptureFixture[str]) -> None:
        assert main(["derive", str(small), "--out", str(small.parent / "generated"), "--check"]) == 0
        assert "is what" in capsys.readouterr().out

    def test_check_is_1_where_something_does_and_touches_nothing(
        self, small: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        written = small.parent / "generated"
        small.write_text(SMALL.replace("400.0", "405.0"))
        before = {path: path.read_bytes() for path in (written / "small").iterdir()}
        assert main(["derive", str(small), "--out", str(written), "--check"]) == 1
        shown = capsys.readouterr().out
        assert "(as derived now)" in shown
        assert f"run: trueaxis derive {small} --out {written}" in shown
        assert {path: path.read_bytes() for path in (written / "small").iterdir()} == before

    def test_the_kernels_of_another_spec_of_the_name_are_kept(
        self, small: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """Deriving, and the remedy of a command that meets them, would leave the first machine without its kernels."""
        kernels, other = small.parent / "generated", tmp_path / "other" / small.name
        other.parent.mkdir()
        other.write_text(SMALL)
        assert main(["derive", str(other), "--out", str(kernels)]) == 0  # the same machine, wherever its file lies
        assert main(["derive", str(small), "--out", str(kernels)]) == 0
        before = {path: path.read_bytes() for path in (kernels / "small").iterdir()}
        other.write_text(SMALL.replace("400.0", "405.0"))
        capsys.readouterr()
        assert main(["derive", str(other), "--out", str(kernels)]) == 2
        assert "another spec of the name small; another folder by --out" in capsys.readouterr().err
        words = ["--with", "laser", "--hours", "1", "--out", str(tmp_path / "p"), "--kernels", str(kernels)]
        assert main(["plan", str(other), *words]) == 2
        assert "another spec of this name; run: trueaxis derive" in (told := capsys.readouterr().err)
        assert "--out OTHER, and give --kernels OTHER" in told
        assert {path: path.read_bytes() for path in (kernels / "small").iterdir()} == before

    def test_a_folder_of_runs_that_is_not_there(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        spec = tmp_path / "dmu60p.toml"
        spec.write_text(DMU60P.read_text())
        assert main(["derive", str(spec), "--out", str(tmp_path / "out")]) == 2
        assert "key runs: there is no folder" in capsys.readouterr().err
        assert not (tmp_path / "out").exists()

    def test_a_place_that_cannot_be_written_is_2(self, small: Path, capsys: pytest.CaptureFixture[str]) -> None:
        file = small.parent / "file"
        file.write_text("")
        assert main(["derive", str(small), "--out", str(file)]) == 2
        shown = capsys.readouterr()
        assert str(file) in shown.err
        assert shown.err.count("\n") == 1

    def test_predict_runs_on_what_it_wrote(self, paper: Derived, tmp_path: Path) -> None:
        (tmp_path / "e.json").write_text(
            '{"schema": 1, "machine": "dmu60p", "parameters": {"eps_xy": 1e-5}, "motion_errors": {}}'
        )
        (tmp_path / "points.csv").write_text("X,Y,Z\n100,0,0\n0,200,0\n")
        words = ["predict", str(DMU60P), "--errors", str(tmp_path / "e.json"), "--at", str(tmp_path / "points.csv")]
        words += ["--out", str(tmp_path / "out.csv"), "--kernels", str(paper.folder)]
        assert main(words) == 0
        rows = np.genfromtxt(tmp_path / "out.csv", delimiter=",", names=True)
        # X turned by eps_xy about z: y = 100 eps at X = 100; at home the tool point lies on the axis of the turn.
        np.testing.assert_allclose(rows["dy"], [1e-3, 0], atol=1e-15)
        np.testing.assert_allclose(rows["dx"], [0, 0], atol=1e-15)
