"""The kernels of the library of effects, which all machines share: `python -m trueaxis.codegen.effect_library`.

What it writes, model/effect_library.py, is checked in. A machine's own kernels have the effects of its spec alone.
"""

from pathlib import Path

from trueaxis.codegen.meta import kinds_record, routine_record
from trueaxis.codegen.numpy_source import module_source
from trueaxis.derivation.effect_terms import library_routines
from trueaxis.effects.library import BY_NAME
from trueaxis.io.files import write_files

FILE = Path(__file__).parents[1] / "model" / "effect_library.py"


def library_source() -> str:
    """The text of model/effect_library.py. Same input, same bytes."""
    routines = library_routines()
    record = {
        "effects": {"kinds": kinds_record(BY_NAME)},
        "routines": {routine.name: routine_record(routine) for routine in routines},
    }
    return module_source(
        routines,
        record,
        digest="",
        spec="effects/library.py",
        command="python -m trueaxis.codegen.effect_library",
        title="the library of effects",
        turning=True,
    )


if __name__ == "__main__":
    write_files({FILE: library_source().encode()})
