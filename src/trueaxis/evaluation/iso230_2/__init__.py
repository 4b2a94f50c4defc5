"""Positioning tests of linear axes up to 2000 mm: their files and their evaluation by ISO 230-2:2014."""
