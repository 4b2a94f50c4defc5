"""Reads NC programs (ISO 6983-1, RS-274; SINUMERIK): lines of text -> items, see reader."""
