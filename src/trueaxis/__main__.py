"""The program as a process of its own: the command `trueaxis` and `python -m trueaxis`."""

import os
import sys

from trueaxis.import_path import leave_current_folder_out


def main() -> int:
    """Run the command line of this process. Returns the exit code."""
    leave_current_folder_out()  # before anything else is imported
    _occupy_standard_streams()
    from trueaxis.stopping import Stopped, stoppable  # noqa: PLC0415

    try:
        with stoppable():
            from trueaxis.cli.main import main as run  # noqa: PLC0415  what takes time is loaded where a signal may come

            return run()
    except Stopped as stopped:
        return stopped.code


def _occupy_standard_streams() -> None:
    """Open the standard streams that are closed, so that no file of ours gets their number and with it their text."""
    while (number := os.open(os.devnull, os.O_RDWR)) <= 2:
        pass
    os.close(number)


if __name__ == "__main__":
    sys.exit(main())
