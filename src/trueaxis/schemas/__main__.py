"""`python -m trueaxis.schemas FOLDER` writes all schemas; docs/schemas holds what it writes."""

import json
import sys
from pathlib import Path

from trueaxis.io.files import write_files
from trueaxis.schemas.json_files import diagnosis_schema, errors_schema
from trueaxis.schemas.pieces import Schema
from trueaxis.schemas.toml_files import machine_schema, setup_schema

USAGE = "usage: python -m trueaxis.schemas FOLDER"


def schemas() -> dict[str, Schema]:
    """File name -> schema."""
    return {
        "machine.schema.json": machine_schema(),
        "setup.schema.json": setup_schema(),
        "errors.schema.json": errors_schema(),
        "diagnosis.schema.json": diagnosis_schema(),
    }


def main(words: list[str]) -> int:
    """Write the schemas into a folder. Returns the exit code."""
    if len(words) != 1 or words[0].startswith("-"):
        print(USAGE, file=sys.stderr)
        return 2
    texts = {Path(words[0]) / name: json.dumps(schema, indent=2) + "\n" for name, schema in schemas().items()}
    write_files(texts)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
