"""Set up trueaxis in a folder of its own (.venv) and run it, on a fresh machine with Python 3.11 or later.

    python3 dev.py demo     set up, then the main job: results and pictures in results/
    python3 dev.py test     set up, then the tests
    python3 dev.py site     set up, then the documentation, into build/site
    python3 dev.py setup    set up for development, nothing more

Further arguments go to `trueaxis demo`, to pytest or to MkDocs. Only the standard library is used here.
"""

import hashlib
import os
import subprocess
import sys
import venv
from pathlib import Path

HERE = Path(__file__).resolve().parent
VENV = HERE / ".venv"
BIN = VENV / ("Scripts" if sys.platform == "win32" else "bin")
# Tests run side by side: each is to keep to its own processor. Modules are compiled once, not by each process that a
# test starts, whatever the user has set.
ENVIRONMENT = os.environ | {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "NO_MKDOCS_2_WARNING": "1"}
ENVIRONMENT |= {"PYTHONDONTWRITEBYTECODE": ""}
LOCKS = {"demo": "run.txt", "test": "dev.txt", "site": "dev.txt", "setup": "dev.txt"}


def main(arguments: list[str]) -> int:
    """Set up, then run what was asked for. Returns its exit code."""
    if sys.version_info < (3, 11):  # noqa: UP036  this script runs before anything is known to fit
        print("trueaxis needs Python 3.11 or later, this is " + sys.version.split()[0], file=sys.stderr)
        return 2
    if not arguments or arguments[0] not in LOCKS:
        print(__doc__, file=sys.stderr)
        return 2
    task, rest = arguments[0], arguments[1:]
    set_up(HERE / "locks" / LOCKS[task])
    if task == "demo":
        return run(BIN / "trueaxis", "demo", *rest)
    if task == "test":
        return run_tests(rest)
    if task == "site":
        return run(BIN / "python", "-m", "mkdocs", "build", *rest)
    activate = BIN / "activate" if BIN.name == "bin" else BIN / "Activate.ps1"
    print(f"{VENV.name} is ready; next: {'source ' if BIN.name == 'bin' else ''}{activate.relative_to(HERE)}")
    print("then trueaxis --help; bash .ci/run is what must pass of a change (CONTRIBUTING.md)")
    return 0


def set_up(lock: Path) -> None:
    """Install the locked packages and the project in place, unless that has been done for these very locks."""
    stamp = VENV / f"installed-{lock.stem}"
    state = hashlib.sha256(lock.read_bytes() + (HERE / "pyproject.toml").read_bytes()).hexdigest()
    if stamp.is_file() and stamp.read_text() == state:
        return
    print(f"setting up {VENV.name} from locks/{lock.name} (once; a few minutes) ...", flush=True)
    if not (BIN / "pip").exists() and not (BIN / "pip.exe").exists():
        venv.create(VENV, with_pip=True)
    pip = [str(BIN / "python"), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    subprocess.run([*pip, "--require-hashes", "-r", str(lock)], check=True)
    subprocess.run([*pip, "--no-deps", "--no-build-isolation", "--editable", str(HERE)], check=True)
    stamp.write_text(state)


def run_tests(rest: list[str]) -> int:
    """With arguments: pytest with them. Without: all tests, which are to cover the code (tests/covered.py)."""
    pytest = (BIN / "python", "-m", "pytest")
    if rest:
        return run(*pytest, *rest)
    # Tests of a file share what is dear to make; files that take long come first (tests/conftest.py). One worker more
    # than there are processors: there is always one that waits, for a simulator or a process.
    workers = str((os.cpu_count() or 1) + 1)
    parallel = ("-n", workers, "--dist", "loadfile", "--no-loadscope-reorder", "-q", "--durations", "25")
    return run(*pytest, *parallel, PYTEST_PLUGINS="tests.covered")


def run(*command: object, **environment: str) -> int:
    """Run in this folder, with more in its environment; its exit code."""
    words = [str(part) for part in command]
    return subprocess.run(words, cwd=HERE, env=ENVIRONMENT | environment, check=False).returncode


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except subprocess.CalledProcessError as error:
        print(f"setting up failed: {' '.join(error.cmd)}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        sys.exit(130)
