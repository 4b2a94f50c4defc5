"""What effects depend on besides positions: how the axes came there and moved, and when, at what temperature."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from trueaxis.effects.placement import FARTHEST, REFERENCE_TEMPERATURE

FloatArray = npt.NDArray[np.float64]
Rows = npt.NDArray[np.int64] | npt.NDArray[np.bool_] | slice


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Context:
    """The context of n commanded positions; NaN where something is not known.

    directions: (n_axes, n), direction by which each axis came: +1, -1, 0 before it has moved; velocity: (n_axes, n),
    mm/s or deg/s; since_reversal: (n_axes, n), distance since the last reversal of each axis, mm or deg, infinite
    before the first; time_since: (n_axes, n), time since it, s; path_since: (n_axes, n), way along the path of all
    linear axes since it, mm; time: (n,), s; temperature: (n,), degC. home: context of the position where each reading
    was zeroed, n as well;
    None where nothing was zeroed.
    """

    directions: FloatArray
    velocity: FloatArray
    since_reversal: FloatArray
    time_since: FloatArray
    path_since: FloatArray
    time: FloatArray
    temperature: FloatArray
    home: "Context | None" = None

    @classmethod
    def at_rest(
        cls, axes: int, count: int, time: FloatArray | None = None, temperature: FloatArray | None = None
    ) -> "Context":
        """Axes that stand and have not moved yet: direction 0, velocity 0, no reversal.

        time, temperature: (count,); by default 0 and the reference temperature of 20 degC.
        """
        still, never = np.zeros((axes, count)), np.full((axes, count), np.inf)
        return cls(
            directions=still,
            velocity=still,
            since_reversal=never,
            time_since=never,
            path_since=never,
            time=np.zeros(count) if time is None else time,
            temperature=np.full(count, REFERENCE_TEMPERATURE) if temperature is None else temperature,
        )

    @property
    def count(self) -> int:
        """n, the number of positions."""
        return len(self.time)

    def since(self, variable: str) -> FloatArray:
        """(n_axes, n): what one of d, d_time, d_path counts since the last reversal of each axis."""
        return {"d": self.since_reversal, "d_time": self.time_since, "d_path": self.path_since}[variable]

    def of(self, rows: Rows) -> "Context":
        """The context of some of the positions: indices, a mask or a slice."""
        return Context(
            directions=np.ascontiguousarray(self.directions[:, rows]),
            velocity=np.ascontiguousarray(self.velocity[:, rows]),
            since_reversal=np.ascontiguousarray(self.since_reversal[:, rows]),
            time_since=np.ascontiguousarray(self.time_since[:, rows]),
            path_since=np.ascontiguousarray(self.path_since[:, rows]),
            time=self.time[rows],
            temperature=self.temperature[rows],
            home=None if self.home is None else self.home.of(rows),
        )

    def filled(self) -> "Context":
        """With nothing unknown or infinite: where no effect is felt, what effects depend on may be lacking."""
        return Context(
            directions=self.directions,
            velocity=np.nan_to_num(self.velocity, nan=0.0),
            since_reversal=np.minimum(self.since_reversal, FARTHEST),
            time_since=np.nan_to_num(np.minimum(self.time_since, FARTHEST), nan=FARTHEST),
            path_since=np.minimum(self.path_since, FARTHEST),
            time=np.nan_to_num(self.time, nan=0.0),
            temperature=np.nan_to_num(self.temperature, nan=REFERENCE_TEMPERATURE),
            home=None if self.home is None else self.home.filled(),
        )


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class ReadingContext:
    """What effects on the readings of an instrument depend on, (n,) each; NaN where something is not known.

    along: ideal displacement that laser or probe sense, since home, mm; theta: polar angle of a ball bar in the plane
    of its circle, rad; way: ideal way of laser or probe along the line of the motion, since home, mm; time: s;
    temperature: degC.
    """

    along: FloatArray
    theta: FloatArray
    way: FloatArray
    time: FloatArray
    temperature: FloatArray

    def of(self, rows: Rows) -> "ReadingContext":
        """The context of some of the readings: indices, a mask or a slice."""
        return ReadingContext(
            along=self.along[rows],
            theta=self.theta[rows],
            way=self.way[rows],
            time=self.time[rows],
            temperature=self.temperature[rows],
        )
