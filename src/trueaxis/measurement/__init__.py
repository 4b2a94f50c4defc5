"""Measured data: what was set up, what was read, and what a machine model expects to be read."""
