"""What the clients in Python share: the export, its test vectors, and the verdict."""

import argparse
import csv
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent

# The largest difference from the CPU evaluation in any channel.
TOLERANCE = 1e-5

# The parameters of the exported functions, and the columns of the test vectors that they take.
PARAMETERS = {
    "CosTheta": ["cos_theta1"],
    "ThicknessNm": ["thickness_nm"],
    "FilmIor": ["film_ior"],
    "BaseColor": ["f0_r", "f0_g", "f0_b"],
}


def arguments():
    """The command line: the program pavo, the folder for exports, and the form of the answer."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--pavo", required=True, type=pathlib.Path, help="the command pavo")
    parser.add_argument("--folder", required=True, type=pathlib.Path, help="where exports and pictures go")
    parser.add_argument("--json", action="store_true")
    return parser.parse_args()


def exported(given, engine):
    """Exports clients/scene.toml for an engine; the folder of the export."""
    folder = given.folder / "exports" / engine
    command = [given.pavo, "export", str(HERE / "scene.toml"), "--engine", engine, "-o", str(folder)]
    ended = subprocess.run(command, stdout=subprocess.DEVNULL)
    if ended.returncode != 0:
        sys.exit(ended.returncode)
    return folder


def vectors(folder):
    """The test vectors of an export: for each the values of the parameters, and the colour by the CPU in f64."""
    lines = [line for line in (folder / "test-vectors.csv").read_text().splitlines() if not line.startswith("#")]
    found = []
    for row in csv.DictReader(lines):
        values = {name: [float(row[column]) for column in columns] for name, columns in PARAMETERS.items()}
        found.append((values, [float(row[channel]) for channel in "rgb"]))
    return found


def numbers(values):
    """The six numbers of a point, in the order of PARAMETERS."""
    return [number for name in PARAMETERS for number in values[name]]


def report(given, client, version, device, found, expected):
    """Prints how far the colours are apart, and ends with 0 or 1."""
    worst = max(
        abs(found - expected) if abs(found) < float("inf") else float("inf")
        for colors in zip(found, expected, strict=True)
        for found, expected in zip(*colors, strict=True)
    )
    result = {
        "client": client, "version": version, "device": device, "points": len(found), "max": worst,
        "tolerance": TOLERANCE, "passed": worst <= TOLERANCE,
    }
    if given.json:
        print(json.dumps(result, indent=2))
    else:
        verdict = "passed" if result["passed"] else "FAILED"
        print(f"{client} {version} on {device}: {len(found)} points, max error {worst:.1e} of {TOLERANCE:.0e}: {verdict}")
    sys.exit(0 if result["passed"] else 1)
