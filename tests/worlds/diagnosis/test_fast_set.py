"""A few cases of two small worlds put before the diagnosis: no name is false or wrong, and nothing breaks down."""

from dataclasses import replace
from pathlib import Path

import pytest

from tests.worlds.diagnosis.answers import said_of
from tests.worlds.diagnosis.cases import bench_of, draw_case
from tests.worlds.diagnosis.counting import reasons
from tests.worlds.diagnosis.lines import line_of
from tests.worlds.diagnosis.values import write_case
from tests.worlds.effects import Effect

WORLDS, CASES = (5219, 5226), 4  # lasers alone with repeats; circles and lines
NEVER = {"broke down", "wrong name", "false name"}


@pytest.mark.parametrize("seed", WORLDS)
def test_no_name_is_false_and_nothing_breaks_down(seed: int, tmp_path: Path) -> None:
    bench = bench_of(seed)
    lines = [line_of(bench, number, tmp_path) for number in range(CASES)]
    assert [(line["case"], line.get("sets"), line.get("error")) for line in lines if NEVER & set(reasons(line))] == []


def test_a_step_in_a_run_of_few_readings_is_not_taken_apart(tmp_path: Path) -> None:
    """Twelve readings, the last six of them after the step: two explained as much, then two more beside them, until
    what was left was a zero of the run.
    """
    bench = bench_of(20059)
    plain = draw_case(bench, 101, ("nothing",))
    step = Effect("laser_step", size=0.017, runs=("Z1",), shape=2040876066)
    case = replace(plain, given="zeros", truth=plain.truth.hiding(step))
    said = said_of(tmp_path, write_case(tmp_path, tmp_path / "kernels", bench.design, case)).said
    assert [[(one.kind, one.runs) for one in names] for names in said.sets] == [[("laser_step", ("Z1",))]]


@pytest.mark.slow
def test_a_disturbed_reading_that_play_hides_does_not_keep_it_from_its_name(tmp_path: Path) -> None:
    """Play in yaw of 25 urad, ten times what tells it; one of two readings of a target is a micrometre or two off."""
    line = line_of(bench_of(24098), 3, tmp_path)
    assert ([one["name"] for one in line["hidden"]], line["grade"]) == (["backlash ECX"], "unique")
