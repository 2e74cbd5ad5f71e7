"""What the tests of the page share: a server for its folder, the page in a browser, the contents of its cards."""
import contextlib
import functools
import http.server
import json
import os
import subprocess
import sys
import threading

import fixtures
from bench import same
from driver import BrowserError


class Site:
    """A server of the folder on 127.0.0.1, with a log of requests."""

    def __init__(self, folder):
        self.folder = folder
        self.asked = []
        self.missing = set()  # paths that are missing for now
        self.held = {}  # paths whose answer waits for an event
        self.types = {}  # wrong types for paths
        self.policy = None  # a Content-Security-Policy for all
        site = self

        class Handler(http.server.SimpleHTTPRequestHandler):
            # One connection for many files, as on other servers.
            protocol_version = "HTTP/1.1"
            disable_nagle_algorithm = True
            extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, ".wasm": "application/wasm",
                              ".js": "text/javascript"}

            def send_head(self):
                if self.path in site.held:
                    site.held[self.path].wait()
                if self.path not in site.missing:
                    return super().send_head()
                return self.send_error(404)

            def guess_type(self, path):
                return site.types.get(self.path) or super().guess_type(path)

            def end_headers(self):
                if site.policy:
                    self.send_header("Content-Security-Policy", site.policy)
                super().end_headers()

            def log_message(self, *_):
                site.asked.append((self.command, self.path, int(self.headers.get("Content-Length") or 0)))

        class Server(http.server.ThreadingHTTPServer):
            def handle_error(self, request, client_address):
                # A closed or reloaded page does not wait for its requests.
                if not isinstance(sys.exc_info()[1], ConnectionError):
                    super().handle_error(request, client_address)

        self.server = Server(("127.0.0.1", 0), functools.partial(Handler, directory=folder))
        self.address = f"http://127.0.0.1:{self.server.server_port}/"
        self.thread = threading.Thread(target=self.server.serve_forever, daemon=True)
        self.thread.start()

    def close(self):
        for event in self.held.values():
            event.set()
        self.server.shutdown()
        self.server.server_close()
        self.thread.join()


EVENTS = ["fivecheck-ready", "example-open", "files-shown", "checked", "machine-written", "setup-written", "report-shown", "machine-open", "posed", "edited",
          "sampled", "wall-checked"]
# Counts events; until(name, count) is a promise that is kept when the event has come this often.
WATCH = """
window.counts = {};
window.waiters = {};
for (const name of %s) {
    counts[name] = 0;
    document.addEventListener(name, () => { counts[name]++; (waiters[name] || []).splice(0).forEach((done) => done()); });
}
window.until = (name, count) => counts[name] >= count ? Promise.resolve()
    : new Promise((done) => (waiters[name] ||= []).push(done)).then(() => until(name, count));
""" % json.dumps(EVENTS)


def drop(page, *paths):
    """Drops folders, and chooses files by the button, which also works in a browser without a command for dropping."""
    shown = page.run("counts['files-shown']")
    if any(map(os.path.isdir, paths)):
        page.drop(640, 200, list(paths))
    else:
        page.choose("#choose", list(paths))
    page.run(f"await until('files-shown', {shown + 1})")


def wait_for(page, script):
    """Waits until an expression is true, also while one page replaces another."""
    while True:
        with contextlib.suppress(BrowserError):
            if page.run(f"await new Promise((done) => requestAnimationFrame(() => done({script})))"):
                return


class Bench:
    def __init__(self, arguments, site, browser):
        self.fivecheck = arguments.fivecheck
        self.keep = arguments.keep
        self.site = site
        self.browser = browser

    def open(self, path="", before="", **options):
        """Opens a page of the site; `before` runs before its scripts."""
        page = self.browser.page(**options)
        page.before(WATCH + before)
        page.navigate(self.site.address + path)
        page.run("await until('fivecheck-ready', 1)")
        return page

    def example(self, page, name, count=1):
        page.run(f"document.querySelector('[data-example={name}]').click()")
        page.run(f"await until('example-open', {count})")

    def check(self, page, count=1):
        page.run("document.querySelector('#check').click()")
        page.run(f"await until('checked', {count})")

    def verdicts(self, page, what="verdicts"):
        """One of the example's two programs is clear."""
        same(what, sorted(verdict for _, verdict in page.run(VERDICTS)), ["clear", "found"])

    def works(self, page, what="verdicts"):
        """An example can be opened and checked, and has its verdicts."""
        self.example(page, "cb-head", page.run("counts['example-open']") + 1)
        self.check(page, page.run("counts.checked") + 1)
        self.verdicts(page, what)

    def boxes(self, page, work):
        """Drops the folder of a small machine. Returns this folder and the program."""
        machine, _, program = fixtures.boxes(work)
        drop(page, os.path.dirname(machine))
        return os.path.dirname(machine), program

    def native(self, name, program, *options):
        return subprocess.run([self.fivecheck, *options, f"--setup=examples/{name}/setup.xml", f"machines/{name}/machine.xml",
                               f"examples/{name}/{program}.nc"], capture_output=True, text=True, check=False)

    def done(self, page, picture=None):
        """There was no exception and no message, and all requests were for files of the page and had no body."""
        if picture:
            page.picture(os.path.join(self.keep, f"{picture}.png"))
        same("exceptions", page.exceptions(), [])
        same("foreign requests", [url for url in page.requests() if not url.startswith(self.site.address)], [])
        same("requests with a body", [entry for entry in self.site.asked if entry[0] != "GET" or entry[2]], [])
        page.close()


VERDICTS = "[...document.querySelectorAll('.program')].map((card) => [card.dataset.path, card.dataset.verdict])"
WORDS = "Object.fromEntries([...document.querySelectorAll('.program')].map((card) => [card.dataset.path, card.querySelector('.words').textContent]))"
