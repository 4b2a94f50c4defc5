"""A control as shops have it: work offsets, tool lengths, reference points. Nothing of the package.

It runs a program, written or source, from wherever its axes stand, with the offsets that it has, and says where the
axes are in machine coordinates after every block: the program may believe what it likes.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

AXES = "XYZ"
ZERO = dict.fromkeys(AXES, 0.0)
SYSTEMS = {54: "G54", 55: "G55", 56: "G56", 57: "G57", 58: "G58", 59: "G59"}


@dataclass
class Control:
    """at: where the axes stand, machine coordinates, mm. offsets, lengths: of work offsets and tools (H numbers). tool:
    in the spindle, 0: none.
    """

    at: dict[str, float]
    offsets: dict[str, dict[str, float]] = field(default_factory=dict)
    lengths: Mapping[int, float] = field(default_factory=dict)
    references: Mapping[int, Mapping[str, float]] = field(default_factory=dict)
    system: str = "G54"
    linuxcnc: bool = True
    tool: int = 0

    def __post_init__(self) -> None:
        self.reset, self.local, self.length = dict(ZERO), dict(ZERO), 0.0
        self.absolute, self.unit, self.motion, self.inverse = True, 1.0, 0, False
        self.feed = 0.0
        self.selected = 0
        self.minutes = 0.0  # spent in feed motions under G93
        self.cycle: int | None = None
        self.level = True  # G98
        self.sticky: dict[str, float] = {}
        self.initial = 0.0
        self.number = 0
        self.trace: list[tuple[int, int, dict[str, float], int]] = []  # block number, motion, end, tool

    def shift(self, axis: str) -> float:
        base = self.offsets.get(self.system, ZERO)[axis]
        return base + self.reset[axis] + self.local[axis] + (self.length if axis == "Z" else 0.0)

    def run(self, program: str) -> list[tuple[int, int, dict[str, float], int]]:
        number = 0
        for line in program.splitlines():
            text = re.sub(r"\([^()]*\)|;.*", "", line).strip()
            if not text or text[0] in "%O":
                continue
            words = [(letter, float(value)) for letter, value in re.findall(r"([A-Z])\s*([-+]?[\d.]+)", text)]
            found = dict(words)
            number = int(found.get("N", number))
            self.block([round(value * 10) for letter, value in words if letter == "G"], found, number)
            if {("M", 2.0), ("M", 30.0)} & set(words):
                break
        return self.trace

    def block(self, codes: list[int], words: dict[str, float], number: int) -> None:
        self.number = number
        self.modes(codes, words)
        values = {axis: words[axis] * self.unit for axis in AXES if axis in words}
        if {100, 520, 920, 921, 922, 280, 300, 40} & set(codes):
            self.data(codes, words, values)
            return
        if self.drill(codes, words, values):
            return
        for axis, value in values.items():
            if 530 in codes:
                self.at[axis] = value
            elif self.absolute:
                self.at[axis] = value + self.shift(axis)
            else:
                self.at[axis] += value
        if values:
            if self.inverse and self.motion:
                assert words["F"] > 0.0, "a feed block under G93 without F"
                self.minutes += 1.0 / words["F"]
            self.trace.append((number, self.motion, dict(self.at), self.tool))

    def modes(self, codes: list[int], words: dict[str, float]) -> None:
        self.selected = int(words.get("T", self.selected))
        if words.get("M") == 6.0:
            self.tool = self.selected
        elif words.get("M") == 61.0:
            self.tool = int(words["Q"])
        for code in codes:
            self.absolute = {900: True, 910: False}.get(code, self.absolute)
            self.unit = {200: 25.4, 210: 1.0}.get(code, self.unit)
            self.motion = {0: 0, 10: 1, 20: 2, 30: 3}.get(code, self.motion)
            self.inverse = {930: True, 940: False, 950: False}.get(code, self.inverse)
            if code // 10 in SYSTEMS and code % 10 == 0:
                self.system = SYSTEMS[code // 10]
            if code == 490:
                self.length = 0.0
            if code == 430:
                number = int(words.get("H", self.tool)) or (self.tool if self.linuxcnc else 0)
                self.length = self.lengths[number] if number else 0.0

    def data(self, codes: list[int], words: dict[str, float], values: dict[str, float]) -> None:
        if 100 in codes and words["L"] == 2:
            self.offsets[f"G{53 + int(words['P'])}"].update(values)
        elif 100 in codes:
            table = self.offsets[f"G{53 + int(words['P'])}"]
            for axis, value in values.items():
                others = self.reset[axis] + self.local[axis] + (self.length if axis == "Z" else 0.0)
                table[axis] = self.at[axis] - others - value
        elif 520 in codes:
            (self.reset if self.linuxcnc else self.local).update(values)
        elif 920 in codes:
            for axis, value in values.items():
                self.reset[axis] += self.at[axis] - self.shift(axis) - value
        elif {921, 922} & set(codes):
            self.reset = dict(ZERO)
        for code in {280, 300} & set(codes):
            for axis, value in values.items():
                self.at[axis] = value + self.shift(axis) if self.absolute else self.at[axis] + value
            self.at.update({axis: self.references[code // 10][axis] for axis in values})

    def drill(self, codes: list[int], words: dict[str, float], values: dict[str, float]) -> bool:
        """Whether a canned cycle takes the block: RS274/NGC, Sect. 3.5.16 and on; in G17."""
        self.level = {980: True, 990: False}.get(max({980, 990} & set(codes), default=0), self.level)
        if {0, 10, 20, 30, 800} & set(codes):
            self.cycle = None
        started = {730, 810, 820, 830, 850, 860, 890} & set(codes)
        if started:
            if self.cycle is None:
                self.initial, self.sticky = self.at["Z"], {}
            self.cycle = started.pop()
        if self.cycle is None or not values:
            return False
        self.sticky.update({letter: words[letter] * self.unit for letter in "ZRQ" if letter in words})
        if self.absolute:
            r, bottom = (self.sticky[letter] + self.shift("Z") for letter in "RZ")
        else:
            r = self.at["Z"] + self.sticky["R"]
            bottom = r + self.sticky["Z"]
        clear = max(self.initial, r) if self.level else r
        for _ in range(int(words.get("L", 1))):
            if self.at["Z"] < r:
                self.to(0, Z=r)
            over = {axis: values[axis] for axis in "XY" if axis in values}
            self.to(0, **{a: v + (self.shift(a) if self.absolute else self.at[a]) for a, v in over.items()})
            self.to(0, Z=r)
            self.hole(r, bottom)
            if self.cycle in (850, 890):
                self.to(1, Z=r)
            self.to(0, Z=clear)
        return True

    def hole(self, r: float, bottom: float) -> None:
        if self.cycle in (730, 830):
            depth = r - self.sticky["Q"]
            while depth > bottom + 1e-9:
                self.to(1, Z=depth)
                if self.cycle == 830:
                    self.to(0, Z=r)
                self.to(0, Z=depth + 0.254)
                depth -= self.sticky["Q"]
        self.to(1, Z=bottom)

    def to(self, motion: int, **ends: float) -> None:
        if any(abs(self.at[axis] - value) > 1e-9 for axis, value in ends.items()):
            self.at.update(ends)
            self.trace.append((self.number, motion, dict(self.at), self.tool))
