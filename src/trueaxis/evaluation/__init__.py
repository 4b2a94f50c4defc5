"""Standard tests, their figures and reports: positioning (ISO 230-2), circular (ISO 230-4), diagonal (ISO 230-6)."""
