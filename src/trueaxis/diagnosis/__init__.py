"""Diagnose: where simulation and measurement differ beyond noise, why, and what an extended model gains."""
