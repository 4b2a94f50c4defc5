"""No command writes over what it reads, or writes two things into one file."""

from collections.abc import Mapping
from pathlib import Path

from trueaxis.faults import Fault
from trueaxis.measure import readings, setup

_DATA_FILES = (setup.FILE_NAME, readings.FILE_NAME, readings.PARQUET_NAME)


def overwritten(inputs: Mapping[str, Path | None], outputs: Mapping[str, Path | None]) -> list[Fault]:
    """Faults of outputs that are an input, a file of measured data in an input folder, or another output.

    Both by the name of their option, as the user knows it; None where the option was not given.
    """
    found: list[Fault] = []
    read = {name: path.resolve() for name, path in inputs.items() if path is not None}
    written: dict[Path, str] = {}
    for option, path in outputs.items():
        if path is None:
            continue
        target = path.resolve()
        for name, source in read.items():
            if target == source:
                found.append(
                    Fault(str(path), "", f"is both {name}, which is read, and {option}", "another place to write")
                )
            elif target.parent == source and target.name in _DATA_FILES:
                found.append(
                    Fault(str(path), "", f"{option} is a file of {name}, which is read", "another place to write")
                )
        if target in written:
            found.append(Fault(str(path), "", f"is both {written[target]} and {option}", "a file for each"))
        written.setdefault(target, option)
    return found
