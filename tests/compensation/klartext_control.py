"""A Heidenhain control: runs Klartext programs as its manual has them. Nothing of the package.

Axes are moved in machine coordinates: position = word + preset + datum shift + length of the tool (Z).
"""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
WORD = re.compile(r"(I?)(PR|PA|[XYZ])\s*([-+]?\d*\.?\d+|[-+]?\d+\.)")


@dataclass
class KlartextControl:
    """at: where the axes stand. runs: for each run of feed motions its points (3, n), arcs cut finely; rapids: ends."""

    at: list[float]
    preset: Sequence[float] = (0.0, 0.0, 0.0)
    lengths: Mapping[int, float] = field(default_factory=dict)
    finely: float = 1e-5  # mm between arcs and their chords

    def __post_init__(self) -> None:
        self.datum, self.length, self.unit, self.tool = [0.0] * 3, 0.0, 1.0, 0
        self.pole: list[float] | None = None
        self.rapids: list[list[float]] = []
        self.runs: list[list[list[float]]] = []
        self.feeding = self.ended = False
        self.numbers: list[int] = []

    def run(self, program: str) -> "KlartextControl":
        joined = re.sub(r"~\s*\n", " ", program)
        for line in joined.splitlines():
            found = re.match(r"\s*(\d+)\s", line)
            if found:
                self.numbers.append(int(found[1]))
            text = re.sub(r"^\s*\d+\s+", "", line).split(";")[0].strip()
            if text and not self.ended:
                self.block(text)
        return self

    def paths(self) -> list[FloatArray]:
        return [np.array(run).T for run in self.runs]

    def block(self, text: str) -> None:
        if match := re.match(r"BEGIN PGM \S+ (MM|INCH)", text):
            self.unit = 25.4 if match[1] == "INCH" else 1.0
        elif match := re.match(r"CYCL DEF 7\.[1-9]\s*(I?)([XYZ])\s*([-+]?[\d.]+)", text):
            row = "XYZ".index(match[2])
            self.datum[row] = float(match[3]) * self.unit + (self.datum[row] if match[1] else 0.0)
        elif match := re.match(r"TOOL CALL (\d+)", text):
            self.tool = int(match[1])
            self.length = self.lengths.get(self.tool, 0.0)
        elif text.startswith("END PGM"):
            self.ended = True
        elif match := re.match(r"(LP|L|CC|CP|CR|C)(?=\s|$)(.*)", text):
            self.path(match[1], match[2])
        if re.search(r"\bM0?(2|30)\b", text):
            self.ended = True

    def shift(self, row: int, machine: bool) -> float:
        return 0.0 if machine else self.preset[row] + self.datum[row] + (self.length if row == 2 else 0.0)

    def path(self, verb: str, words: str) -> None:
        machine = "M91" in words
        named = {name: (mark == "I", float(value)) for mark, name, value in WORD.findall(words)}
        end = self.at.copy()
        for name, (added, value) in named.items():
            if name in "XYZ":
                row = "XYZ".index(name)
                end[row] = value * self.unit + (self.at[row] if added else self.shift(row, machine))
        if verb == "CC":
            self.pole = end[:2]
            return
        if not named and verb == "L":
            return
        if verb == "L":
            self.go([end], rapid="FMAX" in words)
            return
        turn = 1 if "DR+" in words else -1
        if verb == "CR":
            radius = float(re.search(r"\bR([-+][\d.]+)", words)[1]) * self.unit  # type: ignore[index]
            self.arc(self.by_radius(end, radius, turn), end, turn)
            return
        assert self.pole is not None
        if verb == "C":
            self.arc(self.pole, end, turn)
            return
        size = math.dist(self.at[:2], self.pole)
        angle = math.atan2(self.at[1] - self.pole[1], self.at[0] - self.pole[0])
        if "PR" in named:
            size = named["PR"][1] * self.unit + (size if named["PR"][0] else 0.0)
        sweep = None
        if "PA" in named:
            added, value = named["PA"]
            sweep = math.radians(value) if added else None
            angle = angle + sweep if sweep is not None else math.radians(value)
        end[:2] = [self.pole[0] + size * math.cos(angle), self.pole[1] + size * math.sin(angle)]
        if verb == "LP":
            self.go([end], rapid="FMAX" in words)
        else:
            self.arc(self.pole, end, turn, sweep)

    def by_radius(self, end: list[float], radius: float, turn: int) -> list[float]:
        """The centre that lies to the left of the chord for a turn to the left by less than half."""
        x, y = end[0] - self.at[0], end[1] - self.at[1]
        chord = math.hypot(x, y)
        rise = math.sqrt(max(radius**2 - chord**2 / 4, 0.0)) * (1 if radius > 0 else -1) * turn
        return [self.at[0] + x / 2 - y / chord * rise, self.at[1] + y / 2 + x / chord * rise]

    def arc(self, centre: Sequence[float], end: list[float], turn: int, sweep: float | None = None) -> None:
        begin = math.atan2(self.at[1] - centre[1], self.at[0] - centre[0])
        finish = math.atan2(end[1] - centre[1], end[0] - centre[0])
        if sweep is None:
            sweep = turn * ((turn * (finish - begin)) % (2 * math.pi))
            if abs(sweep) < 1e-9 or math.dist(self.at[:2], end[:2]) < 1e-9:
                sweep = turn * 2 * math.pi
        first, last = math.dist(self.at[:2], centre), math.dist(end[:2], centre)
        count = max(2, math.ceil(abs(sweep) / math.sqrt(8 * self.finely / max(first, 0.01))))
        points = []
        for k in range(1, count + 1):
            share = k / count
            radius = first + share * (last - first)
            turned = begin + share * sweep
            points.append([
                centre[0] + radius * math.cos(turned), centre[1] + radius * math.sin(turned),
                self.at[2] + share * (end[2] - self.at[2]),
            ])  # fmt: skip
        self.go([*points[:-1], end], rapid=False)

    def go(self, points: list[list[float]], rapid: bool) -> None:
        if rapid:
            self.rapids.append(points[-1])
        else:
            if not self.feeding:
                self.runs.append([self.at.copy()])
            self.runs[-1] += points
        self.feeding = not rapid
        self.at = points[-1].copy()
