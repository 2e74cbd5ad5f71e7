"""What the tests in a browser share: the list of tests, assertions, and reports that are written once."""
import json
import os
import subprocess
import traceback

from driver import Browser, NotHere
from firefox import Firefox

PHONE = {"width": 390, "height": 800, "scale": 2, "mobile": True}
TESTS = []


def test(function):
    TESTS.append(function)
    return function


def browser_of(arguments):
    """The class of the requested browser."""
    return Firefox if arguments.firefox else Browser


def carry_out(tests, bench_for, names):
    """Runs all tests, or those with these names, each with its own bench. Returns the number of failed tests."""
    failed = 0
    for function in tests:
        if names and function.__name__ not in names:
            continue
        try:
            with bench_for() as bench:
                function(bench)
            print(f"ok   {function.__name__}", flush=True)
        except NotHere as word:
            print(f"     {function.__name__} is skipped: {word}", flush=True)
        except Exception:  # noqa: BLE001 - each failure is reported, and the other tests go on
            failed += 1
            print(f"FAIL {function.__name__}", flush=True)
            traceback.print_exc()
    return failed


def shown(value):
    """A value, shortened to a readable length."""
    text = repr(value)
    return text if len(text) <= 2000 else f"{text[:2000]} ... ({len(text)} characters)"


def same(what, found, wanted):
    if found != wanted:
        raise AssertionError(f"{what}: {shown(found)} instead of {shown(wanted)}")


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
        """There was no exception, no message on the console, and no request."""
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
READ_OUT = "Object.fromEntries([...document.querySelectorAll('.readout dl div:not(.heads)')].map((row) => [row.children[0].textContent, Number(row.children[1].textContent)]))"
HERE = "Number(document.querySelector('.row.here')?.dataset.line || 0)"
# Visible text with too little contrast (WCAG 2.2, 1.4.3), except in pictures and on disabled controls.
WEAK_TEXT = """((lum, over) => {
    const parse = (text) => { const n = text.match(/[\\d.]+/g).map(Number); return text.startsWith('color(') ? [n[0] * 255, n[1] * 255, n[2] * 255, n[3] ?? 1] : [n[0], n[1], n[2], n[3] ?? 1]; };
    const ground = (e) => {
        if (!e) return [255, 255, 255];
        const c = parse(getComputedStyle(e).backgroundColor);
        return c[3] >= 0.8 ? c : over(c, ground(e.parentElement));
    };
    const bad = [];
    for (const e of document.querySelectorAll('body *')) {
        const words = [...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim()) || e.matches('input:is(:not([type]), [type=number]), select, textarea');
        if (!words || !e.checkVisibility() || !e.getClientRects().length || e.disabled || e.closest('svg')) continue;
        const style = getComputedStyle(e), a = lum(parse(style.color)), b = lum(ground(e));
        const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        const large = parseFloat(style.fontSize) >= 18.66;
        if (ratio < (large ? 3 : 4.5)) bad.push(`${e.tagName}.${e.className} ${(e.textContent || e.value).slice(0, 20)} ${ratio.toFixed(2)}`);
    }
    return bad;
})((c) => { const [r, g, b] = c.map((v) => (v /= 255, v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)); return 0.2126 * r + 0.7152 * g + 0.0722 * b; },
(c, d) => [0, 1, 2].map((k) => c[k] * c[3] + d[k] * (1 - c[3])))"""
