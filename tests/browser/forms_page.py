"""The forms of the page, filled in as a person would: they write the same files as the command line, which also checks them."""
import json
import os
import re
import subprocess
import tempfile

import fixtures
from bench import same, test, true
from page_bench import VERDICTS


@test
def form(bench):
    """From the form to the XML, first with an error at a field, then to a check with this file."""
    page = bench.open()
    page.run("document.querySelector('#form-details').open = true")
    page.run("document.querySelector('#fill-example').click()")
    page.run("document.querySelector('[name=\"Z.min\"]').value = '400'")
    page.run("document.querySelector('#write-machine').click()")
    page.run("await until('machine-written', 1)")
    true("the fault stands at Z", "limit_min is to be less than limit_max" in page.run("document.querySelector('[data-axis=Z] .fault').textContent"))
    same("faults elsewhere", page.run("[...document.querySelectorAll('.fault')].filter((f) => f.textContent).length"), 1)
    true("nothing to download", page.run("document.querySelector('#machine-made').hidden"))
    page.run("document.querySelector('[name=\"Z.min\"]').value = '-400'")
    page.run("document.querySelector('[name=\"A.title\"]').value = 'First <b>axis</b>'")
    page.run("document.querySelector('#write-machine').click()")
    page.run("await until('machine-written', 2)")
    xml = page.run("document.querySelector('#machine-xml').value")
    native = subprocess.run(
        [bench.fivecheck, "init", "table-table", "--rotary=A,C", "--limits=X=-300:300", "--limits=Y=-250:250", "--limits=Z=-400:0",
         "--limits=A=-120:30", "--title=A=First <b>axis</b>", "--location=A=0,0,120", "--limits=C=none", "--location=C=0,0,120",
         "--spindle=0,0,520", "--workholding=0,0,80", "--dialect=linuxcnc"], capture_output=True, text=True, check=False)
    same("XML", xml, native.stdout)
    page.run("document.querySelector('#use-machine').click()")
    page.run("await new Promise((done) => setTimeout(done))")
    page.run("await window.fivecheckPage.add([['part.nc', new Blob(['G0 X10\\n'])]])")
    bench.check(page)
    same("verdict", page.run(VERDICTS), [["part.nc", "incomplete"]])
    true("the missing meshes are named", ".stl" in page.run("document.querySelector('.findings').textContent"))
    bench.done(page, "page-form")


def after(page, event, action):
    """Does something and waits for the event that it causes."""
    before = page.run(f"counts['{event}']")
    action()
    page.run(f"await until('{event}', {before + 1})")


def write(page, kind):
    """Presses the button of a form and waits for its message."""
    after(page, f"{kind}-written", lambda: page.run(f"document.querySelector('#write-{kind}').click()"))


def enter(page, form, **fields):
    """Types into fields and leaves each of them."""
    for name, text in fields.items():
        page.run("((field) => { field.value = %s; field.dispatchEvent(new Event('change', {bubbles: true})); })(document.querySelector(%s))"
                 % (json.dumps(text), json.dumps(f"#{form}-form [name='{name.replace('__', '.')}']")))


def faults(page, form):
    return page.run(f"[...document.querySelectorAll('#{form}-form .fault')].map((e) => e.textContent).filter(Boolean)")


