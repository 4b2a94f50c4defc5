"""The pieces that schemas are put together from (JSON Schema draft 7, which editors know)."""

from collections.abc import Iterable, Mapping
from typing import Any

Schema = dict[str, Any]

NUMBER: Schema = {"type": "number"}
TEXT: Schema = {"type": "string", "pattern": r"^[^\x00-\x1f\x7f]*\S[^\x00-\x1f\x7f]*$"}  # one line with something in it


def document(title: str, description: str, schema: Schema) -> Schema:
    """A whole schema."""
    head = {"$schema": "http://json-schema.org/draft-07/schema#", "title": title, "description": description}
    return head | schema


def table(keys: Mapping[str, Schema], required: Iterable[str] = (), **more: Any) -> Schema:
    """A table, or an object, with these keys and no others."""
    found: Schema = {"type": "object", "properties": dict(keys), "additionalProperties": False}
    return found | ({"required": list(required)} if required else {}) | more


def by_name(value: Schema, names: str = "") -> Schema:
    """A table with keys of one's own; names: a pattern of all of them."""
    found: Schema = {"type": "object", "additionalProperties": value}
    return found | ({"propertyNames": {"pattern": f"^({names})$"}} if names else {})


def said(schema: Schema, description: str) -> Schema:
    """A schema with what an editor shows beside it."""
    return schema | {"description": description}


def numbers(count: int | None = None) -> Schema:
    """A list of numbers, of so many where that is given."""
    return array(NUMBER) if count is None else array(NUMBER, minItems=count, maxItems=count)


def array(items: Schema, **more: Any) -> Schema:
    """A list of one kind of things."""
    return {"type": "array", "items": items} | more


def among(words: Iterable[str]) -> Schema:
    """One of a few words."""
    return {"enum": list(words)}


def above_zero(largest: float) -> Schema:
    """A number above 0."""
    return {"type": "number", "exclusiveMinimum": 0, "maximum": largest}


def within(lowest: float, highest: float) -> Schema:
    """A number between these."""
    return {"type": "number", "minimum": lowest, "maximum": highest}


def uncertain(value: Schema) -> Schema:
    """A value, or null where it is not known."""
    return {"anyOf": [value, {"type": "null"}]}


def where(key: str, is_one_of: Iterable[str], then: Schema) -> Schema:
    """What holds of a table whose key is one of these words."""
    return {"if": {"properties": {key: among(is_one_of)}, "required": [key]}, "then": then}


FIRST_SCHEMA = said({"const": 1}, "version of the file's form")
