"""What a report shows: the contact in words and in red, on a desk, on a phone, on paper, and with any names."""
import os
import re

import fixtures
from bench import HERE, PHONE, READ_OUT, RED, WEAK_TEXT, same, test, true


@test
def units(bench):
    """Unit tests of the modules."""
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
    """The example opens at its collision: in words, in red, at the exact axis positions."""
    path, findings = bench.example("ac-trunnion", "collision", "--all")
    page = bench.open(path)
    same("frames of the names", page.run("['.name-a', '.name-b'].map((name) => getComputedStyle(document.querySelector(name)).borderColor)"),
         ["rgb(232, 38, 44)", "rgb(255, 157, 30)"])
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
    with type(bench.browser)() as fresh:
        times = []
        for _ in range(3):
            visit = fresh.page()
            times.append(visit.open(path) / 1000)
            visit.close()
        print(f"  {size / 1000:.0f} kB, shown after {times[0]:.2f} s in a fresh browser, {times[2]:.2f} s in a warm one; "
              f"{fresh.processor_time() / 3:.2f} s of the browser's processor time, drawing in software included")
    true(f"{size} bytes", size <= 150_000)
    bench.done(page, "collision-desk")
    for name, options in {"collision-dark": {"dark": True}, "collision-phone": PHONE}.items():
        bench.done(bench.open(path, **options), name)


@test
def clear(bench):
    """Without a finding nothing is red, and the smallest clearance is named once, with a button that shows it."""
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
        said = page.run("document.querySelector('.findings .card').textContent")
        smallest = page.run("fivecheck.state.model.clearance.smallest")
        for words in (f"at least {smallest['least']:.3f} mm between ", f", in line {smallest['line']}."):
            true(f"{words}: {said}", said.count(words) == 1)
        true("the sentence stands once", page.run("document.querySelector('.app').textContent.split(fivecheck.state.model.sentence).length") == 2)
        page.run("document.querySelector('.findings .card button').click()")
        page.frames()
        same("shown", page.run(HERE), smallest["line"])
        bench.done(page, f"clear-{name}")


@test
def doubts(bench):
    """Doubts stand beside a clear verdict without a click; cautions that a person has settled do not."""
    machine, setup, _ = fixtures.boxes(bench.work)
    program = os.path.join(bench.work, "beside.nc")
    with open(program, "w", encoding="utf-8") as file:
        file.write("G21 G90 G94 G64\nT1 M6\nG53 G0 Z-10\nG53 G1 X80 F900\nG53 G1 Y80 Z-30\nM2\n")
    path, findings = bench.report("doubts", machine, setup, program)
    same("findings", findings, [])
    for name, options in (("doubts-desk", {}), ("doubts-phone", {**PHONE, "dark": True})):
        page = bench.open(path, **options)
        true("clear", page.run("document.querySelector('.app h1').textContent").startswith("Clear"))
        true("the doubt is read at once", page.run("""(() => {
            const doubt = document.querySelector('.doubts .first-doubt'), {top, bottom} = document.querySelector('header').getBoundingClientRect();
            const mine = doubt.getBoundingClientRect();
            return doubt.textContent.startsWith('G64') && mine.height > 10 && mine.top > top && mine.bottom < bottom + 30;
        })()"""))
        same("it is no remark", page.run("document.querySelectorAll('.cautions li').length"), 0)
        same("sideways", page.run("document.documentElement.scrollWidth"), page.run("innerWidth"))
        # There is no part, so the whole path of the tool is in view.
        ways = page.run("""(({camera, canvas, placed}, trace) => [trace.feed.length, [...trace.feed, ...trace.rapid].filter((_, i) => i % 3 === 0).length,
            Array.from({length: (trace.feed.length + trace.rapid.length) / 3}, (_, i) => {
                const all = [...trace.feed, ...trace.rapid], m = placed.links[trace.link], [x, y, z] = all.slice(3 * i, 3 * i + 3);
                const p = [0, 1, 2].map((r) => m[r] * x + m[4 + r] * y + m[8 + r] * z + m[12 + r]);
                const [u, v] = camera.project(p, canvas.clientWidth, canvas.clientHeight);
                return u >= 0 && v >= 0 && u <= canvas.clientWidth && v <= canvas.clientHeight;
            })])(fivecheck.stage, fivecheck.stage.way())""")
        true("there is a way", ways[0] > 0)
        same("points of the way beside the picture", ways[2].count(False), 0)
        bench.done(page, name)
    page = bench.open(bench.example("cb-head", "clear")[0])
    same("neighbours are no doubt", page.run("[document.querySelectorAll('.doubts').length, document.querySelectorAll('.cautions li').length]"), [0, 1])
    bench.done(page)


