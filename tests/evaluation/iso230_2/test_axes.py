"""Rotary axes in arc seconds, and axes beyond the standard's length without repeatability: the same definitions."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

from tests.evaluation.iso230_2.builders import dat_text, made_up
from trueaxis.cli.main import main
from trueaxis.evaluation.positioning_test import PositioningTest

ARCSEC = 3600.0
TARGETS = np.array([0.0, 45.5, 90.0, 137.25, 180.0, 226.0, 270.0, 315.75])


def table(path: Path, test: PositioningTest) -> Path:
    lines = ["target,cycle,direction,measured"]
    for label, values in (("+1", test.positive), ("-1", test.negative)):
        for i, target in enumerate(test.targets.tolist()):
            for j, value in enumerate(values[i].tolist()):
                lines.append(f"{target!r},{j + 1},{label},{value!r}")
    path.write_text("\n".join(lines) + "\n")
    return path


def rotary(cycles: int = 5, scale: float = 1.0) -> PositioningTest:
    """Deviations of some arc seconds, deg; scale: of the targets."""
    source = np.random.default_rng(4)
    targets = scale * TARGETS
    off = 5.0 * np.sin(np.radians(targets))[:, np.newaxis] + source.normal(0.0, 0.3, (2, targets.size, cycles))
    off[0] -= 2.0
    return PositioningTest(targets, targets[:, None] + off[0] / ARCSEC, targets[:, None] + off[1] / ARCSEC, "deg")


def by_definition(off: np.ndarray) -> dict[str, float]:
    """Clause 3 written out: off (2, m, n)."""
    mean, s = off.mean(axis=2), np.sqrt(((off - off.mean(axis=2, keepdims=True)) ** 2).sum(axis=2) / (off.shape[2] - 1))
    b = mean[0] - mean[1]
    r = [max(2 * s[0, i] + 2 * s[1, i] + abs(b[i]), 4 * s[0, i], 4 * s[1, i]) for i in range(off.shape[1])]
    both = mean.mean(axis=0)
    return {
        "B": float(np.abs(b).max()),
        "B_mean": float(b.mean()),
        "R": max(r),
        "E": float(mean.max() - mean.min()),
        "M": float(both.max() - both.min()),
        "A": float((mean + 2 * s).max() - (mean - 2 * s).min()),
    }


def test_a_rotary_axis_is_evaluated_in_arc_seconds_and_microradians(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    test = rotary()
    data, out = table(tmp_path / "c.csv", test), tmp_path / "c.json"
    words = ["evaluate", str(data), "--rotary", "--out", str(out), "--picture", str(tmp_path / "c.png")]
    assert main(words) == 0
    told = capsys.readouterr().out
    right = by_definition(ARCSEC * (np.array([test.positive, test.negative]) - test.targets[:, None]))
    found = json.loads(out.read_text())
    assert found["unit"] == "deg"
    for name, value in right.items():
        assert found["bidirectional_arcsec"][name] == pytest.approx(value, rel=1e-9)
        assert found["bidirectional_urad"][name] == pytest.approx(value * math.pi / 648000.0 * 1e6, rel=1e-9)
        assert found["bidirectional"][name] == pytest.approx(value / ARCSEC, rel=1e-9)
    assert "of the axis (arcsec)" in told
    assert "of the axis (urad)" in told
    assert "P_i target (deg); the rest in arcsec" in told
    assert "per metre" not in told


def test_a_dat_file_says_which_unit_it_has(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = dat_text(made_up(6, 5)).replace('"mm"', '"deg"').replace("UNIT=mm", "UNIT=deg")
    assert "deg" in text
    (tmp_path / "c.dat").write_text(text)
    assert main(["evaluate", str(tmp_path / "c.dat")]) == 2
    assert "--rotary" in capsys.readouterr().err
    assert main(["evaluate", str(tmp_path / "c.dat"), "--rotary"]) == 0
    (tmp_path / "x.dat").write_text(dat_text(made_up(6, 5)))
    assert main(["evaluate", str(tmp_path / "x.dat"), "--rotary"]) == 2
    assert "is not deg" in capsys.readouterr().err


@pytest.mark.parametrize("unit", ["mm", "deg"])
def test_one_approach_is_enough_beyond_the_longest_axis_alone(
    tmp_path: Path, unit: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """Clause 6.2: B, E and M of single approaches; R and A are not estimated."""
    options = ["--rotary"] if unit == "deg" else []
    long = rotary(1, 2.0 if unit == "deg" else 8.0)
    data, out = table(tmp_path / "long.csv", long), tmp_path / "long.json"
    assert main(["evaluate", str(data), *options, "--out", str(out)]) == 0
    told = capsys.readouterr().out
    found = json.loads(out.read_text())["bidirectional"]
    off = np.array([long.positive, long.negative])[:, :, 0] - long.targets
    assert found["B"] == pytest.approx(float(np.abs(off[0] - off[1]).max()))
    assert found["E"] == pytest.approx(float(np.ptp(off)))
    assert found["M"] == pytest.approx(float(np.ptp(off.mean(axis=0))))
    assert (found["R"], found["A"]) == (None, None)
    assert "R and A are not estimated" in told
    assert "nan" not in told
    assert main(["evaluate", str(data), *options, "--picture", str(tmp_path / "no.png")]) == 2
    short = table(tmp_path / "short.csv", rotary(1))
    assert main(["evaluate", str(short), *options]) == 2
    assert "has 1 cycle" in capsys.readouterr().err
