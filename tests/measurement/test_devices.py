"""Devices and sessions of setup.toml: what is read, what is a fault."""

from pathlib import Path

import pytest

from tests.measurement.test_setup import CONTRACT, faults_of, read_text
from trueaxis.measurement.setup import Device

DEVICES = """
[device.L]
serial = "81-H4"
resolution_um = 0.01
noise_um = 0.2
scale_u_ppm = 0.5
[device.B]
length_u_um = 0.4
line_u_urad = 2.0
"""
TEXT = (
    CONTRACT.replace('id = "X1"', 'id = "X1"\ndevice = "L"\nsession = "Monday"').replace(
        'id = "XY-300-cw"', 'id = "XY-300-cw"\ndevice = "B"'
    )
    + DEVICES
)


def test_they_are_read_in_millimetres(tmp_path: Path) -> None:
    laser, bar = read_text(tmp_path, TEXT).runs
    assert laser.device == Device(id="L", serial="81-H4", resolution=1e-5, noise=2e-4, scale_u=5e-7)
    assert laser.session == "Monday"
    assert bar.device == Device(id="B", length_u=4e-4, line_u=2e-6)
    assert bar.session == ""


def test_they_may_be_absent(tmp_path: Path) -> None:
    assert [(run.device, run.session) for run in read_text(tmp_path, CONTRACT).runs] == [(None, "")] * 2
    named = read_text(tmp_path, CONTRACT.replace('id = "X1"', 'id = "X1"\ndevice = "L"'))
    assert named.runs[0].device == Device(id="L")


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("noise_um = 0.2", "noise_um = 0.0", "device.L.noise_um: is 0"),
        ("noise_um = 0.2", "noise_um = 1e9", "is 1e+09"),
        ("noise_um = 0.2", 'noise_um = "low"', "device.L.noise_um"),
        ("noise_um = 0.2", "noise = 0.2", "device.L.noise"),
        ("[device.B]", "[device.C]", "device.C: is the device of no run"),
        ('session = "Monday"', 'session = " Monday"', "session: is"),
        ('device = "L"', "device = 3", "device"),
    ],
)
def test_what_is_wrong_is_named(tmp_path: Path, old: str, new: str, told: str) -> None:
    assert old in TEXT
    found = faults_of(tmp_path, TEXT.replace(old, new, 1))
    assert any(told in one for one in found), found
