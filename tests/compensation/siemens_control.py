"""A SINUMERIK control: runs part programs as its manual has them. Nothing of the package.

Positions of the axes in machine coordinates: word + settable frame + programmable frame + length of the tool (Z).
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from tests.compensation.control_motions import Motions

N = r"([-+]?(?:\d+\.?\d*|\.\d+))"
WORD = re.compile(rf"\b(CR|[XYZIJKGMTDF])\s*=?\s*(?:(AC|IC)\(\s*{N}\s*\)|{N})")


@dataclass
class SiemensControl(Motions):
    """frames: settable, by G code, mm; lengths: of tools, mm."""

    frames: Mapping[int, Sequence[float]] = field(default_factory=dict)
    lengths: Mapping[int, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.settable: Sequence[float] = self.frames[54]
        self.program, self.length, self.unit = [0.0] * 3, 0.0, 1.0
        self.selected = self.spindle = 0
        self.motion, self.absolute = 0, True
        self.ended = False
        self.called: list[tuple[float, bool]] = []  # by MCALL, as written: to where in a hole, and whether by rapid

    def run(self, program: str) -> "SiemensControl":
        for line in program.splitlines():
            text = re.sub(r"^\s*(N\d+|:\d+)\s*", "", line.split(";")[0].replace('"', "'").strip())
            text = re.sub(r"'[^']*'", "", text)
            if text and not text.startswith("%") and not self.ended:
                self.block(text)
        return self

    def block(self, text: str) -> None:
        if match := re.match(r"(A?)TRANS\b(.*)", text):
            self.shift(match[2], bool(match[1]))
            return
        if re.match(r"(ROT|SCALE|MIRROR)\s*$", text):
            self.program = [0.0] * 3
            return
        if match := re.match(r"(MCALL\b)?\s*(?:CYCLE8([123])\((.*)\))?\s*$", text):
            hole = (self.deep_hole_of if match[2] == "3" else self.hole_of)(match[3]) if match[3] else []
            if match[1]:
                self.called = hole
            else:
                self.drill(hole)
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
                self.length = self.tip = self.lengths.get(self.spindle, 0.0)
        for name, _, value in words:
            if name == "D":
                self.length = self.lengths.get(self.spindle, 0.0) if value else 0.0
        self.go(
            {name: (way, value * self.unit) for name, way, value in words if name in "XYZIJK" or name == "CR"}, machine
        )
        self.ended |= any(name == "M" and value in (2.0, 30.0) for name, _, value in words)

    def hole_of(self, arguments: str) -> list[tuple[float, bool]]:
        """CYCLE81, CYCLE82: retraction, reference plane, clearance, depth or depth below the reference plane."""
        given = [float(text) if text.strip() else 0.0 for text in [*arguments.split(","), ""]]
        depth = given[3] if arguments.split(",")[3].strip() else given[1] - abs(given[4])
        return [(given[1] + abs(given[2]), True), (depth, False), (given[0], True)]

    def deep_hole_of(self, arguments: str) -> list[tuple[float, bool]]:
        """CYCLE83: RTP RFP SDIS DP DPR FDEP FDPR DAM DTB DTS FRF VARI AXN MDEP VRT DTD DIS1."""
        texts = [*arguments.split(","), *[""] * 20]
        given = [float(text) if text.strip() else 0.0 for text in texts]
        start, reference = given[1] + abs(given[2]), given[1]
        end = given[3] if texts[3].strip() else reference - abs(given[4])
        depth = given[5] if texts[5].strip() else reference - abs(given[6])
        degression, stroke, clear_chips = given[7], reference - depth, given[11] == 1.0
        share, degression = (-degression, 0.0) if degression < 0.0 else (1.0, degression)
        break_by = given[14] or 1.0 / self.unit
        total = (start - end) * self.unit
        anticipation = given[16] or (0.6 if total <= 30.0 else min(total / 50.0, 7.0)) / self.unit
        hole = [(start, True), (depth, False)]
        while depth > end:
            hole += [(start, True), (depth + anticipation, True)] if clear_chips else [(depth + break_by, False)]
            rest = depth - end
            stroke = max(stroke - degression, degression) if share == 1.0 else max(stroke * share, given[13])
            if degression and degression < rest <= 2.0 * degression:
                stroke = rest / 2.0
                hole += [(depth - stroke, False)]
                depth -= stroke
                hole += [(start, True), (depth + anticipation, True)] if clear_chips else [(depth + break_by, False)]
                stroke = rest
            depth = max(depth - stroke, end)
            hole.append((depth, False))
        return [*hole, (given[0], True)]

    def drill(self, hole: Sequence[tuple[float, bool]]) -> None:
        """Modes are as before."""
        for value, rapid in hole:
            self.move([[*self.at[:2], value * self.unit + self.origin(2, False)]], rapid)

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
        self.path(words, end, machine)
        if self.called:
            self.drill(self.called)

    def path(self, words: Mapping[str, tuple[str, float]], end: list[float], machine: bool) -> None:
        if self.motion < 2:
            self.move([end], self.motion == 0)
            return
        turn = 1 if self.motion == 3 else -1
        if "CR" in words:
            centre = self.by_radius(end, words["CR"][1], turn)
        else:
            centre = []
            for row, letter in enumerate("IJ"):
                way, value = words.get(letter, ("", 0.0))
                centre.append(value + self.origin(row, machine) if way == "AC" else self.at[row] + value)
        self.arc(centre, end, turn)
