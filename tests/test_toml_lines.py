"""Lines of TOML keys, against texts whose lines are counted by hand, and against a slow method that cannot err."""

import time
import tomllib
from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trueaxis.io.faults import Faults, InputError
from trueaxis.io.toml_lines import LARGEST_TEXT, MOST_PARTS, KeyPath, error_line, key_lines, parse_toml, place

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


def line_of(path: KeyPath, lines: dict[KeyPath, int]) -> int:
    return int(place(path, lines).split()[1].rstrip(","))


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
def test_every_key_is_found_on_its_line(ending: str) -> None:
    found = key_lines(TEXT.replace("\n", ending))
    assert {path: line_of(path, found) for path in LINES} == LINES
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


def lines_by_prefixes(text: str) -> dict[KeyPath, int]:
    """The slow method: a key belongs to the stretch of lines after whose end the standard parser first sees it."""
    lines = [f"{line}\n" for line in text.replace("\r\n", "\n").split("\n")]
    found: dict[KeyPath, int] = {}
    start = 1
    for count in range(1, len(lines) + 1):
        try:
            tree = tomllib.loads("".join(lines[:count]))
        except tomllib.TOMLDecodeError:
            continue  # inside a value that spans lines
        for path in paths(tree, ()):
            found.setdefault(path, start)
        start = count + 1
    return found


def paths(node: Any, prefix: KeyPath) -> Iterator[KeyPath]:
    if prefix:
        yield prefix
    pairs = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    for key, value in pairs:
        yield from paths(value, (*prefix, key))


BARE = st.sampled_from(["a", "b", "body", "1", "-", "x-y"])
QUOTED = st.sampled_from(['"a"', "'b.c'", '"q # ["', "'='", '"\\" ]"', '""', '"\\u0061\\\\"'])
PARTS = st.lists(st.one_of(BARE, BARE, QUOTED), min_size=1, max_size=3)
DOTTED = st.builds(lambda parts, dot: dot.join(parts), PARTS, st.sampled_from([".", " . ", "\t.", ". "]))
SCALARS = st.sampled_from(
    """1|-2.5e3|true|1979-05-27 07:32:00|"a # b"|'[{'|"\\"]"|""|''|nan"""
    """|\"\"\"\nx = 1\n[[a]]\n\"\"\"|\"\"\"a\"\"b\\\"\"\"\"\"|'''\n\n# '' \\\''''|\"\"\"\"\"\"|''''''""".split("|")
)
GAPS = st.sampled_from(["", " ", "\t"])
LINE_GAPS = st.sampled_from(["", " ", "\n", " # ] a = '\n", "\n\n  "])


