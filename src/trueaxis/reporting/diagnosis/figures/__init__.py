"""The figures of the report, one module each: a diagnosis goes in, pictures as inline SVG come out."""

import trueaxis.reporting.pictures  # noqa: F401  Matplotlib is loaded there, away from the data, before any figure needs it
