"""Loading generated kernels: only those of this machine and this runtime, and what to run for others."""

from pathlib import Path

import numpy as np
import pytest

from tests.kernels import model_of
from tests.machines import DMU60P, machine_at, machine_of
from trueaxis.emit.meta import ABI as EMITTED_ABI
from trueaxis.emit.render import render
from trueaxis.faults import InputError
from trueaxis.files import write_files
from trueaxis.runtime.kernels import ABI, Kernels, load_kernels
from trueaxis.spec import Machine


@pytest.fixture(scope="module")
def files() -> dict[str, bytes]:
    return render(model_of(DMU60P.read_text()))


@pytest.fixture
def folder(tmp_path: Path, files: dict[str, bytes]) -> Path:
    write_files({tmp_path / "dmu60p" / name: content for name, content in files.items()})
    return tmp_path


def load(folder: Path, machine: Machine | None = None, backend: str = "numpy") -> Kernels:
    return load_kernels(machine or machine_at(DMU60P), Path("machines/dmu60p.toml"), folder, backend=backend)


def fault_of(folder: Path, machine: Machine | None = None) -> str:
    with pytest.raises(InputError) as caught:
        load(folder, machine)
    (fault,) = caught.value.faults
    assert str(fault).endswith(f"; run: trueaxis derive machines/dmu60p.toml --out {folder}")
    return str(fault)


def changed(folder: Path, old: str, new: str) -> None:
    path = folder / "dmu60p" / "kernels.py"
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def test_emitter_and_loader_are_of_one_abi() -> None:
    assert ABI == EMITTED_ABI


def test_loaded_kernels_compute(folder: Path) -> None:
    kernels = load(folder)
    point = np.array([[1.0], [2.0], [3.0]])
    ideal = kernels["tool_in_workpiece_ideal"](np.array([[10.0], [20.0], [30.0]]), np.zeros(9), point)
    np.testing.assert_array_equal(ideal[:, 0], [11, -18, 33])
    assert "correction" in kernels
    assert "no_such_kernel" not in kernels
    assert kernels.backend == "numpy"
    assert set(kernels.routines) == set(kernels.meta["routines"])


def test_missing_kernels(tmp_path: Path) -> None:
    assert "there are no kernels of this machine" in fault_of(tmp_path)


def test_kernels_of_another_abi(folder: Path) -> None:
    changed(folder, f"ABI = {ABI}\n", f"ABI = {ABI + 1}\n")
    assert f"ABI: is {ABI + 1}, not {ABI}" in fault_of(folder)


def test_kernels_of_another_spec(folder: Path) -> None:
    other = machine_of(DMU60P.read_text().replace("540.0", "541.0"))
    assert "SPEC_HASH: is not that of machines/dmu60p.toml as it is now" in fault_of(folder, other)


def test_references_and_layout_of_a_spec_leave_its_kernels_good(folder: Path) -> None:
    text = DMU60P.read_text().replace('motion_X = "Eq. (12)"', 'motion_X = "elsewhere"').replace("540.0", "540")
    assert load(folder, machine_of("# a comment\n" + text))


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("import numpy as np", "import numpy as", "SyntaxError"),
        ("import numpy as np", "import no_such_module as np", "ModuleNotFoundError"),
        ("META = {", "META = 1 / 0 + {", "ZeroDivisionError"),
        ("META = {", "OTHER = {", "META"),
        ("def correction(", "def correction_(", "correction"),
    ],
)
def test_damaged_kernels(folder: Path, old: str, new: str, told: str) -> None:
    changed(folder, old, new)
    assert told in fault_of(folder)


def test_kernels_written_again_within_a_second_are_the_new_ones(folder: Path) -> None:
    # Python's own bytecode cache goes by size and whole seconds; a changed hash keeps both.
    load(folder)
    other = machine_of(DMU60P.read_text().replace("540.0", "541.0"))
    changed(folder, machine_at(DMU60P).digest, other.digest)
    assert load(folder, other)
    assert sorted(path.name for path in (folder / "dmu60p").iterdir()) == sorted(
        ("kernels.py", "kernels.c", "kernels.h", "equations.md", "manifest.json")
    )
