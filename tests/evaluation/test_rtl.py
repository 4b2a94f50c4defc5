"""trueaxis evaluate of a .rtl file: the figures of the same readings in a table; what is no bidirectional test."""

import json
from pathlib import Path

import numpy as np
import pytest

from tests.evaluation.iso230_2.builders import made_up
from tests.evaluation.iso230_2.test_axes import table
from tests.instrument_files.writers import rtl
from trueaxis.cli.main import main


def deviations(cycles: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """Targets, and (runs, m) um, up and down by turns."""
    test = made_up(6, cycles)
    order = np.stack([test.positive.T, test.negative.T], axis=1).reshape(2 * cycles, -1)
    return test.targets, 1e3 * (order - test.targets)


def test_a_rtl_file_has_the_figures_of_a_table(tmp_path: Path) -> None:
    targets, off = deviations()
    (tmp_path / "x.rtl").write_bytes(rtl(targets.tolist(), off, axis="X", digits=12).encode("gbk"))
    table(tmp_path / "x.csv", made_up(6, 3))
    for name in ("x.rtl", "x.csv"):
        assert main(["evaluate", str(tmp_path / name), "--out", str(tmp_path / f"{name}.json")]) == 0
    found, right = (json.loads((tmp_path / f"{name}.json").read_text()) for name in ("x.rtl", "x.csv"))
    for figure in ("B", "B_mean", "R", "E", "M", "A"):
        assert found["bidirectional"][figure] == pytest.approx(right["bidirectional"][figure], abs=1e-9)


def test_what_is_no_bidirectional_test_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    targets, off = deviations()
    file = tmp_path / "x.rtl"

    def refused(text: str, *words: str) -> str:
        file.write_bytes(text.encode())
        assert main(["evaluate", str(file), *words]) == 2
        return capsys.readouterr().err

    assert "3 runs in the positive direction and 2 in the negative one" in refused(rtl(targets.tolist(), off[:5]))
    assert "has 1 cycle: an evaluation needs at least 2" in refused(rtl(targets.tolist(), off[:2]))
    assert "has lengths" in refused(rtl(targets.tolist(), off), "--rotary")
    mixed = targets[[0, 2, 1, 3, 4, 5]]
    assert "does not go one way" in refused(rtl(mixed.tolist(), off))
    assert "DEVIATIONS: one is " in refused(rtl(targets.tolist(), 1e4 * off))
    angles = tmp_path / "x.rta"
    angles.write_bytes(rtl(targets.tolist(), off).encode())
    assert main(["evaluate", str(angles)]) == 2
    assert "has angles" in capsys.readouterr().err
