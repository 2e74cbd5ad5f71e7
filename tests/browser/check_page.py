"""Uses the page of the checker (make web) in a real Chromium or Firefox, as a person would: make check-page, check-firefox.
Pictures go to --keep.

usage: check_page.py [--firefox] --fivecheck PROGRAM --page FOLDER --keep FOLDER [TEST...]
"""
import argparse
import contextlib
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bench import PHONE, TESTS, browser_of, carry_out, same, test, true  # noqa: E402
from page_bench import VERDICTS, WORDS, Bench, Site  # noqa: E402
import access_page  # noqa: E402, F401
import adverse_page  # noqa: E402, F401
import builds_page  # noqa: E402, F401
import embed_page  # noqa: E402, F401
import figures_page  # noqa: E402, F401
import forms_page  # noqa: E402, F401
import hostile_page  # noqa: E402, F401
import jobs_page  # noqa: E402, F401
import learn_page  # noqa: E402, F401
import runs_page  # noqa: E402, F401
import setup_page  # noqa: E402, F401


def untimed(text):
    return "\n".join(line for line in text.splitlines() if " blocks" not in line or "; time " not in line)


def verdicts_are_those_of_the_command_line(bench, name):
    page = bench.open()
    bench.example(page, name)
    bench.check(page)
    same("verdicts", sorted(page.run(VERDICTS)), [[f"examples/{name}/clear.nc", "clear"], [f"examples/{name}/collision.nc", "found"]])
    words = page.run(WORDS)
    for program in ("clear", "collision"):
        same(f"words of {program}", untimed(words[f"examples/{name}/{program}.nc"]), untimed(bench.native(name, program).stdout))
    bench.done(page, f"page-{name}")


@test
def ac_trunnion(bench):
    verdicts_are_those_of_the_command_line(bench, "ac-trunnion")


@test
def b_head_c_table(bench):
    verdicts_are_those_of_the_command_line(bench, "b-head-c-table")


@test
def cb_head(bench):
    verdicts_are_those_of_the_command_line(bench, "cb-head")


@test
def report(bench):
    """The report is shown in its frame, and the saved report has the same bytes as that of the command line."""
    page = bench.open()
    bench.example(page, "cb-head")
    bench.check(page)
    saved = page.run("""await window.fivecheckPage.checks.reports.get('examples/cb-head/collision.nc').text()""")
    path = os.path.join(bench.keep, "page-report.html")
    bench.native("cb-head", "collision", f"--report={path}")
    with open(path, encoding="utf-8") as file:
        same("report", saved, file.read())
    same("reports in frames", page.run("document.querySelectorAll('iframe.report').length"), 2)
    page.run("await until('report-shown', 2)")
    bench.done(page, "page-report")


ENDLESS = """G21 G90
T1 M6
G53 G0 Z0
G53 G0 X150 Y0
G0 A-30 C90
G53 G1 Z-380 F5000
G53 G0 Z0
o100 while [1]
G53 G0 X149
G53 G0 X150
o100 endwhile
M2
"""


@test
def cancel(bench):
    """Checks of endless programs can be cancelled, whether they run or wait, and a new check can be started."""
    page = bench.open()
    bench.example(page, "ac-trunnion")
    page.run("document.querySelector('[name=all]').click()")
    page.run("fivecheckPage.setFiles(fivecheckPage.files.filter(({role}) => role !== 'program'))")
    page.run("await fivecheckPage.add(Array.from({length: 9}, (_, i) => [`endless-${i}.nc`, new Blob([%s])]))" % json.dumps(ENDLESS))
    # After its first finding the program loops forever.
    page.run("""await new Promise((found) => {
        new MutationObserver(() => document.querySelector('.findings .collision') && found()).observe(document.querySelector('#results'), {childList: true, subtree: true});
        document.querySelector('#check').click();
    })""")
    same("verdicts before", [verdict for _, verdict in page.run(VERDICTS) if verdict], [])
    page.run("document.querySelector('#cancel').click()")
    page.run("await until('checked', 1)")
    same("verdicts", [verdict for _, verdict in page.run(VERDICTS)], ["incomplete"] * 9)
    page.run("document.querySelector('#empty').click()")
    bench.example(page, "cb-head", 2)
    bench.check(page, 2)
    bench.verdicts(page, "verdicts of the next check")
    bench.done(page)


