"""What is said before the faults of a program that has many: the one fact that explains them."""

from collections.abc import Iterator
from contextlib import contextmanager

from trueaxis.compensation.dialects import NAMES
from trueaxis.compensation.foreign import looks_like
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import LINEAR, ErrorModel
from trueaxis.compensation.nc.mistyped import COMMA, LETTER
from trueaxis.compensation.settings import Dialect
from trueaxis.io.faults import Fault, InputError

FEW = 3  # faults that are read one by one
_UNROLLABLE: tuple[Dialect | None, ...] = (None, "linuxcnc")


def overview(faults: FaultLog, model: ErrorModel, said: Dialect | None, seen: Dialect | None, head: str) -> list[Fault]:
    """What explains the faults. said: the control that the user names; seen: the one whose language it looks like;
    head: how the file begins.
    """
    if not faults.count:
        return []
    if (foreign := looks_like(head)) is not None:
        return [Fault(faults.file, "line 1", *foreign)]
    found = [*_mistyped(faults)]
    if said is not None and seen is not None and seen != said:
        found.append(Fault(faults.file, "", f"looks like a program for {NAMES[seen]}", f"--dialect {seen}"))
    elif faults.macros > FEW and said in _UNROLLABLE:
        found.append(
            Fault(faults.file, "", f"{faults.macros} blocks hold macros, variables or expressions",
                  "--via-linuxcnc has LinuxCNC's interpreter unroll them")
        )  # fmt: skip
    return [*found, *_travel(faults, model)]


@contextmanager
def foreign_first(file: str, head: str) -> Iterator[None]:
    """What the file looks like is said before the faults of an interpreter that was given it."""
    try:
        yield
    except InputError as error:
        if (foreign := looks_like(head)) is None:
            raise
        raise InputError([Fault(file, "line 1", *foreign), *error.faults]) from None


def _mistyped(faults: FaultLog) -> Iterator[Fault]:
    """Numbers that are mistyped throughout: by the settings of what wrote the program."""
    for what, remedy in ((COMMA, "numbers with a decimal point throughout"), (LETTER, "the digit 0 in each")):
        some = [fault for _, fault in faults.kept if what in fault.problem]
        if len(some) > FEW:
            first = some[0].problem.partition(": ")[2]
            yield Fault(
                faults.file, some[0].place, f"{len(some)} or more numbers are mistyped; the first: {first}", remedy
            )


def _travel(faults: FaultLog, model: ErrorModel) -> Iterator[Fault]:
    """Axes that many blocks take out of their travel, and by how much the program would have to be moved."""
    for axis, blocks in faults.outside.items():
        low, high = faults.reach[axis]
        lowest, highest = model.travel[axis]
        if blocks <= FEW:
            continue
        remedy = "another machine, or another clamping"
        if high - low <= highest - lowest:
            by = lowest - low if low < lowest else highest - high
            remedy = f"moved by {by:+.4g} {'mm' if axis in LINEAR else 'deg'} it fits: is the work offset right?"
        yield Fault(
            faults.file, "", f"{axis} reaches {low:.6g} to {high:.6g}, and its travel is from {lowest:g} to "
            f"{highest:g}: {blocks} blocks are outside", remedy,
        )  # fmt: skip
