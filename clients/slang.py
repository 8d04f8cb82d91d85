"""Has slangc compile a kernel that imports the module of an export, runs it on lavapipe, and compares it with the CPU.

Usage: python clients/slang.py --pavo PAVO --folder DIR [--json]
Exit codes are those of the command pavo.
"""

import importlib.metadata
import importlib.util
import os
import pathlib
import subprocess

import kernels
import vectors


def main():
    given = vectors.arguments()
    folder = vectors.exported(given, "slang")
    # The package itself would load PyTorch, which is not needed.
    package = pathlib.Path(importlib.util.find_spec("slangtorch").origin).parent
    slangc = package / "bin" / "slangc"
    slangc.chmod(0o755)
    kernel = folder / "kernel.spv"
    # The optimiser of SPIR-V is not in the package; Debian's spirv-val does not know the name of the language yet.
    command = [slangc, vectors.HERE / "slang/kernel.slang", "-I", folder, "-target", "spirv", "-profile", "spirv_1_3"]
    command += ["-entry", "main", "-stage", "compute", "-fvk-use-entrypoint-name", "-O0", "-o", kernel]
    ended = subprocess.run(command, env={**os.environ, "SLANG_USE_SPV_SOURCE_LANGUAGE_UNKNOWN": "1"})
    if ended.returncode != 0:
        raise SystemExit("slangc refused the module")
    kernels.report(given, "slang", importlib.metadata.version("slangtorch"), kernel)


main()
