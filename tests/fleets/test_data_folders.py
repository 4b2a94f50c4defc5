"""The folders of measured data of a machine, in order of their dates."""

from datetime import date
from pathlib import Path

import pytest

from trueaxis.fleets.fleet_file import data_folders, date_of
from trueaxis.io.faults import InputError


@pytest.mark.parametrize(
    ("name", "day"),
    [
        ("2026-11-03", date(2026, 11, 3)),
        ("M17_20261103_night", date(2026, 11, 3)),
        ("run7 2026-11-03T06-30", date(2026, 11, 3)),
        ("2026-11", date(2026, 11, 1)),
        ("2026-13-01", None),
        ("2026-02-30 or 2026-03-02", date(2026, 3, 2)),
        ("120261103", None),
        ("serial 4711", None),
        ("2026", None),
    ],
)
def test_the_date_of_a_name(name: str, day: date | None) -> None:
    assert date_of(name) == day


def make(tmp_path: Path, *names: str) -> None:
    for name in names:
        (tmp_path / name).mkdir(parents=True)


def test_patterns_and_folders_come_by_date(tmp_path: Path) -> None:
    make(tmp_path, "d/2026-11-03", "d/2026-09-01", "d/2026-10-01b", "d/2026-10-01a", "d/first", "e/20250101")
    (tmp_path / "d" / "2026-12-01").write_text("a file")
    found = data_folders(tmp_path, ("e/20250101", "d/2026-*", "d/first", "d/2026-11-*", "not/there"))
    assert [one.name for one in found] == [
        "d/first", "not/there", "e/20250101", "d/2026-09-01", "d/2026-10-01a", "d/2026-10-01b", "d/2026-11-03",
    ]  # fmt: skip
    assert found[-1].path == tmp_path / "d" / "2026-11-03"


def test_absolute_patterns_are_kept(tmp_path: Path) -> None:
    make(tmp_path, "d/2026-11-03")
    (one,) = data_folders(tmp_path / "elsewhere", (f"{tmp_path}/d/*",))
    assert (one.name, one.path) == (f"{tmp_path}/d/2026-11-03", tmp_path / "d" / "2026-11-03")


def test_what_matches_nothing_and_names_that_are_one_are_told(tmp_path: Path) -> None:
    make(tmp_path, "a/2026-11-03", "b/2026-11-03")
    with pytest.raises(InputError) as error:
        data_folders(tmp_path, ("c/*", "?/2026-*", "a/.."))
    assert [fault.file for fault in error.value.faults] == ["c/*", "b/2026-11-03", "a/.."]
    assert "matches no folder" in error.value.faults[0].problem


def test_a_link_has_its_own_name(tmp_path: Path) -> None:
    make(tmp_path, "d/2026-11-03")
    (tmp_path / "d" / "latest").symlink_to("2026-11-03")
    assert [one.path.name for one in data_folders(tmp_path, ("d/*",))] == ["latest", "2026-11-03"]