@test
def other_examples(bench):
    """The contact is also visible on the other machines."""
    for name in ("b-head-c-table", "cb-head"):
        path, _ = bench.example(name, "collision", "--all")
        page = bench.open(path)
        true("red pixels", page.run(RED) > 500)
        bench.done(page, f"collision-{name}")


@test
def index(bench):
    """The index of several programs leads to each report, and each verdict has its colour."""
    machine, setup, program = fixtures.boxes(bench.work)
    folder, path = os.path.dirname(program), os.path.join(bench.work, "several.html")
    for name, text in {"high.nc": "G21 G90 G61\nG0 X10\nM2\n", "odd.nc": "G777\n"}.items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)
    fixtures.run(bench.fivecheck, machine, f"--setup={setup}", *(os.path.join(folder, name) for name in ("high.nc", "part.nc", "odd.nc")), f"--report={path}")
    page = bench.browser.page()
    page.open_without_scripts(path)
    same("verdicts", page.run("[...document.querySelectorAll('tr td:nth-child(2)')].map((e) => e.textContent)"), ["clear", "found", "incomplete"])
    same("colours", page.run("new Set([...document.querySelectorAll('tr td:nth-child(2)')].map((e) => getComputedStyle(e).color)).size"), 3)
    same("weak text", page.run(WEAK_TEXT), [])
    true("links", page.run("[...document.querySelectorAll('td a')].every((e) => /^several-.*[.]html$/.test(e.getAttribute('href')))"))
    bench.done(page, "index")


@test
def program_error(bench):
    """An error of the program has a card that leads to its line; the report opens where the check ended."""
    machine, setup, program = fixtures.boxes(bench.work)
    path = os.path.join(bench.work, "error.html")
    faulty = os.path.join(os.path.dirname(program), "faulty.nc")
    with open(program, encoding="utf-8") as file, open(faulty, "w", encoding="utf-8") as other:
        lines = file.read().splitlines()
        other.write("\n".join([*lines[:5], "G0 Z190", *["(a remark)"] * 60, "G777 X1", *lines[6:]]) + "\n")
    done = fixtures.run(bench.fivecheck, machine, f"--setup={setup}", faulty, f"--report={path}")
    same("exit status", done.returncode, 2)
    page = bench.open(path)
    same("headline", page.run("document.querySelector('.app h1').textContent"), "Incomplete: an error in line 67")
    same("the last block that was checked", page.run(HERE), 6)
    true("the error in words", "G777" in page.run("document.querySelector('.card.error').textContent"))
    page.run("document.querySelector('.card.error button').click()")
    page.frames()
    same("the line of the error", page.run("document.querySelector('.row.faulty')?.dataset.line"), "67")
    same("weak text", page.run(WEAK_TEXT), [])
    bench.done(page, "program-error")


@test
def sensitivity(bench):
    """The card says how many mm are needed: the block is 40 high, the tool passes 10 above its foot. Without --sensitivity it names this option."""
    machine, setup, program = fixtures.boxes(bench.work)
    path, _ = bench.report("sensitivity", machine, setup, program, "--sensitivity=0,0,0,50")
    page = bench.open(path)
    text = page.run("document.querySelector('.card .cure').textContent")
    needed = re.fullmatch(r"Needs at least ([0-9.]+) mm: with the tool farther back by that \(length offset \+\1 mm\) nothing is found; "
                          r"([0-9.]+) mm is not enough\.", text)
    true(text, needed and 30 <= float(needed[1]) < 30.1 and 29.9 < float(needed[2]) <= 30)
    bench.done(page, "sensitivity")
    path, _ = bench.report("sensitivity-small", machine, setup, program, "--sensitivity=0,0,0,5")
    page = bench.open(path)
    same("too small a range", page.run("document.querySelector('.card .cure').textContent"),
         "No change of the setup that was tried, up to 5 mm, is enough (--sensitivity).")
    bench.done(page)
    path, _ = bench.report("sensitivity-none", machine, setup, program)
    page = bench.open(path)
    same("how to ask", page.run("document.querySelector('.card .question').textContent"),
         "How many mm are needed? Check again with --sensitivity=0,0,0,50.")
    bench.done(page)


