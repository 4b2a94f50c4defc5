"""The tables [device.ID] of setup.toml: what is known of the instruments."""

from collections.abc import Mapping, Sequence

from trueaxis.machine.fields import Fields, shown
from trueaxis.measurement.instrument_kinds import ARM, small_unit
from trueaxis.measurement.limits import LONGEST_ID
from trueaxis.measurement.setup import Device, Run

LARGEST_UM = 1e4  # um, a centimetre: no instrument is off by more
LARGEST_PPM = 1e4  # a percent
LARGEST_URAD = 1e4
KEYS = "serial, resolution_um, noise_um, resolution_urad, noise_urad, length_u_um, scale_u_ppm, line_u_urad"
OF_READINGS = ("resolution", "noise")  # keys with a unit of the readings: _um, or _urad of angle instruments


def read_devices(top: Fields) -> dict[str, Device]:
    """ID -> device; complains of what is wrong."""
    table = top.table("device")
    found = {}
    for name in table.raw:
        fields = table.table(name)
        found[name] = Device(
            id=name,
            serial=fields.text("serial", default="") or "",
            resolution=_of_readings(fields, "resolution"),
            noise=_of_readings(fields, "noise"),
            length_u=_size(fields, "length_u_um", 1e-3, LARGEST_UM),
            scale_u=_size(fields, "scale_u_ppm", 1e-6, LARGEST_PPM),
            line_u=_size(fields, "line_u_urad", 1e-6, LARGEST_URAD),
        )
        fields.refuse_others(KEYS)
    return found


def check_devices(top: Fields, devices: Mapping[str, Device], runs: Sequence[Run]) -> None:
    """A device that no run has been read with is a slip of the pen."""
    table = top.table("device")
    used = {run.device.id for run in runs if run.device is not None}
    for name in devices:
        if name not in used:
            table.fault(name, "is the device of no run", f'device = "{name}" in the runs that were read with it')
    for name, units in _units(runs).items():
        if name in devices:
            _check_units(table.table(name), units)


def _units(runs: Sequence[Run]) -> dict[str, set[str]]:
    """ID of each device -> small units of the instruments that name it."""
    found: dict[str, set[str]] = {}
    for run in runs:
        if run.device is not None:
            found.setdefault(run.device.id, set()).add(small_unit(run.instrument))
    return found


def _check_units(fields: Fields, units: set[str]) -> None:
    for quantity in OF_READINGS:
        for unit in ("um", "urad"):
            key, other = f"{quantity}_{unit}", f"{quantity}_{'urad' if unit == 'um' else 'um'}"
            if key in fields.raw and unit not in units:
                fields.fault(key, f"is in {unit}, which no run of this device reads in", other)


def _of_readings(fields: Fields, quantity: str) -> float | None:
    """What is given in um, or of an angle instrument in urad: mm, or mm at ARM; None where it is absent or wrong."""
    length = _size(fields, f"{quantity}_um", 1e-3, LARGEST_UM)
    angle = _size(fields, f"{quantity}_urad", 1e-6 * ARM, LARGEST_URAD)
    if length is not None and angle is not None:
        fields.fault(f"{quantity}_urad", f"is given beside {quantity}_um", "one of them: a device reads one quantity")
    return angle if length is None else length


def check_label(fields: Fields, key: str, label: str) -> None:
    """Complains of a name that cannot be told from others by looking at it, or that is too long."""
    if label and (label != label.strip() or not label.isprintable()):
        fields.fault(key, f"is {shown(label)}", "printable characters with no space before or after them")
    if len(label) > LONGEST_ID:
        fields.fault(key, f"has {len(label)} characters", f"{LONGEST_ID} at most")


def _size(fields: Fields, key: str, unit: float, largest: float) -> float | None:
    """A number above 0, in mm or 1; None where it is absent or wrong."""
    if key not in fields.raw:
        fields.known.add(key)
        return None
    right = f"a number above 0, at most {largest:g}"
    value = fields.number(key, right)
    if value is not None and not 0.0 < value <= largest:
        fields.fault(key, f"is {value:g}", right)
        return None
    return None if value is None else value * unit
