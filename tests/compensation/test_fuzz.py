"""Mutated programs: a clear fault or a program that an independent control can run, never a traceback."""

import re
import tempfile
from pathlib import Path

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.compensation.analytic_machine import XyzMachine
from tests.compensation.control import Bench, execute, strip, without_mark
from tests.compensation.few_blocks import FEWEST, runs_of
from trueaxis.io.faults import Fault, InputError

NC = (
    "%\nO100 (part)\nG21 G90 G17 G94\nG0 X10. Y0. Z5.\nG1 Z0. F200\nX20. Y5.5\nG2 X30. Y5.5 I5. J0. F90 M8\n"
    "G3 X20. R5.\nG91 X1.5 G1\nX-.5Y2.(note)\nG90 G20\nX.5 Y.25 Z-.01\nG18 G3 X.5 Z.2 I.1 K.1\n"
    "G21 M5\n/N5 M9\n; end\nM30\n%\n"
)
CL = (
    "PARTNO X\nUNITS/MM\nLOADTL/1\nFROM/10,0,50\nSPINDL/RPM,900,CLW\nRAPID\nGOTO/10,0,5,0,0,1\nFEDRAT/100,MMPM\n"
    "GOTO/10,0,0 $$ down\nCIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0\nGOTO/-10, $\n0,0\nGODLTA/1,2,3\nCOOLNT/OFF\nEND\nFINI\n"
)
TOKENS = st.sampled_from(
    ["G0", "G1", "G2", "G3", "G20", "G91", "G41", "X", "Y1.", "Z-2.", "I3.", "J", "R5.", "R-5.", "F", "M30", "%", "(",
     ")", ";", "/", "\n", "\r", " ", "1e400", "NaN", "-", ".", "9" * 30, "#1", "\x00", "\xff", "$", "$$", ",", "GOTO/",
     "CIRCLE/", "RAPID", "FROM/1,2,3", "UNITS/INCHES", "0", "5", "G4", "X99999.", "A1.", "N", "O", "G54", "E", "*"]
)  # fmt: skip
MUTATIONS = st.lists(
    st.tuples(st.floats(0.0, 1.0), st.integers(0, 6), st.one_of(TOKENS, st.text("XYZGIJ0123456789.- \n", max_size=8))),
    max_size=6,
)
MACHINE = XyzMachine({"EXX": lambda x: 1e-3 * x, "EYX": lambda x: 1e-6 * x * x})


def mutated(text: str, mutations: list[tuple[float, int, str]]) -> bytes:
    for share, removed, inserted in mutations:
        place = int(share * len(text))
        text = text[:place] + inserted + text[place + removed :]
    return text.encode("latin-1", "replace")


WORD = re.compile(rb"([A-Za-z])\s*([-+]?(?:\d+\.?\d*|\.\d+))")


def right_or_refused(source: bytes, language: str) -> None:
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(Path(folder))
        faults: tuple[Fault, ...] = ()
        text = b""
        try:
            text = bench.run(source, MACHINE, language, chord_tolerance=0.05)  # type: ignore[arg-type]
        except InputError as error:
            faults = error.faults
        if faults:
            assert all(fault.problem for fault in faults)
            # of all blocks together that leave the travel no line is named; each is, besides
            blocks = [fault for fault in faults[:49] if not re.search(r"reaches .* outside$", fault.problem)]
            assert all(re.match(r"lines? \d", fault.place) for fault in blocks)
            assert not bench.out.exists()
            return
        marked = int(without_mark(bench.out.read_bytes()) != bench.out.read_bytes())
        assert bench.report.blocks_out - marked == len(text.removesuffix(b"\n").split(b"\n")) - (not text)
        if bench.report.after is None:
            if language == "nc":  # of rapids, some axes of which are not known yet, the others are corrected
                given, written = (
                    sorted(((letter, float(value)) for letter, value in WORD.findall(one)), key=lambda word: word[0])
                    for one in (source, text)
                )
                assert [letter for letter, _ in given] == [letter for letter, _ in written]
                assert all(abs(one - other) < 0.5 for (_, one), (_, other) in zip(given, written, strict=True))
            return
        at = execute(text, start=[np.nan] * 3)
        assert np.isfinite(at[:, -1]).all()
        assert np.abs(at).max() < 1100.0
        assert bench.report.after.largest < 0.001


@settings(max_examples=400, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(MUTATIONS)
def test_nc(mutations: list[tuple[float, int, str]]) -> None:
    right_or_refused(mutated(NC, mutations), "nc")


@settings(max_examples=400, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(MUTATIONS)
def test_apt(mutations: list[tuple[float, int, str]]) -> None:
    right_or_refused(mutated(CL, mutations), "apt")


@settings(max_examples=200, deadline=None)
@given(st.binary(max_size=200), st.sampled_from(["nc", "apt"]))
def test_bytes(source: bytes, language: str) -> None:
    right_or_refused(source, language)


WORDS = st.lists(
    st.tuples(
        st.sampled_from(["G0", "G1", "G91 G1", "G90 G1", "G90 G0", ""]),
        st.tuples(*[st.one_of(st.none(), st.integers(-3000, 3000)) for _ in range(3)]),
        st.sampled_from(["", " F100", " M8", " (c)"]),
    ),
    min_size=1,
    max_size=20,
)


@settings(max_examples=150, deadline=None)
@given(WORDS, FEWEST)
def test_straight_programs_mean_the_same_to_an_independent_control(
    blocks: list[tuple[str, tuple[int | None, ...], str]], fewest: int
) -> None:
    """The control reaches with the written program what it would have reached with the source, within a word."""
    lines = ["G90 G21 G0 X0.000 Y0.000 Z0.000"]
    for code, values, rest in blocks:
        words = "".join(f" {axis}{v / 1000:.3f}" for axis, v in zip("XYZ", values, strict=True) if v is not None)
        lines.append((code + words + rest).strip())
    source = "\n".join(lines)
    with tempfile.TemporaryDirectory() as folder, runs_of(fewest):
        bench = Bench(Path(folder))
        text = bench.run(source, MACHINE)
        same = bench.run(source)
    assert same == source.encode()
    wanted, got = execute(source.encode()), execute(text)
    off = MACHINE.actual(got, np.zeros((3, 1))) - MACHINE.ideal(wanted, np.zeros((3, 1)))
    assert np.abs(off).max() <= 0.0005 + 1e-5 + 1e-7  # half a step, and what is too small to be corrected
    still = [line for line in source.splitlines() if not any(axis in strip(line) for axis in "XYZ")]
    assert [line for line in text.decode().splitlines() if line in still] == still
