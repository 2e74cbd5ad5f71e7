"""The learning page, as a student uses it: sliders, editor, tour, own files, on a phone, in light and dark mode."""
import json
import os
import re
import subprocess
import tempfile

import fixtures
from bench import PHONE, WEAK_TEXT, same, test, true
from page_bench import wait_for

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
    """The learning page after its first machine is loaded and its first program is checked."""
    page = bench.open("learn.html", **options)
    page.run("await until('machine-open', 1)")
    page.run("await until('posed', 1)")
    return page


def jog(page, axes, tool):
    """Moves the axes and waits for the answer for exactly this pose."""
    page.run(f"learnPage.jog.moveTo({json.dumps(axes)}, {tool})")
    page.run("await (async () => { while (learnPage.jog.newest.busy) await until('posed', counts.posed + 1); })()")
    page.frames()


def edit(page, text):
    page.run(f"(learnPage.editor.text.value = {json.dumps(text)}, await learnPage.editor.typed(), "
             "await (async () => { while (learnPage.editor.newest.busy) await until('edited', counts.edited + 1); })())")


@test
def jog_sliders(bench):
    """Bodies move with the sliders, by mouse and keys; bodies in contact are red; the distance is that of the pose."""
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
    """Errors and findings are shown at their lines, verdicts equal those of the command line, and the button of a finding shows its pose."""
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
    for z in range(41, 61):
        edit(page, first.replace("Z60", f"Z{z}"))
        times.append(page.run("learnPage.editor.took"))
    print(f"     from the last key to the verdict: {sorted(times)[len(times) // 2]:.0f} ms (median of {len(times)})")
    edit(page, "G21 G90\nG1 X\nM2\n")
    true("an error", page.run(EDITED).startswith("Incomplete"))
    same("its line", page.run(GUTTER), [[2, "bad"]])
    # The change that the page proposes.
    true("a change", "Z20 in place of Z60" in page.run("document.querySelector('#try').textContent"))
    hit = first.replace("Z60", "Z20")
    edit(page, hit)
    true("a finding", page.run(EDITED).startswith("Found"))
    times, proved = [], []
    for z in range(1, 21):
        edit(page, first.replace("Z60", f"Z{z}"))
        true("the proof is shown last", page.run(EDITED).startswith("Found. "))
        times.append(page.run("learnPage.editor.took"))
        proved.append(page.run("learnPage.editor.proved"))
    print(f"     from the last key to the first finding of a collision: {sorted(times)[len(times) // 2]:.0f} ms, "
          f"to its proof: {sorted(proved)[len(proved) // 2]:.0f} ms (medians of {len(times)})")
    # With samples alone, the finding is there before any proof.
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
    pressed = "[...document.querySelectorAll('#pair-table [aria-pressed=true]')].map((e) => e.ariaLabel)"
    labels = "[...document.querySelectorAll('.labels .label')].map((e) => e.textContent)"
    page.run("[...document.querySelectorAll('#pair-table button')].find((e) => /Z–C/.test(e.ariaLabel)).click()")
    page.frames()
    same("the pair that is shown", (page.run(pressed), page.run(labels)), (["Show Z–C on the machine"], ["head", "table"]))
    jog(page, {"X": 150, "Z": -150, "A": -30, "C": 90}, 1)
    page.run("document.querySelector('#show-plane').click()")
    page.frames()
    same("the plane takes its place", (page.run(pressed), sorted(page.run(labels))), ([], ["78.826 mm", "T1 cutter", "cradle"]))
    page.picture(os.path.join(bench.keep, "learn-plane.png"))
    page.run("document.querySelector('#check-wall').click()")
    page.run("await until('wall-checked', 1)")
    same("samples and proof", page.run("[...document.querySelectorAll('#wall-results .program')].map((e) => [e.dataset.method, e.dataset.verdict])"),
         [["conventional", "incomplete"], ["certified", "found"]])
    page.run("document.querySelector('#tour').scrollIntoView()")
    bench.done(page, "learn-tour")


@test
def learn_own_files(bench):
    """The user's own files: their errors are shown while the earlier machine stays usable; their program is opened in the editor, with its doubts."""
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
def first_programs(bench):
    """The first blocks of each example are clear without a doubt, and the proposed change makes them collide."""
    page = learn(bench)
    for i, other in enumerate(page.run("[...document.querySelectorAll('#examples button')].map((e) => e.textContent)")):
        if i:
            page.run(f"[...document.querySelectorAll('#examples button')][{i}].click()")
            page.run(f"await until('machine-open', {i + 1})")
        same("the open one", page.run("[...document.querySelectorAll('#examples [aria-pressed=true]')].map((e) => e.textContent)"), [other])
        true(f"{other} is clear", page.run(EDITED).startswith("Clear"))
        same(f"what is said of {other}", page.run("document.querySelectorAll('.remarks li').length"), 0)
        page.run("await (async () => { while (learnPage.jog.newest.busy) await until('posed', counts.posed + 1); })()")
        true(f"{other} stands clear", page.run(JOGGED).startswith("Nearest"))
        put, place, line = re.match(r"Try (\S+) in place of (\S+) in line (\d+):", page.run("document.querySelector('#try').textContent")).groups()
        blocks = page.run("learnPage.editor.text.value").split("\n")
        true(f"{place} in line {line}", f" {place} " in blocks[int(line) - 1])
        blocks[int(line) - 1] = blocks[int(line) - 1].replace(place, put)
        edit(page, "\n".join(blocks))
        same(f"{other}, changed", page.run(GUTTER), [[int(line), "bad"]])
    bench.done(page, "learn-first")


@test
def endless(bench):
    """An endless loop, as it exists while one types, is reported, and the machine can still be moved."""
    page = learn(bench)
    edit(page, "G21 G90\no1 while [1]\nG53 G0 X1\nG53 G0 X0\no1 endwhile\nM2\n")
    true("it is told", "is this loop endless?" in page.run("document.querySelector('.remarks').textContent"))
    jog(page, {"Z": -380, "A": -40}, 1)
    true("the machine is moved", page.run(JOGGED).startswith("Collision:"))
    edit(page, "G21 G90\nG53 G0 X1\nM2\n")
    true("the next text is checked", page.run(EDITED).startswith("Clear"))
    bench.done(page)


@test
def learn_dropped(bench):
    """A dropped folder is opened; a dropped file never replaces the page. Errors of an archive are shown."""
    page = learn(bench)
    with tempfile.TemporaryDirectory() as work:
        machine, _, _ = fixtures.boxes(work)
        page.drop(640, 400, [os.path.dirname(machine)])
        page.run("await until('machine-open', 2)")
        true("found", page.run(EDITED).startswith("Found"))
        broken = os.path.join(work, "job.zip")
        with open(broken, "wb") as file:
            file.write(b"PK")
        page.drop(640, 400, [broken])
        wait_for(page, "/job.zip cannot be read: it has no end: is it whole?/.test(document.querySelector('#machine-name').textContent)")
        true("the machine before stands", "What stands below is" in page.run("document.querySelector('#machine-name').textContent"))
    bench.done(page)


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
    """Contrast of text and background: 4.5 to 1, large text 3 to 1, in light and dark mode."""
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
