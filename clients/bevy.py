"""Has naga_oil compose a kernel with the module of an export, as Bevy does, runs it on lavapipe, and compares it with the CPU.

Usage: python clients/bevy.py --pavo PAVO --folder DIR [--json]
The composing is done by the example naga-oil. Exit codes are those of the command pavo.
"""

import re
import subprocess

import kernels
import vectors

EXAMPLE = vectors.HERE.parent / "examples/naga-oil"


def main():
    given = vectors.arguments()
    folder = vectors.exported(given, "bevy")
    kernel = folder / "kernel.spv"
    command = ["cargo", "run", "--quiet", "--manifest-path", EXAMPLE / "Cargo.toml", "--"]
    command += [folder / "pavo_thin_film.wgsl", vectors.HERE / "bevy/kernel.wgsl", kernel]
    ended = subprocess.run(command, stdout=subprocess.DEVNULL)
    if ended.returncode != 0:
        raise SystemExit("naga_oil refused the module")
    lock = (EXAMPLE / "Cargo.lock").read_text()
    version = re.search(r'name = "naga_oil"\nversion = "([^"]+)"', lock).group(1)
    kernels.report(given, "bevy", f"naga_oil {version}", kernel)


main()
