"""What results have in common: a report that notebooks show, and tables, as frames of Polars and of pandas."""

from abc import ABC, abstractmethod
from html import escape
from typing import Any

import polars as pl


class Printed:
    """What has a report as its text: notebooks show it as it is printed."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        return f"<pre>{escape(str(self))}</pre>"


class Tabular(ABC):
    """What has `to_polars` has `to_pandas`, too."""

    __slots__ = ()

    @abstractmethod
    def to_polars(self) -> pl.DataFrame:
        """The result as a table."""

    def to_pandas(self) -> Any:
        """The same as a pandas.DataFrame. Raises ModuleNotFoundError where pandas is not installed."""
        try:
            import pandas as pd  # noqa: PLC0415  half a second; only who asks for it needs it
        except ModuleNotFoundError:
            remedy = "pip install 'trueaxis[pandas]'"
            raise ModuleNotFoundError(f"to_pandas needs the package pandas: {remedy}", name="pandas") from None
        # column by column: Polars' own way asks for pyarrow, 40 MB and more, as well
        return pd.DataFrame({column.name: column.to_numpy() for column in self.to_polars()})
