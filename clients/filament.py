"""Has Filament's matc compile the material of an export, and Filament for the web run its function at the test vectors.

Usage: python clients/filament.py --pavo PAVO --folder DIR [--json]
DIR has the npm package filament, of the version whose materials Debian's matc writes. Exit codes are those of the command
pavo.
"""

import json
import struct
import subprocess

import browser
import vectors

POINTS = 64


def compiled(material, options, result):
    """Has matc compile a material."""
    if subprocess.run(["matc", *options, "-o", result, material]).returncode != 0:
        raise SystemExit(f"matc refused {material.name}")


def main():
    given = vectors.arguments()
    folder = vectors.exported(given, "filament")
    exported = folder / "pavo_thin_film.mat"
    compiled(exported, ["-p", "all", "-a", "all"], folder / "pavo_thin_film.filamat")

    # The same function in a material that shows its bits.
    text = exported.read_text()
    functions = text[text.index("fragment {") + len("fragment {") : text.index("void material(")]
    rows = vectors.vectors(folder)[:POINTS]
    numbers = [number for values, _ in rows for number in vectors.numbers(values)]
    numbers += [0.5] * (6 * POINTS - len(numbers))
    points = (vectors.HERE / "filament/points.mat").read_text()
    for name, value in {
        "functions": functions.strip(), "count": str(len(numbers)), "given": ", ".join(map(repr, numbers)),
    }.items():
        points = points.replace(f"{{{{ {name} }}}}", value)
    (folder / "points.mat").write_text(points)
    compiled(folder / "points.mat", ["-p", "mobile", "-a", "opengl"], folder / "points.filamat")

    package = given.folder / "node_modules/filament"
    answer = browser.answer({
        "/": (vectors.HERE / "filament/page.html").read_bytes(),
        "/points.filamat": (folder / "points.filamat").read_bytes(),
        **{f"/package/{name}": (package / name).read_bytes() for name in ["filament.js", "filament.wasm"]},
    })
    if "values" not in answer:
        raise SystemExit("Filament did not run the material:\n" + "\n".join(answer["messages"][:40]))
    values = answer["values"]

    def number(point, channel):
        pixels = [4 * (row * POINTS + point) for row in (2 * channel, 2 * channel + 1)]
        return struct.unpack("<f", bytes(values[pixel + byte] for pixel in pixels for byte in (0, 1)))[0]

    colors = [[number(point, channel) for channel in range(3)] for point in range(len(rows))]
    version = json.loads((package / "package.json").read_text())["version"]
    vectors.report(given, "filament", version, answer["device"], colors, [color for _, color in rows])


main()
