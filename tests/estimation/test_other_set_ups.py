"""What setup.toml may have said instead: frames, directions, signs along a line."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from tests.estimation.test_left_out import _kept
from tests.planning.data import model
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.fitted import Fitted
from trueaxis.estimation.misread import SURE, fault_ratios
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.other_set_ups import _kind, other_set_ups
from trueaxis.measurement.reading_model import expected_reading
from trueaxis.measurement.setup import Run
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel
from trueaxis.planning.candidates import candidates
from trueaxis.planning.kit import Kit

NOISE = 1e-3  # mm


def sphere(machine: MachineModel) -> Observations:
    """C turns about a sphere, read along x, y and z of the workpiece; a machine whose C is tilted and off its place."""
    kit = Kit(instruments=("probe",), everywhere=False)
    every = [one for one in candidates(machine, kit) if "C turning at B0 about" in one.what]
    turns = [one for one in every if one.run.frame == "workpiece"]
    values = {**machine.errors.parameters, "EX0C": 0.03, "EY0C": -0.02, "EA0C": 5e-5, "EB0C": -4e-5}
    hidden = machine.with_values(replace(machine.errors, parameters=values))
    draw = np.random.default_rng(3)
    read = [expected_reading(hidden, one.run, one.positions) for one in turns]
    return Observations(
        source="plan",
        runs=tuple(one.run for one in turns),
        run=np.repeat(np.arange(len(turns)), [one.size for one in read]),
        positions=np.hstack([one.positions for one in turns]),
        reading=np.concatenate([one + draw.normal(0.0, NOISE, one.size) for one in read]),
    )


def fitted(machine: MachineModel, observed: Observations, monkeypatch: pytest.MonkeyPatch) -> Fitted:
    kept = _kept(monkeypatch)
    known = {name: machine.errors.parameters.get(name, 0.0) for name in machine.dimensions}
    estimate(machine, observed, ErrorValues(machine=machine.name, parameters=known))
    return kept[0]


def proposed(machine: MachineModel, observed: Observations, wrong: Sequence[int], found: Fitted) -> list[Run]:
    """The runs of the first other set-up that is tried of runs that are all wrong alike."""

    def no_refit(_: object) -> Fitted:
        raise AssertionError("frames need no estimate without a run")

    each = other_set_ups(found, observed, [], wrong, no_refit, SURE)
    first = next(iter(each), None)
    return [] if first is None else list(first.observed.runs)


def test_all_runs_of_a_cycle_are_tried_in_the_other_frame(monkeypatch: pytest.MonkeyPatch) -> None:
    machine = model("dmu60p_5axis")
    right = sphere(machine)
    wrong = right.framed(range(len(right.runs)), "bed")
    found = fitted(machine, wrong, monkeypatch)
    assert proposed(machine, wrong, [0, 1, 2], found) == list(right.runs)
    assert proposed(machine, wrong, [], found) == []


def test_runs_along_one_line_may_have_the_wrong_sign_together(monkeypatch: pytest.MonkeyPatch) -> None:
    """The column of Y had the wrong sign in all runs of a probe, which no run shows by itself, nor all together."""
    machine = model("dmu60p_5axis")
    right = sphere(machine)
    runs = tuple(
        replace(run, direction=(0.0, -1.0, 0.0)) if run.direction == (0.0, 1.0, 0.0) else run for run in right.runs
    )
    again = Observations(
        source="plan",
        runs=(*runs, *(replace(run, id=f"{run.id} again", session="2") for run in right.runs)),
        run=np.concatenate([right.run, right.run + len(runs)]),
        positions=np.hstack([right.positions] * 2),
        reading=np.concatenate([right.reading] * 2),
    )
    found = fitted(machine, again, monkeypatch)
    faults = fault_ratios(found, found.posterior())
    together = {tuple(again.runs[place].line for place in one.places) for one in faults if one.of_instrument}
    assert ((0.0, 1.0, 0.0),) * 2 in together
    assert ((1.0, 0.0, 0.0),) * 2 in together


@pytest.mark.parametrize(("direction", "turned"), [((0.0, 0.0, 1.0), True), ((1.0, 0.0, 0.0), False)])
def test_an_angle_about_its_own_axis_is_another_kind_than_one_across(
    direction: tuple[float, float, float], turned: bool
) -> None:
    """A calibrator of B was said to have read about Z, which it cannot: following that, its readings told nothing."""
    machine = model("dmu60p_5axis")
    right = sphere(machine)
    run = replace(right.runs[0], instrument="angle", frame="bed", direction=direction)
    target = replace(run.target, on="workpiece")
    run = replace(run, target=target, reference=replace(run.reference, on="bed"))
    positions = right.positions[:, right.run == 0]
    assert _kind(machine, run, positions) == (False, turned)
    still = np.repeat(positions[:, :1], 5, axis=1)
    assert _kind(machine, run, still) == (False, False)
