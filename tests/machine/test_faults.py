"""Every fault of a spec is told with its line, its key and what would be right, and all of them at once."""

from pathlib import Path

import pytest

from tests.machines import machine_of
from trueaxis.io.faults import Fault, InputError
from trueaxis.machine import read_machine

BASE = """\
schema = 1
name = "mill"
title = "A mill"

[[body]]
number = 2
name = "Y slide"
lower = 1
moves = "Y"
travel = [0.0, 700.0]
motion_errors = ["EXY", "ECY"]

[[body]]
number = 4
name = "workpiece"
lower = 2
position = ["q_wx", 2, 3.5]

[[body]]
number = 5
name = "C head"
lower = 1
moves = "C"
sense = -1
travel = [-10, 10]
position_errors = { EC = "eps_c", EX = "d_c" }

[[body]]
number = 9
name = "tool"
lower = 5

[ends]
workpiece = 4
tool = 9

[curves]
degree = 5

[references]
motion_Y = "Eq. (13)"
"""


def faults_of(text: str) -> tuple[Fault, ...]:
    with pytest.raises(InputError) as caught:
        machine_of(text)
    return caught.value.faults


def changed(old: str, new: str) -> str:
    assert BASE.count(old) == 1
    return BASE.replace(old, new)


def test_the_base_is_right_and_read_as_it_says() -> None:
    machine = machine_of(BASE)
    assert machine.axes == ("Y", "C")
    assert machine.components == ("EXY", "ECY", "EXC", "EYC", "EZC", "EAC", "EBC", "ECC")
    assert machine.parameters == ("q_wx", "d_c", "eps_c")
    assert [machine.parameter_unit(name) for name in machine.parameters] == ["mm", "mm", "rad"]
    assert machine.travel == {"Y": (0.0, 700.0), "C": (-10.0, 10.0)}
    assert machine.body(4).position == ("q_wx", 2.0, 3.5)
    assert (machine.mover("C").sense, machine.curve_degree) == (-1, 5)
    assert machine.references == (("motion_Y", "Eq. (13)"),)


