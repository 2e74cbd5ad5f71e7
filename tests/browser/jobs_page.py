"""Job files and options on the page: what is checked, the messages, and the equivalent command line."""
import json
import os
import shlex
import subprocess
import tempfile
import zipfile

import fixtures
from bench import same, test, true
from page_bench import VERDICTS, drop

CARDS = "[...document.querySelectorAll('.program')].map((card) => [card.dataset.job, card.dataset.path, card.dataset.verdict])"
JOBS = "[...document.querySelectorAll('.job')].map((part) => [part.dataset.job, part.dataset.verdict, part.querySelector('h3').textContent])"
ADVICE = "document.querySelector('#job').textContent"
WHY = "document.querySelector('#why-not').textContent"


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def waive(bench, folder, *words):
    """Writes waivers.xml, which accepts all findings."""
    native(bench, folder, "-a", "-o", "run.ndjson", *words)
    subprocess.run([bench.fivecheck, "waive", "--reason=soft block", "--until=2099-01-01", "run.ndjson", "-o", "waivers.xml"], cwd=folder, check=True, capture_output=True)
    os.remove(os.path.join(folder, "run.ndjson"))


def native(bench, folder, *words):
    done = subprocess.run([bench.fivecheck, "-f", "ndjson", *words], cwd=folder, capture_output=True, text=True, check=False)
    return done, [json.loads(line) for line in done.stdout.splitlines()]


def jobs(bench, work):
    """A folder with a job file: two machines in separate folders, one with another clearance, three programs, waivers."""
    machine, setup, program = fixtures.boxes(work)
    source, folder = os.path.dirname(machine), os.path.join(work, "cell & co")
    meshes = {name: open(os.path.join(source, f"{name}.stl"), "rb").read() for name in ("table", "head", "block")}  # noqa: SIM115
    for mill in ("mills/one", "mills/two"):
        for name in ("table", "head"):
            os.makedirs(os.path.join(folder, mill), exist_ok=True)
            with open(os.path.join(folder, mill, f"{name}.stl"), "wb") as file:
                file.write(meshes[name])
    write(os.path.join(folder, "mills/one/machine.xml"), read(machine))
    write(os.path.join(folder, "mills/two/machine.xml"), read(machine).replace('limit_max="300"', 'limit_max="90"'))
    write(os.path.join(folder, "op10.xml"), read(setup))
    with open(os.path.join(folder, "block.stl"), "wb") as file:
        file.write(meshes["block"])
    hit = read(program)
    write(os.path.join(folder, "nc/hit.nc"), hit)
    write(os.path.join(folder, "nc/safe.nc"), hit.replace("G0 Z10\n", "G0 Z120\n"))
    write(os.path.join(folder, "nc/spare.nc"), "M2\n")
    waive(bench, folder, "--setup=op10.xml", "mills/one/machine.xml", "nc/hit.nc")
    write(os.path.join(folder, "jobs.xml"), """<?xml version="1.0"?>
<!-- <job name="old" machine="gone.xml"><program file="gone.nc"/></job> -->
<jobs version="1">
  <job name="op10" machine="mills/one/machine.xml" setup="op10.xml">
    <program file="nc/hit.nc"/>
    <program file="nc/safe.nc"/>
  </job>
  <job name="op20" machine="mills/two/machine.xml" setup="op10.xml"><program file="nc/safe.nc"/></job>
  <job name="op30" machine="mills/one/machine.xml" setup="op10.xml" waivers="waivers.xml"><program file="nc/hit.nc"/></job>
</jobs>
""")
    return folder


