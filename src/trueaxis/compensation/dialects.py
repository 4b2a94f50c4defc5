"""What a program says of itself: which control's language it is in, where no other control reads it, and that it is
compensated: a second compensation would double every correction. And new block numbers where Klartext has grown.
"""

import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.settings import Dialect

_KLARTEXT = re.compile(r"(?im)^[ \t]*(?:\d+[ \t]+)?BEGIN[ \t]+PGM[ \t]+\S+[ \t]+(?:MM|INCH)\b")
_SIEMENS = re.compile(
    r"(?m)^[ \t]*%_N_\w+_(?:MPF|SPF)\b|^[ \t]*;\$PATH=|"
    r"^[ \t]*(?:N\d+[ \t]*)?(?:(?:G0?[0123]|G17)[ \t]+)?"
    r"(?:[^;(\n]*\bCR[ \t]*=|A?TRANS[ \t]+[XYZ]|A?TRANS[ \t]*$|TRAORI\b|(?:MCALL[ \t]+)?CYCLE8\d+[ \t]*\(|MSG[ \t]*\(|"
    r"[XYZ][ \t]*=[ \t]*[-+.\dAI])"
)
_OF_SIEMENS_ALONE = ("%_N_", ";$PATH", "=", "TRA", "CYCLE8", "MSG")  # without any of these the above finds nothing
# Fanuc and the like, milling: control of the tool point, tilted planes, further offsets, looking ahead, macros
_FANUC = re.compile(
    r"(?<![A-Z#\[])(?:G(?:43\.[45]|68\.2|54\.1[ \t]*P\d|0?5\.1[ \t]*Q[01]|0?5[ \t]*P10000|"
    r"0?8[ \t]*P[01]|6[56][ \t]*P\d)|IF[ \t]*\[[^\n]*\][ \t]*(?:GOTO|THEN)|WHILE[ \t]*\[[^\n]*\][ \t]*DO)"
)
# how programs of Fanuc and the like begin: % and their number
_NUMBERED = re.compile(r"(?i)(?:\xef\xbb\xbf)?\s*%[^\S\n]*\n\s*[O:]\d")
_TURRET = re.compile(r"(?i)T\d{4}")  # of a lathe, on which T alone changes the tool
_OF_SIEMENS = frozenset({".mpf", ".spf"})  # extensions that only SINUMERIK gives its programs
BYTE_ORDER_MARK = "\xef\xbb\xbf"  # of UTF-8, as latin-1
_BYTES = 65536
RECOGNISED = "the program is read as one for {}; --dialect says otherwise"
NAMES = {"fanuc": "Fanuc or the like", "siemens": "SINUMERIK (Siemens)", "heidenhain": "Heidenhain Klartext"}


def is_klartext(text: str) -> bool:
    """Whether a program begins as Heidenhain's conversational programs do."""
    return bool(_KLARTEXT.search(text))


def head_of(program: Path) -> str:
    """The first lines of a program, bytes as latin-1; empty where it is a pipe, which can be read only once.

    Raises OSError when the file cannot be read.
    """
    if not program.is_file():
        return ""
    with program.open("rb") as file:
        return file.read(_BYTES).decode("latin-1")


def dialect_of(text: str, said: Dialect | None = None, suffix: str = "") -> Dialect | None:
    """The control, by the first lines of a program and its extension; None where several may read it, also the one that
    the user says.
    """
    if is_klartext(text):
        return "heidenhain"
    words = re.sub(r"\([^()]*\)|\"[^\"]*\"", "()", text).upper()
    if any(sign in words for sign in _OF_SIEMENS_ALONE) and _SIEMENS.search(words):
        return "siemens"
    if said in {"siemens", "heidenhain"} and _NUMBERED.match(text):
        return "fanuc"
    if any(_says(words, found.start()) for found in _FANUC.finditer(words)) and not _TURRET.search(words):
        return "fanuc"
    return "siemens" if suffix.lower() in _OF_SIEMENS and not _NUMBERED.match(text) else None


def _says(words: str, place: int) -> bool:
    """Whether no comment begins in the line before this place."""
    before = words[words.rfind("\n", 0, place) + 1 : place]
    return ";" not in before and "(" not in before


# capitals and no sign but a blank: older controls take no other in a comment
MARK = "TRUEAXIS COMPENSATED"
COMPENSATED_ALREADY = ("this program is compensated already", "compensate the original program")
# what must stay first: a byte order mark, blank lines, %, the program's number, Siemens' path in the second line, and
# BEGIN PGM of Heidenhain
_HEAD = re.compile(
    r"(?:\xef\xbb\xbf)?"
    r"(?:[ \t]*+(?:%[^\r\n]*+|[O:o][ \t]*+\d[^\r\n]*+|;\$PATH[^\r\n]*+|(?:\d++[ \t]++)?BEGIN PGM[^\r\n]*+)?\r*+\n)*"
)
_HEAD_BYTES = 65536
_SEMICOLON = _OF_SIEMENS | {".i"}  # extensions of Siemens and Heidenhain, where ( ) is no comment


def comment_of(program: Path, dialect: Dialect | None) -> str:
    """The mark as a comment of the program's own kind: `;` where the control or the program has no other.

    Raises OSError when the file cannot be read.
    """
    head = b""
    if program.is_file():  # a pipe can be read only once
        with program.open("rb") as file:
            head = file.read(_HEAD_BYTES)
    semicolon = dialect in {"siemens", "heidenhain"} or (
        dialect is None and b"(" not in head and (b";" in head or program.suffix.lower() in _SEMICOLON)
    )
    return f"; {MARK}" if semicolon else f"({MARK})"


def is_marked(line: str) -> bool:
    """Whether a line holds the mark, in capitals or not: an editor may have changed them."""
    return MARK in line.upper()


def unmarked(lines: Iterable[str], faults: FaultLog) -> Iterator[str]:
    """The lines as they are; one that holds the mark is a fault."""
    for number, line in enumerate(lines, 1):
        if is_marked(line):
            faults.add(number, *COMPENSATED_ALREADY)
        yield line


def marked(pieces: Iterable[str], comment: str) -> Iterator[str]:
    """The program in pieces of whole lines, with the mark in a line of its own before the first that may come later."""
    placed = False
    for piece in pieces:
        match = None if placed else _HEAD.match(piece)
        if match is None or match.end() == len(piece):
            yield piece
            continue
        placed, end = True, match.end()
        if piece.startswith(BYTE_ORDER_MARK, end):
            end += len(BYTE_ORDER_MARK)
        ending = re.search(r"\r*\n", piece)
        yield f"{piece[:end]}{comment}{ending[0] if ending else chr(10)}{piece[end:]}"


_NUMBER = re.compile(r"([ \t]*+)(\d{1,9}+)(?=[ \t])")
_MARKED = re.compile(rf"[ \t]*;[ \t]*{MARK}")


def numbered(pieces: Iterable[str]) -> Iterator[str]:
    """The program with block numbers that rise: each is kept where it can be. Labels, not numbers, are what calls name,
    so a new number changes nothing. Blocks that have none get none.
    """
    last, goes_on = -1, False
    for piece in pieces:
        lines = piece.splitlines(keepends=True)
        for index, line in enumerate(lines):
            match = None if goes_on else _NUMBER.match(line)
            goes_on = line.rstrip().endswith("~")
            if match is not None:
                last = max(int(match[2]), last + 1)
                lines[index] = f"{match[1]}{last}{line[match.end() :]}"
            elif last >= 0 and _MARKED.match(line):
                last += 1
                lines[index] = f"{last} {line.lstrip()}"
        yield "".join(lines)
