"""Diagnoses made by hand, one for every verdict: 3 axes, lines both ways and circles, with the signatures drawn in."""

import math
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from trueaxis.diagnosis.further_runs.of_plan import Absence, Limit, NextRun, Placed, Separating, Told
from trueaxis.diagnosis.judging.structure import Check, StructureClass
from trueaxis.diagnosis.result import (
    AmplitudeOf,
    Cause,
    Circle,
    Diagnosis,
    ErrorNow,
    Estimate,
    Evidence,
    Gain,
    MeasuredWith,
    NoiseOf,
    Outlier,
    Residuals,
    SecondOrder,
    Stage,
    Stale,
    Verdict,
)
from trueaxis.effects.kind import Effect
from trueaxis.effects.library import BY_NAME

FloatArray = npt.NDArray[np.float64]
BACKLASH = Effect(kind="backlash", component="EXX")
LAG = Effect(kind="servo_lag", component="EXX")
CYCLIC = Effect(kind="cyclic", component="EYY")
COSINE = Effect(kind="laser_cosine", runs=("X-2", "X-3"))
CROSS = Effect(kind="cross_axis", component="EXX", axis="Y")
OFFSET = Effect(kind="point_offset", runs=("Y-1",), end="target")
CIRCLES_AGAIN = "circles in XY at another feed, both directions"
APART = Told(BACKLASH, "mm", 0.4e-3, 9e-3)
SEPARATING = Separating(cause=Placed(BACKLASH), run=CIRCLES_AGAIN, apart=(Placed(LAG),), told=APART)
NOISE = 0.0003
WIDTH = 0.0061


def residuals(targets: int = 41, repeats: int = 3, circle: int = 360, *, time: bool = True) -> Residuals:
    """Lines along X, Y, Z, to and fro, and circles in XY and ZX, both ways at two feeds; X has backlash."""
    rng = np.random.default_rng(7)
    runs: list[str] = []
    instruments: list[str] = []
    columns: list[dict[str, FloatArray]] = []
    for axis, name in enumerate("XYZ"):
        for line in range(3):
            there = np.linspace(0.0, 500.0, targets)
            way = np.concatenate([np.concatenate([there, there[::-1]])] * repeats)
            directions = np.zeros((3, way.size))
            directions[axis] = np.concatenate([np.concatenate([np.ones(targets), -np.ones(targets)])] * repeats)
            directions[axis, 0] = 0.0
            positions = np.full((3, way.size), 100.0)
            positions[axis] = way
            runs.append(f"{name}-{line + 1}")
            instruments.append("laser")
            nothing = np.full(way.size, np.nan)
            columns.append({"positions": positions, "directions": directions, "theta": nothing, "feed": nothing})
    for plane, (a, b) in {"XY": (0, 1), "ZX": (2, 0)}.items():
        for feed in (500.0, 3000.0):
            for turn in (1.0, -1.0):
                theta = turn * np.linspace(0.0, 2.0 * np.pi, circle, endpoint=False)
                positions = np.full((3, circle), 200.0)
                positions[a] += 150.0 * np.cos(theta)
                positions[b] += 150.0 * np.sin(theta)
                directions = np.zeros((3, circle))
                directions[a], directions[b] = -turn * np.sign(np.sin(theta)), turn * np.sign(np.cos(theta))
                runs.append(f"{plane}-{feed:g}-{'ccw' if turn > 0 else 'cw'}")
                instruments.append("ballbar")
                wrapped = np.arctan2(np.sin(theta), np.cos(theta))
                feeds = np.full(circle, feed)
                columns.append({"positions": positions, "directions": directions, "theta": wrapped, "feed": feeds})
    joined = {key: np.concatenate([one[key] for one in columns], axis=-1) for key in columns[0]}
    run = np.repeat(np.arange(len(runs)), [one["theta"].size for one in columns])
    count = run.size
    theta = joined["theta"]
    bar = np.isfinite(theta)
    sense = np.where(bar, np.cos(np.nan_to_num(theta)), np.isin(run, [0, 1, 2]).astype(float))
    sense = np.where(np.isin(run, range(13, 17)), np.sin(np.nan_to_num(theta)), sense)
    noise = rng.normal(0.0, NOISE, count)
    refitted = noise + WIDTH / 2.0 * joined["directions"][0] * sense
    shape = 0.004 * np.sin(np.radians(joined["positions"][0])) + 0.002 * np.where(bar, np.sin(2 * theta), 0.0)
    seconds = np.cumsum(np.full(count, 4.0))
    return Residuals(
        runs=tuple(runs),
        instruments=tuple(instruments),
        noise_groups=tuple(instruments),
        axes=("X", "Y", "Z"),
        row=np.arange(count),
        run=run,
        seq=np.concatenate([np.arange(one["theta"].size) for one in columns]),
        positions=joined["positions"],
        directions=joined["directions"],
        time=seconds if time else None,
        temperature=20.0 + 1.5 * (1.0 - np.exp(-seconds / 4000.0)) if time else None,
        feed=joined["feed"],
        theta=theta,
        along=np.where(bar, np.nan, joined["positions"][0]),
        reading=refitted + shape,
        given=refitted + 0.3 * shape,
        refitted=refitted,
        extended=noise,
        whitened=noise / NOISE,
    )