@test
def strange_files(bench):
    """Pictures and drawings are not taken for programs, and the page says what to do with a drawing. A quoted block keeps its columns."""
    page = bench.open()
    page.run("await fivecheckPage.add(['photo.jpg', 'table.STEP', 'report.html', 'part.nc', 'O1000'].map((name) => [name, new Blob(['G1 X\\n'])]))")
    same("roles", page.run("Object.fromEntries(fivecheckPage.files.map(({path, role}) => [path, role]))"),
         {"photo.jpg": "other", "table.STEP": "other", "report.html": "other", "part.nc": "program", "O1000": "program"})
    true("what to do", "export table.STEP as STL" in page.run("document.querySelector('#job').textContent"))
    bench.example(page, "cb-head")
    page.run("await fivecheckPage.add([['fault.nc', new Blob(['G21 G90 G61\\nG1 Y-10 X\\nM2\\n'])]])")
    bench.check(page)
    card = "document.querySelector('[data-path=\"fault.nc\"]')"
    same("the caret stands below its place", page.run(f"[...{card}.querySelectorAll('.quoted')].map((e) => [e.textContent.search(/\\S/), getComputedStyle(e).whiteSpaceCollapse || getComputedStyle(e).whiteSpace])"),
         [[4, "preserve"], [4 + len("G1 Y-10 "), "preserve"]])
    same("errors in their colour", page.run(f"{card}.querySelectorAll('.message.error').length"), 1)
    bench.done(page, "page-fault")


@test
def said(bench):
    """A verdict of samples is not called clear; doubts stand beside the verdict; an outdated verdict is marked as outdated."""
    page = bench.open()
    bench.example(page, "cb-head")
    page.run("fivecheckPage.setFiles(fivecheckPage.files.filter(({path}) => !path.endsWith('collision.nc')))")
    said = "[...document.querySelectorAll('.program')].map((card) => [card.dataset.verdict, card.querySelector('.verdict').textContent.split(':')[0], card.querySelectorAll('.doubts li').length])"
    outdated = "document.querySelector('#outdated').checkVisibility()"
    for count, (method, verdict) in enumerate([("conventional", "passed"), ("interpolated", "passed"), ("certified", "clear")], 1):
        page.run(f"((field) => {{ field.value = '{method}'; field.dispatchEvent(new Event('change', {{bubbles: true}})); }})(document.querySelector('[name=method]'))")
        same("what stands there is about another method", page.run(outdated), count > 1)
        bench.check(page, count)
        same(method, page.run(said), [[verdict, verdict.capitalize(), 0]])
        same("it is about this method", page.run(outdated), False)
    page.run("fivecheckPage.setFiles(fivecheckPage.files.filter(({role}) => role !== 'setup'))")
    same("what stands there is about other files", page.run(outdated), True)
    page.run("await fivecheckPage.add([['empty.nc', new Blob([])]])")
    true("an empty file", "empty.nc: nothing in it" in page.run("document.querySelector('#job').textContent"))
    bench.check(page, 4)
    same("without a setup, and without a block", sorted(page.run(said))[-1][:2], ["incomplete", "Incomplete"])
    bench.done(page, "page-doubts")


@test
def many(bench):
    """With many programs only the first reports are drawn at once, the others on request."""
    page = bench.open()
    bench.example(page, "cb-head")
    program = page.run("await fivecheckPage.of('program')[0].blob.text()")
    page.run("await fivecheckPage.add(Array.from({length: 5}, (_, i) => [`copy-${i}.nc`, new Blob([%s])]))" % json.dumps(program))
    bench.check(page)
    same("reports", page.run("[document.querySelectorAll('.save').length, document.querySelectorAll('iframe.report').length]"), [7, 4])
    page.run("await until('report-shown', 4)")
    page.run("document.querySelector('[data-path=\"copy-4.nc\"] .show').click()")
    page.run("await until('report-shown', 5)")
    same("the one that was asked for", page.run("document.querySelectorAll('[data-path=\"copy-4.nc\"] iframe.report').length"), 1)
    bench.done(page)


