"""The page in src/web/app/README.md, exactly as printed there."""
import os
import re
import tempfile

import fixtures
from bench import same, test, true
from builds_page import copy_of_page


@test
def page_of_the_readme(bench):
    """Files are chosen and checked in a worker, and findings are shown as they come."""
    with open("src/web/app/README.md", encoding="utf-8") as file:
        text = re.search(r"```html\n(<!doctype html>[^\v]*?)```", file.read())[1]
    with copy_of_page(bench) as (folder, copy), tempfile.TemporaryDirectory() as work:
        with open(os.path.join(folder, "own.html"), "w", encoding="utf-8") as file:
            file.write(text)
        machine, setup, program = fixtures.boxes(work)
        page = copy.browser.page()
        page.navigate(copy.site.address + "own.html")
        page.run("void (window.ended = new Promise((done) => new MutationObserver(() => said.textContent.includes('exit status') && done()).observe(said, {childList: true})))")
        page.choose("#files", [machine, setup, program, *(os.path.join(os.path.dirname(machine), f"{name}.stl") for name in ("table", "head", "block"))])
        page.run("await ended")
        lines = page.run("said.textContent").splitlines()
        true(f"a finding: {lines}", "line 8: collision: block and T1 cutter" in lines)
        same("its end", lines[-1], "exit status 1")
        same("exceptions", [text for text in page.exceptions() if "favicon" not in text and "404" not in text], [])
        page.close()
