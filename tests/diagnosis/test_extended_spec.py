"""A spec is extended in place: it reads as before with the effects behind, and nothing a person wrote is moved."""

import os
import re
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.machines import FIVE_AXIS, ROOT
from trueaxis.diagnosis.extended_spec import extended_spec, moved_spec
from trueaxis.effects.kind import Effect

SPECS = [*sorted((ROOT / "machines").glob("*.toml")), FIVE_AXIS]
BACKLASH = Effect(kind="backlash", component="EXX")
FOUND = (
    BACKLASH,
    Effect(kind="cross_axis", component="EZX", axis="Y"),
    Effect(kind="laser_cosine", runs=("X1", 'the "long" one', "a\\b\x7f")),
    Effect(kind="point_offset", runs=("X1",), end="reference"),
    Effect(kind="reading_zero", runs=("X1",)),
    Effect(kind="reversal_spike_path", component="EXX"),
    Effect(kind="squareness", component="EC0X"),
)
TABLES: list[dict[str, Any]] = [
    {"kind": "backlash", "component": "EXX"},
    {"kind": "cross_axis", "component": "EZX", "axis": "Y"},
    {"kind": "laser_cosine", "runs": ["X1", 'the "long" one', "a\\b\x7f"]},
    {"kind": "point_offset", "runs": ["X1"], "end": "reference"},
    {"kind": "reading_zero", "runs": ["X1"]},
    {"kind": "reversal_spike_path", "component": "EXX"},
    {"kind": "squareness", "component": "EC0X"},
]


def written(path: Path) -> str:
    return path.read_bytes().decode()


def one_piece_was_put_in(before: str, after: str) -> bool:
    """Whether `after` is `before` with one stretch of text put in somewhere."""
    grown = len(after) - len(before)
    return grown > 0 and any(after[:i] + after[i + grown :] == before for i in range(len(before) + 1))


def assert_extended(before: str, after: str, tables: Sequence[Mapping[str, Any]]) -> None:
    old = tomllib.loads(before)
    assert tomllib.loads(after) == old | {"effect": [*old.get("effect", []), *tables]}
    assert one_piece_was_put_in(before, after)


@pytest.mark.parametrize("path", SPECS, ids=lambda path: path.stem)
@pytest.mark.parametrize("newline", ["\n", "\r\n"])
@pytest.mark.parametrize("last", [True, False])
def test_every_machine_reads_as_before_with_the_effects_behind(path: Path, newline: str, last: bool) -> None:
    text = written(path).replace("\n", newline)
    text = text if last else text.removesuffix(newline)
    extended = extended_spec(text, FOUND)
    assert extended.startswith(text)
    assert_extended(text, extended, TABLES)
    assert ("\r" in extended) == (newline == "\r\n")
    assert not re.search("\r(?!\n)", extended)
    assert extended.endswith(newline)
    assert extended.count(newline) == extended.count("\n"), "one kind of line ends"


def test_the_addition_is_readable() -> None:
    assert extended_spec('name = "m"', FOUND[:2]) == (
        'name = "m"\n\n# Found by trueaxis diagnose.\n'
        '[[effect]]\nkind = "backlash"\ncomponent = "EXX"\n\n'
        '[[effect]]\nkind = "cross_axis"\ncomponent = "EZX"\naxis = "Y"\n'
    )


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("effect = []\n", 'effect = [{ kind = "backlash", component = "EXX" }]\n'),
        (
            'effect = [ {kind = "drift", component = "EYY"} ]  # ]\n[ends]\n',
            'effect = [ {kind = "drift", component = "EYY"}, { kind = "backlash", component = "EXX" } ]  # ]\n[ends]\n',
        ),
        (
            'effect = [\r\n  {kind = "drift", component = "EYY"}, # [1]\r\n]\r\n',
            'effect = [\r\n  {kind = "drift", component = "EYY"}, # [1]\r\n'
            ' { kind = "backlash", component = "EXX" }]\r\n',
        ),
        (
            'a = "]"\neffect = [\n  {kind = "laser_cosine", runs = ["]"]}\n  # none ]\n]\nb = [1]\n',
            'a = "]"\neffect = [\n  {kind = "laser_cosine", runs = ["]"]}\n  # none ]\n'
            ', { kind = "backlash", component = "EXX" }]\nb = [1]\n',
        ),
    ],
)
def test_effects_in_a_list_on_a_line_come_into_the_list(before: str, after: str) -> None:
    assert extended_spec(before, [BACKLASH]) == after
    assert one_piece_was_put_in(before, after)


