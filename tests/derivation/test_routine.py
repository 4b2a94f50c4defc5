"""What every routine record promises: stages, no waste, every result, every symbol told."""

import re
from collections import Counter
from functools import cache

import pytest
import sympy as sp

from tests.derivation.test_systems import derived
from tests.kernels import model_of
from tests.machines import FIVE_AXIS
from trueaxis.derivation import symbols
from trueaxis.derivation.model import DerivedModel
from trueaxis.derivation.routine import Argument, Binder, Routine, build

TRIGONOMETRY = sp.cos, sp.sin


@cache
def models() -> dict[str, DerivedModel]:
    return {"dmu60p": derived(), "five_axis": model_of(FIVE_AXIS.read_text())}


def assignments(routine: Routine) -> list[tuple[sp.Symbol, sp.Expr]]:
    return [*routine.batch, *routine.preparation, *routine.body]


def inputs(routine: Routine, *, per_point: bool | None = None) -> set[str]:
    return {row for a in routine.inputs if per_point in (None, a.per_point) for row in a.rows}


@pytest.mark.parametrize("name", ["dmu60p", "five_axis"])
class TestEveryRoutine:
    def test_the_batch_holds_constants_alone(self, name: str) -> None:
        for routine in models()[name].routines:
            known = inputs(routine, per_point=False)
            for target, value in routine.batch:
                assert {s.name for s in value.free_symbols} <= known, routine.name
                known.add(target.name)

    def test_what_is_the_same_at_all_points_is_not_computed_per_point(self, name: str) -> None:
        # A temporary of the body that hangs on no quantity per point would be computed anew at every point.
        for routine in models()[name].routines:
            varying = inputs(routine, per_point=True) | {target.name for target, _ in routine.preparation}
            results = {row for a in routine.outputs for row in a.rows}
            for target, value in routine.body:
                hangs = any(s.name in varying for s in value.free_symbols)
                assert hangs or target.name in results, (routine.name, target)
                if hangs:
                    varying.add(target.name)

    def test_only_the_preparation_calls_the_library(self, name: str) -> None:
        for routine in models()[name].routines:
            if routine.name.startswith("effect_"):  # their expressions are a person's
                continue
            for _, value in routine.batch + routine.body:
                functions = value.atoms(sp.Function)
                assert not functions, (routine.name, functions)
                for power in value.atoms(sp.Pow):
                    assert power.exp in (-1, 2, 3, 4, sp.Rational(1, 2)), (routine.name, power)
            for _, value in routine.preparation:
                assert isinstance(value, TRIGONOMETRY), routine.name

    def test_every_value_is_made_once_before_it_is_used_and_is_used(self, name: str) -> None:
        for routine in models()[name].routines:
            known, used = inputs(routine), set()
            for target, value in assignments(routine):
                needs = {s.name for s in value.free_symbols}
                assert needs <= known, (routine.name, target)
                assert target.name not in known, (routine.name, target)
                known.add(target.name)
                used |= needs
            results = [row for a in routine.outputs for row in a.rows]
            assert len(set(results)) == len(results)
            assert set(results) <= known
            unused = {target.name for target, _ in assignments(routine)} - used - set(results)
            assert not unused, (routine.name, unused)

    def test_no_expression_is_computed_twice(self, name: str) -> None:
        for routine in models()[name].routines:
            values = [value for _, value in assignments(routine) if not value.is_Atom and not (-value).is_Atom]
            assert not [v for v, count in Counter(values).items() if count > 1], routine.name
            # Nor as part of another one: what stands under a name is not written out again.
            named = {value for _, value in assignments(routine) if value.args and not value.is_Atom}
            for target, value in assignments(routine):
                inner = {part for arg in value.args for part in sp.preorder_traversal(arg)}
                again = {p for p in inner & named if p.count_ops() > 0 and not (-p).is_Atom}
                assert not again, (routine.name, target, again)

    def test_operations_are_counted_as_they_stand(self, name: str) -> None:
        for routine in models()[name].routines:
            per_point = sum(sp.count_ops(value) for _, value in routine.preparation + routine.body)
            assert routine.operations == per_point, routine.name
            assert routine.batch_operations == sum(sp.count_ops(value) for _, value in routine.batch), routine.name

    def test_every_symbol_has_a_unit_and_a_description(self, name: str) -> None:
        model = models()[name]
        texts = symbols.describe(model.machine)
        for routine in model.routines:
            rows = {row: argument for argument in routine.inputs + routine.outputs for row in argument.rows}
            for argument in routine.inputs + routine.outputs:
                assert argument.unit, (routine.name, argument.name)
                assert argument.description, (routine.name, argument.name)
                size = 1
                for length in argument.shape:
                    size *= length
                assert size == len(argument.rows), (routine.name, argument.name)
            for target, value in assignments(routine):
                for symbol in {target, *value.free_symbols}:
                    known = symbol.name in texts or symbol.name in rows or re.fullmatch(r"w\d+", symbol.name)
                    assert known, (routine.name, symbol)
            # What a table of rows cannot tell apart is told of each.
            for argument in routine.inputs:
                if argument.name in ("positions", "errors", "parameters") and not routine.name.startswith("effect_"):
                    for row in argument.rows:
                        assert texts[row].unit in ("mm", "rad", "deg"), row
                        assert texts[row].description, row
                        assert texts[row].latex, row
        assert {*model.machine.components, *model.machine.parameters} <= texts.keys()

    def test_routine_names_summaries_and_sources_are_there(self, name: str) -> None:
        names = [routine.name for routine in models()[name].routines]
        assert len(set(names)) == len(names)
        assert all(routine.summary.endswith(".") and routine.source for routine in models()[name].routines)


