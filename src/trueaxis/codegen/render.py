"""All files of a machine: names and contents, nothing written."""

import hashlib
import json

from trueaxis.codegen.c_source import c_header, c_source, control_sources
from trueaxis.codegen.equations import equations_page
from trueaxis.codegen.meta import ABI, spec_name
from trueaxis.codegen.numpy_source import numpy_source
from trueaxis.derivation.model import DerivedModel


def render(model: DerivedModel, spec: str = "") -> dict[str, bytes]:
    """File name -> content of generated/NAME/; spec: how it is named there. Same input, same bytes."""
    machine, routines = model.machine, model.routines
    spec = spec or spec_name(machine)
    texts = {
        "kernels.py": numpy_source(machine, routines, spec),
        "kernels.c": c_source(machine, routines, spec),
        "kernels.h": c_header(machine, routines, spec),
        "equations.md": equations_page(model, spec),
    }
    texts |= control_sources(machine, routines, spec)
    files = {name: text.encode() for name, text in texts.items()}
    return files | {"manifest.json": _manifest(model, files, spec).encode()}


def _manifest(model: DerivedModel, files: dict[str, bytes], spec: str) -> str:
    record = {
        "schema": 1,
        "machine": model.machine.name,
        "spec": spec,
        "spec_sha256": model.machine.digest,
        "kernel_abi": ABI,
        "files": {name: hashlib.sha256(content).hexdigest() for name, content in files.items()},
        "operations": {r.name: {"per_point": r.operations, "per_call": r.batch_operations} for r in model.routines},
        "systems": [
            {"runs": list(s.runs), "unknowns": list(s.unknowns)}
            for s in (model.identification.systems if model.identification else ())
        ],
    }
    return json.dumps(record, indent=1) + "\n"
