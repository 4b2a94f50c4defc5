"""A plain control: reads G0/G1 programs as written by compensation, independently of the package's readers."""

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tests.compensation.analytic_machine import XyzMachine
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.report import CompensationReport
from trueaxis.compensation.settings import Language, Settings
from trueaxis.reporting.compensation import compensation_text

FloatArray = NDArray[np.float64]


def strip(line: str) -> str:
    return re.sub(r"\([^()]*\)|;.*", "", line).strip()


def execute(program: bytes, axes: Sequence[str] = "XYZ", start: Sequence[float] | None = None) -> FloatArray:
    """Positions (n_axes, n) after every block that moves, mm and deg; fails on anything but straight motions."""
    at = dict(zip(axes, start or [0.0] * len(axes), strict=True))
    absolute, unit = True, 1.0
    found = []
    percents = 0
    for line in program.decode("latin-1").splitlines():
        text = strip(line).lstrip("/")
        percents += text.startswith("%")
        if percents == 2:
            break
        if not text or text[0] in "%O:":
            continue
        words = re.findall(r"([A-Z])\s*([-+]?[\d.]+)", text)
        codes = [float(value) for letter, value in words if letter == "G"]
        assert not set(codes) & {2.0, 3.0}, line
        if 4.0 in codes:
            continue
        for code in codes:
            absolute = {90.0: True, 91.0: False}.get(code, absolute)
            unit = {20.0: 25.4, 21.0: 1.0}.get(code, unit)
        moved = [(letter, float(value)) for letter, value in words if letter in at]
        for letter, value in moved:
            size = value * (unit if letter in "XYZ" else 1.0)
            at[letter] = size if absolute else at[letter] + size
        if moved:
            found.append([at[axis] for axis in axes])
        if {2.0, 30.0} & {float(value) for letter, value in words if letter == "M"}:
            break
    return np.array(found).T.reshape(len(axes), -1)


class Bench:
    """A machine, a folder and a way to run a program through compensation."""

    def __init__(self, folder: Path) -> None:
        self.program = folder / "in.nc"
        self.out = folder / "out.nc"

    def run(
        self,
        text: str | bytes,
        machine: object | None = None,
        language: Language | None = "nc",
        **settings: object,
    ) -> bytes:
        self.program.write_bytes(text if isinstance(text, bytes) else text.encode("latin-1"))
        self.report: CompensationReport = compensate_file(
            self.program,
            self.out,
            XyzMachine() if machine is None else machine,  # type: ignore[arg-type]
            Settings(**({"arcs": "chords"} | settings)),  # type: ignore[arg-type]  # `execute` knows lines alone
            language=language,
            name="in.nc",
        )
        return without_mark(self.out.read_bytes())

    @property
    def told(self) -> str:
        """The report, as people read it."""
        return compensation_text(self.report)


def without_mark(written: bytes) -> bytes:
    """A written program without the line of its mark, which must be there once where there is anything but a head."""
    found = re.findall(rb"(?m)(?:^|(?<=\xef\xbb\xbf))(?:\(TRUEAXIS COMPENSATED\)|; TRUEAXIS COMPENSATED)\r*\n", written)
    head = re.fullmatch(rb"(?:\xef\xbb\xbf)?(?:[ \t]*(?:%[^\r\n]*|[Oo:]\s*\d[^\r\n]*)?\r*\n)*", written + b"\n")
    assert len(found) == 1 or (head and not found), written[:300]
    return written.replace(found[0], b"", 1) if found else written
