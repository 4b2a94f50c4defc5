"""FLEET.toml: what it says, and every fault of it at once, each with its line."""

from pathlib import Path

import pytest

from trueaxis.fleets.fleet_file import FleetMachine, read_fleet
from trueaxis.io.faults import InputError

GOOD = """schema = 1
[[machine]]
id = "M17"
spec = "specs/m17.toml"
errors = "now/m17.json"
data = "data/M17/2026-*"
tasks = ["report", "identify"]

[[machine]]
id = "M-18.b"
spec = "specs/m17.toml"
data = ["a", "b/*"]

[[machine]]
id = "paper"
spec = "s.toml"
errors = "e.json"
tasks = ["report"]
"""


def faults_of(tmp_path: Path, text: str, specs: tuple[str, ...] = ("specs/m17.toml", "s.toml", "s")) -> list[str]:
    path = tmp_path / "FLEET.toml"
    (tmp_path / "specs").mkdir(exist_ok=True)
    for spec in specs:
        (tmp_path / spec).touch()
    path.write_text(text)
    with pytest.raises(InputError) as error:
        read_fleet(path)
    return [str(fault).removeprefix(f"{path}: ") for fault in error.value.faults]


def test_what_it_says(tmp_path: Path) -> None:
    (tmp_path / "FLEET.toml").write_text(GOOD)
    fleet = read_fleet(tmp_path / "FLEET.toml")
    assert fleet.folder == tmp_path
    assert fleet.machines == (
        FleetMachine(id="M17", spec="specs/m17.toml", errors="now/m17.json", data=("data/M17/2026-*",),
                     tasks=("identify", "report")),
        FleetMachine(id="M-18.b", spec="specs/m17.toml", errors=None, data=("a", "b/*"), tasks=("identify",)),
        FleetMachine(id="paper", spec="s.toml", errors="e.json", data=(), tasks=("report",)),
    )  # fmt: skip


def test_specs_that_are_not_there_stand_beside_other_faults(tmp_path: Path) -> None:
    """By themselves they are rows of machines that failed; a file that is to be mended is mended once."""
    found = faults_of(tmp_path, GOOD.replace('"identify"]', '"grind"]'), specs=("s.toml",))
    assert found == [
        "line 7, key machine[0].tasks: has 'grind'; of identify, diagnose, report",
        "line 4, key machine[0].spec: there is no file 'specs/m17.toml'; a spec, from the folder of the fleet file",
    ]


def test_every_fault_is_told_with_its_line(tmp_path: Path) -> None:
    text = GOOD.replace("schema = 1", "schema = 2").replace('"M-18.b"', '"m17"').replace('"identify"]', '"grind"]')
    text = text.replace('["a", "b/*"]', "[1]").replace('errors = "e.json"\n', 'colour = "red"\n') + "\n[other]\n"
    assert faults_of(tmp_path, text) == [
        "line 1, key schema: is 2; this version reads schema 1",
        "line 7, key machine[0].tasks: has 'grind'; of identify, diagnose, report",
        "line 12, key machine[1].data: is [1]; a list of texts in quotes, each once",
        "line 10, key machine[1].id: is 'm17', and M17 is there already; one machine for each id; ids that differ in "
        "capitals alone are one folder on some systems",
        "line 14, key machine[2].errors: is missing; the error values that report alone is to show",
        "line 17, key machine[2].colour: is not a key of this table; allowed: id, spec, errors, data, tasks",
        "line 20, key other: is not a key of this table; allowed: schema, machine",
    ]


@pytest.mark.parametrize("name", ["", "..", ".hidden", "a/b", "a\\\\b", "a b", "\\u00e4", "-x", "a" * 101])
def test_an_id_is_the_name_of_a_folder(tmp_path: Path, name: str) -> None:
    (fault,) = faults_of(tmp_path, f'[[machine]]\nid = "{name}"\nspec = "s"\ndata = "d"\n')
    assert fault.startswith("line 2, key machine[0].id: ")


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "key machine: is missing; one table [[machine]] or more"),
        ("machine = 3", "line 1, key machine: is no array of tables; [[machine]]"),
        ("machine = []", "line 1, key machine: holds no machine; one table [[machine]] or more"),
        ("[[machine]", "line 1: is not TOML: "),
        ('[[machine]]\nid = "a"\nspec = "s"', "line 1, key machine[0].data: is missing; a folder, a list of folders"),
        ('[[machine]]\nid = "a"\nspec = "s"\nerrors = "e"\ndata = "d"\ntasks = ["report"]',
         "line 5, key machine[0].data"),
        ('[[machine]]\nid = "a"\nspec = "s"\ndata = "d"\ntasks = []', "line 5, key machine[0].tasks: is []"),
    ],
)  # fmt: skip
def test_what_is_no_fleet_is_told(tmp_path: Path, text: str, told: str) -> None:
    (fault,) = faults_of(tmp_path, text)
    assert fault.startswith(told)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="there is no such file"):
        read_fleet(tmp_path / "none.toml")
