"""A part of the campaign that is quick enough to run always: the same trials every time, limits that can be missed.

The limits leave room for what so few trials cannot tell; the figures themselves are in docs/diagnosis-power.md.
"""

import os
from collections.abc import Iterator, Sequence
from itertools import islice

import pytest

from tests.hidden_effects.campaign import bounds, run
from tests.hidden_effects.power.tally import Result
from tests.hidden_effects.power.trials import SCENARIOS, Trial, single_of

WORKERS = min(2, os.cpu_count() or 1)
pytestmark = pytest.mark.slow


def trials_of(scenario: str, count: int = 1) -> Iterator[Trial]:
    """As they are wanted: what is never asked for needs no audit of its design."""
    return SCENARIOS[scenario](count, bounds)


def of_one_machine() -> Iterator[Trial]:
    """Every kind ten times as plain as it need be, and two that are too faint."""
    faint = 0
    for trial in single_of("table_mill", 1, bounds, (0.3, 10.0)):
        faint += trial.row.endswith(", 0.3")
        if trial.row.endswith(", 10") or (trial.row.endswith(", 0.3") and faint <= 2):
            yield trial


@pytest.fixture(scope="module")
def results() -> list[Result]:
    separated = islice(trials_of("separated"), 6)
    trials = [
        *trials_of("clean", 8),
        *of_one_machine(),
        *islice(trials_of("outside"), None, None, 2),
        *(trial for trial in separated if trial.row.startswith(("laser_scale", "laser_cosine"))),
        *trials_of("tampered"),
        *trials_of("values"),
    ]
    return run(trials, WORKERS)


def of(results: Sequence[Result], scenario: str, rows: str = "") -> list[Result]:
    found = [one for one in results if one.trial.scenario == scenario and one.trial.row.endswith(rows)]
    assert found
    return found


def grades(results: Sequence[Result]) -> list[tuple[str, str]]:
    return [(one.trial.row, one.grade) for one in results]


def test_no_diagnosis_breaks_down(results: list[Result]) -> None:
    assert [pair for pair in grades(results) if pair[1] == "failed"] == []


def test_nothing_is_named_where_nothing_is_hidden(results: list[Result]) -> None:
    assert [(one.trial.row, one.said.sets) for one in of(results, "clean") if one.said.sets] == []


def test_plain_effects_are_named_by_their_name_alone(results: list[Result]) -> None:
    found = grades(of(results, "single", ", 10"))
    # ten times the audit's limits, which are smaller than they were: the noise is no longer taken for as slow as can be
    assert sum(grade == "unique" for _, grade in found) >= 0.8 * len(found), found


def test_no_name_is_wrong(results: list[Result]) -> None:
    assert [pair for pair in grades(of(results, "single")) if pair[1] == "wrong"] == []


def test_effects_of_no_known_kind_are_called_unexplained(results: list[Result]) -> None:
    found = [(one.trial.row, one.said.verdict, one.said.sets) for one in of(results, "outside")]
    assert sum(verdict == "unexplained_structure" for _, verdict, _ in found) >= 0.75 * len(found), found
    assert sum(bool(sets) for _, _, sets in found) <= 1, found


def test_what_cannot_be_told_apart_is_not_until_it_can(results: list[Result]) -> None:
    without, with_it = (of(results, "separated", rows) for rows in ("without the run", "with the run"))
    assert not any(len(names) == 1 for one in without for names in one.said.sets)
    assert {one.grade for one in with_it} == {"unique"}  # of pairs that the audit calls confounded without the run


def test_names_go_when_the_data_are_spoilt(results: list[Result]) -> None:
    for one in of(results, "tampered"):
        named = any(set(names) & set(one.trial.truth) for names in one.said.sets)
        assert named == one.trial.row.endswith("sound"), (one.trial.row, one.said)


@pytest.mark.parametrize(("given", "verdict"), [("exact", "no_discrepancy"), ("stale", "recalibrate")])
def test_values_given_are_judged(results: list[Result], given: str, verdict: str) -> None:
    assert [one.said.verdict for one in of(results, "values", given)] == [verdict]
