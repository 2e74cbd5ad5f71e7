"""Uses the page of the checker (make web) in a real Chromium or Firefox, as a person would: make check-page, check-firefox.
Pictures go to --keep.

usage: check_page.py [--firefox] --fivecheck PROGRAM --page FOLDER --keep FOLDER [TEST...]
"""
import argparse
import contextlib
import json
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bench import PHONE, TESTS, WEAK_TEXT, browser_of, carry_out, same, test, true  # noqa: E402
from page_bench import VERDICTS, WORDS, Bench, Site  # noqa: E402
import access_page  # noqa: E402, F401
import adverse_page  # noqa: E402, F401
import builds_page  # noqa: E402, F401
import embed_page  # noqa: E402, F401
import figures_page  # noqa: E402, F401
import fixtures  # noqa: E402
import forms_page  # noqa: E402, F401
import hostile_page  # noqa: E402, F401
import jobs_page  # noqa: E402, F401
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
    """The report shows itself in its frame, and what is saved has the bytes of the command line's."""
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
    """Checks of programs that never end can be cancelled, those that run and those that wait, and another one started."""
    page = bench.open()
    bench.example(page, "ac-trunnion")
    page.run("document.querySelector('[name=all]').click()")
    page.run("fivecheckPage.setFiles(fivecheckPage.files.filter(({role}) => role !== 'program'))")
    page.run("await fivecheckPage.add(Array.from({length: 9}, (_, i) => [`endless-${i}.nc`, new Blob([%s])]))" % json.dumps(ENDLESS))
    # The first finding: from there on that program goes round and round.
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
    """Pictures and drawings are no programs; what to do with a drawing is said. A block that is quoted stands in columns."""
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
    """A verdict is called what it is: samples prove nothing, what speaks against the premises stands beside it, and an older one is told to be so."""
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
    same("without a setup, and without a move", sorted(page.run(said))[0], ["clear", "Clear", 2])
    bench.done(page, "page-doubts")


@test
def many(bench):
    """Of many programs the first reports are drawn, the others when asked for."""
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
    """By keys alone: an example is opened and checked; the focus goes from Check to Cancel, and back to Check."""
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
    """Nothing is wider than a phone, and everything has a name."""
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
    """What the server does not have is named, and gives no verdict; once it is there again, the job runs."""
    bench.site.missing = {"/fivecheck.wasm"}
    page = bench.open("learn.html")
    true("the page to learn with", "fivecheck.wasm cannot be loaded" in page.run("document.querySelector('#machine-name').textContent"))
    page.close()
    page = bench.open()
    bench.example(page, "cb-head")
    bench.check(page)
    same("no verdict", [verdict in ("clear", "found") for _, verdict in page.run(VERDICTS)], [False, False])
    true("its reason", "fivecheck.wasm cannot be loaded: the server answers 404" in page.run("document.querySelector('.program').textContent"))
    bench.site.missing = {"/examples/examples/b-head-c-table/setup.xml"}
    bench.check(page, 2)
    bench.verdicts(page)
    bench.example(page, "b-head-c-table", 2)
    true("a file of an example", "setup.xml cannot be loaded" in page.run("document.querySelector('#job').textContent"))
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


RED = """(() => {
    const canvas = document.querySelector('.stage canvas'), gl = canvas.getContext('webgl2'), w = canvas.width, h = canvas.height;
    const pixels = new Uint8Array(4 * w * h);
    gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    let red = 0;
    for (let i = 0; i < pixels.length; i += 4) red += pixels[i] > 2 * pixels[i + 1] && pixels[i] > 2 * pixels[i + 2] && pixels[i] > 60;
    return red;
})()"""
JOGGED = "document.querySelector('.jog .verdict').textContent"
EDITED = "document.querySelector('.editor .verdict').textContent"
GUTTER = "[...document.querySelectorAll('.gutter div')].flatMap((e, i) => e.className ? [[i + 1, e.className]] : [])"