def test_tables_of_effects_may_stand_in_the_middle() -> None:
    text = '[[effect]]\nkind = "drift"\ncomponent = "EYY"\n\n[ends]\ntool = 9 # the last'
    extended = extended_spec(text, FOUND)
    assert extended.startswith(text + "\n")
    assert_extended(text, extended, TABLES)


@pytest.mark.parametrize("path", SPECS, ids=lambda path: path.stem)
def test_what_is_there_is_not_added_again(path: Path) -> None:
    text = written(path)
    once = extended_spec(text, FOUND)
    assert extended_spec(once, FOUND) == once
    assert extended_spec(once, FOUND[::-1]) == once
    assert extended_spec(text, [*FOUND, *FOUND]) == once
    assert extended_spec(text, []) == text


def test_effects_are_told_apart_by_all_that_they_act_on() -> None:
    there = extended_spec(
        "", [Effect(kind="laser_cosine", runs=("X1", "X2")), Effect(kind="point_offset", runs=("X1",))]
    )
    same = [Effect(kind="laser_cosine", runs=("X2", "X1")), Effect(kind="point_offset", runs=("X1",), end="target")]
    assert extended_spec(there, same) == there
    others = [
        Effect(kind="laser_cosine", runs=("X1",)),
        Effect(kind="point_offset", runs=("X1",), end="reference"),
        Effect(kind="cross_axis", component="EZX", axis="Y"),
        Effect(kind="cross_axis", component="EZX", axis="Z"),
        Effect(kind="cross_axis", component="EYX", axis="Z"),
    ]
    assert len(tomllib.loads(extended_spec(there, others))["effect"]) == 2 + len(others)


COMMENTS = st.lists(st.sampled_from(["# a note ]", "# effect = [", "", "#", "   ", "# [[effect]]"]), max_size=3)
LETTERS = st.characters(codec="utf-8", exclude_categories=["Cs"])
NAMES = st.text(LETTERS, max_size=6)
EFFECTS = st.builds(
    Effect,
    kind=st.sampled_from(["backlash", "drift", "laser_cosine"]) | NAMES,
    component=st.none() | st.sampled_from(["EXX", "EC0X"]) | NAMES,
    axis=st.none() | st.sampled_from("XYZ"),
    runs=st.lists(NAMES, max_size=2).map(tuple),
    end=st.none() | st.sampled_from(["target", "reference"]),
)
TAILS = st.sampled_from(
    [
        "",
        "[ends]\nworkpiece = 4\ntool = 9\n",
        "[axis.X]\ntravel = [0.0, 1.0] # ]\n",
        "[[body]]\nposition = [\n  1.0, # first ]\n  'q',\n]\n",
        '[[effect]]\nkind = "servo_lag"\ncomponent = "EYY"\n\n[tool]\nposition = ["q_Px", 0, 0]\n',
        "[[effect_kind]]\nname = 'own'\nparameters.sag = { unit = \"u\", grid = [1.0, 2.0] }\n",
    ]
)
LISTS = st.sampled_from(
    [
        "",
        "effect = []\n",
        "effect = [ # none ]\n]\n",
        '\'effect\' = [{kind = "servo_lag", runs = [\']\', "\\"]"]}]\n',
        'effect = [\n  { kind = "servo_lag" }, # ], \n  # and ]\n]\n',
        'effect=[{kind="servo_lag"},]# ]',
        'effect = [{kind = """servo\n]lag"""}\n\n\n]\n',
    ]
)


