"""Looks at reports in a real Chromium: make check-browser. Pictures are kept in the folder that --keep names.

usage: check_browser.py --fivecheck PROGRAM --viewer viewer.js --keep FOLDER [TEST...]
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile
import traceback

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver import Browser, find_browser  # noqa: E402
import fixtures  # noqa: E402

PHONE = {"width": 390, "height": 800, "scale": 2, "mobile": True}
TESTS = []


def test(function):
    TESTS.append(function)
    return function


def same(what, found, wanted):
    if found != wanted:
        raise AssertionError(f"{what}: {found!r} instead of {wanted!r}")


def true(what, condition):
    if not condition:
        raise AssertionError(what)


class Bench:
    """What the tests share: reports that were written once, one browser, the folder of pictures."""

    def __init__(self, arguments, work, browser):
        self.fivecheck = arguments.fivecheck
        self.viewer = arguments.viewer
        self.keep = arguments.keep
        self.work = work
        self.browser = browser
        self.written = {}

    def report(self, name, machine, setup, program, *options):
        """Writes a report, once for each name; its path and the NDJSON findings of the same run."""
        if name not in self.written:
            path = os.path.join(self.work, f"{name}.html")
            done = subprocess.run(
                [self.fivecheck, machine, *([f"--setup={setup}"] if setup else []), program, f"--report={path}", "-f", "ndjson", *options],
                capture_output=True, text=True, check=False)
            true(f"exit status {done.returncode}: {done.stderr}", done.returncode in (0, 1) and os.path.exists(path))
            lines = [json.loads(line) for line in done.stdout.splitlines()]
            self.written[name] = path, [line for line in lines if line["kind"] not in ("header", "program", "summary")]
        return self.written[name]

    def example(self, name, program, *options):
        return self.report(f"{name}-{program}-{len(options)}", f"machines/{name}/machine.xml", f"examples/{name}/setup.xml",
                           f"examples/{name}/{program}.nc", *options)

    def open(self, path, **options):
        page = self.browser.page(**options)
        page.shown_after = page.open(path)
        true("the viewer has started", page.run("!!document.querySelector('.app')"))
        page.frames()
        return page

    def done(self, page, picture=None):
        """Nothing was thrown, said or asked for."""
        if picture:
            page.picture(os.path.join(self.keep, f"{picture}.png"))
        same("exceptions", page.exceptions(), [])
        same("requests", page.requests(), [])
        page.close()


RED = """((canvas) => {
    const flat = document.createElement('canvas');
    Object.assign(flat, {width: canvas.width, height: canvas.height});
    const pen = flat.getContext('2d');
    pen.drawImage(canvas, 0, 0);
    const pixels = pen.getImageData(0, 0, flat.width, flat.height).data;
    let red = 0;
    for (let i = 0; i < pixels.length; i += 4) if (pixels[i] > 120 && pixels[i + 1] < 0.35 * pixels[i] && pixels[i + 2] < 0.35 * pixels[i]) red++;
    return red;
})(document.querySelector('.stage canvas'))"""
READ_OUT = "Object.fromEntries([...document.querySelectorAll('.readout dl div')].map((row) => [row.children[0].textContent, Number(row.children[1].textContent)]))"
HERE = "Number(document.querySelector('.row.here')?.dataset.line || 0)"


@test
def units(bench):
    """The modules by themselves."""
    with open(bench.viewer, encoding="utf-8") as file:
        script = file.read()
    with open(os.path.join(os.path.dirname(__file__), "units.js"), encoding="utf-8") as file:
        checks = file.read()
    path = os.path.join(bench.work, "units.html")
    with open(path, "w", encoding="utf-8") as file:
        file.write("<!doctype html><meta charset=utf-8><script>" + script[:script.rindex("main();")] + checks + "})();</script>")
    page = bench.browser.page()
    page.open(path, ready="units-done")
    same("failures", page.run("window.unitFailures"), [])
    bench.done(page)


@test
def collision(bench):
    """The example opens at its collision: in words, in red, at the very axis positions."""
    path, findings = bench.example("ac-trunnion", "collision", "--all")
    page = bench.open(path)
    headline = page.run("document.querySelector('.app h1').textContent")
    for word in (findings[0]["a"], findings[0]["b"], str(findings[0]["line"])):
        true(f"{word} in the headline: {headline}", word in headline)
    true("red pixels", page.run(RED) > 2000)
    read = page.run(READ_OUT)
    same("axes", sorted(read), sorted(findings[0]["axes"]))
    for letter, value in findings[0]["axes"].items():
        true(f"{letter} {read[letter]} as in NDJSON {value}", abs(read[letter] - value) <= 0.000500001)
        exact = page.run(f"fivecheck.state.pose.values[fivecheck.state.model.axes.findIndex((axis) => axis.letter === '{letter}')]")
        true(f"{letter} {exact} to four digits", abs(exact - value) < 5e-5)
    same("line", page.run(HERE), findings[0]["line"])
    size = os.path.getsize(path)
    print(f"  {size / 1000:.0f} kB, shown after {page.shown_after / 1000:.2f} s")
    true(f"{size} bytes", size <= 150_000)
    bench.done(page, "collision-desk")
    for name, options in {"collision-dark": {"dark": True}, "collision-phone": PHONE}.items():
        bench.done(bench.open(path, **options), name)


@test
def clear(bench):
    """Nothing was found: nothing is red."""
    for name in ("ac-trunnion", "b-head-c-table", "cb-head"):
        path, findings = bench.example(name, "clear")
        same("findings", findings, [])
        page = bench.open(path)
        headline = page.run("document.querySelector('.app h1').textContent")
        true(headline, headline.startswith("Clear"))
        same("red pixels", page.run(RED), 0)
        page.run("fivecheck.state.seek(fivecheck.state.model.path.duration * 0.6)")
        page.frames()
        same("red pixels in the middle", page.run(RED), 0)
        bench.done(page, f"clear-{name}")


@test
def other_examples(bench):
    """The contact is seen on the other machines, too."""
    for name in ("b-head-c-table", "cb-head"):
        path, _ = bench.example(name, "collision", "--all")
        page = bench.open(path)
        true("red pixels", page.run(RED) > 500)
        bench.done(page, f"collision-{name}")


@test
def sensitivity(bench):
    """With --sensitivity the card says what the setup lacks: the block is 40 high, the tool passes 10 above its foot."""
    machine, setup, program = fixtures.boxes(bench.work)
    path, _ = bench.report("sensitivity", machine, setup, program, "--sensitivity=0,0,0,50")
    page = bench.open(path)
    text = page.run("document.querySelector('.card .cure').textContent")
    needed = float(text.split()[1])
    true(text, text.endswith("mm more tool length: then nothing is found.") and 30 <= needed < 30.1)
    bench.done(page, "sensitivity")


@test
def limit(bench):
    """An axis that leaves its travel: what it carries is red, and the words say how far."""
    machine, setup, _ = fixtures.boxes(bench.work)
    program = os.path.join(bench.work, "limit.nc")
    with open(program, "w", encoding="utf-8") as file:
        file.write("G21 G90\nT1 M6\nG54 G43 H1\nG0 Z150\nZ350\nM2\n")
    path, findings = bench.report("limit", machine, setup, program, "--all")
    same("kinds", {finding["kind"] for finding in findings}, {"limit"})
    page = bench.open(path)
    text = page.run("document.querySelector('.card').textContent")
    true(text, text.startswith("Z leaves its travel") and "its limit is 0.000: 110.000 too far" in text and "Z -90.000 \u2192 " in text)
    true("red pixels", page.run(RED) > 2000)
    bench.done(page, "limit")


@test
def phone(bench):
    """No sideways scroll at 390 px, on no tab; one finger turns, two zoom."""
    path, _ = bench.example("ac-trunnion", "collision", "--all")
    page = bench.open(path, **PHONE)
    for tab in range(4):
        page.run(f"document.querySelectorAll('[role=tab]')[{tab}].click()")
        page.frames()
        true("page is as wide as the screen", page.run("document.documentElement.scrollWidth") <= 390)
        wide = page.run("[...document.querySelectorAll('.app *')].filter((e) => !e.closest('.overlay, .rows, canvas, dialog') && e.getBoundingClientRect().right > 390.5).map((e) => e.className || e.tagName)")
        same(f"elements that stick out, tab {tab}", wide, [])
        page.picture(os.path.join(bench.keep, f"phone-tab-{tab}.png"))
    x, y, width, height = page.box(".stage canvas")
    cx, cy = x + width / 2, y + height / 2
    camera = "[fivecheck.stage.camera.yaw, fivecheck.stage.camera.distance]"
    before = page.run(camera)
    page.touch([(cx, cy)], [(cx + 40, cy)], [(cx + 80, cy + 10)])
    turned = page.run(camera)
    true("one finger turns", abs(turned[0] - before[0]) > 0.1 and turned[1] == before[1])
    page.touch([(cx - 30, cy), (cx + 30, cy)], [(cx - 60, cy), (cx + 60, cy)])
    true("two fingers zoom", page.run(camera)[1] < 0.8 * turned[1])
    bench.done(page)


@test
def linked(bench):
    """A click on a line shows where its block has led; a moment of the timeline shows its line."""
    path, findings = bench.example("ac-trunnion", "collision", "--all")
    rows = fixtures.dump_path(bench.fivecheck, "machines/ac-trunnion/machine.xml", "examples/ac-trunnion/setup.xml", "examples/ac-trunnion/collision.nc")
    page = bench.open(path)
    for line in (68, 66, 71):
        x, y, _, height = page.box(f"[data-line='{line}']")
        page.click(x + 100, y + height / 2)
        page.run("await new Promise((done) => setTimeout(done))")
        same("line", page.run(HERE), line)
        wanted = [row for row in rows if row["line"] == line][-1]
        read = page.run(READ_OUT)
        for letter in "XYZAC":
            true(f"line {line}: {letter} {read[letter]} as in the path {wanted[letter]}", abs(read[letter] - wanted[letter]) < 0.006)
    page.press("n")
    same("back at the finding", page.run(HERE), findings[0]["line"])
    x, y, width, height = page.box(".timeline canvas")
    for share in (0.1, 0.5, 0.9):
        page.click(x + width * share, y + height / 2)
        time = page.run("fivecheck.state.time")
        true("time by the place in the timeline", abs(time - share * page.run("fivecheck.state.model.path.duration")) < 0.5)
        after = next(row for row in rows if row["time"] >= time - 1e-4)
        same("line by the timeline", page.run(HERE), after["line"])
    bench.done(page)


@test
def keyboard(bench):
    path, findings = bench.example("ac-trunnion", "collision", "--all")
    page = bench.open(path)
    finding = findings[0]["time"]
    time = "fivecheck.state.time"
    page.press("b")
    true("two seconds before", abs(page.run(time) - (finding - 2)) < 1e-3)
    # Play goes on to the finding, and stops there.
    page.run("fivecheck.state.speed = 100")
    page.run("(window.stopped = new Promise((done) => fivecheck.state.watch((what) => what === 'look' && done())), 0)")
    page.press(" ")
    page.run("await window.stopped")
    same("stops at the finding", page.run("[fivecheck.state.finding, fivecheck.state.playing]"), [0, False])
    line = page.run(HERE)
    page.press(",")
    true("block before", 0 < page.run(HERE) < line)
    page.press(".")
    same("next block", page.run(HERE), line)
    for key, name in {"s": "section", "m": "measuring", "x": "xray"}.items():
        was = page.run(f"!!fivecheck.stage.{name}")
        page.press(key)
        same(name, page.run(f"!!fivecheck.stage.{name}"), not was)
        page.press(key)
    page.press("3")
    true("from above", page.run("fivecheck.stage.camera.pitch") > 1.5)
    page.press("]")
    page.press("?")
    true("help", page.run("document.querySelector('dialog').open"))
    page.press("Escape")
    true("help closed", not page.run("document.querySelector('dialog').open"))
    # Every control is reached by Tab, shows that it is, and has a name.
    seen = []
    page.run("document.activeElement.blur()")
    for _ in range(60):
        page.press("Tab")
        name = page.run("((e) => e === document.body ? '' : (e.getAttribute('aria-label') || e.textContent || e.id).trim().slice(0, 30))(document.activeElement)")
        if not name or (seen and name == seen[0]):
            break
        seen.append(name)
        true(f"{name}: focus is seen", page.run("getComputedStyle(document.activeElement).outlineStyle !== 'none'"))
    for name in ("The machine in 3-D", "Time in the program", "Program", "Measure", "Print"):
        true(f"{name} is reached by Tab: {seen}", any(s.startswith(name) for s in seen))
    # The canvas: arrow keys turn the machine; the timeline: they move the time.
    page.run("document.querySelector('.stage canvas').focus()")
    yaw = page.run("fivecheck.stage.camera.yaw")
    page.press("ArrowLeft")
    true("arrow turns", page.run("fivecheck.stage.camera.yaw") != yaw)
    page.run("document.querySelector('.timeline canvas').focus()")
    page.press("Home")
    same("Home", page.run(time), 0)
    page.press("ArrowRight")
    true("arrow right", abs(page.run(time) - 0.1) < 1e-9)
    bench.done(page)


@test
def bodies_and_measure(bench):
    """Hide, isolate, section and measure by picking, on boxes of known size."""
    machine, setup, program = fixtures.boxes(bench.work)
    path, _ = bench.report("boxes", machine, setup, program, "--all")
    page = bench.open(path)
    # What is made faint is not picked.
    page.press("x")
    page.press("1")
    page.press("f")
    page.frames()
    name = "fivecheck.state.model.bodies[fivecheck.stage.selected]?.name || null"
    corner = "((p) => fivecheck.stage.camera.project(p, fivecheck.stage.canvas.clientWidth, fivecheck.stage.canvas.clientHeight))"
    left, top, _, _ = page.box(".stage canvas")

    def at(point):
        x, y, _ = page.run(f"{corner}({json.dumps(point)})")
        return left + x, top + y

    page.click(*at([0, -100, 30]))
    same("picked", page.run(name), "table")
    page.press("h")
    page.click(*at([-40, -100, 30]))
    true("hidden is not picked", page.run(name) != "table")
    page.press("a")
    page.click(*at([40, -100, 20]))
    page.press("i")
    same("alone", page.run("fivecheck.stage.placed.all().length"), 1)
    page.press("a")
    # The table is 200 wide and 60 tall.
    page.press("m")
    for point in ([-99.999, -100, 0.001], [99.999, -100, 59.999]):
        page.click(*at(point))
    text = page.run("document.querySelector('.measure-label')?.textContent || ''")
    true(f"measure: {text}", text.startswith("208.81 mm") and "X 200.00" in text and "Z 60.00" in text)
    page.press("m")
    solid = "((gl) => { const p = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight); gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, p); let n = 0; for (let i = 3; i < p.length; i += 4) if (p[i]) n++; return n; })(fivecheck.stage.scene.gl)"
    page.press("2")
    page.frames()
    whole = page.run(solid)
    page.press("s")
    page.frames()
    true("a section takes something away", page.run(solid) < 0.9 * whole)
    bench.done(page, "section")


@test
def poses(bench):
    """Every body stands at the finding where --pose says, to the accuracy that the report states."""
    path, _ = bench.example("ac-trunnion", "collision", "--all")
    wanted = fixtures.pose_boxes(bench.fivecheck, bench.work, "machines/ac-trunnion/machine.xml", "examples/ac-trunnion/setup.xml", "examples/ac-trunnion/collision.nc")
    page = bench.open(path)
    found = page.run("""(({placed, model}) => placed.all().map((i) => {
        const {positions, indices} = model.bodies[i].mesh, m = placed.matrix(i);
        const all = [];
        for (const v of new Set(indices)) all.push([0, 1, 2].map((r) => m[r] * positions[3 * v] + m[4 + r] * positions[3 * v + 1] + m[8 + r] * positions[3 * v + 2] + m[12 + r]));
        return {name: model.bodies[i].name, triangles: indices.length / 3, points: all};
    }))(fivecheck.stage)""")
    accuracy = page.run("fivecheck.state.model.accuracy")
    true(f"accuracy {accuracy}", 0 < accuracy <= 0.05)
    # Triangles that are thinner than the accuracy of the picture are not drawn.
    triangles = sum(body["triangles"] for body in found)
    true(f"{triangles} triangles of {len(wanted['triangles'])}", 0.999 * len(wanted["triangles"]) < triangles <= len(wanted["triangles"]))
    missed = fixtures.farthest([p for body in found for p in body["points"]], wanted["points"], accuracy + 1e-3)
    same("vertices of the picture that --pose has not", missed, 0)
    missed = fixtures.farthest(wanted["points"], [p for body in found for p in body["points"]], accuracy + 1e-3)
    same("vertices of --pose that the picture has not", missed, 0)
    bench.done(page)


@test
def hostile(bench):
    """Names, comments and code are text, whatever they say."""
    machine, setup, program = fixtures.boxes(bench.work, hostile=True)
    path, findings = bench.report("hostile", machine, setup, program, "--all")
    true("something is found", findings)
    page = bench.open(path)
    for tab in range(4):
        page.run(f"document.querySelectorAll('[role=tab]')[{tab}].click()")
        page.frames()
    same("ran", page.run("window.pwned || null"), None)
    same("images", page.run("document.querySelectorAll('img[src=x]').length"), 0)
    true("the name is shown", page.run("document.querySelector('.app h1').textContent").find("<img") >= 0)
    page.run("document.querySelectorAll('[role=tab]')[0].click()")
    true("the code is shown", "</script>" in page.run("document.querySelector('.rows').textContent"))
    bench.done(page, "hostile")


@test
def plain(bench):
    """Without WebGL, without JavaScript and on paper the plain HTML says what hits what, and where."""
    path, findings = bench.example("ac-trunnion", "collision", "--all")
    words = [findings[0]["a"], findings[0]["b"], "line 70"]
    text = "document.getElementById('plain').innerText"

    page = bench.browser.page()
    page.call("Emulation.setScriptExecutionDisabled", value=True)
    page.call("Page.navigate", url="file://" + os.path.abspath(path))
    page.wait("Page.loadEventFired")
    page.call("Emulation.setScriptExecutionDisabled", value=False)
    for word in words:
        true(f"{word} without JavaScript", word in page.run(text))
    same("no viewer", page.run("document.querySelector('.app')"), None)
    page.picture(os.path.join(bench.keep, "plain.png"))
    page.size(390, 800, mobile=True)
    true("plain on a phone", page.run("document.documentElement.scrollWidth") <= 390)
    page.close()

    page = bench.browser.page()
    page.open(path, scripts="HTMLCanvasElement.prototype.getContext = () => null;")
    for word in words:
        true(f"{word} without WebGL", word in page.run(text))
    same("no viewer without WebGL", page.run("document.querySelector('.app')"), None)
    page.close()

    page = bench.open(path)
    page.call("Emulation.setEmulatedMedia", media="print")
    page.frames()
    for word in words:
        true(f"{word} on paper", word in page.run(text))
    same("the viewer on paper", page.run("getComputedStyle(document.querySelector('.app')).display"), "none")
    bench.done(page, "paper")


CONTRAST = """((lum, over) => {
    const parse = (text) => { const n = text.match(/[\\d.]+/g).map(Number); return text.startsWith('color(') ? [n[0] * 255, n[1] * 255, n[2] * 255, n[3] ?? 1] : [n[0], n[1], n[2], n[3] ?? 1]; };
    const ground = (e) => {
        if (!e) return [255, 255, 255];
        const c = parse(getComputedStyle(e).backgroundColor);
        return c[3] >= 0.8 ? c : over(c, ground(e.parentElement));
    };
    const bad = [];
    for (const e of document.querySelectorAll('.app *')) {
        if (![...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim()) || !e.getClientRects().length || e.closest('svg')) continue;
        const style = getComputedStyle(e), a = lum(parse(style.color)), b = lum(ground(e));
        const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        const large = parseFloat(style.fontSize) >= 18.66;
        if (ratio < (large ? 3 : 4.5)) bad.push(`${e.tagName}.${e.className} ${e.textContent.slice(0, 20)} ${ratio.toFixed(2)}`);
    }
    return bad;
})((c) => { const [r, g, b] = c.map((v) => (v /= 255, v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)); return 0.2126 * r + 0.7152 * g + 0.0722 * b; },
(c, d) => [0, 1, 2].map((k) => c[k] * c[3] + d[k] * (1 - c[3])))"""


@test
def contrast(bench):
    """Text stands out from its ground: 4.5 to 1, large text 3 to 1 (WCAG 2.2, 1.4.3)."""
    for program in ("collision", "clear"):
        path, _ = bench.example("ac-trunnion", program, "--all")
        for dark in (False, True):
            page = bench.open(path, dark=dark)
            for tab in range(4):
                page.run(f"document.querySelectorAll('[role=tab]')[{tab}].click()")
                same(f"weak text, {program}, dark {dark}, tab {tab}", page.run(CONTRAST), [])
            bench.done(page)


@test
def proof(bench):
    """The plane lies between the two nearest bodies."""
    path, _ = bench.example("ac-trunnion", "clear")
    page = bench.open(path)
    true("planes", page.run("!!fivecheck.state.model.planes"))
    row = page.run("fivecheck.state.model.planes.pair.findIndex((pair) => pair >= 0)")
    page.run(f"fivecheck.state.seek(fivecheck.state.model.planes.time[{row}])")
    page.press("p")
    true("words", page.run("document.querySelector('.hints').textContent").startswith("Proof"))
    bench.done(page, "proof")


@test
def windows(bench):
    """A report that has no text of the program takes it from the user, if it is the right file."""
    path, _ = bench.report("no-code", "machines/ac-trunnion/machine.xml", "examples/ac-trunnion/setup.xml", "examples/ac-trunnion/collision.nc", "--all", "--report-code=none")
    page = bench.open(path)
    true("no code", "N630" not in page.run("document.querySelector('.rows').textContent"))
    with open("examples/ac-trunnion/collision.nc", encoding="utf-8") as file:
        program = file.read()
    taken = page.run(f"await fivecheck.program.take(new File([{json.dumps(program + '(x)')}], 'other.nc'))")
    same("another file", taken, False)
    true("and it says so", "SHA-256" in page.run("document.querySelector('.program .note').textContent"))
    taken = page.run(f"await fivecheck.program.take(new File([{json.dumps(program)}], 'collision.nc'))")
    same("the right file", taken, True)
    page.frames()
    true("code", "N630 C180." in page.run("document.querySelector('.rows').textContent"))
    bench.done(page)


@test
def subprograms(bench):
    """The lines of a subprogram are shown in its file; the card says from where it is called, and a click shows that line."""
    machine, setup, program = fixtures.boxes(bench.work, subprogram=True)
    path, findings = bench.report("sub", machine, setup, program, "--all")
    page = bench.open(path)
    same("file of the finding", page.run("fivecheck.state.model.sources[fivecheck.program.file].name"), findings[0]["file"])
    same("line of the finding", page.run(HERE), findings[0]["line"])
    same("callers", findings[0]["callers"], [{"file": program, "line": 5, "column": 1}])
    same("caller", page.run("document.querySelector('.call').textContent"), f"{program}:5")
    page.run("document.querySelector('.call').click()")
    page.frames()
    same("the call is shown", page.run("document.querySelector('.row.read').textContent"), "5o<approach> call")
    page.press("n")
    same("and the finding again", page.run(HERE), findings[0]["line"])
    bench.done(page, "subprograms")


@test
def read_outs(bench):
    """Work coordinates by the offset in force, feed and spindle, as a control shows them: they are the program's own numbers."""
    machine, setup, _ = fixtures.boxes(bench.work)
    program = os.path.join(bench.work, "read-outs.nc")
    with open(program, "w", encoding="utf-8") as file:
        file.write("G21 G90 G17\nT1 M6\nS1200 M4\nG54 G43 H1\nG0 X-90 Y3 Z120\nG1 Z90 F600\nG92 X0\nX10 F450.5\nG53 G0 Z0\nM2\n")
    path, findings = bench.report("read-outs", machine, setup, program, "--all")
    same("findings", findings, [])
    page = bench.open(path)
    work = "Object.fromEntries([...document.querySelectorAll('.readout dl div')].map((row) => [row.children[0].textContent, row.children[2].textContent]))"
    text = "[...document.querySelectorAll('.readout p')].map((line) => line.textContent)"
    seen = {}
    for line in (5, 6, 8, 9):
        page.run(f"await fivecheck.state.showLine(0, {line})")
        page.frames()
        seen[line] = page.run(work), page.run(text)
        if line == 8:
            page.picture(os.path.join(bench.keep, "read-outs.png"))
    same("rapid", seen[5][0], {"X": "-90.000", "Y": "3.000", "Z": "120.000"})
    same("feed", list(seen[6]), [{"X": "-90.000", "Y": "3.000", "Z": "90.000"}, ["work: G54", seen[6][1][1], "feed 600 mm/minS1,200 (M4)"]])
    same("shifted", list(seen[8]), [{"X": "10.000", "Y": "3.000", "Z": "90.000"}, ["work: G54, shifted", seen[8][1][1], "feed 451 mm/minS1,200 (M4)"]])
    same("machine coordinates", seen[9][0], {"X": "", "Y": "", "Z": ""})
    bench.done(page)
    page = bench.open(path, **PHONE)
    page.run("await fivecheck.state.showLine(0, 8)")
    page.frames()
    true("page is as wide as the screen", page.run("document.documentElement.scrollWidth") <= 390)
    bench.done(page, "read-outs-phone")