@test
def job_file(bench):
    """Each job of a job file is checked on its machine, with its setup; its verdicts are those of the command line."""
    page = bench.open()
    with tempfile.TemporaryDirectory() as work:
        folder = jobs(bench, work)
        drop(page, folder)
        same("roles", page.run("['jobs', 'machine', 'setup', 'program', 'waivers'].map((role) => fivecheckPage.of(role).length)"), [1, 2, 1, 3, 1])
        same("why not", page.run(WHY), "")
        same("advice", page.run(ADVICE), "The job file does not name cell & co/nc/spare.nc: not checked.")
        bench.check(page)
        done, events = native(bench, folder, "jobs.xml")
        same("exit status of the command line", done.returncode, 1)
        wanted = [[os.path.basename(event["file"]), event["verdict"]] for event in events if event["kind"] == "program"]
        cards = page.run(CARDS)
        same("verdicts", [[os.path.basename(path), verdict] for _, path, verdict in cards], wanted)
        same("their jobs", [job for job, *_ in cards], ["op10", "op10", "op20", "op30"])
        same("jobs", page.run(JOBS), [["op10", "found", "Job op10: found (1 of 2 programs)"], ["op20", "found", "Job op20: found"], ["op30", "accepted", "Job op30: accepted"]])
        line = page.run("document.querySelector('#results > .copied .command').textContent")
        same("the command line", shlex.split(line), ["fivecheck", "jobs.xml"])
    bench.done(page, "page-jobs")


@test
def job_file_in_pieces(bench):
    """Files dropped without their folders are found, missing files are named, and a faulty job file gets the messages of the command line."""
    page = bench.open()
    with tempfile.TemporaryDirectory() as work:
        folder = jobs(bench, work)
        drop(page, os.path.join(folder, "jobs.xml"))
        said = page.run(ADVICE)
        true(f"missing: {said}", all(name in said for name in ("mills/one/machine.xml", "mills/two/machine.xml", "op10.xml", "nc/hit.nc", "nc/safe.nc", "waivers.xml")) and "gone" not in said)
        bench.check(page)
        same("nothing is there", page.run(CARDS), [[job, path, "incomplete"] for job, path in (("op10", "nc/hit.nc"), ("op10", "nc/safe.nc"), ("op20", "nc/safe.nc"), ("op30", "nc/hit.nc"))])
        text = read(os.path.join(folder, "jobs.xml"))
        write(os.path.join(folder, "jobs.xml"), text.replace("mills/two", "mills/one"))
        drop(page, os.path.join(folder, "jobs.xml"), os.path.join(folder, "mills/one/machine.xml"), *(os.path.join(folder, name) for name in ("nc/hit.nc", "nc/safe.nc", "op10.xml", "waivers.xml")))
        same("only the meshes are missing", page.run(ADVICE), "Not here yet: table.stl, head.stl, block.stl. Drop them, too.")
        drop(page, os.path.join(folder, "mills/one/table.stl"), os.path.join(folder, "mills/one/head.stl"), os.path.join(folder, "block.stl"))
        same("nothing is missing", page.run(ADVICE), "")
        bench.check(page, 2)
        same("verdicts", [verdict for *_, verdict in page.run(CARDS)], ["found", "clear", "clear", "accepted"])
        write(os.path.join(folder, "jobs.xml"), text.replace('name="op20"', 'name="op10"'))
        drop(page, os.path.join(folder, "jobs.xml"))
        bench.check(page, 3)
        done, _ = native(bench, folder, "jobs.xml")
        same("the one verdict", page.run(VERDICTS), [["jobs.xml", "incomplete"]])
        same("its words", page.run("[...document.querySelectorAll('.message')].map((e) => e.textContent)"), done.stderr.splitlines())
        write(os.path.join(folder, "other.xml"), text)
        drop(page, os.path.join(folder, "jobs.xml"), os.path.join(folder, "other.xml"))
        same("two job files", page.run(WHY), "There is more than one job file: remove all but one.")
    bench.done(page)


@test
def waivers(bench):
    """A file of waivers is used, and two setups are reported."""
    page = bench.open()
    with tempfile.TemporaryDirectory() as work:
        machine, _, _ = fixtures.boxes(work)
        folder = os.path.dirname(machine)
        waive(bench, folder, "--setup=setup.xml", "machine.xml", "part.nc")
        drop(page, *(os.path.join(folder, name) for name in ("machine.xml", "setup.xml", "part.nc", "waivers.xml", "table.stl", "head.stl", "block.stl")))
        page.run("document.querySelector('[name=all]').click()")
        bench.check(page)
        done, events = native(bench, folder, "--setup=setup.xml", "-a", "--waivers=waivers.xml", "machine.xml", "part.nc")
        same("verdict", page.run(VERDICTS), [["part.nc", next(event["verdict"] for event in events if event["kind"] == "program")]])
        same("it is accepted", page.run(VERDICTS)[0][1], "accepted")
        write(os.path.join(folder, "setup2.xml"), read(os.path.join(folder, "setup.xml")))
        drop(page, os.path.join(folder, "setup.xml"), os.path.join(folder, "setup2.xml"))
        same("two setups", page.run(WHY), "There is more than one setup: remove all but one.")
    bench.done(page)


