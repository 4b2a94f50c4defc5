"""Curves rougher than the base: they compete with the causes, the base takes them, and nothing is named for them."""

from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pytest
from scipy.stats import chi2

from tests.diagnosis.prepared import SIGMA, Prepared, field, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from trueaxis.diagnosis.causes.search import Search, search
from trueaxis.diagnosis.causes.signature import Readings
from trueaxis.diagnosis.causes.signatures import signature_of
from trueaxis.diagnosis.null_model.base import DEGREE, ROUGH, base_of, rough_degree
from trueaxis.diagnosis.null_model.roughness import FURTHER_DEGREES, Higher, _local, roughness_of
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.procedure import diagnose
from trueaxis.effects.kind import Effect
from trueaxis.measurement.data import MeasuredData
from trueaxis.model.model import MachineModel

FloatArray = npt.NDArray[np.float64]
PLAN = Design(lines=3, repeats=2, targets=45, samples=72)


def rough(model: MachineModel, rows: Rows, component: str, size: float) -> FloatArray:
    """(n,), mm: what a component of degrees 13 to 20 of this RMS, mm or rad, does to the readings."""
    base = base_of(model, rows, (component,))
    mine = np.flatnonzero(np.array(base.components) == component)[DEGREE:20]
    weights = np.random.default_rng(10).standard_normal(mine.size)
    _, curve = base.curve(component, rows)
    found = base.machine.take(mine).dense() @ (base.expected[mine] * weights)
    return np.asarray(size * found / np.sqrt(np.mean((curve[:, DEGREE:20] @ weights) ** 2)), dtype=np.float64)


def searched(values: FloatArray, *, looks: bool) -> Search:
    where = field(PLAN)
    noise = SIGMA * np.random.default_rng(4).standard_normal(where.readings.rows.size)
    ground = where.ground(values + noise)
    return search(
        replace(ground, roughness=roughness_of(_higher(where.readings), where.whitening, ground.base))
        if looks
        else ground
    )


def _higher(readings: Readings) -> Higher:
    where, names = field(PLAN), ("EXX", "EYX", "EZY", "EBX")
    base = base_of(readings.model, readings.rows, names)
    of = np.array(base.components)
    places = {name: np.flatnonzero(of == name)[DEGREE:] for name in names}
    local = {name: _local(base, name, readings.rows, slice(DEGREE, base.bases[name].degree)) for name in names}
    return Higher(base=where.null, columns=base.machine, places=places, local=local)


@pytest.mark.parametrize(("component", "size"), [("EXX", 2e-3), ("EBX", 2e-5)])
def test_what_is_rough_is_not_a_cause(component: str, size: float) -> None:
    """Without roughness it has names."""
    readings = field(PLAN).readings
    values = rough(readings.model, readings.rows, component, size)
    assert searched(values, looks=False).causes != ()
    found = searched(values, looks=True)
    assert (found.rough, found.causes) == (component, ())


def test_a_curve_that_is_a_little_rougher_is_told_by_its_next_degrees() -> None:
    """Fourteen further degrees would be tries: what one of them explains is worth less among them."""
    where = field(PLAN)
    rows = where.readings.rows
    base = base_of(where.readings.model, rows, ("EYX",))
    column = base.machine.take(np.flatnonzero(np.array(base.components) == "EYX")[DEGREE : DEGREE + 1]).dense()[:, 0]
    noise = SIGMA * np.random.default_rng(4).standard_normal(rows.size)
    seen = where.base.rest(where.whitening(column))
    ground = where.ground(noise + column * 8.0 / np.linalg.norm(seen))  # eight standard uncertainties
    higher = roughness_of(_higher(where.readings), where.whitening, ground.base)
    found = higher.roughest(ground.base, ground.values, ground.freedom)
    explained = float(seen @ ground.values) ** 2 / float(seen @ seen)
    assert found is not None
    assert found.component == "EYX"
    tries = len(FURTHER_DEGREES) + 1
    assert found.preference == pytest.approx(-np.log10(chi2.sf(explained, 1) * tries), abs=0.05)


