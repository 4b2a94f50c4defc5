"""How a machine's C functions are named: who writes them and who calls them must agree."""


def c_prefix(machine_name: str) -> str:
    """What the names of a machine's C functions start with: its name, `-` being no part of a C name."""
    return machine_name.replace("-", "_")
