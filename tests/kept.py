"""What is derived from a spec once, by the first process of any test run that needs it, and kept for all others."""

import contextlib
import hashlib
import io
import os
import shutil
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

import sympy as sp

from trueaxis.cli.main import main

ROOT = Path(__file__).resolve().parent.parent
# "jobs" and "cli": `derived` runs the command
DERIVING = ("machine", "derivation", "codegen", "effects", "io", "jobs", "cli")
KEPT = Path(tempfile.gettempdir()) / f"trueaxis-tests-{getattr(os, 'getuid', int)()}"


def kept(what: str, text: str, write: Callable[[Path], object]) -> Path:
    """The folder that `write` fills with `what` from the text of a spec; nothing in it may be changed.

    Its name stands for the text and for the code that derives, so that no change of either meets old files.
    """
    stamp = hashlib.sha256(f"{what}\n{text}".encode() + _deriving_code())
    folder = KEPT / stamp.hexdigest()[:20]
    if not folder.exists():
        KEPT.mkdir(mode=0o700, exist_ok=True)
        begun = Path(tempfile.mkdtemp(dir=KEPT))
        try:
            write(begun)
            with contextlib.suppress(OSError):  # where another process was faster
                begun.rename(folder)
        finally:
            shutil.rmtree(begun, ignore_errors=True)
    return folder


def derived(spec: Path) -> Path:
    """What `trueaxis derive` writes of a spec without runs, for --kernels; nothing in it may be changed."""

    def write(folder: Path) -> None:
        with contextlib.redirect_stdout(io.StringIO()):
            if main(["derive", str(spec), "--out", str(folder)]) != 0:
                raise RuntimeError(f"{spec} could not be derived")

    return kept("derive", spec.read_text(), write)


@cache
def _deriving_code() -> bytes:
    """What files depend on besides the spec, read once per process."""
    source = ROOT / "src" / "trueaxis"
    parts = [path for part in DERIVING for path in (source / part).rglob("*.py")]
    paths = (*sorted(source.glob("*.py")), *sorted(parts), *sorted((ROOT / "templates").iterdir()))
    return b"".join([str(sp.__version__).encode(), *(path.read_bytes() for path in paths)])