@test
def columns(bench):
    """The two columns of axis values have headings, each above its column; the scale of the curve claims nothing."""
    page = bench.open(bench.example("ac-trunnion", "collision", "--all")[0])
    same("heads", page.run("[...document.querySelectorAll('.readout .heads dd')].map((head) => head.textContent)"), ["machine", "work"])
    right = page.run("""[...document.querySelectorAll('.readout dl > div')].map((row) => [...row.querySelectorAll('dd')].map((e) => Math.round(e.getBoundingClientRect().right)))""")
    true(f"right edges {right}", len({tuple(row) for row in right}) == 1 and len(right) == 6)
    bench.done(page)


@test
def limit(bench):
    """If an axis leaves its travel, the bodies that it carries are red, and the words say how far it is outside."""
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
def words(bench):
    """A cutter enters the material, not the reverse; both are named in the picture of a phone; the requirement is stated and drawn."""
    path, findings = bench.report("stock-rapid", "machines/ac-trunnion/machine.xml", "examples/stock/setup.xml", "examples/stock/rapid.nc")
    same("finding", [findings[0][key] for key in ("kind", "a", "b")], ["rapid-contact", "block", "T1 cutter"])
    page = bench.open(path, **PHONE)
    true("what enters what", "T1 cutter enters block" in page.run("document.querySelector('.app h1').textContent"))
    true("how deep it may", "0.25 mm deep" in page.run("document.querySelector('.card').textContent"))
    same("names", page.run("[...document.querySelectorAll('.label')].map((label) => label.textContent).sort()"), ["T1 cutter", "block"])
    true("the buttons of the card can be reached", page.run(
        "document.querySelector('.card .actions').getBoundingClientRect().bottom <= document.querySelector('.findings').getBoundingClientRect().bottom"))
    bench.done(page, "rapid-phone")
    page = bench.open(bench.example("ac-trunnion", "clear", "--clearance=5")[0])
    # The probe is in a bore: from the front its tip would be hidden.
    same("what stands before the contact", page.run("""(({camera, placed}, {point, bodies}) => {
        const way = point.map((v, k) => v - camera.eye()[k]), far = Math.hypot(...way);
        return placed.hit(camera.eye(), way.map((v) => v / far), far - 0.5, bodies);
    })(fivecheck.stage, fivecheck.stage.finding())"""), None)
    true("the distance that is required", "required: more than 5 mm" in page.run("document.querySelector('.card').textContent"))
    bench.done(page, "clearance-desk")


@test
def narrow(bench):
    """In a narrow frame, as on a phone, the axis positions cover no names, and no label of a button is broken."""
    page = bench.open(bench.example("ac-trunnion", "collision")[0], width=318, height=640, scale=2, mobile=True)
    same("names under the positions", page.run("""(({bottom}) => [...document.querySelectorAll('.stage .label')].filter((label) => label.getBoundingClientRect().top < bottom).length)(
        document.querySelector('.readout').getBoundingClientRect())"""), 0)
    same("buttons of two lines", page.run("[...document.querySelectorAll('.play button')].filter((e) => e.clientHeight > 40).length"), 0)
    same("sideways", page.run("document.documentElement.scrollWidth"), 318)
    bench.done(page, "narrow")


@test
def poses(bench):
    """At the finding, every body is where --pose puts it, to the accuracy that the report states."""
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
    """Names, comments and code are always shown as text."""
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
    """Without WebGL, without JavaScript and on paper the plain HTML says which bodies collide and where."""
    path, findings = bench.example("ac-trunnion", "collision", "--all")
    words = [findings[0]["a"], findings[0]["b"], "line 70"]
    text = "document.getElementById('plain').innerText"

    page = bench.browser.page()
    page.open_without_scripts(path)
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
    page.on_paper()
    page.frames()
    for word in words:
        true(f"{word} on paper", word in page.run(text))
    same("the viewer on paper", page.run("getComputedStyle(document.querySelector('.app')).display"), "none")
    bench.done(page, "paper")




@test
def contrast(bench):
    """Contrast of text and background: 4.5 to 1, large text 3 to 1 (WCAG 2.2, 1.4.3)."""
    for program in ("collision", "clear"):
        path, _ = bench.example("ac-trunnion", program, "--all")
        for dark in (False, True):
            page = bench.open(path, dark=dark)
            for tab in range(4):
                page.run(f"document.querySelectorAll('[role=tab]')[{tab}].click()")
                same(f"weak text, {program}, dark {dark}, tab {tab}", page.run(WEAK_TEXT), [])
            bench.done(page)