# What is changed, then line, key, a part of the problem, a part of the remedy.
ONE_FAULT = {
    # keys that no table has, at every level
    "unknown top key": ("schema = 1", "schema = 1\nspeed = 3", 2, "speed", "not a key", "allowed: body, curves"),
    "unknown body key": ("sense = -1", "sence = -1", 24, "body[2].sence", "not a key", "lower, motion_errors, moves"),
    "unknown end": ("tool = 9", "tool = 9\nprobe = 3", 36, "ends.probe", "not a key", "tool, workpiece"),
    "unknown curve key": ("degree = 5", "degree = 5\nbasis = 1", 39, "curves.basis", "not a key", "degree"),
    "unknown direction": ("EX = ", "EW = ", 26, "body[2].position_errors.EW", "not a key", "EX EY EZ EA EB EC"),
    "unknown reference": ("motion_Y =", "motoin_Y =", 41, "references.motoin_Y", "not a key", "motion_X"),
    # what bodies make together
    "axis moved twice": ('moves = "C"', 'moves = "Y"', 23, "body[2].moves", "axis Y is moved 2 times", "X Y Z A B C"),
    "no such end": ("tool = 9", "tool = 8", 35, "ends.tool", "there is no body 8", "number of a body"),
    "ends the same": ("tool = 9", "tool = 4", 33, "ends", "are both body 4", "two different"),
    "idle body": ("lower = 5", "lower = 1", 19, "body[2]", "carries neither", "leave it out"),
    # travel
    "travel the wrong way round": ("[0.0, 700.0]", "[700.0, 0.0]", 10, "body[0].travel", "from 700 to 0", "lower end"),
    "travel of nothing": ("[0.0, 700.0]", "[1.0, 1.0]", 10, "body[0].travel", "from 1 to 1", "lower end"),
    "no travel": ("travel = [-10, 10]\n", "", 19, "body[2].travel", "is missing", "2 finite numbers"),
    "travel of three": ("[0.0, 700.0]", "[0, 1, 2]", 10, "body[0].travel", "[0, 1, 2]", "2 finite numbers"),
    "travel is not finite": ("[0.0, 700.0]", "[0.0, inf]", 10, "body[0].travel", "inf", "2 finite numbers"),
    "travel is no number": ("[0.0, 700.0]", "[nan, 700.0]", 10, "body[0].travel", "nan", "2 finite numbers"),
    "travel is beyond doubles": ("[0.0, 700.0]", f"[0, 1{'0' * 400}]", 10, "body[0].travel", "[0, 1000", "finite"),
    "travel of a body at rest": ("lower = 5", "lower = 5\ntravel = [0, 1]", 32, "body[3].travel", "not move", "moves"),
    # names
    "clash of parameters": ('"eps_c"', '"q_wx"', 26, "body[2].position_errors", "with position of body 4", "own"),
    "a word of Python": ('"q_wx"', '"lambda"', 17, "body[1].position", "'lambda' clashes", "another name"),
    "a word of C": ('"q_wx"', '"double"', 17, "body[1].position", "'double' clashes", "another name"),
    "a component's name": ('"q_wx"', '"EXY"', 17, "body[1].position", "'EXY' clashes", "another name"),
    "a coordinate": ('"q_wx"', '"bx"', 17, "body[1].position", "for a coordinate: b, d, e, i", "such as q_bx"),
    "an axis's name": ('"d_c"', '"y"', 26, "body[2].position_errors", "'y' clashes", "another name"),
    "no name": ('"d_c"', '"d-c"', 26, "body[2].position_errors", "'d-c' is no name", "a letter"),
    "two bodies of a name": ('"C head"', '"Y slide"', 21, "body[2].name", "body 2 is called 'Y slide' too", "its own"),
    # types
    "schema": ("schema = 1", "schema = 2", 1, "schema", "2 is not a schema", "schema = 1"),
    "true is no number": ("number = 9", "number = true", 29, "body[3].number", "True", "a whole number"),
    "a text for a number": ("lower = 2", 'lower = "2"', 16, "body[1].lower", "'2'", "a whole number"),
    "a fraction": ("lower = 2", "lower = 2.0", 16, "body[1].lower", "2.0", "a whole number"),
    "a number for a text": ('name = "mill"', "name = 3", 2, "name", "3", "a text in quotes"),
    "an empty text": ('title = "A mill"', 'title = " "', 3, "title", "' '", "a text in quotes"),
    "a machine's name": ('name = "mill"', 'name = "a/b"', 2, "name", "'a/b'", "letters, digits"),
    "two lines": ('title = "A mill"', 'title = "A\\nmill"', 3, "title", "'A\\nmill'", "one line"),
    "quotes in prose": ('title = "A mill"', "title = 'A\"\"\"mill'", 3, "title", "mill", "letters, digits"),
    "bars in a table": ('"C head"', '"C | head"', 21, "body[2].name", "'C | head'", "letters, digits"),
    "no such axis": ('moves = "C"\nsense = -1', 'moves = "U"', 23, "body[2].moves", "'U'", "one of X Y Z A B C"),
    "a list for an axis": ('moves = "C"\nsense = -1', "moves = [1]", 23, "body[2].moves", "[1]", "one of X Y Z A B C"),
    "sense": ("sense = -1", "sense = 2", 24, "body[2].sense", "2 is no sense", "1, or -1"),
    "sense at rest": ("lower = 5", "lower = 5\nsense = 1", 32, "body[3].sense", "has no sense", "leave it out"),
    "position of two": ('["q_wx", 2, 3.5]', "[1, 2]", 17, "body[1].position", "is not a position", "three numbers"),
    "position of nan": ('["q_wx", 2, 3.5]', "[1, 2, nan]", 17, "body[1].position", "entry 3 is nan", "finite"),
    "position of inf": ('["q_wx", 2, 3.5]', "[-inf, 2, 3]", 17, "body[1].position", "entry 1 is -inf", "finite"),
    "position of true": ('["q_wx", 2, 3.5]', "[1, true, 3]", 17, "body[1].position", "entry 2 is True", "finite"),
    "errors are no list": ('["EXY", "ECY"]', '"some"', 11, "body[0].motion_errors", "'some'", '"all"'),
    "another axis's error": ('"ECY"]', '"ECX"]', 11, "body[0].motion_errors", "'ECX' is no motion error", "EXY EYY"),
    "errors that are no text": ('"ECY"]', "{ a = 1 }]", 11, "body[0].motion_errors", "{'a': 1}", "EXY EYY"),
    "an error twice": ('"ECY"]', '"EXY"]', 11, "body[0].motion_errors", "'EXY' stands there already", "once"),
    "errors at rest": ("lower = 5", 'lower = 5\nmotion_errors = ["E"]', 32, "body[3].motion_errors", "'E'", "not move"),
    "no table": ("position_errors = { EC", "position_errors = 3 # { EC", 26, "body[2].position_errors", "3", "a table"),
    "degree": ("degree = 5", "degree = 16", 38, "curves.degree", "16 is out of range", "from 1 to 15"),
    "degree zero": ("degree = 5", "degree = 0", 38, "curves.degree", "0 is out of range", "from 1 to 15"),
    "a huge number": ("schema = 1", f"schema = 0x{'f' * 5000}", 1, "schema", "larger than any", "a whole number"),
    "a date": ("lower = 2", "lower = 1979-05-27", 16, "body[1].lower", "1979", "a whole number"),
    # missing
    "no name at all": ('name = "mill"\n', "", 0, "name", "is missing", "a text in quotes"),
    "no number": ("number = 4\n", "", 13, "body[1].number", "is missing", "a whole number"),
    "no lower": ("lower = 2\n", "", 13, "body[1].lower", "is missing", "a whole number"),
    "an end is missing": ("tool = 9\n", "", 33, "ends.tool", "is missing", "a whole number"),
}  # fmt: skip


