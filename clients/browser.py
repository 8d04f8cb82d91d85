"""Runs a page in a headless Chromium on lavapipe, and gives what it sends back."""

import http.server
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

DRIVER = "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json"
FLAGS = [
    "--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--enable-unsafe-swiftshader",
]
KINDS = {".js": "text/javascript", ".wasm": "application/wasm", "": "text/html"}
SECONDS_AT_MOST = 240


def missing(message):
    """Ends as the command does where something is not here."""
    print(f"error: {message}. Nothing was rendered", file=sys.stderr)
    sys.exit(3)


def answer(pages):
    """Serves texts by their paths, opens `/`, and waits for what it posts to `/finished`: a JSON object."""
    found = next(filter(None, map(shutil.which, ["chromium", "chromium-browser", "google-chrome"])), None)
    if found is None:
        missing("no Chromium is here; on Debian, `apt-get install chromium` brings it")
    if not pathlib.Path(DRIVER).exists():
        missing(f"{DRIVER} is not here; on Debian, `apt-get install mesa-vulkan-drivers` brings it")
    finished = threading.Event()
    answers = []

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            body = pages.get(self.path)
            self.send_response(404 if body is None else 200)
            self.send_header("content-type", KINDS.get(pathlib.Path(self.path).suffix, "application/octet-stream"))
            # What a build with threads asks for.
            self.send_header("cross-origin-opener-policy", "same-origin")
            self.send_header("cross-origin-embedder-policy", "require-corp")
            self.end_headers()
            self.wfile.write(body or b"")

        def do_POST(self):
            answers.append(json.loads(self.rfile.read(int(self.headers["content-length"]))))
            self.send_response(204)
            self.end_headers()
            finished.set()

        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = [found, *FLAGS, f"--user-data-dir={profile}", f"http://127.0.0.1:{server.server_port}/"]
        with open(pathlib.Path(profile) / "log", "w") as log:
            process = subprocess.Popen(command, stdout=log, stderr=log, env={"VK_DRIVER_FILES": DRIVER, "HOME": profile, "PATH": "/usr/bin:/bin"})
            try:
                finished.wait(SECONDS_AT_MOST)
            finally:
                process.terminate()
                process.wait()
                server.shutdown()
    if not answers:
        sys.exit(f"error: the page sent nothing within {SECONDS_AT_MOST} seconds")
    return answers[0]
