"""What is said before the faults of a program that has many: the one fact that explains them."""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

from trueaxis.compensation.dialects import NAMES
from trueaxis.compensation.foreign import looks_like
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import LINEAR, ErrorModel
from trueaxis.compensation.nc.mistyped import Slip
from trueaxis.compensation.settings import Dialect
from trueaxis.io.faults import Fault, InputError

FEW = 3  # faults that are read one by one
_OFFSET = "is the work offset right?"
_NO_OFFSET = "no work offset is given; --offset G54=X..,Y..,Z.. says where the zero of the part lies in the machine"
_NO_PRESET = "no preset is given; --offset G54=X..,Y..,Z.. says where the one that is active on the control lies"
_MENDED = {Slip.COMMA: "numbers with a decimal point throughout", Slip.LETTER: "the digit 0 in each"}
_STEP = 0.001  # mm, deg: of the shifts that are named
_ROUNDING = 1e-6  # of a step: what doubles lose
_UNROLLABLE: tuple[Dialect | None, ...] = (None, "linuxcnc")


def raise_explained(faults: FaultLog, model: ErrorModel, said: Dialect | None, seen: Dialect | None, head: str) -> None:
    """Raise InputError where there are faults, what explains them first. said: the control that the user names; seen:
    the one whose language it looks like; head: how the file begins.
    """
    if not faults.count:
        return
    first: list[Fault] = []
    if (foreign := looks_like(head)) is not None:
        raise InputError([Fault(faults.file, "line 1", *foreign)])  # what its lines would be as blocks helps nobody
    if said is not None and seen is not None and seen != said:
        problem = f"looks like a program for {NAMES[seen]}"
        if faults.count > FEW:  # what each block would be for the control that is named helps nobody
            problem += f"; {faults.count} faults as one for {NAMES.get(said, said)} are not listed"
            raise InputError([Fault(faults.file, "", problem, f"--dialect {seen}")])
        first.append(Fault(faults.file, "", problem, f"--dialect {seen}"))
    elif faults.macros > FEW and said in _UNROLLABLE:
        first.append(
            Fault(faults.file, "", f"{faults.macros} blocks hold macros, variables or expressions",
                  "--via-linuxcnc (LinuxCNC installed here) has its interpreter unroll them")
        )  # fmt: skip
    faults.raise_if_any([*_mistyped(faults), *first, *_travel(faults, model, said or seen)])


@contextmanager
def foreign_alone(file: str, head: str) -> Iterator[None]:
    """What the file looks like is said in place of the faults of an interpreter that was given it."""
    try:
        yield
    except InputError as error:
        if (foreign := looks_like(head)) is None:
            raise
        raise InputError([Fault(file, "line 1", *foreign)]) from error


def _mistyped(faults: FaultLog) -> Iterator[Fault]:
    """Numbers that are mistyped throughout: by the settings of what wrote the program."""
    for slip, first in faults.first_mistyped.items():
        if (blocks := faults.mistyped[slip]) > FEW:
            problem = f"{blocks} blocks hold mistyped numbers; the first: {first.problem}"
            yield replace(first, problem=problem, remedy=_MENDED[slip])


def _travel(faults: FaultLog, model: ErrorModel, control: Dialect | None) -> Iterator[Fault]:
    """Axes that blocks take out of their travel, and by how much the program would have to be moved: where they are
    many, or no work offset is given, which then is the likely cause.
    """
    shifts = {axis: _shift(reach, model.travel[axis]) for axis, reach in faults.reach.items()}
    shifts = {axis: by for axis, by in shifts.items() if by != 0.0}
    blocks = faults.outside.total()
    fits = not any(math.isnan(by) for by in shifts.values())
    if not blocks or not shifts or (blocks <= FEW and (faults.placed or not fits)):
        return
    reached = ", ".join(
        "{} reaches {:.6g} to {:.6g}, and its travel is from {:g} to {:g}".format(
            axis, *faults.reach[axis], *model.travel[axis]
        )
        for axis in shifts
    )
    remedy = "another machine, or another clamping"
    if fits:
        moved = " ".join(f"{axis}{by:+.9g} {'mm' if axis in LINEAR else 'deg'}" for axis, by in shifts.items())
        cause = _OFFSET if faults.placed else _NO_PRESET if control == "heidenhain" else _NO_OFFSET
        remedy = cause if faults.by_tip else f"moved by at least {moved} it fits: {cause}"
    are = "block is" if blocks == 1 else "blocks are"
    yield Fault(faults.file, "", f"{reached}: {blocks} {are} outside", remedy)


def _shift(reach: tuple[float, float], travel: tuple[float, float]) -> float:
    """By how much an axis would have to be moved to stay within its travel, rounded up; NaN: it reaches too far."""
    (low, high), (lowest, highest) = reach, travel
    if high - low > highest - lowest:
        return math.nan
    by = max(lowest - low, 0.0) or min(highest - high, 0.0)
    return math.copysign(math.ceil(abs(by) / _STEP - _ROUNDING) * _STEP, by)
