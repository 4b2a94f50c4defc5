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
BYTE_ORDER_MARK = "\xef\xbb\xbf"  # of UTF-8, as latin-1
_BYTES = 65536
RECOGNISED = "the program is read as one for {}; --dialect says otherwise"
NAMES = {"siemens": "SINUMERIK (Siemens)", "heidenhain": "Heidenhain Klartext"}


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
    return "siemens" if _SIEMENS.search(re.sub(r"\([^()]*\)|\"[^\"]*\"", "()", text)) else None