def choose(page, **options):
    for name, value in options.items():
        page.run("((field) => { if (field.type === 'checkbox') field.checked = %s; else field.value = %s; field.dispatchEvent(new Event('change', {bubbles: true})); })(document.querySelector(`#options [name='%s']`))"
                 % (json.dumps(bool(value)), json.dumps(str(value)), name.replace("_", "-")))


@test
def options(bench):
    """The options have the words of --help; the shown command line gives the verdict of the page for any file names."""
    page = bench.open()
    told = " ".join(subprocess.run([bench.fivecheck, "--help"], capture_output=True, text=True, check=True).stdout.split())
    for label in page.run("[...document.querySelectorAll('#more-options label')].map((label) => [label.querySelector('code').textContent, label.querySelector('span').textContent])"):
        true(f"as --help says: {label}", " ".join(label) in told)
    with tempfile.TemporaryDirectory() as work:
        machine, setup, program = fixtures.boxes(work)
        folder, names = os.path.dirname(machine), ["-my $(machine).xml", "it's `a` setup.xml", "-part \"1\" &.nc"]
        for old, new in zip((machine, setup, program), names):
            os.rename(old, os.path.join(folder, new))
        write(os.path.join(folder, names[2]), read(os.path.join(folder, names[2])).replace("G0 Z10\n", "G0 Z10 F1\n/G0 X-90\nG1 X-80 X-81 F5000\n"))
        drop(page, *(os.path.join(folder, name) for name in (*names, "table.stl", "head.stl", "block.stl")))
        checks = 0
        for chosen, verdict, used in (
                ({}, "incomplete", None),
                ({"duplicates": "last", "block_delete": True}, "found", ["dialect linuxcnc", "blocks that begin with / skipped", "the last of two like words"]),
                ({"dialect": "fanuc", "tolerance": "0,01", "clearance": "2", "all": True}, None, None),
                ({"dialect": "sinumerik"}, None, None),
                ({"dialect": "", "all": False, "fail_on": "limit"}, "accepted", ["fail-on limit", "tolerance 0.01 mm", "clearance 2 mm"]),
                ({"fail_on": "", "clearance": "0", "tolerance": "", "parse_only": True}, "passed", ["method parse-only"]),
                ({"parse_only": False, "max_blocks": "1000", "include": "."}, "found", ["subprograms in .", "at most 1000 blocks"]),
                ({"max_blocks": "", "sensitivity": "1,1,1,50"}, "found", None),
                ({"max_blocks": "x"}, "incomplete", None)):
            choose(page, **chosen)
            checks += 1
            bench.check(page, checks)
            line = page.run("document.querySelector('.program .command').textContent")
            true(line, line.startswith("fivecheck "))
            done = subprocess.run(["sh", "-c", line.replace("fivecheck", f"'{bench.fivecheck}' -f ndjson", 1)], cwd=folder, capture_output=True, text=True, check=False)
            found = page.run("document.querySelector('.program').dataset.verdict")
            same(f"{line}: {done.stderr}", {"clear": 0, "passed": 0, "accepted": 0, "found": 1, "incomplete": 2}[found], done.returncode)
            events = [json.loads(text) for text in done.stdout.splitlines()]
            same("verdict of the line", found, next((event["verdict"] for event in events if event["kind"] == "program"), "incomplete"))
            same(f"findings of {line}", page.run("[...document.querySelectorAll('.findings > :not(.message)')].length"), sum("fraction" in event for event in events))
            true(f"{line}: {found}", verdict in (None, found))
            words = page.run("document.querySelector('.words')?.textContent ?? ''")
            same("the sensitivity is in the words", "tool length " in words, chosen.get("sensitivity") is not None)
            said = page.run("document.querySelector('.used')?.textContent ?? ''")
            true(f"{line}: {said}", all(word in said for word in used or []))
        button = "document.querySelector('.program .copied button')"
        page.run("Object.defineProperty(navigator, 'clipboard', {value: {writeText: async (text) => { window.copied = text; }}, configurable: true})")
        page.run(f"{button}.click()")
        page.frames()
        same("copied", page.run(f"[window.copied, {button}.textContent]"), [line, "Copied"])
        # A page loaded over http from another computer has no clipboard.
        page.run("Object.defineProperty(navigator, 'clipboard', {value: undefined})")
        page.run(f"{button}.click()")
        page.frames()
        same("selected", page.run(f"[String(getSelection()), {button}.textContent]"), [line, "Selected: copy it"])
    bench.done(page, "page-options")


