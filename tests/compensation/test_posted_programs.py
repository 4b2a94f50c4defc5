"""Whole programs as post-processors of shops emit them for SINUMERIK and Heidenhain controls: right along the path.

They are written by the manuals' syntax, with what such programs have around their motions: heads, blanks, messages,
several tools, work offsets, shifts, tolerances. Source and result are run by controls apart from the package.
"""

from pathlib import Path

import numpy as np
import pytest

from tests.compensation.analytic_machine import paper_sized
from tests.compensation.klartext_control import KlartextControl
from tests.compensation.path_distance import apart, sampled
from tests.compensation.siemens_control import SiemensControl
from tests.compensation.test_klartext import PRESET
from tests.compensation.test_siemens import FRAMES
from trueaxis.compensation.files import compensate_file
from trueaxis.compensation.offsets import Offsets
from trueaxis.compensation.settings import Settings
from trueaxis.compensation.tools import Tool, ToolTable
from trueaxis.reporting.compensation import compensation_text

MACHINE = paper_sized()
LENGTHS = {1: 60.0, 3: 112.35, 5: 81.5, 12: 143.0}
TOOLS = ToolTable({tool: Tool(length=length) for tool, length in LENGTHS.items()})
OFFSETS = Offsets(
    {f"G{n}": {axis: (v, v) for axis, v in zip("XYZ", values, strict=True)} for n, values in FRAMES.items()}, {}, "G54"
)
ALONG = 0.0015  # mm: half a word in each axis, and the height of a chord

PLATE = """\
%_N_PLATE_20_MPF
;$PATH=/_N_WKS_DIR/_N_PLATE_WPD
; ROUGH AND FINISH A POCKET, DRILL BY G1
N10 G17 G71 G90 G94 G40 G60
N20 DYNROUGH SOFT FFWON
N30 WORKPIECE(,"",,"BOX",48,0,-20,-80,0,0,120,90)
N40 SUPA G0 Z500 D0
N50 T5
N60 M6
N70 MSG("END MILL 10")
N80 G54 D1
N90 S6000 M3
N100 G0 X20 Y15 M8
N110 Z5
N120 G64
N130 CYCLE832(0.01,_ROUGH,1)
N140 G1 Z-2 F300
N150 G1 X100 F1200
N160 G3 X105 Y20 CR=5
N170 G1 Y70
N180 G3 X100 Y75 I-5 J0
N190 G1 X20
N200 G3 X15 Y70 CR=5
N210 G1 Y20
N220 G3 X20 Y15 I=AC(20) J=AC(20)
N230 G0 Z50 M9
N240 CYCLE832()
N250 SUPA G0 Z500 D0
N260 T3
N270 M6
N280 MSG("DRILL 6.8")
N290 D1 S2500 M3
N300 G0 X30 Y30 M8
N310 Z3
N320 G1 Z-18 F180
N330 G0 Z3
N340 X90 Y60
N350 G1 Z-18
N360 G0 Z3
N370 M5 M9
N380 SUPA G0 Z500 D0
N390 M30
"""
ROWS = """\
%_N_ROWS_MPF
N1 G17 G710 G90 G94 G500
N2 T12 M6
N3 D1
N4 G55
N5 S4500 M03
N6 DYNFINISH
N7 G642
N8 TRANS X=12.5 Y=8
N9 G0 X0 Y0
N10 Z2
FIRST: G1 Z=-0.35 F=250
N12 G91 X=4 F=900
N13 G2 X=6 Y=-6 I=0 J=-6
N14 G1 Y=-3.25
N15 X=-2.5 Y=1.125
N16 G90
N17 G0 Z2
N18 MSG ("SECOND ROW")
N19 ATRANS X30
N20 G0 X0 Y0
N21 G1 Z=-0.35 F=250
N22 G2 X=IC(14) Y=IC(0) CR=-9 F=700
N23 G1 X=AC(2.2) Y=IC(-5.05)
N24 G3 X2.2 Y-5.05 Z-0.85 I3 J0
N25 G1 Z2
N26 TRANS
N27 G153 G0 Z450 D0
N28 M2
"""
INCHES = """\
%_N_BRACKET_MPF
; BRACKET, INCH
N010 G70 G17 G40 G90 G60
N020 T1 M6
N030 G54 D1
N040 S8000 M3
N050 G0 X.5 Y-.25
N060 Z.1 M8
N070 G641 ADIS=.001
N080 G1 Z-.0625 F12
N090 X2.75 F40
N100 G3 X3. Y0. I0. J.25
N110 G1 Y1.5
N120 G3 X2.75 Y1.75 CR=.25
N130 G1 X.5
N140 G3 X.25 Y1.5 I0. J-.25
N150 G1 Y0.
N160 G3 X.5 Y-.25 CR=.25
N170 G1 X.75
N180 G0 Z1. M9
N190 G71
N200 G1 X40. Y-10. F1500
N210 X75.5 Y12.25 Z20.
N220 SUPA G0 Z400. D0
N230 M30
"""
HOUSING = """\
0  BEGIN PGM HOUSING MM
1  ;CAM OUTPUT, 3 AXES
2  BLK FORM 0.1 Z  X+0  Y+0  Z-25
3  BLK FORM 0.2  X+150  Y+100  Z+0
4  CYCL DEF 247 DATUM SETTING ~
    Q339=+1    ;DATUM NUMBER
5  * - FACE MILL 50
6  TOOL CALL 12 Z S1800 F900
7  M3
8  L  X-30  Y+20 R0 FMAX
9  L  Z+50 R0 FMAX M8
10 L  Z+0 F500
11 L  X+180 F AUTO
12 L  Y+60
13 L  X-30
14 L  Z+100 R0 FMAX M9
15 * - END MILL 10
16 TOOL CALL 5 Z S6500
17 M3
18 CYCL DEF 32.0 TOLERANCE
19 CYCL DEF 32.1 T0.01
20 CYCL DEF 32.2 HSC-MODE:0
21 L  X+25  Y+30 R0 FMAX
22 L  Z+2 R0 FMAX M8
23 L  Z-5 F300
24 L  X+110 F1500
25 CC X+110  Y+45
26 C  X+125  Y+45 DR+
27 L  Y+70
28 CR X+110  Y+85 R+15 DR+
29 L  X+25
30 CC X+25  Y+70
31 CP PA+180 DR+
32 L  Y+45
33 CR X+25  Y+30 R+15 DR+
34 L  Z+100 R0 FMAX M9
35 L  Z-1 R0 FMAX M91
36 M30
37 END PGM HOUSING MM
"""
THREADS = """\
0 BEGIN PGM BORES MM
1 BLK FORM 0.1 Z X-60 Y-60 Z-30
2 BLK FORM 0.2 X+60 Y+60 Z+0
3 TOOL CALL 3 Z S4200 DL+0
4 L Z+100 R0 FMAX M3
5 TRANS DATUM AXIS X+40 Y+25
6 CC X+0 Y+0
7 L X+0 Y+0 R0 FMAX
8 L Z+2 FMAX
9 L Z-12 F200
10 LP PR+7.25 PA+0 F350
11 CP IPA+1440 IZ+6 DR+
12 L X+0 Y+0
13 L Z+50 FMAX
14 TRANS DATUM AXIS X-32.5 Y+18.75
15 L X+0 Y+0 FMAX
16 CC X+0 Y+0
17 L Z+2 FMAX
18 L Z-4 F200
19 LP PR+11 PA+90
20 CP PA-150 DR- F500
21 L IX+2.5 IY-1.25
22 L IX-2.5 IZ+1 M9
23 TRANS DATUM RESET
24 L Z+150 FMAX
25 M30
26 END PGM BORES MM
"""
SURFACE = ["0 BEGIN PGM SURF INCH", "1 TOOL CALL 1 Z S12000", "2 L X+0 Y+0 FMAX M3", "3 L Z+.5 FMAX", "4 L Z+.05 F30"]
SURFACE += [
    f"{5 + 12 * row + column} L X{(0.2 * column if row % 2 else 2.2 - 0.2 * column):+.4f} Y{0.1 * row:+.4f} "
    f"Z{0.02 * np.sin(column + row):+.5f}" + (" F80" if row == column == 0 else "")
    for row in range(6)
    for column in range(12)
]
SURFACE += ["77 L Z+1 FMAX M5", "78 L Z+10 FMAX M91", "79 M30", "80 END PGM SURF INCH", ""]


