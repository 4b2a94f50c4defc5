"""The codes that shift the frame of an NC program's positions: G54 to G59.3, G10, G52, G92."""

from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.moves import Item, Notes, Setup, Zero
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc.lexer import Block, Meaning, block_text
from trueaxis.compensation.nc.state import Commanded, NcState
from trueaxis.compensation.offsets import NOT_KNOWN, NUMBERED
from trueaxis.compensation.settings import Settings

_OF_ALL = 6  # G54 to G59 exist on all controls; the others of `NUMBERED` on LinuxCNC alone
CUT_OFF = "the program ends without {}: is it whole?"
FIRST = "no work offset is selected yet: G54 is taken to be in force"
_LINUXCNC = "say --dialect linuxcnc if that is the control"


class FrameReader:
    """Follows the frames of one program in its state."""

    def __init__(self, state: NcState, settings: Settings, faults: FaultLog, notes: Notes) -> None:
        self._state, self._faults, self._notes = state, faults, notes
        self._on_linuxcnc = settings.dialect == "linuxcnc"
        self._on_fanuc = settings.dialect == "fanuc"
        self._setup = Setup()
        self._touched = {one.system for one in settings.touched_off}
        self._said = False  # whether the program has selected a work offset
        self._unknown: set[str] = set()  # work offsets that are selected and not given
        self._reset = False  # whether it has said what G92 shifts by

    def apart(self, items: list[Item]) -> list[Item]:
        """Motions in machine coordinates: not from the datum of the work offset in force, where that was touched off
        without compensation.
        """
        if self._state.frames.system not in self._touched:
            return items
        return [*self.changed(in_machine=True), *items, *self.changed()]

    def changed(self, in_machine: bool = False) -> list[Item]:
        """What holds from here on, where it differs from what held before; in_machine: for a motion in machine
        coordinates.
        """
        state, frames = self._state, self._state.frames
        system = "" if in_machine else frames.system or ""
        setup = Setup(
            system, frames.values if system else (), frames.spread if system else (), state.tool, state.point_control
        )
        state.enter_frame()
        if setup == self._setup:
            return []
        self._setup = setup
        return [setup]

    def select(self, number: int, meaning: Meaning) -> list[Item]:
        """Take in what a block says of work offsets and the end of shifts."""
        if meaning.system:
            self._system(number, meaning.system)
        if meaning.codes & {codes.END_SHIFT, codes.SUSPEND_SHIFT, codes.RESTORE_SHIFT}:
            self._end_shift(number, meaning)
        return self.changed()

    @property
    def selected(self) -> str:
        """The work offset that the program has selected, where nothing is to be said of it if it does so again; else
        empty.
        """
        system = self._state.frames.system
        return system if self._said and system and system not in self._state.frames.unsaid else ""

    def note_first(self, number: int) -> None:
        """Note, at the first motion, that the work offset in force is not the program's choice."""
        frames = self._state.frames
        if frames.unsaid and frames.system:
            self._whole(number, frames.system)
        if not self._said and frames.system and frames.offsets.active is None:
            self._notes.add(number, FIRST)
            self._said = True

    def note_end(self, end: str) -> None:
        """Note, behind a program, that it moves without any work offset, and that it has no end where one is due: what
        ends such a program, or empty.
        """
        if self._state.moved and not self._said and not self._state.frames.system:
            self._notes.unplaced = True
        if end and not self._state.ended:
            self._notes.warn(0, CUT_OFF.format(end))

    def _whole(self, number: int, name: str) -> None:
        """A fault, once, where a work offset under which the program moves lacks the value of a linear axis."""
        if missing := self._state.frames.unsaid.pop(name, ""):
            words = ",".join(f"{axis}.." for axis in missing)
            self._faults.add_unplaced(
                number, f"{name} has no value of {' '.join(missing)}: {NOT_KNOWN}",
                f"say --offset {name.replace(' ', '')}={words} too",
            )  # fmt: skip

    def data(self, number: int, line: str, body: str, block: Block, meaning: Meaning) -> list[Item]:
        """A block whose axis words are data."""
        item: Item | None = line
        if meaning.data_code == codes.WRITE_DATA:
            item = self._write(number, line, body, block, meaning)
        elif meaning.data_code == codes.LOCAL_SHIFT:
            self._local(number, meaning)
        elif meaning.data_code in (codes.SHIFT_TO, codes.SHIFT_BY):
            self._state.frames.shift_program(self._values(meaning), adding=meaning.data_code == codes.SHIFT_BY)
        else:
            item = self._put(number, line, body, block, meaning)
        return [item or line, *self.changed()]

    def _system(self, number: int, name: str) -> None:
        frames = self._state.frames
        self._said = True
        if name == codes.MACHINE_FRAME:
            frames.system = None
            return
        if name not in frames.tables:
            given = name.replace(" ", "")
            remedy = f"say --offset {given}=X..,Y..,Z.. (to 10 mm is enough), or --offsets"
            if name not in self._unknown:  # once, however often the program selects it
                self._faults.add_unplaced(number, f"{name}: {NOT_KNOWN}", remedy)
            self._unknown.add(name)
            return
        frames.system = name

    def _end_shift(self, number: int, meaning: Meaning) -> None:
        frames = self._state.frames
        if codes.RESTORE_SHIFT in meaning.codes:
            if self._on_linuxcnc and self._reset:
                frames.restore_reset()
            else:
                self._faults.add(number, "G92.3 restores a shift that is not in the program", codes.WITHOUT_IT)
            return
        if any(frames.reset) and codes.END_SHIFT in meaning.codes and not self._on_linuxcnc:
            self._faults.add(
                number, "G92.1 ends all of G92 (LinuxCNC) or sets named axes to the work offset (Fanuc)", _LINUXCNC
            )
        frames.end_reset(codes.END_SHIFT in meaning.codes)
        self._reset |= codes.END_SHIFT in meaning.codes

    def _values(self, meaning: Meaning) -> dict[int, float]:
        """Values of axis words by row, mm and deg."""
        state = self._state
        return {state.row[axis]: state.scale(axis) * value for axis, value in meaning.data.items() if axis in state.row}

    def _local(self, number: int, meaning: Meaning) -> None:
        frames = self._state.frames
        if not self._state.absolute and not self._on_linuxcnc:
            self._faults.add(number, "G52 under G91: whether its values add up differs by control", "write G90 first")
        frames.shift_locally(self._values(meaning), shared=self._on_linuxcnc)
        self._one_of_both(number)

    def _one_of_both(self, number: int) -> None:
        frames = self._state.frames
        if any(frames.local) and any(frames.reset):
            self._faults.add(number, "G52 and G92 together: whether they add up differs by control", _LINUXCNC)

    def _put(self, number: int, line: str, body: str, block: Block, meaning: Meaning) -> Item | None:
        """G92: the axes have these values where they stand."""
        values = self._values(meaning)
        if not values and self._on_fanuc and {word.letter for word in block.words} - {"N"} == {"G", "S"}:
            return None  # the largest speed of the spindle
        if not values:
            self._faults.add(number, "G92 without axis words", "G92 X0 Y0 Z0, or G92.1")
        if not values or not self._known(number, "G92", values):
            return None
        state = self._state
        position = state.position
        zero = self._zero(line, body, block, values)
        state.frames.put(values, position)
        self._one_of_both(number)
        self._reset = True
        state.enter_frame()
        state.commanded.name(values, Commanded.ABSOLUTE)
        return zero

    def _known(self, number: int, name: str, values: dict[int, float]) -> bool:
        state = self._state
        unknown = [
            state.axes[row] for row in values if state.position[row] is None or not state.commanded.stands([row])
        ]
        if unknown:
            self._faults.add(
                number,
                f"{name} gives {' '.join(unknown)} a value where it stands, and where that is is not known",
                f"command {' '.join(unknown)} by G90 G0 before, or say --start at the start of the program",
            )
        return not unknown

    def _zero(self, line: str, body: str, block: Block, values: dict[int, float]) -> Zero:
        state = self._state
        text = block_text(body, block.words, state.gap, False, False)
        shift = [0.0] * len(state.axes)
        for row, value in values.items():
            shift[row] = (state.position[row] or 0.0) - value
        return Zero(
            tuple(values), tuple(shift), text.lead, text.tail + line[len(body) :], state.gap, state.inch, line
        )  # fmt: skip

    def _write(self, number: int, line: str, body: str, block: Block, meaning: Meaning) -> Item | None:
        """G10: a work offset by values, or by what the axes are to read where they stand."""
        kind, place = meaning.parameters.get("L"), meaning.parameters.get("P", -1.0)
        values = self._values(meaning)
        touch_off = kind == 20 and self._on_linuxcnc
        system = self._written_system(number, kind, place)
        if system in self._touched:
            self._faults.add(number, f"G10 gives {system} a value, and --touched-off says that it was touched off",
                             "one of both")  # fmt: skip
        if meaning.data.get("R"):
            self._faults.add(number, "G10 with R turns the positions", codes.WITHOUT_IT)
        if not (self._state.absolute or self._on_linuxcnc):
            self._faults.add(number, "G10 under G91: whether its values add up differs by control", "write G90 first")
        if system is None or (touch_off and not self._known(number, "G10 L20", values)):
            return None
        frames = self._state.frames
        if not touch_off:
            frames.write(system, {row: (value, 0.0) for row, value in values.items()})
            return None
        zero = self._zero(line, body, block, values)
        spread = frames.spread
        others = [sum(parts) for parts in zip(frames.local, frames.reset, frames.length, strict=True)]
        frames.write(system, {row: (zero.shift[row] - others[row], spread[row]) for row in values})
        if system == frames.system:
            self._state.enter_frame()
            self._state.commanded.name(values, Commanded.ABSOLUTE)
        return zero

    def _written_system(self, number: int, kind: float | None, place: float) -> str | None:
        """Which work offset a G10 block writes; None after a fault."""
        if kind == 20 and self._on_fanuc and place >= 1 and place == int(place):
            return f"G54.1 P{place:.0f}"
        if kind == 2 or (kind == 20 and self._on_linuxcnc):
            if place == 0 and self._on_linuxcnc and self._state.frames.system:
                return self._state.frames.system
            if place in range(1, 1 + (len(NUMBERED) if self._on_linuxcnc else _OF_ALL)):
                return NUMBERED[int(place) - 1]
            self._faults.add(number, f"G10 L{kind:g} without a P that means the same on every control", "P1 to P6")
        elif kind == 20:
            self._faults.add(number, "G10 L20 sets G54 and on where the axes stand (LinuxCNC) or writes G54.1 (Fanuc)",
                             "say --dialect linuxcnc or fanuc")  # fmt: skip
        else:
            self._faults.add(number, "G10 that is not L2 or L20 changes data that are not followed", codes.WITHOUT_IT)
        return None
