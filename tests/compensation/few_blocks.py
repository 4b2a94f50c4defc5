"""Blocks are read in runs where there are enough of them; here, in runs of as few as are asked for."""

from collections.abc import Iterator
from contextlib import contextmanager
from unittest.mock import patch

from hypothesis import strategies as st

from trueaxis.compensation.nc import runs as nc_runs

FEWEST = st.sampled_from([1, nc_runs.FEWEST])


@contextmanager
def runs_of(fewest: int) -> Iterator[None]:
    """Runs have no fewer blocks, or holes, than these."""
    with patch.object(nc_runs, "FEWEST", fewest), patch.object(nc_runs, "FEWEST_HOLES", fewest):
        yield
