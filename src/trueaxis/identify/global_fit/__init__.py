"""Identification from all readings at once: weighted least squares on polynomial coefficients."""
