"""Servers with wrong answers, browsers without a feature, unexpected actions of users: the page says what is wrong, or it goes on."""
import json
import os
import tempfile

import fixtures
from bench import same, test, true
from jobs_page import ADVICE
from page_bench import VERDICTS, drop, wait_for

SAID = "[...document.querySelectorAll('.program .verdict')].map((e) => e.textContent)"


NO_SERVICE_WORKER = "delete Navigator.prototype.serviceWorker;"


def is_told(bench, page, *words):
    """A check gives no verdict and states the reason."""
    bench.example(page, "cb-head")
    # Deferred: code that the driver calls directly is exempt from the policy.
    page.run("void setTimeout(() => document.querySelector('#check').click())")
    page.run("await until('checked', 1)")
    said = page.run(SAID)
    true(f"the reason: {said}", len(said) == 2 and all(word in text for word in words for text in said))
    same("no verdict", page.run(VERDICTS), [[f"examples/cb-head/{name}.nc", "incomplete"] for name in ("clear", "collision")])
    same("another check may be begun", page.run("[document.querySelector('#check').disabled, document.querySelector('#cancel').hidden]"), [False, True])


@test
def wrong_type(bench):
    """A server gives a module a wrong MIME type: the page still works."""
    bench.site.types = {"/fivecheck.wasm": "application/octet-stream"}
    page = bench.open()
    bench.works(page)
    bench.done(page)


@test
def no_module(bench):
    """The page reports a server that answers with something else, a policy that forbids modules, and a browser without modules."""
    # A service worker, which a page registers after some seconds, would answer with the page from before the policy.
    page = bench.open(before=NO_SERVICE_WORKER + """(() => { const real = fetch; window.fetch = (address) => String(address).endsWith('fivecheck.wasm')
        ? Promise.resolve(new Response('<!doctype html>', {headers: {'Content-Type': 'text/html'}})) : real(address); })();""")
    is_told(bench, page, "fivecheck.wasm", "cannot be loaded")
    page.close()
    page = bench.open(before=NO_SERVICE_WORKER + "delete window.WebAssembly;")
    is_told(bench, page, "has no WebAssembly")
    page.close()
    bench.site.policy = "script-src 'self'"
    page = bench.open("?not-of-the-cache")
    is_told(bench, page, "fivecheck.wasm", "cannot be loaded")
    page.close()
    bench.site.policy = None
    page = bench.open(before="{ const Own = Worker; window.Worker = class extends Own { constructor(address, options) { super(new URL('none.js', address), options); } }; }")
    is_told(bench, page, "worker.js cannot be loaded")
    page.close()


@test
def no_form_module(bench):
    """The form for a machine needs a part of the checker. If that part cannot be loaded, the form says so."""
    page = bench.open()
    bench.site.missing = {"/fivecheck-more.wasm"}
    page.run("document.querySelector('#fill-example').click()")
    page.run("document.querySelector('#write-machine').click()")
    page.run("await until('machine-written', 1)")
    same("the reason", page.run("document.querySelector('#form-fault').textContent").strip(), "fivecheck-more.wasm cannot be loaded: the server answers 404")
    bench.site.missing = set()
    page.run("document.querySelector('#write-machine').click()")
    page.run("await until('machine-written', 2)")
    true("a machine file", page.run("document.querySelector('#machine-xml').value").startswith("<?xml"))
    page.close()


@test
def no_examples(bench):
    """The page says that the examples cannot be loaded; the user's own files can still be checked."""
    bench.site.missing = {"/examples/index.json"}
    page = bench.open()
    true("it is told", "The examples cannot be loaded" in page.run("document.querySelector('#examples').textContent"))
    with tempfile.TemporaryDirectory() as work:
        bench.boxes(page, work)
        bench.check(page)
        same("verdict", page.run(VERDICTS), [["part.nc", "found"]])
    page.close()


@test
def no_storage(bench):
    """If the browser forbids storage, as in some private windows, the page works and shows no message about it."""
    page = bench.open(before="""for (const name of ['localStorage', 'sessionStorage', 'indexedDB', 'caches'])
        Object.defineProperty(window, name, {get() { throw new DOMException('denied', 'SecurityError'); }});
        if (window === top && navigator.serviceWorker) navigator.serviceWorker.register = () => (window.asked = true, Promise.reject(new DOMException('denied', 'SecurityError')));""")
    bench.works(page)
    page.run("await new Promise((done) => { const look = () => window.asked ? done() : requestAnimationFrame(look); look(); })")
    page.run("await until('report-shown', 2)")
    bench.done(page)


