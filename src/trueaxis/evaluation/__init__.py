"""Standard figures of tests: ISO 230-2, ISO 230-4 and ISO 230-6."""