@given(COMMENTS, LISTS, COMMENTS, TAILS, COMMENTS, st.booleans(), st.booleans(), st.lists(EFFECTS, max_size=3))
def test_any_layout(
    head: list[str],
    effect_list: str,
    middle: list[str],
    tail: str,
    foot: list[str],
    crlf: bool,
    cut: bool,
    effects: list[Effect],
) -> None:
    if effect_list:
        tail = tail.replace("[[effect]]", "[[effect_kind]]")  # no TOML has both
    lines = ["schema = 1", *head, effect_list, *middle, tail, *foot]
    text = "\n".join(lines)
    text = text.rstrip("\n") if cut else f"{text}\n"
    text = text.replace("\n", "\r\n") if crlf else text
    tomllib.loads(text)
    extended = extended_spec(text, effects)
    there = tomllib.loads(text).get("effect", [])
    new = tomllib.loads(extended).get("effect", [])[len(there) :]
    if new:
        assert_extended(text, extended, new)
    wanted = {(e.kind, e.component, e.axis, frozenset(e.runs), e.end or "target") for e in effects}
    before, added = [identity(table) for table in there], [identity(table) for table in new]
    assert sorted(added, key=repr) == sorted(wanted - set(before), key=repr), "each that is not there, once"
    assert extended_spec(extended, effects) == extended


def identity(table: Mapping[str, Any]) -> tuple[Any, ...]:
    runs = frozenset(table.get("runs", []))
    return table["kind"], table.get("component"), table.get("axis"), runs, table.get("end", "target")


@pytest.mark.parametrize("text", ["effect = 3\n", "effect.kind = 'a'\n", "[effect]\nkind = 'a'\n", "a = "])
def test_what_is_no_spec_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r"."):
        extended_spec(text, [BACKLASH])


class TestRuns:
    SPEC = '# runs = \'no\'\nname = "m"\nruns   = \'plans/a\' # 18 "runs"\n[[effect]]\nruns = ["X1"]\n'

    def test_a_path_leads_to_the_same_folder_from_elsewhere(self, tmp_path: Path) -> None:
        plans, out = tmp_path / "specs" / "plans" / "a", tmp_path / "results" / "out"
        plans.mkdir(parents=True)
        moved = moved_spec(self.SPEC, tmp_path / "specs", out)
        runs = tomllib.loads(moved)["runs"]
        assert (out / runs).resolve() == plans
        assert runs == "../../specs/plans/a"
        assert moved == self.SPEC.replace("'plans/a'", f'"{runs}"')

    def test_it_does_through_a_link_too(self, tmp_path: Path) -> None:
        plans = tmp_path / "specs" / "plans" / "a"
        plans.mkdir(parents=True)
        (tmp_path / "deep" / "real").mkdir(parents=True)
        (tmp_path / "link").symlink_to(tmp_path / "deep" / "real")
        runs = tomllib.loads(moved_spec(self.SPEC, tmp_path / "specs", tmp_path / "link"))["runs"]
        assert Path(os.path.realpath(os.path.join(tmp_path / "link", runs))) == plans  # noqa: PTH118

    @pytest.mark.parametrize("spec", [SPEC, SPEC.replace("plans/a", "/plans/a"), "name = 'm'\n"])
    def test_nothing_changes_where_the_path_leads_there_already(self, spec: str, tmp_path: Path) -> None:
        target = tmp_path / ("x/.." if "'plans/a'" in spec else "out")
        (tmp_path / "x").mkdir()
        assert moved_spec(spec, tmp_path, target) == spec

    def test_only_the_key_of_the_machine_is_changed(self, tmp_path: Path) -> None:
        text = 'title = "runs"\n"runs" = "a\\u002Fb"\n[run]\nruns = "a/b"\n'
        moved = moved_spec(text, tmp_path, tmp_path / "out")
        assert tomllib.loads(moved) == {"title": "runs", "runs": "../a/b", "run": {"runs": "a/b"}}
