"""A case put before the diagnosis, through the files that a user would have."""

import contextlib
import fcntl
import hashlib
import io
import os
import tempfile
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from tests.hidden_effects.case import Case, generate
from tests.hidden_effects.power.grade import Name, Said
from trueaxis.cli import main
from trueaxis.diagnose.procedure import diagnose
from trueaxis.diagnose.result import Diagnosis
from trueaxis.effects.kind import Effect
from trueaxis.measure.data import read_data
from trueaxis.runtime.model import load_model

ROOT = Path(__file__).resolve().parents[3]
DERIVING = ("spec", "derive", "emit", "effects")
KERNELS = Path(tempfile.gettempdir()) / f"trueaxis-hidden-effects-{os.getuid()}"


@dataclass(frozen=True)
class Bound:
    """The audit's word on one candidate, in the unit of its first parameter."""

    name: Name
    size: str
    detection: float
    isolation: float
    state: str
    rival: Name | None


def diagnosed(case: Case) -> Diagnosis:
    """The diagnosis of a case's data."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        generate(case).write(folder)
        model = load_model(folder / "machine.toml", folder / "errors.json", kernels_of(folder / "machine.toml"))
        return diagnose(model, read_data(folder / "data", model.machine))


def said_of(found: Diagnosis) -> Said:
    sets = tuple((_name(c.effect), *(_name(rival.effect) for rival in c.rivals)) for c in found.causes)
    sizes = tuple(c.parameters[0].value for c in found.causes)
    u = tuple(c.parameters[0].u for c in found.causes)
    return Said(found.verdict, sets, sizes, u, tuple(check.name for check in found.checks if check.fired))


def bounds_of(case: Case) -> tuple[Bound, ...]:
    """Limits of every candidate in data of this design and noise."""
    return tuple(
        Bound(
            _name(one.effect),
            one.size,
            one.detection,
            one.isolation,
            one.state,
            _name(one.nearest) if one.nearest else None,
        )
        for one in diagnosed(case).limits
    )


def kernels_of(spec: Path) -> Path:
    """Folder of the kernels of a spec, derived once and kept; the code that derives is part of what they depend on."""
    stamp = hashlib.sha256(spec.read_bytes() + _deriving_code())
    folder = KERNELS / stamp.hexdigest()[:20]
    KERNELS.mkdir(parents=True, exist_ok=True)
    with (KERNELS / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (folder / "done").exists():
            with contextlib.redirect_stdout(io.StringIO()):
                if main(["derive", str(spec), "--out", str(folder)]) != 0:
                    raise RuntimeError(f"{spec} could not be derived")
            (folder / "done").touch()
    return folder


@cache
def _deriving_code() -> bytes:
    """What kernels depend on besides the spec, read once per process."""
    sources = [path for part in DERIVING for path in (ROOT / "src" / "trueaxis" / part).rglob("*.py")]
    return b"".join(path.read_bytes() for path in (*sorted(sources), *sorted((ROOT / "templates").iterdir())))


def _name(effect: Effect) -> Name:
    end = effect.end if effect.end == "reference" else ""
    return Name(effect.kind, effect.component or "", effect.axis or "", tuple(sorted(effect.runs)), end or "")
