"""The files of a case put before the diagnosis, and its answer by the keys of diagnosis.json.

Whatever engine there is, this is all that the campaign knows of it: `said_of` in this process, or by the command.
"""

import contextlib
import io
import json
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tests.hidden_effects.power.grade import Name, Said
from trueaxis.cli.main import main
from trueaxis.diagnosis.procedure import DiagnoseOptions, diagnose
from trueaxis.measurement.data import read_data
from trueaxis.model.model import load_model
from trueaxis.model.uncertainty import load_uncertainty
from trueaxis.reporting.diagnosis.json_file import diagnosis_json


@dataclass(frozen=True)
class Answer:
    """limits: name -> detection and isolation in the unit of the first parameter, and r2 with the nearest; stale:
    components that are; stale_p: of the given values being right; standardised: held-out readings over their predictive
    spread; noise: um; seconds: of CPU.
    """

    said: Said
    stale: tuple[str, ...] = ()
    stale_p: float | None = None
    standardised: Mapping[str, float] = field(default_factory=dict)
    noise: float | None = None
    limits: Mapping[Name, tuple[float, float, float]] = field(default_factory=dict)
    seconds: float = 0.0
    outliers: int = 0


Engine = Callable[[Path, Path], Answer]


def said_of(folder: Path, kernels: Path) -> Answer:
    """The answer to machine.toml, errors.json and data of a folder, in this process."""
    start = time.process_time()
    model = load_model(folder / "machine.toml", folder / "errors.json", kernels)
    covariance = load_uncertainty(folder / "errors.json", model.errors, model.machine)
    options = DiagnoseOptions(covariance=covariance, ahead=False)
    found = diagnose(model, read_data(folder / "data", model.machine), options)
    seconds = time.process_time() - start
    return answer_of(json.loads(diagnosis_json(found, None, None)), seconds)


def said_by_command(folder: Path, kernels: Path) -> Answer:
    """The same by the command line, report and extended model included. Raises RuntimeError where it fails."""
    start = time.process_time()
    arguments = ["diagnose", str(folder / "machine.toml"), "--errors", str(folder / "errors.json")]
    arguments += ["--data", str(folder / "data"), "--out", str(folder / "out"), "--kernels", str(kernels)]
    said = io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        code = main(arguments)
    file = folder / "out" / "diagnosis.json"
    if code > 1 or not file.exists():
        raise RuntimeError(f"diagnose ended with {code}: {said.getvalue()[-300:]}")
    return answer_of(json.loads(file.read_text()), time.process_time() - start)


def answer_of(tree: Mapping[str, Any], seconds: float = 0.0) -> Answer:
    """From the keys that the contract fixes, and those of limits and checks where they are there."""
    causes = tree["causes"]
    sets = tuple((_name(cause), *map(_name, cause.get("cannot_be_told_from", ()))) for cause in causes)
    first: list[Mapping[str, Any]] = [next(iter(cause["parameters"].values()), {}) for cause in causes]
    sizes, u = (tuple(float(one.get(key) or 0.0) for one in first) for key in ("value", "u"))
    checks = tuple(str(c.get("id", c.get("check"))) for c in tree.get("checks", ()) if c.get("fired", True))
    gain = tree["gain"]
    standardised = gain.get("held_out_standardised")
    if isinstance(standardised, int | float):
        standardised = {"extended": float(standardised)}
    return Answer(
        said=Said(tree["verdict"], sets, sizes, u, checks),
        stale=tuple(str(one["component"]) for one in tree.get("stale", ())),
        stale_p=tree.get("recalibration_p"),
        standardised={key: value for key, value in (standardised or {}).items() if value is not None},
        noise=tree.get("noise_um"),
        limits={_name(one): _limit(one) for one in tree.get("limits", ()) if one.get("detection") is not None},
        seconds=seconds,
        outliers=len(tree.get("outliers", ())),
    )


def _limit(one: Mapping[str, Any]) -> tuple[float, float, float]:
    far = float("inf")
    isolation, r2 = one.get("isolation"), one.get("r2")
    return float(one["detection"]), far if isolation is None else float(isolation), float(r2 or 0.0)


def _name(one: Mapping[str, Any]) -> Name:
    """Of a cause, a rival or a limit."""
    end = one.get("end") or ""
    runs = tuple(sorted(one.get("runs") or ()))
    component = "" if runs else one.get("component") or ""
    return Name(one["effect"], component, one.get("axis") or "", runs, end if end == "reference" else "")


def matched(said: Said, truth: tuple[Name, ...]) -> Said:
    """With names that mean an effect that is there by the very name of it: of a set-up the diagnosis may name all runs,
    or those of a session.
    """
    return Said(
        said.verdict, tuple(tuple(_as(n, truth) for n in names) for names in said.sets), said.sizes, said.u, said.checks
    )


def _as(name: Name, truth: tuple[Name, ...]) -> Name:
    """A bar of another length in some runs and another zero of these are the same numbers."""
    for one in truth:
        alike = one.kind == name.kind or (one.kind == "ballbar_length" and name.kind == "reading_zero")
        if one.runs and alike and one.end == name.end:
            own, other = set(one.runs), set(name.runs)
            if not other or own <= other or other <= own:
                return one
    return name
