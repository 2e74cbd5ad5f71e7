"""Broken and hostile files, dropped onto the page: each gets the answer of the command line, and the page goes on."""
import json
import os
import random
import re
import shutil
import subprocess
import tempfile

import fixtures
from bench import same, test, true

SEEDS = "tests/fuzz/seeds"
SAID = """[...document.querySelectorAll('.program')].map((card) => ({path: card.dataset.path, verdict: card.dataset.verdict,
    sentence: card.querySelector('.verdict').textContent, messages: [...card.querySelectorAll('.message')].map((e) => e.textContent)}))"""
STATUS = {"clear": 0, "found": 1, "incomplete": 2}


def words_of(path):
    """The words of a fuzzer's dictionary."""
    with open(path, encoding="utf-8") as file:
        return [bytes(line.strip()[1:-1], "utf-8").decode("unicode_escape").encode("latin-1") for line in file if line.startswith('"')]


def mutated(chance, data, words):
    """Mutates bytes as fuzzers do: changes, deletes, repeats, truncates, and inserts words."""
    data = bytearray(data)
    for _ in range(chance.randint(1, 6)):
        at = chance.randrange(len(data) + 1)
        what = chance.randrange(6)
        if what == 0 and at < len(data):
            data[at] = chance.randrange(256)
        elif what == 1:
            del data[at:at + chance.randint(1, 20)]
        elif what == 2:
            data[at:at] = data[max(0, at - 40):at]
        elif what == 3 and words:
            data[at:at] = chance.choice(words)
        elif what == 4:
            data[at:at] = bytes(chance.randrange(256) for _ in range(chance.randint(1, 8)))
        elif chance.randrange(3) == 0:
            del data[at:]
    return bytes(data)


def seed(name):
    with open(os.path.join(SEEDS, name), "rb") as file:
        return file.read()


def programs():
    """Names and bytes of programs for LinuxCNC; none of them runs long."""
    chance, words = random.Random(1), words_of("tests/fuzz/gcode.dict")
    made = {f"mutated-{i}.nc": mutated(chance, seed(chance.choice(["five.nc", "macros.nc", "five.mpf", "contour.h"])), words) for i in range(40)}
    return {**made, "empty.nc": b"", "zeros.nc": bytes(5000), "picture.nc": b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 20, "line.nc": b"X1" * 200000,
            "deep.nc": b"G1 X" + b"[" * 100000 + b"1" + b"]" * 100000, "far.nc": b"G1 X1e308 Y-1e308 F1e-320\n", "not-a-number.nc": b"G1 X[0/0] F100\n",
            "archive.nc": b"PK\x03\x04" + b"\xff\xfe" * 400, "calls.nc": b"o1 call\no1 sub\no1 call\no1 endsub\nM2\n", "mail.nc": b"<script>document.body.remove()</script>\n"}


def of_controls():
    """The same for the controls in separate parts of the module: each control with its programs."""
    chance, words = random.Random(2), words_of("tests/fuzz/gcode.dict")
    return {"sinumerik": {f"mutated-{i}.mpf": mutated(chance, seed("five.mpf"), words) for i in range(8)},
            "klartext": {f"mutated-{i}.h": mutated(chance, seed(chance.choice(["five.h", "contour.h"])), words) for i in range(8)}}


def meshes():
    chance = random.Random(3)
    made = [mutated(chance, seed(name), []) for name in ["ascii.stl", "binary.stl"] for _ in range(9)]
    return made + [b"", b"solid", b"solid x\nendsolid x\n", bytes(80) + b"\xff\xff\xff\xff", bytes(83), seed("binary.stl")[:-7],
                   b"solid\nfacet normal 0 0 1\nouter loop\nvertex nan 0 0\nvertex inf 0 0\nvertex 1e39 0 0\nendloop\nendfacet\nendsolid\n"]


BOMB = b'<?xml version="1.0"?><!DOCTYPE %s [<!ENTITY a "aaaaaaaaaa">' + b"".join(
    b'<!ENTITY %c "%s">' % (98 + i, b"&%c;" % (97 + i) * 10) for i in range(9)) + b"]><%s version=\"1\">&j;</%s>"


def trees(good, kind):
    """Broken XML files of one kind."""
    chance, words = random.Random(4), words_of("tests/fuzz/xml.dict")
    name = kind.encode()
    return [*(mutated(chance, good, words) for _ in range(14)), BOMB % (name, name, name), b"<" + name + b">" + b"<axis>" * 20000,
            b'<!DOCTYPE %s SYSTEM "/etc/passwd"><%s version="1"/>' % (name, name), b"<%s version='1'" % name, b"\xff\xfe" + good.decode().encode("utf-16le")[:-9],
            b"<?xml version='1.0' encoding='no-such'?>\n<%s version='1'/>" % name]


