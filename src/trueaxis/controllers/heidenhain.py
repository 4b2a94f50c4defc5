"""HEIDENHAIN .COM tables of nonlinear axis error, a file per axis that moves, and the .CMA table that assigns them.

Values are errors, positive where the travel is too long: actual minus nominal (technical manuals, 1.6 and 6.10).
"""

from collections.abc import Mapping, Sequence

from trueaxis.controllers.axis_tables import AxisTable, plain

DIGITS = 6  # nm
MOST_POINTS = 256  # entries of a .COM table
ASSIGNMENT = "config.cma"


def com_files(tables: Sequence[AxisTable], reversed_too: bool) -> Mapping[str, str]:
    """Name -> text: a .COM for every axis by whose position something is corrected, and config.cma.

    reversed_too: with a column BACKLASH, the axis's own error when approached in the negative direction.
    """
    movers = list(dict.fromkeys(table.by for table in tables))
    files = {f"{axis.lower()}axis.com": _com(axis, tables, reversed_too) for axis in movers}
    head = ["NR", "ACTIVE", *movers]
    row = ["0", "*", *(f"{axis.lower()}axis.com" for axis in movers)]
    files[ASSIGNMENT] = _table(ASSIGNMENT, [head, row])
    return files


def _com(axis: str, tables: Sequence[AxisTable], reversed_too: bool) -> str:
    columns = [table for table in tables if table.by == axis]
    own = next((table for table in columns if table.of == axis), None)
    back = own if reversed_too else None
    head = ["NR", "AXISPOS", *(["BACKLASH"] if back is not None else []), *(table.of for table in columns)]
    rows = [head]
    for index, position in enumerate(columns[0].positions):
        cells = [str(index), plain(position, DIGITS)]
        if back is not None:
            cells.append(plain(back.backward[index], DIGITS))
        rows.append([*cells, *(plain(_value(table, index, back), DIGITS) for table in columns)])
    return _table(f"{axis.lower()}axis.com", rows)


def _value(table: AxisTable, index: int, back: AxisTable | None) -> float:
    return float(table.forward[index] if table is back else table.mean[index])


def _table(name: str, rows: Sequence[Sequence[str]]) -> str:
    """A table as these controls keep it: BEGIN, the names of the columns, rows in columns of one width, [END]."""
    widths = [max(len(row[index]) for row in rows) for index in range(len(rows[0]))]
    lines = [" ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows]
    return "\n".join([f"BEGIN {name.upper()} MM", *lines, "[END]"]) + "\n"