X, Y, K = (sp.Symbol(name, real=True) for name in ("rx", "ry", "k"))
PER_POINT = Argument(name="point", rows=("rx", "ry"), shape=(2,), per_point=True, unit="mm", description="a point")
CONSTANT = Argument(name="k", rows=("k",), shape=(1,), per_point=False, unit="1", description="a constant")
OUT = Argument(name="out", rows=("dx", "dy"), shape=(2,), per_point=True, unit="mm", description="a result")


def built(results: dict[str, sp.Expr], bound: list[tuple[sp.Symbol, sp.Expr]] | None = None) -> Routine:
    return build("f", "F.", "by hand", (PER_POINT, CONSTANT), (OUT,), results, bound or [])


def test_constants_go_to_the_batch_and_the_rest_to_the_body() -> None:
    routine = built({"dx": X * (K**2 + 1), "dy": Y * (K**2 + 1)})
    (constant,) = routine.batch
    assert constant[1] == K**2 + 1
    assert [value for _, value in routine.body] == [X * constant[0], Y * constant[0]]
    assert (routine.operations, routine.batch_operations) == (2, 2)


def test_what_no_result_needs_is_dropped() -> None:
    binder = Binder()
    needed, _ = binder.bind(X + Y), binder.bind(X * Y**2)
    routine = built({"dx": needed, "dy": needed * K}, binder.assignments)
    assert [str(assignment) for assignment in routine.body] == ["(dx, rx + ry)", "(dy, dx*k)"]


def test_results_that_are_constant_or_zero_are_still_made() -> None:
    routine = built({"dx": K, "dy": sp.S.Zero})
    assert [str(assignment) for assignment in routine.body] == ["(dx, k)", "(dy, 0)"]
    assert routine.batch == ()


def test_two_results_of_one_value_are_both_made() -> None:
    routine = built({"dx": X * Y + K, "dy": X * Y + K})
    assert {target.name for target, _ in routine.body} >= {"dx", "dy"}
    assert routine.operations == 2


def test_a_binder_names_only_what_is_more_than_a_symbol() -> None:
    binder = Binder()
    assert binder.bind_all([X, -X, sp.Integer(3), sp.S.Zero]) == (X, -X, 3, 0)
    assert binder.assignments == []
    assert binder.bind(X + 1) in {target for target, _ in binder.assignments}
