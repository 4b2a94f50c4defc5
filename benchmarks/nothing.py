"""A task that does nothing: workers import it by name."""


def nothing(number: int) -> int:
    return number
