"""Runs one after another: sessions, one clock, one course of temperature."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tests.worlds.machine import Array, Machine
from tests.worlds.plan import Measurement, Plan, Run, Track

Source = np.random.Generator

DAY = 86400.0  # s
SOAK_LAG = 3600.0  # s by which the structure follows the air
REPEATED = 0.35  # share of measurements that are taken again in another session
REFERENCE = 20.0  # degC


def schedule(source: Source, machine: Machine, measurements: Sequence[Measurement], sessions: int) -> Plan:
    """The plan: measurements in random order and sessions, some of them again in a later one."""
    where = np.sort(source.integers(0, sessions, len(measurements)))
    taken = [
        (session, [(replace(run, session=session), track) for run, track in measurement.runs])
        for session, measurement in zip(
            where.tolist(), [measurements[k] for k in source.permutation(len(measurements))], strict=True
        )
    ]
    for session, pairs in list(taken):
        if session < sessions - 1 and source.random() < REPEATED:
            again = int(source.integers(session + 1, sessions))
            taken.append((again, [(replace(r, id=f"{r.id}-s{again + 1}", session=again), t) for r, t in pairs]))
    taken.sort(key=lambda pair: pair[0])
    return _joined(source, machine, taken)


def _joined(source: Source, machine: Machine, taken: Sequence[tuple[int, list[tuple[Run, Track]]]]) -> Plan:
    clock, last = 0.0, 0
    runs: list[Run] = []
    tracks: list[Track] = []
    starts: list[float] = []
    for session, pairs in taken:
        clock += source.uniform(0.5, 2.5) * DAY if session != last else source.uniform(300.0, 1200.0)
        last = session
        for run, track in pairs:
            runs.append(run)
            tracks.append(track)
            starts.append(clock)
            clock += float(track.time[-1]) + source.uniform(30.0, 120.0)
    counts = [len(track.time) for track in tracks]

    def joined(name: str) -> dict[str, Array]:
        return {axis: np.concatenate([getattr(track, name)[axis] for track in tracks]) for axis in machine.axes}

    time = np.concatenate([start + track.time for start, track in zip(starts, tracks, strict=True)])
    air, soaked = _weather(source, time)
    return Plan(
        tuple(runs),
        np.repeat(np.arange(len(runs)), counts),
        np.concatenate([np.arange(count) for count in counts]),
        joined("positions"),
        joined("directions"),
        joined("since"),
        joined("path"),
        joined("turned"),
        joined("velocity"),
        time,
        np.concatenate([track.feed for track in tracks]),
        air,
        soaked,
    )


def _weather(source: Source, time: Array) -> tuple[Array, Array]:
    """Air and structure, degC: a wave of the day, a shop that warms up, a structure that follows late."""
    swing, phase = source.uniform(0.3, 2.0), source.uniform(0, 2 * np.pi)
    warm, tau = source.uniform(0.0, 2.0), source.uniform(1.0, 4.0) * 3600.0

    def course(at: Array, lag: float) -> Array:
        wave = swing * np.sin(2 * np.pi * (at - lag) / DAY + phase)
        return np.asarray(REFERENCE + wave + warm * (1.0 - np.exp(-np.maximum(at - lag, 0.0) / tau)), float)

    return course(time, 0.0), course(time, SOAK_LAG)
