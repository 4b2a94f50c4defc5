"""A machine that executes a program in time: play that a motion has to take up, friction, lag; nothing of the package.

The control moves straight between words at the programmed feed, without braking. Every drive then follows its command
through its own play, and the errors of XyzMachine, polynomials and matrices, put the tool elsewhere.
"""

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
import numpy.typing as npt

from tests.compensation.analytic_machine import FloatArray, XyzMachine
from tests.compensation.control import strip

IntArray = npt.NDArray[np.int64]

SPACING = 0.05  # mm between samples
FEWEST = 4  # samples of a block
WORD = re.compile(r"([A-Z])\s*([-+]?[\d.]+)")


@dataclass(frozen=True)
class Samples:
    """Commands (3, n), mm, with their time, s."""

    commands: FloatArray
    time: FloatArray


@dataclass
class MovingMachine:
    """play: axis -> half its width, mm, at a position; lag: axis -> time constant of the position loop, s; friction:
    axis -> (mm by which the drive stays behind right after a reversal, what that dies away over, by `fades`: mm of its
    own way, s, or mm of the path); bent: component error -> function of all positions (3, n).
    """

    rigid: XyzMachine
    play: Mapping[str, Callable[[float], float]] = field(default_factory=dict)
    lag: Mapping[str, float] = field(default_factory=dict)
    friction: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    fades: Literal["way", "time", "path"] = "way"
    bent: Mapping[str, Callable[[FloatArray], FloatArray]] = field(default_factory=dict)

    def tool_path(self, samples: Samples) -> FloatArray:
        """Tool point in the workpiece frame, (3, n), mm."""
        errors = {name: bent(samples.commands) for name, bent in self.bent.items()}
        for row, axis in enumerate("XYZ"):
            name = f"E{axis}{axis}"
            command = samples.commands[row]
            drive = command
            if axis in self.lag:
                drive = drive + lagging(drive, samples.time, self.lag[axis])
            if axis in self.play:
                drive = drive + playing(drive, self.play[axis])
            if axis in self.friction:
                drive = drive + sticking(drive, *self.friction[axis], self._passed(samples, drive))
            errors[name] = errors.get(name, np.zeros_like(drive)) + drive - command
        return self.rigid.actual_with(samples.commands, np.zeros((3, 1)), errors)

    def _passed(self, samples: Samples, drive: FloatArray) -> FloatArray:
        """(n,): what has passed at each sample of what friction fades over."""
        if self.fades == "time":
            return samples.time
        steps = np.diff(samples.commands if self.fades == "path" else drive[np.newaxis], axis=1, prepend=np.nan)
        return np.asarray(np.cumsum(np.nan_to_num(np.sqrt((steps**2).sum(axis=0)))))


def playing(command: FloatArray, half: Callable[[float], float]) -> FloatArray:
    """Play: the driven part rests until the drive has crossed the gap, then is dragged along half a gap behind."""
    out = np.empty_like(command)
    driven = float(command[0])
    for index, at in enumerate(command.tolist()):
        gap = half(at)
        driven = min(max(driven, at - gap), at + gap)
        out[index] = driven - at
    return out


def lagging(command: FloatArray, time: FloatArray, constant: float) -> FloatArray:
    """First-order lag, solved exactly for a command that is straight between samples."""
    found, behind = [0.0], 0.0
    for way, step in zip(np.diff(command).tolist(), np.diff(time).tolist(), strict=True):  # lists: twice as fast
        if step > 0.0:
            kept = math.exp(-step / constant)
            behind = behind * kept - constant * (way / step) * (1.0 - kept)
        found.append(behind)
    return np.array(found)


def sticking(command: FloatArray, height: float, decay: float, passed: FloatArray) -> FloatArray:
    """Friction: after a reversal the slide rests until the drive has wound up by what it takes, then is let go.

    passed: (n,), what it fades over, counted from anywhere.
    """
    found, before = [0.0], float(passed[0])
    way, direction, turn = math.inf, 0.0, -math.inf
    for step, now in zip(np.diff(command).tolist(), passed[1:].tolist(), strict=True):
        if step:
            turned = step * direction < 0.0
            direction = math.copysign(1.0, step)
            way = abs(step) if turned else way + abs(step)
            turn = before if turned else turn
        found.append(-direction * min(way, height * math.exp(-(now - turn) / decay)))
        before = now
    return np.array(found)


def executed(program: bytes) -> Samples:
    """Samples of a program of straight moves in absolute mm; rapids run at 10 m/min."""
    at, motion, feed, now = [0.0, 0.0, 0.0], 0, math.nan, 0.0
    ends, counts, starts = [list(at)], [0], [0.0]  # of each move: end, samples, time at its start
    durations = [0.0]
    for line in program.decode("latin-1").splitlines():
        words = WORD.findall(strip(line))
        for letter, value in words:
            if letter == "G" and float(value) in (0.0, 1.0):
                motion = int(float(value))
            assert not (letter == "G" and float(value) in (2.0, 3.0, 91.0, 20.0)), line
            feed = float(value) if letter == "F" else feed
        named = dict(words)
        end = [float(named.get(axis, before)) for axis, before in zip("XYZ", at, strict=True)]
        way = math.dist(at, end)
        if way == 0.0:
            continue
        duration = way / ((feed if motion else 10_000.0) / 60.0)
        ends.append(end)
        counts.append(max(FEWEST, math.ceil(way / SPACING)) if motion else 1)
        starts.append(now)
        durations.append(duration)
        at, now = end, now + duration
    return _sampled(np.array(ends).T, np.array(counts), np.array(starts), np.array(durations))


def _sampled(ends: FloatArray, counts: IntArray, starts: FloatArray, durations: FloatArray) -> Samples:
    """The first end, then so many samples of each move at even distances, its end among them."""
    move = np.repeat(np.arange(counts.size), counts)
    share = (np.arange(move.size) - np.repeat(np.cumsum(counts) - counts, counts) + 1) / counts[move]
    points = ends[:, move - 1] + share * (ends[:, move] - ends[:, move - 1])
    return Samples(np.hstack([ends[:, :1], points]), np.concatenate([[0.0], starts[move] + share * durations[move]]))