@pytest.mark.parametrize("case", ONE_FAULT)
def test_one_fault_is_told_once_with_line_key_problem_and_remedy(case: str) -> None:
    old, new, line, key, problem, remedy = ONE_FAULT[case]
    (fault,) = faults_of(changed(old, new))
    assert fault.place == (f"line {line}, key {key}" if line else f"key {key}")
    assert problem in fault.problem
    assert remedy in fault.remedy
    assert len(str(fault)) < 300


# Faults that cut an end off from the bed, so that the end is named too.
TWO_FAULTS = {
    "no lower body": (
        ("lower = 5", "lower = 6"),
        "line 31, key body[3].lower: there is no body 6; the bed (1) or one of 2, 4, 5, 9",
        "line 35, key ends.tool: body 9 is not reached from the bed; a chain of lower bodies down to the bed (1)",
    ),
    "two bodies of one number": (
        ("number = 9", "number = 5"),
        "line 29, key body[3].number: two bodies have the number 5; a number of its own",
        "line 35, key ends.tool: there is no body 9; the number of a body",
    ),
    "the number of the bed": (
        ('number = 9\nname = "tool"', 'number = 1\nname = "tool"'),
        "line 29, key body[3].number: 1 is taken by the bed or no body; numbers from 2",
        "line 35, key ends.tool: there is no body 9; the number of a body",
    ),
    "a body on itself": (
        ('lower = 1\nmoves = "C"', 'lower = 5\nmoves = "C"'),
        "line 22, key body[2].lower: body 5 stands on itself: the lower bodies run in a loop; "
        "every body leads down to the bed (1)",
        "line 35, key ends.tool: body 9 is not reached from the bed; a chain of lower bodies down to the bed (1)",
    ),
}


@pytest.mark.parametrize("case", TWO_FAULTS)
def test_an_end_that_is_cut_off_is_told_beside_what_cuts_it_off(case: str) -> None:
    change, *told = TWO_FAULTS[case]
    assert [str(fault) for fault in faults_of(changed(*change))] == [f"test.toml: {each}" for each in told]


def test_a_loop_is_told_at_each_of_its_bodies() -> None:
    faults = faults_of(changed('lower = 1\nmoves = "C"', 'lower = 9\nmoves = "C"'))
    assert [fault.place for fault in faults] == [
        "line 22, key body[2].lower",
        "line 31, key body[3].lower",
        "line 35, key ends.tool",
    ]


