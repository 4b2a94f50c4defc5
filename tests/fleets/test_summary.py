"""What rows come to: changes that are more than chance in a fleet of that size, causes that machines share."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import norm

from trueaxis.fleets.rows import (
    ROW_FILE,
    CauseFound,
    Row,
    StaleFound,
    ValueFound,
    changed_from,
    read_row,
    row_text,
    rows_frame,
    summary_of,
)
from trueaxis.jobs.fleet import FleetResult
from trueaxis.reporting.fleet import fleet_page, fleet_text


def row(machine: str, day: int, *causes: CauseFound, in_u: float | None = None, faults: tuple[str, ...] = ()) -> Row:
    value = ValueFound(
        name="EXX", value=1e-3, u=1e-4, at=0.0, unit="mm", determined="data", change=1e-3, change_in_u=in_u
    )
    return Row(machine=machine, data=f"d/2026-11-{day:02d}", date=f"2026-11-{day:02d}", inputs="x", tasks=("identify",),
               causes=causes, values=(value,), faults=faults)  # fmt: skip


def cause(kind: str, component: str | None, label: str) -> CauseFound:
    return CauseFound(
        kind=kind, component=component, label=label, certain=True, parameters={"width": (0.01, None, "mm")}
    )


def test_the_limit_lets_less_than_one_machine_pass_that_stays_as_it_is() -> None:
    assert changed_from(10) == pytest.approx(3.0, abs=0.2)
    source = np.random.default_rng(1)
    for count in (100, 4200):
        largest = np.abs(source.standard_normal((40, count, 6))).max(axis=2)  # a curve is as good as six numbers
        assert (largest > changed_from(count)).sum(axis=1).mean() < 1.3
        assert changed_from(count) == pytest.approx(norm.isf(0.5 / (6.2 * count)))


def test_the_newest_row_of_each_machine_counts() -> None:
    rows = [row("A", 1, in_u=50.0), row("A", 2, in_u=1.0), row("B", 1), row("B", 2, in_u=9.0), row("C", 1, in_u=7.0)]
    found = summary_of(rows)
    assert [one.machine for one in found.newest] == ["A", "B", "C"]
    assert [(one.row.machine, one.error.change_in_u) for one in found.changed] == [("B", 9.0), ("C", 7.0)]


def test_causes_are_shared_by_what_they_are() -> None:
    play, drift = cause("backlash", "EYY", "backlash EYY"), cause("laser_drift", None, "laser_drift of X1, X2")
    rows = [
        row("A", 1, play, drift), row("B", 1, cause("backlash", "EXX", "backlash EXX")),
        row("C", 1, cause("laser_drift", None, "laser_drift of Z9"), play, play), row("D", 1, play),
    ]  # fmt: skip
    found = summary_of(rows).shared
    assert [(one.label, [r.machine for r in one.rows]) for one in found] == [
        ("backlash EYY", ["A", "C", "D"]),
        ("laser_drift", ["A", "C"]),
    ]


def test_every_row_with_a_fault_failed() -> None:
    found = summary_of([row("A", 1, faults=("it is broken",)), row("A", 2), row("B", 1)])
    assert [one.data for one in found.failed] == ["d/2026-11-01"]


def result_of(*rows: Row) -> FleetResult:
    return FleetResult(rows=rows, summary=summary_of(rows), made=1, kept=0, files=(), folder=Path("out"))


def test_what_is_named_is_told_with_its_size() -> None:
    play = cause("backlash", "EYY", "backlash EYY")
    found = result_of(row("A", 1, play), row("B", 1, replace(play, certain=False)), row("C", 1))
    assert "named: A 2026-11-01: Backlash EYY, width 10.0 um\n" in str(found)
    assert "named: B 2026-11-01: Backlash EYY, width 10.0 um (not certain)\n" in str(found)
    assert "named: C" not in str(found)
    assert found.good


def test_values_that_do_not_fit_are_no_success() -> None:
    misfit = replace(row("A", 2), fit="misfit")
    assert not result_of(row("A", 1), misfit).good
    assert result_of(replace(misfit, date="2026-10-01"), row("A", 3)).good  # newer values fit


def test_rivals_and_values_that_are_no_longer_right_are_told_everywhere(tmp_path: Path) -> None:
    either = replace(cause("backlash", "EAY", "backlash EAY"), certain=False, rivals=("backlash EYY", "drift EYY", "x"))
    crash = StaleFound(name="EC0Y", change=4e-5, u=4.3e-7, unit="rad")
    one = replace(row("M2", 1, either), stale=(crash,), verdict="ambiguous")
    (tmp_path / ROW_FILE).write_text(row_text(one))
    assert read_row(tmp_path) == one
    (cells,) = rows_frame((one,)).iter_rows(named=True)
    assert cells["stale"] == [{"name": "EC0Y", "change": 4e-5, "u": 4.3e-7, "unit": "rad"}]
    assert cells["causes"][0]["rivals"] == ["backlash EYY", "drift EYY", "x"]
    said = fleet_text((one,), summary_of((one,)), 1, 0)
    assert "named: M2 2026-11-01: Backlash EAY, width 10.0 um; or Backlash EYY, Drift EYY, 1 more" in said
    assert "stale: M2 2026-11-01: EC0Y changed by 40.0 urad, u 0.43 urad" in said
    page = fleet_page("FLEET.toml", (one,), summary_of((one,)))
    for text in ("or Backlash EYY", "EC0Y changed by"):
        assert text in page
