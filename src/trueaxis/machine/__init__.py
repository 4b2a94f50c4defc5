"""Machine specs: machines/NAME.toml read to a frozen, checked `Machine`."""

from trueaxis.machine.machine import Body, Machine
from trueaxis.machine.read import read_machine

__all__ = ["Body", "Machine", "read_machine"]