@test
def edited(bench):
    """A program that was edited on the disk must be dropped again, as the page says; it then replaces the earlier one."""
    page = bench.open()
    with tempfile.TemporaryDirectory() as work:
        _, _, program = fixtures.boxes(work)
        drop(page, os.path.dirname(program))
        bench.check(page)
        same("before", page.run(VERDICTS), [["part.nc", "found"]])
        write(program, read(program).replace("G0 Z10\n", "G0 Z120\n"))
        bench.check(page, 2)
        same("it is not read", page.run(VERDICTS), [["part.nc", "incomplete"]])
        same("what to do", page.run("document.querySelector('.verdict').textContent"),
             "Incomplete: the browser cannot read part.nc any more, because the file was changed or moved. Drop it again.")
        page.run("scrollTo(0, 0)")
        drop(page, program)
        same("in the place of the other", page.run("fivecheckPage.of('program').map(({path}) => path)"), ["boxes-00/part.nc"])
        same("what stands there is old", page.run("document.querySelector('#outdated').checkVisibility()"), True)
        bench.check(page, 3)
        same("after", page.run(VERDICTS), [["part.nc", "clear"]])
    bench.done(page)


@test
def dead_ends(bench):
    """Files that a check cannot use are named, with advice."""
    page = bench.open()
    with tempfile.TemporaryDirectory() as work:
        machine, _, program = fixtures.boxes(work)
        made = {"all.7z": "PK", "mill.mch": "<VcMachine/>", "photo.jpg": "x", "x.xml": "<foo/>", "empty.nc": ""}
        for name, text in made.items():
            write(os.path.join(work, name), text)
        os.mkdir(os.path.join(work, "void"))
        drop(page, os.path.join(work, "void"))
        same("an empty folder", page.run(ADVICE), "There is no file in what was dropped.")
        drop(page, *(os.path.join(work, name) for name in made))
        said = page.run(ADVICE)
        for words in ("Unpack all.7z", "fivecheck import --output=machine mill.mch", "empty.nc: nothing in it", "Not of use for a check: photo.jpg, x.xml."):
            true(f"{words}: {said}", words in said)
        true("no machine", page.run(WHY).startswith("A machine file is missing: drop it, open an example, or write one below."))
        page.run("document.querySelector('#empty').click()")
        drop(page, program)
        same("a program alone", page.run(WHY), "A machine file is missing: drop it, open an example, or write one below.")
        write(os.path.join(work, "up/machine.xml"), read(machine).replace('mesh="', 'mesh="../meshes/'))
        drop(page, os.path.join(work, "up/machine.xml"), *(os.path.join(os.path.dirname(machine), f"{name}.stl") for name in ("table", "head")), os.path.join(os.path.dirname(machine), "setup.xml"),
             os.path.join(os.path.dirname(machine), "block.stl"))
        bench.check(page)
        same("meshes above the machine's folder", page.run(VERDICTS), [["part.nc", "found"]])
    bench.done(page)


