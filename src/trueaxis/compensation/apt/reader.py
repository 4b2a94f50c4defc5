"""Reads APT cutter location files (ISO 3592 as text) and gives NC items.

Coordinates are axis positions. GOTO, GODLTA, FROM, RAPID, FEDRAT, CIRCLE and UNITS are followed; post-processor words
become M codes or comments; whatever else may move or shift anything is a fault of its line.
"""

import math
from collections.abc import Callable, Iterable, Iterator

from trueaxis.compensation.apt import statements as words
from trueaxis.compensation.apt.statements import Statement, decimals_of, feed_of, follow_codes, number_of, statements
from trueaxis.compensation.arcs import Arc, ArcError, Circle, Vector, arcs_through, half_unit, unit
from trueaxis.compensation.dialects import unmarked
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.moves import Item, Kind, Move, Notes, Start
from trueaxis.compensation.nc.state import Commanded, CommandedAxes
from trueaxis.compensation.settings import MM_PER_INCH, Settings

_EOL = "\n"
_NEED_HEADER = frozenset({"GOTO", "GODLTA", "CIRCLE", "LOADTL", "SPINDL", "COOLNT", "AUXFUN"})


class AptReader:
    """Turns the lines of one CL file into items; faults and notes are gathered in the logs given."""

    def __init__(self, axes: tuple[str, ...], settings: Settings, faults: FaultLog, notes: Notes) -> None:
        self._axes = axes
        self._settings = settings
        self._commanded = CommandedAxes(axes)
        self._faults = faults
        self._notes = notes
        rotary = [settings.start.get(axis, 0.0) for axis in axes if axis not in LINEAR]
        self._rotary = tuple(rotary)
        given = [settings.start.get(axis) for axis in axes if axis in LINEAR]
        self._position: tuple[float, ...] | None = tuple(v for v in given if v is not None)
        if len(self._position) < 3:
            self._position = None
        self._inch = False
        self._headed = False
        self._rapid = False
        self._motion: int | None = None
        self._feed: tuple[str, str] | None = None  # mode (G94, G95) and word, to be written with the next cut
        self._feed_mode = "G94"
        self._per_minute = math.nan  # F in force, mm/min
        self._tool_axis: Vector | None = None
        self._circle: tuple[int, Circle] | None = None
        self._rounding = 0.0  # mm, half a unit of the numbers that gave the position
        self._along: list[tuple[int, Vector]] = []
        self._ended = 0
        missing = [axis for axis in axes if axis not in LINEAR and axis not in settings.start]
        if missing:
            remedy = f"give it by --start {''.join(f'{axis}0' for axis in missing)} (with its value)"
            faults.add(0, f"a CL file does not say where {' '.join(missing)} stands", remedy)
        if not set(LINEAR) <= set(axes):
            faults.add(0, f"a CL file gives X Y Z, and this machine has only {' '.join(axes)}")

    def items(self, lines: Iterable[str]) -> Iterator[Item]:
        """Items of the NC program that the CL file makes, in order."""
        yield f"%{_EOL}"
        if self._position is not None:
            yield Start(self._position + self._rotary)
        for statement in statements(unmarked(lines, self._faults)):
            if not self._headed and statement.major in _NEED_HEADER:
                yield f"{'G20' if self._inch else 'G21'} G17 G90 G94{_EOL}"
                self._headed = True
            speaks = statement.problem or statement.major not in {"", "GOTO"}
            if self._circle is not None and speaks:
                yield from self._finish_circle()
            if statement.comment is not None:
                yield words.comment(statement.comment) + _EOL
            if statement.problem:
                self._faults.add(statement.line, statement.problem)
            elif statement.major:
                yield from self._statement(statement)
        yield from self._finish_circle()
        if not self._ended:
            yield f"M30{_EOL}"
        yield f"%{_EOL}"

    def _statement(self, statement: Statement) -> Iterator[Item]:
        major = statement.major
        motions: dict[str, Callable[[Statement], Iterator[Item]]] = {
            "GOTO": self._goto, "GODLTA": self._delta, "FROM": self._from, "CIRCLE": self._open_circle,
            "RAPID": self._rapidly, "FEDRAT": self._feed_rate, "UNITS": self._units,
            "END": self._end, "FINI": self._end, "MSYS": self._system, "CSYS": self._system,
        }  # fmt: skip
        if self._ended and major not in {"FINI", *words.TEXT}:
            self._faults.add(statement.line, f"{major[:30]} after the end of the program in line {self._ended}")
        elif major in motions:
            yield from motions[major](statement)
        elif major in words.BLOCKS:
            yield from self._block(statement)
        elif major in words.IGNORED or (major in words.CAN_BE_OFF and words.is_off(statement)):
            if major not in words.TEXT:
                self._notes.add(statement.line, f"{major} is kept as a comment only")
            yield words.comment(statement.text.strip()) + _EOL
        elif major in words.FAULTY:
            self._faults.add(statement.line, f"{major} {words.FAULTY[major]}", "resolve it in the CL file")
        else:
            self._faults.add(
                statement.line,
                f"{major[:30]} is not a known statement",
                "only statements whose effect on positions is known are accepted",
            )

    def _rapidly(self, _: Statement) -> Iterator[Item]:
        self._rapid = True
        yield from ()

    def _end(self, statement: Statement) -> Iterator[Item]:
        if not self._ended:
            yield f"M30{_EOL}"
        self._ended = self._ended or statement.line

    def _block(self, statement: Statement) -> Iterator[Item]:
        if (text := words.BLOCKS[statement.major](statement)) is None:
            self._faults.add(statement.line, f"{statement.text.strip()[:60]!r} cannot be made an NC block")
            return
        if follow_codes(text, statement.line, self._commanded, self._settings, self._faults, self._notes):
            self._ended = self._ended or statement.line
        yield text + _EOL

    def _system(self, statement: Statement) -> Iterator[Item]:
        """A coordinate system: only the one that changes nothing (turned by nothing, shifted by nothing)."""
        numbers = self._numbers(statement, statement.minor)
        if numbers is not None and not words.changes_nothing(numbers):
            self._faults.add(statement.line, f"{statement.major} gives the positions in a shifted frame")
        elif numbers is not None:
            yield words.comment(statement.text.strip()) + _EOL

    def _numbers(self, statement: Statement, words: Iterable[str]) -> list[float] | None:
        values = []
        for word in words:
            value = number_of(word)
            if value is None:
                self._faults.add(statement.line, f"{statement.major}: {word[:30]!r} is no number of a machine")
                return None
            values.append(value)
        return values

    def _half_unit(self, numbers: Iterable[str]) -> float:
        """Half a unit of the last decimal of the longest of some numbers, mm."""
        return float(half_unit(max((decimals_of(number) for number in numbers), default=0), self._inch))

    def _point(self, statement: Statement) -> Vector | None:
        """Point of a GOTO or FROM, mm; checks that the tool axis stays parallel."""
        numbers = self._numbers(statement, statement.minor)
        if numbers is None:
            return None
        if len(numbers) not in (3, 6):
            self._faults.add(statement.line, f"{statement.major} has {len(numbers)} numbers", "x, y, z[, i, j, k]")
            return None
        if len(numbers) == 6:
            try:
                axis = unit(numbers[3:])
            except ArcError as problem:
                self._faults.add(statement.line, f"tool axis: {problem}")
                return None
            before = self._tool_axis
            if before is not None and max(abs(a - b) for a, b in zip(axis, before, strict=True)) > 1e-6:
                self._faults.add(statement.line, "the tool axis turns", "a CL file must keep one tool axis throughout")
                return None
            self._tool_axis = axis
        scale = MM_PER_INCH if self._inch else 1.0
        return (numbers[0] * scale, numbers[1] * scale, numbers[2] * scale)

    def _from(self, statement: Statement) -> Iterator[Item]:
        point = self._point(statement)
        if self._motion is not None:
            self._faults.add(statement.line, "FROM after the first motion")
        elif point is not None:
            self._position, self._rounding = point, self._half_unit(statement.minor[:3])
            yield Start(point + self._rotary)

    def _goto(self, statement: Statement) -> Iterator[Item]:
        point = self._point(statement)
        if point is None:
            return
        if self._circle is not None:
            if self._circle[1].holds(point, self._half_unit(statement.minor[:3])):
                self._along.append((statement.line, point))
                return
            yield from self._finish_circle()
        self._rounding = self._half_unit(statement.minor[:3])
        yield self._to(statement.line, point, None)

    def _delta(self, statement: Statement) -> Iterator[Item]:
        numbers = self._numbers(statement, statement.minor)
        if numbers is None:
            return
        if len(numbers) != 3 or self._position is None:
            self._faults.add(statement.line, "GODLTA needs dx, dy, dz and a known position before it")
            return
        scale = MM_PER_INCH if self._inch else 1.0
        x, y, z = (p + scale * d for p, d in zip(self._position, numbers, strict=True))
        self._rounding = max(self._rounding, self._half_unit(statement.minor))
        yield self._to(statement.line, (x, y, z), None)

    def _to(self, line: int, point: Vector, arc: Arc | None) -> Move:
        motion = 0 if self._rapid and arc is None else 1
        self._rapid = False
        lead = "" if motion == self._motion else f"G{motion} "
        self._motion = motion
        tail = ""
        if motion == 1 and self._feed is not None:
            mode, word = self._feed
            tail = f" {word}" if mode == self._feed_mode else f" {mode} {word}"
            self._feed_mode, self._feed = mode, None
        self._position = point
        kind = Kind.ARC if arc else Kind(motion)
        written = (True, True, True) + (False,) * len(self._rotary)
        known = self._commanded.of(range(3))
        if arc and known == Commanded.DISPLACED:
            self._faults.add(line, "a circle right after a tool change, which may have moved the axes", "GOTO first")
        elif arc and known == Commanded.STATED:
            self._notes.add(line, "a circle from a position that FROM or --start states: the tool must stand there")
        return Move(
            line, kind, point + self._rotary, written, True, self._inch, lead, tail, " ", _EOL, "", arc=arc,
            feed=self._per_minute, held=self._commanded.command(written, absolute=True),
            start_stated=arc is None and known < Commanded.STOPPED,
        )  # fmt: skip

    def _open_circle(self, statement: Statement) -> Iterator[Item]:
        yield from ()
        numbers = self._numbers(statement, statement.minor[:7])
        if numbers is None:
            return
        if len(numbers) < 7:
            self._faults.add(statement.line, "CIRCLE needs centre, axis and radius", "x, y, z, i, j, k, r")
            return
        if self._position is None:
            self._faults.add(statement.line, "the position before CIRCLE is not known", "give FROM or --start")
            return
        scale = MM_PER_INCH if self._inch else 1.0
        centre = (numbers[0] * scale, numbers[1] * scale, numbers[2] * scale)
        radius = numbers[6] * scale
        try:
            axis = unit(numbers[3:6])
        except ArcError as problem:
            self._faults.add(statement.line, f"axis of the circle: {problem}")
            return
        x, y, z = self._position
        circle = Circle(centre, axis, radius, self._half_unit(statement.minor[:7]))
        if not circle.holds((x, y, z), self._rounding):
            off = circle.distance((x, y, z))
            self._faults.add(
                statement.line,
                f"the position before CIRCLE is {off:.5f} mm off it; "
                f"rounding of its numbers explains {circle.allowed(self._rounding):.5f} mm",
            )
            return
        self._circle, self._rapid = (statement.line, circle), False

    def _finish_circle(self) -> Iterator[Item]:
        if self._circle is None or self._position is None:
            return
        line, circle = self._circle
        along, self._circle, self._along = self._along, None, []
        if not along:
            self._faults.add(line, "CIRCLE without a GOTO on it")
            return
        x, y, z = self._position
        try:
            arcs = arcs_through((x, y, z), [point for _, point in along], circle)
        except ArcError as problem:
            self._faults.add(line, str(problem))
            return
        for (number, point), arc in zip(along, arcs, strict=True):
            yield self._to(number, point, arc)

    def _units(self, statement: Statement) -> Iterator[Item]:
        unit_name = statement.minor[0].upper() if len(statement.minor) == 1 else ""
        if unit_name not in {"MM", "INCHES", "INCH"}:
            self._faults.add(statement.line, "UNITS is neither MM nor INCHES")
            return
        inch = unit_name != "MM"
        if inch != self._inch and self._motion is not None:
            self._faults.add(statement.line, "UNITS change after the first motion")
        if inch != self._inch and self._headed:
            yield f"{'G20' if inch else 'G21'}{_EOL}"
        self._inch = inch

    def _feed_rate(self, statement: Statement) -> Iterator[Item]:
        yield from ()
        words = [word.upper() for word in statement.minor]
        if words == ["RAPID"]:
            self._rapid = True
            return
        feed = feed_of(words, self._inch)
        if feed is None:
            self._faults.add(
                statement.line, "FEDRAT is not one positive number with MMPM, IPM, MMPR or IPR", "FEDRAT/100.0,MMPM"
            )
            return
        self._per_minute, self._feed = feed.per_minute, (feed.mode, feed.word)
