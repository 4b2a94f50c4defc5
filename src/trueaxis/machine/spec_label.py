"""How generated files name the spec that they come from."""

import re
from pathlib import Path

UNNAMED = "the machine's spec"
# What a comment of C, Python and Markdown may hold: no end of a comment, no second line.
_NAMEABLE = re.compile(r"(?!.*(?:--|\.\.))[\w. /-]+")


def spec_label(spec: Path, out: Path) -> str:
    """How generated files name the spec that was given: from the folder that holds OUT, else by its name alone.

    So the name does not depend on where the command was run, and holds no folder outside the user's own tree.
    """
    root, given = out.resolve().parent, spec.resolve()
    label = given.relative_to(root).as_posix() if given.is_relative_to(root) else given.name
    return label if _NAMEABLE.fullmatch(label) else UNNAMED