@test
def subprograms(bench):
    """A program that others call need not be checked alone, and a finding in it names its file. Files that operating systems add to folders are not programs."""
    page = bench.open()
    with tempfile.TemporaryDirectory() as work:
        _, _, program = fixtures.boxes(work, subprogram=True)
        folder = os.path.dirname(program)
        for clutter in (".DS_Store", "._part.nc", "Thumbs.db", "desktop.ini", "__MACOSX/part.nc", ".git/config"):
            write(os.path.join(folder, clutter), "x")
        drop(page, folder)
        same("programs", page.run("fivecheckPage.of('program').map(({path}) => path).sort()"), ["boxes-01/approach.ngc", "boxes-01/part.nc"])
        same("files", page.run("fivecheckPage.files.length"), 7)
        button = "document.querySelector('[aria-label=\"Use boxes-01/approach.ngc as a subprogram alone\"]')"
        shown = page.run("counts['files-shown']")
        page.run(f"({button}.focus(), {button}.click())")
        page.run(f"await until('files-shown', {shown + 1})")
        same("roles", page.run("[fivecheckPage.of('program').length, fivecheckPage.of('subprogram').length]"), [1, 1])
        same("the focus stays", page.run("document.activeElement.ariaLabel"), "Check boxes-01/approach.ngc by itself")
        bench.check(page)
        same("verdicts", page.run(VERDICTS), [["part.nc", "found"]])
        same("the finding", page.run("document.querySelector('.findings .collision').textContent.split(' (')[0]"), "approach.ngc, line 4: collision: block and T1 cutter")
        page.run("document.activeElement.blur()")
        page.run("document.querySelector('[aria-label=\"Check boxes-01/approach.ngc by itself\"]').click()")
        bench.check(page, 2)
        same("both", sorted(page.run(VERDICTS)), [["approach.ngc", "clear"], ["part.nc", "found"]])
    bench.done(page, "page-subprograms")


def zipped(path, files, **options):
    with zipfile.ZipFile(path, "w", **options) as archive:
        for name, data in files.items():
            archive.writestr(name, data)
    return path


@test
def zip_archives(bench):
    """A ZIP of a job is read like a folder; a broken, encrypted or too large ZIP, or one with paths that lead out of it, is refused with the reason."""
    page = bench.open()
    with tempfile.TemporaryDirectory() as work:
        machine, _, _ = fixtures.boxes(work)
        files = {}
        for name in os.listdir(os.path.dirname(machine)):
            with open(os.path.join(os.path.dirname(machine), name), "rb") as file:
                files[f"jöb/{name}"] = file.read()
        good = zipped(os.path.join(work, "job.zip"), {**files, "jöb/leer/": b""}, compression=zipfile.ZIP_DEFLATED)
        drop(page, good)
        same("files", page.run("fivecheckPage.files.map(({path}) => path).sort()"), sorted(files))
        bench.check(page)
        same("verdict", page.run(VERDICTS), [["part.nc", "found"]])
        same("words", page.run("document.querySelector('.findings .collision').textContent.split(' (')[0]"), "Line 8: collision: block and T1 cutter")
        page.run("(document.querySelector('#empty').click(), scrollTo(0, 0))")
        drop(page, zipped(os.path.join(work, "stored.zip"), files))
        same("stored", page.run("fivecheckPage.files.length"), len(files))
        with open(good, "rb") as file:
            data = file.read()
        page.run("(document.querySelector('#empty').click())")
        page.run("((limits) => limits.bytes = 5e5)((await import('/zip_files.js')).LIMITS)")
        encrypted = bytearray(zipped(os.path.join(work, "plain.zip"), {"a.nc": b"M2\n"}) and open(os.path.join(work, "plain.zip"), "rb").read())  # noqa: SIM115
        for mark, field in ((b"PK\1\2", 8), (b"PK\3\4", 6)):
            encrypted[encrypted.index(mark) + field] |= 1
        longer = bytearray(open(os.path.join(work, "plain.zip"), "rb").read())  # noqa: SIM115
        longer[longer.index(b"PK\1\2") + 24] += 1
        bad = {"cut.zip": (data[:-30], "it has no end: is it whole?"), "text.zip": (b"no archive", "it has no end: is it whole?"), "empty.zip": (b"", "it has no end: is it whole?"),
               "encrypted.zip": (bytes(encrypted), "a.nc is encrypted"), "longer.zip": (bytes(longer), "a.nc cannot be unpacked: has another length than its archive says"),
               "broken.zip": (data.replace(b"PK\1\2", b"PK\1\1"), "its directory is broken")}
        damaged = bytearray(open(os.path.join(work, "plain.zip"), "rb").read())  # noqa: SIM115
        damaged[damaged.index(b"M2\n")] ^= 1
        pair = open(zipped(os.path.join(work, "pair.zip"), {"a.nc": "M2\n", "b.nc": "M30\n"}), "rb").read()  # noqa: SIM115
        bad |= {"damaged.zip": (bytes(damaged), "a.nc cannot be unpacked: was damaged"), "twice.zip": (pair.replace(b"b.nc", b"a.nc"), "a.nc is in it twice"),
                "zero.zip": (pair.replace(b"b.nc", b"b\0nc"), "a file in it has no name, or one with control characters"),
                "drive.zip": (pair.replace(b"b.nc", b"b:nc"), "b:nc leads out of it")}
        for name, (text, _) in bad.items():
            with open(os.path.join(work, name), "wb") as file:
                file.write(text)
        bad["alias.zip"] = (zipped(os.path.join(work, "alias.zip"), {"x/a.nc": "M2\n", "x//./a.nc": "M30\n"}), "x/a.nc is in it twice")
        bad["out.zip"] = (zipped(os.path.join(work, "out.zip"), {"../out.nc": "M2\n"}), "../out.nc leads out of it")
        bad["bomb.zip"] = (zipped(os.path.join(work, "bomb.zip"), {"a.nc": bytes(10 ** 6)}, compression=zipfile.ZIP_DEFLATED), "more than 0.5 MB would come out of it")
        drop(page, *(os.path.join(work, name) for name in bad))
        said = page.run("[...document.querySelectorAll('#job .lack')].map((e) => e.textContent)")
        for name, (_, reason) in bad.items():
            true(f"{name}: {said}", f"{name} cannot be read: {reason}." in said)
        same("no program", page.run("fivecheckPage.of('program').length"), 0)
    bench.done(page)


