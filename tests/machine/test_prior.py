"""Sizes to expect: defaults, what the table [prior] says, its faults, and that no kernel depends on them."""

import pytest

from tests.machine.test_faults import BASE, faults_of
from tests.machines import machine_of
from trueaxis.error_name import ErrorName
from trueaxis.machine.prior import Prior


def test_defaults_are_those_of_the_contract() -> None:
    prior = machine_of(BASE).prior
    assert prior == Prior(translation=0.02, rotation=50e-6, location_angle=100e-6, location_length=1.0)
    assert prior.of_component(ErrorName("EXY")) == 0.02
    assert prior.of_component(ErrorName("ECY")) == 50e-6
    assert prior.of_location("eps_c", "rad") == 100e-6
    assert prior.of_location("d_c", "mm") == 1.0


def test_sizes_are_read_in_their_units() -> None:
    table = "\n[prior]\nrotation_urad = 30\nlocation_um = 250\n[prior.EXY]\num = 5.0\n[prior.eps_c]\nurad = 7\n"
    prior = machine_of(BASE + table).prior
    assert prior.translation == 0.02
    assert prior.rotation == pytest.approx(30e-6)
    assert prior.location_length == pytest.approx(0.25)
    assert prior.of_component(ErrorName("EXY")) == pytest.approx(0.005)
    assert prior.of_location("eps_c", "rad") == pytest.approx(7e-6)


def test_sizes_change_no_kernel() -> None:
    assert machine_of(BASE + "\n[prior]\ntranslation_um = 3.0\n").digest == machine_of(BASE).digest


@pytest.mark.parametrize(
    ("table", "place"),
    [
        ("[prior]\ntranslation_um = 0.0", "key prior.translation_um"),
        ("[prior]\ntranslation_um = -1.0", "key prior.translation_um"),
        ("[prior]\nrotation_urad = nan", "key prior.rotation_urad"),
        ("[prior]\nlocation_um = 1e7", "key prior.location_um"),
        ('[prior]\nlocation_urad = "100"', "key prior.location_urad"),
        ("[prior]\nlocation = 1.0", "key prior.location"),
        ("[prior.EXY]\nurad = 1.0", "key prior.EXY.um"),
        ("[prior.EXX]\num = 1.0", "key prior.EXX"),
        ("prior = 3", "key"),
    ],
)
def test_faults_name_the_key(table: str, place: str) -> None:
    text = f"{table}\n{BASE}" if table.startswith("prior =") else f"{BASE}\n{table}\n"
    assert any(place in fault.place for fault in faults_of(text))
