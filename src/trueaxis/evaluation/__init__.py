"""Standard figures of tests: ISO 230-2 and ISO 230-4."""
