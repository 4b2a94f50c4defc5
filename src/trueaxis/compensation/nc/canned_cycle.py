"""A canned cycle of an NC program, as its words hold on from block to block."""

from collections.abc import Hashable, Mapping
from dataclasses import dataclass

from trueaxis.compensation.settings import Settings

MOST_REPEATS = 10_000
_Z_AND_R = "give both where the cycle begins, and again after a change to G90, G91, G20 or G21: controls differ there"
_ON_FANUC = "; --dialect fanuc says that the control keeps them under G91, as those of Fanuc and Haas do"


@dataclass(frozen=True, slots=True, kw_only=True)
class Cycle:
    """A canned cycle with its words as they hold on, as written: code (times ten), z and r, peck (0: none; whole_peck:
    without a decimal point), dwell (the text of its P word). initial: where the drilling axis was when it began, mm,
    machine coordinates, None: not known; frame: in which. absolute, inch: how z and r are written.
    """

    code: int
    z: float | None = None
    r: float | None = None
    peck: float = 0.0
    whole_peck: bool = False
    dwell: str = ""
    initial: float | None = None
    frame: Hashable = None
    absolute: bool = True
    inch: bool = False

    @property
    def name(self) -> str:
        """G81 and the like."""
        return f"G{self.code / 10:g}"

    @property
    def pecks(self) -> bool:
        """Whether it drills in steps."""
        return self.code in (730, 830)

    @property
    def in_one_peck(self) -> bool:
        """Whether a peck is no less than the whole way from R to Z."""
        if not self.pecks or self.z is None or self.r is None:
            return False
        return self.peck >= (self.r if self.absolute else 0.0) - self.z


@dataclass(frozen=True, slots=True, kw_only=True)
class DrillingCall:
    """A cycle that a SINUMERIK program calls, lengths as written, in the frame in force. depths: to which it drills one
    after another; none: no modal call from here on. top: where the feed begins; clear: where it ends. back: how far it
    goes back between depths, at the feed, 0: to the top, by rapid, and again to `ahead` above the depth before; None:
    what the control takes. dwells: the words of G4 at each depth, at the top between them, and at the last depth, empty
    for none. modal: whether it is called after each block that moves. axis: along which it says that it drills, empty:
    across the plane.
    """

    name: str = ""
    axis: str = ""
    depths: tuple[float, ...] = ()
    top: float = 0.0
    clear: float = 0.0
    back: float | None = 0.0
    ahead: float | None = None
    dwells: tuple[str, str, str] = ("", "", "")
    modal: bool = False


def repeats_of(parameters: Mapping[str, float], settings: Settings) -> int | None:
    """How often, by the words of a block; 0: never, the words are stored (Fanuc); None: that is no number."""
    count = parameters.get("L", parameters.get("K", 1.0))
    least = 0 if settings.dialect == "fanuc" else 1
    right = {"L", "K"} - parameters.keys() and count % 1 == 0 and least <= count <= MOST_REPEATS
    return int(count) if right else None


def z_and_r(settings: Settings, begins: bool) -> str:
    """What is to be done where no Z and R hold; begins: whether none were given, or they were not left by G91."""
    return _Z_AND_R + (_ON_FANUC if settings.dialect is None and not begins else "")


def whole_peck_in_mm(cycle: Cycle, settings: Settings) -> bool:
    """Whether Q counts mm, or inch, without a decimal point: on some Fanuc controls it counts least increments where
    other whole numbers do not.
    """
    return cycle.pecks and cycle.whole_peck and settings.undotted == "mm" and settings.dialect != "linuxcnc"


def peck_in_doubt(cycle: Cycle, settings: Settings) -> bool:
    """Whether such a Q more likely counts least increments, as it is deeper than the hole."""
    return whole_peck_in_mm(cycle, settings) and cycle.in_one_peck
