"""Output files come whole and all together, or not at all."""

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from trueaxis.io.faults import InputError
from trueaxis.io.files import write_files


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def failing_at(count: int, real: Callable[..., object]) -> Callable[..., object]:
    """A call that fails the count-th time."""
    calls = 0

    def call(*args: object, **kwargs: object) -> object:
        nonlocal calls
        calls += 1
        if calls == count:
            raise OSError(28, "No space left on device", str(args[0]))
        return real(*args, **kwargs)

    return call


def test_texts_and_bytes_are_written_in_folders_that_are_made(tmp_path: Path) -> None:
    write_files({tmp_path / "a.txt": "µm\n", tmp_path / "new" / "deep" / "b.bin": b"\x00\xff"})
    assert contents(tmp_path) == {"a.txt": "µm\n".encode(), "new/deep/b.bin": b"\x00\xff"}


def test_line_ends_are_left_as_they_are(tmp_path: Path) -> None:
    write_files({tmp_path / "a": "one\r\ntwo\n"})
    assert (tmp_path / "a").read_bytes() == b"one\r\ntwo\n"


def test_old_files_are_replaced_whole_while_readers_keep_the_old(tmp_path: Path) -> None:
    target = tmp_path / "a"
    target.write_text("old and long")
    with target.open() as reader:
        write_files({target: "new"})
        assert reader.read() == "old and long"  # never a mixture: the name was moved to another file
    assert contents(tmp_path) == {"a": b"new"}


@pytest.mark.parametrize(("what", "count"), [("replace", 1), ("replace", 2), ("replace", 3), ("chmod", 1)])
def test_a_failure_in_the_middle_leaves_everything_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, what: str, count: int
) -> None:
    (tmp_path / "b").write_text("old b")
    files = {tmp_path / "sub" / "a": "new a", tmp_path / "b": "new b", tmp_path / "sub" / "c": "new c"}
    with monkeypatch.context() as patch:
        patch.setattr(Path, what, failing_at(count, getattr(Path, what)))
        with pytest.raises(OSError, match="No space left"):
            write_files(files)
    assert contents(tmp_path) == {"b": b"old b"}
    assert not (tmp_path / "sub").exists()
    write_files(files)
    assert contents(tmp_path) == {"b": b"new b", "sub/a": b"new a", "sub/c": b"new c"}


def test_a_target_that_is_a_folder_leaves_the_others_alone(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    with pytest.raises(InputError, match="folder: is a folder"):
        write_files({tmp_path / "new" / "a": "a", tmp_path / "folder": "b"})
    assert list(tmp_path.iterdir()) == [tmp_path / "folder"]


@pytest.mark.skipif(os.geteuid() == 0, reason="the superuser may write anywhere")
def test_a_folder_that_may_not_be_written_leaves_the_others_alone(tmp_path: Path) -> None:
    closed = tmp_path / "closed"
    closed.mkdir(mode=0o555)
    with pytest.raises(PermissionError):
        write_files({tmp_path / "a": "a", closed / "b": "b"})
    assert contents(tmp_path) == {}


def test_a_file_where_a_folder_should_be_leaves_the_others_alone(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x")
    with pytest.raises(InputError, match="file: is a file; a folder to write to"):
        write_files({tmp_path / "a": "a", tmp_path / "file" / "b": "b"})
    assert contents(tmp_path) == {"file": b"x"}
