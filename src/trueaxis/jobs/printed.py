"""Results that are reports, as notebooks show them."""

from html import escape


class Printed:
    """What has a report as its text: notebooks show it as it is printed."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        return f"<pre>{escape(str(self))}</pre>"
