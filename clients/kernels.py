"""Runs a compute kernel on lavapipe at the test vectors, by the example `dispatch` of pavo-check."""

import subprocess
import sys

import vectors


def report(given, client, version, kernel):
    """Runs SPIR-V whose entry point is `main`, and ends as `vectors.report` does."""
    rows = vectors.vectors(given.folder / "exports" / client)
    points = given.folder / "points" / f"{client}.txt"
    points.parent.mkdir(parents=True, exist_ok=True)
    points.write_text("".join(f"{' '.join(map(repr, vectors.numbers(values)))}\n" for values, _ in rows))
    dispatch = given.pavo.parent / "examples" / "dispatch"
    ended = subprocess.run([dispatch, kernel, "main", points], stdout=subprocess.PIPE, text=True)
    if ended.returncode != 0:
        sys.exit(ended.returncode)
    found = [[float(number) for number in line.split()] for line in ended.stdout.splitlines()]
    vectors.report(given, client, version, "lavapipe", found, [color for _, color in rows])