def learn(bench, **options):
    """The page to learn with, once its first machine is there and its first program is checked."""
    page = bench.open("learn.html", **options)
    page.run("await until('machine-open', 1)")
    page.run("await until('posed', 1)")
    return page


def jog(page, axes, tool):
    """Moves the axes and waits for the answer that is about just this pose."""
    page.run(f"learnPage.jog.moveTo({json.dumps(axes)}, {tool})")
    page.run("await (async () => { while (learnPage.jog.newest.busy) await until('posed', counts.posed + 1); })()")
    page.frames()


def edit(page, text):
    page.run(f"(learnPage.editor.text.value = {json.dumps(text)}, await learnPage.editor.typed(), "
             "await (async () => { while (learnPage.editor.newest.busy) await until('edited', counts.edited + 1); })())")


@test
def jog_sliders(bench):
    """Bodies move with the sliders, by mouse and keys; what meets is red; the distance is that of the pose."""
    page = learn(bench)
    same("axes", page.run("[...document.querySelectorAll('.axis-row label')].map((e) => e.textContent)"),
         ["Y", "X", "Z", "A (First axis)", "C (Second axis)"])
    same("limits of Z", page.run("['min', 'max'].map((name) => document.querySelector('#jog-Z')[name])"), ["-400", "0"])
    true("clear at home", "Nearest of" in page.run(JOGGED))
    page.frames()
    same("red where nothing meets", page.run(RED), 0)
    same("frame of the distance", page.run("getComputedStyle(document.querySelector('.measure-label')).borderColor"), "rgb(11, 99, 181)")
    jog(page, {"Z": -380, "A": -40}, 1)
    true("the head meets the work", page.run(JOGGED).startswith("Collision:") and "arbor meets T1 holder" in page.run(JOGGED))
    true("red where bodies meet", page.run(RED) > 500)
    page.picture(os.path.join(bench.keep, "learn-jog.png"))
    # By keys: one step of the slider.
    page.run("document.querySelector('#jog-Z').focus()")
    jog(page, {}, 0)
    page.press("ArrowLeft")
    page.run("await (async () => { while (learnPage.jog.newest.busy) await until('posed', counts.posed + 1); })()")
    same("Z after a key", page.run("learnPage.jog.values().Z"), -0.5)
    bench.done(page, "learn-home")


@test
def editor(bench):
    """Errors and findings stand at their lines, verdicts are those of the command line, a finding's button shows its pose."""
    page = learn(bench)
    first = page.run("learnPage.editor.text.value")
    true("the first program is clear", page.run(EDITED).startswith("Clear"))
    same("marks of a clear program", page.run(GUTTER), [])
    true("no verdict of the text before", not page.run("(learnPage.editor.typed(), document.querySelector('.editor .verdict').textContent)").startswith("Clear"))
    edit(page, first)
    # As if a key had been pressed while the text before it is checked.
    page.run("(learnPage.editor.verdict.textContent = '', learnPage.editor.keys++,"
             " await learnPage.editor.check({number: learnPage.editor.keys - 1, at: 0, text: learnPage.editor.text.value}))")
    same("no verdict of a key before the last one", page.run(EDITED), "")
    times = []
    for z in range(-180, -160):
        edit(page, first.replace("Z-180", f"Z{z}"))
        times.append(page.run("learnPage.editor.took"))
    print(f"     from the last key to the verdict: {sorted(times)[len(times) // 2]:.0f} ms (median of {len(times)})")
    edit(page, "G21 G90\nG1 X\nM2\n")
    true("an error", page.run(EDITED).startswith("Incomplete"))
    same("its line", page.run(GUTTER), [[2, "bad"]])
    hit = first.replace("Z-180", "Z-380")
    edit(page, hit)
    true("a finding", page.run(EDITED).startswith("Found"))
    times, proved = [], []
    for z in range(-380, -360):
        edit(page, first.replace("Z-180", f"Z{z}"))
        true("the proof is shown last", page.run(EDITED).startswith("Found. "))
        times.append(page.run("learnPage.editor.took"))
        proved.append(page.run("learnPage.editor.proved"))
    print(f"     from the last key to the first finding of a collision: {sorted(times)[len(times) // 2]:.0f} ms, "
          f"to its proof: {sorted(proved)[len(proved) // 2]:.0f} ms (medians of {len(times)})")
    # Samples alone: their finding is there before any proof.
    page.run("(learnPage.editor.newest.busy = true, learnPage.editor.text.value = %s, learnPage.editor.typed(),"
             " until('sampled', counts.sampled + 1))" % json.dumps(hit))
    true("samples", page.run(EDITED).startswith("Found by samples; the proof follows."))
    page.run("(learnPage.editor.newest.busy = false, learnPage.editor.typed())")
    edit(page, hit)
    path = os.path.join(bench.keep, "program.nc")
    with open(path, "w", encoding="utf-8") as file:
        file.write(hit)
    native = subprocess.run([bench.fivecheck, "--format=ndjson", "--setup=examples/ac-trunnion/setup.xml",
                             "machines/ac-trunnion/machine.xml", path], capture_output=True, text=True, check=False)
    found = next(event for event in map(json.loads, native.stdout.splitlines()) if event["kind"] == "collision")
    same("line of the finding", page.run(GUTTER), [[found["line"], "bad"]])
    page.run("document.querySelector('.remarks button').click()")
    page.run("await (async () => { while (learnPage.jog.newest.busy) await until('posed', counts.posed + 1); })()")
    same("pose of the finding", page.run("learnPage.jog.values()"), found["axes"])
    true("bodies that meet there", f"{found['a']} meets {found['b']}" in page.run(JOGGED))
    bench.done(page, "learn-editor")


