"""Length does not matter: memory is bounded and batches leave no trace in the result."""

import math
import tracemalloc

import numpy as np
import pytest

from tests.compensation.analytic_machine import paper_sized
from tests.compensation.control import Bench
from trueaxis.compensation.columns import columns_of
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.settings import Settings


def wave(blocks: int) -> str:
    lines = ["G21 G90 G0 X0. Y0. Z0.", "G1 F500"]
    for number in range(blocks):
        x, y = 0.3 * (number % 1000), 0.1 * (number // 1000)
        lines.append(f"X{x:.3f} Y{y:.3f} Z{3 * math.sin(x):.3f}" if number % 50 else f"G3 X{x:.3f} Y{y + 2:.3f} R400. ")
        if not number % 50:
            lines.append("G1")
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("words", ["nearest", "ends"])
def test_the_size_of_batches_does_not_show(bench: Bench, words: str) -> None:
    text, machine = wave(600), paper_sized()
    whole = bench.run(text, machine, words=words, ball=(0.0, 0.0, 0.0))
    first = bench.report
    parts = bench.run(text, machine, words=words, ball=(0.0, 0.0, 0.0), batch_points=17)
    assert parts == whole
    for name in ("points", "moves", "iterations", "blocks_out", "not_converged"):
        assert getattr(bench.report, name) == getattr(first, name)
    assert first.after is not None
    assert bench.report.after is not None
    assert bench.report.after.mean == pytest.approx(first.after.mean)
    assert bench.report.after.sd == pytest.approx(first.after.sd)


def test_memory_does_not_grow_with_the_program(bench: Bench) -> None:
    machine = paper_sized()
    peaks = []
    for blocks in (24_000, 80_000):  # both are more than is read at once
        text = wave(blocks).encode()
        bench.program.write_bytes(text)
        del text
        tracemalloc.start()
        compensate_file(bench.program, bench.out, machine, Settings(batch_points=2000), language="nc")
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 1.2 * peaks[0]


def test_many_circles_are_taken_in_parts(bench: Bench) -> None:
    peaks = []
    for circles in (60, 180):
        bench.program.write_text("G0 X100. Y0. Z0.\nF100\n" + "G3 I-100. J0.\n" * circles)
        tracemalloc.start()
        compensate_file(
            bench.program, bench.out, paper_sized(), Settings(batch_points=2000, arcs="chords"), language="nc"
        )
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert bench.out.read_bytes().count(b"\n") > 170_000
    assert peaks[1] < 1.2 * peaks[0]


@pytest.mark.parametrize("of", [slice(1, 5, 2), np.array([4, 0, 0]), np.array([True, False, True, False, True])])
def test_columns_keep_rows_side_by_side(of: slice | np.ndarray) -> None:
    table = np.arange(15.0).reshape(3, 5)
    taken = columns_of(table, of)
    np.testing.assert_array_equal(taken, table[:, of])
    assert np.shares_memory(taken, table) or taken.flags.c_contiguous
