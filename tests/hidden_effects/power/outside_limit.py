"""From what size on an effect outside the library is told from all that are inside, as the audit says it of those.

With M the projection that takes the saturated base away and s the whitened signature of the generator's own effect,
lambda = |M s|^2; R^2 is the share of it that up to four candidates of the library explain, taken one after another as
the search takes them. Below sqrt(21 / (lambda (1 - R^2))) nobody could know it from those; where R^2 is over 0.95 it is
confounded with them, and in these data not outside the library at all.
"""

import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

from tests.hidden_effects.case import Case, generate
from tests.hidden_effects.hidden import Hidden
from tests.hidden_effects.machine import Array
from tests.kept import derived
from trueaxis.diagnosis.causes.candidates import candidates
from trueaxis.diagnosis.causes.search import MOST_CAUSES, Ground, scan_all, whitened_columns, zoomed
from trueaxis.diagnosis.causes.signature import readings_of
from trueaxis.diagnosis.further_runs.audit import CONFOUNDED, DETECTION, ISOLATION
from trueaxis.diagnosis.null_model.freedom import freedom_of
from trueaxis.diagnosis.null_model.outliers import null_of
from trueaxis.diagnosis.null_model.projection import Projection, spanned
from trueaxis.diagnosis.null_model.rows import Rows, rows_of
from trueaxis.diagnosis.null_model.temperature import smoothed
from trueaxis.measurement.data import read_data
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.model.model import MachineModel, load_model

UNIT = 1e-3  # mm or rad, of the signature
CLOSEST = 5  # candidates whose searched parameters are looked at between the points of their grids


def outside_limit(case: Case) -> float:
    """The size of the effect of a case at its isolation limit, positive; infinite where it is not outside."""
    (effect,) = case.effects
    ground = _ground(replace(case, effects=()))
    signature = _exact(case, ground.readings.rows, replace(effect, size=UNIT)) - _exact(case, ground.readings.rows)
    white = ground.whitening(signature)
    of_unit = float(np.sum(ground.base.rest(white) ** 2))
    if of_unit < 1e-9 * float(white @ white):
        return np.inf
    ground = replace(ground, values=white)
    base = ground.base
    for _ in range(MOST_CAUSES):
        residual = ground.left(base)
        closest = sorted(scan_all(ground, residual, ground.effects), key=lambda one: -one.statistic)[:CLOSEST]
        best = max((zoomed(ground, residual, one) for one in closest), key=lambda one: one.scan.statistic)
        base = base.extended(whitened_columns(ground, best.signature))
    left = float(np.sum(base.rest(white) ** 2))
    if left < (1.0 - CONFOUNDED) * of_unit:
        return np.inf
    return UNIT * float(np.sqrt(max(DETECTION / of_unit, ISOLATION / left)))


def _exact(case: Case, kept: Rows, *effects: Hidden) -> Array:
    """(n,), mm, without noise, of the readings kept, in the order of the diagnosis."""
    rows, _ = _rows(replace(case, noise="none", given="exact", effects=effects))
    return np.asarray(rows.reading[np.isin(rows.row, kept.row)])


def _rows(case: Case) -> tuple[Rows, MachineModel]:
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        generate(case).write(folder)
        model = load_model(folder / "machine.toml", folder / "errors.json", derived(folder / "machine.toml"))
        return rows_of(smoothed(read_data(folder / "data", model.machine))), model


def _ground(case: Case) -> Ground:
    """What the diagnosis of data without effects searches on."""
    rows, model = _rows(case)
    values = rows.reading - expected_readings(model, rows.runs, rows.run, rows.positions, rows.context)
    null = null_of(model, rows, values, None)
    white = null.whitening
    plain = Projection(spanned(null.base.columns.whitened(white)))
    base = plain.softened(white(null.base.by_chance))
    return Ground(
        readings=readings_of(model, null.rows),
        effects=candidates(model, null.rows),
        whitening=white,
        plain=plain,
        base=base,
        wide=base,
        values=white(null.values),
        freedom=freedom_of(null.rows, white, null.noise),
        progress=lambda _: None,
    )
