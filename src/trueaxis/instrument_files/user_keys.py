"""What the user says of a run beside its file: keys of --map, or answers; what is missing is gathered as questions."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from pathlib import Path
from typing import Literal

from trueaxis.io.faults import Fault
from trueaxis.io.safe_text import shown
from trueaxis.measurement.delimited import decimal

# Of --map; those that end with a point have a name behind it: of an axis, a column.
KEYS = (
    "id", "instrument", "axis", "target", "target.point", "direction", "frame", "reference", "reference.point", "zero",
    "length", "plane", "compensation", "normalised", "temperature", "at.", "home.", "column.", "unit.", "expansion.",
)  # fmt: skip
Source = Literal["user", "default"]
LONGEST_SHOWN = 60  # characters of a value in a message


@dataclass(frozen=True, slots=True, kw_only=True)
class Question:
    """What neither file nor user has said yet: the key, what it means and what a value looks like."""

    file: str
    run: str
    key: str
    meaning: str
    right: str

    @property
    def name(self) -> str:
        """The key of this run alone, as --map has it."""
        return f"{self.run}:{self.key}"

    @property
    def fault(self) -> Fault:
        """As a fault, for a user who cannot be asked."""
        problem = f"the file does not say {self.meaning}"
        return Fault(self.file, f"run {self.run}", problem, f"--map {self.key}={self.right}")


@dataclass(slots=True, kw_only=True)
class UserKeys:
    """Keys for all runs and, as `RUN:KEY`, for one run, or for the runs of a file by its name without suffix.

    used: keys that some run asked for; questions: what was asked for and is not there; faults: values that are wrong;
    wrong: their keys, as RUN:KEY.
    """

    given: Mapping[str, str]
    used: set[str] = field(default_factory=set)
    questions: list[Question] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)
    wrong: set[str] = field(default_factory=set)

    def of_run(self, file: str, run: str) -> "RunKeys":
        """The keys of one run of a file."""
        return RunKeys(keys=self, file=file, run=run)

    def unknown(self) -> list[Fault]:
        """A fault for every key that no file ever asks for."""
        found = []
        for given in self.given:
            key = given.rpartition(":")[2]
            if key not in KEYS and not any(known.endswith(".") and key.startswith(known) for known in KEYS):
                named = [known + "NAME" if known.endswith(".") else known for known in KEYS]
                close = get_close_matches(key, named, n=1)
                remedy = f"did you mean {close[0]}?" if close else f"known: {', '.join(named)}"
                found.append(Fault("--map", shown(given, LONGEST_SHOWN), "is no key", remedy))
        return found

    def unused(self) -> list[Fault]:
        """A fault for every key that no run asked for."""
        return [
            Fault("--map", shown(key, LONGEST_SHOWN), "is no key that these files ask for", "docs/import.md lists them")
            for key in self.given
            if key not in self.used
        ]


@dataclass(slots=True, kw_only=True)
class RunKeys:
    """The keys of one run. A reader returns None for what is missing or wrong, which is noted.

    sources: where the value of each key came from, values: the value as text, for what is written of it.
    """

    keys: UserKeys
    file: str
    run: str
    sources: dict[str, Source] = field(default_factory=dict)
    values: dict[str, str] = field(default_factory=dict)

    def said(self, key: str) -> str | None:
        """What the user said of a key, None where nothing."""
        stem = Path(self.file).stem
        for name in (f"{self.run}:{key}", f"{stem}:{key}", key):
            if name in self.keys.given:
                self.keys.used |= {f"{self.run}:{key}", f"{stem}:{key}", key}
                self.sources[key] = "user"
                self.values[key] = self.keys.given[name].strip()
                return self.values[key]
        return None

    def text(
        self, key: str, meaning: str, right: str, *, among: Sequence[str] = (), default: str | None = None
    ) -> str | None:
        """A text, one of a few where `among` lists them; a question where there is no default."""
        value = self.said(key)
        if value is None:
            self._missing(key, meaning, right, default)
            return default
        if not value or (among and value not in among):
            self.wrong(key, value, f"one of {' '.join(among)}" if among else right)
            return None
        return value

    def number(self, key: str, meaning: str, right: str, *, default: float | None = None) -> float | None:
        """A finite number; a question where there is no default."""
        value = self.said(key)
        if value is None:
            self._missing(key, meaning, right, None if default is None else f"{default:.12g}")
            return default
        number = decimal(value)
        if number is None:
            self.wrong(key, value, "a number")
        return number

    def vector(
        self, key: str, meaning: str, right: str, *, default: tuple[float, float, float] | None = None
    ) -> tuple[float, float, float] | None:
        """Three finite numbers with commas between them; a question where there is no default."""
        value = self.said(key)
        if value is None:
            self._missing(key, meaning, right, None if default is None else ",".join(f"{v:.12g}" for v in default))
            return default
        numbers = [decimal(part.strip()) for part in value.split(",")]
        x, y, z = numbers if len(numbers) == 3 else (None, None, None)
        if x is None or y is None or z is None or not math.isfinite(math.hypot(x, y, z)):
            self.wrong(key, value, "three numbers with commas between them, such as 0,0,-150.5")
            return None
        return x, y, z

    def wrong(self, key: str, value: str, right: str) -> None:
        """Note a value that is wrong."""
        problem = f'"{shown(value, LONGEST_SHOWN)}" is not right'  # of --map, or typed at a terminal
        self.keys.faults.append(Fault(self.file, f"run {self.run}, {key}", problem, right))
        self.keys.wrong.add(f"{self.run}:{key}")

    def why(self, key: str) -> str:
        """Why a key has its value though no file says it."""
        return "given by the user" if self.sources[key] == "user" else "by default"

    def sentences(self) -> tuple[str, ...]:
        """One for each key: its value, and why it has it."""
        return tuple(f"{key} = {self.values[key]}, {self.why(key)}" for key in self.sources)

    def _missing(self, key: str, meaning: str, right: str, default: str | None) -> None:
        if default is not None:
            self.sources[key] = "default"
            self.values[key] = default
        else:
            self.keys.questions.append(Question(file=self.file, run=self.run, key=key, meaning=meaning, right=right))
