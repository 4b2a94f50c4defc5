"""Folders full of modules, headers and compilers that leave a note when they are run: nothing of ours may run them."""

import sys
from pathlib import Path

EVIL = "import os\nopen(os.environ['EVIDENCE'], 'a').write(__name__ + '\\n')\n"
# what the program, its children and its libraries import; Python's own start is done before any of our code runs
MODULES = sorted(
    {*sys.stdlib_module_names, "numpy", "polars", "scipy", "sympy", "jinja2", "matplotlib", "statsmodels", "pandas"}
    | {"polars_runtime_32", "_polars_runtime_32", "PIL", "trueaxis", "kernels", "usercustomize", "sitecustomize"}
    | {"latex2mathml", "mpmath", "markupsafe", "evil"}
)


def make_hostile(*folders: Path) -> None:
    """Put them into folders, made where there are none. What runs there has the name of a file in $EVIDENCE."""
    for place in folders:
        place.mkdir(parents=True, exist_ok=True)
        for name in MODULES:
            (place / f"{name}.py").write_text(EVIL)
        (place / "matplotlibrc").write_bytes(b"\xff\xfe")  # no settings that Matplotlib can read
        for name in ("cc", "gcc", "clang", "as", "ld"):
            (place / name).write_text("#!/bin/sh\necho compiler >> $EVIDENCE\nexit 1\n")
            (place / name).chmod(0o755)
        (place / "math.h").write_text("#error the header of a data folder\n")


def run_of(evidence: Path) -> list[str]:
    """What was run of it."""
    return sorted(set(evidence.read_text().split())) if evidence.exists() else []
