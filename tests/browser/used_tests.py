"""The use of a report: lines and time linked in both directions, keys, touch, picking, files that the user drops onto it."""
import json
import os

import fixtures
from bench import HERE, PHONE, READ_OUT, same, test, true


@test
def linked(bench):
    """A click on a line shows the pose at the end of its block; a click on the timeline shows the line."""
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
    same("help begins at its top", page.run("document.querySelector('dialog').scrollTop"), 0)
    page.press("Escape")
    true("help closed", not page.run("document.querySelector('dialog').open"))
    # Every control can be reached by Tab, shows the focus, and has a label.
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
    # Faint bodies are not picked.
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
    # The table is 200 wide and 60 tall; a click near a corner means the corner.
    page.press("m")
    for point in ([-99, -100, 1], [99, -100, 59]):
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
    """A report without the text of the program takes it from the user if it is the right file."""
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
    """The lines of a subprogram are shown with its file; the card names its caller, and a click shows that line."""
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
    """Work coordinates in the active offset, feed and spindle speed, as a control shows them: they equal the numbers in the program."""
    machine, setup, _ = fixtures.boxes(bench.work)
    program = os.path.join(bench.work, "read-outs.nc")
    with open(program, "w", encoding="utf-8") as file:
        file.write("G21 G90 G17\nT1 M6\nS1200 M4\nG54 G43 H1\nG0 X-90 Y3 Z120\nG1 Z90 F600\nG92 X0\nX10 F450.5\nG53 G0 Z0\nM2\n")
    path, findings = bench.report("read-outs", machine, setup, program, "--all")
    same("findings", findings, [])
    page = bench.open(path)
    work = "Object.fromEntries([...document.querySelectorAll('.readout dl div:not(.heads)')].map((row) => [row.children[0].textContent, row.children[2].textContent]))"
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
    """1,000,000 blocks: at most 5 MB, and every time can be shown."""
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
