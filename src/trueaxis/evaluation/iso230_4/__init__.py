"""Circular tests by ISO 230-4, and the errors that make up their deviations."""
