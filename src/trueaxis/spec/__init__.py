"""Machine specs: machines/NAME.toml read to a frozen, checked `Machine`."""

from trueaxis.spec.machine import Body, Machine
from trueaxis.spec.read import read_machine

__all__ = ["Body", "Machine", "read_machine"]