NAMES = ["<img src=x onerror=\"window.pwned=1\">.nc", "__proto__", "constructor", "a%2F..%2Fb.nc", "\u202ecn.trap", "&lt;b&gt;.nc", "' onclick='window.pwned=1.nc", "-f.nc", "x".ljust(200, "x") + ".nc"]


@test
def names(bench):
    """Files with unusual names are shown with their names and checked."""
    page = bench.open()
    with tempfile.TemporaryDirectory() as work:
        _, program = bench.boxes(page, work)
        with open(program, encoding="utf-8") as file:
            text = file.read()
        page.run("await fivecheckPage.add(%s.map((name) => [`boxes-00/${name}`, new Blob([%s])]))" % (json.dumps(NAMES), json.dumps(text)))
        same("they are programs", page.run("fivecheckPage.of('program').length"), 1 + len(NAMES))
        bench.check(page)
        cards = dict(page.run(VERDICTS))
        same("verdicts", cards, {name: "found" for name in ["part.nc", *NAMES]})
        same("names", page.run("[...document.querySelectorAll('.program h3')].map((e) => e.textContent)"), ["part.nc", *NAMES])
        same("nothing was run", page.run("window.pwned ?? 0"), 0)
        same("sideways", page.run("document.documentElement.scrollWidth"), 1280)
    bench.done(page, "page-names")


@test
def meanwhile(bench):
    """Files dropped during a check, a second tab, going back, reloading: a verdict always belongs to the files that were checked."""
    page = bench.open()
    bench.example(page, "cb-head")
    page.run("((done) => { window.checkedOnce = new Promise((told) => document.addEventListener('checked', told)); done.click(); })(document.querySelector('#check'))")
    page.run("await fivecheckPage.add([['new.nc', new Blob(['G21 G90\\nM2\\n'])]])")
    other = bench.open()
    bench.works(other, "another tab")
    other.close()
    page.run("await checkedOnce")
    same("what was checked", [path for path, _ in page.run(VERDICTS)], ["examples/cb-head/clear.nc", "examples/cb-head/collision.nc"])
    same("it is told to be older", page.run("document.querySelector('#outdated').checkVisibility()"), True)
    page.navigate(bench.site.address + "learn.html")
    page.run("await until('posed', 1)")
    page.run("void history.back()")
    wait_for(page, "document.querySelector('#check') && location.pathname === '/' && document.readyState === 'complete'")
    bench.example(page, "cb-head", page.run("counts['example-open']") + 1)
    page.run("document.querySelector('#check').click()")
    page.reload()
    page.run("await until('fivecheck-ready', 1)")
    same("a new page", page.run("[document.querySelectorAll('.program').length, document.querySelector('#check').disabled]"), [0, True])
    bench.works(page)
    bench.done(page)


@test
def bad_meshes(bench):
    """Meshes with invalid numbers, and one that claims more triangles than fit in memory: each is named, and the page goes on."""
    page = bench.open()
    with tempfile.TemporaryDirectory() as work:
        machine, _, _ = fixtures.boxes(work)
        folder = os.path.dirname(machine)
        for count, (head, size) in enumerate(((80 * b" " + (2 ** 32 - 1).to_bytes(4, "little"), 84 + 50 * 1000), (80 * b" " + (6_000_000).to_bytes(4, "little"), 84 + 50 * 6_000_000)), 1):
            page.run("(document.querySelector('#empty').click(), scrollTo(0, 0))")
            with open(os.path.join(folder, "table.stl"), "wb") as file:
                file.write(head)
                file.truncate(size)
            drop(page, folder)
            same("nothing is missing", page.run(ADVICE), "")
            bench.check(page, count)
            said = page.run("document.querySelector('.program').textContent")
            true(f"the mesh is named: {said[:300]}", page.run(VERDICTS) == [["part.nc", "incomplete"]] and ("table.stl" in said or "memory" in said))
    bench.done(page)
