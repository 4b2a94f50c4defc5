"""What sizes of errors are to be expected before anything is measured: the table [prior] of a machine spec."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from trueaxis.error_name import ErrorName
from trueaxis.machine.fields import Fields

SIZES = {"translation_um": 20.0, "rotation_urad": 50.0, "location_urad": 100.0, "location_um": 1000.0}
LARGEST_SIZE = 1e6  # um, urad: a metre, a radian


@dataclass(frozen=True, slots=True, kw_only=True)
class Prior:
    """Sizes to expect, one standard deviation each.

    translation: of a translational component error over its travel, mm; rotation: of a rotational one, rad;
    location_angle: of a squareness or parallelism, rad; location_length: of an offset of a rotary axis, mm;
    named: (name, size) of component errors and location errors of which more is known, mm or rad.
    """

    translation: float = SIZES["translation_um"] / 1e3
    rotation: float = SIZES["rotation_urad"] / 1e6
    location_angle: float = SIZES["location_urad"] / 1e6
    location_length: float = SIZES["location_um"] / 1e3
    named: tuple[tuple[str, float], ...] = ()

    def of_component(self, component: ErrorName) -> float:
        """Size of a component error such as EXY, mm or rad."""
        return dict(self.named).get(component, self.rotation if component.is_rotation else self.translation)

    def of_location(self, name: str, unit: str) -> float:
        """Size of the location error `name`, whose unit is `mm` or `rad`."""
        return dict(self.named).get(name, self.location_length if unit == "mm" else self.location_angle)


def read_prior(top: Fields, components: Sequence[ErrorName], locations: Mapping[str, str]) -> Prior:
    """The table [prior] of a spec, defaults where it is silent.

    components: motion-error components of the machine; locations: its location errors with their units.
    """
    fields = top.table("prior")
    units: dict[str, str] = {name: name.unit for name in components}
    units |= locations
    sizes = {key: _size(fields, key, default) for key, default in SIZES.items()}
    named = []
    for name in [name for name in units if name in fields.raw]:
        table = fields.table(name)
        key, units_of_size = ("um", 1e3) if units[name] == "mm" else ("urad", 1e6)
        named.append((name, _size(table, key, None) / units_of_size))
        table.refuse_others(key)
    fields.refuse_others(f"{', '.join(SIZES)}, or a table of a component or location error: {', '.join(units)}")
    return Prior(
        translation=sizes["translation_um"] / 1e3,
        rotation=sizes["rotation_urad"] / 1e6,
        location_angle=sizes["location_urad"] / 1e6,
        location_length=sizes["location_um"] / 1e3,
        named=tuple(named),
    )


def _size(fields: Fields, key: str, default: float | None) -> float:
    """The size under a key; `default` where it is absent, required where there is none; 1 after a complaint."""
    if key not in fields.raw and default is not None:
        fields.known.add(key)
        return default
    right = f"a number above 0, at most {LARGEST_SIZE:g}"
    value = fields.number(key, right)
    if value is None or not 0.0 < value <= LARGEST_SIZE:
        if value is not None:
            fields.fault(key, f"is {value:g}", right)
        return 1.0
    return value
