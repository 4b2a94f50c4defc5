"""Call compiled kernels as if they were the NumPy functions of the same names."""

import ctypes
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from trueaxis.c_prefix import c_prefix
from trueaxis.model.compiler import SOURCE, compile_kernels

FloatArray = npt.NDArray[np.float64]

# Threads share the points out in multiples of this, which the emitted loops divide into whole blocks and vectors: every
# point then meets the same instructions, and the result has the same bytes, whatever the number of threads.
_SHARE = 512
_WORTH = 131072  # points that a thread must have to do before starting it pays
_DOUBLE = np.dtype(np.float64)
_KEPT = 256  # combinations of shapes whose check is kept: a run of a command calls a routine with a few dozen


class _Memory:
    """The type of a C argument that is an array: its address, found four times as fast as by `array.ctypes.data`.

    An array that is not contiguous, or read-only, raises ctypes.ArgumentError.
    """

    from_param = (ctypes.c_char * 0).from_buffer


@dataclass(frozen=True, slots=True)
class ArrayLayout:
    """An argument of a routine: `shape` without the point index; per_point: whether each point has its own values."""

    name: str
    shape: tuple[int, ...]
    per_point: bool


class Shapes(NamedTuple):
    """n: points of a call; spread: which inputs have one point that serves for all; results: shapes of the outputs."""

    n: int
    spread: tuple[int, ...]
    results: tuple[tuple[int, ...], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class CRoutine:
    """A compiled routine: arguments, results and shapes as in the NumPy function of its name.

    function: takes the number of points, their stride and the arrays. shapes: `checked_shapes` of this routine, kept,
    since identification calls a routine with the same shapes thousands of times.
    """

    name: str
    function: Any
    inputs: tuple[ArrayLayout, ...]
    outputs: tuple[ArrayLayout, ...]
    shapes: Callable[..., Shapes]

    def __call__(self, *arrays: npt.ArrayLike, threads: int = 1) -> FloatArray | tuple[FloatArray, ...]:
        """Compute all points, on up to `threads` processors at once; a tuple where there are several outputs.

        Raises ValueError for an array of a wrong shape, TypeError for a wrong number of arrays.
        """
        if threads < 1:
            raise ValueError(f"threads is {threads}, not 1 or more")
        given = [np.asarray(array, dtype=_DOUBLE) for array in arrays]
        n, spread, shapes = self.shapes(*[array.shape for array in given])
        for k in spread:
            given[k] = given[k].repeat(n, axis=-1)
        results = [np.empty(shape) for shape in shapes]
        run = self.function if threads == 1 or n < 2 * _WORTH else partial(self._in_shares, threads)
        try:
            run(n, n, *given, *results)
        except ctypes.ArgumentError:  # an input is not contiguous, or read-only
            run(n, n, *(array if array.flags.carray else array.copy() for array in given), *results)
        return results[0] if len(results) == 1 else tuple(results)

    def _in_shares(self, threads: int, n: int, stride: int, *arrays: FloatArray) -> None:
        """What `function` computes, by so many threads."""
        layouts = (*self.inputs, *self.outputs)
        share = -(-n // (min(threads, n // _WORTH) * _SHARE)) * _SHARE

        def part(start: int) -> None:
            rest = (a.ravel()[start:] if layout.per_point else a for layout, a in zip(layouts, arrays, strict=True))
            self.function(min(share, n - start), stride, *rest)

        starts = range(0, n, share)
        with ThreadPoolExecutor(len(starts) - 1) as pool:
            others = [pool.submit(part, start) for start in starts[1:]]
            part(0)  # the calling thread does its share
        for other in others:
            other.result()


def checked_shapes(
    name: str, inputs: Sequence[ArrayLayout], outputs: Sequence[ArrayLayout], *shapes: tuple[int, ...]
) -> Shapes:
    """What a call of a routine with inputs of these shapes computes. Raises as CRoutine does."""
    if len(shapes) != len(inputs):
        raise TypeError(f"{name} takes {len(inputs)} arrays, not {len(shapes)}")
    sizes: dict[int, str] = {}
    for layout, shape in zip(inputs, shapes, strict=True):
        if layout.per_point and len(shape) == len(layout.shape) + 1:
            sizes.setdefault(shape[-1], layout.name)
    several = [size for size in sizes if size != 1]
    if len(several) > 1:
        told = ", ".join(f"{sizes[size]} has {size}" for size in several)
        raise ValueError(f"the arrays of {name} differ in their number of points: {told}")
    n = several[0] if several else 1
    spread = []
    for k, (layout, shape) in enumerate(zip(inputs, shapes, strict=True)):
        wanted = (*layout.shape, n) if layout.per_point else layout.shape
        if shape == wanted:
            continue
        if not layout.per_point or shape != (*layout.shape, 1):
            raise ValueError(f"{layout.name} has the shape {shape}, not {wanted}")
        spread.append(k)
    return Shapes(n, tuple(spread), tuple((*layout.shape, n) for layout in outputs))


def load_c_kernels(
    code: Mapping[str, bytes], machine_name: str, digest: str, abi: int, routines: Mapping[str, Any]
) -> tuple[dict[str, CRoutine], str]:
    """The routines of kernels.c, compiled where need be; or none of them, and the reason.

    code: the content of kernels.c and kernels.h by these names. digest, abi: what the library must
    say of itself. routines: the `routines` of the META record.
    """
    compiled = compile_kernels(code)
    if compiled.library is None:
        return {}, compiled.reason
    prefix = c_prefix(machine_name)
    try:
        library = ctypes.CDLL(str(compiled.library))
        if reason := _mismatch(library, prefix, digest, abi):
            return {}, f"{SOURCE} {reason}"
        return {name: _routine(library, prefix, name, record) for name, record in routines.items()}, ""
    except (OSError, AttributeError) as error:  # a library of another processor, a function that is not there
        return {}, f"the compiled kernels cannot be used: {error}"


def _mismatch(library: ctypes.CDLL, prefix: str, digest: str, abi: int) -> str:
    """What is wrong with the library; empty if nothing."""
    kernel_abi = getattr(library, f"{prefix}_kernel_abi")
    kernel_abi.argtypes, kernel_abi.restype = (), ctypes.c_int
    spec_hash = getattr(library, f"{prefix}_spec_hash")
    spec_hash.argtypes, spec_hash.restype = (), ctypes.c_char_p
    if (found := kernel_abi()) != abi:
        return f"has the kernel ABI {found}, not {abi}"
    if spec_hash() != digest.encode():
        return "was made from another spec"
    return ""


def _routine(library: ctypes.CDLL, prefix: str, name: str, record: Mapping[str, Any]) -> CRoutine:
    inputs, outputs = (tuple(map(_layout, record[key])) for key in ("inputs", "outputs"))
    function = getattr(library, f"{prefix}_{name}")
    function.argtypes = (ctypes.c_size_t,) * 2 + (_Memory,) * (len(inputs) + len(outputs))
    function.restype = None
    shapes = lru_cache(_KEPT)(partial(checked_shapes, name, inputs, outputs))
    return CRoutine(name=name, function=function, inputs=inputs, outputs=outputs, shapes=shapes)


def _layout(record: Mapping[str, Any]) -> ArrayLayout:
    return ArrayLayout(record["name"], tuple(record["shape"]), record["per_point"])
