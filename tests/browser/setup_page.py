"""The form for a setup: tool libraries, lengths and radii of the control's table, edges, variables; the command line reads the result."""
import os
import re
import subprocess
import tempfile

from bench import same, test, true
from forms_page import after, enter, faults, write
from page_bench import VERDICTS, drop

XML = "document.querySelector('#setup-xml').value"
TABLE = """number,name,type,length,diameter,flute_length,shank_diameter,stickout,holder_diameter
4,"ball & 10",ball,130,10,25,12,65,50
6,end mill,flat,120,16,40,16,60,50
"""
OFFSETS = "number,length_offset,radius_offset\n52,119.95,4.99\n"


def into(page, row, **fields):
    enter(page, "setup", **{f"{row}__{name}": value for name, value in fields.items()})


def rows(page, kind):
    return page.run(f"[...document.querySelectorAll('[data-kind={kind}]')].map((e) => e.dataset.row)")


def add(page, kind):
    page.run(f"document.querySelector('#add-{kind}').click()")
    return rows(page, kind)[-1]


def element(xml, name):
    """The elements with this name, as written in the file."""
    return re.findall(rf"^  <{name} [^>]*/>\n|^  <{name} [^>]*[^/]>\n[^\v]*?^  </{name}>\n", xml, re.MULTILINE)


@test
def setup_as_imported(bench):
    """Tools and offsets from the form are written byte for byte as `fivecheck import` writes them."""
    page = bench.open()
    page.run("document.querySelectorAll('section > details').forEach((e) => e.open = true)")
    with tempfile.TemporaryDirectory() as work:
        imported = ""
        for name, text in (("tools", TABLE), ("offsets", OFFSETS)):
            with open(os.path.join(work, f"{name}.csv"), "w", encoding="utf-8") as file:
                file.write(text)
            subprocess.run([bench.fivecheck, "import", f"--output={name}", f"{name}.csv"], cwd=work, check=True, capture_output=True)
            with open(os.path.join(work, name, "setup.xml"), encoding="utf-8") as file:
                imported += file.read()
    same("imported", [len(element(imported, name)) for name in ("tool", "offset")], [2, 1])
    page.run("document.querySelector('[data-kind=offset] button').click()")
    tools, register = [rows(page, "tool")[0], add(page, "tool")], add(page, "register")
    into(page, tools[0], number="4", name="ball & 10", tip="ball", length="130", holderLength="65", holderDiameter="50", cutterLength="25", cutterDiameter="10", shankDiameter="12")
    into(page, tools[1], number="6", name="end mill", length="120", holderLength="60", holderDiameter="50", cutterLength="40", cutterDiameter="16", shankDiameter="16")
    into(page, register, number="52", length="119,95", radius="4.99")
    write(page, "setup")
    same("faults", faults(page, "setup"), [])
    for name in ("tool", "offset"):
        same(name, element(page.run(XML), name), element(imported, name))
    bench.done(page, "page-setup-tables")


