"""Checks without causes: silent under noise, and each class fires for the structure that it is there for."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pytest
from scipy.stats import kstest

from tests.diagnosis.prepared import SIGMA, SMALL, WHITE, Field, field
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.judging.checks import LOOKS, fired_structure, run_checks
from trueaxis.diagnosis.judging.checks_of_runs import humming_run
from trueaxis.diagnosis.judging.structure import Check, StructureClass
from trueaxis.diagnosis.judging.structure_columns import structures
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.estimation.noise import Noise
from trueaxis.reporting.diagnosis.structures import check_name

FloatArray = npt.NDArray[np.float64]


def checked(where: Field, values: FloatArray) -> tuple[Check, ...]:
    """values: (n,), mm."""
    residual = where.base.rest(where.whitening(values))
    return run_checks(where.readings, where.whitening, where.base, residual, where.freedom)


def noise(where: Field, seed: int) -> FloatArray:
    return SIGMA * np.random.default_rng(seed).standard_normal(where.readings.rows.size)


def test_p_values_are_uniform_but_for_the_number_of_checks() -> None:
    where = field(SMALL, WHITE)
    draws = [checked(where, noise(where, seed)) for seed in range(60)]
    count = len(list(structures(where.readings)))
    # of p values multiplied by their number those below 1 are known: of each check one in so many, evenly spread; the
    # second look at each, by what it leaves, sees the same or, at most, others
    of_classes = ("lines of", "circles of", "readings that show")
    told = np.array([[one.p_value for one in checks if check_name(one).startswith(of_classes)] for checks in draws])
    assert told.shape[1] > 20
    below = told[told < 0.999]
    expected = told.size / count
    assert expected / LOOKS - 4 * np.sqrt(expected) < below.size < expected + 4 * np.sqrt(expected)
    assert kstest(below, "uniform").pvalue > 1e-3
    assert sum(one.fired for checks in draws for one in checks) <= 3


def sense(rows: Rows) -> FloatArray:
    """(n,): +1 for what turns counter-clockwise."""
    return np.array([1.0 if run.id.endswith("ccw") else -1.0 for run in rows.runs])[rows.run]


def known(values: FloatArray | None) -> FloatArray:
    assert values is not None
    return np.nan_to_num(values)


PLANTED: dict[str, Callable[[Rows, FloatArray], FloatArray]] = {
    "lines of X, between directions": lambda rows, _: rows.directions[0] * np.cos(rows.positions[0] / 60.0),
    "lines of Y, by line": lambda rows, _: np.cos(2.0 * rows.setup) * (rows.positions[1] / 350.0 - 1.0) ** 4,
    "lines of Z, in the course of a run": lambda rows, _: (rows.seq / 42.0 - 0.5) ** 2,
    "lines of X, with temperature": lambda rows, _: (known(rows.temperature) - 20.0) * rows.positions[0] / 540.0,
    "circles of XY, lobes by direction": lambda rows, theta: np.cos(4 * theta) * sense(rows),
    "lines of Y, ripple between directions": lambda rows, _: rows.directions[1] * np.cos(rows.positions[1] / 9.0),
    "circles of YZ, ripple by direction": lambda rows, theta: np.sin(23 * theta) * sense(rows),
    "circles of XY, in the course of a run": lambda rows, _: (rows.seq / 36 - 1) ** 3 - 0.6 * (rows.seq / 36 - 1),
    "circles of XY, lobes by feed": lambda rows, theta: np.cos(5 * theta) * (known(rows.feed) > 2000.0),
    "circles of YZ, at reversals": lambda rows, _: rows.directions[1],
    "circles of XZ, after reversals": lambda rows, _: np.exp(-rows.context.since_reversal[0] / 5) * rows.directions[0],
}


def axes_of(name: str) -> set[str]:
    return set(name.split(" ")[2].strip(",")) if name.startswith(("lines of", "circles of")) else set()


@pytest.mark.parametrize("name", PLANTED)
def test_each_class_fires_for_its_structure(name: str) -> None:
    where = field(replace(SMALL, lines=4), WHITE)
    rows, theta = where.readings.rows, np.nan_to_num(where.readings.reading.theta)
    wanted = np.zeros(rows.size, dtype=bool)
    for index in rows.present:
        mine = rows.of_run(index)
        spans = np.ptp(rows.positions[:, mine], axis=1)
        moving = {axis for axis, span in zip(rows.axes, spans, strict=True) if span > 0}
        of_circle = rows.runs[index].instrument == "ballbar"
        wanted[mine] = moving == axes_of(name) and of_circle == name.startswith("circles")
    shape = np.where(wanted, PLANTED[name](rows, theta), 0.0)
    assert np.ptp(shape) > 0.0
    checks = checked(where, noise(where, 6) + 10 * SIGMA * shape / np.abs(shape).max())
    by_name = {check_name(one): one for one in checks}
    assert by_name[name].fired
    assert by_name[name].rms > 0.0
    # nothing that has no axis in common with it does
    fired = [check_name(one) for one in checks if one.fired]
    assert not [one for one in fired if axes_of(one) and not axes_of(name) & axes_of(one)]


def _wave(since: FloatArray) -> FloatArray:
    return np.cos(np.where(np.isfinite(since), since, 0.0) / 40.0)


OF_ERRORS: dict[StructureClass, Callable[[Rows], FloatArray]] = {
    StructureClass.ERROR_DIRECTION: lambda rows: rows.directions[0] * np.sign(rows.positions[0] - 230.0),
    StructureClass.ERROR_AFTER_REVERSALS: lambda rows: rows.directions[0] * _wave(rows.context.since_reversal[0]),
    StructureClass.ERROR_COURSE: lambda rows: rows.positions[0] * (known(rows.context.time) / 3600.0) ** 2,
}


def error_of(where: Field, name: str, structure: StructureClass) -> FloatArray:
    """(n,): an error of size 1 as each reading senses it."""
    rows = where.readings.rows
    shape = OF_ERRORS[structure](rows) * where.readings.sensitivity[where.readings.model.components.index(name)]
    return known(shape / np.abs(shape[np.isfinite(shape)]).max())


@pytest.mark.parametrize("structure", OF_ERRORS)
def test_an_error_of_no_kind_is_seen_by_all_instruments_that_sense_it(structure: StructureClass) -> None:
    where = field(SMALL, WHITE)
    slow = structure is StructureClass.ERROR_COURSE  # nearly all of it is a curve and the zero of each run
    checks = checked(where, noise(where, 3) + (200.0 if slow else 2.0) * SIGMA * error_of(where, "EXX", structure))
    of_class = {one.place: one for one in checks if one.structure is structure}
    assert of_class["EXX"].fired
    assert min(of_class, key=lambda place: of_class[place].p_value) == "EXX"
    assert check_name(of_class["EXX"]).startswith("readings that show EXX, ")


def test_structure_that_is_seen_is_that_which_is_there_and_no_other() -> None:
    where = field(replace(SMALL, lines=4), WHITE)
    rows = where.readings.rows
    shape = np.where(_of_lines_along(rows, 0), rows.directions[0] * np.cos(rows.positions[0] / 60.0), 0.0)
    values = noise(where, 6) + 10.0 * SIGMA * shape
    residual = where.base.rest(where.whitening(values))
    checks = checked(where, values)
    of_lines = [one for one in checks if one.fired and one.structure is StructureClass.LINE_DIRECTION]
    (seen,) = fired_structure(where.readings, where.whitening, where.base, residual, of_lines)
    assert where.base.rest(where.whitening(seen)) == pytest.approx(
        where.base.rest(where.whitening(10.0 * SIGMA * shape)), abs=2.0
    )
    silent = [one for one in checks if not one.fired]
    assert silent
    assert not list(fired_structure(where.readings, where.whitening, where.base, residual, silent))


def _of_lines_along(rows: Rows, axis: int) -> npt.NDArray[np.bool_]:
    """Readings by laser of runs along one axis alone."""
    found = np.zeros(rows.size, dtype=bool)
    for index in rows.present:
        mine = rows.of_run(index)
        moving = np.flatnonzero(np.ptp(rows.positions[:, mine], axis=1)).tolist()
        found[mine] = rows.runs[index].instrument == "laser" and moving == [axis]
    return found


def test_what_counts_as_noise_of_its_runs_is_seen_by_what_it_leaves() -> None:
    """Where nothing is repeated, structure that runs share is noise of these runs in the estimate."""
    where = field(SMALL, Noise(4.0 * SIGMA))
    structure = error_of(where, "EXX", StructureClass.ERROR_DIRECTION)
    found = min(checked(where, noise(where, 3) + 2.0 * SIGMA * structure), key=lambda one: one.p_value)
    assert (found.structure, found.place, found.fired) == (StructureClass.ERROR_DIRECTION, "EXX", True)
    assert 0.5 * SIGMA < found.rms < 2.0 * SIGMA
    assert not [one for seed in range(10) for one in checked(where, noise(where, seed)) if one.fired]


def fired_in(where: Field, values: FloatArray) -> list[StructureClass]:
    return [one.structure for one in checked(where, values) if one.fired]


def test_a_run_that_hums_is_told_and_named() -> None:
    where = field(SMALL, WHITE)
    values = noise(where, 9)
    mine = where.readings.rows.of_run(2)
    values[mine] += 1.8 * SIGMA * np.sin(0.9 * np.arange(mine.stop - mine.start))
    (found,) = [one for one in checked(where, values) if one.structure is StructureClass.ONE_PERIOD]
    assert found.fired
    assert found.place == where.readings.rows.runs[2].id
    # a drift of the same size is the noise of a run
    values = noise(where, 9)
    values[mine] += 1.8 * SIGMA * np.linspace(-1.0, 1.0, mine.stop - mine.start)
    assert StructureClass.ONE_PERIOD not in fired_in(where, values)


def test_what_no_class_has_is_more_than_repeats_differ_by() -> None:
    """The same at every repeat, without any order in it: nothing but the comparison with repeats can tell."""
    where = field(SMALL, WHITE)
    rows = where.readings.rows
    at_target = np.random.default_rng(4).standard_normal(int(rows.target.max()) + 1)[rows.target]
    assert StructureClass.LACK_OF_FIT in fired_in(where, noise(where, 7) + 0.9 * SIGMA * at_target)
    assert StructureClass.LACK_OF_FIT not in fired_in(where, noise(where, 7))


def test_what_the_base_can_take_up_fires_nothing() -> None:
    where = field(SMALL, WHITE)
    smooth = where.columns @ (1e-3 * np.random.default_rng(2).standard_normal(where.columns.shape[1]))
    assert not fired_in(where, noise(where, 6) + smooth)


def test_short_runs_hum_by_chance_as_often_as_is_said() -> None:
    """Of fifteen targets the base leaves little that is white: one data set in eight was below 5 %."""
    where = field(Design(lines=1, repeats=1, targets=15, samples=36))
    p_values = []
    for seed in range(200):
        residual = where.base.rest(where.whitening(noise(where, seed)))
        p_values.append(humming_run(where.readings.rows, where.whitening, where.base, residual).p_value)
    assert 0.02 < np.mean(np.array(p_values) < 0.05) < 0.085