@test
def numbers(bench):
    """A decimal comma is read and shown as a point; a possible thousands separator and text that is no number are reported at their fields."""
    page = bench.open()
    page.run("document.querySelector('#form-details').open = true")
    page.run("document.querySelector('#fill-example').click()")
    enter(page, "machine", A__location__z="120,5", spindle__z="1,200", C__location__x="12a", C__location__y="")
    same("the comma", page.run("document.querySelector('[name=\"A.location.z\"]').value"), "120.5")
    write(page, "machine")
    same("faults", faults(page, "machine"), ["location_x, mm: '12a' is not a number\nlocation_y, mm: a number is missing\n",
                                             "z, mm: '1,200' may be 1200 or 1.2: write it without the comma\n"])
    same("focus", page.run("document.activeElement.name"), "C.location.x")
    same("what a screen reader says of the field", page.run("document.getElementById(document.activeElement.getAttribute('aria-describedby')).textContent"), faults(page, "machine")[0])
    true("no file", page.run("document.querySelector('#machine-made').hidden"))
    enter(page, "machine", spindle__z="520", C__location__x="0", C__location__y="-,5", X__min="", C__direction__z="-1")
    write(page, "machine")
    same("a travel with one end, a direction with one number", faults(page, "machine"),
         ["limit_min, mm: a number is missing\n", "give all three numbers, or none\n"])
    true("the field is seen", page.run("document.querySelector('[name=\"C.direction.x\"]').checkVisibility()"))
    enter(page, "machine", X__min="\u2212300", C__direction__z="")
    write(page, "machine")
    same("faults at last", faults(page, "machine"), [])
    xml = page.run("document.querySelector('#machine-xml').value")
    true("numbers in the file", 'location="0 0 120.5"' in xml and 'location="0 -0.5 120"' in xml and 'limit_min="-300"' in xml)
    page.run("document.querySelector('#options [name=clearance]').value = '0,5'")
    same("the distance to keep", page.run("fivecheckPage.optionsOf()[0]"), "--clearance=0.5")
    bench.done(page)


