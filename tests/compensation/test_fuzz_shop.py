"""Mutated programs of shops: a clear fault, or a program with which a control goes where the source sends it."""

import tempfile
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.compensation.analytic_machine import paper_sized
from tests.compensation.control import Bench
from tests.compensation.few_blocks import FEWEST, runs_of
from tests.compensation.shop_control import AXES
from tests.compensation.test_fuzz import mutated
from tests.compensation.test_offsets import KNOWN, both
from tests.compensation.test_tools import LENGTHS, TABLE
from trueaxis.io.faults import InputError

SOURCE = """N1 G21 G90 G17 G54 M3
N2 G91 G28 Z0.
N3 T1 M6
N4 G90 G0 X10. Y20.
N5 G43 H1 Z50.
N6 G1 Z-2. F200
N7 X60. Y25.
N8 G93 X65. F4.
N9 G94 G52 X3. Y1.
N10 G0 X5. Y5.
N11 G52 X0. Y0.
N12 G99 G81 X1. Y2. Z-3. R4. F90
N13 X7.
N14 G98 G83 X9. Z-5. R2. Q1.5
N15 G80
N16 G0 Z60.
N17 G92 X100.
N18 G1 X90. F30
N19 G92.2
N20 G55 G0 X0. Y0. Z10.
N21 G53 G0 Z90.
N22 G49
N23 T2 M6
N24 G0 G43 H2 Z30.
N25 X8. Y8.
N26 G10 L2 P2 X-190.
N27 G0 X9.
N28 G1 Y7. Z25. F100
N29 M30
"""
TOKENS = st.sampled_from(
    ["G0", "G1", "G53", "G54", "G55", "G56", "G91", "G90", "G80", "G81", "G28", "G49", "G43", "H0", "H1", "H2", "M6",
     "T2", "M61 Q2", "G92", "G52", "G93", "G94", "G98", "G99", " R3.", " Z-4.", " X2.", " Y", "Q", "L2", "P1", "\n",
     "N40 ", "M30", "G10 L20", "G20", "/", "G18", "M0", ".", "-", "5", "(", "G92.1", "X0"]
)  # fmt: skip
MUTATIONS = st.lists(st.tuples(st.floats(0.0, 1.0), st.integers(0, 8), TOKENS), max_size=4)


@settings(max_examples=120, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(MUTATIONS, st.tuples(*[st.integers(-40, 40)] * 4), st.sampled_from([None, "fanuc", "linuxcnc"]), FEWEST)
def test_mutated_programs(
    mutations: list[tuple[float, int, str]], wrong: tuple[int, ...], dialect: Any, fewest: int
) -> None:
    """Offsets and lengths of the control are up to 4 mm off what was given."""
    source = mutated(SOURCE, mutations)
    with tempfile.TemporaryDirectory() as folder, runs_of(fewest):
        bench = Bench(Path(folder))
        try:
            written = bench.run(
                source, paper_sized(3.0), offsets=KNOWN, tools=TABLE, dialect=dialect, integers="mm", block_delete="run"
            )
        except InputError:
            return
    offsets = {
        name: {axis: value[0] + wrong[row] / 10 for axis, value in of.items()}
        for row, (name, of) in enumerate(KNOWN.systems.items())
    }
    lengths = {number: length + wrong[2 + number % 2] / 10 for number, length in LENGTHS.items()}
    references = {28: {"X": 50.0, "Y": 60.0, "Z": 300.0}, 30: {"X": 50.0, "Y": 60.0, "Z": 200.0}}
    known = {"offsets": offsets, "lengths": lengths, "references": references, "linuxcnc": dialect == "linuxcnc"}
    by_source, by_written = both(source.decode().replace("/", ""), written.replace(b"/", b""), **known)
    ends, wanted = ({number: at for number, _, at, _ in one.trace} for one in (by_written, by_source))
    for number, at in wanted.items():
        assert max(abs(ends[number][axis] - at[axis]) for axis in AXES) < 0.3, (number, source, written.decode())
