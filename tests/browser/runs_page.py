"""Checks that are started, cancelled, repeated and counted: they release everything they opened, and very many do not block the page."""
import os
import tempfile
import threading

import fixtures
from bench import PHONE, same, test, true
from jobs_page import CARDS, native, write
from page_bench import drop

# Object URLs that were created and not revoked; listeners of the window without a signal.
WATCH_OPEN = """
window.open_urls = new Set();
window.listeners = 0;
for (const [name, note] of [['createObjectURL', (url) => open_urls.add(url)], ['revokeObjectURL', (url) => open_urls.delete(url)]]) {
    const made = URL[name];
    URL[name] = (what) => { const url = made.call(URL, what); note(url ?? what); return url; };
}
const listen = window.addEventListener;
window.addEventListener = (kind, act, more) => {
    if (kind === 'message') { listeners++; more?.signal?.addEventListener('abort', () => listeners--); }
    return listen.call(window, kind, act, more);
};
"""
SHOWN = """((button) => { const {top, bottom} = button.getBoundingClientRect(); return top >= 0 && bottom <= innerHeight; })(document.querySelector('#check'))"""


@test
def given_back(bench):
    """Each check releases what the previous check had open."""
    page = bench.open(before=WATCH_OPEN)
    bench.example(page, "cb-head")
    for count in range(1, 4):
        bench.check(page, count)
        same(f"open after {count} checks", page.run("[open_urls.size, listeners]"), [2, 2])
    bench.done(page)


@test
def cancel_at_once(bench):
    """Cancel also works while modules are loading; the next check waits for them and has its verdict."""
    held = bench.site.held["/fivecheck.wasm"] = threading.Event()
    page = bench.open()
    bench.example(page, "cb-head")
    page.run("document.querySelector('#check').click()")
    page.run("document.querySelector('#cancel').click()")
    page.run("await until('checked', 1)")
    same("cancelled", page.run("[...document.querySelectorAll('.program .verdict')].map((e) => e.textContent)"), ["Cancelled: nothing is known of this program."] * 2)
    held.set()
    bench.check(page, 2)
    bench.verdicts(page)
    bench.done(page)


def job_file(folder, count, program):
    """A job file with this number of jobs, one program each."""
    write(os.path.join(folder, "jobs.xml"), '<jobs version="1">\n' + "".join(
        f'<job name="op{i}" machine="machine.xml" setup="setup.xml"><program file="{program(i)}"/></job>\n' for i in range(count)) + "</jobs>\n")


@test
def very_many(bench):
    """With very many jobs only the first ones, and those that are not clear, have a card; all are counted and are in the list that can be saved."""
    page = bench.open(before=WATCH_OPEN)
    with tempfile.TemporaryDirectory() as work:
        _, _, program = fixtures.boxes(work)
        folder = os.path.dirname(program)
        with open(program, encoding="utf-8") as file:
            hit = file.read()
        write(os.path.join(folder, "safe.nc"), hit.replace("G0 Z10\n", "G0 Z120\n"))
        job_file(folder, 300, lambda i: "part.nc" if i in (5, 250) else "safe.nc")
        drop(page, folder)
        bench.check(page)
        cards = page.run(CARDS)
        same("cards", len(cards), 201)
        same("those that hit", [card for card in cards if card[2] != "clear"], [["op5", "part.nc", "found"], ["op250", "part.nc", "found"]])
        same("counts", page.run("document.querySelector('.counts').textContent"), "300 of 300 programs checked: 298 clear, 2 found")
        page.run("((made) => URL.createObjectURL = (blob) => (window.list = blob.text(), made.call(URL, blob)))(URL.createObjectURL)")
        page.run("document.querySelector('.save-list').click()")
        lines = page.run("await window.list").splitlines()
        same("lines", sorted(line.split("\t")[2] for line in lines), ["clear"] * 298 + ["found"] * 2 + ["verdict"])
        true("each job", {line.split("\t")[0] for line in lines[1:]} == {f"op{i}" for i in range(300)})
    bench.done(page, "page-very-many")


