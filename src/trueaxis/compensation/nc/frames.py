"""In which frame the positions of an NC program are: work offset, G52, G92 and tool length, added up for each axis."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.offsets import Offsets, half_width, middle

Id = tuple[object, ...]


@dataclass(slots=True, kw_only=True)
class Frames:
    """The offsets of one program as it is read; values by row of the machine's axes, mm and deg.

    system: the work offset in force, None: machine coordinates; empty: it is not known which. tables: (value, half of
    its range) of every work offset that is known. local: of G52 or TRANS; reset: of G92; length: of the tool.
    stored: what G92.3 restores. machine_has_length: whether machine coordinates are those of the tip (SINUMERIK).
    """

    axes: tuple[str, ...]
    offsets: Offsets
    system: str | None = None
    machine_has_length: bool = False
    tables: dict[str, list[tuple[float, float]]] = field(default_factory=dict)
    local: list[float] = field(init=False)
    reset: list[float] = field(init=False)
    length: list[float] = field(init=False)
    stored: list[float] = field(init=False)
    unsaid: dict[str, str] = field(default_factory=dict)  # by work offset: linear axes of which it has no value
    _written: dict[tuple[str, int], int] = field(default_factory=dict)  # how often G10 has written a value
    _resets: list[int] = field(init=False)  # which G92 has set an axis, 0: none
    _stored_resets: list[int] = field(init=False)
    _tools: list[int] = field(init=False)  # whose length an axis has, 0: none

    def __post_init__(self) -> None:
        for name, values in self.offsets.systems.items():
            self.tables[name] = [
                (middle(of_axis), half_width(of_axis))
                for of_axis in (values.get(axis, (0.0, 0.0)) for axis in self.axes)
            ]
            if unsaid := "".join(axis for axis in LINEAR if axis in self.axes and axis not in values):
                self.unsaid[name] = unsaid
        self.system = self.offsets.first or ("" if self.tables else None)
        self.local, self.length = [0.0] * len(self.axes), [0.0] * len(self.axes)
        self.reset = [self.offsets.shift.get(axis, 0.0) for axis in self.axes]
        self.stored = self.reset.copy()
        self._resets = [int(shift != 0.0) for shift in self.reset]
        self._stored_resets, self._tools = self._resets.copy(), [0] * len(self.axes)

    def table(self, system: str | None = None) -> list[tuple[float, float]]:
        """Values and half ranges of a work offset; of the one in force by default."""
        none = [(0.0, 0.0)] * len(self.axes)
        name = system or self.system
        return none if name is None else self.tables.get(name, none)

    @property
    def shift(self) -> tuple[float, ...]:
        """Machine position minus word of each axis; empty in machine coordinates."""
        parts = zip(self.table(), self.local, self.reset, self.length, strict=True)
        found = tuple(base + local + reset + length for (base, _), local, reset, length in parts)
        return found if any(found) else ()

    @property
    def ids(self) -> tuple[Id, ...]:
        """For each axis what is known only roughly of its offset: a position in one frame says nothing certain of words
        in another. G52 is known exactly: it shifts by what the program says.
        """
        system = self.system
        written = [0 if system is None else self._written.get((system, row), 0) for row in range(len(self.axes))]
        return tuple((system, *parts) for parts in zip(written, self._resets, self._tools, strict=True))

    @property
    def of_machine(self) -> tuple[Id, ...]:
        """The same of machine coordinates."""
        if self.machine_has_length:
            return tuple((None, 0, 0, tool) for tool in self._tools)
        return ((None, 0, 0, 0),) * len(self.axes)

    @property
    def shift_of_machine(self) -> tuple[float, ...]:
        """Machine position minus word in machine coordinates: the tool's length where they are those of its tip."""
        return tuple(self.length) if self.machine_has_length and any(self.length) else ()

    @property
    def values(self) -> tuple[float, ...]:
        """Of the work offset in force, for each axis."""
        return tuple(value for value, _ in self.table())

    @property
    def spread(self) -> tuple[float, ...]:
        """Half of the range of each axis' offset."""
        return tuple(half for _, half in self.table())

    def write(self, system: str, values: Mapping[int, tuple[float, float]]) -> None:
        """G10: values and half ranges of a work offset, by row."""
        table = self.table(system).copy()
        unsaid = self.unsaid.get(system, LINEAR if system not in self.tables else "")
        named = {self.axes[row] for row in values}
        self.unsaid[system] = "".join(axis for axis in unsaid if axis in self.axes and axis not in named)
        for row, value in values.items():
            table[row] = value
            self._written[system, row] = self._written.get((system, row), 0) + 1
        self.tables[system] = table
        if not self.system and system == "G54":
            self.system = system  # what controls begin with

    def shift_locally(self, rows: Mapping[int, float], shared: bool) -> None:
        """G52; shared: whether it takes the place of G92, as on LinuxCNC."""
        for row, value in rows.items():
            if shared:
                self.reset[row], self._resets[row] = value, 0
            else:
                self.local[row] = value

    def shift_program(self, rows: Mapping[int, float], adding: bool) -> None:
        """TRANS, or ATRANS where it is added to the shift so far."""
        for row in range(len(self.axes)):
            self.local[row] = rows.get(row, 0.0) + (self.local[row] if adding else 0.0)

    def put(self, rows: Mapping[int, float], position: Sequence[float | None]) -> None:
        """G92: the axes of these rows have these values at the position where they stand (machine coordinates)."""
        latest = max(*self._resets, *self._stored_resets)
        for row, value in rows.items():
            at = position[row]
            if at is None:
                raise ValueError("G92 of an axis whose position is not known")
            self.reset[row] = at - self.table()[row][0] - self.local[row] - self.length[row] - value
            self._resets[row] = latest + 1
        self.stored, self._stored_resets = self.reset.copy(), self._resets.copy()

    def end_reset(self, forget: bool) -> None:
        """G92.1 and G92.2: nothing is shifted by G92; forget: what G92.3 would restore, too."""
        self.reset, self._resets = [0.0] * len(self.axes), [0] * len(self.axes)
        if forget:
            self.stored, self._stored_resets = self.reset.copy(), self._resets.copy()

    def restore_reset(self) -> None:
        """G92.3."""
        self.reset, self._resets = self.stored.copy(), self._stored_resets.copy()

    def take_length(self, lengths: Sequence[float], tool: int) -> None:
        """G43: the lengths of a tool, for each axis; 0: none.

        Tools of the same length in a table need not have the same one on the control.
        """
        for row, (axis, length) in enumerate(zip(self.axes, lengths, strict=True)):
            if length or self.length[row] or axis == "Z":
                self._tools[row] = tool
        self.length = list(lengths)

    @property
    def tool_of_length(self) -> int:
        """The tool whose length is in force in Z; 0: none, negative: a length that the program states."""
        return self._tools[self.axes.index("Z")] if "Z" in self.axes else 0

    def has_length_of(self, tool: int) -> bool:
        """Whether the length of this tool is in force; 0: none."""
        return not set(self._tools) - {0, tool} and (tool == 0 or tool in self._tools)
