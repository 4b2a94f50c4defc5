"""The order in which linear equations can be solved, from which unknowns each of them holds.

Each unknown is matched with an equation of its own, equations of few unknowns first; the strongly connected parts of
"needs to know" are the blocks that must be solved together (block triangular form), the rest is a matter of order.
Used on symbolic systems when they are derived and on measured runs when they are evaluated.
"""

import heapq
from collections.abc import Iterator, Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Block:
    """Equations to be solved together for unknowns, both as indices; more equations than unknowns: least squares."""

    equations: tuple[int, ...]
    unknowns: tuple[int, ...]


@dataclass(frozen=True)
class SolutionOrder:
    """Blocks in an order in which they can be solved; unknowns that no order reaches, and equations left with them."""

    blocks: tuple[Block, ...]
    undetermined: tuple[int, ...]
    unused: tuple[int, ...]


def solution_order(incidence: Sequence[Sequence[int]], count: int) -> SolutionOrder:
    """Find the order.

    incidence: for each equation the unknowns that it holds, as indices below `count`. An equation that was not
    needed for matching is added to the block that holds the last of its unknowns. Ties are broken by the order of
    the equations, so the result is the same everywhere. Cost O(count x entries) at worst.
    """
    held = [tuple(dict.fromkeys(row)) for row in incidence]
    matched = _match(held)  # unknown -> equation
    lost = _unreached(held, matched, count)
    unknowns = [u for u in range(count) if u not in lost]
    labels = _components(held, matched, unknowns)
    members: dict[int, list[int]] = {}
    for unknown, label in zip(unknowns, labels, strict=True):
        members.setdefault(label, []).append(unknown)
    label_of = dict(zip(unknowns, labels, strict=True))
    needs = {
        label: {label_of[v] for u in group for v in held[matched[u]]} - {label} for label, group in members.items()
    }
    first = {label: min(matched[u] for u in group) for label, group in members.items()}
    order = _sorted_by_need(needs, first)
    place = {label: index for index, label in enumerate(order)}
    extra: dict[int, list[int]] = {}
    unused: list[int] = []
    for equation in sorted(set(range(len(held))) - set(matched.values())):
        row = held[equation]
        if not row or any(u in lost for u in row):
            unused.append(equation)
        else:
            extra.setdefault(max((label_of[u] for u in row), key=place.__getitem__), []).append(equation)
    unused += [matched[u] for u in lost if u in matched]
    blocks = tuple(
        Block(tuple(sorted([*(matched[u] for u in members[label]), *extra.get(label, [])])), tuple(members[label]))
        for label in order
    )
    return SolutionOrder(blocks, tuple(sorted(lost)), tuple(sorted(unused)))


def _match(held: Sequence[tuple[int, ...]]) -> dict[int, int]:
    """Augmenting paths, short equations first: the matched set is then the one of fewest entries (a matroid)."""
    matched: dict[int, int] = {}

    def assign(equation: int, seen: set[int]) -> bool:
        for unknown in held[equation]:
            if unknown in seen:
                continue
            seen.add(unknown)
            if unknown not in matched or assign(matched[unknown], seen):
                matched[unknown] = equation
                return True
        return False

    for equation in sorted(range(len(held)), key=lambda e: (len(held[e]), e)):
        assign(equation, set())
    return matched


def _unreached(held: Sequence[tuple[int, ...]], matched: dict[int, int], count: int) -> set[int]:
    """Unknowns without an equation, and all that share an equation with them down to the last."""
    lost = {u for u in range(count) if u not in matched}
    holders: dict[int, list[int]] = {}
    for equation, row in enumerate(held):
        for unknown in row:
            holders.setdefault(unknown, []).append(equation)
    unknown_of = {equation: unknown for unknown, equation in matched.items()}
    waiting = sorted(lost)
    while waiting:
        for equation in holders.get(waiting.pop(), []):
            other = unknown_of.get(equation)
            if other is not None and other not in lost:
                lost.add(other)
                waiting.append(other)
    return lost


def _components(held: Sequence[tuple[int, ...]], matched: dict[int, int], unknowns: Sequence[int]) -> list[int]:
    """A label for each unknown, one for all that need each other: strongly connected (Tarjan 1972)."""
    met: dict[int, int] = {}  # in which order
    lowest: dict[int, int] = {}  # of those that are needed and have no label yet
    labels: dict[int, int] = {}
    unlabelled: list[int] = []
    places: dict[int, int] = {}  # among these
    path: list[tuple[int, Iterator[int]]] = []

    def enter(unknown: int) -> None:
        met[unknown] = lowest[unknown] = len(met)
        places[unknown] = len(unlabelled)
        unlabelled.append(unknown)
        path.append((unknown, iter(held[matched[unknown]])))

    for root in unknowns:
        if root not in met:
            enter(root)
        while path:
            at, left = path[-1]
            following = next((unknown for unknown in left if unknown not in labels), None)
            if following is not None and following not in met:
                enter(following)
            elif following is not None:
                lowest[at] = min(lowest[at], met[following])
            else:
                path.pop()
                for below, _ in path[-1:]:
                    lowest[below] = min(lowest[below], lowest[at])
                if lowest[at] == met[at]:
                    labels |= dict.fromkeys(unlabelled[places[at] :], at)
                    del unlabelled[places[at] :]
    return [labels[unknown] for unknown in unknowns]


def _sorted_by_need(needs: dict[int, set[int]], first: dict[int, int]) -> list[int]:
    """Topological order; of those that are ready, the one with the earliest equation first."""
    left = {label: set(required) for label, required in needs.items()}
    ready = [(first[label], label) for label, required in left.items() if not required]
    heapq.heapify(ready)
    order: list[int] = []
    while ready:
        label = heapq.heappop(ready)[1]
        order.append(label)
        for other, required in left.items():
            if label in required:
                required.remove(label)
                if not required:
                    heapq.heappush(ready, (first[other], other))
    return order
