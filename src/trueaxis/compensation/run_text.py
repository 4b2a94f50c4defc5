"""The text of a run of blocks, all of it at once: a table of characters, of which those that are there are kept."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.nc_plain import PlainRun

_Table = list[tuple[NDArray[np.uint8], NDArray[np.bool_]]]  # by columns: characters, and in which blocks they are


def run_text(
    run: PlainRun,
    forms: Sequence[tuple[str, int]],
    counts: NDArray[np.int64],
    named: NDArray[np.bool_],
    own: Mapping[int, str],
) -> str:
    """The blocks of a run with new words.

    forms: letter and decimals of each axis, at least one. counts: (n_axes, n), what words count, in units of their
    last decimal. named: (n_axes, n), which words are written. own: the text of blocks, by their number in the run, in
    which these do not count.
    """
    columns: _Table = []
    _add_source(columns, run, run.starts[:-1], run.lead)
    digits = _digits(np.abs(counts), max(decimals for _, decimals in forms) + 1)
    before = np.zeros(run.count, dtype=bool)
    for row, ((letter, decimals), there) in enumerate(zip(forms, named, strict=True)):
        if not there.any():
            continue
        if run.gap and before.any():
            columns.append((_same(run.gap), before & there))
        columns.append((_same(letter), there))
        if (negative := counts[row] < 0).any():
            columns.append((_same("-"), negative & there))
        for place in range(len(digits) - 1, -1, -1):
            sign, leads = digits[place]
            columns.append((sign[row], there & leads[row] if place > decimals else there))
            if place == decimals:
                columns.append((_same("."), there))
        before = before | there
    _add_source(columns, run, run.starts[1:] - len(run.eol) - run.tail, run.tail)
    everywhere = np.ones(run.count, dtype=bool)
    columns += [(_same(sign), everywhere) for sign in run.eol]
    table = np.empty((run.count, len(columns)), dtype=np.uint8)
    kept = np.empty(table.shape, dtype=np.bool_)
    for number, (signs, there) in enumerate(columns):
        table[:, number], kept[:, number] = signs, there
    return _with_own(table, kept, own)


def _with_own(table: NDArray[np.uint8], kept: NDArray[np.bool_], own: Mapping[int, str]) -> str:
    """The characters that are kept, block by block, with the text of some blocks in their place."""
    if not own:
        return table[kept].tobytes().decode("latin-1")
    kept[list(own)] = False
    text = table[kept].tobytes().decode("latin-1")
    ends = np.cumsum(kept.sum(axis=1))[list(own)].tolist()
    parts, last = [], 0
    for end, of_own in zip(ends, own.values(), strict=True):
        parts += [text[last:end], of_own]
        last = end
    return "".join([*parts, text[last:]])


def _same(sign: str) -> NDArray[np.uint8]:
    return np.array(ord(sign), dtype=np.uint8)


def _add_source(columns: _Table, run: PlainRun, first: NDArray[np.int64], length: NDArray[np.int64]) -> None:
    """Characters of the source: so many from these places on."""
    for index in range(int(length.max())):
        there = length > index
        columns.append((run.source[np.where(there, first + index, 0)], there))


def _digits(size: NDArray[np.int64], fewest: int) -> _Table:
    """The digits of whole numbers, the last first, and whether it or one before it is not 0; each as the numbers."""
    most = int(size.max())
    rest: NDArray[np.unsignedinteger] = size.astype(np.uint32 if most < 2**32 else np.uint64)
    out = []
    for _ in range(max(len(str(most)), fewest)):
        before = rest // 10
        out.append(((rest - before * 10 + ord("0")).astype(np.uint8), rest > 0))
        rest = before
    return out
