"""Runs that are wrong, on plans drawn at random: python -m tests.hidden_effects.wrong_runs FIRST COUNT [FAULT ...]

One line of JSON a case on stdout, then how often each fault was named rightly (the wrong runs alone), in a set, as the
effect that it is, not at all, or wrongly. `none` is sound data.
"""

import json
import sys
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace

import numpy as np

from tests.diagnosis.prepared import Prepared, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from trueaxis.diagnosis.procedure import DiagnoseOptions, diagnose
from trueaxis.diagnosis.result import Diagnosis
from trueaxis.measurement.data import MeasuredData

FAULTS = ("none", "elsewhere", "sign", "swapped", "scale", "shifted", "point")
VISIBLE = 5.0  # times the noise (RMS) by which a wrong run has to differ for silence to count against the diagnosis


@dataclass(frozen=True)
class Wrong:
    """runs: the wrong ones; change: RMS of what they read too much, over the noise."""

    fault: str
    case: Case
    data: MeasuredData
    runs: tuple[str, ...]
    change: float


def drawn(seed: int, faults: Sequence[str] = FAULTS) -> Wrong:
    source = np.random.default_rng([seed, 77])
    fault = faults[seed % len(faults)]
    design = Design(
        lines=int(source.integers(2, 7)),
        repeats=int(source.integers(1, 6)),
        targets=int(source.integers(5, 22)),
        jitter=bool(source.random() < 0.5),
        one_run=bool(source.random() < 0.2),
        straightness=bool(source.random() < 0.4),
        diagonals=bool(source.random() < 0.4),
        ball_bar=bool(source.random() < 0.5),
        samples=36,
        feeds=(1000.0,),
        times=bool(source.random() < 0.7),
    )
    case = Case(
        seed,
        machine=str(source.choice(["table_mill", "gantry"])),
        design=design,
        noise=str(source.choice(["white", "realistic"])),
        sigma_um=float(np.exp(source.uniform(np.log(0.2), np.log(1.5)))),
        given=str(source.choice(["exact", "identified", "zero"])),
        effects=(Hidden("backlash", "EYY", size=-0.005),) if source.random() < 0.25 else (),
    )
    return spoilt(fault, case, prepared(case), source)


def spoilt(fault: str, case: Case, sound: Prepared, source: np.random.Generator) -> Wrong:
    readings = sound.data.readings
    lines: dict[str, list[int]] = {}
    for index, name in enumerate(readings.run_ids):
        lines.setdefault(name.split("-")[0] if "-F" not in name else name, []).append(index)
    bars = {name for name in lines if "-F" in name}
    of_laser = [name for name in lines if name not in bars]
    name = str(source.choice(of_laser if fault != "sign" or source.random() < 0.7 or not bars else sorted(bars)))
    whole = source.random() < 0.6  # all repeats, which agree with one another
    wrong = lines[name] if whole else [int(source.choice(lines[name]))]
    there = np.isin(readings.run, wrong)
    values = readings.reading.copy()
    if fault == "elsewhere":  # all repeats of a line read something else
        wrong, there = lines[name], np.isin(readings.run, lines[name])
        axis = max(range(len(readings.positions)), key=lambda k: float(np.ptp(readings.positions[k, there])))
        way = readings.positions[axis]
        size = float(np.exp(source.uniform(np.log(0.02), np.log(0.2))))
        values += size * there * np.sin(way / source.uniform(30.0, 120.0) + source.uniform(0.0, 6.0))
    elif fault == "sign":
        values[there] *= -1.0
    elif fault == "scale":
        values[there] *= float(np.exp(source.uniform(np.log(1.001), np.log(1000.0))))
    elif fault == "shifted":  # readings stand beside the next target
        for index in wrong:
            rows = np.flatnonzero(readings.run == index)
            values[rows] = np.roll(values[rows], 1)
    elif fault == "swapped":
        other = str(source.choice([one for one in of_laser if one != name and one[0] == name[0]] or of_laser))
        pairs = list(zip(lines[name], lines[other], strict=False))
        pairs = pairs if whole else pairs[:1]
        wrong = [index for pair in pairs for index in pair] if other != name else []
        for a, b in pairs:
            one, two = np.flatnonzero(readings.run == a), np.flatnonzero(readings.run == b)
            if one.size == two.size:
                values[one], values[two] = values[two].copy(), values[one].copy()
    elif fault == "point":
        wrong = lines[name]
        runs = tuple(readings.run_ids[index] for index in wrong)
        off = Hidden("point_offset", runs=runs, size=float(source.uniform(5.0, 60.0)))
        sound = prepared(replace(case, effects=(*case.effects, off)))
        values = sound.data.readings.reading.copy()
        return _wrong(fault, case, sound.data, prepared(case).data.readings.reading - values, wrong)
    data = replace(sound.data, readings=replace(readings, reading=values))
    return _wrong(fault, case, data, values - readings.reading, [] if fault == "none" else wrong)


