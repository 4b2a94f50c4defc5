"""The campaign: it goes on where it stopped, its lines add up, and its figures are those of their definition."""

import json
from pathlib import Path

import numpy as np
import pytest

from tests.worlds.campaign import KINDS, main, read_lines
from tests.worlds.campaign_tables import figures, tables
from tests.worlds.design import draw_design
from tests.worlds.estimates import GIVEN

SMALL = 36  # a design of three axes, 20 runs, ball bars alone


def line(error: float, oracle: float, coverage: float, curves: str) -> dict[str, object]:
    figures = {
        "true": 10.0,
        "error": error,
        "oracle": oracle,
        "one_family": 2.0 * oracle,
        "class_sizes": 2.5 * oracle,
        "set_ups_expected": 4.0 * oracle,
        "u": 2.0,
        "coverage": coverage,
        "curves": curves,
    }
    return figures | {"oracle_coverage": 0.95, "seconds": 1.0}


def test_machines_are_of_every_kind_in_turn() -> None:
    assert len(set(KINDS)) == 2 * len(GIVEN)
    assert {given for _, given in KINDS} == set(GIVEN)
    assert {curves for curves, _ in KINDS} == {"smooth", "prior"}


def test_figures_of_machines_made_by_hand() -> None:
    found = figures([line(3.0, 3.0, 1.0, "smooth"), line(4.0, 4.0, 0.9, "prior"), line(12.0, 4.0, 0.5, "prior")])
    assert found.left == pytest.approx((9.0 + 16.0 + 144.0) / 300.0)
    expected = np.sqrt(169.0 / 41.0) / np.array([1.0, 2.0, 2.5, 4.0])
    names = ("oracle", "one family", "class sizes", "set-ups expected")
    assert [found.ratios[name][0] for name in names] == pytest.approx(expected)
    assert (found.smooth, found.prior) == pytest.approx((1.0, 0.7))
    assert (found.worse, found.worst) == pytest.approx((1.0 / 3.0, 1.2))


def test_the_uncertainty_of_a_ratio_is_its_scatter_over_campaigns() -> None:
    draw = np.random.default_rng(3)
    ratios, said = [], []
    for _ in range(400):
        oracle = np.exp(0.4 * draw.standard_normal(60))
        error = 1.2 * oracle * np.exp(0.2 * draw.standard_normal(60))
        one = figures([line(a, b, 0.95, "prior") for a, b in zip(error, oracle, strict=True)])
        ratio, u = one.ratios["oracle"]
        ratios.append(ratio)
        said.append(u)
    assert np.mean(said) == pytest.approx(np.std(ratios), rel=0.15)


def test_a_campaign_goes_on_where_it_stopped(tmp_path: Path) -> None:
    options = ["--out", str(tmp_path), "--designs", "1", "--first", str(SMALL)]
    assert main([*options, "--machines", "1"]) == 0
    (results,) = tmp_path.glob("results-*.jsonl")
    before = results.read_text()
    assert main([*options, "--machines", "2"]) == 0
    assert results.read_text().startswith(before)
    lines = read_lines(tmp_path)
    assert [(one["design"], one["machine"]) for one in lines] == [(SMALL, 0), (SMALL, 1)]
    assert [(one["curves"], one["given"]) for one in lines] == list(KINDS[:2])
    assert all(one["converged"] for one in lines)
    text = "\n".join(tables(lines))
    assert "1 designs, 2 machines" in text
    design = draw_design(SMALL)
    assert f"| {SMALL} | {len(design.machine.axes)} | {design.plan.count} | {len(design.plan.runs)} | 2 |" in text
    assert json.loads(before.splitlines()[0])["sizes"].keys() >= {"translation", "rotation"}


@pytest.mark.slow
def test_workers_measure_the_same(tmp_path: Path) -> None:
    options = ["--designs", "1", "--first", str(SMALL), "--machines", "2"]
    assert main(["--out", str(tmp_path / "here"), *options]) == 0
    assert main(["--out", str(tmp_path / "there"), *options, "--workers", "2"]) == 0
    here, there = ([one | {"seconds": 0.0} for one in read_lines(tmp_path / name)] for name in ("here", "there"))
    assert here == there
    assert len(here) == 2
    assert main(["--out", str(tmp_path / "there"), *options, "--workers", "2"]) == 0
    assert len(read_lines(tmp_path / "there")) == 2
