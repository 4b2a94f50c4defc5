"""Geometric error models of machine tools: derived symbolically, run numerically.

    import trueaxis as ta

    ta.derive("machines/dmu60p.toml")                               # kernels and equations, into generated/
    model = ta.load_model("machines/dmu60p.toml")
    errors = ta.load_errors("machines/dmu60p_errors.json", model)
    there = ta.predict(model, errors, {"X": [0, 100, 200], "Y": 50.0})
    there.deviation, there.u                                        # (3, 3), mm

Files may be `str` or `Path`, tables are NumPy arrays in and out. What is wrong with a file is an `InputError` with
every fault, what is wrong with an argument a `ValueError` that names it. Nothing is imported before it is used; SymPy
by `derive` alone.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from trueaxis.compensation.tools import Cutter, Tool
    from trueaxis.evaluation.positioning_test import PositioningTest
    from trueaxis.identification.fit_quality import NotConvergedError
    from trueaxis.identification.weighting import NoiseModel
    from trueaxis.io.faults import Fault, InputError, RefusedError
    from trueaxis.jobs.compensate import Compensated, compensate
    from trueaxis.jobs.compensation_arguments import CompensationSettings
    from trueaxis.jobs.derive import Derivation, SolvedSystem, derive
    from trueaxis.jobs.diagnose import Diagnosed, diagnose
    from trueaxis.jobs.evaluate import evaluate
    from trueaxis.jobs.evaluated import EvaluatedCircle, EvaluatedDiagonals, EvaluatedPositioning
    from trueaxis.jobs.export import Exported, export
    from trueaxis.jobs.fit import Fitted, fit
    from trueaxis.jobs.fleet import FleetResult, fleet
    from trueaxis.jobs.identify import Identified, UnbelievableError, identify
    from trueaxis.jobs.import_readings import Imported, ImportedRun, import_readings
    from trueaxis.jobs.init import NewMachine, init
    from trueaxis.jobs.load import (
        DataFolder,
        Errors,
        load_data,
        load_errors,
        load_machine,
        load_model,
        save_data,
        save_errors,
    )
    from trueaxis.jobs.plan import Planned, plan
    from trueaxis.jobs.predict import Prediction, predict
    from trueaxis.jobs.report import Document, report
    from trueaxis.jobs.simulate import simulate
    from trueaxis.machine.machine import Machine
    from trueaxis.model.best_fit import Placement
    from trueaxis.model.context import Context
    from trueaxis.model.errors import ErrorValues
    from trueaxis.model.grid import Grid
    from trueaxis.model.model import MachineModel
    from trueaxis.monte_carlo.settings import Draws

__version__ = "0.2.0"
__all__ = [
    "Compensated",
    "CompensationSettings",
    "Context",
    "Cutter",
    "DataFolder",
    "Derivation",
    "Diagnosed",
    "Document",
    "Draws",
    "ErrorValues",
    "Errors",
    "EvaluatedCircle",
    "EvaluatedDiagonals",
    "EvaluatedPositioning",
    "Exported",
    "Fault",
    "Fitted",
    "FleetResult",
    "Grid",
    "Identified",
    "Imported",
    "ImportedRun",
    "InputError",
    "Machine",
    "MachineModel",
    "NewMachine",
    "NoiseModel",
    "NotConvergedError",
    "Placement",
    "Planned",
    "PositioningTest",
    "Prediction",
    "RefusedError",
    "SolvedSystem",
    "Tool",
    "UnbelievableError",
    "compensate",
    "derive",
    "diagnose",
    "evaluate",
    "export",
    "fit",
    "fleet",
    "identify",
    "import_readings",
    "init",
    "load_data",
    "load_errors",
    "load_machine",
    "load_model",
    "plan",
    "predict",
    "report",
    "save_data",
    "save_errors",
    "simulate",
]
_MODULES = {
    "compensation.tools": ("Cutter", "Tool"),
    "evaluation.positioning_test": ("PositioningTest",),
    "identification.fit_quality": ("NotConvergedError",),
    "identification.weighting": ("NoiseModel",),
    "io.faults": ("Fault", "InputError", "RefusedError",),
    "jobs.compensate": ("Compensated", "compensate",),
    "jobs.compensation_arguments": ("CompensationSettings",),
    "jobs.derive": ("Derivation", "SolvedSystem", "derive",),
    "jobs.diagnose": ("Diagnosed", "diagnose",),
    "jobs.evaluate": ("evaluate",),
    "jobs.evaluated": ("EvaluatedCircle", "EvaluatedDiagonals", "EvaluatedPositioning",),
    "jobs.export": ("Exported", "export",),
    "jobs.fit": ("Fitted", "fit",),
    "jobs.fleet": ("FleetResult", "fleet",),
    "jobs.identify": ("Identified", "UnbelievableError", "identify",),
    "jobs.import_readings": ("Imported", "ImportedRun", "import_readings",),
    "jobs.init": ("NewMachine", "init",),
    "jobs.load": (
        "DataFolder", "Errors", "load_data", "load_errors", "load_machine", "load_model", "save_data", "save_errors",
    ),
    "jobs.plan": ("Planned", "plan",),
    "jobs.predict": ("Prediction", "predict",),
    "jobs.report": ("Document", "report",),
    "jobs.simulate": ("simulate",),
    "machine.machine": ("Machine",),
    "model.best_fit": ("Placement",),
    "model.context": ("Context",),
    "model.errors": ("ErrorValues",),
    "model.model": ("MachineModel",),
    "model.grid": ("Grid",),
    "monte_carlo.settings": ("Draws",),
}  # fmt: skip
_HOME = {name: module for module, names in _MODULES.items() for name in names}


def __getattr__(name: str) -> Any:
    """The public name, from the module where it lives, which is imported now."""
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = globals()[name] = getattr(import_module(f"{__name__}.{_HOME[name]}"), name)
    return value


def __dir__() -> list[str]:
    return [*globals(), *__all__]
