"""Lengths of probes: location errors that follow one which nobody has stated, and those that are not what is stated."""

from dataclasses import dataclass

from trueaxis.estimation.doubted_lengths import DoubtedLength
from trueaxis.estimation.instruments import CLASSES, PROBE_LENGTH
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.identification.words import in_digits, some_of

# mm per mm, from which on a location error is said to follow the length: other readings tell the smaller part of it
FOLLOWS = 0.5
# times what a length is usually known to: 0.2 mm. A stylus is not as far off, a wrong number may be
FAR_LENGTH = 10.0


@dataclass(frozen=True, slots=True, kw_only=True)
class RestsOnLength:
    """location: follows the length of the probe of the runs, by id; value, mm; longer: by how much the probe would have
    to be longer than setup.toml says for a location error of zero, mm.
    """

    location: str
    runs: tuple[str, ...]
    value: float
    longer: float

    @property
    def far(self) -> bool:
        """Whether one of them is a wrong number: the location error, or the length in the set-up."""
        return abs(self.longer) > FAR_LENGTH * CLASSES[PROBE_LENGTH].size

    def __str__(self) -> str:
        named = self.runs[0] if len(self.runs) == 1 else f"{self.runs[0]} and {len(self.runs) - 1} more"
        than = f"{abs(self.longer) * 1e3:.4g} um {'longer' if self.longer > 0.0 else 'shorter'}"
        usual = CLASSES[PROBE_LENGTH].size * 1e3
        return (
            f"{self.location} ({self.value * 1e3:.4g} um) and the length of the probe of {named} look the same to the "
            f"readings: with a probe {than} than setup.toml says it would be 0. The length is taken as known to "
            f"{usual:g} um, since no [device] table states length_u_um: state how well it is known, or measure circles "
            "by ball bar while the rotary axis turns"
        )


def resting_on_length(observed: Observations, found: Estimate) -> tuple[RestsOnLength, ...]:
    """Of each location error that follows one, of all runs whose probe it follows; the largest first."""
    layout = found.layout
    first = int(layout.offsets[-1])
    each: dict[str, RestsOnLength] = {}
    for place, one in enumerate(layout.shared):
        if one.kind != PROBE_LENGTH:
            continue
        length = found.spread[layout.of_shared][place]
        for row, name in enumerate(layout.locations, first):
            follows = float(found.spread[row] @ length) / max(float(length @ length), 1e-300)
            if layout.model.machine.parameter_unit(name) == "mm" and abs(follows) >= FOLLOWS:
                value = float(found.unknowns[row])
                runs = tuple(observed.runs[index].id for index in one.runs)
                if name in each:
                    runs = (*each[name].runs, *runs)
                each[name] = RestsOnLength(location=name, runs=runs, value=value, longer=-value / follows)
    return tuple(sorted(each.values(), key=lambda one: -abs(one.longer)))


def doubted(observed: Observations, one: DoubtedLength) -> str:
    """That a probe is not as long as it is stated."""
    first = observed.runs[one.runs[0]]
    named = some_of([observed.runs[index].id for index in one.runs])
    off = "longer" if one.longer > 0.0 else "shorter"
    than = f"{in_digits(abs(one.longer) * 1e3)} um (u {in_digits(one.u * 1e3)}) {off} than setup.toml says"
    said, remedy = "its length is taken as known to", "Else correct it"
    if first.device is not None and first.device.length_u is not None:
        said = f"[device.{first.device.id}] states its length to"
        remedy = "Else correct length_u_um, or leave it out"
    return (
        f"{named}: the readings are of a probe {than}, where {said} {one.known * 1e3:g} um: errors of the rotary axes "
        f"have taken up the rest (is the z of the point on the tool right? {remedy}: "
        "lengths are then found from the readings)"
    )