def test_a_cyclic_error_is_one_also_where_a_rough_curve_could_follow_it() -> None:
    """Eight waves over the travel."""
    readings = field(PLAN).readings
    span = float(np.ptp(readings.rows.positions[0]))
    effect = Effect(kind="cyclic", component="EXX")
    signature = signature_of(readings, effect, ({"pitch": span / 8.0},))
    found = searched(1e-3 * signature.over_all()[:, 0], looks=True)
    assert ([one.scan.effect for one in found.causes], found.rough) == ([effect], "")


def test_a_curve_is_no_rougher_than_the_positions_at_which_it_was_read() -> None:
    few = prepared(Case(seed=1, design=Design(lines=1, repeats=2, targets=30, ball_bar=False), noise="none"))
    together = prepared(Case(seed=1, design=Design(lines=4, repeats=2, targets=15, ball_bar=False), noise="none"))
    many = prepared(Case(seed=1, design=Design(lines=2, repeats=2, targets=70, ball_bar=False), noise="none"))
    assert rough_degree(few.rows, "EXX") == 15
    assert 15 < rough_degree(together.rows, "EXX") <= ROUGH
    assert rough_degree(many.rows, "EXX") == ROUGH
    base = base_of(few.model, few.rows, ("EXX",))
    assert {name: one.degree for name, one in base.bases.items() if one.degree != DEGREE} == {"EXX": 15}


def test_an_axis_that_stands_has_no_local_changes() -> None:
    """A warning of NumPy stood in the output: its range is divided by."""
    given = field(PLAN)
    rows = given.readings.rows
    still = replace(rows, positions=np.where(np.arange(3)[:, np.newaxis] == 2, 0.0, rows.positions))
    base = base_of(given.readings.model, rows)
    assert _local(base, "EXZ", still, slice(DEGREE, ROUGH)).shape == (ROUGH - DEGREE, 0)


def changed(given: Prepared, values: FloatArray) -> MeasuredData:
    readings = given.data.readings
    added = np.zeros(readings.reading.size)
    added[given.rows.row] = values
    return replace(given.data, readings=replace(readings, reading=readings.reading + added))


def test_a_local_change_of_a_curve_is_no_periodic_error_on_lines_of_few_targets() -> None:
    """Each line has too few targets for a rougher curve: what 60 mm of it left was cyclic, of 130 mm."""
    given = prepared(Case(seed=5, design=Design(lines=4, repeats=3, targets=15), noise="white", given="exact"))
    base = base_of(given.model, given.rows, degree=80)
    mine = np.flatnonzero(np.array(base.components) == "EYY")
    at, curve = base.curve("EYY", given.rows)
    bump = 4e-3 * np.exp(-(((at - 350.0) / 30.0) ** 2) / 2.0)
    weights = np.linalg.lstsq(curve, bump, rcond=None)[0]
    said = diagnose(given.model, changed(given, base.machine.take(mine).dense() @ (base.expected[mine] * weights)))
    assert (said.verdict, said.causes) == ("recalibrate", ())
    assert "EYY" in {one.component for one in said.stale}


@pytest.mark.parametrize("hidden", [(), (Hidden("backlash", "EYY", size=6e-3),)])
def test_values_of_long_ago_are_stale_and_a_cause_beside_them_keeps_its_name(hidden: tuple[Hidden, ...]) -> None:
    given = prepared(Case(seed=5, design=PLAN, noise="white", sigma_um=0.2, given="exact", effects=hidden))
    said = diagnose(given.model, changed(given, rough(given.model, given.rows, "EYX", 2e-3)))
    assert [(one.effect.kind, one.effect.component) for one in said.causes] == [(e.kind, e.component) for e in hidden]
    assert said.verdict == ("recalibrate" if not hidden else "explained")
    assert "EYX" in {name for one in said.stale for name in (one.component, *one.alike)}
