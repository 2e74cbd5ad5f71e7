"""What the tests in a browser share: the list of tests, words for what must hold, and reports that are written once."""
import json
import os
import subprocess

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