@test
def own_machine(bench):
    """With STL files and a program alone, the two forms lead to a verdict, and the page says what is still missing."""
    page = bench.open()
    job = "document.querySelector('#job').textContent"
    with tempfile.TemporaryDirectory() as work:
        for name, low, high in [("bed", (-300, -300, -80), (300, 300, -40)), ("table", (-100, -100, -20), (100, 100, 0)), ("cradle", (-200, -30, -30), (-120, 30, 30)),
                                ("head", (-40, -40, 420), (40, 40, 600)), ("vise", (-50, -50, 0), (50, 50, 60))]:
            fixtures.stl_box(os.path.join(work, f"{name}.stl"), low, high)
        page.run("await fivecheckPage.add([['part.nc', new Blob(['G21 G90 G94 G61\\n(T9 is in the drawer)\\nT7 M6\\nG43 H7\\nG54 G0 X0 Y0\\nG0 Z30\\nM2\\n'])]])")
        page.run("document.querySelectorAll('details').forEach((e) => e.open = true)")
        for field, name in [("base.body", "bed"), ("C.body", "table"), ("A.body", "cradle"), ("Z.body", "head")]:
            page.choose(f".mesh:has([name='{field}']) input[type=file]", [os.path.join(work, f"{name}.stl")])
        page.run("document.querySelector('#fill-example').click()")
        enter(page, "machine", A__location__z="0", C__location__z="0", spindle__z="420", workholding__z="0")
        write(page, "machine")
        after(page, "files-shown", lambda: page.run("document.querySelector('#use-machine').click()"))
        said = page.run(job)
        true(f"what is missing: {said}", "Y_slide.stl" in said and "X_slide.stl" in said and "head.stl" not in said and "Without a setup" in said)
        for name in ("X_slide", "Y_slide"):
            fixtures.stl_box(os.path.join(work, f"{name}.stl"), (-40, 200 if name == "Y_slide" else 150, 700), (40, 260, 760))
        after(page, "files-shown", lambda: page.choose("#choose", [os.path.join(work, f"{name}.stl") for name in ("X_slide", "Y_slide")]))
        true("no mesh is missing", "slide" not in page.run(job))
        same("the tool of the program", page.run("[...document.querySelectorAll('#tools [name$=number]')].map((e) => e.value)"), ["7"])
        same("offsets of the machine's axes", page.run("[...document.querySelectorAll('#offsets label:not([hidden]):has([name^=\"offset-\"]:not([name$=name]))')].map((e) => e.textContent)"),
             ["X, mm", "Y, mm", "Z, mm", "A, degrees", "C, degrees"])
        os.mkdir(os.path.join(work, "other"))
        fixtures.stl_box(os.path.join(work, "other", "table.stl"), (-10, -10, 0), (10, 10, 20))
        for folder, words in (("other", True), (".", True), (".", False)):
            after(page, "files-shown", lambda: page.choose("#choose", [os.path.join(work, folder, "table.stl")]))
            same("another mesh of the same name is told", "Another table.stl took the place" in page.run(job), words)
        after(page, "files-shown", lambda: page.choose("[data-kind=fixture] .mesh input[type=file]", [os.path.join(work, "vise.stl")]))
        write(page, "setup")
        same("nothing is guessed", [fault.count("a number is missing") for fault in faults(page, "setup")], [3, 5])
        row = page.run("document.querySelector('#tools [data-row]').dataset.row")
        tool = {"length": "120", "holderLength": "100", "holderDiameter": "50,5", "cutterLength": "40", "cutterDiameter": "10"}
        offset = page.run("document.querySelector('[data-kind=offset]').dataset.row")
        enter(page, "setup", **{f"{offset}__{axis}": value for axis, value in (("X", "0"), ("Y", "0"), ("Z", "-400"))}, **{f"{row}__{name}": value for name, value in tool.items()})
        write(page, "setup")
        same("faults", faults(page, "setup"), ["holder and cutter together are longer than the tool\n"])
        enter(page, "setup", **{f"{row}__holderLength": "60"})
        write(page, "setup")
        after(page, "files-shown", lambda: page.run("document.querySelector('#use-setup').click()"))
        same("nothing is missing", page.run(job), "")
        same("the first files", page.run("[...document.querySelectorAll('#file-list li')].slice(0, 3).map((e) => e.dataset.role)"), ["machine", "setup", "program"])
        bench.check(page)
        same("verdict", page.run(VERDICTS), [["part.nc", "found"]])
        true("the tool meets the vise", "vise and T7" in page.run("document.querySelector('.findings').textContent"))
        # The same files on the command line.
        for kind in ("machine", "setup"):
            with open(os.path.join(work, f"{kind}.xml"), "w", encoding="utf-8") as file:
                file.write(page.run(f"document.querySelector('#{kind}-xml').value").replace("stl/", ""))
        with open(os.path.join(work, "part.nc"), "w", encoding="utf-8") as file:
            file.write("G21 G90 G94 G61\n(T9 is in the drawer)\nT7 M6\nG43 H7\nG54 G0 X0 Y0\nG0 Z30\nM2\n")
        done = subprocess.run([bench.fivecheck, "--setup=setup.xml", "machine.xml", "part.nc"], cwd=work, capture_output=True, text=True, check=False)
        same(f"exit status: {done.stderr}", done.returncode, 1)
        bench.done(page, "page-own-machine")


FAMILIES = {
    "table-table": ("A,C", ["A=-120:30", "C=none"]),
    "head-head": ("C,B", ["C=-360:360", "B=-110:110"]),
    "head-table": ("B,C", ["B=-30:120", "C=none"]),
    "nutating-table": ("B,C", ["B=0:180", "C=none"]),
    "nutating-head": ("C,B", ["C=-360:360", "B=-180:180"]),
}


