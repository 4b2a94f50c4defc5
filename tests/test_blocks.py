"""The order of solution: hand-made cases, and any system against solving it in that order."""

from itertools import product

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from trueaxis.blocks import Block, SolutionOrder, _components, solution_order


def test_a_chain_is_solved_from_its_end() -> None:
    # 0: u0 u1; 1: u1 u2; 2: u2
    found = solution_order([[0, 1], [1, 2], [2]], 3)
    assert found == SolutionOrder((Block((2,), (2,)), Block((1,), (1,)), Block((0,), (0,))), (), ())


def test_what_needs_each_other_is_solved_together() -> None:
    found = solution_order([[0, 1], [0, 1], [1, 2]], 3)
    assert found.blocks == (Block((0, 1), (0, 1)), Block((2,), (2,)))


def test_independent_blocks_keep_the_order_of_their_equations() -> None:
    found = solution_order([[2], [0], [1]], 3)
    assert [block.unknowns for block in found.blocks] == [(2,), (0,), (1,)]


def test_an_equation_too_many_joins_the_last_of_its_unknowns() -> None:
    found = solution_order([[0], [0, 1], [0, 1], [0]], 2)
    assert found.blocks == (Block((0, 3), (0,)), Block((1, 2), (1,)))


def test_what_is_underdetermined_is_told_and_its_equations_are_left() -> None:
    # u1 and u2 share their one equation; u3 is in none.
    found = solution_order([[0], [0, 1, 2]], 4)
    assert found == SolutionOrder((Block((0,), (0,)),), (1, 2, 3), (1,))


def test_nothing_is_told_of_nothing() -> None:
    assert solution_order([], 0) == SolutionOrder((), (), ())
    assert solution_order([[], []], 1) == SolutionOrder((), (0,), (0, 1))


incidences = st.integers(1, 7).flatmap(
    lambda count: st.tuples(
        st.lists(st.lists(st.integers(0, count - 1), max_size=4), max_size=10),
        st.just(count),
    )
)


@given(incidences)
def test_each_block_needs_only_what_was_found_before_and_everything_is_accounted_for(
    case: tuple[list[list[int]], int],
) -> None:
    incidence, count = case
    found = solution_order(incidence, count)
    known: set[int] = set()
    for block in found.blocks:
        assert len(block.equations) >= len(block.unknowns)
        for equation in block.equations:
            assert set(incidence[equation]) <= known | set(block.unknowns)
        known |= set(block.unknowns)
    assert known | set(found.undetermined) == set(range(count))
    assert not known & set(found.undetermined)
    used = [equation for block in found.blocks for equation in block.equations]
    assert sorted([*used, *found.unused]) == list(range(len(incidence)))


@given(incidences, st.integers(0, 2**32 - 1))
def test_solving_in_this_order_finds_what_the_whole_determines(case: tuple[list[list[int]], int], seed: int) -> None:
    # Generic numbers at the places of the unknowns: structure is then all that matters.
    incidence, count = case
    rng = np.random.default_rng(seed)
    matrix = np.zeros((len(incidence), count))
    for row, unknowns in enumerate(incidence):
        matrix[row, unknowns] = rng.uniform(1, 2, len(unknowns)) * rng.choice([-1, 1], len(unknowns))
    truth = rng.normal(size=count)
    right = matrix @ truth
    values = np.zeros(count)
    found = solution_order(incidence, count)
    for block in found.blocks:
        rows, columns = list(block.equations), list(block.unknowns)
        others = right[rows] - matrix[rows] @ values
        values[columns] = np.linalg.lstsq(matrix[np.ix_(rows, columns)], others, rcond=None)[0]
    solved = [u for block in found.blocks for u in block.unknowns]
    np.testing.assert_allclose(values[solved], truth[solved], rtol=1e-6, atol=1e-6)
    # And what is called undetermined is so: the whole system leaves it free.
    null = np.linalg.svd(matrix)[2][np.linalg.matrix_rank(matrix) :] if matrix.size else np.eye(count)
    for unknown in found.undetermined:
        assert np.abs(null[:, unknown]).max(initial=0) > 1e-9


@given(incidences, st.randoms(use_true_random=False))
def test_which_unknowns_can_be_found_does_not_hang_on_the_order_of_equations(
    case: tuple[list[list[int]], int], random: object
) -> None:
    incidence, count = case
    shuffled = list(incidence)
    random.shuffle(shuffled)  # type: ignore[attr-defined]
    assert solution_order(incidence, count).undetermined == solution_order(shuffled, count).undetermined


@given(st.data(), st.integers(1, 9))
def test_what_needs_each_other_is_what_scipy_finds(data: st.DataObject, count: int) -> None:
    """Strongly connected components, of any needs: equation k is matched to unknown k."""
    needs = st.lists(st.integers(0, count - 1), max_size=4)
    held = [tuple(sorted({k, *data.draw(needs)})) for k in range(count)]
    labels = _components(held, {k: k for k in range(count)}, range(count))
    pairs = [(k, other) for k, others in enumerate(held) for other in others]
    rows, columns = np.array(pairs).T
    graph = coo_array((np.ones(len(pairs)), (rows, columns)), shape=(count, count))
    expected = connected_components(graph, directed=True, connection="strong")[1]
    for one, other in product(range(count), repeat=2):
        assert (labels[one] == labels[other]) == (expected[one] == expected[other])
