"""A case as files: the machine, the values that are given, the readings; tampered with where that is asked for."""

import contextlib
import io
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from tests.worlds.design import Design
from tests.worlds.diagnosis.cases import Case
from tests.worlds.diagnosis.wear import change_of
from tests.worlds.files import spec_toml, write_world
from tests.worlds.machine import Array
from tests.worlds.readings import measure
from tests.worlds.stale import Given, before, nothing_given, truth_given
from tests.worlds.truth import Truth
from trueaxis.cli.main import main

EARLIER = 500_000_000  # between the seeds of a case and of the readings from which its values were identified


class NoValuesError(Exception):
    """The values of a case could not be identified."""


def write_case(folder: Path, kernels: Path, design: Design, case: Case, tamper: str = "") -> Path:
    """Write machine.toml, errors.json and data/; returns the folder of the kernels, derived where they are not there.

    kernels: of the world, kept; tamper: swapped, shuffled, taken_away or nothing.
    """
    folder.mkdir(parents=True, exist_ok=True)
    own = kernels_of(kernels, design, case.left_out)
    then = earlier(case)
    given = {"zeros": nothing_given(design.machine)}.get(case.given, _tables(case))
    measured = replace(case.truth, effects=()) if tamper == "taken_away" else case.truth
    data = measure(design, measured, case.seed)
    written = _tampered(design, tamper, case.seed)
    sessions = design.ingredients["says_sessions"]
    if case.given == "identified":
        _identified(folder, own, design, then)
    else:
        write_world(folder, written, case.truth, None, given, sessions=sessions)
    values = (folder / "errors.json").read_text()
    write_world(folder, written, case.truth, data, given, sessions=sessions)
    (folder / "errors.json").write_text(values)
    return own


def earlier(case: Case) -> Truth:
    """The machine when its given values were true: without hidden effects, and before it wore."""
    truth = case.truth
    if case.wear is not None:
        change = change_of(truth, case.wear, case.seed)
        curves = dict(truth.curves)
        curves[case.wear.component] = curves[case.wear.component].plus(lambda at: -change(at))
        truth = replace(truth, curves=curves)
    return replace(truth, effects=tuple(one for one in truth.effects if one.kind == "squareness"))


def _tables(case: Case) -> Given:
    if case.wear is None:
        return truth_given(case.truth)
    return before(case.truth, case.wear.component, change_of(case.truth, case.wear, case.seed))


def _identified(folder: Path, kernels: Path, design: Design, then: Truth) -> None:
    """errors.json, with its covariance, as `identify` makes it of an earlier set of readings."""
    clean = replace(then, effects=())
    data = measure(design, clean, EARLIER + design.seed)
    first = folder / "earlier"
    # dimensions are known, and nothing else: a location error that is given is exact, and the curves would bend to it
    write_world(first, design, then, data, Given({}, {}), sessions=design.ingredients["says_sessions"])
    arguments = ["identify", str(first / "machine.toml"), "--data", str(first / "data"), "--kernels", str(kernels)]
    arguments += ["--known", str(first / "errors.json")]
    said = io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        code = main([*arguments, "--out", str(folder / "errors.json")])
    if not (folder / "errors.json").exists():
        raise NoValuesError(f"identify ended with {code}: {said.getvalue()[-200:]}")


def kernels_of(folder: Path, design: Design, left_out: Sequence[str] = ()) -> Path:
    """Derived once for a world, and for each location error that its spec may leave out."""
    own = folder / "-".join(["kernels", *left_out])
    if not (own / "done").exists():
        own.mkdir(parents=True, exist_ok=True)
        spec = own / "machine.toml"
        spec.write_text(spec_toml(design.machine, tuple(left_out)))
        with contextlib.redirect_stdout(io.StringIO()):
            if main(["derive", str(spec), "--out", str(own)]) != 0:
                raise RuntimeError(f"{spec} could not be derived")
        (own / "done").touch()
    return own


def _tampered(design: Design, how: str, seed: int) -> Design:
    """The design as the files say it: `swapped`: every linear axis has the directions of the next; `shuffled`: times
    and temperatures in any order.
    """
    plan, axes = design.plan, design.machine.linear
    if how == "swapped":
        other = dict(zip(axes, (*axes[1:], axes[0]), strict=True))
        directions: dict[str, Array] = {a: plan.directions[other.get(a, a)] for a in design.machine.axes}
        return replace(design, plan=replace(plan, directions=directions))
    if how == "shuffled":
        order = np.random.default_rng([seed, 41]).permutation(plan.count)
        return replace(design, plan=replace(plan, time=plan.time[order], temperature=plan.temperature[order]))
    return design
