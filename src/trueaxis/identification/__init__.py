"""Identification: from measured data to error values, their uncertainty, and what the data cannot determine."""
