"""Lines of TOML keys, against texts whose lines are counted by hand."""

import pytest

from trueaxis.toml_lines import error_line, key_lines, place

TEXT = """\
# 1: a comment
title = "t"

list = [  # 4
    1,
    { inside = 2 },  # 6, in the stretch that begins at 4
    [3],
]
text = \"\"\"
not = "a key"
[nor.a.table]
\"\"\"
a.b.c = 1  # 13
a.b.d = 2

[table]  # 16
key = 1
sub.one = { two = [1, { three = 4 }] }  # 18

# 20
[table.deep]
x = 1

[[body]]  # 24
number = 2

[[body]]  # 27
number = 3
[[body.part]]  # 29
n = 1
[[body.part]]
n = 2
[body.table]  # 33
m = 1

[[body]]  # 36
"quoted key" = 1
"""

LINES = {
    ("title",): 2,
    ("list",): 4,
    ("list", 0): 4,
    ("list", 1, "inside"): 4,
    ("list", 2, 0): 4,
    ("text",): 9,
    ("a",): 13,
    ("a", "b", "c"): 13,
    ("a", "b", "d"): 14,
    ("table",): 16,
    ("table", "key"): 17,
    ("table", "sub", "one", "two", 1, "three"): 18,
    ("table", "deep"): 21,
    ("table", "deep", "x"): 22,
    ("body",): 24,
    ("body", 0): 24,
    ("body", 0, "number"): 25,
    ("body", 1): 27,
    ("body", 1, "number"): 28,
    ("body", 1, "part", 0, "n"): 30,
    ("body", 1, "part", 1): 31,
    ("body", 1, "table"): 33,
    ("body", 1, "table", "m"): 34,
    ("body", 2): 36,
    ("body", 2, "quoted key"): 37,
}


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
def test_every_key_is_found_on_its_line(ending: str) -> None:
    found = key_lines(TEXT.replace("\n", ending))
    assert {path: found.get(path) for path in LINES} == LINES
    assert not [path for path in found if "nor" in path or "not" in path]


def test_a_last_line_without_an_end_counts() -> None:
    assert key_lines("a = 1\nb = 2") == {("a",): 1, ("b",): 2}


def test_signs_that_end_no_line_in_toml_end_none_here() -> None:
    assert key_lines('a = "\u2028"  # \u0085 \u2029\nb = 1\n') == {("a",): 1, ("b",): 2}


def test_an_empty_text_has_no_keys() -> None:
    assert key_lines("") == {}


def test_a_place_is_the_line_of_the_nearest_key_there_is() -> None:
    lines = key_lines(TEXT)
    assert place(("body", 1, "part", 1, "n"), lines) == "line 32, key body[1].part[1].n"
    assert place(("body", 1, "lower"), lines) == "line 27, key body[1].lower"
    assert place(("ends", "tool"), lines) == "key ends.tool"


def test_the_parsers_line_of_an_error() -> None:
    assert error_line(ValueError("Invalid value (at line 12, column 3)")) == "line 12"
    assert error_line(ValueError("Unclosed array (at end of document)")) == ""
