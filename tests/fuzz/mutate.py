"""Hostile files, made from valid ones: bytes, tokens, lines, numbers, arrays and columns changed at random."""

import io
import re
from random import Random
from typing import Any

import numpy as np
import polars as pl

NUMBERS = (
    "0 -0.0 1e308 -1e308 1e309 1e-320 1e-400 nan -nan inf -inf Infinity 0x10 0b1 0o7 1_000 "
    "\u0661\u0662 \uff11 1,5 1.5.2 --1 +-1 1e 1e999999999 .5 5. . - + 1d5 1e5 1e16 1e300 -1e300 "
    "9223372036854775808 -9223372036854775809 9007199254740993 99999999999999999999999999 2147483648 "
    "-1 1e-9 0.1 3 7 100 360.0001 true null [] {} '' #NUM! 12:30 1979-05-27"
).split()
WORDS = (
    '" "" \' , ,, ; : = == [ ] [[ ]] { } ( ) # % / \\ $ $$ * ^ ** . .. .a a.b @ & | ~ ! ? < > \t \n \r \r\n '
    "\0 \x1b[2J \x7f \u2028 \ufeff \U0001f600 \u00e9 \U0001d7d9 \"\"\" ''' NaN null true "
    "G0 G1 G2 G3 G91 G20 M6 X Y Z A I J K R F0 F-1 E GOTO/ CIRCLE/ FROM/1,2,3 UNITS/INCHES "
    "exp sqrt step pi s q t T v d direction other -- reading run seq __proto__ schema"
).split(" ")
FACTORS = (-1.0, 0.0, 10.0, 0.1, 2.0, 1e3, 1e-6, 1e9, 1 + 1e-9, 1.01)
KINDS: tuple[Any, ...] = (pl.Decimal(20, 3), pl.Date, pl.Datetime, pl.Duration, pl.Time, pl.Categorical, pl.Boolean,
                          pl.Binary, pl.Int8, pl.UInt64, pl.Float32, pl.String, pl.Null)  # fmt: skip
LONG = 2000  # characters that a repetition adds at most, mostly; one in a hundred is a hundred times as long
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_TOKEN = re.compile(r"\w+|\s+|[^\w\s]")


def text(data: bytes, draw: Random) -> bytes:
    """A few mutations; half of the time of numbers alone, which leave the grammar as it was."""
    numbers_only = draw.random() < 0.5
    for _ in range(draw.choice((1, 1, 1, 2, 3, 6))):
        change = _numbers if numbers_only else draw.choice((_numbers, _tokens, _lines, _bytes, _repeated, _ends))
        data = change(data, draw)
    return data


def _numbers(data: bytes, draw: Random) -> bytes:
    content = data.decode(errors="replace")
    found = list(_NUMBER.finditer(content))
    if not found:
        return _tokens(data, draw)
    if draw.random() < 0.1:  # a stretch of them, as where a unit is another one
        start, factor = draw.randrange(len(found)), draw.choice((*FACTORS, 1e300, 1e-300))
        ends = found[start].start(), found[min(len(found) - 1, start + draw.randrange(40))].end()
        stretch = _NUMBER.sub(lambda number: repr(float(number[0]) * factor), content[slice(*ends)])
        return (content[: ends[0]] + stretch + content[ends[1] :]).encode()
    at = draw.choice(found)
    # A number of another size passes where one of another form would not, and goes on to what computes with it.
    new = draw.choice(NUMBERS) if draw.random() < 0.4 else repr(float(at[0]) * draw.choice(FACTORS))
    return (content[: at.start()] + new + content[at.end() :]).encode()


def _tokens(data: bytes, draw: Random) -> bytes:
    content = data.decode(errors="replace")
    found = list(_TOKEN.finditer(content))
    if not found:
        return draw.choice(WORDS).encode()
    at, other = draw.choice(found), draw.choice(found)
    new = draw.choice((draw.choice(WORDS), draw.choice(NUMBERS), other[0], "", at[0] * 2))
    return (content[: at.start()] + new + content[at.end() :]).encode()


