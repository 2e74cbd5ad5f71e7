"""Runs examples/apache in a real apache2 on 127.0.0.1: the page with its headers, and the hardened CGI with its limits.

usage: check_apache.py --apache PROGRAM --fivecheck PROGRAM --page FOLDER --cgi PROGRAM [--browser]
"""
import argparse
import concurrent.futures
import contextlib
import gzip
import http.client
import io
import os
import pwd
import re
import shutil
import socket
import subprocess
import sys
import tarfile
import tempfile
import traceback

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "browser"))
from bench import TESTS, same, test, true  # noqa: E402
from driver import Browser, find_browser  # noqa: E402

MODULES = ["mpm_event", "authz_core", "authn_core", "alias", "mime", "dir", "env", "headers", "deflate", "filter", "cgid", "reqtimeout"]
CONFIG = """
ServerName 127.0.0.1
ServerRoot {root}
PidFile {root}/apache.pid
Listen 127.0.0.1:{port}
{modules}
TypesConfig /etc/mime.types
ScriptSock {root}/cgid.sock
ErrorLog {root}/error.log
LogFormat "%m %U %>s %{{Content-Length}}i %{{User-Agent}}i" access
CustomLog {root}/access.log access
{user}
Define FIVECHECK_APP {root}/app
Define FIVECHECK_CGI {root}/cgi-bin/fivecheck.cgi
SetEnv FIVECHECK {root}/fivecheck
SetEnv FIVECHECK_WORK {root}/work
<Directory {root}/cgi-bin>
    Options None
</Directory>
Include {config}
{more}
"""


class Server:
    """An apache2 with examples/apache/fivecheck.conf, in its own folder."""

    def __init__(self, arguments, more=""):
        self.root = tempfile.mkdtemp(prefix="fivecheck-apache-")
        os.chmod(self.root, 0o755)
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        shutil.copytree(arguments.page, f"{self.root}/app")
        shutil.copy(arguments.fivecheck, f"{self.root}/fivecheck")
        os.mkdir(f"{self.root}/cgi-bin")
        os.mkdir(f"{self.root}/work", 0o700)
        shutil.copy(arguments.cgi, f"{self.root}/cgi-bin/fivecheck.cgi")
        user = ""
        if os.geteuid() == 0:
            owner = pwd.getpwnam("www-data")
            os.chown(f"{self.root}/work", owner.pw_uid, owner.pw_gid)
            user = "User www-data\nGroup www-data"
        for folder, _, files in os.walk(f"{self.root}/app"):
            os.chmod(folder, 0o755)
            for name in files:
                os.chmod(os.path.join(folder, name), 0o644)
        modules = "\n".join(f"LoadModule {name}_module /usr/lib/apache2/modules/mod_{name}.so" for name in MODULES)
        with open(f"{self.root}/apache.conf", "w", encoding="utf-8") as file:
            file.write(CONFIG.format(root=self.root, port=self.port, modules=modules, user=user, more=more,
                                     config=os.path.abspath("examples/apache/fivecheck.conf")))
        self.process = subprocess.Popen([arguments.apache, "-f", f"{self.root}/apache.conf", "-DFOREGROUND"],
                                        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        while True:
            with contextlib.suppress(ConnectionRefusedError):
                socket.create_connection(("127.0.0.1", self.port)).close()
                break
            if self.process.poll() is not None:
                raise RuntimeError(f"apache2 has ended: {self.process.stderr.read().decode()}")

    def close(self):
        self.process.terminate()
        self.process.wait()
        self.process.stderr.close()
        shutil.rmtree(self.root)

    def ask(self, method, path, body=None, headers=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=300)
        connection.request(method, path, body, headers or {})
        answer = connection.getresponse()
        text = answer.read()
        connection.close()
        return answer.status, dict(answer.getheaders()), text

    def check(self, body, query="machine=m.xml&program=p.nc", headers=None):
        status, told, text = self.ask("POST", f"/fivecheck/check?{query}", body, {"Content-Type": "application/x-tar", **(headers or {})})
        return status, told.get("Fivecheck-Status"), text.decode()

    def log(self):
        with open(f"{self.root}/access.log", encoding="utf-8") as file:
            return [line.split() for line in file]


def archive(files, extra=()):
    """A tar archive of names and texts; extra members are added unchanged."""
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for name, text in files.items():
            member = tarfile.TarInfo(name)
            member.size = len(text)
            tar.addfile(member, io.BytesIO(text))
        for member in extra:
            tar.addfile(member)
    return out.getvalue()


# Files that stay in the folder of the jobs.
LOCK = re.compile("slot-|room-")
MACHINE = b"""<machine version="1"><base><body name="wall" mesh="stl/wall.stl"/>
<axis name="X" type="linear" direction="1 0 0" limit_min="0" limit_max="400" rate_max="30000"><body name="plate" mesh="stl/plate.stl"/></axis>
</base><pairs><pair a="plate" b="wall" check="always"/></pairs></machine>
"""


def box(low, high):
    corner = lambda i: " ".join(str((high if i >> k & 1 else low)[k]) for k in range(3))  # noqa: E731
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    text = "solid box\n"
    for a, b, c, d in faces:
        for triangle in ((a, b, c), (a, c, d)):
            text += "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {corner(i)}\n" for i in triangle) + "endloop\nendfacet\n"
    return (text + "endsolid box\n").encode()


