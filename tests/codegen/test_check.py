"""`derive --check`: missing, left-over and changed files are each told, and nothing else is."""

from pathlib import Path

from trueaxis.codegen.check import differences, write

FILES = {"kernels.py": b"a = 1\nb = 2\nc = 3\n", "equations.md": b"# page\n"}


def test_what_was_written_does_not_differ(tmp_path: Path) -> None:
    write(tmp_path / "m", FILES)
    assert differences(tmp_path / "m", FILES) == []


def test_a_folder_that_is_not_there_lacks_every_file(tmp_path: Path) -> None:
    found = differences(tmp_path / "m", FILES)
    assert found == [f"{tmp_path}/m/kernels.py: is missing", f"{tmp_path}/m/equations.md: is missing"]


def test_a_left_over_file_is_told(tmp_path: Path) -> None:
    write(tmp_path, {**FILES, "kernels.rs": b""})
    assert differences(tmp_path, FILES) == [f"{tmp_path}/kernels.rs: is not generated from this spec"]


def test_a_changed_file_is_told_line_by_line(tmp_path: Path) -> None:
    write(tmp_path, {**FILES, "kernels.py": b"a = 1\nb = 5\nc = 3\n"})
    path = f"{tmp_path}/kernels.py"
    assert differences(tmp_path, FILES, context=1) == [
        f"--- {path}", f"+++ {path} (as derived now)", "@@ -1,3 +1,3 @@", " a = 1", "-b = 5", "+b = 2", " c = 3",
    ]  # fmt: skip


def test_files_that_differ_in_line_ends_alone_differ(tmp_path: Path) -> None:
    write(tmp_path, {**FILES, "equations.md": b"# page\r\n"})
    assert differences(tmp_path, FILES)


def test_bytes_that_are_no_text_are_told_all_the_same(tmp_path: Path) -> None:
    write(tmp_path, {**FILES, "equations.md": b"\xff\xfe"})
    assert any("as derived now" in line for line in differences(tmp_path, FILES))