def _wrong(fault: str, case: Case, data: MeasuredData, change: np.ndarray, wrong: Sequence[int]) -> Wrong:
    readings = data.readings
    seen = [change[readings.run == index] - np.mean(change[readings.run == index]) for index in wrong]
    size = float(np.sqrt(np.mean(np.square(np.concatenate([np.zeros(1), *seen])))))
    return Wrong(fault, case, data, tuple(readings.run_ids[index] for index in wrong), 1e3 * size / case.sigma_um)


def graded(one: Wrong, said: Diagnosis) -> str:
    """right: these runs alone; effect: one of these runs' set-up; set; silent; unexplained; wrong; small: not seen."""
    truth = set(one.runs)
    hidden = {(effect.kind, effect.component) for effect in one.case.effects}
    causes = [cause for cause in said.causes if (cause.effect.kind, cause.effect.component) not in hidden]
    of_runs = [cause for cause in causes if set(cause.effect.runs) & truth or cause.effect.kind == "laser_scale"]
    if any(cause not in of_runs and not _in_set(cause, hidden, truth) for cause in causes):
        return "wrong"
    named = set(said.misfits)
    if named:
        # of two runs swapped, or of a line, one names the fault; a run more is no right answer
        return "right" if named <= truth else "set" if named & truth else "wrong"
    if of_runs:
        return "effect"
    silent = "unexplained" if said.verdict == "unexplained_structure" else "silent"
    return silent if one.change >= VISIBLE or not truth else f"small, {silent}"


def _in_set(cause, hidden: set[tuple[str, str]], truth: set[str]) -> bool:  # type: ignore[no-untyped-def]
    rivals = [*cause.rivals]
    return any((r.effect.kind, r.effect.component) in hidden or set(r.effect.runs) & truth for r in rivals)


def main(first: int, count: int, faults: Sequence[str]) -> None:
    table: dict[str, Counter[str]] = {}
    for seed in range(first, first + count):
        start = time.process_time()
        one = drawn(seed, faults or FAULTS)
        try:
            said = diagnose(prepared(one.case).model, one.data, DiagnoseOptions(ahead=False))
        except Exception as error:  # a diagnosis that breaks down is a result, and no reason to lose the others
            table.setdefault(one.fault, Counter())["failed"] += 1
            print(
                json.dumps({"seed": seed, "fault": one.fault, "grade": "failed", "error": repr(error)[:200]}),
                flush=True,
            )
            continue
        grade = graded(one, said)
        table.setdefault(one.fault, Counter())[grade] += 1
        d = one.case.design
        print(
            json.dumps(
                {
                    "seed": seed,
                    "fault": one.fault,
                    "grade": grade,
                    "runs": one.runs,
                    "change": round(one.change, 1),
                    "misfits": said.misfits,
                    "verdict": said.verdict,
                    "causes": [(c.effect.label, [r.effect.label for r in c.rivals]) for c in said.causes],
                    "hidden": [(e.kind, e.component) for e in one.case.effects],
                    "plan": asdict(d),
                    "given": one.case.given,
                    "s": round(time.process_time() - start, 1),
                }
            ),
            flush=True,
        )
    for fault, grades in table.items():
        print(fault, dict(grades))


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), sys.argv[3:])