def job(program=b"G21 G90\nG0 X100\nM2\n", **more):
    files = {"m.xml": MACHINE, "stl/wall.stl": box((152.2, -100, 0), (152.7, 100, 200)), "stl/plate.stl": box((-0.5, -60, 40), (0.5, 60, 160)),
             "p.nc": program}
    return {**files, **more}


def nothing_left(server):
    same("what is left of jobs", [name for name in os.listdir(f"{server.root}/work") if not LOCK.match(name)], [])


@test
def page(server):
    """The page's files with their types, policies and validators; nothing can be sent to it."""
    status, headers, _ = server.ask("GET", "/fivecheck/")
    same("status", status, 200)
    true("policy", "default-src 'none'" in headers["Content-Security-Policy"] and "unsafe-inline" not in headers["Content-Security-Policy"])
    same("sniffing", headers["X-Content-Type-Options"], "nosniff")
    status, headers, body = server.ask("GET", "/fivecheck/fivecheck.wasm", headers={"Accept-Encoding": "gzip"})
    same("type", headers["Content-Type"], "application/wasm")
    same("magic", gzip.decompress(body)[:4], b"\0asm")
    status, headers, _ = server.ask("GET", "/fivecheck/main.js")
    same("type of modules", headers["Content-Type"].split(";")[0], "text/javascript")
    same("caching", headers["Cache-Control"], "no-cache")
    status, _, body = server.ask("GET", "/fivecheck/main.js", headers={"If-None-Match": headers["ETag"]})
    same("unchanged", (status, body), (304, b""))
    same("no sending", server.ask("POST", "/fivecheck/main.js", b"x")[0], 403)
    same("no listing", server.ask("GET", "/fivecheck/viewer/")[0] in (403, 404), True)
    same("no way out", server.ask("GET", "/fivecheck/%2e%2e/apache.conf")[0] in (400, 403, 404), True)


@test
def verdicts(server):
    """The CGI answers with the output of the command line."""
    same("clear", server.check(archive(job()))[:2], (200, "0"))
    status, code, text = server.check(archive(job(b"G21 G90\nG0 X300\nM2\n")))
    same("found", (status, code), (200, "1"))
    true("words", "p.nc:2:1: error: collision: wall (base) meets plate (X) [collision]" in text)
    status, code, text = server.check(archive(job(b"G21\nG0 X\n")))
    same("a fault", (status, code), (200, "2"))
    true("its place", "p.nc:2:" in text)
    status, code, text = server.check(archive(job(b"G21 G90\nG0 X300\nM2\n")), "machine=m.xml&program=p.nc&format=ndjson&all=1&clearance=2")
    same("another format", (status, code), (200, "1"))
    true("NDJSON", '"kind":"clearance"' in text)
    folders = archive({f"./job/{name}": text for name, text in job().items()}, [member("./"), member("./job/")])
    same("a folder", server.check(folders, "machine=job%2Fm.xml&program=job/p.nc")[:2], (200, "0"))
    nothing_left(server)


