"""A second process for work that nothing else waits for.

It is this very module, run by the same Python: it imports what it is told, takes one call from its standard input and
gives the result on its standard output. Whatever goes wrong with it, the call is made here instead; where its input
ends, because the first process has, it ends, too.
"""

import gc
import pickle
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module

from trueaxis.own_python import cores, own_python

Result = Callable[[], object]


@contextmanager
def beside(module: str) -> Iterator[Callable[..., Result]]:
    """Gives start(function, *arguments), once, which gives what waits for the result of that function of the module.

    The process imports the module while the caller goes on. Where there is one core, or no process can be had, the
    function is called when its result is asked for.
    """
    process = _started(module) if cores() > 1 else None

    def start(function: str, *arguments: object) -> Result:
        sent = process is not None and _sent(process, function, arguments)

        def result() -> object:
            if sent and process is not None:
                told, _ = process.communicate()
                if process.returncode == 0:
                    return pickle.loads(told)  # of our own process
            return getattr(import_module(module), function)(*arguments)

        return result

    try:
        yield start
    finally:
        if process is not None:
            process.kill()
            process.communicate()


def _started(module: str) -> "subprocess.Popen[bytes] | None":
    # a session of its own: who interrupts the program means the first process
    try:
        return own_python(
            "-m",
            __name__,
            module,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
    except OSError:
        return None


def _sent(process: "subprocess.Popen[bytes]", function: str, arguments: tuple[object, ...]) -> bool:
    assert process.stdin is not None
    try:
        pickle.dump((function, arguments), process.stdin)
        process.stdin.flush()
    except OSError:
        return False
    return True


def main() -> None:
    """The second process: one call; what becomes garbage in it is gone with it."""
    gc.disable()
    module = import_module(sys.argv[1])
    given, told = sys.stdin.buffer, sys.stdout.buffer
    sys.stdout = sys.stderr  # what a library prints is no result
    try:
        function, arguments = pickle.load(given)
    except EOFError:
        return
    pickle.dump(getattr(module, function)(*arguments), told)


if __name__ == "__main__":
    main()
