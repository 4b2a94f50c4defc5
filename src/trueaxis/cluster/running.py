"""The workers of a scheduler that runs already."""

import asyncio
import socket
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any
from urllib.parse import urlsplit

from trueaxis.cluster.quiet import quiet
from trueaxis.io.faults import Fault, InputError

SECONDS = 5.0  # for an answer: on a network that works it takes milliseconds
OPTION = "--scheduler"
PROTOCOLS = ("tcp", "tls")
_RIGHT = "an address such as tcp://192.168.0.10:8786, as the scheduler prints it when it starts"


@contextmanager
def running_client(address: str) -> Iterator[Any]:
    """A client of the scheduler at that address. Raises InputError where none answers there, or it has no workers."""
    host, port = _host_and_port(address)
    try:  # Dask would try again and again
        socket.create_connection((host, port), SECONDS).close()
    except OSError as error:
        raise _fault(address, f"nothing answers there: {error.strerror or error}") from None
    with quiet():
        from distributed import Client  # noqa: PLC0415  an extra, and half a second

        try:
            asyncio.run(asyncio.wait_for(_identity(address), SECONDS))
        except (OSError, TimeoutError, ValueError) as error:  # another service, or another protocol
            problem = f"no Dask scheduler answers there within {SECONDS:g} s ({type(error).__name__})"
            raise _fault(address, problem) from None
        with Client(address, timeout=SECONDS, set_as_default=False) as client:
            try:
                client.wait_for_workers(1, timeout=SECONDS)
            except TimeoutError:
                raise _fault(address, "has no workers", f"start some: dask worker {address}") from None
            yield client


async def _identity(address: str) -> object:
    """What a scheduler says of itself. A client would wait for a service that never answers without end."""
    from distributed.core import connect  # noqa: PLC0415  as above
    from distributed.security import Security  # noqa: PLC0415

    comm = await connect(address, timeout=SECONDS, **Security().get_connection_args("client"))
    try:
        await comm.write({"op": "identity", "reply": True})
        return await comm.read()
    finally:
        comm.abort()


def _host_and_port(address: str) -> tuple[str, int]:
    try:
        parts = urlsplit(address if "://" in address else f"tcp://{address}")
        host, port = parts.hostname, parts.port
    except ValueError:
        raise _fault(address, "is no address") from None
    if not host or not port or parts.scheme not in PROTOCOLS:
        raise _fault(address, "is no address")
    return host, port


def _fault(address: str, problem: str, remedy: str = _RIGHT) -> InputError:
    return InputError([Fault(f"{OPTION} {address}", "", problem, remedy)])