@test
def setup_tables(bench):
    """Incomplete rows of every kind are reported, complete rows are written; a dropped library is proposed and used in the check."""
    page = bench.open()
    page.run("document.querySelectorAll('details').forEach((e) => e.open = true)")
    register, variable, table, tool = add(page, "register"), add(page, "variable"), add(page, "table"), rows(page, "tool")[0]
    page.run(f"document.querySelector('[data-row={tool}] .add-edge').click()")
    page.run(f"document.querySelector('[data-row={tool}] .add-edge').click()")
    edges = rows(page, "edge")
    same("numbers of edges", page.run("[...document.querySelectorAll('[data-kind=edge] [name$=number]')].map((e) => e.value)"), ["2", "3"])
    into(page, rows(page, "offset")[0], X="0", Y="0", Z="-400")
    into(page, tool, length="120", holderLength="60", holderDiameter="50", cutterLength="40", cutterDiameter="12")
    into(page, "stock", form="box", excess="0,2")
    into(page, "stock", size__x="90", size__y="90", size__z="60")
    into(page, register, number="52")
    into(page, edges[0], length="110")
    into(page, edges[1], number="2", length="111", diameter="8")
    page.run("document.querySelector('#more-setup').open = false")
    write(page, "setup")
    said = [text.strip() for text in faults(page, "setup")]
    same("faults", said, ["D2 is there twice", "the file is missing", "give a length or a radius", "a name is missing, such as #500, R5 or Q1600"])
    same("they are seen", page.run("[...document.querySelectorAll('#setup-form .fault')].filter((e) => e.textContent && !e.checkVisibility()).length"), 0)
    into(page, edges[1], number="4")
    into(page, register, radius="5")
    into(page, variable, name="_PLACE", value="1<2", type="REAL", size="2,1")
    into(page, table, href="../tools.csv", units="inch", numbers="1 3 10-20")
    write(page, "setup")
    same("faults at last", faults(page, "setup"), [])
    xml = page.run(XML)
    for line in ('<stock box="90 90 60" excess="0.2"/>', '<offset number="52" radius="5"/>', '<edge number="2" length="110"/>', '<edge number="4" length="111" diameter="8"/>',
                 '<variable name="_PLACE" value="1&lt;2" type="REAL" size="2,1"/>', '<tools href="../tools.csv" units="inch" numbers="1 3 10-20"/>'):
        true(f"{line}: {xml}", f"{line}\n" in xml)
    for row in ("variable", "register"):
        page.run(f"document.querySelector('[data-kind={row}] > button').click()")
        same("the focus stays near", page.run("document.activeElement.id"), f"add-{row}")
    bench.done(page, "page-setup-rows")


@test
def library_of_tools(bench):
    """A dropped tool library is proposed in the form, and the check has the verdict of the command line."""
    page = bench.open()
    program = "G21 G90 G94 G54\nT4 M6\nG43 H4\nS5000 M3\nG0 X0 Y0\nG0 Z50\nM2\n"
    with tempfile.TemporaryDirectory() as work:
        for name, text in (("tools.csv", TABLE), ("part.nc", program), ("package.json", "{}"), ("measured.csv", "x,y\n1,2\n"), ("machine.xml", open("machines/ac-trunnion/machine.xml", encoding="utf-8").read())):  # noqa: SIM115
            with open(os.path.join(work, name), "w", encoding="utf-8") as file:
                file.write(text)
        os.symlink(os.path.abspath("machines/ac-trunnion/stl"), os.path.join(work, "stl"))
        drop(page, *(os.path.join(work, name) for name in ("tools.csv", "part.nc", "package.json", "measured.csv", "machine.xml")), *(os.path.join(os.path.abspath("machines/ac-trunnion/stl"), name) for name in os.listdir("machines/ac-trunnion/stl")))
        same("roles", page.run("fivecheckPage.files.filter(({role}) => role !== 'mesh').map(({path, role}) => [path, role])"),
             [["machine.xml", "machine"], ["part.nc", "program"], ["tools.csv", "library"], ["package.json", "other"], ["measured.csv", "other"]])
        true("what to do", "tools.csv: perhaps tools, but no setup names them. The form for a setup below does." in page.run("document.querySelector('#job').textContent"))
        page.run("document.querySelector('#setup-details').open = true")
        same("proposed", page.run("[...document.querySelectorAll('[data-kind=table] [name$=href]')].map((e) => e.value)"), ["tools.csv"])
        same("its tools are not asked for", rows(page, "tool"), [])
        into(page, rows(page, "offset")[0], X="0", Y="0", Z="-400", A="0", C="0")
        write(page, "setup")
        same("faults", faults(page, "setup"), [])
        after(page, "files-shown", lambda: page.run("document.querySelector('#use-setup').click()"))
        same("nothing is missing", page.run("document.querySelector('#job').textContent"), "Not of use for a check: package.json, measured.csv.")
        bench.check(page)
        with open(os.path.join(work, "setup.xml"), "w", encoding="utf-8") as file:
            file.write(page.run(XML))
        done = subprocess.run([bench.fivecheck, "--setup=setup.xml", "machine.xml", "part.nc"], cwd=work, capture_output=True, text=True, check=False)
        same(f"verdict {done.stderr}", page.run(VERDICTS), [["part.nc", "clear" if done.returncode == 0 else "found"]])
        words = page.run("document.querySelector('.words').textContent")
        same("words", [line for line in words.splitlines() if "; time " not in line], [line for line in done.stdout.splitlines() if "; time " not in line])
    bench.done(page)
