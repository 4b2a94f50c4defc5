"""The path mode about canned cycles that are written out for LinuxCNC.

LinuxCNC drills in exact path mode, and behind each hole puts the mode of before in force again. Motions that are
written out go in the mode that the program says: G64 could cut the bottom of a hole short.
"""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from trueaxis.compensation.linuxcnc.modes import written
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.settings import MM_PER_INCH

_TOLERANCES = "PQ"  # of the path, and of points in line that are left out


@dataclass(slots=True)
class PathMode:
    """code: that the program has said last, times ten, 0: none; tolerances: of G64, mm, by letter. in_cycle: whether
    G61 is in force that the program does not have.
    """

    code: int = 0
    tolerances: tuple[tuple[str, float], ...] = ()
    in_cycle: bool = False

    def take(self, block: Collection[int], parameters: Mapping[str, float], inch: bool) -> None:
        """Take in what a block sets, by its codes and the words with P and Q."""
        for code in codes.PATH_MODES:
            if code in block:
                unit = MM_PER_INCH if inch else 1.0
                given = tuple((letter, parameters[letter] * unit) for letter in _TOLERANCES if letter in parameters)
                self.code, self.tolerances, self.in_cycle = code, given if code == codes.CONTINUOUS else (), False

    @property
    def rounds(self) -> bool:
        """Whether the control may leave the path of a hole."""
        return not self.in_cycle and self.code in (0, codes.CONTINUOUS)

    def leave_cycle(self, inch: bool) -> str:
        """Behind a cycle: the block that puts the mode of the program in force again; empty where there is none."""
        if not self.in_cycle:
            return ""
        self.in_cycle = False
        if not self.code:  # that of the control is not known
            self.code = codes.EXACT_PATH
            return ""
        unit = MM_PER_INCH if inch else 1.0
        return " ".join(["G64", *(f"{letter}{written(value / unit)}" for letter, value in self.tolerances)])
