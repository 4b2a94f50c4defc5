"""The worked numbers of docs/controllers are what the formats write."""

import re

import numpy as np
import pytest

from tests.controllers.machines import GANTRY, model_of
from tests.machines import ROOT
from trueaxis.controllers.formats import FORMATS, TABLED, Layout, export_tables
from trueaxis.controllers.linuxcnc import FILE_TYPES
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.errors import ErrorValues

FOLDER = ROOT / "docs" / "controllers"
PAGES = {name: FOLDER / f"{'siemens' if name.startswith('siemens') else name}.md" for name in FORMATS}
PARTS = ("Source", "Sign", "What it holds|What they hold", "Limits", "Load", "Verify", "Take off")


@pytest.mark.parametrize("name", TABLED)
def test_the_number_beside_the_sign(name: str) -> None:
    curves = {"EXX": PolynomialCurve(powers=(1,), coefficients=(1e-4,))}
    if name != "isg-csv":
        curves["EYX"] = PolynomialCurve(powers=(1,), coefficients=(-4e-5,))
    model = model_of(GANTRY, ErrorValues(machine="gantry", motion_errors=curves))
    layouts = [Layout(file_type=kind) for kind in (FILE_TYPES if name == "linuxcnc-comp" else FILE_TYPES[:1])]
    made = [export_tables(name, model, np.zeros((3, 1)), 50.0, np.zeros((3, 1)), layout).files for layout in layouts]
    written = {" ".join(line.split()) for files in made for text in files.values() for line in text.splitlines()}
    blocks = re.findall(r"\n```\n(.*?)```", PAGES[name].read_text(), re.DOTALL)
    of_format = [block for block in blocks if name != "siemens-enc" or "ENC" in block]
    of_format = [block for block in of_format if name != "siemens-cec" or "CEC" in block]
    assert of_format
    for line in "".join(of_format).strip().splitlines():
        assert " ".join(line.split()) in written


@pytest.mark.parametrize("name", FORMATS)
def test_every_page_says_what_a_user_needs(name: str) -> None:
    text = PAGES[name].read_text()
    for part in PARTS:
        assert re.search(rf"^\*\*({part})\.\*\*", text, re.MULTILINE), f"{PAGES[name].name} has no {part}"
    assert f"`{name}`" in (FOLDER / "README.md").read_text()
