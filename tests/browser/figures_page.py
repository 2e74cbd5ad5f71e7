"""Prints figures of the page: the time from a first visit to its first verdict, the cost of 1,000,000 blocks. No time is judged here."""
import os
import re
import resource
import subprocess
import tempfile
import time

import fixtures
from bench import same, test, true
from page_bench import VERDICTS, Bench

FIRST_VERDICT = """await new Promise((done) => {
    new MutationObserver(() => document.querySelector('.program[data-verdict]') && done(performance.now()))
        .observe(document.querySelector('#results'), {attributes: true, childList: true, subtree: true});
    document.querySelector('[data-example=ac-trunnion]').click();
    until('example-open', 1).then(() => document.querySelector('#check').click());
})"""


def first_verdict(bench):
    """A visit: ms to the page that is ready, and to the verdict of the example's first program."""
    page = bench.open()
    ready, verdict = page.run("performance.now()"), page.run(FIRST_VERDICT)
    page.run("await until('checked', 1)")
    return page, ready, verdict


@test
def visits(bench):
    """The first visit of a browser that has never seen the page, and the second one."""
    with type(bench.browser)(timeout=600) as fresh:
        visitor = Bench(bench, bench.site, fresh)
        page, ready, verdict = first_verdict(visitor)
        page.run("await navigator.serviceWorker.ready")
        print(f"     first visit: ready after {ready / 1000:.2f} s, first verdict after {verdict / 1000:.2f} s; {fresh.processor_time():.2f} s of the browser's processor time")
        page.close()
        page, ready, verdict = first_verdict(visitor)
        print(f"     second visit: ready after {ready / 1000:.2f} s, first verdict after {verdict / 1000:.2f} s")
        visitor.verdicts(page)
        page.close()


def choose(page, paths):
    """Chooses files by the button of the page."""
    shown = page.run("counts['files-shown']")
    page.choose("#choose", paths)
    page.run(f"await until('files-shown', {shown + 1})")


def native_times(*command):
    """Seconds, and seconds of processor time."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run(command, capture_output=True, check=False)
    after, end = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    return end - start, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


@test
def million_blocks(bench):
    """1,000,000 blocks: the verdict and its words, the memory, the time beside that of the command line."""
    with tempfile.TemporaryDirectory() as work:
        machine, setup, program = fixtures.million(work)
        folder = os.path.dirname(machine)
        page = bench.open()
        choose(page, [machine, setup, program, *(os.path.join(folder, f"{name}.stl") for name in ("table", "head", "block"))])
        before, start = bench.browser.processor_time(), page.run("performance.now()")
        bench.check(page)
        took, cost = (page.run("performance.now()") - start) / 1000, bench.browser.processor_time() - before
        same("verdict", page.run(VERDICTS), [["million.nc", "clear"]])
        true("all blocks", re.search(r"^1,?000,?00[0-9] blocks", page.run("document.querySelector('.words').textContent"), re.M))
        memory = page.run("fivecheckPage.checks.memory.get('million.nc')")
        wall, cpu = native_times(bench.fivecheck, "-j1", f"--report={work}/report.html", f"--setup={setup}", machine, program)
        print(f"     1,000,000 blocks with their report: {took:.1f} s, {cost:.1f} s of the browser's processor time, {memory / 2**20:.0f} MB; "
              f"command line: {wall:.1f} s, {cpu:.1f} s; {cost / cpu:.1f} times")
        true(f"{memory} bytes", memory <= 64 * 2**20)
        bench.done(page)
