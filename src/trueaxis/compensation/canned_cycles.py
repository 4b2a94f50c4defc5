"""The motions of canned cycles: G73 G81 G82 G83 G85 G86 G89, as LinuxCNC and Fanuc make them."""

from collections.abc import Hashable, Iterator
from dataclasses import dataclass

# The way back that breaks the chip (G73) and the way before the cut goes on (G83): LinuxCNC's 0.010 inch; on a Fanuc
# control a parameter.
CLEARANCE = 0.254  # mm
MOST_PECKS = 10_000

RAPID, FEED, DWELL, SPINDLE_STOP, SPINDLE_START = range(5)
Step = tuple[int, float]  # what is done, and to which position of the axis that drills (machine, mm)


@dataclass(frozen=True, slots=True, kw_only=True)
class Cycle:
    """A canned cycle with its words as they hold on, as written: code (times ten), z and r, peck (0: none), dwell (the
    text of its P word). initial: where the drilling axis was when it began, mm, machine coordinates, None: not
    known; frame: in which.
    absolute, inch: how z and r are written.
    """

    code: int
    z: float | None = None
    r: float | None = None
    peck: float = 0.0
    dwell: str = ""
    initial: float | None = None
    frame: Hashable = None
    absolute: bool = True
    inch: bool = False

    @property
    def name(self) -> str:
        """G81 and the like."""
        return f"G{self.code // 10}"

    @property
    def pecks(self) -> bool:
        """Whether it drills in steps."""
        return self.code in (730, 830)


def steps(code: int, r: float, bottom: float, clear: float, peck: float, dwells: bool) -> Iterator[Step]:
    """What a cycle does in one hole, from R on; r, bottom, clear (where it ends), peck: mm, machine coordinates."""
    if code in (730, 830):
        depth = r - peck
        while depth > bottom + 1e-9:
            yield FEED, depth
            if code == 830:
                yield RAPID, r
            yield RAPID, depth + min(CLEARANCE, r - depth)
            depth -= peck
    yield FEED, bottom
    if dwells and code in (820, 860, 890):
        yield DWELL, bottom
    if code == 860:
        yield SPINDLE_STOP, bottom
    if code in (850, 890):
        yield FEED, r
    if clear != r or code not in (850, 890):
        yield RAPID, clear
    if code == 860:
        yield SPINDLE_START, clear
