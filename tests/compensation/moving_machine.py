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

from tests.compensation.analytic_machine import FloatArray, XyzMachine
from tests.compensation.control import strip

SPACING = 0.05  # mm between samples
FEWEST = 4  # samples of a block


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
    out = np.zeros_like(command)
    behind = 0.0
    for index in range(1, command.size):
        step = time[index] - time[index - 1]
        if step > 0.0:
            kept = math.exp(-step / constant)
            speed = (command[index] - command[index - 1]) / step
            behind = behind * kept - constant * speed * (1.0 - kept)
        out[index] = behind
    return out


def sticking(command: FloatArray, height: float, decay: float, passed: FloatArray) -> FloatArray:
    """Friction: after a reversal the slide rests until the drive has wound up by what it takes, then is let go.

    passed: (n,), what it fades over, counted from anywhere.
    """
    out = np.zeros_like(command)
    way, direction, turn = math.inf, 0.0, -math.inf
    for index in range(1, command.size):
        step = float(command[index] - command[index - 1])
        if step:
            turned = step * direction < 0.0
            direction = math.copysign(1.0, step)
            way = abs(step) if turned else way + abs(step)
            turn = float(passed[index - 1]) if turned else turn
        out[index] = -direction * min(way, height * math.exp(-(float(passed[index]) - turn) / decay))
    return out


def executed(program: bytes) -> Samples:
    """Samples of a program of straight moves in absolute mm; rapids run at 10 m/min."""
    at, motion, feed, now = [0.0, 0.0, 0.0], 0, math.nan, 0.0
    points, times = [list(at)], [0.0]
    for line in program.decode("latin-1").splitlines():
        words = re.findall(r"([A-Z])\s*([-+]?[\d.]+)", strip(line))
        for letter, value in words:
            if letter == "G" and float(value) in (0.0, 1.0):
                motion = int(float(value))
            assert not (letter == "G" and float(value) in (2.0, 3.0, 91.0, 20.0)), line
            feed = float(value) if letter == "F" else feed
        end = [float(dict(words).get(axis, before)) for axis, before in zip("XYZ", at, strict=True)]
        way = math.dist(at, end)
        if way == 0.0:
            continue
        count = max(FEWEST, math.ceil(way / SPACING)) if motion else 1
        duration = way / ((feed if motion else 10_000.0) / 60.0)
        for number in range(1, count + 1):
            share = number / count
            points.append([a + share * (b - a) for a, b in zip(at, end, strict=True)])
            times.append(now + share * duration)
        at, now = end, now + duration
    return Samples(np.array(points).T, np.array(times))
