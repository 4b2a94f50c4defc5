"""What is at hand for further runs: instruments, bars, where they sit on the tool."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.measurement.instrument_kinds import Instrument
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import Device, Vector
from trueaxis.planning.paths import places

LENGTHS = (150.0, 300.0)  # mm: of ball bars, where the plan has none (ISO 230-4 tests use such)


@dataclass(frozen=True, slots=True, kw_only=True)
class Kit:
    """What is at hand. tools: points in the tool frame at which optics, balls and styli sit, mm, but for instruments
    that have points of their own, `points`; lengths: of ball bars, mm; devices: of instruments, and whether they read
    straightness, where they are known; session: of the new runs; everywhere: whether circles and turns are wanted at
    all places of the travels, or in the middle alone.
    """

    instruments: tuple[Instrument, ...]
    tools: tuple[Vector, ...] = ((0.0, 0.0, 0.0),)
    points: Mapping[str, tuple[Vector, ...]] = field(default_factory=dict)
    lengths: tuple[float, ...] = LENGTHS
    devices: Mapping[tuple[str, bool], Device] = field(default_factory=dict)
    session: str = ""
    everywhere: bool = True

    def on_tool(self, instrument: Instrument) -> tuple[Vector, ...]:
        """Where it sits on the tool."""
        return self.points.get(instrument, self.tools)

    def device_of(self, instrument: str, *, straightness: bool = False) -> Device | None:
        """That which reads such runs; else the only one there is: a laser head may have other optics."""
        return self.devices.get((instrument, straightness), self.devices.get((instrument, not straightness)))

    def places(self, machine: IdentifiedMachine) -> list[FloatArray]:
        """(n_axes, 1) each, at which circles and turns are."""
        return places(machine)[: None if self.everywhere else 1]