@test
def keys(bench):
    """With the keyboard alone an example is opened and checked; the focus goes from Check to Cancel and back to Check."""
    page = bench.open()
    reached = []
    for _ in range(30):
        page.press("Tab")
        reached.append(page.run("[document.activeElement.tagName, document.activeElement.dataset.example ?? document.activeElement.id, getComputedStyle(document.activeElement).outlineStyle]"))
        if reached[-1][1] == "cb-head":
            break
    same("each place is seen", [place for place in reached if place[2] == "none"], [])
    same("the example is reached", reached[-1][1], "cb-head")
    page.press("Enter")
    page.run("await until('example-open', 1)")
    while page.run("document.activeElement.id") != "check":
        page.press("Tab")
        true("the button is reached", page.run("document.activeElement.tagName") != "BODY")
    page.run("(window.focused = [], document.addEventListener('focusin', ({target}) => focused.push(target.id)))")
    page.press("Enter")
    page.run("await until('checked', 1)")
    bench.verdicts(page)
    same("focus", page.run("[...focused, document.activeElement.id]"), ["cancel", "check", "check"])
    bench.done(page)


@test
def phone(bench):
    """Nothing is wider than a phone, and every control has a label."""
    page = bench.open(**PHONE)
    bench.example(page, "cb-head")
    bench.check(page)
    page.run("document.querySelector('#form-details').open = true")
    same("sideways", page.run("document.documentElement.scrollWidth"), 390)
    nameless = page.run("""[...document.querySelectorAll('button, input, select, a')].filter((e) => e.offsetParent
        && !(e.textContent.trim() || e.ariaLabel || e.closest('label')?.textContent.trim())).map((e) => e.outerHTML)""")
    same("controls without a name", nameless, [])
    bench.done(page, "page-phone")


@test
def lacking(bench):
    """A file that is missing on the server is named, and there is no verdict; once the file is there again, the job runs."""
    bench.site.missing = {"/fivecheck.wasm"}
    page = bench.open("learn.html")
    true("the page to learn with", "fivecheck.wasm cannot be loaded" in page.run("document.querySelector('#machine-name').textContent"))
    page.close()
    page = bench.open()
    bench.example(page, "cb-head")
    bench.check(page)
    same("no verdict", [verdict in ("clear", "found") for _, verdict in page.run(VERDICTS)], [False, False])
    true("its reason", "fivecheck.wasm cannot be loaded: the server answers 404" in page.run("document.querySelector('.program').textContent"))
    bench.site.missing = {"/examples/b-head-c-table.zip"}
    bench.check(page, 2)
    bench.verdicts(page)
    bench.example(page, "b-head-c-table", 2)
    true("a file of an example", "b-head-c-table.zip cannot be loaded" in page.run("document.querySelector('#job').textContent"))
    same("nothing is half there", page.run("document.querySelector('#check').disabled"), True)
    bench.site.missing = set()
    page.close()


@test
def offline(bench):
    """After the first visit the page works without the network."""
    page = bench.open()
    page.run("await navigator.serviceWorker.ready")
    bench.example(page, "cb-head")
    page.reload()
    page.run("await until('fivecheck-ready', 1)")
    bench.example(page, "cb-head")
    page.offline()
    bench.site.close()
    page.reload()
    page.run("await until('fivecheck-ready', 1)")
    bench.example(page, "cb-head")
    bench.check(page)
    bench.verdicts(page)
    page.close()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--firefox", action="store_true")
    parser.add_argument("--fivecheck", required=True)
    parser.add_argument("--page", required=True)
    parser.add_argument("--keep", required=True)
    parser.add_argument("tests", nargs="*")
    arguments = parser.parse_args()
    os.makedirs(arguments.keep, exist_ok=True)

    @contextlib.contextmanager
    def bench():
        site = Site(arguments.page)
        try:
            yield Bench(arguments, site, browser)
        finally:
            if site.thread.is_alive():
                site.close()

    with browser_of(arguments)(timeout=600) as browser:
        return 1 if carry_out(TESTS, bench, arguments.tests) else 0


if __name__ == "__main__":
    sys.exit(main())
