"""Compile the C kernels of a machine once, into a cache of the user's own."""

import hashlib
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

# Contraction (fused multiply-add) is the one licence taken with the arithmetic: it rounds less, not more. Without errno
# a root is one instruction. -ffast-math is not given: its sums in another order would not keep the last digits.
FLAGS = ("-std=c17", "-O3", "-fno-math-errno", "-ffp-contract=fast", "-fPIC", "-shared")
NATIVE = "-march=native"  # dropped where a compiler does not know it

_COMPILERS = ("cc", "gcc", "clang")
_SECONDS = 300
_CPU_LINES = ("vendor_id", "cpu family", "model", "stepping", "flags", "Features", "CPU implementer", "CPU part")


@dataclass(frozen=True, slots=True)
class Compilation:
    """The compiled library; or None, and the reason in words that end no sentence."""

    library: Path | None
    reason: str = ""


def compile_kernels(source: Path) -> Compilation:
    """The shared library of kernels.c (with kernels.h beside it), compiled unless the cache has it.

    The cache is $TRUEAXIS_CACHE, else the user's cache folder; its entries are named by the content of the source, the
    flags, the compiler's version and the processor. Any number of processes may do this at once.
    """
    try:
        compiler = find_compiler()
        if compiler is None:
            return Compilation(None, f"no C compiler found ({_looked_for()})")
        texts = {name: source.with_name(name).read_bytes() for name in (source.name, "kernels.h")}
        library = _private_folder(_cache_root()) / f"{_key(texts, compiler)}{_suffix()}"
        if library.is_file():
            return Compilation(library)
        return _compile(compiler, texts, source.name, library)
    except subprocess.TimeoutExpired:
        return Compilation(None, f"the C compiler took longer than {_SECONDS} s")
    except (OSError, RuntimeError) as error:  # a folder that cannot be written, a user without a home
        return Compilation(None, f"the C kernels cannot be compiled: {error}")


def find_compiler() -> tuple[str, ...] | None:
    """The words of $CC if it is set, else cc, gcc or clang; None where there is none. The first is a full path."""
    asked = shlex.split(os.environ.get("CC", ""))
    for words in [asked] if asked else [[name] for name in _COMPILERS]:
        if path := shutil.which(words[0]):
            return (path, *words[1:])
    return None


def _looked_for() -> str:
    asked = os.environ.get("CC", "").strip()
    return f"CC is {asked}" if asked else f"looked for {', '.join(_COMPILERS)}"


def _cache_root() -> Path:
    if named := os.environ.get("TRUEAXIS_CACHE"):
        return Path(named)
    if sys.platform == "win32":
        base = os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local"
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Caches"
    else:
        base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(base) / "trueaxis"


def _private_folder(root: Path) -> Path:
    """The folder of the libraries: they will be run, so nobody else may write there."""
    folder = root.absolute() / "kernels"
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    if sys.platform != "win32":
        status = folder.stat()
        if status.st_uid != os.geteuid() or status.st_mode & 0o022:
            raise PermissionError(f"others can write to the cache folder {folder}")
    return folder


def _key(texts: dict[str, bytes], compiler: Sequence[str]) -> str:
    version = _run([*compiler, "--version"]).stdout
    parts = (*texts.values(), *(word.encode() for word in (*compiler, *FLAGS, NATIVE, _processor())), version.encode())
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


def _compile(compiler: Sequence[str], texts: dict[str, bytes], main: str, library: Path) -> Compilation:
    """Compile copies in a folder of our own, then move the library into place, whole."""
    with tempfile.TemporaryDirectory(prefix="compile-", dir=library.parent) as name:
        folder = Path(name)
        for file, text in texts.items():
            (folder / file).write_bytes(text)
        output = folder / library.name
        arguments = [str(folder / main), "-o", str(output), "-lm"]
        for flags in ((*FLAGS, NATIVE), FLAGS):
            done = _run([*compiler, *flags, *arguments])
            if done.returncode == 0 and output.is_file():
                output.replace(library)
                return Compilation(library)
    return Compilation(None, f"{compiler[0]} cannot compile {main}: {_first_error(done.stderr)}")


def _run(command: Sequence[str]) -> subprocess.CompletedProcess[str]:
    environment = os.environ | {"LC_ALL": "C"}
    return subprocess.run(
        command,
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        errors="replace",
        timeout=_SECONDS,
        check=False,
    )


def _first_error(text: str) -> str:
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return next((line for line in lines if "error" in line), lines[0] if lines else "no message")
