"""One case from its number to its line of JSON."""

import math
import tempfile
import time
import traceback
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.stats import chi2

from tests.hidden_effects.power.grade import FAILED, Name, grade
from tests.worlds.design import Design
from tests.worlds.diagnosis.answers import Answer, Engine, matched, said_of
from tests.worlds.diagnosis.cases import INTERVENTIONS, Bench, Case, draw_case
from tests.worlds.diagnosis.values import NoValuesError, earlier, write_case
from tests.worlds.readings import exact_readings, measure

Line = dict[str, Any]
ROOT = Path(__file__).resolve().parents[3]
FRAMES = 4
NEEDS_COLUMN = {"swapped": "directions", "shuffled": "time_s"}


def line_of(bench: Bench, number: int, kernels: Path, only: tuple[str, ...] = (), engine: Engine = said_of) -> Line:
    """kernels: folder where those of the world are kept. An error is a line, too."""
    found: Line = {"world": bench.design.seed, "case": number}
    start = time.process_time()
    try:
        case = draw_case(bench, number, only)
        found |= _of_case(case) | {"true_noise": _true_noise(bench.design)}
        needed = NEEDS_COLUMN.get(case.kind)
        if needed is not None and needed not in bench.design.columns:
            return found | {"grade": "not possible"}
        with tempfile.TemporaryDirectory() as place:
            answer = engine(Path(place), write_case(Path(place), kernels, bench.design, case))
        found |= _of_answer(case, answer) | {"stale_expected_p": _stale_p(bench, case)}
        if case.kind in INTERVENTIONS:
            found |= {"sound": found["grade"]} | _spoilt(bench.design, case, kernels, engine)
    except NoValuesError as error:
        return found | {"grade": "no values", "error": str(error)}
    except Exception as error:  # a diagnosis that breaks down is a result, and no reason to lose the others
        found |= {"grade": FAILED, "error": f"{type(error).__name__}: {error}"[:300], "at": _where(error)}
    return found | {"all_seconds": round(time.process_time() - start, 2)}


def _where(error: Exception) -> list[str]:
    """The innermost calls in this repository, outermost first."""
    frames = [f for f in traceback.extract_tb(error.__traceback__) if f.filename.startswith(str(ROOT))]
    return [f"{Path(f.filename).relative_to(ROOT)}:{f.lineno} {f.name}" for f in frames[-FRAMES:]]


def _of_case(case: Case) -> Line:
    hidden = [
        {
            "kind": one.effect.kind,
            "name": _text(one.name),
            "size": one.effect.size,
            "state": one.state,
            "times": one.times,
            "detection": _number(one.detection),
            "isolation": _number(one.isolation),
            "r2": round(one.r2, 4),
            "rival": _text(one.rival),
            "own": round(one.own, 4),
        }
        for one in case.hidden
    ]
    wear = None if case.wear is None else asdict(case.wear)
    return {"kind": case.kind, "given": case.given, "curves": case.truth.family, "hidden": hidden, "wear": wear}


def _of_answer(case: Case, answer: Answer) -> Line:
    truth = tuple(one.name for one in case.hidden)
    said = matched(answer.said, truth)
    audited = [answer.limits.get(name) for name in truth]
    return {
        "grade": grade(truth, said),
        "verdict": said.verdict,
        "sets": [[_text(name) for name in names] for names in said.sets],
        "sizes": list(said.sizes),
        "u": list(said.u),
        "checks": list(said.checks),
        "stale": list(answer.stale),
        "stale_p": answer.stale_p,
        "standardised": dict(answer.standardised),
        "noise": answer.noise,
        "audited": [None if one is None else [_number(value) for value in one] for one in audited],
        "outliers": answer.outliers,
        "seconds": round(answer.seconds, 2),
    }


def _true_noise(design: Design) -> float:
    """Root mean square over the readings of white noise, slow noise and steps of the display, um."""
    shop = design.shop
    squares = shop.white**2 + shop.slow_mm[design.plan.run] ** 2 + shop.resolution**2 / 12
    return float(f"{1e3 * np.sqrt(np.mean(squares)):.4g}")


def _spoilt(design: Design, case: Case, kernels: Path, engine: Engine) -> Line:
    with tempfile.TemporaryDirectory() as place:
        answer = engine(Path(place), write_case(Path(place), kernels, design, case, case.kind))
    truth = tuple(one.name for one in case.hidden)
    said = matched(answer.said, truth)
    kept = any(set(names) & set(truth) for names in said.sets)
    names = [[_text(name) for name in own] for own in said.sets]
    return {"spoilt_sets": names, "spoilt_verdict": said.verdict, "name_kept": kept}


def _stale_p(bench: Bench, case: Case) -> float | None:
    """The p value of the given values being right, by the true noise, in the readings of the case less what its hidden
    effects do; instruments and orders beyond DEGREE taken out. Values that were identified from readings as good as
    these are half as telling. None of zeros, and where the spec leaves out a location error.
    """
    if case.given == "zeros" or case.left_out:
        return None
    before = earlier(case)
    bare = measure(bench.design, replace(case.truth, effects=()), case.seed).reading
    ground = bench.flat
    white = ground.white(bare - exact_readings(bench.design, [before])[0])
    white = white - ground.instruments @ (ground.instruments.T @ white)
    within = ground.q.T @ white
    freedom = ground.q.shape[1] - ground.instruments.shape[1]
    beyond = float(np.sum(within**2)) - freedom
    return float(chi2.sf(freedom + (0.5 if case.given == "identified" else 1.0) * beyond, freedom))


def _text(name: Name) -> str:
    """`cross_axis EXX Y`, `laser_step X1-2`."""
    runs = ",".join(name.runs)
    return " ".join(part for part in (name.kind, name.component, name.axis, runs, name.end) if part)


def _number(value: float) -> float | None:
    return float(f"{value:.5g}") if math.isfinite(value) else None
