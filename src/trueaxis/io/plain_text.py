"""Text that is safe to show: what a name or value from a file holds cannot steer a terminal or fill the screen.

Numbers of a report that are zero but for rounding are shown as zero.
"""

LONGEST = 1000  # characters of one part of a message: more than any file name that is met, less than a screen
_UNDECODED = range(0xDC80, 0xDD00)  # how Python keeps the bytes of a file name that are not UTF-8
# um, urad, ppm, and these per mm or deg: a hundredth of what any instrument resolves; solving leaves 1e-22 of a zero
NEAR_ZERO = 1e-6


def shown(text: str, longest: int = LONGEST) -> str:
    r"""One line of printable characters, of about `longest` at most: the middle of a longer text is left out.

    Control, format (zero-width, bidirectional) and unassigned characters come as escapes such as \x1b and \u202e.
    """
    if len(text) > longest:
        half = longest // 2
        text = f"{text[:half]} [... {len(text) - 2 * half} more characters ...] {text[-half:]}"
    return escaped(text)


def escaped(text: str, keep: str = "") -> str:
    """The text with every character that is not printable as an escape, but for spaces and those to keep."""
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() or c in keep else _escape(c) for c in text)


def _escape(character: str) -> str:
    code = ord(character)
    if code in _UNDECODED:
        return f"\\x{code - 0xDC00:02x}"
    return character.encode("unicode_escape").decode()


def plain_zero(value: float) -> float:
    """The value in um, urad or ppm, 0 where it is so small that only rounding made it other than zero."""
    return 0.0 if abs(value) < NEAR_ZERO else value
