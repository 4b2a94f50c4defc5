"""The program that LinuxCNC's interpreter is given: as it is, but that no value is read which is not known here.

A numbered parameter that nothing has set is 0 to the interpreter; on the control it has what another program left in
it. So each one is read together with a mark, a named parameter that is set where the parameter is: LinuxCNC itself then
refuses to read a mark that is not there, with the line in which it happens. Lines stay lines.
"""

import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass

from trueaxis.compensation.nc.tool_codes import SPINDLE_REMEDY
from trueaxis.io.faults import Fault

LONGEST = 250  # characters of a block: LinuxCNC takes lines up to 254 with their ends
ARGUMENTS = range(1, 31)  # of a subprogram, set by its call
TOOL_PARAMETERS = range(5400, 5414)  # of the tool in the spindle
FIRST_OF_INTERPRETER = 5420  # positions, set by the interpreter
_COMMENTS = re.compile(r"\([^()]*\)?|;.*")
_READ = re.compile(r"#[ \t]*(\d+)(?![ \t]*[\d=])")
_SET = re.compile(r"#[ \t]*(\d+)[ \t]*=(?!=)")
_TOOL_READ = re.compile(r"#[ \t]*<[ \t]*_current_tool[ \t]*>", re.IGNORECASE)
_CHANGE = re.compile(r"(?i)M[ \t]*0*61?(?![ \t]*[\d.])")
_EXISTS = re.compile(r"(?i)exists[ \t]*\[[ \t]*$")
_SUB = re.compile(r"(?i)^[ \t]*(?:N[ \t]*\d+[ \t]*)?O[ \t]*(?:\d+|<[^<>]*>)[ \t]*(sub|endsub)\b")
_CONTROL = re.compile(r"(?i)#[ \t]*<[ \t]*(_(?:ini|hal)[ \t]*\[[^>]*|_task|_current_pocket|_selected_pocket)[ \t]*>")
_GLOBAL = re.compile(r"(?i)exists[ \t]*\[[ \t]*#[ \t]*<[ \t]*(_[^<>]*)>")
_MARK = "_trueaxis_{}_is_set"
_TOOL_MARK = _MARK.format("tool")
_REFUSED = re.compile(r"#<_trueaxis_(\w+)_is_set>")
_ELSEWHERE = re.compile(r"EOF in file:\S* seeking o-word: o<(.*?)>|Failed to find sub 'O(.*?)'")
_COMPUTED = r"G[#\[]|#[#\[]"  # codes, and numbers of parameters
_POINTS = {"G28": re.compile(rf"(?i)G0*28(?!\d)|#0*516\d|{_COMPUTED}"),
           "G30": re.compile(rf"(?i)G0*30(?!\d)|#0*518\d|{_COMPUTED}")}  # fmt: skip
_OFFSETS = re.compile(r"(?i)G0*10(?!\d)|G[#\[]|#0*5(?:2[2-9]|3\d)\d=(?!=)|#[#\[][^=]*=(?!=)")
_MACHINE = re.compile(r"(?i)G0*53(?![\d.])")
_MAIN_AGAIN = re.compile(r"(?i)M0*99(?!\d)")
FROM_CONTROL = "the value itself in the program"
FROM_FILE = "set it in the program, or give the control's parameters: --offsets FILE.var"


@dataclass(frozen=True, slots=True)
class Source:
    """text: with marks. indirect: whether parameters are read by numbers that are computed. diameters: lines that read
    the diameter of the tool in the spindle.
    """

    text: bytes
    indirect: bool
    diameters: tuple[int, ...]


def marked_source(source: bytes, known: Collection[int]) -> Source:
    """The program with marks; known: numbers of parameters that are known before it."""
    if b"#" not in source:
        return Source(source, indirect=False, diameters=())
    lines, inside, indirect, diameters = [], False, False, []
    for number, line in enumerate(source.decode("latin-1").split("\n"), 1):
        code = _COMMENTS.sub(lambda found: " " * len(found[0]), line)
        if bounds := _SUB.match(code):
            inside = bounds[1].lower() == "sub"
        indirect |= bool(re.search(r"#[ \t]*[#\[]", code))
        if re.search(r"#[ \t]*5410(?![ \t]*[\d=])", code):
            diameters.append(number)
        changed = (
            _marked(line, code, ARGUMENTS if inside else (), known) if "#" in code or _CHANGE.search(code) else line
        )
        lines.append(changed if len(changed.rstrip("\r")) <= LONGEST else line)
    return Source("\n".join(lines).encode("latin-1"), indirect, tuple(diameters))


