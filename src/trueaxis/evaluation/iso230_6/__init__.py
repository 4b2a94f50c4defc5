"""Diagonal displacement tests (ISO 230-6): positioning along the diagonals of the volume or of a face."""
