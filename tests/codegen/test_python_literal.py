"""The literals of generated Python: what was put in comes out, in lines of the width of the code."""

import ast

from hypothesis import given
from hypothesis import strategies as st

from trueaxis.codegen.numpy_source import literal

SCALARS = st.text("abc 'q\\", max_size=8) | st.integers() | st.floats(allow_nan=False, allow_infinity=False) | st.none()
RECORDS = st.recursive(
    SCALARS | st.booleans(),
    lambda inner: st.lists(inner, max_size=30) | st.dictionaries(st.text("abc", min_size=1), inner, max_size=6),
    max_leaves=60,
)


@given(RECORDS)
def test_a_literal_is_what_was_put_in(record: object) -> None:
    assert ast.literal_eval(literal(record)) == record


def test_what_fits_stands_on_one_line_and_nothing_is_wider_than_the_code() -> None:
    record = {"names": [f"name of quantity {k}" for k in range(30)], "empty": {}, "nested": [{"a": [1, 2]}] * 12}
    lines = f"META = {literal(record)}".splitlines()
    assert max(map(len, lines)) <= 120
    assert lines[1] == "    'names': ["
    assert "        {'a': [1, 2]}," in lines
    assert "    'empty': {}," in lines
