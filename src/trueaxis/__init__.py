"""Geometric error models of machine tools: derived symbolically, run numerically."""

__version__ = "0.1.0"
