"""Compile the C kernels of a machine once, into a cache of the user's own."""

import contextlib
import hashlib
import os
import platform
import shlex
import shutil
import signal
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from trueaxis.io.faults import Fault, InputError
from trueaxis.io.staging import staged_folder, sweep

# Contraction (fused multiply-add) is the one licence taken with the arithmetic: it rounds less, not more. Without errno
# a root is one instruction. -ffast-math is not given: its sums in another order would not keep the last digits.
FLAGS = ("-std=c17", "-O3", "-fno-math-errno", "-ffp-contract=fast", "-fPIC", "-shared")
SOURCE = "kernels.c"  # which includes kernels.h
NATIVE = "-march=native"  # dropped where a compiler does not know it

_COMPILERS = ("cc", "gcc", "clang")
_SECONDS = 300
_VARIABLE = "environment variable"  # how a fault names one
_CPU_LINES = ("vendor_id", "cpu family", "model", "stepping", "flags", "Features", "CPU implementer", "CPU part")


@dataclass(frozen=True, slots=True)
class Compilation:
    """The compiled library; or None, and the reason in words that end no sentence."""

    library: Path | None
    reason: str = ""


def compile_kernels(code: Mapping[str, bytes]) -> Compilation:
    """The shared library of kernels.c, compiled unless the cache has it.

    code: the content of kernels.c and kernels.h by these names. It is compiled as given and not read from files, which
    may have changed since they were checked.
    The cache is $TRUEAXIS_CACHE, else the user's cache folder; its entries are named by the content of the source, the
    flags, the compiler's version and the processor, and by their own content, which is compared before they are used.
    Any number of processes may do this at once.
    Raises InputError where CC or TRUEAXIS_CACHE is set to what cannot be meant.
    """
    compiler = find_compiler()
    if compiler is None:
        return Compilation(None, f"no C compiler found ({_looked_for()})")
    try:
        root = _cache_root()
        folder = _private_folder(root)
        key = _key(code, compiler, folder)
        if library := _cached(folder, key):
            return Compilation(library)
        return _compile(compiler, code, folder, key)
    except subprocess.TimeoutExpired:
        return Compilation(None, f"the C compiler took longer than {_SECONDS} s")
    except (OSError, RuntimeError) as error:  # a folder that cannot be written, a full disk, a user without a home
        return Compilation(None, f"the C kernels cannot be compiled: {error}")


def find_compiler() -> tuple[str, ...] | None:
    """The words of $CC if it is set, else cc, gcc or clang; None where there is none. The first is a full path.

    Entries of PATH that are not absolute are passed over: they would mean the folder that the program is used in.
    Raises InputError where $CC cannot be split into words.
    """
    try:
        asked = shlex.split(os.environ.get("CC", ""))
    except ValueError as error:
        problem = f"{os.environ['CC']} cannot be split into words: {error}"
        raise InputError([Fault(f"{_VARIABLE} CC", "", problem, "a command such as gcc -m64")]) from None
    search = os.pathsep.join(entry for entry in os.get_exec_path() if Path(entry).is_absolute())
    for words in [asked] if asked else [[name] for name in _COMPILERS]:
        if path := shutil.which(words[0], path=search):
            return (str(Path(path).absolute()), *words[1:])
    return None


def _looked_for() -> str:
    asked = os.environ.get("CC", "").strip()
    return f"CC is {asked}" if asked else f"looked for {', '.join(_COMPILERS)}"


def _cache_root() -> Path:
    """Where the cache is. Raises RuntimeError for a user without a home."""
    if named := os.environ.get("TRUEAXIS_CACHE"):
        root = Path(named)
        # from a relative one, the code of whatever folder the program is used in would be run
        problem = "" if root.is_absolute() else "is not an absolute path"
        if root.exists() and not root.is_dir():
            problem = "is not a folder"
        if problem:
            remedy = "an absolute path of a folder, which need not exist"
            raise InputError([Fault(f"{_VARIABLE} TRUEAXIS_CACHE", "", f"{named} {problem}", remedy)])
        return root
    from platformdirs import user_cache_dir  # noqa: PLC0415  only where kernels are compiled

    return Path(user_cache_dir("trueaxis", appauthor=False, opinion=False))


