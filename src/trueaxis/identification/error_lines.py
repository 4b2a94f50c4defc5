"""Lines of the identification report on component and location errors."""

from trueaxis.error_name import ErrorName
from trueaxis.identification.report import ComponentReport, LocationReport
from trueaxis.identification.usual_sizes import LargerU
from trueaxis.identification.words import parts_of_u
from trueaxis.io.safe_text import plain_zero

MICRO = 1e6
KNOWN_WIDTH, U_WIDTH = 22, 9


def location_line(location: LocationReport) -> str:
    """`EC0X  determined by readings  +55 urad  u 4.16 (readings 2.75, prior 3.12, of 100 urad)`; without a prior the
    value alone where it is open.
    """
    value, unit = small_size(location.value, location.unit)
    parts = ""
    if location.u_readings is not None and location.u_prior is not None and location.prior is not None:
        parts = f" ({parts_of_u(location.u_readings, location.u_prior, location.prior, location.unit)})"
    line = f"  {location.name:<10} {location.origin:<{KNOWN_WIDTH}} {value:+10.4g} {unit:<5}"
    return f"{line} {with_u(location.u, location.unit)}{parts}".rstrip()


def component_line(one: ComponentReport) -> str:
    """`EYZ  determined by readings  31.8 um at Z-456, u 3.08; largest u 18.1 (readings 3.1, prior 2.5, of 44 um)`."""
    known = f"{one.origin:<{KNOWN_WIDTH}}" if one.origin else f"{one.known:<13}"
    if one.known in ("not measured", "given"):
        return f"  {one.name:<4} {known}".rstrip()
    value, unit = small_size(one.largest, one.unit)
    if one.at is None:
        line = f"largest value {value:10.4g} {unit:<5} largest {with_u(one.u, one.unit)}".removesuffix(
            "largest"
        ).rstrip()
        return f"  {one.name:<4} {known} {line}".rstrip()
    at = f"at {ErrorName(one.name).axis}{one.at:.4g},"
    there = "u not known" if one.u_there is None else f"u {small_size(one.u_there, one.unit)[0]:.3g}"
    line = f"{value:9.4g} {unit:<4} {at:<11} {there + ';':<11}"
    if one.u is not None:
        line += f" largest {with_u(one.u, one.unit)} {unit:<4}"
    if one.u_readings_rms is not None and one.u_prior_rms is not None and one.prior_rms is not None:
        line += f" ({parts_of_u(one.u_readings_rms, one.u_prior_rms, one.prior_rms, one.unit)})"
    return f"  {one.name:<4} {known} {line}".rstrip().removesuffix(";")


def with_u(u: float | None, unit: str) -> str:
    """`u 3.42`, of one width; blank where u is not known."""
    return f"u {small_size(u, unit)[0]:{U_WIDTH}.3g}" if u is not None else " " * (U_WIDTH + 2)


def small_size(value: float, unit: str) -> tuple[float, str]:
    """In micrometres, microradians or parts per million."""
    if unit == "1":
        return plain_zero(value * MICRO), "ppm"
    return (plain_zero(value * 1e3), "um") if unit == "mm" else (plain_zero(value * MICRO), "urad")


def by_usual_sizes(one: LargerU | None) -> str:
    """`; by the usual sizes u 45.4`, where it is far larger."""
    return "" if one is None else f"; by the usual sizes u {small_size(one.u_usual, one.unit)[0]:.3g}"
