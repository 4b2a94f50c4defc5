"""`python -m trueaxis`."""

from trueaxis.cli import main

raise SystemExit(main())
