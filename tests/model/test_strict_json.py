"""JSON text that is valid, or nearly so, and hostile."""

import json
import sys

import pytest

from trueaxis.io.faults import Faults
from trueaxis.model import strict_json
from trueaxis.model.strict_json import parse


@pytest.mark.parametrize("depth", [100, 900, 990, 995, 1000, 100_000])
def test_any_depth_is_read_or_a_fault(depth: int) -> None:
    faults = Faults("f")
    parse("[" * depth + "]" * depth, faults)
    assert [fault.problem for fault in faults.found] in ([], ["is nested too deeply"])


def test_repeated_keys_are_noted_deeper_than_python_recurses(monkeypatch: pytest.MonkeyPatch) -> None:
    """Newer versions of Python parse deeper than they recurse: a tree of that depth is made by hand here."""
    depth = 3 * sys.getrecursionlimit()
    tree = json.loads('{"a": 1, "a": 2}', object_pairs_hook=strict_json._object)
    for _ in range(depth):
        tree = [tree]
    monkeypatch.setattr(json, "loads", lambda *_, **__: tree)
    faults = Faults("f")
    parse("", faults)
    (fault,) = faults.found
    assert fault.place == "[0]" * depth + ".a"
    assert len(str(fault)) < 1200  # the ends of the place, and how much is left out


def test_repeated_keys_come_in_the_order_of_the_text() -> None:
    faults = Faults("f")
    parse('{"b": {"x": 1, "x": 2}, "a": [{"y": 0, "y": 0}, {}], "b2": 1, "b2": 2}', faults)
    assert [fault.place for fault in faults.found] == ["b2", "b.x", "a[0].y"]