@test
def families(bench):
    """Every family and every option of init can be given in the form, and the files are the same."""
    page = bench.open()
    page.run("document.querySelector('#form-details').open = true")
    known = subprocess.run([bench.fivecheck, "init", "none"], capture_output=True, text=True, check=False).stderr
    same("the families of init", page.run("[...document.querySelectorAll('[name=family] option')].map((e) => e.value)"),
         known.split("is not one of ")[1].splitlines()[0].split(", "))
    for family, (rotary, limits) in FAMILIES.items():
        enter(page, "machine", family=family)
        page.run("document.querySelector('#fill-example').click()")
        write(page, "machine")
        same(f"faults of {family}", faults(page, "machine"), [])
        example = page.run(f"(await import('./machine_families.js')).EXAMPLES['{family}']")
        vector = lambda name: ",".join(example[f"{name}.{k}"] for k in "xyz")  # noqa: E731
        told = [f"--limits={axis}={example[f'{axis}.min']}:{example[f'{axis}.max']}" for axis in "XYZ"] + [f"--limits={limit}" for limit in limits]
        native = subprocess.run(
            [bench.fivecheck, "init", family, f"--rotary={rotary}", *told, *[f"--location={axis}={vector(f'{axis}.location')}" for axis in rotary.split(",")],
             *(["--table=Y"] if family == "head-table" else []), *(["--inclination=B=45"] if family.startswith("nutating") else []),
             f"--spindle={vector('spindle')}", f"--workholding={vector('workholding')}", "--dialect=linuxcnc"], capture_output=True, text=True, check=False)
        same(f"XML of {family}", page.run("document.querySelector('#machine-xml').value"), native.stdout)
        chains = page.run("document.querySelector('#machine-chains').textContent")
        same("what carries what", chains.replace(" \u2192 ", " > ") in native.stderr, True)
    # The last one, with all other options.
    enter(page, "machine", units="inch", rapid="dogleg", dialect="fanuc", name="Portal <2>", **{"spindle-direction__x": "0"}, A__home="7",
          **{f"{axis}__rate": str(1000 * i) for i, axis in enumerate("XYZCB", 1)}, C__title="turn & tilt", B__home="12", B__inclination="50",
          Z__direction__x="0", Z__direction__y="0", Z__direction__z="-1", base__body="bed.stl, left.stl", B__body="head.stl")
    page.run("['X', 'Z'].forEach((axis) => document.querySelector(`[name=\"${axis}.table\"]`).click())")
    same("orders", page.run("[...document.querySelectorAll('[name=\"order.table\"] option')].map((e) => e.value)"), ["X,Z", "Z,X"])
    enter(page, "machine", **{"order__table": "Z,X", "spindle-direction__z": "-1", "spindle-direction__y": "0"})
    write(page, "machine")
    same("faults", faults(page, "machine"), [])
    true("inches", page.run("document.querySelector('[name=\"X.min\"]').closest('label').textContent") == "limit_min, inch")
    native = subprocess.run(
        [bench.fivecheck, "init", family, f"--rotary={rotary}", *told, *[f"--location={axis}={vector(f'{axis}.location')}" for axis in rotary.split(",")],
         "--table=Z,X", "--inclination=B=50", "--direction=Z=0,0,-1", "--rates=X=1000,Y=2000,Z=3000,C=4000,B=5000", "--home=B=12", "--title=C=turn & tilt",
         "--body=base=bed.stl", "--body=base=left.stl", "--body=B=head.stl", f"--spindle={vector('spindle')}", "--spindle-direction=0,0,-1",
         f"--workholding={vector('workholding')}", "--name=Portal <2>", "--units=inch", "--dialect=fanuc", "--rapid=dogleg"], capture_output=True, text=True, check=False)
    same("XML with everything", page.run("document.querySelector('#machine-xml').value"), native.stdout)
    enter(page, "machine", B__home="500", Y__body="slide.stl", B__body="head.stl, x/slide.stl")
    write(page, "machine")
    true("a fault of init stands at its field", "the home of B" in page.run("document.querySelector('[data-axis=B] .fault').textContent"))
    enter(page, "machine", B__home="")
    write(page, "machine")
    true("one of a mesh, too", "x/slide.stl another name" in page.run("document.querySelector('[data-axis=B] .fault').textContent"))
    bench.done(page, "page-families")