def test_several_faults_come_together() -> None:
    text = BASE
    for old, new in (
        ("schema = 1", "schema = 3\nextra = 1"),
        ("travel = [0.0, 700.0]", "travel = [700.0, 0.0]"),
        ('"q_wx"', '"for"'),
        ("lower = 5", "lower = 77"),
        ("degree = 5", "degree = 50"),
        ("tool = 9\n", ""),
    ):
        text = text.replace(old, new)
    keys = {fault.place.partition("key ")[2] for fault in faults_of(text)}
    assert keys == {
        "schema", "extra", "body[0].travel", "body[1].position", "body[3].lower", "curves.degree", "ends.tool",
    }  # fmt: skip


def test_an_empty_file_lacks_everything_it_must_have() -> None:
    keys = [fault.place for fault in faults_of("")]
    assert keys == ["key schema", "key name", "key body", "key ends", "key ends.workpiece", "key ends.tool"]


@pytest.mark.parametrize(
    ("text", "place", "problem"),
    [
        ("schema = \n", "line 1", "Invalid value"),
        ("schema = 1\nname = 'a'\nname = 'b'\n", "line 3", "Cannot overwrite"),
        ("schema = 1\n[[body]\n", "line 2", "Expected"),
        ("x = " + "[" * 100_000, "", "nested too deeply"),
        ("x = 1" + "0" * 5000, "", "digit"),
    ],
)
def test_what_is_not_toml_is_told_with_its_line(text: str, place: str, problem: str) -> None:
    (fault,) = faults_of(text)
    assert fault.place == place
    assert "is not TOML" in fault.problem
    assert problem in fault.problem


def test_keys_nested_deeper_than_python_recurses_are_faults_like_others() -> None:
    (fault,) = faults_of(BASE + ".".join("a" * 2000) + " = 1\n")
    assert (fault.place, fault.problem) == ("line 42", "has a dotted key of too many parts")
    inline = ".".join("a" * 100_000)  # the parser would take it, in time that grows with the square of its parts
    (fault,) = faults_of(BASE + f"b = [{{ {inline} = 1 }}]\n")
    assert (fault.place, fault.problem) == ("line 42", "has a dotted key of too many parts")
    nested = "{ a = " * 60 + "1" + " }" * 60  # Python's repr would show all of it
    (fault,) = faults_of(BASE + f"b = {nested}\n")
    assert fault.place == "line 42, key references.b"
    assert len(str(fault)) < 300


def test_lines_are_counted_as_editors_do() -> None:
    # U+2028, form feeds and the like end a line for Python's splitlines, and for nobody else.
    text = changed("schema = 1", "schema = 1 # \u2028 \u0085") + 'extra = "x"\n'
    assert [fault.place for fault in faults_of(text)] == ["line 42, key references.extra"]
    windows = changed("degree = 5", "degree = 50").replace("\n", "\r\n")
    assert [fault.place for fault in faults_of(windows)] == ["line 38, key curves.degree"]


def test_files_that_are_no_text_or_are_not_there(tmp_path: Path) -> None:
    def told(path: Path) -> str:
        with pytest.raises(InputError) as caught:
            read_machine(path)
        (fault,) = caught.value.faults
        return str(fault).removeprefix(str(path))

    latin = tmp_path / "latin.toml"
    latin.write_bytes(b'schema = 1\nname = "m"\ntitle = "M\xfchle"\n')
    assert told(latin) == ": line 3: byte 0xfc is not UTF-8; save the file as UTF-8"
    assert told(tmp_path / "none.toml") == ": there is no such file"
    assert told(tmp_path) == ": is a folder; name a file"
    assert "is not a file name" in told(tmp_path / "a\0b")


def test_a_byte_order_mark_is_no_fault(tmp_path: Path) -> None:
    path = tmp_path / "bom.toml"
    path.write_bytes(b"\xef\xbb\xbf" + BASE.encode())
    assert read_machine(path) == machine_of(BASE)
