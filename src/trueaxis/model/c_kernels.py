"""Call compiled kernels as if they were the NumPy functions of the same names."""

import ctypes
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import numpy.typing as npt

from trueaxis.c_prefix import c_prefix
from trueaxis.model.compiler import SOURCE, compile_kernels

FloatArray = npt.NDArray[np.float64]

# Threads share the points out in multiples of this, which the emitted loops divide into whole blocks and vectors: every
# point then meets the same instructions, and the result has the same bytes, whatever the number of threads.
_SHARE = 512
_WORTH = 131072  # points that a thread must have to do before starting it pays
_ITEM = 8  # bytes of a double


@dataclass(frozen=True, slots=True)
class ArrayLayout:
    """An argument of a routine: `shape` without the point index; per_point: whether each point has its own values."""

    name: str
    shape: tuple[int, ...]
    per_point: bool

    def checked(self, values: npt.ArrayLike, n: int) -> FloatArray:
        """The values contiguous, of this shape for `n` points. Raises ValueError when they are of another."""
        wanted = (*self.shape, n) if self.per_point else self.shape
        array = np.asarray(values, dtype=np.float64)
        if array.shape != wanted:
            if not self.per_point or array.shape != (*self.shape, 1):
                raise ValueError(f"{self.name} has the shape {array.shape}, not {wanted}")
            array = np.broadcast_to(array, wanted)
        return np.ascontiguousarray(array)


@dataclass(frozen=True, slots=True)
class CRoutine:
    """A compiled routine: arguments, results and shapes as in the NumPy function of its name."""

    name: str
    function: Any
    inputs: tuple[ArrayLayout, ...]
    outputs: tuple[ArrayLayout, ...]

    def __call__(self, *arrays: npt.ArrayLike, threads: int = 1) -> FloatArray | tuple[FloatArray, ...]:
        """Compute all points, on up to `threads` processors at once; a tuple where there are several outputs.

        Raises ValueError for an array of a wrong shape, TypeError for a wrong number of arrays.
        """
        if len(arrays) != len(self.inputs):
            raise TypeError(f"{self.name} takes {len(self.inputs)} arrays, not {len(arrays)}")
        if threads < 1:
            raise ValueError(f"threads is {threads}, not 1 or more")
        n = self._points(arrays)
        given = [layout.checked(array, n) for layout, array in zip(self.inputs, arrays, strict=True)]
        results = tuple(np.empty((*layout.shape, n)) for layout in self.outputs)
        if n:
            self._run(n, [*given, *results], threads)
        return results[0] if len(results) == 1 else results

    def _points(self, arrays: Sequence[npt.ArrayLike]) -> int:
        """The number of points of the arrays that have points; those of one point serve for all."""
        sizes: dict[int, str] = {}
        for layout, array in zip(self.inputs, arrays, strict=True):
            if layout.per_point and np.ndim(array) == len(layout.shape) + 1:
                sizes.setdefault(np.shape(array)[-1], layout.name)
        several = [size for size in sizes if size != 1]
        if len(several) > 1:
            told = ", ".join(f"{sizes[size]} has {size}" for size in several)
            raise ValueError(f"the arrays of {self.name} differ in their number of points: {told}")
        return several[0] if several else 1

    def _run(self, n: int, arrays: Sequence[FloatArray], threads: int) -> None:
        addresses = [array.ctypes.data for array in arrays]
        threads = min(threads, n // _WORTH)
        if threads <= 1:
            self.function(n, n, *addresses)
            return
        steps = [_ITEM if layout.per_point else 0 for layout in (*self.inputs, *self.outputs)]
        share = -(-n // (threads * _SHARE)) * _SHARE
        parts = [
            partial(
                self.function,
                min(share, n - start),
                n,
                *(address + start * step for address, step in zip(addresses, steps, strict=True)),
            )
            for start in range(0, n, share)
        ]
        with ThreadPoolExecutor(threads - 1) as pool:
            others = [pool.submit(part) for part in parts[1:]]
            parts[0]()  # the calling thread does its share
        for other in others:
            other.result()


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
    function.argtypes = (ctypes.c_size_t,) * 2 + (ctypes.c_void_p,) * (len(inputs) + len(outputs))
    function.restype = None
    return CRoutine(name, function, inputs, outputs)


def _layout(record: Mapping[str, Any]) -> ArrayLayout:
    return ArrayLayout(record["name"], tuple(record["shape"]), record["per_point"])
