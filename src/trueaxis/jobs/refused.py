"""The answer is no: a result that would rely on too little is not given out."""

from typing import Any


class RefusedError(ValueError):
    """Nothing was written, as the command ends with exit code 1.

    reasons: a sentence each; where one names an option of the command, such as --max-u, it means the argument of that
    name, max_u. result: what was computed, to look at, of the class that the function returns.
    """

    def __init__(self, reasons: tuple[str, ...], result: Any) -> None:
        super().__init__("; ".join(reasons))
        self.reasons, self.result = reasons, result
