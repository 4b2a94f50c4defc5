"""The cases of worlds, put before the diagnosis one after the other, a line of JSON for each: what processes do."""

import json
import time
from collections.abc import Sequence
from pathlib import Path

from tests.worlds.diagnosis.answers import said_by_command, said_of
from tests.worlds.diagnosis.cases import bench_of
from tests.worlds.diagnosis.lines import line_of

ENGINES = {"process": said_of, "command": said_by_command}
A_TURN = 25  # cases of a world before the next one's


def read_lines(folder: Path) -> list[dict[str, object]]:
    """All cases in all files of a folder, in the order of worlds and cases."""
    texts = (path.read_text() for path in sorted(folder.glob("cases-*.jsonl")))
    found = [json.loads(line) for text in texts for line in text.splitlines()]
    return sorted(found, key=lambda line: (line["world"], line["case"]))


def measure_worlds(
    folder: Path, seeds: Sequence[int], cases: int, only: tuple[str, ...], engine: str, until: float
) -> None:
    """Append a line for every case that is not there yet; until: of time.time()."""
    done = {(line["world"], line["case"]) for line in read_lines(folder)}
    for start in range(0, cases, A_TURN):
        for seed in seeds:
            left = [k for k in range(start, min(start + A_TURN, cases)) if (seed, k) not in done]
            if not left:
                continue
            bench = bench_of(seed)
            with (folder / f"cases-{seed}.jsonl").open("a") as file:
                for number in left:
                    if time.time() > until:
                        return
                    line = line_of(bench, number, folder / "worlds" / str(seed), only, ENGINES[engine])
                    file.write(json.dumps(line) + "\n")
                    file.flush()