@test
def zip_names(bench):
    """Names in a ZIP that are not UTF-8 are read in the old code page; several ZIPs get separate folders; duplicates are reported."""
    page = bench.open()
    with tempfile.TemporaryDirectory() as work:
        old = zipped(os.path.join(work, "old.zip"), {"nc/kAse.nc": "M2\n"})
        with open(old, "rb") as file:
            data = file.read().replace(b"nc/kAse.nc", "nc\\käse.nc".encode("cp437"))
        with open(old, "wb") as file:
            file.write(data)
        drop(page, old)
        same("an old name", page.run("fivecheckPage.files.map(({path}) => path)"), ["nc/käse.nc"])
        page.run("document.querySelector('#empty').click()")
        drop(page, *(zipped(os.path.join(work, f"{name}.zip"), {"part.nc": f"({name})\nM2\n"}) for name in ("one", "two")))
        same("two ZIPs", page.run("fivecheckPage.files.map(({path, text}) => [path, text.split('\\n')[0]]).sort()"), [["one/part.nc", "(one)"], ["two/part.nc", "(two)"]])
        page.run("document.querySelector('#empty').click()")
        write(os.path.join(work, "part.nc"), "(loose)\nM2\n")
        drop(page, os.path.join(work, "one.zip"), os.path.join(work, "part.nc"))
        same("one of a name", page.run("fivecheckPage.files.map(({path}) => path)"), ["part.nc"])
        true("it is told", "part.nc came twice" in page.run(ADVICE))
    bench.done(page)


@test
def names_without_end(bench):
    """Files that refer to themselves or to an invalid letter, endless comments and very many files do not block the page."""
    page = bench.open()
    page.run("""await fivecheckPage.add([
        ['jobs.xml', new Blob(['<jobs version="1"><job name="a" machine="a/jobs.xml" setup="&#x7fffffff;.xml"><program file="a/b/jobs.xml"/></job></jobs>'])],
        ['setup.xml', new Blob(['<setup version="1"><part mesh="a/setup.xml"/>' + '<!--'.repeat(1e6)])],
        ['tools.xml', new Blob(['<setup ' + '<tools '.repeat(1e6)])]])""")
    said = page.run(ADVICE)
    true(said, "Not here yet: &#x7fffffff;.xml." in said)
    page.run("document.querySelector('#empty').click()")
    page.run("await fivecheckPage.add(Array.from({length: 30}, (_, i) => [`photo-${i}.jpg`, new Blob(['x'])]))")
    same("thirty files", page.run(ADVICE).split("photo-7.jpg")[1], " and 22 others.")
    bench.done(page)
