"""Text that is safe to show: what a name or value of a file holds steers no terminal, fills no screen, is no markup.

Numbers of a report that are zero but for rounding are shown as zero.
"""

from collections.abc import Iterable, Sequence
from html import escape

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


def html_table(caption: str, head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """A `<table>` with a caption; None and NaN are empty cells, numbers have four digits."""
    top = "".join(f"<th>{escape(name)}</th>" for name in head)
    body = "".join(f"<tr>{''.join(f'<td>{escape(_cell(one))}</td>' for one in row)}</tr>" for row in rows)
    return f"<table><caption>{escape(caption)}</caption><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def _cell(value: object) -> str:
    if value is None or value != value:  # noqa: PLR0124  NaN alone differs from itself
        return ""
    return f"{value:.4g}" if isinstance(value, float) else str(value)
