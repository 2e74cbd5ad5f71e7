"""A new build on the server: all files of a loaded page belong to one build until the page is loaded again."""
import contextlib
import os
import shutil
import subprocess
import tempfile
import time

from bench import same, test, true
from driver import BrowserError
from page_bench import Bench, Site

CACHES = "(await caches.keys()).length"
# Requests an update of the page until a newer build is in this state; the browser may also request it by itself.
UPDATED = """await (async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    const come = async () => {
        const found = new Promise((done) => registration.addEventListener('updatefound', () => done(registration.installing), {once: true}));
        await registration.update();
        const newer = registration.waiting ?? registration.installing ?? await found;
        while (newer.state === 'installing')
            await new Promise((done) => newer.addEventListener('statechange', done, {once: true}));
        return newer.state;
    };
    while (await come() !== '%s');
})()"""
# A partly loaded build is discarded.
ONE_CACHE = "await (async () => { while ((await caches.keys()).length > 1) await new Promise((done) => setTimeout(done, 20)); })()"
TITLE = "document.querySelector('h1').textContent"


def change(folder):
    """Puts a file of another build into the folder: the page with a different title."""
    page = os.path.join(folder, "index.html")
    with open(page, encoding="utf-8") as file:
        text = file.read()
    # The server distinguishes versions by seconds.
    later = os.stat(page).st_mtime + 10
    with open(page, "w", encoding="utf-8") as file:
        file.write(text.replace("<h1>fivecheck</h1>", "<h1>newer</h1>"))
    os.utime(page, (later, later))


def tell(folder):
    """Writes the service worker of the build that is in the folder."""
    names = [os.path.relpath(os.path.join(path, name), folder) for path, _, files in os.walk(folder) for name in files]
    names = [name for name in names if name != "service_worker.js" and (not name.startswith("examples/") or name == "examples/index.json")]
    worker = os.path.join(folder, "service_worker.js")
    # In one step: a browser that requests an update by itself would take an empty worker.
    with open(worker + ".new", "wb") as file:
        subprocess.run(["sh", "scripts/web-build", folder, "src/web/app/service_worker.js", *names], stdout=file, check=True)
    os.replace(worker + ".new", worker)


@contextlib.contextmanager
def copy_of_page(bench):
    """A copy of the page on a server, which may change: its folder and a bench."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(bench.site.folder, folder, dirs_exist_ok=True)
        site = Site(folder)
        try:
            yield folder, Bench(bench, site, bench.browser)
        finally:
            if site.thread.is_alive():
                site.close()


def load_again(page, title):
    """
    Loads the page until it has this title: a build that hands over to a newer one loads it twice, and does not yet while a
    page that was closed has not quite gone.
    """
    page.reload()
    end = time.monotonic() + 60
    while time.monotonic() < end:
        try:
            if not page.run("document.readyState === 'complete' && window.counts?.['fivecheck-ready'] > 0"):
                continue
            if page.run(TITLE) == title:
                return
            page.reload()
        except BrowserError:
            pass  # the document was replaced meanwhile
    raise AssertionError(f"the title is {page.run(TITLE)}, not {title}")


def visited(bench):
    """A page whose requests are answered by its service worker."""
    page = bench.open()
    page.run("await navigator.serviceWorker.ready")
    load_again(page, "fivecheck")
    return page


@test
def newer_build(bench):
    """A page keeps its build until it is loaded again, also for parts that it loads later; then all files are new."""
    with copy_of_page(bench) as (folder, visitor):
        page = visited(visitor)
        change(folder)
        os.remove(os.path.join(folder, "fivecheck-more.wasm"))
        shutil.copy(os.path.join(folder, "fivecheck-klartext.wasm"), os.path.join(folder, "fivecheck-more.wasm"))
        tell(folder)
        page.run(UPDATED % "installed")
        same("caches", page.run(CACHES), 2)
        true("a part is that of the page's build", page.run("(await (await fetch('fivecheck-more.wasm')).arrayBuffer()).byteLength"
             " !== (await (await fetch('fivecheck-klartext.wasm')).arrayBuffer()).byteLength"))
        other = visitor.open("learn.html")
        load_again(page, "fivecheck")
        other.close()
        load_again(page, "newer")
        same("caches", page.run(CACHES), 1)
        true("a part of the newer build", page.run("(await (await fetch('fivecheck-more.wasm')).arrayBuffer()).byteLength"
             " === (await (await fetch('fivecheck-klartext.wasm')).arrayBuffer()).byteLength"))
        visitor.works(page)
        visitor.done(page)


@test
def half_a_build(bench):
    """While the server has files of two builds, the page keeps its old build; once all files are there, it takes the new one."""
    with copy_of_page(bench) as (folder, visitor):
        page = visited(visitor)
        change(folder)
        tell(folder)
        shutil.copy2(os.path.join(bench.site.folder, "index.html"), folder)
        page.run(UPDATED % "redundant")
        page.run(ONE_CACHE)
        load_again(page, "fivecheck")
        change(folder)
        page.run(UPDATED % "installed")
        load_again(page, "newer")
        page.close()


# Runs before the service worker's own script: once it answers for the page, the browser can open no cache.
CLOSED = """{
    const open = caches.open.bind(caches);
    caches.open = (name) => registration.active ? Promise.reject(new DOMException('none is opened', 'UnknownError')) : open(name);
}
"""


@test
def no_cache(bench):
    """If the browser cannot open its cache, or has emptied it, the page is loaded from the server and works."""
    for closed in (True, False):
        with copy_of_page(bench) as (folder, visitor):
            worker = os.path.join(folder, "service_worker.js")
            with open(worker, encoding="utf-8") as file:
                text = file.read()
            with open(worker, "w", encoding="utf-8") as file:
                file.write(CLOSED * closed + text)
            page = visited(visitor)
            if not closed:
                page.run("await Promise.all((await caches.keys()).map((name) => caches.delete(name)))")
            before = len(visitor.site.asked)
            load_again(page, "fivecheck")
            true("the service worker is there, and the server was asked", page.run("navigator.serviceWorker.controller !== null")
                 and "/" in [path for _, path, _ in visitor.site.asked[before:]])
            visitor.works(page)
            visitor.done(page)
