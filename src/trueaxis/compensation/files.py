"""A compensation from file to file, and the positions that a program commands."""

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from typing import BinaryIO, Protocol

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.apt.reader import AptReader
from trueaxis.compensation.columns import PlainRun
from trueaxis.compensation.dialects import (
    MARK,
    NAMES,
    RECOGNISED,
    comment_of,
    dialect_of,
    head_of,
    is_klartext,
    marked,
    numbered,
)
from trueaxis.compensation.foreign import NO_BLOCK, is_empty
from trueaxis.compensation.klartext.reader import KlartextReader
from trueaxis.compensation.linuxcnc.unrolled import check_unrolled, of_source, unrolled_first
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import ErrorModel
from trueaxis.compensation.moves import Move, Notes
from trueaxis.compensation.nc.reader import NcReader
from trueaxis.compensation.overview import raise_explained
from trueaxis.compensation.path import MoveTable
from trueaxis.compensation.program import Compensator
from trueaxis.compensation.reliance import Judge
from trueaxis.compensation.report import Changes, CompensationReport
from trueaxis.compensation.settings import Language, Settings
from trueaxis.compensation.sign_check import home_of
from trueaxis.compensation.touched_off import faults_of as touched_off_faults
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import OutputFiles

LONGEST_LINE = 65536
# Bytes read: some 10 000 blocks. A run ends where they do: with half of it, `half` of benchmarks/compensate_blocks.py
# took 4 to 6 % longer, in turns in one process; with twice the points of a batch as well, `cycles` took 17 % longer.
_AT_ONCE = 262144
_ONE_LINE = re.compile(r"[^\n]*+\n|[^\n]++")
_NC = frozenset({".nc", ".tap", ".ngc", ".gcode", ".mpf", ".iso", ".cnc", ".din", ".eia", ".h", ".i", ".min"})
_APT = frozenset({".cl", ".cls", ".clsf", ".apt", ".aptsource", ".ncl", ".cld"})
_APT_LINE = re.compile(
    r"\s*(?:\$\$|(?:GOTO|FROM|FEDRAT|UNITS|LOADTL|SPINDL|COOLNT|CIRCLE|TOOL PATH|CUTTER|TLDATA|MACHIN)\s*/|PARTNO\b)",
    re.I,
)


def language_of(program: Path) -> Language:
    """NC or APT, by the name's extension, else by what the first lines look like.

    Raises OSError when the file cannot be read.
    """
    suffix = program.suffix.lower()
    if suffix in _APT or re.search(r"\.ncl\.\d+$", program.name.lower()):
        return "apt"
    if suffix in _NC:
        return "nc"
    with program.open("rb") as file:
        head = file.read(LONGEST_LINE).decode("latin-1").splitlines()[:200]
    return "apt" if any(_APT_LINE.match(line) for line in head) else "nc"


def _has_long_line(text: bytes) -> bool:
    """Whether a line of it has `LONGEST_LINE` bytes or more, without its end."""
    begin = 0
    while len(text) - begin >= LONGEST_LINE:
        end = text.rfind(b"\n", begin, begin + LONGEST_LINE)
        if end < 0:
            return True
        begin = end + 1
    return False


class _Lines:
    """Lines of a file as latin-1 text, many at once, so that every byte comes back as it was; counts them. empty:
    whether there is no block among them.
    """

    def __init__(self, file: BinaryIO, faults: FaultLog, progress: Callable[[int], None] | None) -> None:
        self._file = file
        self._faults = faults
        self._progress = progress
        self.count, self.empty = 0, True

    def __iter__(self) -> Iterator[str]:
        while text := self._file.read(_AT_ONCE):
            if not text.endswith(b"\n"):
                text += self._file.readline(LONGEST_LINE + 1)
            before = self.count
            decoded = text.decode("latin-1")
            self.empty = self.empty and is_empty(decoded)
            if b"\0" in text:
                self._faults.add(before + text[: text.index(b"\0")].count(b"\n") + 1, "a byte of zero: no text file")
                return
            if _has_long_line(text) and self._too_long(text):
                return
            self.count += text.count(b"\n") + (not text.endswith(b"\n"))
            if self._progress is not None and self.count // 65536 > before // 65536:
                self._progress(self.count)
            yield decoded

    def _too_long(self, text: bytes) -> bool:
        """Whether a line is no line of a program; a fault then."""
        for number, line in enumerate(text.split(b"\n"), self.count + 1):
            if len(line) >= LONGEST_LINE:
                self.count = number
                self._faults.add(
                    number, f"a line of more than {LONGEST_LINE} bytes: not a program, or one without line ends"
                )
                return True
        return False


def single_lines(texts: Iterable[str]) -> Iterator[str]:
    """The lines of texts, one by one, with their ends."""
    for text in texts:
        yield from _ONE_LINE.findall(text)


def _check_start(settings: Settings, model: ErrorModel) -> None:
    """Faults of a start that the machine does not have."""
    foreign = sorted(set(settings.start) - set(model.axes))
    if foreign:
        raise InputError([Fault("--start", "", f"this machine has no axis {' '.join(foreign)}")])
    outside = [
        f"{axis} = {at:g} is outside its travel, from {model.travel[axis][0]:g} to {model.travel[axis][1]:g}"
        for axis, at in settings.start.items()
        if not model.travel[axis][0] <= at <= model.travel[axis][1]
    ]
    if outside:
        raise InputError([Fault("--start", "", problem, "a position that the axis reaches") for problem in outside])


class Target(Protocol):
    """What takes the bytes of the program that is written."""

    def write(self, data: bytes, /) -> object:
        """Append bytes."""


