"""Rules that a screen reader, a keyboard and a finger need, on both pages with all that can be opened (WCAG 2.2)."""
from bench import PHONE, same, test

# Each rule gives the elements that break it.
BROKEN = """((all, shown, text, broken) => {
    const named = (e) => text(e) || e.ariaLabel || [...e.labels ?? []].some(text) || e.getAttribute('aria-labelledby') && text(document.getElementById(e.getAttribute('aria-labelledby'))) || e.title;
    broken('without a name', all('button, input, select, textarea, a[href], iframe, summary, progress, [role=textbox], section').filter((e) => shown(e) && !named(e)));
    const ids = all('[id]').map((e) => e.id);
    broken('an id that is there twice', all('[id]').filter((e) => ids.indexOf(e.id) !== ids.lastIndexOf(e.id)));
    broken('what is described by nothing', all('[aria-describedby], [aria-labelledby]').filter((e) => !document.getElementById(e.getAttribute('aria-describedby') ?? e.getAttribute('aria-labelledby'))));
    broken('an order of its own', all('[tabindex]').filter((e) => e.tabIndex > 0));
    const levels = all('h1, h2, h3, h4').filter(shown).map((e) => Number(e.tagName[1]));
    broken('a heading that skips a level', all('h1, h2, h3, h4').filter(shown).filter((e, i) => i && levels[i] > levels[i - 1] + 1));
    broken('what scrolls and takes no focus', all('body *').filter((e) => shown(e) && /auto|scroll/.test(getComputedStyle(e).overflow) && (e.scrollWidth > e.clientWidth + 1 || e.scrollHeight > e.clientHeight + 1)
        && e.tabIndex < 0 && !e.querySelector('button, a, input, [tabindex]')));
    broken('small for a finger', all('button, .button, select, input:not([type=checkbox], [type=file]), textarea').filter((e) => shown(e) && e.getBoundingClientRect().height < 24));
    broken('a list with something else in it', all('ul, ol').flatMap((list) => [...list.children].filter((e) => e.tagName !== 'LI')));
    broken('a label around two fields', all('label').filter((e) => e.querySelectorAll('input, select, textarea').length > 1));
    return found;
})((what) => [...document.querySelectorAll(what)], (e) => e.checkVisibility(), (e) => e.textContent.trim(),
   (window.found = [], (rule, which) => found.push(...which.map((e) => `${rule}: ${e.outerHTML.slice(0, 160)}`))))"""


@test
def access(bench):
    """With findings, with faults in both forms, and with rows that were removed and added again."""
    for options in ({}, PHONE):
        page = bench.open(**options)
        same("at first", page.run(BROKEN), [])
        bench.example(page, "cb-head")
        bench.check(page)
        page.run("document.querySelectorAll('details').forEach((e) => e.open = true)")
        page.run("['offset', 'fixture', 'tool', 'table', 'register', 'variable'].forEach((kind) => document.querySelector(`#add-${kind}`).click())")
        page.run("document.querySelectorAll('.add-edge').forEach((e) => e.click())")
        for form in ("machine", "setup"):
            page.run(f"document.querySelector('#write-{form}').click()")
            page.run(f"await until('{form}-written', 1)")
        same("with faults", page.run(BROKEN), [])
        page.run("document.querySelector('[data-kind=register] > button').click()")
        page.run("['register', 'variable'].forEach((kind) => document.querySelector(`#add-${kind}`).click())")
        page.run("document.querySelector('#write-setup').click()")
        page.run("await until('setup-written', 2)")
        same("with other rows", page.run(BROKEN), [])
        same("sideways", page.run("document.documentElement.scrollWidth"), options.get("width", 1280))
        bench.done(page)
        page = bench.open("learn.html", **options)
        page.run("await until('machine-open', 1)")
        same("the page to learn with", page.run(BROKEN), [])
        bench.done(page)


@test
def focus(bench):
    """If a button disappears, the element in its place gets the focus, so the focus does not return to the top of the page."""
    page = bench.open()
    bench.example(page, "cb-head")
    names = page.run("fivecheckPage.files.map(({path}) => path)")
    for i in (3, len(names) - 2):
        page.run(f"(document.querySelectorAll('#file-list li')[{i}].querySelector('button:last-of-type').focus())")
        page.press("Enter")
        names.pop(i)
        same("the next one", page.run("document.activeElement.ariaLabel"), f"Remove {names[min(i, len(names) - 1)]}")
    page.run("document.querySelector('#empty').focus()")
    page.press("Enter")
    same("where files are chosen", page.run("[fivecheckPage.files.length, document.activeElement.id]"), [0, "choose"])
    bench.done(page)
