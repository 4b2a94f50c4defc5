"""Read machines/NAME.toml: types and keys here, what the bodies make together in `structure`."""

import re
from dataclasses import dataclass, replace
from pathlib import Path

from trueaxis.io.faults import Faults
from trueaxis.io.input_files import input_bytes, utf8_text
from trueaxis.io.toml_lines import KeyPath, complainer, parse_toml
from trueaxis.machine.body import PROSE, PROSE_MEANING, read_body, read_joint
from trueaxis.machine.effect_kinds import read_effect_kinds
from trueaxis.machine.effects import read_effects, with_squareness
from trueaxis.machine.fields import Complain, Fields
from trueaxis.machine.machine import AXES, BED, LINEAR, Body, Machine, read_reference_points, read_start
from trueaxis.machine.prior import read_prior
from trueaxis.machine.structure import check_structure
from trueaxis.machine.structure_code import AxisOrder, StructureCodeError, default_location_errors, parse_structure

NAME = r"[A-Za-z][A-Za-z0-9_-]{0,99}"  # of a folder, too
ROTATIONS = ("small-angle", "true")  # of errors: the paper's matrix 1 + [epsilon x], or a true rotation
MOST_BODIES = 40  # six axes, two ends, and what is fixed between them
LABEL = r"motion_[XYZABC]+|system_[1-9][0-9]*|squareness"


def read_machine(path: Path) -> Machine:
    """The machine that a spec describes.

    Raises InputError with every fault found, each with key and line and what would be right.
    """
    return replace(parse_machine(utf8_text(path, input_bytes(path)), Faults(str(path))), source=path)


def parse_machine(text: str, faults: Faults) -> Machine:
    """The machine described by the text of a spec; raises InputError with every fault."""
    tree = parse_toml(text, faults)
    complain = complainer(text, faults)
    machine = _machine(Fields(tree, (), complain), complain, faults)
    faults.raise_if_any()
    return machine


def _machine(top: Fields, complain: Complain, faults: Faults) -> Machine:
    if (schema := top.integer("schema")) not in (1, None):
        complain(("schema",), f"{schema} is not a schema that this version reads", "schema = 1")
    name = top.text("name", pattern=NAME, meaning="a letter, then letters, digits, _ and -, 100 at most") or "unnamed"
    title = top.text("title", default=name, pattern=PROSE, meaning=PROSE_MEANING) or name
    before = len(faults.found)
    outline = _from_code(top, complain) if "structure" in top.raw else _from_bodies(top, complain)
    # What may act where cannot be told of bodies that are in doubt.
    bodies = outline.bodies if len(faults.found) == before else None
    kinds = read_effect_kinds(top, bodies)
    effects = read_effects(top, bodies, kinds)
    curves = top.table("curves")
    degree = curves.integer("degree", default=7)
    if degree is not None and not 1 <= degree <= 15:
        complain(("curves", "degree"), f"{degree} is out of range", "a degree from 1 to 15")
    curves.refuse_others()
    runs = top.text("runs", default="")
    references = top.table("references")
    said = tuple(
        (key, text) for key in references.raw if re.fullmatch(LABEL, key) and (text := references.text(key)) is not None
    )
    references.refuse_others("motion_X, motion_XY, ..., system_1, ..., squareness")
    rotations = top.choice("rotations", ROTATIONS) or ROTATIONS[0]
    machine = Machine(
        name=name,
        title=title,
        bodies=with_squareness(outline.bodies, effects),
        workpiece=outline.workpiece,
        tool=outline.tool,
        curve_degree=degree or 7,
        true_rotation=rotations == "true",
        runs=runs or None,
        references=said,
        effects=effects,
        effect_kinds=kinds,
    )
    units = {parameter: machine.parameter_unit(parameter) for parameter in machine.location_errors}
    prior = read_prior(top, machine.components, units)
    start, points = read_start(top, machine.travel), read_reference_points(top, machine.travel)
    top.refuse_others()
    return replace(machine, prior=prior, start=start, reference_points=points)


@dataclass(frozen=True)
class _Outline:
    """The bodies and which of them are the ends (0: unknown, a fault has been told)."""

    bodies: tuple[Body, ...]
    workpiece: int
    tool: int


def _from_bodies(top: Fields, complain: Complain) -> _Outline:
    """[[body]] tables and [ends]."""
    indexed = [(index, read_body(fields)) for index, fields in enumerate(top.tables("body", True, MOST_BODIES))]
    bodies = [(index, body) for index, body in indexed if body is not None]
    ends = top.table("ends", required=True)
    workpiece, tool = ends.integer("workpiece"), ends.integer("tool")
    ends.refuse_others()
    check_structure(bodies, workpiece, tool, len(bodies) == len(indexed), complain)
    return _Outline(tuple(body for _, body in bodies), workpiece or 0, tool or 0)


def _from_code(top: Fields, complain: Complain) -> _Outline:
    """`structure` and the tables [axis.X], [workpiece], [tool]; all errors and default names where they are silent."""
    for key in ("body", "ends"):
        if key in top.raw:
            top.fault(key, "stands beside structure", "one of the two: structure, or [[body]] and [ends]")
        top.known.add(key)
    code = top.text("structure") or ""
    tables = top.table("axis")
    try:
        order = parse_structure(code)
    except StructureCodeError as problem:
        top.fault("structure", f"{code!r} cannot be read: {problem}", "such as [w C' Y' b X Z B t], YFXZ or XZB+YC")
        order = AxisOrder((), ())
        tables.known.update(AXES)
    paths: list[KeyPath] = []
    bodies: list[Body] = []
    for end, axes in (("workpiece", order.workpiece), ("tool", order.tool)):
        lower = BED
        for axis in axes:
            fields = tables.table(axis)
            if axis in LINEAR or "travel" in fields.raw:
                default = fields
            else:
                default = Fields({"travel": [-360.0, 360.0]} | fields.raw, fields.path, fields.complain)
            kind = "slide" if axis in LINEAR else ("table" if end == "workpiece" else "head")
            location = default_location_errors(axis, order)
            bodies.append(read_joint(default, len(bodies) + 2, lower, axis, f"{axis} {kind}", location))
            paths.append(fields.path)
            lower = bodies[-1].number
        bodies.append(read_joint(top.table(end), len(bodies) + 2, lower, None, end, ()))
        paths.append((end,))
    tables.refuse_others(f"the axes of the structure: {' '.join(order.workpiece + order.tool)}")
    workpiece, tool = len(order.workpiece) + 2, len(bodies) + 1

    def at_table(path: KeyPath, problem: str, remedy: str) -> None:
        complain((*paths[int(path[1])], *path[2:]) if path[0] == "body" else path, problem, remedy)

    check_structure(list(enumerate(bodies)), workpiece, tool, True, at_table)
    return _Outline(tuple(bodies), workpiece, tool)
