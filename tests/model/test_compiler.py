"""Compiling the kernels: once, privately, and with a reason where it cannot be done."""

import contextlib
import ctypes
import errno
import os
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import pytest

from trueaxis.model import compiler
from trueaxis.model.compiler import Compilation, compile_kernels, find_compiler
from trueaxis.stopping import Stopped

pytestmark = [
    pytest.mark.skipif(find_compiler() is None, reason="there is no C compiler"),
    pytest.mark.skipif(sys.platform == "win32", reason="the compilers of these tests are shell scripts"),
]


@pytest.fixture
def source(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A source that says 41, in a folder of its own, and an empty cache."""
    monkeypatch.setenv("TRUEAXIS_CACHE", str(tmp_path / "cache"))
    path = tmp_path / "kernels.c"
    path.write_text('#include "kernels.h"\nint answer(void) { return ANSWER; }\n')
    path.with_name("kernels.h").write_text("#define ANSWER 41\nint answer(void);\n")
    return path


def script(path: Path, text: str) -> str:
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return str(path)


def code_of(source: Path) -> dict[str, bytes]:
    return {name: source.with_name(name).read_bytes() for name in ("kernels.c", "kernels.h")}


def compiled(source: Path) -> Compilation:
    return compile_kernels(code_of(source))


def answer(library: Path | None) -> int:
    assert library is not None
    return int(ctypes.CDLL(str(library)).answer())


def test_the_second_time_nothing_is_compiled(source: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = compiled(source)
    assert answer(first.library) == 41
    monkeypatch.setattr(compiler, "_compile", None)
    assert compiled(source) == first


def test_another_content_is_another_library(source: Path) -> None:
    before = compiled(source).library
    source.with_name("kernels.h").write_text("#define ANSWER 42\nint answer(void);\n")
    after = compiled(source).library
    assert before != after
    assert answer(after) == 42


def test_processes_compile_at_once(source: Path) -> None:
    with ProcessPoolExecutor(4) as pool:
        found = set(pool.map(compiled, [source] * 8))
    assert len(found) == 1
    assert answer(found.pop().library) == 41
    left = [path.suffix for path in (source.parent / "cache" / "kernels").iterdir()]
    assert left == [".so"]


def test_flags_that_a_compiler_refuses_are_dropped(
    source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = (find_compiler() or ("",))[0]
    old = (
        f'for word; do [ "$word" = -march=native ] && {{ echo "error: no such flag" >&2; exit 1; }}; done; {real} "$@"'
    )
    monkeypatch.setenv("CC", script(tmp_path / "old-cc", old))
    assert answer(compiled(source).library) == 41


def test_words_of_cc_are_kept(source: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", f"{(find_compiler() or ('',))[0]} -DUNUSED='two words'")
    assert answer(compiled(source).library) == 41


def test_broken_source_tells_the_first_error(source: Path) -> None:
    source.write_text("int answer(void) { return }\n")
    found = compiled(source)
    assert found.library is None
    assert "cannot compile kernels.c" in found.reason
    assert "error:" in found.reason


def test_compiler_that_fails_or_makes_nothing(source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for text in ("exit 1", "exit 0"):
        monkeypatch.setenv("CC", script(tmp_path / "bad-cc", text))
        found = compiled(source)
        assert found.library is None
        assert "bad-cc cannot compile kernels.c: no message" in found.reason


def test_no_compiler(source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", "no-such-compiler")
    assert compiled(source).reason == "no C compiler found (CC is no-such-compiler)"
    monkeypatch.delenv("CC")
    monkeypatch.setenv("PATH", str(tmp_path / "nothing"))
    assert compiled(source).reason == "no C compiler found (looked for cc, gcc, clang)"


def test_compiler_that_hangs(source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiler, "_SECONDS", 0.2)
    monkeypatch.setenv("CC", script(tmp_path / "slow-cc", f"exec {shutil.which('sleep')} 60"))
    assert compiled(source).reason == "the C compiler took longer than 0.2 s"


@pytest.mark.parametrize("ended_by", ["limit", "signal"])
def test_what_a_compiler_has_started_ends_with_it(
    source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ended_by: str
) -> None:
    """As gcc starts cc1. The child holds the pipe open as long as it lives."""

    def stop(number: int, _: object) -> None:
        raise Stopped(number)

    os.mkfifo(pipe := tmp_path / "pipe")
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    child = f"{{ echo started; exec {shutil.which('sleep')} 60; }} > {pipe} &"
    monkeypatch.setenv("CC", script(tmp_path / "slow-cc", f'[ "$1" = --version ] || {{ {child} wait; }}'))
    if ended_by == "limit":
        monkeypatch.setattr(compiler, "_SECONDS", 2.0)
        assert "took longer" in compiled(source).reason
    else:
        before = signal.signal(signal.SIGALRM, stop)
        signal.setitimer(signal.ITIMER_REAL, 2.0)
        with pytest.raises(Stopped):
            compiled(source)
        signal.signal(signal.SIGALRM, before)
    assert os.read(reader, 100) == b"started\n"
    assert ends(reader), "the child outlives its compiler"
    os.close(reader)
    assert list((tmp_path / "cache" / "kernels").iterdir()) == []


def ends(reader: int) -> bool:
    """Nobody holds the other end of the pipe any more, or will within 5 s."""
    for _ in range(500):
        with contextlib.suppress(BlockingIOError):
            return os.read(reader, 1) == b""
        time.sleep(0.01)
    return False


def test_the_content_is_compiled_and_no_file_is_read(source: Path) -> None:
    code = code_of(source)
    source.write_text("no C at all")
    source.with_name("kernels.h").unlink()
    assert answer(compile_kernels(code).library) == 41


def test_cache_that_cannot_be_made(source: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TRUEAXIS_CACHE", str(source / "below a file"))
    assert "cannot be compiled" in compiled(source).reason


def test_cache_that_others_can_write_is_not_trusted(source: Path) -> None:
    folder = source.parent / "cache" / "kernels"
    folder.mkdir(parents=True)
    folder.chmod(0o777)
    assert "others can write" in compiled(source).reason


def test_cache_is_made_for_its_owner_alone(source: Path) -> None:
    compiled(source)
    assert (source.parent / "cache" / "kernels").stat().st_mode & 0o777 == 0o700


@pytest.mark.skipif(sys.platform == "darwin", reason="the folder's name is another")
def test_cache_of_the_platform(source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("TRUEAXIS_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    library = compiled(source).library
    assert library is not None
    assert library.parent == tmp_path / "xdg" / "trueaxis" / "kernels"
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    library = compiled(source).library
    assert library is not None
    assert library.parent == tmp_path / "home" / ".cache" / "trueaxis" / "kernels"


@pytest.mark.parametrize("damage", ["truncated", "zeros", "one byte", "empty"])
def test_a_damaged_library_is_compiled_anew(source: Path, damage: str) -> None:
    library = compiled(source).library
    assert library is not None
    content = library.read_bytes()
    flipped = content[:1000] + bytes([content[1000] ^ 1]) + content[1001:]
    damaged = {
        "truncated": content[: len(content) // 2],
        "zeros": bytes(len(content)),
        "one byte": flipped,
        "empty": b"",
    }
    library.write_bytes(damaged[damage])
    again = compiled(source).library
    assert answer(again) == 41
    assert [path.suffix for path in library.parent.iterdir()] == [".so"]


def test_a_full_cache_is_a_reason(source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> int:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    found = compiled(source)
    assert found.library is None
    assert "No space left on device" in found.reason
    assert list((tmp_path / "cache" / "kernels").iterdir()) == []


def test_a_killed_compilation_is_cleared_up_by_the_next(source: Path, tmp_path: Path) -> None:
    waits = f'{{ echo $$ > "$STARTED".tmp; mv "$STARTED".tmp "$STARTED"; exec {shutil.which("sleep")} 60; }}'
    slow = script(tmp_path / "slow-cc", f'[ "$1" = --version ] || {waits}')
    code = (
        "import sys; from pathlib import Path; from trueaxis.model.compiler import compile_kernels\n"
        "compile_kernels({path.name: path.read_bytes() for path in map(Path, sys.argv[1:])})"
    )
    environment = os.environ | {"CC": slow, "STARTED": str(tmp_path / "started")}
    words = [sys.executable, "-c", code, str(source), str(source.with_name("kernels.h"))]
    with subprocess.Popen(words, env=environment) as process:
        while not (tmp_path / "started").exists():
            time.sleep(0.01)
        cache = tmp_path / "cache" / "kernels"
        (folder,) = cache.iterdir()
        assert compiled(source).library is not None
        assert folder.is_dir(), "what a running process holds is not removed"
        os.kill(process.pid, signal.SIGKILL)
    os.kill(int((tmp_path / "started").read_text()), signal.SIGKILL)  # nobody is left who would end it
    assert folder.is_dir()
    source.write_text(source.read_text() + "\n")
    assert answer(compiled(source).library) == 41
    assert {path.suffix for path in cache.iterdir()} == {".so"}


def test_a_relative_cache_of_the_user_is_passed_over(
    source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("TRUEAXIS_CACHE")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("XDG_CACHE_HOME", "relative")
    library = compiled(source).library
    assert library is not None
    assert library.is_relative_to(tmp_path / "home")
