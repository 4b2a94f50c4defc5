"""A figure that was drawn, as the page takes it: whoever puts the page together need not be able to draw."""

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Picture:
    """A figure of the page: name (for its ids), title, text for those who do not see it, caption, the svg element."""

    name: str
    title: str
    alt: str
    caption: str
    svg: str


@dataclass(frozen=True, slots=True)
class Pictures:
    """causes: those of each cause, in order; sections: by the name of the section."""

    causes: tuple[tuple[Picture, ...], ...]
    sections: Mapping[str, tuple[Picture, ...]]