def attributes_of_schema():
    """The attributes of <controller> in the schema with their choices; a number has none."""
    with open("src/machine/xml/machine.rng", encoding="utf-8") as file:
        part = file.read().split('<define name="controller-attributes">')[1].split("</define>")[0]
    told = {name: set(re.findall("<value>(.*?)</value>", body)) for name, body in re.findall(r'<attribute name="(\w+)">(.*?)</attribute>', part, re.S)}
    return {name: choices for name, choices in told.items() if name not in ("dialect", "rapid")}


@test
def control(bench):
    """Every attribute of <controller> with every choice can be given in the form for the controls that have it; the file is that of `fivecheck init`."""
    page = bench.open()
    page.run("document.querySelector('#form-details').open = true")
    page.run("document.querySelector('#fill-example').click()")
    rest = ["--rotary=A,C", "--limits=X=-300:300", "--limits=Y=-250:250", "--limits=Z=-400:0", "--limits=A=-120:30", "--location=A=0,0,120", "--limits=C=none",
            "--location=C=0,0,120", "--spindle=0,0,520", "--workholding=0,0,80"]
    offered = {}
    for dialect in ("linuxcnc", "fanuc", "haas", "sinumerik", "klartext"):
        enter(page, "machine", dialect=dialect)
        fields = page.run("[...document.querySelectorAll('#control [name]')].map((field) => [field.name.slice(11), [...field.options ?? []].map(({value}) => value).filter(Boolean)])")
        for name, choices in fields:
            offered.setdefault(name, set()).update(choices)
        told = {name: choices[-1] if choices else "0.25" for name, choices in fields}
        enter(page, "machine", **{f"controller__{name}": value.replace(".", ",") if value == "0.25" else value for name, value in told.items()}, change__Z="-10", change__A="20,5")
        write(page, "machine")
        same(f"faults of {dialect}", faults(page, "machine"), [])
        native = subprocess.run([bench.fivecheck, "init", "table-table", *rest, f"--dialect={dialect}", "--tool-change=Z=-10,A=20.5",
                                 *(f"--controller={name}={value}" for name, value in told.items())], capture_output=True, text=True, check=False)
        same(f"XML for {dialect}: {native.stderr}", page.run("document.querySelector('#machine-xml').value"), native.stdout)
    same("all attributes with all their choices", offered, attributes_of_schema())
    enter(page, "machine", dialect="linuxcnc", controller__path_tolerance="0", change__Z="1")
    page.run("document.querySelector('[name=\"change.none\"]').click()")
    write(page, "machine")
    same("the fault", faults(page, "machine"), ["path_tolerance of <controller> must be greater than 0\n"])
    same("its field has the focus", page.run("[document.activeElement.name, document.activeElement.getAttribute('aria-invalid')]"), ["controller.path_tolerance", "true"])
    enter(page, "machine", controller__path_tolerance="0.1")
    write(page, "machine")
    true("the tool is changed where the spindle stands", "<tool_change/>" in page.run("document.querySelector('#machine-xml').value"))
    page.run("document.querySelector('[name=\"change.none\"]').click()")
    write(page, "machine")
    same("a place out of reach", faults(page, "machine"), ["the tool-change of Z, 1, is outside its travel: --tool-change=Z=VALUE\n"])
    page.run("document.querySelector('[data-axis=control]').scrollIntoView()")
    bench.done(page, "page-control")


