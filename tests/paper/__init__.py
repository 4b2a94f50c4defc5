"""The paper's equations and tables as printed, what follows from its own chain, and the errata between them."""