def member(name, kind=tarfile.DIRTYPE, target=""):
    made = tarfile.TarInfo(name)
    made.type = kind
    made.linkname = target
    made.mode = 0o755
    return made


@test
def hostile(server):
    """Links, paths that lead out, names that look like options, duplicates, other files than archives, files elsewhere, and bombs."""
    for name, body in {
            "a symbolic link": archive(job(), [member("link.stl", tarfile.SYMTYPE, "/etc/passwd")]),
            "a hard link": archive(job(), [member("link.stl", tarfile.LNKTYPE, "m.xml")]),
            "a device": archive(job(), [member("null", tarfile.CHRTYPE)]),
            "a pipe": archive(job(), [member("pipe", tarfile.FIFOTYPE)]),
            "a way out": archive(job(**{"../evil": b"x"})), "a way out below": archive(job(**{"a/../../evil": b"x"})),
            "from the root": archive(job(**{"/tmp/evil": b"x"})), "hidden": archive(job(**{".output": b"x"})),
            "an option": archive(job(**{"--jobs": b"x"})), "twice": archive(job(), [member("p.nc", tarfile.REGTYPE)]),
            "no archive": b"G0 X1\n" * 1000, "cut off": archive(job())[:3000], "compressed": gzip.compress(archive(job())),
            "a folder as a file": archive(job(**{"stl": b"x"})),
    }.items():
        same(name, server.check(body)[0], 400)
    same("an archive in disguise", server.check(gzip.compress(archive(job())), headers={"Content-Encoding": "gzip"})[0], 415)
    same("another type", server.check(archive(job()), headers={"Content-Type": "multipart/form-data"})[0], 415)
    same("no machine", server.check(archive(job()), "program=p.nc")[0], 400)
    for query in ("machine=../../etc/passwd&program=p.nc", "machine=/etc/passwd&program=p.nc", "machine=m.xml&program=--help",
                  "machine=m.xml&program=p.nc&output=x", "machine=m.xml&program=p%0a.nc", "machine=m.xml&program=p.nc&clearance=1;x",
                  "machine=m.xml&program=p.nc&all=true", "machine=m.xml&program=p.nc&machine=n.xml",
                  # The option that fivecheck gets has no room for more: cut off, it would be another number.
                  "machine=m.xml&program=p.nc&clearance=" + 25 * "0" + "2"):
        same(query, server.check(archive(job()), query)[0], 400)
    outside = job(**{"m.xml": MACHINE.replace(b"stl/wall.stl", b"/etc/passwd")})
    status, code, text = server.check(archive(outside))
    same("a mesh elsewhere", (status, code, "root:" in text), (200, "2", False))
    laughs = b'<!DOCTYPE machine [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;"><!ENTITY c "&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;">]>'
    same("a bomb of entities", server.check(archive(job(**{"m.xml": laughs + MACHINE.replace(b'version="1"', b'version="1" name="&c;"')})))[:2], (200, "2"))
    same("too many files", server.check(archive(job(**{f"f{i}": b"" for i in range(1001)})))[0], 413)
    deep = lambda first: "/".join([first] + ["d"] * 90)  # noqa: E731
    same("files in folders without number", server.check(archive({deep(f"f{i}"): b"" for i in range(20)}))[0], 413)
    same("folders alone without number", server.check(archive({}, [member(deep(f"f{i}")) for i in range(20)]))[0], 413)
    same("no length", server.ask("POST", "/fivecheck/check?machine=m.xml&program=p.nc", iter([archive(job())]),
                                 {"Content-Type": "application/x-tar", "Transfer-Encoding": "chunked"})[0] in (411, 413, 400), True)
    same("GET", server.ask("GET", "/fivecheck/check")[0], 403)
    nothing_left(server)