@test
def setup_form(bench):
    """Offsets, fixtures at two places, stock of each form, tools with every tip: the command line reads the file as intended."""
    page = bench.open()
    page.run("document.querySelectorAll('section > details').forEach((e) => e.open = true)")
    with open("machines/ac-trunnion/machine.xml", encoding="utf-8") as file:
        machine = file.read()
    program = "G21 G90 G54\nT12 M6\nG55 G0 X0\nG54.1P3 X0\nT3 M6\nM2\n"
    page.run("await fivecheckPage.add([['machine.xml', new Blob([%s])], ['part.nc', new Blob([%s])]])" % (json.dumps(machine), json.dumps(program)))
    rows = lambda kind: page.run(f"[...document.querySelectorAll('[data-kind={kind}]')].map((e) => e.dataset.row)")  # noqa: E731
    same("offsets of the program", page.run("[...document.querySelectorAll('[data-kind=offset] [name$=name]')].map((e) => e.value)"), ["G54", "G55", "G54.1 P3"])
    same("tools of the program", page.run("[...document.querySelectorAll('[data-kind=tool] [name$=number]')].map((e) => e.value)"), ["3", "12"])
    page.run("document.querySelectorAll('[data-kind=offset] button').forEach((e, i) => i && e.click())")
    for kind in ("fixture", "tool", "tool"):
        page.run(f"document.querySelector('#add-{kind}').click()")
    (offset,), fixture, tool, (part,) = rows("offset"), rows("fixture"), rows("tool"), rows("part")

    def into(row, **fields):
        enter(page, "setup", **{f"{row}__{name}": value for name, value in fields.items()})

    into(offset, X="1", Y="-2.5", Z="-385", A="0", C="90")
    into(fixture[0], mesh="fixtures/part.stl, vise.stl", location__z="20")
    into(fixture[1], mesh="other/vise.stl", location__x="5", rotation__z="45")
    into(part, mesh="impeller.stl", gouge="0.05")
    for row, tip in zip(tool, ["flat", "ball", "bull", "cone"]):
        into(row, tip=tip, length="120", holderLength="50", holderDiameter="40", cutterLength="30", cutterDiameter="12")
    write(page, "setup")
    same("what a tip needs", [fault.strip() for fault in faults(page, "setup")], ["corner radius, mm: a number is missing", "angle of the cone, degrees: a number is missing"])
    into(tool[2], corner="7")
    into(tool[3], angle="118", hand="right", lengthOffset="119.5", flutes="20", holderEnd="30", collarLength="10", collarDiameter="28", shankDiameter="11")
    write(page, "setup")
    same("what it may be", [fault.strip() for fault in faults(page, "setup")], ["the corner radius is more than 0 and at most half the diameter"])
    number = page.run(f"document.querySelector('[name=\"{tool[3]}.number\"]').value")
    into(tool[2], corner="2", kind="probe")
    into(tool[3], number="3")
    write(page, "setup")
    same("a number that is there twice", [fault.strip() for fault in faults(page, "setup")], ["3 is there twice"])
    into(tool[3], number=number)
    written = {}
    for form, fields in {"": {}, "box": {"size__x": "100", "size__y": "80", "size__z": "50"}, "cylinder": {"diameter": "90", "height": "60,5"}, "mesh": {"mesh": "blank.stl", "location__z": "-3"}}.items():
        into("stock", form=form)
        into("stock", **fields)
        write(page, "setup")
        same(f"faults with the stock {form}", faults(page, "setup"), [])
        written[form] = page.run("document.querySelector('#setup-xml').value")
    same("stock", [next((line.strip() for line in text.splitlines() if "<stock" in line), "") for text in written.values()],
         ["", '<stock box="100 80 50"/>', '<stock cylinder="90 60.5"/>', '<stock mesh="blank.stl" location="0 0 -3"/>'])
    true("names that are free", all(f'<fixture name="{name}" mesh="{mesh}" {place}/>' in written[""] for name, mesh, place in
         [("part 1", "fixtures/part.stl", 'location="0 0 20"'), ("vise", "vise.stl", 'location="0 0 20"'), ("vise 1", "other/vise.stl", 'location="5 0 0" rotation="0 0 45"')]))
    with tempfile.TemporaryDirectory() as work:
        os.mkdir(os.path.join(work, "fixtures"))
        os.mkdir(os.path.join(work, "other"))
        for name in ("fixtures/part", "vise", "other/vise", "impeller", "blank"):
            fixtures.stl_box(os.path.join(work, f"{name}.stl"), (-9, -9, 0), (9, 9, 9))
        for form, text in written.items():
            path = os.path.join(work, "setup.xml")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            done = subprocess.run([bench.fivecheck, "--check-machine", f"--setup={path}", "machines/ac-trunnion/machine.xml"], capture_output=True, text=True, check=False)
            same(f"errors of the setup with the stock {form}", [line for line in done.stderr.splitlines() if "error" in line], [])
            for words in ("T12", "part 1", "vise 1", "impeller"):
                true(f"{words} is read: {done.stdout}", words in done.stdout)
    xml = written[""]
    same("the next free number", number, "14")
    true("a tool with all it can have", """  <tool number="14" length="120" length_offset="119.5" hand="right">
    <holder>
      <section length="50" diameter="40" diameter_end="30"/>
      <section length="10" diameter="28"/>
    </holder>
    <shank>
      <section length="30" diameter="11"/>
    </shank>
    <cutter tip="cone" angle="118" flute_length="20">
      <section length="30" diameter="12"/>
    </cutter>
  </tool>""" in xml)
    true("a bull-nose", '<cutter tip="bull" corner="2">' in xml and 'kind="probe"' in xml)
    bench.done(page, "page-setup-form")


