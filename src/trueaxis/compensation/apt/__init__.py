"""Reads APT cutter location files: lines of text -> items, see reader."""
