"""Loading generated kernels: only those of this machine and this runtime, and what to run for others."""

import json
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.kernels import model_of
from tests.machines import DMU60P, machine_at, machine_of
from trueaxis.codegen.meta import ABI as EMITTED_ABI
from trueaxis.codegen.render import render
from trueaxis.io.faults import InputError
from trueaxis.io.files import write_files
from trueaxis.machine import Machine
from trueaxis.model import kernels as kernels_module
from trueaxis.model.compiler import find_compiler
from trueaxis.model.kernels import ABI, Kernels, load_kernels
from trueaxis.model.manifest import CODE_FILES, MANIFEST, verified_code


@pytest.fixture(scope="module")
def files() -> dict[str, bytes]:
    return render(model_of(DMU60P.read_text()))


@pytest.fixture
def folder(tmp_path: Path, files: dict[str, bytes]) -> Path:
    write_files({tmp_path / "dmu60p" / name: content for name, content in files.items()})
    return tmp_path


def load(folder: Path, machine: Machine | None = None, backend: str = "numpy") -> Kernels:
    return load_kernels(machine or machine_at(DMU60P), Path("machines/dmu60p.toml"), folder, backend=backend)


def fault_of(folder: Path, machine: Machine | None = None, remedy: str = "--out {folder}") -> str:
    with pytest.raises(InputError) as caught:
        load(folder, machine)
    (fault,) = caught.value.faults
    assert str(fault).endswith(f"; run: trueaxis derive machines/dmu60p.toml {remedy.format(folder=folder)}")
    return str(fault)


def changed(folder: Path, old: str, new: str, file: str = "kernels.py") -> None:
    path = folder / "dmu60p" / file
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def sealed(folder: Path) -> None:
    """Write the manifest of the kernels as they are now."""
    path = folder / "dmu60p" / MANIFEST
    record = json.loads(path.read_text())
    record["files"] = {name: sha256(path.with_name(name).read_bytes()).hexdigest() for name in record["files"]}
    path.write_text(json.dumps(record))


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
    changed(folder, f'"kernel_abi": {ABI}', f'"kernel_abi": {ABI + 1}', MANIFEST)
    assert f"kernel_abi: is {ABI + 1}, not {ABI}" in fault_of(folder)


def test_kernels_of_another_spec(folder: Path) -> None:
    other = machine_of(DMU60P.read_text().replace("540.0", "541.0"))
    told = fault_of(folder, other, "--out OTHER, and give --kernels OTHER")
    assert "spec_sha256: is not that of machines/dmu60p.toml as it is now" in told


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
    sealed(folder)
    assert told in fault_of(folder)


@pytest.mark.parametrize("backend", ["numpy", "c"])
@pytest.mark.parametrize("name", CODE_FILES)
def test_no_other_content_is_run_than_was_derived(folder: Path, name: str, backend: str) -> None:
    path = folder / "dmu60p" / name
    content = path.read_bytes()
    # a constant, a comment, an end that is missing, nothing at all
    for other in (content.replace(b"1.0", b"1.5", 1), content + b"\n", content[:-100], bytes(len(content)), b""):
        if other == content:  # the header has no constant
            continue
        path.write_bytes(other)
        with pytest.raises(InputError) as caught:
            load(folder, backend=backend)
        (fault,) = caught.value.faults
        assert str(fault).startswith(f"{path}: is not as it was derived")
        assert fault.remedy == f"run: trueaxis derive machines/dmu60p.toml --out {folder}"
    path.write_bytes(content)
    assert load(folder)
    path.unlink()
    with pytest.raises(InputError, match=name):
        load(folder, backend=backend)


@pytest.mark.skipif(find_compiler() is None, reason="there is no C compiler")
@pytest.mark.parametrize("name", ["kernels.c", "kernels.h"])
def test_what_is_compiled_is_what_was_checked(
    folder: Path, name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def checked_then_changed(*args: Any, **options: Any) -> dict[str, bytes]:
        code = verified_code(*args, **options)
        path = folder / "dmu60p" / name
        path.write_bytes(b"#error changed after its check\n" + path.read_bytes())
        return code

    monkeypatch.setenv("TRUEAXIS_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(kernels_module, "verified_code", checked_then_changed)
    assert load(folder, backend="c").backend == "c"


def test_every_file_that_was_changed_is_told(folder: Path) -> None:
    for name in CODE_FILES:
        (folder / "dmu60p" / name).write_bytes(b"")
    with pytest.raises(InputError) as caught:
        load(folder)
    assert [Path(fault.file).name for fault in caught.value.faults] == list(CODE_FILES)


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"files": 3}', "[" * 100000, "\0"])
def test_a_manifest_that_is_none(folder: Path, text: str) -> None:
    (folder / "dmu60p" / MANIFEST).write_text(text)
    assert MANIFEST in fault_of(folder)
    (folder / "dmu60p" / MANIFEST).unlink()
    assert "there is no manifest of these kernels" in fault_of(folder)


def test_no_code_is_run_before_it_is_known(folder: Path, tmp_path: Path) -> None:
    changed(folder, "import numpy as np", f"open({str(tmp_path / 'run')!r}, 'w')\nimport numpy as np")
    fault_of(folder)
    assert not (tmp_path / "run").exists()


def test_a_backend_that_is_none(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TRUEAXIS_BACKEND", "fortran")
    with pytest.raises(InputError, match="TRUEAXIS_BACKEND: fortran is no backend; one of auto, c, numpy"):
        load_kernels(machine_at(DMU60P), DMU60P, folder)
    monkeypatch.setenv("TRUEAXIS_BACKEND", "")
    assert load_kernels(machine_at(DMU60P), DMU60P, folder)


def test_kernels_written_again_within_a_second_are_the_new_ones(folder: Path) -> None:
    # Python's own bytecode cache goes by size and whole seconds; a changed hash keeps both.
    load(folder)
    other = machine_of(DMU60P.read_text().replace("540.0", "541.0"))
    changed(folder, machine_at(DMU60P).digest, other.digest)
    changed(folder, machine_at(DMU60P).digest, other.digest, MANIFEST)
    sealed(folder)
    assert load(folder, other)
    assert sorted(path.name for path in (folder / "dmu60p").iterdir()) == sorted(
        ("kernels.py", "kernels.c", "kernels.h", "control.c", "control.h", "equations.md", "manifest.json")
    )