def arrays(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    def text(items: list[str], gap: str, last: str) -> str:
        return f"[{gap}{f'{gap},{gap}'.join(items)}{last if items else ''}{gap}]"

    return st.builds(text, st.lists(inner, max_size=3), LINE_GAPS, st.sampled_from(["", ","]))


def inline_tables(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    pairs = st.lists(st.tuples(DOTTED, inner), max_size=3)
    return pairs.map(lambda items: "{ " + ", ".join(f"{key} = {value}" for key, value in items) + " }")


VALUES = st.recursive(SCALARS, lambda inner: st.one_of(arrays(inner), inline_tables(inner)), max_leaves=6)
STATEMENTS = st.one_of(
    st.builds(lambda key, gap, value: f"{gap}{key}{gap}={gap}{value}", DOTTED, GAPS, VALUES),
    st.builds(lambda key, gap: f"{gap}[{gap}{key}{gap}]", DOTTED, GAPS),
    st.builds(lambda key, gap: f"{gap}[[{gap}{key}{gap}]]", DOTTED, GAPS),
    st.sampled_from(["", "# [a] = '", "\t"]),
)


@st.composite
def documents(draw: st.DrawFn) -> str:
    """Random valid texts: a statement that would make the text invalid is left out."""
    text = ""
    for statement in draw(st.lists(STATEMENTS, max_size=12)):
        longer = (
            text + statement + draw(GAPS) + draw(st.sampled_from(["", "# '[{"])) + draw(st.sampled_from(["\n", "\r\n"]))
        )
        try:
            tomllib.loads(longer)
        except tomllib.TOMLDecodeError:
            continue
        text = longer
    return text


@settings(max_examples=400, deadline=None)
@given(documents())
def test_the_lines_of_any_text_are_those_of_the_slow_method(text: str) -> None:
    found, right = key_lines(text), lines_by_prefixes(text)
    assert {path: line_of(path, found) for path in right} == right
    assert found.keys() <= right.keys()


def test_the_lines_of_thousands_of_runs_take_no_time() -> None:
    """Parsing anew after each line took 40 s for 400 runs, and a hundred times as long for ten times as many."""
    run = '[[run]]\nid = "r"\ntarget = { on = "tool", point = [\n  1.0, 2, 3] }\n'
    before = time.perf_counter()
    lines = key_lines(run * 4000)
    assert time.perf_counter() - before < 20
    assert lines["run", 3999, "target"] == 4 * 3999 + 3


@pytest.mark.parametrize(
    ("text", "place", "problem"),
    [
        ("a = 1\n" + ".".join("a" * 100_000) + " = 1", "line 2", "a dotted key of too many parts"),
        ("a = 1\n\n [ " + " . ".join(['"a"'] * 100_000) + "]", "line 3", "a dotted key of too many parts"),
        ("a = 1\nb = { c = 2, " + ".".join("a" * 100_000) + " = 1 }", "line 2", "a dotted key of too many parts"),
        ('a = """\n\n"""\n' + ".".join(["'a.b'"] * 51) + " = 1", "line 4", "a dotted key of too many parts"),
        ('"a\\' * 200_000, "", "is not TOML: "),  # where lines are traced, its time grows with the square
        ("a = " + "[" * 10_000 + "]" * 10_000, "", "nested too deeply"),
        ("a = " + "{a=" * 10_000 + "1" + "}" * 10_000, "", "nested too deeply"),
        ("a" * 1_000_000 + " = 1\n" + "a" * 1_000_000 + " = 2\n", "line 2", "is not TOML: Cannot overwrite"),
        ("[" + "a" * 1_000_000 + "]\n[" + "a" * 1_000_000 + "]\n", "line 2", "is not TOML: Cannot declare"),
        ("a = " + "1" * 5000, "", "is not TOML: "),
        ("#" * (LARGEST_TEXT + 1), "", f"has {LARGEST_TEXT + 1} characters"),
    ],
    ids=range(11),
)
def test_a_hostile_text_is_one_short_fault(text: str, place: str, problem: str) -> None:
    with pytest.raises(InputError) as raised:
        parse_toml(text, Faults("f"))
    (fault,) = raised.value.faults
    assert fault.place == place
    assert problem in fault.problem
    assert len(str(fault)) < 300


def test_as_many_parts_as_are_allowed_are_read() -> None:
    key = ".".join("a" * MOST_PARTS)
    assert place(("a",) * 3, key_lines(f"\n{key} = 1")) == "line 2, key a.a.a"
    assert parse_toml(f"{key} = 1", Faults("f"))


WORDS = ".".join(["word"] * 60)


@pytest.mark.parametrize(
    "text",
    [
        f'a = """\n{WORDS}\n"""',
        f'a = """\n[{WORDS}]\n"""',
        f"a = '''\n'{WORDS} = 1\n'''''",
        f'a = """\\"""\n{WORDS}\n"""',
        f'a = """""{WORDS}\n{WORDS}"""""',
        f"a = [\n\"{WORDS}\",\n'{WORDS}']",
        f'a = "\\"{WORDS}"',
        f"a = 1 # {WORDS}\n# {WORDS} = 1",
        f"\"{WORDS}\" = 1\n['b.{WORDS}'.b]",
    ],
    ids=range(9),
)
def test_dotted_words_that_are_no_key_are_read(text: str) -> None:
    assert parse_toml(text, Faults("f")) == tomllib.loads(text)


@settings(max_examples=200, deadline=None)
@given(documents())
def test_any_valid_text_of_short_keys_is_read(text: str) -> None:
    assert repr(parse_toml(text, Faults("f"))) == repr(tomllib.loads(text.replace("\r\n", "\n")))  # a nan is no other


def test_a_long_or_strange_key_is_shown_short() -> None:
    text = '"' + "k" * 1_000_000 + '" = 1\n"a\\n\\u001b" = 2\n'
    assert place(("k" * 1_000_000,), key_lines(text)) == f"line 1, key {'k' * 60} ..."
    assert place(("a\n\x1b",), key_lines(text)) == r"line 2, key 'a\n\x1b'"


def test_a_line_end_of_three_characters_is_a_fault() -> None:
    """Reading \\r\\n as \\n twice would have made a text valid of which the lines could not be told."""
    with pytest.raises(InputError, match="is not TOML"):
        parse_toml("\r\r\nschema = 1\r\n", Faults("f"))
