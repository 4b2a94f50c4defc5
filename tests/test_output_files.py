"""Outputs go to files and nowhere else, keep what the user set of them, and never take the place of what is read."""

import errno
import os
import resource
import socket
import stat
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.command_lines import COMMANDS, KERNELS, command_line, leftovers, run, words_of
from tests.machines import ROOT
from trueaxis.cli.main import main
from trueaxis.io import staging
from trueaxis.io.faults import InputError
from trueaxis.io.files import OutputFiles, write_files
from trueaxis.io.staging import staged_file, staged_folder, staged_name, sweep

Program = Callable[[list[str]], tuple[int, str]]

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="modes, links and locks of POSIX")


@pytest.fixture
def program(prepared: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Program:
    """Runs a command among the inputs, in this process; gives its exit code and all that it said."""

    def run_it(words: list[str]) -> tuple[int, str]:
        monkeypatch.chdir(prepared)
        code = main(words_of(words))
        shown = capsys.readouterr()
        return code, shown.out + shown.err

    return run_it


@pytest.fixture
def umask() -> Iterator[None]:
    before = os.umask(0o027)
    yield
    os.umask(before)


@pytest.mark.usefixtures("umask")
def test_a_new_file_has_the_mode_of_new_files_and_an_old_one_keeps_its_own(tmp_path: Path) -> None:
    old = tmp_path / "old"
    old.write_text("old")
    old.chmod(0o604)
    write_files({tmp_path / "folder" / "new": "new", old: "new"})
    assert (tmp_path / "folder" / "new").stat().st_mode & 0o7777 == 0o640
    assert (tmp_path / "folder").stat().st_mode & 0o777 == 0o750
    assert old.stat().st_mode & 0o777 == 0o604


@pytest.mark.skipif(os.geteuid() != 0, reason="only the superuser gives files away")
def test_an_old_file_keeps_its_owner(tmp_path: Path) -> None:
    (tmp_path / "old").write_text("old")
    os.chown(tmp_path / "old", 12345, 12346)
    write_files({tmp_path / "old": "new"})
    there = (tmp_path / "old").stat()
    assert (there.st_uid, there.st_gid) == (12345, 12346)


def test_a_link_is_written_through(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "real" / "file").write_text("old")
    (tmp_path / "second").symlink_to("real/file")
    (tmp_path / "first").symlink_to("second")
    (tmp_path / "dangling").symlink_to("real/new")
    write_files({tmp_path / "first": "one", tmp_path / "dangling": "two"})
    assert (tmp_path / "first").is_symlink()
    assert (tmp_path / "second").is_symlink()
    assert (tmp_path / "dangling").is_symlink()
    assert (tmp_path / "real" / "file").read_text() == "one"
    assert (tmp_path / "real" / "new").read_text() == "two"


@pytest.mark.parametrize("name", ["/dev/null", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/2", "fifo", "socket", "loop"])
def test_what_is_no_file_is_refused(tmp_path: Path, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    os.mkfifo("fifo")
    (tmp_path / "loop").symlink_to("loop")
    (tmp_path / "other").write_text("other")
    with socket.socket(socket.AF_UNIX) as listening:
        listening.bind("socket")
        before = {path: (path.lstat().st_ino, path.lstat().st_mode) for path in tmp_path.iterdir()}
        device = Path("/dev/null").stat()
        with pytest.raises(InputError):
            write_files({Path("other"): "new", Path(name): "new"})
    assert Path("/dev/null").stat().st_rdev == device.st_rdev
    assert {path: (path.lstat().st_ino, path.lstat().st_mode) for path in tmp_path.iterdir()} == before
    assert (tmp_path / "other").read_text() == "other"


@pytest.mark.parametrize("word", [">", "2>"])
def test_the_file_that_the_text_goes_to_is_refused(prepared: Path, tmp_path: Path, word: str) -> None:
    target = tmp_path / "both"
    with target.open("w") as file:
        streams = {"stdout": file, "stderr": subprocess.PIPE} if word == ">" else {"stderr": file}
        words = command_line(f"evaluate {prepared / 'test.csv'} --out {target}")
        done = subprocess.run(words, check=False, text=True, **streams)
    assert done.returncode == 2
    told = done.stderr if word == ">" else target.read_text()
    assert f"{target}: is where standard {'output' if word == '>' else 'error'} goes" in told


@pytest.mark.skipif(os.geteuid() == 0, reason="the superuser may write any file")
def test_a_file_that_may_not_be_written_is_not_replaced(tmp_path: Path) -> None:
    (tmp_path / "kept").write_text("old")
    (tmp_path / "kept").chmod(0o444)
    with pytest.raises(PermissionError):
        write_files({tmp_path / "kept": "new"})


def test_other_names_of_a_file_keep_what_they_had(tmp_path: Path) -> None:
    (tmp_path / "one").write_text("old")
    (tmp_path / "two").hardlink_to(tmp_path / "one")
    write_files({tmp_path / "one": "new"})
    assert (tmp_path / "two").read_text() == "old"


READERS = {
    "predict": ("m.toml", "e.json", "points.parquet"),
    "simulate": ("m.toml", "e.json", "dmu60p_runs/setup.toml"),
    "plan": ("m.toml", "dmu60p_runs/readings.csv"),
    "identify": ("m.toml", "data/readings.csv"),
    "fit": ("m.toml", "tables.json"),
    "compensate": ("m.toml", "e.json", "part.nc"),
    "diagnose": ("m.toml", "e.json", "of_x/readings.csv"),
    "evaluate": ("test.csv",),
    "import": ("m.toml", "x.rtl"),
    "export": ("m.toml", "e.json"),
    "derive": ("small.toml",),
}
FIRST_OUTPUT = {
    "predict": "p.csv", "simulate": "data/setup.toml", "plan": "plan.json", "identify": "i.json", "fit": "f.json",
    "compensate": "c.nc", "diagnose": "d/diagnosis.json", "evaluate": "t.json", "derive": "generated/small/kernels.py",
    "import": "imported/setup.toml", "export": "enc.ini",
}  # fmt: skip


@pytest.mark.parametrize("link", ["hard", "symbolic"])
@pytest.mark.parametrize(("name", "source"), [(name, source) for name, some in READERS.items() for source in some])
def test_what_is_read_is_known_under_every_name(
    prepared: Path, tmp_path: Path, program: Program, name: str, source: str, link: str
) -> None:
    target = tmp_path / FIRST_OUTPUT[name]
    target.parent.mkdir(parents=True, exist_ok=True)
    if link == "hard":
        target.hardlink_to(prepared / source)
    else:
        target.symlink_to(prepared / source)
    before = (prepared / source).read_bytes()
    code, told = program(COMMANDS[name].format(out=tmp_path).split())
    assert code == 2
    assert "which is read" in told
    assert (prepared / source).read_bytes() == before
    assert target.read_bytes() == before
    assert leftovers(tmp_path) == []


@pytest.mark.parametrize("name", ["kernels.py", "kernels.c", "manifest.json", "new.json"])
@pytest.mark.parametrize("command", ["predict", "identify", "compensate"])
def test_kernels_are_not_written_over(prepared: Path, program: Program, command: str, name: str) -> None:
    kept = [path for path in (KERNELS / "dmu60p").iterdir() if path.is_file()]  # Python may keep its own folder there
    before = {path: path.read_bytes() for path in kept}
    other = os.path.relpath(KERNELS / "trunnion_mill" / ".." / "dmu60p", prepared)
    words = COMMANDS[command].replace(f"{{out}}/{Path(FIRST_OUTPUT[command]).name}", f"{other}/{name}")
    code, told = program(words.format(out="out").split())
    assert code == 2
    assert "lies among the kernels of" in told
    assert {path: path.read_bytes() for path in (KERNELS / "dmu60p").iterdir() if path.is_file()} == before


def test_a_file_named_as_a_folder_is_refused(
    tmp_path: Path, program: Program, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "p.csv").write_text("old")
    for name in ("p.csv/", "new/"):
        with pytest.raises(SystemExit, match="2"):
            program(f"predict m.toml --errors e.json --at points.parquet --out {tmp_path / name}/".split())
        assert "is the name of a folder" in capsys.readouterr().err
    assert (tmp_path / "p.csv").read_text() == "old"


NAMES = {"newline": "a\nb", "surrogate": "a\udcffb", "long": "x" * 300, "escape": "a\x1b[31mb", "bidi": "a\u202eb"}


@pytest.mark.parametrize("name", NAMES.values(), ids=NAMES)
@pytest.mark.parametrize("command", COMMANDS)
def test_odd_names_of_inputs_and_outputs_are_one_line(
    tmp_path: Path, program: Program, command: str, name: str
) -> None:
    words = [word.format(out=str(tmp_path)) for word in COMMANDS[command].split()]
    for number, odd in (
        (1, name),
        (words.index("--out") + 1 if "--out" in words else -1, str(tmp_path / "sub" / name)),
    ):
        if number < 0 or (number > 1 and command == "diagnose"):  # which takes long where all is well
            continue
        code, told = program([*words[:number], odd, *words[number + 1 :]])
        assert code in ((2,) if number == 1 or len(name) > 255 else (0, 1)), told
        for character in ("\x1b", "\u202e", "\udcff"):
            assert character not in told
        if "\n" in name:
            assert name not in told
        if code == 2:
            assert all(line.startswith("trueaxis: ") for line in told.splitlines())
    assert leftovers(tmp_path) == []


def test_a_name_with_nul_is_a_fault(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="is not a file name"):
        write_files({tmp_path / "a\0b": "new"})


@pytest.mark.parametrize("command", ["predict", "compensate", "identify", "derive"])
def test_a_full_disk_names_the_output_and_leaves_nothing(prepared: Path, tmp_path: Path, command: str) -> None:
    """A file that may not grow stands for a disk that is full: both fail while the output is written."""
    before = sorted(tmp_path.rglob("*"))
    done = run(
        prepared,
        COMMANDS[command].format(out=tmp_path),
        env={"TRUEAXIS_BACKEND": "numpy", "PYTHONDONTWRITEBYTECODE": "1"},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (10, 10)),
    )
    assert done.returncode == 2, done.stdout + done.stderr
    (line,) = done.stderr.splitlines()
    assert line.startswith(f"trueaxis: {tmp_path}/")
    assert line.endswith(os.strerror(errno.EFBIG))
    assert ".trueaxis-" not in line
    assert sorted(tmp_path.rglob("*")) == before


@pytest.mark.skipif(sys.platform != "linux" or os.geteuid() != 0, reason="a disk of one page is mounted")
def test_a_disk_that_is_full(prepared: Path, tmp_path: Path, program: Program) -> None:
    disk = tmp_path / "disk"
    disk.mkdir()
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=4k", "none", str(disk)], check=False)
    if mounted.returncode:
        pytest.skip("no disk can be mounted here")
    try:
        (disk / "i.json").write_text("old")
        code, told = program(COMMANDS["identify"].format(out=disk).split())
        assert code == 2
        (line,) = told.splitlines()
        assert line.startswith(f"trueaxis: {disk}/")
        assert line.endswith(": No space left on device")
        assert [path.name for path in disk.iterdir()] == ["i.json"]
        assert (disk / "i.json").read_text() == "old"
        done = run(prepared, COMMANDS["predict"].format(out=tmp_path), env={"TRUEAXIS_CACHE": str(disk / "cache")})
        assert done.returncode == 0
        assert "running on NumPy" in done.stderr
        assert leftovers(disk) == []
    finally:
        subprocess.run(["umount", str(disk)], check=True)


class TestSweeping:
    def test_what_a_killed_run_left_is_removed_by_the_next(self, tmp_path: Path) -> None:
        code = (
            "import os, sys; from pathlib import Path; from trueaxis.io.files import OutputFiles\n"
            "OutputFiles().open(Path(sys.argv[1])).write(b'x' * 10**6); os.kill(os.getpid(), 9)"
        )
        subprocess.run([sys.executable, "-c", code, str(tmp_path / "a")], check=False)
        assert len(leftovers(tmp_path)) == 1
        write_files({tmp_path / "b": "b"})
        assert [path.name for path in tmp_path.iterdir()] == ["b"]

    def test_what_a_running_process_holds_stays(self, tmp_path: Path) -> None:
        with OutputFiles() as first:
            first.open(tmp_path / "a").write(b"a")
            write_files({tmp_path / "b": "b"})
            first.commit()
        assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "b"]
        with staged_folder(tmp_path) as folder:
            sweep(tmp_path)
            assert folder.is_dir()
        assert not folder.exists()

    @pytest.mark.parametrize("moment", ["before it is opened", "before it is locked", "while it is locked"])
    def test_a_new_folder_that_another_run_takes_is_made_again(
        self, tmp_path: Path, moment: str, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        real_mkdir, real_hold = Path.mkdir, staging.hold
        lost: list[Path] = []

        def mkdir(path: Path, mode: int = 0o777) -> None:
            real_mkdir(path, mode)
            if moment == "before it is opened" and not lost:
                lost.append(path)
                sweep(tmp_path)

        def hold(handle: int) -> bool:
            if moment == "before it is opened" or lost:
                return real_hold(handle)
            lost.extend(tmp_path.iterdir())
            if moment == "before it is locked":
                sweep(tmp_path)
                return real_hold(handle)
            return False

        monkeypatch.setattr(Path, "mkdir", mkdir)
        monkeypatch.setattr(staging, "hold", hold)
        with staged_folder(tmp_path) as folder:
            assert folder not in lost
            sweep(tmp_path)
            (folder / "file").write_text("in it")
        assert len(lost) == 1
        assert list(tmp_path.iterdir()) == []

    def test_folders_that_others_keep_taking_are_a_fault(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(staging, "hold", lambda _: False)
        with pytest.raises(TimeoutError, match="keep taking"), staged_folder(tmp_path):
            pass
        assert list(tmp_path.iterdir()) == []

    @pytest.mark.parametrize("case", ["no links", "held by another run"])
    def test_the_old_file_is_held_until_all_is_done(
        self, tmp_path: Path, case: str, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        real = Path.replace
        a, b = tmp_path / "a", tmp_path / "b"
        a.write_text("old a")
        a.chmod(0o640)

        def no_link(*_: object) -> None:
            raise PermissionError(errno.EPERM, os.strerror(errno.EPERM))

        def replace(path: Path, target: Path) -> Path:
            if target == b:
                if other is not None:
                    other.close()
                sweep(tmp_path)  # of another run
                raise OSError(errno.EIO, os.strerror(errno.EIO))
            return real(path, target)

        other = a.open() if case == "held by another run" else None
        if other is None:
            monkeypatch.setattr(os, "link", no_link)
        else:
            assert staging.hold(other.fileno())
        monkeypatch.setattr(Path, "replace", replace)
        with pytest.raises(OSError, match=os.strerror(errno.EIO)):
            write_files({a: "new a", b: "new b"})
        assert a.read_text() == "old a"
        assert stat.S_IMODE(a.stat().st_mode) == 0o640
        assert list(tmp_path.iterdir()) == [a]

    def test_files_of_the_user_stay(self, tmp_path: Path) -> None:
        names = [".trueaxis-notes.tmp", ".trueaxis-0123456789abcdef.tmp.txt", "trueaxis-0123456789abcdef.tmp", ".x.tmp"]
        for name in names:
            (tmp_path / name).write_text("of the user")
        (tmp_path / "target").write_text("of the user")
        (tmp_path / ".trueaxis-0123456789abcdef.tmp").symlink_to("target")
        sweep(tmp_path)
        assert all((tmp_path / name).exists() for name in (*names, "target"))

    def test_many_writers_and_sweepers_lose_nothing(self, tmp_path: Path) -> None:
        failures: list[BaseException] = []

        def write(number: int) -> None:
            try:
                for turn in range(20):
                    write_files({tmp_path / f"{number}": f"{turn}" * 1000, tmp_path / "shared": f"{number}" * 1000})
            except BaseException as error:
                failures.append(error)

        threads = [threading.Thread(target=write, args=(number,)) for number in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert failures == []
        assert sorted(path.name for path in tmp_path.iterdir()) == [*map(str, range(4)), "shared"]
        assert all((tmp_path / str(number)).read_text() == "19" * 1000 for number in range(4))
        assert len(set((tmp_path / "shared").read_text())) == 1

    def test_a_name_is_never_that_of_another(self, tmp_path: Path) -> None:
        from contextlib import ExitStack

        with ExitStack() as undo:
            path, handle = staged_file(tmp_path, undo)
            assert stat.S_IMODE(os.fstat(handle).st_mode) & 0o600 == 0o600
            os.close(handle)
            assert path != staged_name(tmp_path)
        assert not path.exists()


def test_no_module_writes_files_by_another_way() -> None:
    writers = {"files.py", "staging.py", "compiler.py"}
    for path in (ROOT / "src").rglob("*.py"):
        if path.name not in writers or path.parent.name == "compensate":
            text = path.read_text()
            # an empty folder in which LinuxCNC's interpreter runs, one in which worker processes keep what is theirs
            if path.parts[-2:] == ("linuxcnc", "interpreter.py") or path.parts[-2:] == ("cluster", "workers.py"):
                text = text.replace("tempfile", "")
            for word in (".write_text(", ".write_bytes(", "tempfile", '.open("w', ".mkdir(", "shutil.copy", ".unlink("):
                assert word not in text, f"{path}: {word}"