@test
def tour(bench):
    """The pairs are those of --list-pairs; samples miss the wall that the proof finds."""
    page = learn(bench)
    true("pairs of axes", "3 of 10 pairs of axes are checked: Y–C, Z–A, Z–C." in page.run("document.querySelector('#pair-table').textContent"))
    before = page.run("document.querySelector('.axis-picture .verdict').textContent")
    page.run("(document.querySelector('#axis-angle').value = 0, document.querySelector('#axis-angle').dispatchEvent(new Event('input')))")
    true("a direction that separates", "34.0 mm apart" in page.run("document.querySelector('.axis-picture .verdict').textContent"))
    true("one that does not", "proves nothing" in before)
    page.run("document.querySelector('#check-wall').click()")
    page.run("await until('wall-checked', 1)")
    same("samples and proof", page.run("[...document.querySelectorAll('#wall-results .program')].map((e) => [e.dataset.method, e.dataset.verdict])"),
         [["conventional", "incomplete"], ["certified", "found"]])
    page.run("document.querySelector('#tour').scrollIntoView()")
    bench.done(page, "learn-tour")


@test
def learn_own_files(bench):
    """Own files: what is wrong with them is told while the machine before goes on; a program of theirs comes into the editor, with the doubts about it."""
    page = learn(bench)
    name = "document.querySelector('#machine-name').textContent"

    def choose(*paths):
        page.run("void (window.said = new Promise((done) => new MutationObserver(() => /cannot be shown/.test(document.querySelector('#machine-name').textContent) && done())"
                 ".observe(document.querySelector('#machine-name'), {childList: true, characterData: true, subtree: true})))")
        page.choose("#choose", list(paths))

    with tempfile.TemporaryDirectory() as work:
        machine, setup, program = fixtures.boxes(work)
        folder = os.path.dirname(machine)
        choose(program)
        page.run("await window.said")
        same("no machine", page.run(name), "This machine cannot be shown: a machine file is missing\nWhat stands below is A/C trunnion 400.")
        choose(machine)
        page.run("await window.said")
        true("no mesh", "not here: table.stl, head.stl; choose these files" in page.run(name))
        with open(os.path.join(folder, "broken.xml"), "w", encoding="utf-8") as file:
            file.write("<machine version='1'><base></machine>")
        choose(os.path.join(folder, "broken.xml"))
        page.run("await window.said")
        true("no XML", "not well-formed" in page.run(name))
        jog(page, {"Z": -380, "A": -40}, 1)
        true("the machine before goes on", page.run(JOGGED).startswith("Collision:"))
        edit(page, "G21 G90\nG1 X\nM2\n")
        true("and its editor", page.run(EDITED).startswith("Incomplete"))
        meshes = [os.path.join(folder, f"{mesh}.stl") for mesh in ("table", "head", "block")]
        with open(program, encoding="utf-8") as file:
            text = file.read().replace("G94", "G94 G64")
        with open(program, "w", encoding="utf-8") as file:
            file.write(text)
        page.choose("#choose", [machine, setup, program, *meshes])
        page.run("await until('machine-open', 2)")
        same("the program", page.run("learnPage.editor.text.value"), text)
        true("found", page.run(EDITED).startswith("Found"))
        true("a doubt", any(line.startswith("G64") for line in page.run("[...document.querySelectorAll('.remarks .warning')].map((e) => e.textContent)")))
        with open(machine, encoding="utf-8") as file:
            klartext = file.read().replace('dialect="linuxcnc"', 'dialect="klartext"').replace('rapid="linear"/>', 'rapid="linear" path_tolerance="0.01"><tool_change/></controller>')
        with open(machine, "w", encoding="utf-8") as file:
            file.write(klartext)
        page.choose("#choose", [machine, *meshes])
        page.run("await until('machine-open', 3)")
        true("blocks that its control reads", page.run("learnPage.editor.text.value").startswith("BEGIN PGM"))
        true(f"they are clear: {page.run(EDITED)}", page.run(EDITED).startswith("Clear"))
        true("without a setup", any("no setup" in line for line in page.run("[...document.querySelectorAll('.remarks .warning')].map((e) => e.textContent)")))
    bench.done(page, "learn-own")