def _marked(line: str, code: str, arguments: Collection[int], known: Collection[int]) -> str:
    """One line with marks; code: it with blanks for comments, of the same length."""

    def to_be_set(number: int) -> bool:
        return number not in arguments and number not in known and number < FIRST_OF_INTERPRETER

    pieces, end = [], 0
    reads = [*_READ.finditer(code), *_TOOL_READ.finditer(code)]
    for read in sorted(reads, key=lambda found: found.start()):
        one = TOOL_PARAMETERS[0] if read.re is _TOOL_READ else int(read[1])
        name = _TOOL_MARK if one in TOOL_PARAMETERS else _MARK.format(one)
        if to_be_set(one) and not _EXISTS.search(code[: read.start()]):
            pieces += [line[end : read.start()], f"[{read[0]} + 0 * #<{name}>]"]
            end = read.end()
    marks = [_MARK.format(int(one)) for one in _SET.findall(code) if to_be_set(int(one))]
    marks += [_TOOL_MARK] if _CHANGE.search(code) else []
    last = len(code.rstrip())
    pieces += [line[end:last], *(f" #<{mark}>=1" for mark in dict.fromkeys(marks)), line[last:]]
    return "".join(pieces)


def _blocks(source: bytes) -> Iterator[str]:
    """The blocks without comments and blanks, which LinuxCNC does not read."""
    for line in source.decode("latin-1").split("\n"):
        yield re.sub(r"[ \t]", "", _COMMENTS.sub("", line))


def machine_lines(source: bytes) -> frozenset[int]:
    """Lines of blocks in machine coordinates (G53)."""
    return frozenset(number for number, block in enumerate(_blocks(source), 1) if _MACHINE.search(block))


def may_use_point(source: bytes, code: str) -> bool:
    """Whether a program may use the reference point of `G28` or `G30`."""
    return any(_POINTS[code].search(block) for block in _blocks(source))


def offset_faults(source: bytes, name: str) -> list[Fault]:
    """Faults of blocks that may change work offsets that were touched off."""
    problem = "may change a work offset, and --touched-off says that it was touched off"
    return [
        Fault(name, f"line {number}", problem, "take it out, or leave out --touched-off")
        for number, block in enumerate(_blocks(source), 1) if _OFFSETS.search(block)
    ]  # fmt: skip


def end_faults(source: bytes, line: int, name: str) -> list[Fault]:
    """Faults of the block that ends the program: M99 does not."""
    blocks = ["", *_blocks(source)]  # 0: of no line
    if line >= len(blocks) or not _MAIN_AGAIN.search(blocks[line]):
        return []
    problem = "M99 begins the main program anew, without end"
    return [Fault(name, f"line {line}", problem, "M2 or M30; M99 ends subprograms")]


def fault_of(name: str, line: int, refusal: str) -> Fault:
    """The fault of a program that LinuxCNC refuses in a line."""
    if missing := _ELSEWHERE.search(refusal):
        problem = f"subprogram O{missing[1] or missing[2]} is not in the file"
        return Fault(name, f"line {line}", problem, "put it into the file, as on the control: O.. to M99, or O.. sub")
    mark = _REFUSED.search(refusal)
    if mark is None:
        return Fault(name, f"line {line}", f"LinuxCNC refuses the program: {refusal}")
    if mark[1] == "tool":
        problem = "a parameter of the tool in the spindle is read before a tool change: which tool it is is not known"
        return Fault(name, f"line {line}", problem, SPINDLE_REMEDY)
    return Fault(name, f"line {line}", f"parameter #{mark[1]} is read, and its value is not known", FROM_FILE)


def control_faults(source: bytes, name: str) -> list[Fault]:
    """Faults of values that are the control's own: of its INI, its HAL, its pockets, and global names of others."""
    found = []
    for number, line in enumerate(source.decode("latin-1").split("\n"), 1):
        code = _COMMENTS.sub(" ", line)
        values = [*(f"#<{one}>" for one in _CONTROL.findall(code))]
        found += [Fault(name, f"line {number}", f"{one} is a value of the control, not known here", FROM_CONTROL)
                  for one in dict.fromkeys(values)]  # fmt: skip
        found += [Fault(name, f"line {number}", f"whether #<{one}> exists on the control is not known", FROM_CONTROL)
                  for one in dict.fromkeys(_GLOBAL.findall(code)) if not _CONTROL.search(f"#<{one}>")]  # fmt: skip
    return found
