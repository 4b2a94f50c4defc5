"""`fleet` on real worker processes: rows whatever fails, nothing lost, nothing twice, nothing done again."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import polars as pl
import psutil
import pytest

import trueaxis as ta
from tests.cluster.running import scheduler, worker_processes
from tests.command_lines import PROGRAM, leftovers
from tests.fleets.small_fleet import SLOPE, write_data, write_fleet
from trueaxis.cli.main import main
from trueaxis.fleets.fleet_file import read_fleet
from trueaxis.fleets.rows import read_row
from trueaxis.fleets.unit import chains_of
from trueaxis.jobs.fleet_unit import do_unit


def rows_of(out: Path) -> dict[tuple[str, str], dict[str, Any]]:
    return {
        (row["machine"], row["data"]): row for row in pl.read_parquet(out / "results.parquet").iter_rows(named=True)
    }


def stamps(out: Path) -> dict[Path, int]:
    return {path: path.stat().st_mtime_ns for path in out.rglob("row.json")}


def workers() -> list[psutil.Process]:
    found = []
    for process in psutil.Process().children(recursive=True):
        if "--multiprocessing-fork" in process.cmdline():
            found.append(process)
    return found


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, ta.FleetResult]:
    """A fleet of four machines, of which the third has changed; its folder, and what was done."""
    folder = tmp_path_factory.mktemp("fleet")
    file = write_fleet(folder, 4, changed=[2])
    shown: list[str] = []
    result = ta.fleet(file, folder / "out", workers=2, show=shown.append)
    assert shown[-2:] == ["8 of 8", "summary"]
    return folder, result


def test_each_machine_and_day_is_a_row_with_its_values(done: tuple[Path, ta.FleetResult]) -> None:
    folder, result = done
    assert result.good
    assert result.made == 8
    frame = pl.read_parquet(folder / "out" / "results.parquet")
    assert frame.equals(result.to_polars())
    assert frame["machine"].to_list() == [f"M{n}" for n in range(4) for _ in range(2)]
    assert frame["date"].dt.to_string().to_list() == ["2026-10-01", "2026-11-01"] * 4
    assert set(frame["fit"]) == {"converged"}
    for row in frame.iter_rows(named=True):
        (error,) = row["errors"]
        slope = 3.0 * SLOPE if (row["machine"], str(row["date"])) == ("M2", "2026-11-01") else SLOPE
        file = folder / "out" / "machines" / row["machine"] / str(row["date"]) / "errors.json"
        model = ta.load_model(folder / "small.toml", next((folder / "out" / "kernels").iterdir()))
        curve = ta.load_errors(file, model).values.motion_errors["EXX"]
        over = np.array([0.0, 100.0])
        assert np.diff(curve(over))[0] == pytest.approx(100.0 * slope, abs=4e-4)
        assert error["name"] == "EXX"
        assert row["against"] == (None if str(row["date"]) == "2026-10-01" else "../2026-10-01/errors.json")


def test_what_has_changed_is_told_by_how_many_u(done: tuple[Path, ta.FleetResult]) -> None:
    folder, result = done
    (changed,) = result.summary.changed
    assert (changed.row.machine, changed.error.name) == ("M2", "EXX")
    assert (changed.error.change_in_u or 0.0) > 5.0
    assert "changed: M2 2026-11-01: EXX by" in str(result)
    page = (folder / "out" / "index.html").read_text()
    assert "<span>2026-10-01</span></td>" in page
    assert str(folder) not in page
    assert b"/tmp" not in b"".join(path.read_bytes() for path in (folder / "out").rglob("row.json"))


def test_the_values_are_those_of_the_command(done: tuple[Path, ta.FleetResult], tmp_path: Path) -> None:
    folder, _ = done
    kernels = next((folder / "out" / "kernels").iterdir())
    words = [str(folder / "small.toml"), "--data", str(folder / "data" / "M1" / "2026-10-01")]
    assert main(["identify", *words, "--out", str(tmp_path / "errors.json"), "--kernels", str(kernels)]) == 0
    for name in ("errors.json", "errors.npz"):
        own = folder / "out" / "machines" / "M1" / "2026-10-01" / name
        assert own.read_bytes() == (tmp_path / name).read_bytes()


@pytest.mark.slow
def test_what_is_unchanged_is_not_done_again_and_comes_out_the_same(
    done: tuple[Path, ta.FleetResult], tmp_path: Path
) -> None:
    folder = tmp_path / "fleet"
    shutil.copytree(done[0], folder)
    before, pages = (
        stamps(folder / "out"),
        {n: (folder / "out" / n).read_bytes() for n in ("index.html", "results.parquet")},
    )
    assert ta.fleet(folder / "FLEET.toml", folder / "out").made == 0
    assert stamps(folder / "out") == before
    assert {name: (folder / "out" / name).read_bytes() for name in pages} == pages
    # another reading on the first day of one machine: both of its days, since the second is compared with the first
    readings = folder / "data" / "M1" / "2026-10-01" / "readings.csv"
    readings.write_text(readings.read_text().replace(",10.0,", ",10.5,", 1))
    assert ta.fleet(folder / "FLEET.toml", folder / "out", workers=1).made == 2
    assert {path.parent.parent.name for path, when in stamps(folder / "out").items() if when != before[path]} == {"M1"}
    # what is gone is made anew
    (folder / "out" / "machines" / "M3" / "2026-11-01" / "errors.json").unlink()
    assert ta.fleet(folder / "FLEET.toml", folder / "out", workers=1).made == 1
    assert ta.fleet(folder / "FLEET.toml", folder / "out", workers=2, again=True).made == 8
    (folder / "other").mkdir()
    assert ta.fleet(folder / "FLEET.toml", folder / "other", workers=1).made == 8
    for path in (folder / "other").rglob("*.*"):  # one worker or two, at once or in parts
        assert path.read_bytes() == (folder / "out" / path.relative_to(folder / "other")).read_bytes(), path


def test_a_machine_that_fails_is_a_row(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = write_fleet(tmp_path, 3, dates=("2026-09-01", "2026-10-01", "2026-11-01"))
    broken = tmp_path / "data" / "M1" / "2026-10-01" / "readings.csv"
    broken.write_text(broken.read_text().replace("reading", "raeding").replace("10.0,", "x,"))
    more = '[[machine]]\nid = "lost"\nspec = "none.toml"\ndata = "data/M0/2026-09-01"\n'
    more += '[[machine]]\nid = "unmeasured"\nspec = "small.toml"\ndata = ["data/U/2026-*", "data/V/*"]\n'
    more += '[[machine]]\nid = "gone"\nspec = "small.toml"\nerrors = "gone.json"\ndata = "data/gone"\n'
    file.write_text(file.read_text() + more)
    assert main(["fleet", str(file), "--out", str(tmp_path / "out"), "--workers", "2"]) == 1
    told = capsys.readouterr()
    assert told.err == ""
    assert "6 machines, 12 rows, 4 with faults; 11 made now, 0 as before" in told.out
    rows = rows_of(tmp_path / "out")
    faults = {name: row["faults"] for name, row in rows.items() if row["faults"]}
    assert faults.keys() == {
        ("M1", "data/M1/2026-10-01"),
        ("lost", "data/M0/2026-09-01"),
        ("unmeasured", "data/U/2026-*, data/V/*"),
        ("gone", "data/gone"),
    }
    assert faults["lost", "data/M0/2026-09-01"] == ["none.toml: there is no such file"]
    assert len(faults["unmeasured", "data/U/2026-*, data/V/*"]) == 2
    gone = "".join(faults["gone", "data/gone"])
    assert "gone.json: there is no such file" in gone
    assert "data/gone/setup.toml: there is no such file" in gone
    assert any("raeding" in fault for fault in faults["M1", "data/M1/2026-10-01"])
    assert rows["M1", "data/M1/2026-11-01"]["against"] == "../2026-09-01/errors.json"  # the last that there is
    assert not (tmp_path / "out" / "machines" / "M1" / "2026-10-01" / "errors.json").exists()
    assert leftovers(tmp_path) == []
    # where it is mended, that alone is made
    write_data(tmp_path / "data" / "gone", SLOPE, 5)
    file.write_text(file.read_text().replace('errors = "gone.json"\n', ""))
    assert ta.fleet(file, tmp_path / "out", workers=1).made == 1
    assert not rows_of(tmp_path / "out")["gone", "data/gone"]["faults"]


def test_killed_workers_lose_nothing_and_do_nothing_twice(tmp_path: Path) -> None:
    file = write_fleet(tmp_path, 6)
    killed = []

    def kill(stage: str) -> None:
        if stage in ("2 of 12", "5 of 12"):
            victim = workers()[0]
            victim.send_signal(signal.SIGKILL)
            killed.append(victim.pid)

    result = ta.fleet(file, tmp_path / "out", workers=2, show=kill)
    assert len(killed) == 2
    assert result.good
    assert len(rows_of(tmp_path / "out")) == 12
    first = stamps(tmp_path / "out")
    assert len(first) == 12
    assert ta.fleet(file, tmp_path / "out", workers=2).made == 0
    assert leftovers(tmp_path) == []


@pytest.mark.slow
def test_data_that_take_all_memory_are_given_up_and_tried_again_by_the_next_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = write_fleet(tmp_path, 2)
    endless = tmp_path / "data" / "M0" / "2026-10-01" / "readings.csv"
    endless.unlink()
    endless.symlink_to("/dev/zero")
    words = ["fleet", str(file), "--out", str(tmp_path / "out"), "--workers", "2", "--memory", "0.6"]
    assert main(words) == 1
    told = capsys.readouterr()
    assert told.err == ""
    assert "M0 2026-10-01: given up: 3 workers were lost with it, killed or out of memory" in told.out
    rows = rows_of(tmp_path / "out")
    assert [bool(row["faults"]) for row in rows.values()] == [True, False, False, False]
    endless.unlink()
    shutil.copy(tmp_path / "data" / "M1" / "2026-10-01" / "readings.csv", endless)
    assert main(words) == 0
    assert rows_of(tmp_path / "out")["M0", "data/M0/2026-11-01"]["against"] == "../2026-10-01/errors.json"


@pytest.mark.slow
def test_a_run_that_is_killed_goes_on_where_it_was(tmp_path: Path) -> None:
    file = write_fleet(tmp_path, 5)
    out = tmp_path / "out"
    words = [sys.executable, "-P", "-c", PROGRAM, "fleet", str(file), "--out", str(out), "--workers", "2"]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as first:
        while len(stamps(out)) < 3:
            time.sleep(0.02)
            assert first.poll() is None
        first.kill()
    time.sleep(1.0)  # its workers end on their own
    before = stamps(out)
    assert not (out / "results.parquet").exists()
    assert 3 <= len(before) < 10
    result = ta.fleet(file, out, workers=2)
    assert result.made == 10 - len(before)
    assert {path: when for path, when in stamps(out).items() if path in before} == before
    assert result.good


def test_two_runs_do_not_write_into_one_folder(done: tuple[Path, ta.FleetResult]) -> None:
    import fcntl

    folder, _ = done
    handle = os.open(folder / "out", os.O_RDONLY)
    fcntl.flock(handle, fcntl.LOCK_EX)
    with pytest.raises(ta.InputError, match="is being written by another run"):
        ta.fleet(folder / "FLEET.toml", folder / "out")
    os.close(handle)
    assert ta.fleet(folder / "FLEET.toml", folder / "out").made == 0


def test_results_are_no_inputs(done: tuple[Path, ta.FleetResult], tmp_path: Path) -> None:
    folder = tmp_path / "fleet"
    shutil.copytree(done[0], folder)
    text = (folder / "FLEET.toml").read_text()
    own = 'spec = "small.toml"\nerrors = "out/machines/M0/2026-10-01/errors.json"'
    (folder / "FLEET.toml").write_text(text.replace('spec = "small.toml"', own, 1))
    before = stamps(folder)
    with pytest.raises(ta.InputError, match="lies among the results of --out"):
        ta.fleet(folder / "FLEET.toml", folder / "out")
    (folder / "machines").mkdir()
    shutil.copytree(folder / "data", folder / "machines" / "data")
    (folder / "FLEET.toml").write_text(text.replace('"data/', '"machines/data/'))
    with pytest.raises(ta.InputError, match="lies among the results of --out"):
        ta.fleet(folder / "FLEET.toml", folder)
    assert stamps(folder) == before


def test_workers_of_a_scheduler_that_runs_give_the_same_rows(done: tuple[Path, ta.FleetResult], tmp_path: Path) -> None:
    folder, _ = done
    file = write_fleet(tmp_path, 4, changed=[2])
    with scheduler() as address, worker_processes(address):
        assert main(["fleet", str(file), "--out", str(tmp_path / "out"), "--scheduler", address]) == 0
    for name in ("results.parquet", "machines/M2/2026-11-01/row.json"):
        assert (tmp_path / "out" / name).read_bytes() == (folder / "out" / name).read_bytes()


def test_wrong_files_and_options_write_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "bad.toml").write_text('[[machine]]\nid = "a/b"\nspec = 3\ntask = ["x"]\n')
    assert main(["fleet", str(tmp_path / "bad.toml"), "--out", str(tmp_path / "out")]) == 2
    told = capsys.readouterr()
    assert [line.split(": ")[2].partition(",")[0] for line in told.err.splitlines()] == [
        "line 2",
        "line 3",
        "line 1",
        "line 4",
    ]
    file = write_fleet(tmp_path, 1)
    words = ["fleet", str(file), "--out", str(tmp_path / "out")]
    start = time.monotonic()
    assert main([*words, "--scheduler", "tcp://127.0.0.1:1"]) == 2
    assert time.monotonic() - start < 5.0
    assert capsys.readouterr().err.startswith("trueaxis: --scheduler tcp://127.0.0.1:1: nothing answers there")
    assert main([*words, "--scheduler", "tcp://127.0.0.1:1", "--workers", "2", "--memory", "1"]) == 2
    assert len(capsys.readouterr().err.splitlines()) == 2
    (tmp_path / "file").write_text("")
    assert main(["fleet", str(file), "--out", str(tmp_path / "file")]) == 2
    assert "is a file" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
    with pytest.raises(ValueError, match="workers: expected a whole number"):
        ta.fleet(file, tmp_path / "out", workers=0)
    with pytest.raises(ValueError, match=r"memory: expected GB, at least 0\.5; given 0\.1"):
        ta.fleet(file, tmp_path / "out", memory=0.1)


def test_workers_run_no_modules_that_lie_beside_the_data(tmp_path: Path) -> None:
    write_fleet(tmp_path, 1, dates=("2026-10-01",))
    for name in ("multiprocessing", "polars", "numpy", "dask", "distributed", "trueaxis", "pickle", "tornado"):
        (tmp_path / f"{name}.py").write_text("open('evidence', 'w').close()\nraise SystemExit('run')\n")
    words = [sys.executable, "-P", "-c", PROGRAM, "fleet", "FLEET.toml", "--out", "out", "--workers", "1"]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert "1 made now" in done.stdout
    assert not (tmp_path / "evidence").exists()


def test_a_row_names_no_files_beyond_its_folder(done: tuple[Path, ta.FleetResult], tmp_path: Path) -> None:
    folder = tmp_path / "fleet"
    shutil.copytree(done[0], folder)
    for machine, name in (("M0", "../../../../FLEET.toml"), ("M1", str(folder / "FLEET.toml"))):
        row = folder / "out" / "machines" / machine / "2026-10-01" / "row.json"
        row.write_text(json.dumps({**json.loads(row.read_text()), "files": [name]}))
    ta.fleet(folder / "FLEET.toml", folder / "out", workers=1, again=True)
    assert (folder / "FLEET.toml").is_file()


def test_another_version_of_the_program_is_told(tmp_path: Path) -> None:
    file = write_fleet(tmp_path, 1, dates=("2026-10-01",))
    (chain,) = chains_of(read_fleet(file), tmp_path / "out")
    row, made = do_unit(replace(chain.units[0], version="0.0.1"))
    assert made
    assert row.faults == (
        f"the worker: has trueaxis {ta.__version__}; the fleet was started by 0.0.1; the same version on all computers",
    )


def test_a_damaged_row_is_made_anew(done: tuple[Path, ta.FleetResult], tmp_path: Path) -> None:
    folder = tmp_path / "fleet"
    shutil.copytree(done[0], folder)
    out = folder / "out" / "machines"
    row = out / "M0" / "2026-10-01" / "row.json"
    for text in ("", "[]", "{}", row.read_text()[:200], json.dumps({**json.loads(row.read_text()), "schema": 9})):
        row.write_text(text)
        assert read_row(row.parent) is None
    assert ta.fleet(folder / "FLEET.toml", folder / "out", workers=1).made == 1
    assert read_row(row.parent) is not None


@pytest.mark.slow
def test_all_tasks_leave_the_files_of_the_single_commands(tmp_path: Path) -> None:
    file = write_fleet(tmp_path, 2, dates=("2026-10-01", "2026-11-01"), changed=[1],
                       tasks='tasks = ["identify", "diagnose", "report"]\n')  # fmt: skip
    own = ta.fleet(file, tmp_path / "first", workers=1).folder / "machines" / "M0" / "2026-10-01"
    shutil.copy(own / "errors.json", tmp_path / "now.json")
    shutil.copy(own / "errors.npz", tmp_path / "errors.npz")  # which the values name
    alone = '[[machine]]\nid = "shown"\nspec = "small.toml"\nerrors = "now.json"\ntasks = ["report"]\n'
    text = file.read_text().replace('id = "M1"\n', 'id = "M1"\nerrors = "now.json"\n')
    file.write_text(text + alone)
    result = ta.fleet(file, tmp_path / "out", workers=2)
    assert [row.faults for row in result.rows] == [()] * 5
    rows = rows_of(tmp_path / "out")
    assert all(row["verdict"] is not None for (name, _), row in rows.items() if name != "shown")
    out = tmp_path / "out" / "machines"
    for name in ("errors.json", "errors.npz", "report.html", "diagnosis/diagnosis.json", "diagnosis/report.html"):
        assert (out / "M0" / "2026-11-01" / name).stat().st_size > 0
    assert {path.name for path in (out / "shown" / "given").iterdir()} == {"report.html", "row.json"}
    page = (tmp_path / "out" / "index.html").read_text()
    for address in ("machines/M1/2026-11-01/report.html", "machines/M1/2026-11-01/diagnosis/report.html"):
        assert f'href="{address}"' in page
        assert (tmp_path / "out" / address).is_file()
    kernels = next((tmp_path / "out" / "kernels").iterdir())
    words = ["diagnose", "small.toml", "--data", "data/M1/2026-11-01", "--kernels", str(kernels)]
    for name, errors in (("M1", tmp_path / "now.json"), ("M0", out / "M0" / "2026-10-01" / "errors.json")):
        words[3] = f"data/{name}/2026-11-01"  # beside what the control has, else the values of the date before
        command = [sys.executable, "-P", "-c", PROGRAM, *words, "--errors", str(errors), "--out", name]
        subprocess.run(command, cwd=tmp_path, check=False, capture_output=True)
        own = out / name / "2026-11-01" / "diagnosis" / "diagnosis.json"
        assert json.loads(own.read_text()) == json.loads((tmp_path / name / "diagnosis.json").read_text())