def cause(effect: Effect = BACKLASH, rivals: tuple[Evidence, ...] = (), separating: Separating | None = None) -> Cause:
    """With the sentence of its kind; of the size of the backlash drawn in."""
    return Cause(
        effect=effect,
        parameters=(Estimate("width", WIDTH, 0.0001, "mm"),),
        sentence=BY_NAME[effect.kind].sentence,
        formula=r"\delta_x(x) \leftarrow \delta_x(x) + \frac{width}{2}\,\sigma_x",
        p_value=1e-12,
        evidence=10.3,
        rms=0.0021,
        held_out_gain=0.84,
        rivals=rivals,
        amplitudes=(
            *(AmplitudeOf(f"X-{k}", WIDTH + 0.0002 * (k - 2), 0.0003) for k in range(1, 4)),
            AmplitudeOf("XY-500-ccw", WIDTH, 0.0002),
            AmplitudeOf("Y-1", math.nan, math.nan),
        ),
        homogeneous_p=0.41,
        remainder=False,
        separating=separating,
    )


RIVAL = Evidence(effect=LAG, evidence=9.4, p_value=1e-11, tries=40.0, freedom=1)
SCAN = (
    Evidence(effect=BACKLASH, evidence=10.3, p_value=1e-12, tries=40.0, freedom=1),
    RIVAL,
    Evidence(effect=CYCLIC, evidence=0.4, p_value=0.01, tries=40.0, freedom=2),
    Evidence(effect=COSINE, evidence=0.0, p_value=0.6, tries=40.0, freedom=1),
    Evidence(effect=CROSS, evidence=math.nan, p_value=math.nan, tries=40.0, freedom=1),
    Evidence(effect=OFFSET, evidence=-0.3, p_value=1.0, tries=40.0, freedom=3),
)
STALE = (
    Stale(component="EYY", first=300.0, last=400.0, value=0.0007, u=0.0001, unit="mm", p_value=1e-9),
    Stale(component="EC0X", first=None, last=None, value=-5.2e-6, u=4e-7, unit="rad", p_value=2e-7),
)
EFFECTS = (BACKLASH, LAG, CYCLIC, COSINE, CROSS, OFFSET)


def limits() -> tuple[Limit, ...]:
    """One of each state."""
    return (
        Limit(
            effect=BACKLASH,
            size="width",
            unit="mm",
            detection=0.0004,
            isolation=0.0006,
            share=0.98,
            nearest=LAG,
            r2=0.4,
            state="observable",
        ),
        Limit(
            effect=LAG,
            size="tau",
            unit="s",
            detection=0.00012,
            isolation=0.0002,
            share=0.9,
            nearest=BACKLASH,
            r2=0.4,
            state="observable",
        ),
        Limit(
            effect=CYCLIC,
            size="amplitude",
            unit="mm",
            detection=0.00022,
            isolation=0.00022,
            share=0.97,
            nearest=CROSS,
            r2=0.02,
            state="observable",
        ),
        Limit(
            effect=COSINE,
            size="angle",
            unit="rad",
            detection=0.0011,
            isolation=math.inf,
            share=0.5,
            nearest=OFFSET,
            r2=0.99,
            state="confounded",
        ),
        Limit(
            effect=CROSS,
            size="k",
            unit="mm",
            detection=math.nan,
            isolation=math.nan,
            share=0.0,
            nearest=None,
            r2=math.nan,
            state="unobservable",
            reason="lines at one offset only",
        ),
        Limit(
            effect=OFFSET,
            size="x",
            unit="mm",
            detection=0.2,
            isolation=math.inf,
            share=0.1,
            nearest=COSINE,
            r2=0.99,
            state="confounded",
        ),
    )


