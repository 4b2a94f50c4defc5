"""Cyclic errors on plans drawn at random: python -m tests.hidden_effects.pitches FIRST COUNT

One line of JSON a case on stdout, then how often the pitch was named alone and rightly, in a set that holds it, or
wrongly, and how often values that are right were called stale beside it. Targets are even, nearly even or irregular,
few or many; pitches have from 2 to 60 mm.
"""

import json
import sys
import time
from collections import Counter
from dataclasses import dataclass

import numpy as np

from tests.diagnosis.prepared import prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from trueaxis.diagnosis.procedure import DiagnoseOptions, diagnose
from trueaxis.diagnosis.result import Cause, Diagnosis

PITCHES = 2.0, 60.0  # mm
WITHIN = 3.0  # standard uncertainties by which a pitch that is named alone may be off


@dataclass(frozen=True)
class Answer:
    """pitch: right, wrong, set (holds it), wrong set, or none where no cyclic error of the axis was named; pitches: mm,
    those named; stale: components whose values are right.
    """

    pitch: str
    pitches: tuple[float, ...]
    stale: tuple[str, ...]


def drawn(seed: int) -> Case:
    source = np.random.default_rng([seed, 78])
    machine = str(source.choice(["table_mill", "gantry"]))
    off = {"even": 0.0, "nearly": float(source.uniform(0.5, 8.0)), "irregular": None}[
        str(source.choice(["even", "nearly", "nearly", "irregular"]))
    ]
    design = Design(
        lines=int(source.integers(1, 4)),
        repeats=int(source.integers(2, 5)),
        targets=int(np.exp(source.uniform(np.log(9.0), np.log(45.0)))),
        off=off,
        one_run=bool(source.random() < 0.3),
        ball_bar=bool(source.random() < 0.15),
        samples=36,
        feeds=(1000.0,),
    )
    sigma = float(np.exp(source.uniform(np.log(0.2), np.log(0.8))))
    size = 1e-3 * sigma * float(np.exp(source.uniform(np.log(2.0), np.log(15.0))))
    axis = str(source.choice(list("XYZ")))
    hidden = Hidden(
        "cyclic", f"E{axis}{axis}", size=size, shape=seed, pitch=float(np.exp(source.uniform(*np.log(PITCHES))))
    )
    return Case(
        seed,
        machine=machine,
        design=design,
        noise=str(source.choice(["white", "realistic"])),
        sigma_um=sigma,
        given=str(source.choice(["exact", "identified"])),
        effects=(hidden,),
    )


def graded(case: Case, said: Diagnosis) -> Answer:
    (hidden,) = case.effects
    stale = tuple(one.component for one in said.stale)
    named = [one for one in said.causes if (one.effect.kind, one.effect.component) == ("cyclic", hidden.component)]
    if not named:
        return Answer("none", (), stale)
    pitches = _pitches(named[0])
    values = tuple(value for value, _ in pitches)
    right = [abs(value - hidden.pitch) <= WITHIN * u for value, u in pitches]
    single = len(pitches) == 1
    return Answer(("right" if single else "set") if any(right) else ("wrong" if single else "wrong set"), values, stale)


def _pitches(cause: Cause) -> list[tuple[float, float]]:
    """Value and standard uncertainty of each that may be, mm."""
    sets = [cause.parameters, *(one.parameters for one in cause.rivals if one.effect == cause.effect)]
    return [(one.value, one.u) for parameters in sets for one in parameters if one.name == "pitch"]


def main(first: int, count: int) -> None:
    table: Counter[str] = Counter()
    for seed in range(first, first + count):
        start = time.process_time()
        case = drawn(seed)
        given = prepared(case)
        said = diagnose(given.model, given.data, DiagnoseOptions(ahead=False))
        answer = graded(case, said)
        table[answer.pitch] += 1
        table["stale"] += bool(answer.stale)
        design, (hidden,) = case.design, case.effects
        line = {
            "seed": seed,
            "pitch": answer.pitch,
            "true": round(hidden.pitch, 4),
            "named": [round(one, 4) for one in answer.pitches[:8]],
            "count": len(answer.pitches),
            "stale": answer.stale,
            "verdict": said.verdict,
            "causes": [(one.effect.label, len(one.rivals)) for one in said.causes],
            "plan": (case.machine, design.lines, design.repeats, design.targets, design.off, design.ball_bar),
            "hidden": (hidden.component, round(1e3 * hidden.size / case.sigma_um, 1), case.noise, case.given),
            "s": round(time.process_time() - start, 1),
        }
        print(json.dumps(line), flush=True)
    print(dict(table))


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]))
