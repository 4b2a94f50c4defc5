"""Files that are no programs, by how they begin: what they look like instead, and what would be right."""

import re

_PROGRAM = "the program that a CAM system or the control wrote"
_BEGINNINGS = (
    (r"%PDF-", "a PDF document"), (r"PK\x03\x04", "a ZIP archive, such as an office document,"),
    (r"\x89PNG|\xff\xd8\xff|GIF8|BM.{4}\x00{4}", "a picture"), (r"\{\\rtf", "a text document (RTF)"),
    (r"\s*<(?:!DOCTYPE|html|\?xml|svg)", "a page of HTML or XML"), (r"ISO-10303-21", "a STEP model"),
    (r"solid\b[^\n]*\n\s*facet\b", "an STL model"), (r"\s*0\s*\r?\n\s*SECTION\b|AutoCAD Binary DXF", "a DXF drawing"),
    (r"\x7fELF|MZ.\x00", "a program of the computer"), (r".{72}S {6}1", "an IGES model"), (r"\s*[{\[]\s*\"", "JSON"),
)  # fmt: skip
_FOREIGN = [(re.compile(pattern, re.IGNORECASE | re.DOTALL), name) for pattern, name in _BEGINNINGS]
_UTF_16 = ("\xff\xfe", "\xfe\xff")
# what a block begins with or holds: a switch, a mark, a comment, a variable, a block number, an address and its number,
# a keyword with its arguments (SINUMERIK, APT), a path function of Klartext
_BLOCK = re.compile(
    r"^\s*(?:[%(;/#:$]|\d+\s+(?:L|C|CC|CR|CP|CT|LP|TOOL|CYCL|BEGIN|END|BLK|M\d+|STOP|FN|Q\w?\d|\*|;|LBL)\b|"
    r"(?-i:[A-Z_]+\d*\s*[(=/])|(?:PARTNO|RAPID|FINI|(?:BEGIN|END) PGM|TOOL CALL|CYCL DEF|CALL LBL)\b|N?\d*\s*O\s*<)|"
    r"(?:^|[\s\d.*;/)])[A-Z]\s*[-+=]?\s*[-+]?(?:\.?\d|[#\[])",
    re.IGNORECASE,
)
_FEWEST_LINES = 2
# of lines that may be blocks: the programs of tests.shop_programs have 0.44 and more, texts and sources less
_SHARE = 0.25
_SHARE_OF_BYTES = 0.5  # the same where there are bytes that no text has
_LINES = 200  # of the head of a file that are looked at
_NOTHING = re.compile(r"(?:[\s\x1a\xef\xbb\xbf]|\([^()\r\n]*+\)|;[^\r\n]*+|\$\$[^\r\n]*+|%[^\r\n]*+)*")
NO_BLOCK = ("holds no block: it is empty, or comments alone", "the program as it was written: a copy may have failed")


def looks_like(head: str) -> tuple[str, str] | None:
    """What a file is that begins so (bytes as latin-1) and is no program, and what would be right; None where it may be
    one.
    """
    if head.startswith(_UTF_16):
        return "is text in UTF-16, which no control reads", "save it as ASCII or UTF-8"
    for pattern, name in _FOREIGN:
        if pattern.match(head):
            return f"looks like no NC program: it begins as {name} does", _PROGRAM
    if "\r" in head and "\n" not in head:
        return "its lines end with CR alone, which this reads as one line", "line ends LF or CR LF"
    lines = [line for line in head.splitlines()[:_LINES] if line.strip()]
    blocks = sum(bool(_BLOCK.search(line)) for line in lines)
    if "\0" in head and blocks < _SHARE_OF_BYTES * len(lines):
        return "looks like no NC program: it holds bytes of zero, and no text does", _PROGRAM
    if len(lines) >= _FEWEST_LINES and blocks < _SHARE * len(lines):
        return f"looks like no NC program: {blocks} of its first {len(lines)} lines may be blocks", _PROGRAM
    return None


def is_empty(text: str) -> bool:
    """Whether a text (bytes as latin-1) holds nothing but comments, marks and blank lines."""
    found = _NOTHING.match(text)
    return found is not None and found.end() == len(text)
