"""A case put before the diagnosis, through the files that a user would have."""

import tempfile
from dataclasses import dataclass
from pathlib import Path

from tests.hidden_effects.case import Case, generate
from tests.hidden_effects.power.grade import Name, Said
from tests.kept import derived
from trueaxis.diagnosis.procedure import DiagnoseOptions, diagnose
from trueaxis.diagnosis.result import Diagnosis
from trueaxis.effects.kind import Effect
from trueaxis.measurement.data import read_data
from trueaxis.model.model import load_model
from trueaxis.reporting.diagnosis.structures import check_name


@dataclass(frozen=True)
class Bound:
    """The audit's word on one candidate, in the unit of its first parameter."""

    name: Name
    size: str
    detection: float
    isolation: float
    state: str
    rival: Name | None


def diagnosed(case: Case) -> Diagnosis:
    """The diagnosis of a case's data."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        generate(case).write(folder)
        model = load_model(folder / "machine.toml", folder / "errors.json", derived(folder / "machine.toml"))
        return diagnose(model, read_data(folder / "data", model.machine), DiagnoseOptions(ahead=False))


def said_of(found: Diagnosis) -> Said:
    sets = tuple((_name(c.effect), *(_name(rival.effect) for rival in c.rivals)) for c in found.causes)
    sizes = tuple(c.parameters[0].value for c in found.causes)
    u = tuple(c.parameters[0].u for c in found.causes)
    return Said(found.verdict, sets, sizes, u, tuple(check_name(check) for check in found.checks if check.fired))


def bounds_of(case: Case) -> tuple[Bound, ...]:
    """Limits of every candidate in data of this design and noise."""
    return tuple(
        Bound(
            _name(one.effect),
            one.size,
            one.detection,
            one.isolation,
            one.state,
            _name(one.nearest) if one.nearest else None,
        )
        for one in diagnosed(case).limits
    )


def _name(effect: Effect) -> Name:
    end = effect.end if effect.end == "reference" else ""
    return Name(effect.kind, effect.component or "", effect.axis or "", tuple(sorted(effect.runs)), end or "")
