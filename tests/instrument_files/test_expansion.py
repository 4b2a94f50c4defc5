"""Readings normalised to 20 degC at import: by hand, undone and redone, never twice, and asked for."""

from pathlib import Path

import numpy as np
import pytest

from tests.instrument_files.test_import import LONG_AXIS, SHAPE, imported, refused
from tests.instrument_files.writers import rtl

ALWAYS = ["target.point=0,0,0", "at.Y=0", "at.Z=0"]
TARGETS = np.array(LONG_AXIS)
WARM = 1e-3 * SHAPE + 11.5e-6 * 2.4 * TARGETS  # mm, as a laser reads it at 22.4 degC


def written(path: Path, reading: np.ndarray) -> Path:
    path.write_bytes(rtl(LONG_AXIS, 1e3 * reading[np.newaxis], axis="X", digits=9).encode())
    return path


@pytest.mark.parametrize("applied", [0.0, 10.0, 11.5])
def test_what_the_instrument_did_is_undone_and_the_axis_s_own_done_once(tmp_path: Path, applied: float) -> None:
    reading = WARM - applied * 1e-6 * 2.4 * TARGETS
    file = written(tmp_path / "x.rtl", reading)
    keys = [*ALWAYS, "expansion.X=11.5", f"normalised={applied}", "temperature=22.4"]
    data = imported(tmp_path / "data", file, "--map", *keys)
    np.testing.assert_allclose(data.readings.reading, 1e-3 * SHAPE, atol=1e-10)
    assert data.setup.runs[0].normalised == 11.5
    text = (tmp_path / "data" / "setup.toml").read_text()
    assert "normalised to 20 degC by 11.5e-6/K, at 22.4 degC" in text
    assert ("of which the instrument had done" in text) == (applied > 0.0)


def test_readings_stay_as_they_are_where_no_coefficient_is_given(tmp_path: Path) -> None:
    data = imported(tmp_path / "data", written(tmp_path / "x.rtl", WARM), "--map", *ALWAYS)
    np.testing.assert_allclose(data.readings.reading, WARM, atol=1e-12)
    assert data.setup.runs[0].normalised is None


def test_the_way_counts_from_home_and_with_the_sense_of_the_direction(tmp_path: Path) -> None:
    back = written(tmp_path / "x.rtl", -WARM)
    keys = [*ALWAYS, "direction=-1,0,0", "expansion.X=11.5", "normalised=0", "temperature=22.4"]
    data = imported(tmp_path / "data", back, "--map", *keys)
    np.testing.assert_allclose(data.readings.reading, -1e-3 * SHAPE, atol=1e-10)


def test_temperatures_of_a_table_are_those_of_its_rows(tmp_path: Path) -> None:
    warm = np.linspace(20.0, 24.0, TARGETS.size)
    reading = 1e-3 * SHAPE + 11.5e-6 * (warm - 20.0) * TARGETS
    rows = "\n".join(
        f"{x};{1e3 * r!r};{t!r}" for x, r, t in zip(LONG_AXIS, reading.tolist(), warm.tolist(), strict=True)
    )
    (tmp_path / "x.csv").write_text(f"target [mm];deviation [um];temperature [degC]\n{rows}\n")
    keys = [*ALWAYS, "axis=X", "expansion.X=11.5", "normalised=0"]
    data = imported(tmp_path / "data", tmp_path / "x.csv", "--map", *keys)
    np.testing.assert_allclose(data.readings.reading, 1e-3 * SHAPE, atol=1e-10)


def test_what_is_not_known_is_asked_for_and_what_stands_across_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = written(tmp_path / "x.rtl", WARM)
    told = refused(tmp_path / "out", capsys, file, "--map", *ALWAYS, "expansion.X=11.5")
    assert "--map normalised=0" in told
    assert "--map temperature=21.5" in told
    keys = [*ALWAYS, "expansion.X=11.5", "normalised=0", "temperature=22.4"]
    assert "a run along the axis" in refused(tmp_path / "out", capsys, file, "--map", *keys, "direction=0,1,0")
    keys[-3] = "expansion.X=2000"
    assert "from 0 to 100" in refused(tmp_path / "out", capsys, file, "--map", *keys)
    assert "is no key that these files ask for" in refused(
        tmp_path / "out", capsys, file, "--map", *ALWAYS, "normalised=0"
    )
