"""Eqs. (1)-(48), (53)-(56) and Tables 1-7 exactly as the recognised text prints them, slips included."""

from __future__ import annotations

from ..notation import Printed
from .compensation import COMPENSATION
from .linkage_xy import LINKAGE_XY
from .linkage_xz import LINKAGE_XZ
from .linkage_yz import LINKAGE_YZ
from .model import MODEL
from .polynomials import POLYNOMIALS
from .single_axis import SINGLE_AXIS
from .squareness import SQUARENESS_SECTION
from .tables import TABLES

EQUATIONS: tuple[Printed, ...] = (
    *MODEL,
    *SINGLE_AXIS,
    *LINKAGE_XZ,
    *LINKAGE_XY,
    *LINKAGE_YZ,
    *SQUARENESS_SECTION,
    *POLYNOMIALS,
    *COMPENSATION,
)
PRINTED: dict[int | str, Printed] = {item.number: item for item in (*EQUATIONS, *TABLES)}