def errors(source: SiemensControl | KlartextControl, written: SiemensControl | KlartextControl) -> tuple[float, float]:
    """Largest distance from the path that is meant, with the machine's errors: as programmed, as written."""
    assert source.tips == written.tips
    assert len(source.rapids) == len(written.rapids)
    before = after = 0.0
    for tip, meant, done in zip(source.tips, source.paths(), written.paths(), strict=True):
        point = np.array([[0.0], [0.0], [-tip]])
        a, b = sampled(meant, 0.3), sampled(done, 0.3)
        path = MACHINE.ideal(a, point)
        before = max(before, apart(MACHINE.actual(a, point), path))
        after = max(after, apart(MACHINE.actual(b, point), path))
    return before, after


def written_of(folder: Path, name: str, text: str) -> str:
    source, out = folder / name, folder / "out"
    source.write_text(text)
    report = compensate_file(source, out, MACHINE, Settings(offsets=OFFSETS, tools=TOOLS, integers="mm"), name=name)
    assert report.good, compensation_text(report)
    return out.read_text()


@pytest.mark.parametrize("text", [PLATE, ROWS, INCHES], ids=["plate", "rows", "inches"])
def test_sinumerik(tmp_path: Path, text: str) -> None:
    written = written_of(tmp_path, "in.mpf", text)
    before, after = errors(*(SiemensControl([0.0, 0.0, 450.0], FRAMES, LENGTHS).run(one) for one in (text, written)))
    assert after < ALONG < 0.008 < before


@pytest.mark.parametrize("text", [HOUSING, THREADS, "\n".join(SURFACE)], ids=["housing", "threads", "surface"])
def test_heidenhain(tmp_path: Path, text: str) -> None:
    written = written_of(tmp_path, "in.h", text)
    before, after = errors(*(KlartextControl([0.0, 0.0, 450.0], PRESET, LENGTHS).run(one) for one in (text, written)))
    assert after < ALONG < 0.008 < before
