"""A part of the campaign, always the same, over every reader; `python -m tests.fuzz` goes on from there."""

import warnings
from pathlib import Path

import pytest

from tests.fuzz import campaign
from tests.fuzz.judge import Outcome, case_of, judged
from tests.fuzz.readers import DRILLS, READERS, Reader

SEEDS = 100  # of each reader
SECONDS = 45.0  # at most; about a third of it on an idle processor


def test_no_hostile_file_does_harm(tmp_path: Path) -> None:
    readers = [reader for reader in READERS if reader.every <= SEEDS]  # a case of others takes seconds
    tally = campaign.run(readers, range(SEEDS), SECONDS, tmp_path)
    assert not tally.findings, "\n".join([*tally.lines(), *tally.details.values()])
    assert {name for name, _ in tally.states} == {reader.name for reader in readers}


def test_a_process_that_hangs_or_dies_is_a_finding_and_is_started_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(campaign, "SECONDS", 1.0)
    monkeypatch.setattr(campaign, "PATIENCE", 2)
    tally = campaign.run(DRILLS, [0], 60.0)
    assert tally.findings == {("hangs", "takes too long"): [0], ("dies", "the process dies"): [0]}


@pytest.mark.parametrize(
    "reader", [one for one in READERS if one.name not in ("expression", "readings-diagnose")], ids=lambda one: one.name
)
def test_what_the_campaign_changes_is_right_before(
    reader: Reader, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # It would prove nothing if every file were refused. A ball bar of any length is, and a CL file for rotary axes.
    monkeypatch.setenv("TRUEAXIS_BACKEND", "numpy")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        outcomes = [judged(reader, case_of(reader, seed, valid=True), tmp_path / "case") for seed in range(8)]
    assert not [one for one in outcomes if one.state == "finding"]
    assert sum(one.state in ("read", "done", "answered no") for one in outcomes) >= 3, outcomes


def test_the_judge_sees_what_must_not_be(tmp_path: Path) -> None:
    def outcome(read: object) -> Outcome:
        reader = Reader("points", "points.csv", read)  # type: ignore[arg-type]
        return judged(reader, case_of(reader, 1), tmp_path / "case")

    def fails(*_: object) -> None:
        raise LookupError("oh")

    assert outcome(fails).problem == "LookupError in test_fuzz.py:fails"
    assert outcome(lambda *_: None).state == "read"
