"""Fleets of machines of one axis, whose error is a slope, measured by a laser: a row takes a tenth of a second."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from tests.command_lines import SMALL, SMALL_RUN

SLOPE = 1e-5  # of EXX, mm/mm
NOISE = 1e-4  # mm
POSITIONS = np.linspace(0.0, 100.0, 11)


def write_data(folder: Path, slope: float, seed: int) -> None:
    """Three repeats of one run, there and back."""
    folder.mkdir(parents=True)
    source = np.random.default_rng(seed)
    runs, rows = [], []
    for number in range(3):
        runs.append(SMALL_RUN.partition("[[run]]")[2].replace("X-1", f"X-{number}"))
        for seq, x in enumerate(POSITIONS):
            rows.append(f"X-{number},{seq},{x},{slope * x + NOISE * source.standard_normal():.7f}")
    head = SMALL_RUN.partition("[[run]]")[0]
    (folder / "setup.toml").write_text(head + "".join(f"[[run]]{one}" for one in runs))
    (folder / "readings.csv").write_text("\n".join(["run,seq,X,reading", *rows]) + "\n")


def write_fleet(
    folder: Path,
    count: int,
    *,
    dates: Sequence[str] = ("2026-10-01", "2026-11-01"),
    changed: Sequence[int] = (),
    tasks: str = "",
) -> Path:
    """The fleet file. changed: machines whose slope is another at the last date."""  # fmt: skip
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "small.toml").write_text(SMALL)
    text = []
    for number in range(count):
        for day, date in enumerate(dates):
            worn = number in changed and day == len(dates) - 1
            write_data(folder / "data" / f"M{number}" / date, (3.0 if worn else 1.0) * SLOPE, 100 * number + day)
        text.append(f'[[machine]]\nid = "M{number}"\nspec = "small.toml"\ndata = "data/M{number}/2026-*"\n{tasks}')
    (folder / "FLEET.toml").write_text("\n".join(text))
    return folder / "FLEET.toml"
