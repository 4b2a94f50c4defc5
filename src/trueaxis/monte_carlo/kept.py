"""Results of draws that are kept, so that what was stopped goes on where it was."""

import hashlib
from io import BytesIO
from pathlib import Path
from zipfile import BadZipFile

import numpy as np

from trueaxis.model.curves import FloatArray
from trueaxis.monte_carlo.drawn import STATISTICS, Drawn
from trueaxis.monte_carlo.settings import Draws


def kept_name(version: str, draws: Draws, sample: FloatArray, value: FloatArray, u: FloatArray) -> str:
    """The name of the file of these results.

    version: of the program; sample: (m, 4, n), the first draws, which another model, other values, points or settings
    would change; value, u: (3, n), of linear propagation, mm.
    """
    digest = hashlib.sha256(f"{version} {draws.count} {draws.seed} {sample.shape}".encode())
    for array in (sample, value, u):
        digest.update(np.ascontiguousarray(array).tobytes())
    return f"{digest.hexdigest()}.npz"


def dump_kept(drawn: Drawn) -> bytes:
    """The content of that file."""
    buffer = BytesIO()
    np.savez(buffer, count=np.int64(drawn.count), **{name: getattr(drawn, name) for name in STATISTICS})
    return buffer.getvalue()


def read_kept(path: Path) -> Drawn | None:
    """None where there is none, or it is damaged: it is drawn again then."""
    try:
        with np.load(BytesIO(path.read_bytes()), allow_pickle=False) as file:
            return Drawn(count=int(file["count"]), **{name: file[name] for name in STATISTICS})
    except (OSError, ValueError, KeyError, EOFError, BadZipFile):
        return None
