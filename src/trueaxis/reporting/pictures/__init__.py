"""Pictures as PNG bytes; the program's state is read, never changed.

Matplotlib takes a file matplotlibrc of the current folder for its own and stops where that or MPLBACKEND is wrong. It
is therefore loaded here, before any module of this package uses it, with its own defaults and away from the data.
"""

import os
from contextlib import chdir, suppress
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path


def _load_matplotlib() -> None:
    spec = find_spec("matplotlib")
    assert spec is not None
    assert spec.origin is not None
    package = Path(spec.origin).parent
    settings = {"MPLBACKEND": "agg", "MATPLOTLIBRC": str(package / "mpl-data" / "matplotlibrc")}
    before = {name: os.environ.pop(name) for name in settings if name in os.environ}
    os.environ.update(settings)
    try:
        with suppress(FileNotFoundError), chdir(package):  # or the current folder was removed
            import_module("matplotlib")
    finally:
        for name in settings:
            del os.environ[name]
        os.environ.update(before)


_load_matplotlib()
