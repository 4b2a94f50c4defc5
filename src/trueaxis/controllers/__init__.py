"""Tables of error compensation as controls read them, made from error values."""
