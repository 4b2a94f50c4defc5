# mypy: ignore-errors
"""Runs in LinuxCNC's own Python: hears the calls of its interpreter that the module gcode passes over.

The interpreter (librs274) makes a call for everything that a program asks of the machine. The module gcode tells
Python of motions alone: for spindle, coolant, path modes and outputs it has functions that do nothing. As every shared
library of Linux, librs274 goes to functions of others by way of a table of addresses (the global offset table of the
ELF format, filled in by its relocations): here the addresses of such functions are replaced by ones that tell Python
first, and then do what was done before.
"""

import ctypes
import os
import struct

# the calls that are heard, with their arguments as C++ mangles them into the name (System V ABI)
CALLS = {
    "USE_LENGTH_UNITS": "11CANON_UNITS", "SET_MOTION_CONTROL_MODE": "17CANON_MOTION_MODEd",
    "SET_NAIVECAM_TOLERANCE": "d", "SET_FEED_MODE": "ii", "SET_SPINDLE_MODE": "id", "SET_SPINDLE_SPEED": "id",
    "START_SPINDLE_CLOCKWISE": "ii", "START_SPINDLE_COUNTERCLOCKWISE": "ii", "STOP_SPINDLE_TURNING": "i",
    "ORIENT_SPINDLE": "idi", "START_SPEED_FEED_SYNCH": "idb", "FLOOD_ON": "v", "FLOOD_OFF": "v", "MIST_ON": "v",
    "MIST_OFF": "v", "PROGRAM_STOP": "v", "OPTIONAL_PROGRAM_STOP": "v", "PROGRAM_END": "v", "PALLET_SHUTTLE": "v",
    "ENABLE_FEED_OVERRIDE": "v", "DISABLE_FEED_OVERRIDE": "v", "ENABLE_SPEED_OVERRIDE": "i",
    "DISABLE_SPEED_OVERRIDE": "i", "ENABLE_ADAPTIVE_FEED": "v", "DISABLE_ADAPTIVE_FEED": "v", "ENABLE_FEED_HOLD": "v",
    "DISABLE_FEED_HOLD": "v", "SET_MOTION_OUTPUT_BIT": "i", "CLEAR_MOTION_OUTPUT_BIT": "i",
    "SET_MOTION_OUTPUT_VALUE": "id", "SET_AUX_OUTPUT_BIT": "i", "CLEAR_AUX_OUTPUT_BIT": "i",
    "SET_AUX_OUTPUT_VALUE": "id", "SELECT_TOOL": "i", "START_CHANGE": "v", "CHANGE_TOOL_NUMBER": "i",
    "SET_TOOL_TABLE_ENTRY": "ii7EmcPosedddi", "NURBS_FEED": "iSt6vectorI13CONTROL_POINTSaIS0_EEj", "WAIT": "iiid",
    "MESSAGE": "Pc", "COMMENT": "PKc",
}  # fmt: skip
# what is asked of the arguments where that is not what the name says: a record or a vector stands in memory
_TAKEN = {"SET_TOOL_TABLE_ENTRY": "ii", "NURBS_FEED": "ipj"}
# what the interpreter asks, and the module answers with numbers of its own
ANSWERS = ("GET_EXTERNAL_MOTION_CONTROL_TOLERANCE", "GET_EXTERNAL_MOTION_CONTROL_NAIVECAM_TOLERANCE")
_KEPT_SILENT = frozenset({"SET_TOOL_TABLE_ENTRY", "MESSAGE", "COMMENT"})  # not done: the module's do nothing of use
_TYPES = {"i": ctypes.c_int, "j": ctypes.c_uint, "d": ctypes.c_double, "b": ctypes.c_bool, "p": ctypes.c_void_p}
_CONTROL_POINT = 24  # bytes: three doubles
_END, _RELA_SIZE, _STRINGS, _SYMBOLS, _RELA, _PLT_SIZE, _PLT = 0, 8, 5, 6, 7, 2, 23  # tags of the dynamic section
_SYMBOL = 24  # bytes of a symbol of a 64-bit library


class _LinkMap(ctypes.Structure):
    """Where a library is in memory: the head of glibc's link_map, see dlinfo(3)."""

    _fields_ = (("base", ctypes.c_size_t), ("name", ctypes.c_char_p), ("dynamic", ctypes.c_void_p))


def hear(say, answers):
    """Have every call of CALLS told: say(name, its arguments), and those of ANSWERS answered, by functions of the name.

    Returns what must live as long as calls may be made. Raises LookupError with a call that is not there.
    """
    slots = _slots(ctypes.CDLL("librs274.so.0"))
    kept = []
    for name, mangled in {**CALLS, **dict.fromkeys(ANSWERS, "v")}.items():
        if (slot := slots.get(f"_Z{len(name)}{name}{mangled}")) is None:
            raise LookupError(name)
        place = ctypes.c_void_p.from_address(slot)
        if name in ANSWERS:
            function = ctypes.PYFUNCTYPE(ctypes.c_double)(answers[name])
        else:
            function = _heard(name, place.value, say)
        _allow_writing(slot, name)
        place.value = ctypes.cast(function, ctypes.c_void_p).value
        kept.append(function)
    return kept


def _heard(name, address, say):
    """A function that tells a call and makes it at an address."""
    kind = ctypes.PYFUNCTYPE(ctypes.c_int, *_types(name))
    before = kind(address)

    def heard(*given):
        say(name, [_points(given[1])] if name == "NURBS_FEED" else list(given))
        return 0 if name in _KEPT_SILENT else before(*given)

    return kind(heard)


def _allow_writing(slot, name):
    page = os.sysconf("SC_PAGESIZE")
    start = slot // page * page
    if ctypes.CDLL(None).mprotect(ctypes.c_void_p(start), ctypes.c_size_t(page), 3):  # reading and writing
        raise LookupError(name)


def _types(name):
    """Of the arguments that are asked for."""
    mangled = _TAKEN.get(name, CALLS[name])
    if mangled in ("Pc", "PKc"):
        return [ctypes.c_char_p]
    for word in ("11CANON_UNITS", "17CANON_MOTION_MODE"):
        mangled = mangled.replace(word, "i")
    return [_TYPES[letter] for letter in mangled if letter != "v"]


def _points(vector):
    """How many control points a vector has: it begins with where they begin and end."""
    begin, end = struct.unpack("QQ", ctypes.string_at(vector, 16))
    return (end - begin) // _CONTROL_POINT


def _slots(library):
    """Where the addresses of functions that a library calls stand in memory, by mangled name."""
    at = ctypes.cast(library._handle, ctypes.POINTER(_LinkMap)).contents
    tags, place = {}, at.dynamic
    while (tag := struct.unpack("q", ctypes.string_at(place, 8))[0]) != _END:
        tags[tag] = struct.unpack("Q", ctypes.string_at(place + 8, 8))[0]
        place += 16
    found = {}
    for table, size in ((_PLT, _PLT_SIZE), (_RELA, _RELA_SIZE)):
        for offset, info, _ in struct.iter_unpack("QQq", ctypes.string_at(tags.get(table, 0), tags.get(size, 0))):
            if number := info >> 32:
                (name,) = struct.unpack("I", ctypes.string_at(tags[_SYMBOLS] + _SYMBOL * number, 4))
                found[ctypes.string_at(tags[_STRINGS] + name).decode("latin-1")] = at.base + offset
    return found