def cases(work):
    """Folders of files to drop, and the programs in them: {name: {path: bytes}}."""
    good = {}
    for path in fixtures.boxes(work) + tuple(os.path.join(work, "boxes-00", f"{name}.stl") for name in ["table", "head", "block"]):
        with open(path, "rb") as file:
            good[os.path.basename(path)] = file.read()
    made = {"programs": {**{path: data for path, data in good.items() if path != "part.nc"}, **programs()}}
    for control, hostile in of_controls().items():
        made[control] = {**good, "machine.xml": good["machine.xml"].replace(b"linuxcnc", control.encode()), **hostile}
        del made[control]["part.nc"]
    for i, mesh in enumerate(meshes()):
        made[f"mesh-{i}"] = {**good, "table.stl": mesh}
    for kind in ("machine", "setup"):
        for i, tree in enumerate(trees(good[f"{kind}.xml"], kind)):
            made[f"{kind}-{i}"] = {**good, f"{kind}.xml": tree}
    return made


def drop(page, folder, count):
    """Drops a folder onto the page as a file manager does; it replaces the earlier files."""
    page.run("document.querySelector('#empty').click()")
    shown = page.run("counts['files-shown']")
    page.drop(640, 200, [folder])
    page.run(f"await until('files-shown', {shown + 1})")
    same(f"files of {folder}", page.run("fivecheckPage.files.length"), count)


def native(bench, work, folder, files, program):
    """The answer of the command line: its exit status and messages."""
    setup = [f"--setup={files['setup']}"] if files["setup"] else []
    done = subprocess.run([bench.fivecheck, "--format=ndjson", f"--format=text={work}/native.txt", "--progress=none", f"--report={work}/native.html",
                           *setup, "--", files["machine"], program], cwd=os.path.join(work, folder), capture_output=True, check=False, timeout=300)
    cautions = [caution for line in done.stdout.splitlines() for caution in json.loads(line).get("cautions", [])]
    messages = [line for line in done.stderr.decode("utf-8", "replace").splitlines() if f"{work}/native." not in line]
    return done.returncode, messages, cautions


def is_judged(bench, page, work, name):
    """Checks the dropped files. Returns the number of programs, and how many of them ended with a message about a file."""
    roles = dict(page.run("fivecheckPage.files.map(({path, role}) => [role, path.slice(path.indexOf('/') + 1)])"))
    if page.run("document.querySelector('#check').disabled"):
        why = page.run("document.querySelector('#why-not').textContent")
        true(f"{name}: {why}", re.search(r"(machine|setup)\.xml|missing", why))
        return 1, 1
    bench.check(page, page.run("counts.checked") + 1)
    said = page.run(SAID)
    told = 0
    for card in said:
        status, messages, cautions = native(bench, work, name, {role: roles.get(role) for role in ("machine", "setup")}, card["path"])
        same(f"verdict of {card['path']}: {card['sentence']} {messages}", STATUS[card["verdict"]], status)
        true(f"{card['path']}: {card['sentence']}", card["sentence"].split(":")[0] in ("Clear", "Found", "Incomplete"))
        same(f"messages of {card['path']}", sorted(card["messages"]), sorted(message for message in messages + cautions if message))
        true(f"{card['path']}: no message names a file: {messages}", status != 2 or any(re.match(r"[\w-]+\.\w+(:|$)", message) for message in messages))
        told += status == 2
    return len(said), told


@test
def hostile_files(bench):
    """Mutated seeds of the fuzzers, and files made to break readers."""
    page = bench.open()
    judged = told = 0
    with tempfile.TemporaryDirectory() as work:
        for name, files in cases(work).items():
            folder = os.path.join(work, name)
            os.makedirs(folder)
            for path, data in files.items():
                with open(os.path.join(folder, path), "wb") as file:
                    file.write(data)
            drop(page, folder, len(files))
            some, of_them = is_judged(bench, page, work, name)
            judged, told = judged + some, told + of_them
            shutil.rmtree(folder)
    print(f"     {judged} jobs with hostile files, {told} of them end with a message at the file, the others with a verdict")
    true(f"{judged} jobs, {told} told", judged >= 120 and told >= 80)
    page.run("document.querySelector('#empty').click()")
    bench.works(page, "verdicts afterwards")
    bench.done(page, "page-hostile")
