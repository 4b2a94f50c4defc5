"""The columns of a table that draws add for each point."""

from trueaxis.model.curves import FloatArray
from trueaxis.monte_carlo.drawn import Drawn

QUANTITIES = ("dx", "dy", "dz", "length")
STATISTICS = ("mean", "sd", "low", "high")


def drawn_columns(drawn: Drawn) -> list[tuple[tuple[str, ...], FloatArray]]:
    """Names and values (4, n), mm, of means, standard deviations, 2.5 % and 97.5 %: of dx, dy, dz and the length."""
    values = (drawn.mean, drawn.sd, drawn.low, drawn.high)
    return [
        (tuple(f"{statistic}_{quantity}" for quantity in QUANTITIES), rows)
        for statistic, rows in zip(STATISTICS, values, strict=True)
    ]
