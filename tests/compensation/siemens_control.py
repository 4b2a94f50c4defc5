"""A SINUMERIK control: runs part programs as its manual has them. Nothing of the package.

Positions of the axes in machine coordinates: word + settable frame + programmable frame + length of the tool (Z).
"""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
N = r"([-+]?(?:\d+\.?\d*|\.\d+))"
WORD = re.compile(rf"\b(CR|[XYZIJKGMTDF])\s*=?\s*(?:(AC|IC)\(\s*{N}\s*\)|{N})")


@dataclass
class SiemensControl:
    """at: where the axes stand. runs: points (n, 3) of each run of feed motions, arcs cut finely; rapids: ends."""

    at: list[float]
    frames: Mapping[int, Sequence[float]]
    lengths: Mapping[int, float] = field(default_factory=dict)
    finely: float = 1e-5  # mm between arcs and their chords

    def __post_init__(self) -> None:
        self.settable: Sequence[float] = self.frames[54]
        self.program, self.length, self.unit = [0.0] * 3, 0.0, 1.0
        self.selected = self.spindle = 0
        self.motion, self.absolute = 0, True
        self.runs: list[list[list[float]]] = []
        self.rapids: list[list[float]] = []
        self.feeding = self.ended = False

    def run(self, program: str) -> "SiemensControl":
        for line in program.splitlines():
            text = re.sub(r"^\s*(N\d+|:\d+)\s*", "", line.split(";")[0].replace('"', "'").strip())
            text = re.sub(r"'[^']*'", "", text)
            if text and not text.startswith("%") and not self.ended:
                self.block(text)
        return self

    def paths(self) -> list[FloatArray]:
        return [np.array(run).T for run in self.runs]

    def block(self, text: str) -> None:
        if match := re.match(r"(A?)TRANS\b(.*)", text):
            self.shift(match[2], bool(match[1]))
            return
        if re.match(r"(ROT|SCALE|MIRROR)\s*$", text):
            self.program = [0.0] * 3
            return
        if not re.search(r"[AI]C\(", text):
            text = re.sub(r"[A-Z_]{2,}\(.*?\)|[MS]\d+=\d+", "", text)
        words = [(name, way, float(a or b)) for name, way, a, b in WORD.findall(text)]
        machine = "SUPA" in text
        for name, _, value in words:
            if name == "G":
                self.code(value)
                machine |= value in (53.0, 153.0)
            elif name == "T":
                self.selected = int(value)
            elif name == "M" and value == 6.0:
                self.spindle = self.selected
                self.length = self.lengths.get(self.spindle, 0.0)
        for name, _, value in words:
            if name == "D":
                self.length = self.lengths.get(self.spindle, 0.0) if value else 0.0
        self.go(
            {name: (way, value * self.unit) for name, way, value in words if name in "XYZIJK" or name == "CR"}, machine
        )
        self.ended |= any(name == "M" and value in (2.0, 30.0) for name, _, value in words)

    def code(self, value: float) -> None:
        if value in (0.0, 1.0, 2.0, 3.0):
            self.motion = int(value)
        elif value in (90.0, 91.0):
            self.absolute = value == 90.0
        elif value in (70.0, 71.0, 700.0, 710.0):
            self.unit = 25.4 if value in (70.0, 700.0) else 1.0
        elif value == 500.0:
            self.settable = [0.0] * 3
        elif value in self.frames:
            self.settable = self.frames[int(value)]

    def shift(self, words: str, adding: bool) -> None:
        before = self.program if adding else [0.0] * 3
        named = {name: float(value) * self.unit for name, value in re.findall(rf"([XYZ])\s*=?\s*{N}", words)}
        self.program = [before[row] + named.get(axis, 0.0) for row, axis in enumerate("XYZ")]

    def origin(self, row: int, machine: bool) -> float:
        length = self.length if row == 2 else 0.0
        return length + (0.0 if machine else self.settable[row] + self.program[row])

    def go(self, words: Mapping[str, tuple[str, float]], machine: bool) -> None:
        end = self.at.copy()
        for row, axis in enumerate("XYZ"):
            if axis in words:
                way, value = words[axis]
                absolute = way == "AC" or (not way and self.absolute)
                end[row] = value + self.origin(row, machine) if absolute else self.at[row] + value
        if not any(axis in words for axis in "XYZ") and not any(letter in words for letter in "IJ"):
            return
        if self.motion < 2:
            self.move([end], self.motion == 0)
            return
        turn = 1 if self.motion == 3 else -1
        if "CR" in words:
            radius = words["CR"][1]
            x, y = end[0] - self.at[0], end[1] - self.at[1]
            chord = math.hypot(x, y)
            rise = math.sqrt(max(radius**2 - chord**2 / 4, 0.0)) * (1 if radius > 0 else -1) * turn
            centre = [self.at[0] + x / 2 - y / chord * rise, self.at[1] + y / 2 + x / chord * rise]
        else:
            centre = []
            for row, letter in enumerate("IJ"):
                way, value = words.get(letter, ("", 0.0))
                centre.append(value + self.origin(row, machine) if way == "AC" else self.at[row] + value)
        self.arc(centre, end, turn)

    def arc(self, centre: Sequence[float], end: list[float], turn: int) -> None:
        begin = math.atan2(self.at[1] - centre[1], self.at[0] - centre[0])
        finish = math.atan2(end[1] - centre[1], end[0] - centre[0])
        sweep = turn * ((turn * (finish - begin)) % (2 * math.pi))
        if abs(sweep) < 1e-9 or math.dist(self.at[:2], end[:2]) < 1e-9:
            sweep = turn * 2 * math.pi
        first, last = math.dist(self.at[:2], centre), math.dist(end[:2], centre)
        count = max(2, math.ceil(abs(sweep) / math.sqrt(8 * self.finely / max(first, 0.01))))
        points = []
        for k in range(1, count + 1):
            share = k / count
            radius, turned = first + share * (last - first), begin + share * sweep
            points.append([
                centre[0] + radius * math.cos(turned), centre[1] + radius * math.sin(turned),
                self.at[2] + share * (end[2] - self.at[2]),
            ])  # fmt: skip
        self.move([*points[:-1], end], rapid=False)

    def move(self, points: list[list[float]], rapid: bool) -> None:
        if rapid:
            self.rapids.append(points[-1])
        else:
            if not self.feeding:
                self.runs.append([self.at.copy()])
            self.runs[-1] += points
        self.feeding = not rapid
        self.at = points[-1].copy()
