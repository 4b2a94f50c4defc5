"""What the bodies of a machine must make together: a tree on the bed with two ends, and names that differ."""

import keyword
import re
from collections import Counter
from collections.abc import Callable, Sequence

from trueaxis.io.toml_lines import KeyPath
from trueaxis.machine.machine import AXES, BED, Body

Complain = Callable[[KeyPath, str, str], None]
IndexedBody = tuple[int, Body]

# Words of C17 that are no words of Python: a parameter's name becomes a variable in both.
_C_WORDS = frozenset(
    "auto bool case char const default do double enum extern false float goto inline int long register restrict "
    "return short signed sizeof static struct switch true typedef union unsigned void volatile while".split()
)
# Names that generated code and its readers use for other things, and what these are.
_RESERVED = {
    re.compile(pattern): what
    for pattern, what in (
        ("[xyzabc]|[XYZABC]|(sin|cos)_[abc]", "an axis: x, X ... c, C, sin_a, cos_a ..."),
        (r"E[XYZABC][XYZABC](_\d+)?", "a component error: EXX, EAX ..., with _1 and the like a coefficient"),
        (
            r"[beipt][xyz]|r([TWB]\d*)?[xyz]|d[xyz](_.*)?",
            "a coordinate: b, d, e, i, p, r or t before x, y or z, rTx, rW1y, dx_ and whatever follows",
        ),
        (r"[wnipej]\d*", "a count or a row: e, i, j, n, p or w, with or without digits"),
        (r"L\d+|(identified|move)_.*", "a reading or a result: L1, identified_ and move_ and whatever follows"),
        (
            "at|start|count|stride|block|length|positions?|errors?|parameters|points?|(tool|workpiece)_point"
            "|ball|curves|deviation|ideal|sensitivity|moves|direction|displacement|readings|unknowns",
            "an argument of a kernel",
        ),
        (
            "np|numpy|slice|range|sin|cos|sqrt|NaN|NAN|NULL|INFINITY|inf|pi|ABI|SPEC_HASH|META|BLOCK",
            "a word of NumPy, C or the kernels",
        ),
    )
}


def taken_for(name: str) -> str | None:
    """What generated code uses a name for; None where it is free."""
    if keyword.iskeyword(name) or name in _C_WORDS:
        return "a word of Python or C"
    return next((what for pattern, what in _RESERVED.items() if pattern.fullmatch(name)), None)


def check_structure(
    bodies: Sequence[IndexedBody], workpiece: int | None, tool: int | None, complete: bool, complain: Complain
) -> None:
    """Complain of duplicates, missing lower bodies, loops, ends not reached, axes moved twice, clashing names.

    workpiece, tool: numbers of the ends' bodies, None where the spec does not tell. complete: whether these are all
    bodies; else one that is missed may be one whose own table is wrong, and nothing is said of it here.
    """
    numbers = {body.number for _, body in bodies if body.number > BED}
    first = {body.number: index for index, body in reversed(bodies)}
    for index, body in bodies:
        if body.number <= BED:
            complain(("body", index, "number"), f"{body.number} is taken by the bed or no body", "numbers from 2")
        elif first[body.number] != index:
            complain(("body", index, "number"), f"two bodies have the number {body.number}", "a number of its own")
        if complete and body.lower != BED and body.lower not in numbers:
            right = f"the bed (1) or one of {', '.join(str(n) for n in sorted(numbers)) or 'the bodies'}"
            complain(("body", index, "lower"), f"there is no body {body.lower}", right)
    _check_ends(bodies, workpiece if complete else None, tool if complete else None, complain)
    _check_axes(bodies, complain)
    _check_names(bodies, complain)


def _check_ends(bodies: Sequence[IndexedBody], workpiece: int | None, tool: int | None, complain: Complain) -> None:
    lower = {body.number: body.lower for _, body in reversed(bodies) if body.number > BED}  # the first of a number
    in_loop = {number for number in lower if _branch(number, lower) is None}
    for index, body in bodies:
        if body.number in in_loop and body.number in _loop(body.number, lower):
            complain(
                ("body", index, "lower"),
                f"body {body.number} stands on itself: the lower bodies run in a loop",
                "every body leads down to the bed (1)",
            )
    on_branch: set[int] = set()
    for key, end in (("workpiece", workpiece), ("tool", tool)):
        if end is None:
            on_branch.update(lower)  # no telling what stands below it
            continue
        if end != BED and end not in lower:
            complain(("ends", key), f"there is no body {end}", "the number of a body")
            on_branch.update(lower)
            continue
        branch = _branch(end, lower)
        if branch is None or branch[-1] != BED:
            complain(
                ("ends", key),
                f"body {end} is not reached from the bed",
                "a chain of lower bodies down to the bed (1)",
            )
            on_branch.update(lower)
        else:
            on_branch.update(branch)
    if workpiece is not None and workpiece == tool:
        complain(("ends",), f"workpiece and tool are both body {tool}", "two different bodies")
        on_branch.update(lower)
    for index, body in bodies:
        if body.number > BED and body.number not in on_branch | in_loop:
            complain(
                ("body", index),
                f"body {body.number} carries neither the workpiece nor the tool",
                "leave it out, or make it part of a branch to one of the ends",
            )


def _branch(number: int, lower: dict[int, int]) -> list[int] | None:
    """The body, its lower body, ... as far down as they lead; None where they run in a loop."""
    branch = [number]
    while branch[-1] in lower:
        branch.append(lower[branch[-1]])
        if len(branch) > len(lower) + 1:
            return None
    return branch


def _loop(number: int, lower: dict[int, int]) -> set[int]:
    """The bodies met by walking down from one of them as often as there are bodies, then once more around."""
    at = number
    for _ in lower:
        at = lower[at]
    met = set()
    while at not in met:
        met.add(at)
        at = lower[at]
    return met


def _check_axes(bodies: Sequence[IndexedBody], complain: Complain) -> None:
    movers = Counter(body.moves for _, body in bodies if body.moves)
    seen: set[str] = set()
    for index, body in bodies:
        if body.moves and body.moves in seen:
            complain(
                ("body", index, "moves"),
                f"axis {body.moves} is moved {movers[body.moves]} times",
                f"each of {' '.join(AXES)} by one body at most",
            )
        if body.moves:
            seen.add(body.moves)


def _check_names(bodies: Sequence[IndexedBody], complain: Complain) -> None:
    names: dict[str, str] = {}
    titles: dict[str, int] = {}
    for index, body in bodies:
        if body.name in titles:
            complain(
                ("body", index, "name"),
                f"body {titles[body.name]} is called {body.name!r} too",
                "a name of its own",
            )
        titles.setdefault(body.name, body.number)
        uses = [("position", part) for part in body.position if isinstance(part, str)]
        uses += [("position_errors", part) for _, part in body.position_errors]
        for key, name in uses:
            where = f"{key} of body {body.number}"
            if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name):
                complain(("body", index, key), f"{name!r} is no name", "a letter, then letters, digits and _")
            elif (what := taken_for(name)) is not None:
                problem = f"the name {name!r} clashes with one that generated code uses for {what}"
                complain(("body", index, key), problem, f"another name, such as q_{name}")
            elif name in names:
                complain(("body", index, key), f"the name {name!r} clashes with {names[name]}", "a name of its own")
            names.setdefault(name, where)