@test
def million(bench):
    """1,000,000 blocks: at most 5 MB, and every moment can be reached."""
    machine, setup, program = fixtures.million(bench.work)
    path, _ = bench.report("million", machine, setup, program, "--jobs=2")
    size = os.path.getsize(path)
    page = bench.open(path)
    print(f"  {size / 1e6:.2f} MB, shown after {page.shown_after / 1000:.2f} s")
    true(f"{size} bytes", size <= 5_000_000)
    page.run("fivecheck.state.seek(fivecheck.state.model.path.duration / 2)")
    page.run("await fivecheck.state.model.path.load(fivecheck.state.time)")
    page.frames()
    line = page.run(HERE)
    true(f"line {line} in the middle", 400_000 < line < 600_000)
    page.run("fivecheck.program.scrollTo(999990)")
    page.frames()
    true("the last lines", "1,000,0" in page.run("document.querySelector('.rows').textContent"))
    bench.done(page, "million")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--fivecheck", required=True)
    parser.add_argument("--viewer", required=True)
    parser.add_argument("--keep", required=True)
    parser.add_argument("tests", nargs="*")
    arguments = parser.parse_args()
    if not find_browser():
        sys.exit("check_browser: there is no Chromium")
    os.makedirs(arguments.keep, exist_ok=True)
    chosen = [t for t in TESTS if not arguments.tests or t.__name__ in arguments.tests]
    failed = 0
    with tempfile.TemporaryDirectory() as work, Browser() as browser:
        bench = Bench(arguments, work, browser)
        for function in chosen:
            try:
                function(bench)
                print(f"{function.__name__} passed", flush=True)
            except Exception:  # one test's failure must not hide the others
                traceback.print_exc()
                print(f"FAILED: {function.__name__}", flush=True)
                failed += 1
    print(f"browser tests: {len(chosen) - failed} passed, {failed} failed; pictures are in {arguments.keep}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
