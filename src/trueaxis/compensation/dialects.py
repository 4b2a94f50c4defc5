"""Which control's language a program is in, where no other control reads it."""

import re
from pathlib import Path

from trueaxis.compensation.settings import Dialect

_KLARTEXT = re.compile(r"(?im)^[ \t]*(?:\d+[ \t]+)?BEGIN[ \t]+PGM[ \t]+\S+[ \t]+(?:MM|INCH)\b")
_SIEMENS = re.compile(
    r"(?im)^[ \t]*(?:%_N_\w+_(?:MPF|SPF)\b|;\$PATH=)|"
    r"^[ \t]*(?:N\d+[ \t]*)?(?:(?:G0?[0123]|G17)[ \t]+)?"
    r"(?:[^;(\n]*\bCR[ \t]*=|A?TRANS[ \t]+[XYZ]|A?TRANS[ \t]*$|TRAORI\b|CYCLE8\d+[ \t]*\(|MSG[ \t]*\(|"
    r"[XYZ][ \t]*=[ \t]*[-+.\dAI])"
)
# Fanuc and the like, milling: control of the tool point, tilted planes, further offsets, looking ahead, macros
_FANUC = re.compile(
    r"(?im)^[^;(\n]*(?<![A-Z#\[])(?:G43\.[45]|G68\.2|G54\.1[ \t]*P\d|G0?5\.1[ \t]*Q[01]|G0?5[ \t]*P10000|"
    r"G0?8[ \t]*P[01]|G6[56][ \t]*P\d|IF[ \t]*\[[^\n]*\][ \t]*(?:GOTO|THEN)|WHILE[ \t]*\[[^\n]*\][ \t]*DO)"
)
_TURRET = re.compile(r"(?i)T\d{4}")  # of a lathe, on which T alone changes the tool
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


def dialect_of(text: str) -> Dialect | None:
    """The control, by the first lines of a program; None where several may read it."""
    if is_klartext(text):
        return "heidenhain"
    words = re.sub(r"\([^()]*\)|\"[^\"]*\"", "()", text)
    if _SIEMENS.search(words):
        return "siemens"
    return "fanuc" if _FANUC.search(words) and not _TURRET.search(words) else None
