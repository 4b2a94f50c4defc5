"""`python -m trueaxis`."""

from trueaxis.cli import main

if __name__ == "__main__":  # a second process imports this module, too
    raise SystemExit(main())