@test
def limits(server):
    """413 for what is too large; a job that never ends is ended; ten at once are all answered."""
    same("too large", server.check(archive(job(**{"large.nc": b"x" * (2 << 20)})))[0], 413)
    # A loop without an end: only the limit of processor time ends it.
    status, _, text = server.check(archive(job(b"G21 G90\no1 while [1]\nG0 X1\nG0 X0\no1 endwhile\nM2\n")))
    same("without an end", status, 503)
    true("the reason", "more time" in text)
    with concurrent.futures.ThreadPoolExecutor(10) as pool:
        answers = list(pool.map(lambda i: server.check(archive(job(b"G21 G90\nG0 X%d\nM2\n" % (100 + 20 * i)))), range(10)))
    same("ten at once", [(status, code) for status, code, _ in answers], [(200, "0" if 100 + 20 * i < 152 else "1") for i in range(10)])
    nothing_left(server)


def half_a_request(server, text, length=None):
    """A socket with an unfinished request for a check: this part of the body is sent, `length` bytes are announced."""
    client = socket.socket()
    client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    client.settimeout(300)
    client.connect(("127.0.0.1", server.port))
    client.sendall(b"POST /fivecheck/check?machine=m.xml&program=p.nc&format=ndjson&all=1 HTTP/1.1\r\nHost: x\r\nContent-Type: application/x-tar\r\n"
                   b"Connection: close\r\nContent-Length: %d\r\n\r\n" % (length or len(text)) + text)
    return client


def wait_until_tidied(server):
    """Waits until nothing is left of the jobs that the server has ended."""
    for _ in range(300):
        if all(map(LOCK.match, os.listdir(f"{server.root}/work"))):
            return
        server.check(archive(job()))
    nothing_left(server)


@test
def impolite(server):
    """A client that disconnects, sends half a job or does not read the answer leaves nothing behind and blocks no processor."""
    body, endless = archive(job()), archive(job(b"G21 G90\no1 while [1]\nG0 X1\nG0 X0\no1 endwhile\nM2\n"))
    for sent in (b"", body[:700], body[:-600]):
        half_a_request(server, sent, len(body)).close()
        wait_until_tidied(server)
    waiting = half_a_request(server, body[:1500], len(body))
    true("half a job is not waited for", waiting.recv(100).split()[1:2] in ([b"408"], [b"400"], []))
    waiting.close()
    half_a_request(server, endless).close()
    wait_until_tidied(server)
    # Each has megabytes of findings to send, and more are at it than there are processors.
    passes = archive(job(b"G21 G90 G61\no1 repeat [10000]\nG0 X500 (%s)\nG0 X501 (%s)\no1 endrepeat\nM2\n" % (b"a" * 200, b"b" * 200)))
    readers = [half_a_request(server, passes) for _ in range((os.cpu_count() or 1) + 1)]
    for reader in readers:
        same("an answer begins", reader.recv(12), b"HTTP/1.1 200")
    same("others have a processor", server.check(body)[:2], (200, "0"))
    wait_until_tidied(server)
    for reader in readers:
        reader.close()
    wait_until_tidied(server)


@test
def many_uploads(server):
    """A bounded number of unfinished uploads lies on the server; the next client waits and is answered when one of them has ended."""
    body, most = archive(job()), 32
    clients = [half_a_request(server, body[:1500], len(body)) for _ in range(most + 10)]
    lying = set()
    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        answer = pool.submit(clients[0].recv, 12)
        while not answer.done():
            lying.add(sum(name.startswith("job-") for name in os.listdir(f"{server.root}/work")))
    same("the most that lie on the server", max(lying), most)
    same("one more", server.check(body)[:2], (200, "0"))
    for client in clients:
        client.close()
    wait_until_tidied(server)


