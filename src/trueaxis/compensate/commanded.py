"""Which axes a program has commanded so far: only those may get words that the program does not have."""

from collections.abc import Iterable, Sequence
from enum import IntEnum

from trueaxis.compensate.machine import LINEAR


class Commanded(IntEnum):
    """How the position of an axis is known.

    A word put in for an axis that does not stand where it is taken to stand would move it there.
    """

    DISPLACED = 0  # a tool change may have moved it
    STATED = 1  # by --start (FROM in a CL file)
    BY_INCREMENTS = 2  # by increments from there: an increment put in is right wherever the axis is
    STOPPED = 3  # commanded, but the operator may have moved it since, and moves it back if the way on is to be right
    ABSOLUTE = 4


class CommandedAxes:
    """Follows `Commanded` of every axis through a program.

    linear_complete: whether all linear axes are ABSOLUTE. held: for G91 and G90 (index 0 and 1) whether each axis may
    get no word in a block that does not name it; empty where all may.
    """

    def __init__(self, axes: tuple[str, ...]) -> None:
        self._linear = [row for row, axis in enumerate(axes) if axis in LINEAR]
        self._set([Commanded.STATED] * len(axes))

    def _set(self, known: list[Commanded]) -> None:
        self._known = known
        self.linear_complete = self.of(self._linear) == Commanded.ABSOLUTE
        self.held = (_below(known, Commanded.BY_INCREMENTS), _below(known, Commanded.ABSOLUTE))

    def displace(self) -> None:
        """A tool change may have moved any axis."""
        self._set([Commanded.DISPLACED] * len(self._known))

    def stop(self) -> None:
        """The operator may have moved any axis."""
        self._set([min(known, Commanded.STOPPED) for known in self._known])

    def of(self, rows: Iterable[int]) -> Commanded:
        """The least certain of some axes."""
        return min((self._known[row] for row in rows), default=Commanded.ABSOLUTE)

    def command(self, written: Sequence[bool], absolute: bool) -> tuple[bool, ...]:
        """Take in a block with these axis words; returns `held` of it."""
        as_now = Commanded.ABSOLUTE if absolute else Commanded.BY_INCREMENTS
        if self.of(row for row, named in enumerate(written) if named) < as_now:
            self._set([max(k, as_now) if named else k for k, named in zip(self._known, written, strict=True)])
        return self.held[absolute]


def _below(known: Sequence[Commanded], least: Commanded) -> tuple[bool, ...]:
    return tuple(one < least for one in known) if min(known) < least else ()