def compensate_file(
    program: Path,
    out: Path,
    model: ErrorModel,
    settings: Settings,
    *,
    language: Language | None = None,
    name: str | None = None,
    report_file: Path | None = None,
    progress: Callable[[int], None] | None = None,
    judge: Judge | None = None,
    via_linuxcnc: Path | None = None,
) -> CompensationReport:
    """Compensate `program` and write `out`, whole or not at all; they may be the same file.

    report_file: where the report goes as JSON, if anywhere. The others: see `compensated`, whose judge keeps anything
    from being written where it refuses. Raises InputError with every fault of the program (the first 50 in full),
    OSError when a file cannot be read or written; everything is then as it was.
    """
    with OutputFiles() as outputs:
        report = compensated(
            program, lambda: outputs.open(out), model, settings, language=language, name=name, progress=progress,
            judge=judge, via_linuxcnc=via_linuxcnc,
        )  # fmt: skip
        if report.refused:
            return report
        if report_file is not None:
            outputs.open(report_file).write(report.to_json().encode())
        outputs.commit()
    return report


def compensated(
    program: Path,
    target: Callable[[], Target],
    model: ErrorModel,
    settings: Settings,
    *,
    language: Language | None = None,
    name: str | None = None,
    progress: Callable[[int], None] | None = None,
    judge: Judge | None = None,
    via_linuxcnc: Path | None = None,
    changes: Changes | None = None,
) -> CompensationReport:
    """Compensate `program` into what `target` opens, once the settings are known to go with machine and program.

    name: the program's name in messages. progress: called now and then with the number of lines read. judge: says how
    far the program relies on what was measured; where it refuses, what was written is of no use. via_linuxcnc: the
    folder of LinuxCNC whose interpreter unrolls the program first. changes: gathers what is changed. Raises as
    `compensate_file`.
    """
    name = name or str(program)
    language = language or language_of(program)
    settings = _fitting(settings, model, language)
    vouched, head = settings.pass_m, head_of(program)
    faults, notes, made = FaultLog(file=name, placed=language == "apt"), Notes(), None
    faults.add_option("--spindle-tool", settings.unknown_tool)
    if via_linuxcnc is not None:
        faults.raise_if_any()  # LinuxCNC is given the tool
        check_unrolled(settings, language, model)
        made, settings = unrolled_first(program, model, settings, via_linuxcnc, name, notes)
    said = settings.dialect
    seen = dialect_of(head, said, program.suffix) if language == "nc" else None
    if said is None and seen is not None:
        notes.add(0, RECOGNISED.format(NAMES[seen]))
        settings = replace(settings, dialect=seen)
    compensator = Compensator(model, settings, faults, notes, changes)
    klartext = language == "nc" and settings.dialect == "heidenhain" and is_klartext(head)
    read_by = AptReader if language == "apt" else KlartextReader if klartext else NcReader
    reader = read_by(model.axes, settings, faults, notes)
    if made is not None:
        reader = NcReader(model.axes, settings, faults, notes, made.lines)
    mark = comment_of(program, settings.dialect) if language == "nc" else f"({MARK})"
    written, blocks_out, ends_whole = target(), 0, True
    with program.open("rb") if made is None else BytesIO(made.text.encode("latin-1", "replace")) as source:
        lines = _Lines(source, faults, progress)
        items = reader.items(lines if isinstance(reader, NcReader) else single_lines(lines))
        pieces = marked(compensator.texts(items), mark)
        for piece in numbered(pieces) if klartext else pieces:
            if piece and not faults.count:
                written.write(piece.encode("latin-1"))
                blocks_out, ends_whole = blocks_out + piece.count("\n"), piece.endswith("\n")
    if lines.empty:
        faults.add(1, *NO_BLOCK)
    raise_explained(faults, model, said, seen, head)
    report = compensator.report(name, language, lines.count, blocks_out + (not ends_whole))
    if made is not None:
        report = of_source(report, program, vouched)
    if judge is not None:
        report = replace(report, reliance=judge(compensator.visited))
    return replace(report, blocks_out=0) if report.refused else report


def _fitting(settings: Settings, model: ErrorModel, language: Language) -> Settings:
    """The settings with where axes are taken to stand. Raises InputError where they do not go with the machine."""
    _check_start(settings, model)
    if language == "apt" and (settings.offsets.systems or settings.tools is not None):
        raise InputError([Fault("--offset, --tools", "", "go with NC programs: a CL file is in machine coordinates")])
    if found := touched_off_faults(settings.touched_off, model, settings.offsets):
        raise InputError(found)
    home = dict(zip(model.axes, home_of(model).tolist(), strict=True))
    linear = [axis for axis in model.axes if axis in "XYZ"]
    if settings.words != "nearest" and len(linear) != 3:
        raise InputError([Fault("--words", "", f"'{settings.words}' needs a machine with X, Y and Z")])
    return replace(settings, assumed=home | dict(settings.assumed))


def commanded_ends(program: Path, axes: tuple[str, ...]) -> NDArray[np.float64]:
    """Ends of the moves of a program without arcs: positions (n_axes, n), mm or deg.

    Raises InputError with every fault of the program, OSError when it cannot be read.
    """
    faults = FaultLog(file=str(program))
    reader = NcReader(axes, Settings(), faults, Notes())
    with program.open(encoding="latin-1", newline="") as file:
        text = "".join("\n" if MARK in line else line for line in file)
        moves = MoveTable([item for item in reader.items([text]) if isinstance(item, Move | PlainRun)], len(axes))
    for line in moves.lines[moves.arcs.index].tolist():
        faults.add(line, "is an arc", "chords, as compensate writes them")
    faults.raise_if_any()
    return moves.ends if len(moves) else np.zeros((len(axes), 0))