@test
def methods(server):
    """HEAD, ranges, other methods and types, and wrong lengths."""
    status, headers, text = server.ask("HEAD", "/fivecheck/fivecheck.wasm")
    same("HEAD", (status, headers["Content-Type"], text), (200, "application/wasm", b""))
    whole = server.ask("GET", "/fivecheck/main.js")[2]
    status, headers, text = server.ask("GET", "/fivecheck/main.js", headers={"Range": "bytes=10-19"})
    same("a range", (status, text), (206, whole[10:20]))
    same("a range beyond the end", server.ask("GET", "/fivecheck/main.js", headers={"Range": f"bytes={len(whole)}-"})[0], 416)
    many = "bytes=" + ",".join(f"{i}-" for i in range(1500))
    true("a thousand ranges are no thousand files", len(server.ask("GET", "/fivecheck/main.js", headers={"Range": many})[2]) <= len(whole))
    for method in ("OPTIONS", "PUT", "DELETE", "PROPFIND", "HEAD", "PATCH"):
        true(f"{method} of a check", server.ask(method, "/fivecheck/check?machine=m.xml&program=p.nc")[0] in (403, 405, 501))
        true(f"{method} of a file", method == "HEAD" or server.ask(method, "/fivecheck/main.js")[0] in (403, 405, 501))
    body = archive(job())
    for kind in ("text/plain", "application/x-tar-gz", "application/x-tarball", "application/json", "", "application/X"):
        same(f"the type {kind}", server.check(body, headers={"Content-Type": kind})[0], 415)
    for kind in ("application/x-tar; charset=binary", "Application/X-Tar"):
        same(f"the type {kind}", server.check(body, headers={"Content-Type": kind})[:2], (200, "0"))
    same("a length beyond any", server.ask("POST", "/fivecheck/check?machine=m.xml&program=p.nc", b"", {"Content-Type": "application/x-tar", "Content-Length": str(70 << 20)})[0], 413)
    same("an empty body", server.check(b"")[0] in (400, 411), True)
    same("a job in a job's place", server.ask("POST", "/fivecheck/check/../../apache.conf?machine=m.xml&program=p.nc", body)[0] in (400, 403, 404, 405), True)
    same("a path behind the program", server.ask("GET", "/fivecheck/check/x")[0], 403)
    wait_until_tidied(server)


@test
def nothing_is_sent(server):
    """A browser checks a user's files in the page: the access log has only GETs of the page's own files."""
    if not find_browser():
        print("     skipped: there is no Chromium")
        return
    with Browser(timeout=300) as browser:
        tab = browser.page()
        tab.before("""
            window.ready = new Promise((done) => document.addEventListener('fivecheck-ready', done));
            window.checked = new Promise((done) => document.addEventListener('checked', done));
            window.shown = new Promise((done) => document.addEventListener('report-shown', done));""")
        tab.navigate(f"http://127.0.0.1:{server.port}/fivecheck/")
        tab.run("await ready")
        files = [(f"secret/{name}", text.decode()) for name, text in job(b"G21 G90\nG0 X300\nM2\n").items()]
        tab.run(f"await fivecheckPage.add({files!r}.map(([path, text]) => [path, new Blob([text])]))".replace("('", "['").replace("')", "']"))
        tab.run("document.querySelector('#check').click()")
        tab.run("await checked")
        same("verdict", tab.run("document.querySelector('.program').dataset.verdict"), "found")
        tab.run("await shown")
        same("exceptions", tab.exceptions(), [])
        tab.close()
    # What the tests before asked for may be logged only now.
    log = [entry for entry in server.log() if any("Chrome" in word for word in entry[4:])]
    true("something was asked for", any(entry[1].endswith("fivecheck.wasm") for entry in log))
    same("all but GETs without a body", [entry for entry in log if entry[0] != "GET" or entry[3] != "-"], [])
    same("names of the user", [entry for entry in log if "secret" in entry[1] or entry[1].endswith((".nc", "m.xml"))], [])


def main():
    parser = argparse.ArgumentParser()
    for name in ("apache", "fivecheck", "page", "cgi"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("tests", nargs="*")
    arguments = parser.parse_args()
    failed = 0
    # Smaller limits than the example's, so that the test is quick.
    server = Server(arguments, "RequestReadTimeout body=2\n<Location /fivecheck/check>\nSetEnv FIVECHECK_MB 1\nSetEnv FIVECHECK_SECONDS 2\n</Location>\n")
    try:
        for function in TESTS:
            if arguments.tests and function.__name__ not in arguments.tests:
                continue
            try:
                function(server)
                print(f"ok   {function.__name__}", flush=True)
            except Exception:  # noqa: BLE001 - every failure is told, and the rest goes on
                failed += 1
                print(f"FAIL {function.__name__}", flush=True)
                traceback.print_exc()
        if failed:
            with open(f"{server.root}/error.log", encoding="utf-8") as file:
                sys.stderr.write(file.read()[-3000:])
    finally:
        server.close()
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