@test
def learn_on_a_phone(bench):
    page = learn(bench, **PHONE)
    page.run("[...document.querySelectorAll('#examples button')][2].click()")
    page.run("await until('machine-open', 2)")
    same("machine", page.run("document.querySelector('#machine-name').textContent"), "C/B head portal 1900")
    same("sideways", page.run("document.documentElement.scrollWidth"), 390)
    nameless = page.run("""[...document.querySelectorAll('button, input, select, textarea, a')].filter((e) => e.offsetParent
        && !(e.textContent.trim() || e.ariaLabel || e.labels?.length)).map((e) => e.outerHTML)""")
    same("controls without a name", nameless, [])
    bench.done(page, "learn-phone")


@test
def contrast(bench):
    """Text stands out from its ground: 4.5 to 1, large text 3 to 1, by day and by night."""
    for dark in (False, True):
        page = bench.open(dark=dark)
        bench.example(page, "cb-head")
        bench.check(page)
        page.run("document.querySelectorAll('details').forEach((e) => e.open = true)")
        page.run("document.querySelector('#fill-example').click()")
        page.run("document.querySelector('[name=\"Z.min\"]').value = '400'")
        page.run("document.querySelector('#write-machine').click()")
        page.run("await until('machine-written', 1)")
        same(f"weak text, fault in the form, dark {dark}", page.run(WEAK_TEXT), [])
        page.run("document.querySelector('[name=\"Z.min\"]').value = '-400'")
        page.run("document.querySelector('#write-machine').click()")
        page.run("await until('machine-written', 2)")
        same(f"weak text, machine file, dark {dark}", page.run(WEAK_TEXT), [])
        bench.done(page, f"page-dark-{dark}")
        page = learn(bench, dark=dark)
        same(f"weak text, home, dark {dark}", page.run(WEAK_TEXT), [])
        jog(page, {"Z": -380, "A": -40}, 1)
        edit(page, "G21 G90\nG1 X\nM2\n")
        page.run("document.querySelector('#check-wall').click()")
        page.run("await until('wall-checked', 1)")
        same(f"weak text, findings, dark {dark}", page.run(WEAK_TEXT), [])
        bench.done(page, f"learn-dark-{dark}")


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