@test
def ten_thousand(bench):
    """A job file of 10,000 jobs with as many programs: the page responds meanwhile, and the check can be cancelled."""
    page = bench.open()
    with tempfile.TemporaryDirectory() as work:
        _, _, program = fixtures.boxes(work)
        job_file(os.path.dirname(program), 10000, lambda i: f"nc/{i}.nc")
        drop(page, os.path.dirname(program))
        page.run("void (window.longest = 0, new PerformanceObserver((list) => list.getEntries().forEach(({duration}) => longest = Math.max(longest, duration))).observe({entryTypes: ['longtask']}))")
        page.run("await fivecheckPage.add(Array.from({length: 10000}, (_, i) => [`boxes-00/nc/${i}.nc`, new Blob(['G21 G90\\nG0 X1\\nM2\\n'])]))")
        print(f"     10,000 programs are dropped: the page is busy for {page.run('longest'):.0f} ms at most")
        page.run("void (longest = 0)")
        same("nothing is missing", page.run("document.querySelector('#job').textContent"), "The job file does not name boxes-00/part.nc: not checked.")
        page.run("void document.querySelector('#check').click()")
        page.run("await new Promise((done) => new MutationObserver(() => /^[1-9]\\d. of/.test(document.querySelector('.counts')?.textContent) && done())"
                 ".observe(document.querySelector('#results'), {childList: true, subtree: true}))")
        print(f"     10,000 jobs are checked: the page is busy for {page.run('longest'):.0f} ms at most")
        true("cards and rows", page.run("document.querySelectorAll('.program').length <= 400 && document.querySelectorAll('#file-list li').length <= 501"))
        page.run("document.querySelector('#cancel').click()")
        page.run("await until('checked', 1)")
        true("all are told", page.run("document.querySelector('.counts').textContent").startswith("10000 of 10000 programs checked"))
    bench.done(page)


@test
def what_changed(bench):
    """After an example is opened, on a phone and on a desk, the next button is visible and has the focus."""
    for options in ({}, PHONE):
        page = bench.open(**options)
        bench.example(page, "cb-head")
        same("the button is seen, and has the focus", page.run(f"[{SHOWN}, document.activeElement.id]"), [True, "check"])
        same("what would be checked", page.run("document.querySelector('#ready').textContent"), "Ready to check clear.nc, collision.nc.")
        page.press("Enter")
        page.run("await until('checked', 1)")
        page.run("await until('report-shown', 2)")
        top = "((card) => Math.round(card.getBoundingClientRect().top))(document.querySelectorAll('.program')[%d])"
        true("the first result is seen", 0 <= page.run(top % 0) < options.get("height", 800) / 2)
        same("what is not clear", page.run("[document.querySelector('.counts').textContent, document.querySelector('.ways').textContent]"),
             ["2 of 2 programs checked: 1 clear, 1 found", "Not clear:collision.nc"])
        page.picture(os.path.join(bench.keep, f"page-checked-{options.get('width', 1280)}.png"))
        page.run("document.querySelector('.ways button').focus()")
        page.press("Enter")
        same("the way to it", page.run(f"[{top % 1}, document.activeElement.dataset.path]"), [0, "examples/cb-head/collision.nc"])
        bench.done(page, f"page-opened-{options.get('width', 1280)}")


@test
def one_control_for_all(bench):
    """--dialect=auto considers all programs of one run together, as the command line does; the same for the programs of a job."""
    page = bench.open()
    with tempfile.TemporaryDirectory() as work:
        machine, _, program = fixtures.boxes(work)
        folder = os.path.dirname(machine)
        write(os.path.join(folder, "other.h"), "BEGIN PGM A MM\nL X+1 R0 FMAX\nEND PGM A MM\n")
        write(os.path.join(folder, "part.nc"), "o100 sub\no100 endsub\nG21 G90\nG0 X1\nM2\n")
        for jobs in (False, True):
            page.run("(document.querySelector('#empty').click(), scrollTo(0, 0))")
            if jobs:
                write(os.path.join(folder, "jobs.xml"), '<jobs version="1"><job name="a" machine="machine.xml"><program file="part.nc"/><program file="other.h"/></job>'
                      '<job name="b" machine="machine.xml"><program file="part.nc"/></job></jobs>')
            drop(page, folder)
            page.run("((field) => field.value = 'auto')(document.querySelector('[name=dialect]'))")
            bench.check(page, 1 + 2 * jobs)
            done, events = native(bench, folder, "--dialect=auto", *(["jobs.xml"] if jobs else ["--setup=setup.xml", "machine.xml", *(path for _, path, _ in page.run(CARDS))]))
            same("verdicts", sorted(verdict for *_, verdict in page.run(CARDS)), sorted(event["verdict"] for event in events if event["kind"] == "program"))
            same(f"exit status: {done.stderr}", done.returncode, 2)
            said = [line for line in done.stderr.splitlines() if "error: --dialect=auto" in line]
            same("words", page.run("[...new Set([...document.querySelectorAll('.message.error')].map((e) => e.textContent))]"), said)
            if not jobs:
                page.run("fivecheckPage.setFiles(fivecheckPage.files.filter(({path}) => !path.endsWith('other.h')))")
                bench.check(page, 2)
                same("one alone", [verdict for *_, verdict in page.run(CARDS)], ["clear"])
    bench.done(page)
