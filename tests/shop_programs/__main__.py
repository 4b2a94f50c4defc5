"""Command line: fetch the sample programs and the interpreter; grade programs and print a table."""

import argparse
import json
import random
import subprocess
import tempfile
from collections import Counter
from dataclasses import asdict
from pathlib import Path

from tests.shop_programs import klartext
from tests.shop_programs.grade import Grade, all_grades, different

# of Debian 12: programs and interpreter, what it needs, and headers for splines
PACKAGES = ("linuxcnc-uspace", "libboost-python1.74.0", "linuxcnc-uspace-dev")
SUFFIXES = frozenset({".ngc", ".nc", ".gcode", ".gc", ".tap"})
LARGEST = 3_000_000  # bytes; longer programs are left out, and counted


def fetch(folder: Path) -> None:
    """Download the packages and unpack them into the folder; nothing is installed."""
    folder.mkdir(parents=True, exist_ok=True)
    for package in PACKAGES:
        subprocess.run(["apt-get", "download", package], cwd=folder, check=True)
    for archive in sorted(folder.glob("*.deb")):
        subprocess.run(["dpkg-deb", "-x", archive.name, "."], cwd=folder, check=True)


def table(grades: list[Grade], too_long: int) -> str:
    """What became of the programs, by kind; then why those that are refused are, and what is wrong."""
    rows = ["| programs | number | accepted | refused | wrong |", "|---|---|---|---|---|"]
    for kind, number in Counter(grade.kind for grade in grades).most_common():
        count = Counter(grade.outcome for grade in grades if grade.kind == kind)
        rows.append(f"| {kind} | {number} | {count['accepted']} | {count['refused']} | {count['wrong']} |")
    rows.append(f"\n{too_long} programs above {LARGEST} bytes left out\n")
    accepted = [grade for grade in grades if grade.outcome == "accepted"]
    if accepted:
        after, before = (1000 * max(getattr(g, stage) for g in accepted) for stage in ("after", "before"))
        moves = [sum(g.moves[side] for g in accepted) for side in (0, 1)]
        rows.append(f"accepted: at most {after:.2f} um along the path after, {before:.1f} um before")
        rows.append(f"{moves[0]} motions became {moves[1]}")
        rows += [f"  {number} {why}" for why, number in Counter(g.reason for g in accepted).most_common() if why]
    for outcome in ("refused", "wrong"):
        reasons = Counter(g.reason for g in grades if g.outcome == outcome and g.kind == "plain")
        rows += [f"plain, {outcome}: {number} {why}" for why, number in reasons.most_common()]
    return "\n".join(rows)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(required=True, dest="command")
    commands.add_parser("fetch").add_argument("folder", type=Path)
    grading = commands.add_parser("grade")
    grading.add_argument("package", type=Path, help="the folder of `fetch`, or / where LinuxCNC is installed")
    grading.add_argument("folders", type=Path, nargs="+")
    grading.add_argument("--json", type=Path)
    grading.add_argument("--via-linuxcnc", action="store_true", help="unroll the programs first")
    grading.add_argument("--share", type=float, default=1.0, help="of the different programs, drawn by --seed")
    grading.add_argument("--seed", type=int, default=1)
    commands.add_parser("klartext", help="Heidenhain's").add_argument("folders", type=Path, nargs="+")
    args = parser.parse_args()
    if args.command == "fetch":
        fetch(args.folder)
        return
    if args.command == "klartext":
        programs = different(sorted(path for at in args.folders for path in at.rglob("*") if klartext.is_program(path)))
        with tempfile.TemporaryDirectory() as folder:
            graded = [klartext.grade(program, Path(folder) / "out.h") for program in programs]
        print(table(graded, 0))
        print("\n".join(f"{one.outcome}: {one.name}: {one.reason}" for one in graded if one.reason))
        return
    paths = {path for folder in args.folders for path in folder.rglob("*")}
    found = sorted(path for path in paths if path.suffix.lower() in SUFFIXES and path.is_file())
    within = [path for path in found if path.stat().st_size <= LARGEST]
    short = different(within)
    if args.share < 1.0:
        short = sorted(random.Random(args.seed).sample(short, round(args.share * len(short))))
    grades = []
    with tempfile.TemporaryDirectory() as folder:
        for one in all_grades(short, args.package, Path(folder), args.via_linuxcnc):
            grades.append(one)
            if args.json is not None:
                with args.json.open("a") as file:
                    file.write(json.dumps(asdict(one)) + "\n")
    print(table(grades, len(found) - len(within)))


if __name__ == "__main__":
    main()