def _private_folder(root: Path) -> Path:
    """The folder of the libraries: they will be run, so nobody else may write there."""
    folder = root.absolute() / "kernels"
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    if sys.platform != "win32":
        status = folder.stat()
        if status.st_uid != os.geteuid() or status.st_mode & 0o022:
            raise PermissionError(f"others can write to the cache folder {folder}")
    return folder


def _key(code: Mapping[str, bytes], compiler: Sequence[str], folder: Path) -> str:
    version = _run([*compiler, "--version"], folder).stdout
    parts = (
        *(code[name] for name in sorted(code)),
        *(word.encode() for word in (*compiler, *FLAGS, NATIVE, _processor())),
        version.encode(),
    )
    return hashlib.sha256(b"".join(hashlib.sha256(part).digest() for part in parts)).hexdigest()[:32]


def _processor() -> str:
    """What -march=native depends on, as far as it can be learnt without the compiler."""
    known = f"{platform.machine()} {platform.processor()}"
    try:
        first = Path("/proc/cpuinfo").read_text(errors="replace").split("\n\n", 1)[0]
    except OSError:  # not Linux
        return known
    return known + "".join(line for line in first.splitlines() if line.split("\t")[0].split(":")[0] in _CPU_LINES)


def _suffix() -> str:
    return ".dll" if sys.platform == "win32" else ".so"


def _cached(folder: Path, key: str) -> Path | None:
    """The library of this key whose content is that which its name says; others, damaged ones, are removed."""
    for library in sorted(folder.glob(f"{key}-*{_suffix()}")):
        try:
            if library.name == _library_name(key, library.read_bytes()):
                return library
            library.unlink()
        except FileNotFoundError:  # another process has removed it
            continue
    return None


def _library_name(key: str, content: bytes) -> str:
    return f"{key}-{hashlib.sha256(content).hexdigest()[:32]}{_suffix()}"


def _compile(compiler: Sequence[str], code: Mapping[str, bytes], cache: Path, key: str) -> Compilation:
    """Compile the code in a folder of our own, then move the library into place, whole."""
    sweep(cache)
    with staged_folder(cache) as folder:
        for name, content in code.items():
            (folder / name).write_bytes(content)
        output = folder / f"kernels{_suffix()}"
        arguments = [str(folder / SOURCE), "-o", str(output), "-lm"]
        for flags in ((*FLAGS, NATIVE), FLAGS):
            # in that folder: empty entries of variables such as CPATH mean the folder that the compiler is run in
            done = _run([*compiler, *flags, *arguments], folder)
            if done.returncode == 0 and output.is_file():
                return Compilation(_kept(output, cache, key))
    return Compilation(None, f"{compiler[0]} cannot compile {SOURCE}: {_first_error(done.stderr)}")


def _kept(output: Path, cache: Path, key: str) -> Path:
    """Move the library into the cache, once its content is on the disk."""
    with output.open("rb") as file:
        os.fsync(file.fileno())
        library = cache / _library_name(key, file.read())
    output.replace(library)
    return library


def _run(command: Sequence[str], folder: Path) -> subprocess.CompletedProcess[str]:
    """Run the compiler. Where the time limit or a signal ends it, what it has started (gcc: cc1, as) ends, too."""
    with subprocess.Popen(
        command,
        env=os.environ | {"LC_ALL": "C"},
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        errors="replace",
        start_new_session=True,  # a process group of its own; Windows has none
    ) as process:
        try:
            output, errors = process.communicate(timeout=_SECONDS)
        except BaseException:
            _kill(process)
            raise
    return subprocess.CompletedProcess(command, process.returncode, output, errors)


def _kill(process: "subprocess.Popen[str]") -> None:
    """Kill the process and its group; on Windows the process alone, as its children cannot be known for certain."""
    if sys.platform == "win32":
        process.kill()
        return
    with contextlib.suppress(ProcessLookupError, PermissionError):  # all have ended; macOS: none but zombies are left
        os.killpg(process.pid, signal.SIGKILL)


def _first_error(text: str) -> str:
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return next((line for line in lines if "error" in line), lines[0] if lines else "no message")
