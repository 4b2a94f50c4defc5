"""`python -m trueaxis`."""

from trueaxis.cli import main

if __name__ == "__main__":
    raise SystemExit(main())