@test
def setup_stock(bench):
    """A blank and a bull-nose of the form: a rapid into the blank is found, as on the command line."""
    page = bench.open()
    bench.example(page, "ac-trunnion")
    program = "G21 G90 G94 G54\nT1 M6\nG43 H1\nS5000 M3\nG0 X0 Y0\nG0 Z100\nG0 Z20\nM2\n"
    page.run("fivecheckPage.setFiles(fivecheckPage.files.filter(({role}) => role === 'machine' || role === 'mesh'))")
    page.run("await fivecheckPage.add([['part.nc', new Blob([%s])]])" % json.dumps(program))
    page.run("document.querySelector('#setup-details').open = true")
    offset, tool = page.run("['offset', 'tool'].map((kind) => document.querySelector(`[data-kind=${kind}]`).dataset.row)")
    enter(page, "setup", **{"stock__form": "box"})
    enter(page, "setup", **{f"stock__size__{k}": v for k, v in zip("xyz", ("90", "90", "60"))}, **{f"{offset}__{k}": v for k, v in (("X", "0"), ("Y", "0"), ("Z", "-440"))},
          **{f"{tool}__{k}": v for k, v in {"tip": "bull", "length": "120", "holderLength": "60", "holderDiameter": "50", "cutterLength": "40", "cutterDiameter": "12"}.items()})
    enter(page, "setup", **{f"{tool}__corner": "1,5"})
    write(page, "setup")
    same("faults", faults(page, "setup"), [])
    after(page, "files-shown", lambda: page.run("document.querySelector('#use-setup').click()"))
    bench.check(page)
    same("verdict", page.run(VERDICTS), [["part.nc", "found"]])
    true("the cutter meets the blank at rapid", "rapid-contact: " in page.run("document.querySelector('.findings').textContent"))
    with tempfile.TemporaryDirectory() as work:
        for name, text in (("setup.xml", page.run("document.querySelector('#setup-xml').value")), ("part.nc", program)):
            with open(os.path.join(work, name), "w", encoding="utf-8") as file:
                file.write(text)
        done = subprocess.run(
            [bench.fivecheck, "-f", "ndjson", f"--setup={work}/setup.xml", "machines/ac-trunnion/machine.xml", f"{work}/part.nc"], capture_output=True, text=True, check=False)
        found = [event for event in map(json.loads, done.stdout.splitlines()) if event["kind"] == "rapid-contact"]
        same("line of the command line", [event["line"] for event in found[:1]], [7])
        true("the same line", f"Line {found[0]['line']}: rapid-contact" in page.run("document.querySelector('.findings').textContent"))
    bench.done(page, "page-stock")


