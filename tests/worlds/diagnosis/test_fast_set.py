"""A few cases of two small worlds put before the diagnosis: no name is false or wrong, and nothing breaks down."""

from pathlib import Path

import pytest

from tests.worlds.diagnosis.cases import bench_of
from tests.worlds.diagnosis.counting import reasons
from tests.worlds.diagnosis.lines import line_of

WORLDS, CASES = (5219, 5226), 4  # lasers alone with repeats; circles and lines
NEVER = {"broke down", "wrong name", "false name"}


@pytest.mark.parametrize("seed", WORLDS)
def test_no_name_is_false_and_nothing_breaks_down(seed: int, tmp_path: Path) -> None:
    bench = bench_of(seed)
    lines = [line_of(bench, number, tmp_path) for number in range(CASES)]
    assert [(line["case"], line.get("sets"), line.get("error")) for line in lines if NEVER & set(reasons(line))] == []
