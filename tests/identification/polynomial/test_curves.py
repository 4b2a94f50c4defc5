"""The picture of values and polynomials."""

from pathlib import Path

import numpy as np
import pytest

from trueaxis.identification.polynomial import OptimalFit, fit_optimal
from trueaxis.reporting.pictures.curves import curves_picture

COMPONENTS = [f"E{direction}{axis}" for axis in "XYZ" for direction in "XYZABC"]


def fits(count: int) -> dict[str, OptimalFit]:
    found = {}
    for seed, component in enumerate(COMPONENTS[:count]):
        random = np.random.default_rng(seed)
        x = np.linspace(0.0, 540.0, 28)
        size = 5e-6 if component[1] in "ABC" else 5e-3
        found[component] = fit_optimal(x, size * (np.sin(x / 120.0 + seed) - np.sin(seed) + random.normal(0, 0.1, 28)))
    return found


def width_and_height(png: bytes) -> tuple[int, int]:
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    return int.from_bytes(png[16:20]), int.from_bytes(png[20:24])


def test_equal_input_gives_equal_bytes_without_dates_or_versions(tmp_path: Path) -> None:
    for name in ("one.png", "other.png"):
        (tmp_path / name).write_bytes(curves_picture(fits(2)))
    png = (tmp_path / "one.png").read_bytes()
    assert png == (tmp_path / "other.png").read_bytes()
    assert b"tEXt" not in png
    assert b"tIME" not in png


@pytest.mark.parametrize(("count", "columns", "rows"), [(1, 1, 1), (4, 3, 2), (18, 3, 6)])
def test_components_fill_a_grid_of_three_columns(tmp_path: Path, count: int, columns: int, rows: int) -> None:
    (tmp_path / "curves.png").write_bytes(curves_picture(fits(count)))
    width, height = width_and_height((tmp_path / "curves.png").read_bytes())
    assert width == pytest.approx(110 * (1.2 + 4.2 * columns), abs=1)
    assert height == pytest.approx(110 * (0.9 + 2.7 * rows), abs=1)


def test_error_bars_and_curves_show(tmp_path: Path) -> None:
    plain = fits(1)
    (tmp_path / "plain.png").write_bytes(curves_picture(plain))
    (tmp_path / "bars.png").write_bytes(curves_picture(plain, u={"EXX": np.full(28, 4e-4)}))
    (tmp_path / "angle.png").write_bytes(curves_picture({"EAX": plain["EXX"]}))
    pictures = {(tmp_path / name).read_bytes() for name in ("plain.png", "bars.png", "angle.png")}
    assert len(pictures) == 3


def test_an_empty_polynomial_is_drawn(tmp_path: Path) -> None:
    x = np.linspace(0.0, 360.0, 20)
    noise = np.random.default_rng(8).normal(size=20)
    empty = {"EXC": fit_optimal(x, np.zeros(20)), "EAC": fit_optimal(x, noise - noise.mean(), alpha=1e-6)}
    assert not any(fit.passed for fit in empty.values())
    (tmp_path / "empty.png").write_bytes(curves_picture(empty))
    assert (tmp_path / "empty.png").stat().st_size > 5000


def test_nothing_to_draw_is_said_and_writes_nothing(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="no fit"):
        (tmp_path / "none.png").write_bytes(curves_picture({}))
    assert not (tmp_path / "none.png").exists()