def correlation(count: int = len(EFFECTS)) -> FloatArray:
    """Backlash and servo lag 0.4 alike, laser cosine and the offset confounded."""
    r2 = np.eye(count)
    r2[0, 1] = r2[1, 0] = 0.4
    r2[3, 5] = r2[5, 3] = 0.99
    return r2


def diagnosis(verdict: Verdict) -> Diagnosis:
    """A diagnosis with this verdict, every field of it in use."""
    causes = {
        "explained": (cause(),),
        "ambiguous": (cause(rivals=(RIVAL,), separating=SEPARATING),),
    }.get(verdict, ())
    fired = verdict == "unexplained_structure"
    explained = verdict in ("explained", "ambiguous")
    left = 0.00031 if explained or verdict in ("no_discrepancy", "recalibrate") else 0.0032
    refitted = 0.0032 if explained or fired else left
    given = 0.0041 if verdict != "no_discrepancy" else left
    data = residuals()
    if verdict in ("no_discrepancy", "recalibrate"):
        data = replace(data, refitted=data.extended)
    if verdict == "no_discrepancy":
        data = replace(data, given=data.extended)
    if fired:
        data = replace(data, extended=data.refitted, whitened=data.refitted / NOISE)
    return Diagnosis(
        machine="mill <3 & more>",
        verdict=verdict,
        noise=(
            NoiseOf(
                instrument="laser",
                group="laser",
                white=0.00029,
                correlated=0.00008,
                correlation=0.4,
                settles=0.0001,
                freedom=180.0,
                origin="repeats",
                wanders=0.0002,
            ),
            NoiseOf(
                instrument="ballbar",
                group="ballbar",
                white=0.0003,
                correlated=0.0,
                correlation=0.0,
                settles=0.0,
                freedom=1e6,
                origin="given",
            ),
        ),
        causes=causes,
        limits=limits(),
        isolability=EFFECTS,
        correlation=correlation(),
        scan=SCAN if explained else tuple(replace(one, evidence=0.1, p_value=0.1) for one in SCAN),
        threshold=3.9,
        checks=(
            Check(structure=StructureClass.LINE_BY_LINE, place="X", p_value=1.0, fired=False, rms=0.00002),
            Check(
                structure=StructureClass.LINE_DIRECTION,
                place="X",
                p_value=1e-9 if fired else 0.3,
                fired=fired,
                rms=0.003 if fired else 3e-5,
            ),
        ),
        outliers=(Outlier("X-2", 17, 0.0042, 9.3),),
        stale=STALE if verdict == "recalibrate" else (),
        gain=Gain(
            rms=Stage(given, refitted, left),
            held_out=Stage(given, 1.03 * refitted, 1.03 * left),
            split="whole runs left out, one at a time",
            floor=0.0003,
            standardised=1.03,
        ),
        circles=(
            Circle(run="XY-500-ccw", measured=0.0123, given=0.0101, refitted=0.0098, extended=0.0016),
            Circle(run="XY-500-cw", measured=0.0119, given=0.0099, refitted=0.0097, extended=0.0015),
        ),
        recalibration_p=1e-8,
        next_runs=(NextRun(run=CIRCLES_AGAIN, pairs=((Placed(BACKLASH), (Placed(LAG),)),), told=APART),),
        absences=(Absence(lack="column", place="temperature_c", kinds=("thermal_offset",), empty=(3, 9)),),
        second_order=SecondOrder(2e-5, seen=False),
        residuals=data,
        measured=(
            MeasuredWith(
                instrument="laser",
                device="XL",
                serial="<7>",
                sessions=("Monday", "Tuesday"),
                runs=4,
                readings=320,
                motions=("X", "Y"),
                time_s=(0.0, 5400.0),
                temperature_c=(20.1, 21.4),
            ),
            MeasuredWith(
                instrument="ballbar",
                device="",
                serial="",
                sessions=(),
                runs=2,
                readings=720,
                motions=("XY",),
                time_s=None,
                temperature_c=None,
            ),
        ),
        errors=(
            ErrorNow(name="EXX", unit="mm", given=0.004, now=0.0061, change=0.0021, u=0.0003, determined="data"),
            ErrorNow(name="EC0Y", unit="rad", given=2e-5, now=2e-5, change=0.0, u=float("nan"), determined="prior"),
        ),
        report={"operator": "one & all", "date": "2024-05-06"},
    )