def _lines(data: bytes, draw: Random) -> bytes:
    lines = data.split(b"\n")
    at, other = draw.randrange(len(lines)), draw.randrange(len(lines))
    match draw.randrange(5):
        case 0:
            del lines[at]
        case 1:
            lines.insert(other, lines[at])
        case 2:
            lines[at], lines[other] = lines[other], lines[at]
        case 3:
            lines[at] = lines[at][: draw.randrange(len(lines[at]) + 1)]
        case _:
            del lines[at:]
    return b"\n".join(lines)


def _bytes(data: bytes, draw: Random) -> bytes:
    found = bytearray(data)
    at = draw.randrange(len(found) + 1)
    match draw.randrange(4):
        case 0:
            found[at : at + 1] = bytes([draw.randrange(256)])
        case 1:
            found[at:at] = bytes(draw.randrange(256) for _ in range(draw.randrange(1, 9)))
        case 2:
            del found[at : at + draw.randrange(1, 40)]
        case _:
            del found[at:]
    return bytes(found)


def _repeated(data: bytes, draw: Random) -> bytes:
    start = draw.randrange(len(data) + 1)
    piece = data[start : start + draw.choice((1, 1, 3, 10, 80))] or b"x"
    most = LONG * (100 if draw.random() < 0.01 else 1)
    return data[:start] + piece * draw.randrange(2, max(3, most // len(piece))) + data[start:]


def _ends(data: bytes, draw: Random) -> bytes:
    match draw.randrange(6):
        case 0:
            return b"\xef\xbb\xbf" + data
        case 1:
            return data.replace(b"\n", b"\r\n")
        case 2:
            return data.replace(b"\n", b"\r")
        case 3:
            return data.replace(b"\n", b"\r\n", draw.randrange(1, 9))
        case 4:
            return data.decode(errors="replace").encode("utf-16")
        case _:
            return data.rstrip(b"\n")


def archive(data: bytes, draw: Random) -> bytes:
    """A .npz file with an array of another content, shape or type, or with other bytes."""
    if draw.random() < 0.3:
        return _bytes(data, draw)
    with np.load(io.BytesIO(data)) as loaded:
        arrays: dict[str, Any] = dict(loaded)
    name = draw.choice(list(arrays))
    array = arrays[name]
    if name == "head":
        arrays[name] = np.frombuffer(text(array.tobytes(), draw), np.uint8)
    elif draw.random() < 0.6 and array.size:
        changed = array.astype(float)
        changed.flat[draw.randrange(array.size)] = draw.choice(
            (np.nan, np.inf, -np.inf, 1e308, -1.0, 0.0, 1e300, 1e-320, 2.0**63)
        )
        arrays[name] = changed
    else:
        arrays[name] = draw.choice(
            (
                array[:0],
                array[..., None],
                array.astype(complex),
                array.astype("U8"),
                array > 0,
                array.astype("M8[s]"),
                np.float64(1.0),
            )
        )
    if draw.random() < 0.1:
        del arrays[name]
    buffer = io.BytesIO()
    np.savez(buffer, **arrays)
    return buffer.getvalue()


def parquet(data: bytes, draw: Random) -> bytes:
    """A Parquet file with other bytes, maybe of a column of another type, too."""
    return _bytes(frame(data, draw) if draw.random() < 0.5 else data, draw)


def frame(data: bytes, draw: Random) -> bytes:
    """A Parquet file of the table, with a column of another type or content."""
    table = pl.read_parquet(io.BytesIO(data))
    name = draw.choice(table.columns)
    column = table[name]
    match draw.randrange(6):
        case 0:
            column = pl.Series(name, [[value] for value in column.to_list()])
        case 1:
            column = pl.Series(name, [{"a": value} for value in column.to_list()])
        case 2 if column.dtype.is_numeric():
            values = column.cast(pl.Float64).to_list()
            values[draw.randrange(len(values))] = draw.choice(
                (float("nan"), float("inf"), 1e308, -1e308, 5e-324, -0.0, None, 2.0**63)
            )
            column = pl.Series(name, values, dtype=pl.Float64)
        case _:
            try:
                column = column.cast(draw.choice(KINDS), strict=False)
            except pl.exceptions.PolarsError:
                column = pl.Series(name, [None] * len(column), dtype=pl.Null)
    buffer = io.BytesIO()
    try:
        table.with_columns(column.alias(name)).write_parquet(buffer)
    except pl.exceptions.PolarsError:
        return data
    return buffer.getvalue()