@test
def oblique_table(bench):
    """From nothing to a verdict for a machine with an oblique table and a Klartext program: the file from the form is completed in its text field."""
    page = bench.open()
    page.run("document.querySelectorAll('section > details').forEach((e) => e.open = true)")
    program = "BEGIN PGM P MM\nCYCL DEF 247 Q339=+1\nTOOL CALL 5 Z S1000\nM3\nM128\nL X+0 Y+0 Z+200 F5000\nL %s F1000\nEND PGM P MM\n"
    boxes = {"base": ((-300, -300, -300), (300, 300, -200)), "B": ((-60, -60, -180), (60, 60, -20)), "C": ((-100, -100, -20), (100, 100, 0)), "Z": ((-40, -40, 520), (40, 40, 700)),
             "X": ((-40, 40, 600), (40, 300, 760)), "Y": ((-40, 300, -200), (40, 380, 760))}
    with tempfile.TemporaryDirectory() as work:
        for link, (low, high) in boxes.items():
            path = os.path.join(work, f"body-{link}.stl")
            fixtures.stl_box(path, low, high)
            page.choose(f".mesh:has([name='{link}.body']) input[type=file]", [path])
        enter(page, "machine", family="nutating-table", dialect="klartext")
        page.run("document.querySelector('#fill-example').click()")
        write(page, "machine")
        after(page, "files-shown", lambda: page.run("document.querySelector('#use-machine').click()"))
        programs = {"clear.h": program % "B+60 C+45", "hit.h": program % "X+0 Y+0 Z-30"}
        after(page, "files-shown", lambda: page.run("await fivecheckPage.add(%s.map(([name, text]) => [name, new Blob([text])]))" % json.dumps(list(programs.items()))))
        same("the preset and the tool of the programs", page.run("[...document.querySelectorAll('[data-kind=offset] [name$=name], [data-kind=tool] [name$=number]')].map((e) => e.value)"), ["G54.1 P1", "5"])
        offset, tool = page.run("['offset', 'tool'].map((kind) => document.querySelector(`[data-kind=${kind}]`).dataset.row)")
        enter(page, "setup", **{f"{offset}__{axis}": value for axis, value in (("X", "0"), ("Y", "0"), ("Z", "-520"))},
              **{f"{tool}__{k}": v for k, v in {"length": "120", "holderLength": "60", "holderDiameter": "50", "cutterLength": "40", "cutterDiameter": "10"}.items()})
        write(page, "setup")
        same("faults", faults(page, "setup"), [])
        after(page, "files-shown", lambda: page.run("document.querySelector('#use-setup').click()"))
        bench.check(page)
        same("what only the control knows", [verdict for _, verdict in page.run(VERDICTS)], ["incomplete", "incomplete"])
        true("is asked for", "<tool_change" in page.run("document.querySelector('.findings').textContent"))
        link = page.run("document.querySelector('#download-machine').href")
        page.run("((text) => { text.value = text.value.replace(/<controller[^>]*>/, '<controller dialect=\"klartext\" rapid=\"any\" path_tolerance=\"0.01\"><tool_change/></controller>');"
                 " text.dispatchEvent(new Event('input')); })(document.querySelector('#machine-xml'))")
        after(page, "files-shown", lambda: page.run("document.querySelector('#use-machine').click()"))
        true("the edited file is downloaded", page.run("document.querySelector('#download-machine').href") != link)
        bench.check(page, 2)
        same("verdicts", sorted(page.run(VERDICTS)), [["clear.h", "clear"], ["hit.h", "found"]])
        for name, text in {**programs, "machine.xml": page.run("document.querySelector('#machine-xml').value"), "setup.xml": page.run("document.querySelector('#setup-xml').value")}.items():
            with open(os.path.join(work, name), "w", encoding="utf-8") as file:
                file.write(text)
        for name, status in (("clear.h", 0), ("hit.h", 1)):
            done = subprocess.run([bench.fivecheck, "--setup=setup.xml", "machine.xml", name], cwd=work, capture_output=True, text=True, check=False)
            same(f"{name} on the command line: {done.stdout}{done.stderr}", done.returncode, status)
        bench.done(page, "page-oblique-table")
