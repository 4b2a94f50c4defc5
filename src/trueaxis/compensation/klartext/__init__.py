"""Reads Heidenhain Klartext programs: lines of text -> items, see reader."""
