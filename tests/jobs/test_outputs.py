"""Outputs that would destroy inputs are refused."""

from pathlib import Path

from trueaxis.jobs.outputs import overwritten


def test_an_output_may_be_no_input_no_file_of_an_input_folder_and_no_other_output(tmp_path: Path) -> None:
    data = tmp_path / "data"
    data.mkdir()
    (data / "readings.csv").write_text("run\n")
    machine = tmp_path / "m.toml"
    machine.write_text("")
    link = tmp_path / "link.toml"
    link.symlink_to(machine)
    inputs = {"MACHINE.toml": machine, "--data": data, "--known": None}
    problems = [
        fault.problem
        for fault in overwritten(
            inputs, {"--out": data / ".." / "m.toml", "--report": data / "readings.csv", "--picture": link}
        )
    ]
    assert problems == [
        "is both MACHINE.toml, which is read, and --out",
        "--report is a file of --data, which is read",
        "is both MACHINE.toml, which is read, and --picture",
        "is both --out and --picture",
    ]


def test_new_files_are_fine_even_inside_a_data_folder(tmp_path: Path) -> None:
    assert overwritten({"--data": tmp_path}, {"--out": tmp_path / "new.json", "--report": None}) == []
