"""Compiles the functions of an export for Metal as C++ under a stand-in for its standard library, and compares what they
compute with the CPU evaluation.

Usage: python clients/metal.py --pavo PAVO --folder DIR [--json]
This is no compiler of Metal: there is none on Linux. Exit codes are those of the command pavo.
"""

import subprocess

import vectors


def main():
    given = vectors.arguments()
    folder = vectors.exported(given, "metal")
    rows = vectors.vectors(folder)
    stand_in = vectors.HERE / "metal"
    program = folder / "evaluate"
    command = ["g++", "-std=c++17", "-Wall", "-Wextra", "-Werror", "-Wno-unused-parameter", "-isystem", stand_in]
    command += ["-I", folder, stand_in / "main.cpp", "-o", program]
    if subprocess.run(command).returncode != 0:
        raise SystemExit("the functions do not compile")
    points = "".join(f"{' '.join(map(repr, vectors.numbers(values)))}\n" for values, _ in rows)
    text = subprocess.run([program], input=points, stdout=subprocess.PIPE, text=True, check=True).stdout
    found = [[float(number) for number in line.split()] for line in text.splitlines()]
    version = subprocess.run(["g++", "-dumpversion"], stdout=subprocess.PIPE, text=True, check=True).stdout.strip()
    vectors.report(given, "metal", "as C++", f"g++ {version}", found, [color for _, color in rows])


main()
