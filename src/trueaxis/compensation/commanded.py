"""Which axes a program has commanded so far: only those may get words that the program does not have."""

from collections.abc import Hashable, Iterable, Sequence
from enum import IntEnum

from trueaxis.compensation.machine import LINEAR


class Commanded(IntEnum):
    """How the position of an axis is known.

    A word put in for an axis that does not stand where it is taken to stand would move it there.
    """

    UNKNOWN = 0  # neither commanded nor stated
    DISPLACED = 1  # a tool change may have moved it
    STATED = 2  # by --start (FROM in a CL file)
    BY_INCREMENTS = 3  # by increments from there: an increment put in is right wherever the axis is
    STOPPED = 4  # commanded, but the operator may have moved it since, and moves it back if the way on is to be right
    ABSOLUTE = 5


class CommandedAxes:
    """Follows `Commanded` of every axis through a program.

    An axis that was commanded in another frame (work offset, tool length) counts as BY_INCREMENTS: its position in this
    one is known only as well as both offsets, which may be rough.
    linear_complete: whether all linear axes are ABSOLUTE. held: for G91 and G90 (index 0 and 1) whether each axis may
    get no word in a block that does not name it; empty where all may. elsewhere: whether each axis may stand anywhere;
    empty where none may. unnamed: whether each axis is a linear one that nothing in the program has moved yet; empty
    where none is.
    """

    def __init__(self, axes: tuple[str, ...], stated: Sequence[bool] = ()) -> None:
        """stated: for each axis whether the user states where it stands at first; empty: for all."""
        self._linear = [row for row, axis in enumerate(axes) if axis in LINEAR]
        self._commanded = [Commanded.STATED if known else Commanded.UNKNOWN for known in stated or [True] * len(axes)]
        self._frame: Sequence[Hashable] = [None] * len(axes)  # that positions are given in now
        self._given: list[Hashable] = [None] * len(axes)  # that each axis was commanded in
        self._jogged: set[int] = set()  # since a stop
        self._unnamed = set(self._linear)
        self._set(self._commanded)

    def _set(self, commanded: list[Commanded]) -> None:
        self._commanded = commanded
        self._known = [
            known if given == now else min(known, Commanded.BY_INCREMENTS)
            for known, given, now in zip(commanded, self._given, self._frame, strict=True)
        ]
        self.linear_complete = self.of(self._linear) == Commanded.ABSOLUTE
        self.unnamed = tuple(row in self._unnamed for row in range(len(commanded))) if self._unnamed else ()
        self.elsewhere = _below(self._known, Commanded.STATED)
        self.held = (_below(self._known, Commanded.BY_INCREMENTS), _below(self._known, Commanded.ABSOLUTE))

    def enter(self, frame: Sequence[Hashable]) -> None:
        """Positions are given in another frame from now on: for each axis what its offset is made of."""
        self._frame = frame
        self._set(self._commanded)

    def displace(self, rows: Iterable[int] | None = None) -> None:
        """Some axes (None: any) may have moved.

        Before the program's first motion that is part of where the user states that they stand.
        """
        if rows is None and len(self._unnamed) == len(self._linear):
            return
        moved = set(range(len(self._commanded)) if rows is None else rows)
        self._set([min(k, Commanded.DISPLACED) if row in moved else k for row, k in enumerate(self._commanded)])

    def lose(self, rows: Iterable[int]) -> None:
        """Nothing says where these axes stand now."""
        lost = set(rows)
        self._unnamed -= lost
        self._set([Commanded.UNKNOWN if row in lost else k for row, k in enumerate(self._commanded)])

    def name(self, rows: Iterable[int], known: Commanded) -> None:
        """The axes stand where the program says in the frame in force."""
        named = set(rows)
        self._jogged -= named
        self._unnamed -= named
        for row in named:
            self._given[row] = self._frame[row]
        self._set([known if row in named else k for row, k in enumerate(self._commanded)])

    def stop(self) -> None:
        """The operator may have moved any axis."""
        self._jogged = set(range(len(self._commanded)))
        self._set([min(known, Commanded.STOPPED) for known in self._commanded])

    def stands(self, rows: Iterable[int]) -> bool:
        """Whether axes stand where they are taken to stand, and no operator may have moved them since."""
        named = set(rows)
        return not named & self._jogged and self.of(named) >= Commanded.STATED

    def of(self, rows: Iterable[int]) -> Commanded:
        """The least certain of some axes."""
        return min((self._known[row] for row in rows), default=Commanded.ABSOLUTE)

    def command(self, written: Sequence[bool], absolute: bool) -> tuple[bool, ...]:
        """Take in a block with these axis words; returns `held` of it."""
        named = [row for row, named in enumerate(written) if named]
        if self.of(named) < (Commanded.ABSOLUTE if absolute else Commanded.BY_INCREMENTS):
            if absolute:
                self.name(named, Commanded.ABSOLUTE)
            else:
                raised = set(named)
                self._unnamed -= raised
                self._set(
                    [max(k, Commanded.BY_INCREMENTS) if row in raised else k for row, k in enumerate(self._commanded)]
                )
        return self.held[absolute]


def _below(known: Sequence[Commanded], least: Commanded) -> tuple[bool, ...]:
    return tuple(one < least for one in known) if min(known) < least else ()
