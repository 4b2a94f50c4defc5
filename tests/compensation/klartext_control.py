"""A Heidenhain control: runs Klartext programs as its manual has them. Nothing of the package.

Axes are moved in machine coordinates: position = word + preset + datum shift + length of the tool (Z).
"""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from tests.compensation.control_motions import Motions

WORD = re.compile(r"(I?)(PR|PA|[XYZ])\s*([-+]?\d*\.?\d+|[-+]?\d+\.)")


@dataclass
class KlartextControl(Motions):
    """preset: of the control, mm; lengths: of tools, mm."""

    preset: Sequence[float] = (0.0, 0.0, 0.0)
    lengths: Mapping[int, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.datum, self.length, self.unit, self.tool = [0.0] * 3, 0.0, 1.0, 0
        self.pole: list[float] | None = None
        self.ended = False
        self.numbers: list[int] = []
        self.cycle: dict[int, float] = {}  # values of CYCL DEF 200, 201, 203, 205; 0: which

    def run(self, program: str) -> "KlartextControl":
        joined = re.sub(r"(?:;[^\n]*)?~[ \t]*\n", " ", program)
        for line in joined.splitlines():
            found = re.match(r"\s*(\d+)\s", line)
            if found:
                self.numbers.append(int(found[1]))
            text = re.sub(r"^\s*\d+\s+", "", line).split(";")[0].strip()
            if text and not self.ended:
                self.block(text)
        return self

    def block(self, text: str) -> None:
        if match := re.match(r"BEGIN PGM \S+ (MM|INCH)", text):
            self.unit = 25.4 if match[1] == "INCH" else 1.0
        elif match := re.match(r"CYCL DEF 7\.[1-9]\s*(I?)([XYZ])\s*([-+]?[\d.]+)", text):
            row = "XYZ".index(match[2])
            self.datum[row] = float(match[3]) * self.unit + (self.datum[row] if match[1] else 0.0)
        elif match := re.match(r"TRANS DATUM (AXIS|RESET)(.*)", text):
            self.datum = [0.0] * 3 if match[1] == "RESET" else self.datum
            for _, axis, value in WORD.findall(match[2]):
                self.datum["XYZ".index(axis)] = float(value) * self.unit
        elif match := re.match(r"TOOL CALL (\d+)", text):
            self.tool = int(match[1])
            self.length = self.tip = self.lengths.get(self.tool, 0.0)
        elif text.startswith("END PGM"):
            self.ended = True
        elif match := re.match(r"CYCL DEF (20[0135])", text):
            self.cycle = {int(name): float(value) for name, value in re.findall(r"Q(\d+)=([-+\d.]+)", text)}
            self.cycle[0] = float(match[1])
        elif match := re.match(r"CYCL DEF 1\.([1-5])\s*(?:DIST|SET UP|DEPTH|PLNGNG|PECKG|DWELL|F)\s*([-+.\d]+)", text):
            self.cycle = {**(self.cycle if int(match[1]) > 1 else {}), int(match[1]): float(match[2]), 0: 1.0}
        elif match := re.match(r"(LP|L|CC|CP|CR|C)(?=\s|$)(.*)", text):
            self.path(match[1], match[2])
        if match := re.match(r"CYCL CALL POS X([-+\d.]+) Y([-+\d.]+) Z([-+\d.]+) FMAX", text):
            x, y, z = (float(value) for value in match.groups())
            self.path("L", f"X{x} Y{y} FMAX")
            self.drill({**self.cycle, 203: self.cycle[203] + z})
        elif re.search(r"\bM99\b|^CYCL CALL", text):
            self.drill(self.cycle)
        if re.search(r"\bM0?(2|30)\b", text):
            self.ended = True

    def shift(self, row: int, machine: bool) -> float:
        return 0.0 if machine else self.preset[row] + self.datum[row] + (self.length if row == 2 else 0.0)

    def drill(self, q: Mapping[int, float]) -> None:
        """By rapid to the set-up clearance, in pecks from the surface down, by rapid to the larger clearance.

        201 (reaming) goes in one step; 201, 203 and 205 come back to the clearance at a feed, 203 between pecks too.
        """
        if q[0] == 1.0:
            self.peck(q)
            return
        depth, clearance, bottom = q[203], q[203] + q[200], q[203] + q[201]
        back = q.get(208, 99999.0) == 99999.0
        self.deepen(clearance, True)
        ends, infeed = [], q.get(202, 0.0)
        while q[0] != 201.0 and depth - infeed > bottom:
            depth -= infeed
            ends.append(depth)
            infeed = max(infeed - q.get(212, 0.0), q.get(205, 0.0)) if q.get(212, 0.0) else infeed
        unbroken, begin = 0, q[203]
        for number, end in enumerate(ends):
            self.break_chips(begin, end, q)
            self.deepen(end, False)
            unbroken += 1
            if unbroken <= q.get(213, 0.0):  # a chip is broken instead
                self.deepen(end + q[256], True)
            else:
                unbroken = 0
                self.deepen(clearance, back or q[0] != 203.0)
                above = q[200]
                if q[0] == 205.0:  # from the upper to the lower distance, evenly
                    above = q[258] + (q[259] - q[258]) * (number / (len(ends) - 1) if number else 0.0)
                self.deepen(end + above, not q.get(373, 0.0))
            begin = end
        self.break_chips(begin, bottom, q)
        self.deepen(bottom, False)
        if not back:
            self.deepen(clearance, False)
        if back or q[204] > q[200]:
            self.deepen(q[203] + max(q[200], q[204]), True)

    def peck(self, q: Mapping[int, float]) -> None:
        """The older pecking: from where Z stands, back there by rapid after each infeed."""
        start = (self.at[2] - self.shift(2, False)) / self.unit
        bottom, depth = start - abs(q[1]) + q[2], start - abs(q[1]) - q[3]
        ahead = 0.6 if -q[2] <= 30.0 else min(-q[2] / 50.0, 7.0)
        self.deepen(start, True)
        while depth > bottom:
            self.deepen(depth, False)
            self.deepen(start, True)
            self.deepen(depth + ahead, True)
            depth -= q[3]
        self.deepen(bottom, False)
        self.deepen(start, True)

    def break_chips(self, begin: float, end: float, q: Mapping[int, float]) -> None:
        """Within an infeed, each Q257 of its way."""
        count = 1
        while q.get(257, 0.0) and begin - count * q[257] > end + 1e-9:
            self.deepen(begin - count * q[257], False)
            self.deepen(begin - count * q[257] + q[256], True)
            count += 1

    def deepen(self, value: float, rapid: bool) -> None:
        self.move([[*self.at[:2], value * self.unit + self.shift(2, False)]], rapid)

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
            self.move([end], rapid="FMAX" in words)
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
            self.move([end], rapid="FMAX" in words)
        else:
            self.arc(self.pole, end, turn, sweep)
