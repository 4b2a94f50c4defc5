"""NC programs that undo a machine's geometric errors (Sect. 5 of the paper)."""
